"""Listed index ranges, i = 1, 2, 3 or j = 1, …, n, as ranges that the reader accepts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from workbench.core.brackets import nesting
from workbench.language.grammar.vocabulary import DOTS
from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.source.documents import Token, joined

_DOTS = frozenset({"...", "…", *(f"\\{name}" for name in DOTS)})


def with_listed(pieces: Sequence[list[Token]], line: Sequence[Token]) -> Iterator[list[Token]]:
    """Yields the pieces of a line, with lists of index values as one range per index: i = \\overline{1,3}.

    j = 1, …, n with an unknown n gives j \\geq 1.
    """
    place = 0
    while place < len(pieces):
        if (inside := _in_brackets(pieces[place])) is not None:
            listed = list(with_listed(inside, line))
            yield from listed if all(map(is_index_range, listed)) else [pieces[place]]
            place += 1
            continue
        found = _listed(pieces, place, line)
        yield from [pieces[place]] if found is None else found[0]
        place = place + 1 if found is None else found[1]


def _listed(
    pieces: Sequence[list[Token]], start: int, line: Sequence[Token]
) -> tuple[list[list[Token]], int] | None:
    """Returns the ranges that begin at `start`, and the index after them; None if there are none."""
    place, letters = start, []
    while place < len(pieces) - 1 and len(pieces[place]) == 1:
        letters += pieces[place]
        place += 1
    texts = [token.text for token in pieces[place] if token.text != " "]
    if not (len(texts) == 3 and texts[1] == "=" and texts[2].isdecimal()):
        return None
    letters.append(pieces[place][0])
    if not all(letter.text in INDEX_LETTERS and _is_index(letter.text, line) for letter in letters):
        return None
    first = last = int(texts[2])
    bound, after = "", False
    for end in range(place + 1, len(pieces)):
        text = joined(pieces[end]).strip()
        if after and (text.isdecimal() or (len(text) == 1 and text.isalpha())):
            bound, place = text, end
            break
        after = text in _DOTS
        if not after and text != str(last + 1):
            break
        last, place = last + (not after), end
    if not bound and (after or first == last):
        return None
    sign = next(token for token in pieces[start + len(letters) - 1] if token.text == "=")
    return [_range(letter, sign, first, bound or str(last)) for letter in letters], place + 1


def is_index_range(piece: Sequence[Token]) -> bool:
    """True for i = \\overline{…}, or i \\geq 1."""
    texts = [token.text for token in piece if token.text != " "]
    return texts[0] in INDEX_LETTERS and (texts[1:3] == ["=", "\\overline"] or texts[1:2] == ["\\geq"])


def _is_index(letter: str, line: Sequence[Token]) -> bool:
    """True if the letter occurs in a subscript in the line."""
    depth, below = 0, False
    for before, token in pairwise(line):
        if depth == 0 and before.text == "_":
            below = True
        if below and token.text == letter:
            return True
        depth += below * nesting(token.text)
        below = below and depth > 0
    return False


def _in_brackets(piece: list[Token]) -> list[list[Token]] | None:
    """Returns the list in round brackets around the piece, else None."""
    texts = [token.text for token in piece if token.text != " "]
    if texts[:1] != ["("] or texts[-1:] != [")"] or texts[2:3] not in (["="], [","]):
        return None
    inside: list[list[Token]] = [[]]
    for token in piece[1:-1]:
        if token.text == ",":
            inside.append([])
        else:
            inside[-1].append(token)
    return [[token for token in each if token.text != " "] for each in inside]


def _range(letter: Token, sign: Token, first: int, last: str) -> list[Token]:
    if not last.isdecimal():
        return [letter, sign.standing_for("\\geq"), sign.standing_for(str(first))]
    return [
        letter,
        sign,
        *(sign.standing_for(text) for text in ("\\overline", "{", str(first), ",", last, "}")),
    ]
