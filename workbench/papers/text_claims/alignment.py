"""The rows of a display as lines of an argument: alignment marks, environments, lines that go on."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from workbench.language.grammar.vocabulary import LINES, NUMBER, goes_on, spellings
from workbench.papers.respell import argument, respelled
from workbench.papers.texts import Display, Token, joined

_OTHER_LINES = "alignedat dcases rcases gather gather* array equation equation* multlined"
_LINES = LINES | set(_OTHER_LINES.split())
_MATRICES = frozenset({"matrix", "smallmatrix"})
_ARROWS = frozenset({"\\rightarrow", "\\to", "\\longrightarrow"})
EQUALITIES = frozenset({"=", ":=", "\\equiv", "\\stackrel", "\\overset"})
_UNREAD = "simeq sim propto le leq lt gt ll gg cong doteq subset"
RELATIONS = EQUALITIES | {"<", *(f"\\{name}" for name in _UNREAD.split())}
RELATIONS |= spellings("RELATION") - {":", "\\colon"}
IMPLICATIONS = spellings("IMPLICATION") | {"\\Leftarrow", "\\impliedby", "\\Longleftarrow"}
_KINDS = {
    text: kind
    for kind, texts in {
        "RELATION": RELATIONS,
        "IMPLICATION": IMPLICATIONS,
        "INFIX": spellings("INFIX"),
        "SIGN": spellings("SIGN"),
    }.items()
    for text in texts
}
WORD_COMMANDS = frozenset({"\\text", "\\mbox", "\\textrm", "\\textit", "\\textnormal", "\\hbox"})
_SPACES = frozenset(
    {" ", "\\,", "\\;", "\\:", "\\!", "\\ ", "\\\n", "~", "\\>", "\\par", "\\enspace", "\\thinspace"}
)
#: Spaces that the author asks for.
EXPLICIT = frozenset({"\\ ", "\\\n", "~", "\\;"})
WIDE = frozenset({"\\quad", "\\qquad", "\\hspace"})
_FAR = WIDE | {"\\hfill"}
_OPEN, _CLOSE = frozenset("([{"), frozenset(")]}")
_ENDS = frozenset({".", ",", ";"})

#: Words that say where what stands before them holds.
_CONDITION = re.compile(
    r"\b(if|when\w*|where\w*|for|with\w*|under|unless|provided|given|suppos\w*|assum\w*|small|near|at|in|as|only)\b",
    re.IGNORECASE,
)


@dataclass
class Line:
    """`rows`: of each of its rows the last token, the number and labels. `opens`: whether it begins behind an
    alignment mark, as what goes on with the line before does. `begins`: that something is before one."""

    tokens: list[Token]
    rows: list[tuple[Token, str | None, tuple[str, ...]]]
    opens: bool = False
    begins: bool = False


def lines_of(display: Display, words: Collection[str]) -> list[Line]:
    made: list[Line] = []
    in_column: dict[int, Line] = {}
    several, is_one = len(display.rows) > 1, display.environment.startswith("multline")
    for row in display.rows:
        tokens = respelled(_without_number(row.tokens), words)
        inner = None if several else _inside(tokens)
        for piece in [tokens] if inner is None else _split(inner, "\\\\"):
            for column, (cell, opens, begins) in enumerate(_columns(_with_implications(piece))):
                cell = trimmed(cell)
                if not cell or (column and _is_remark(cell)):
                    stands = in_column.get(column - 1)
                    if stands is not None and _CONDITION.search(joined(cell)):
                        stands.tokens = [*stands.tokens, cell[0].standing_for("\\quad"), *cell]
                    continue
                line = Line(cell, [(cell[-1], row.number, row.labels)], opens, begins)
                before = in_column.get(column)
                if before is not None and (_goes_on(before, line) or (is_one and _is_rest(before, line))):
                    before.tokens = [
                        *_without_plus(before.tokens, line.tokens[0]),
                        line.tokens[0].standing_for(" "),
                        *line.tokens,
                    ]
                    before.rows += line.rows
                else:
                    made.append(line)
                    in_column[column] = line
    return made


def _without_number(tokens: Sequence[Token]) -> list[Token]:
    """Without the number that an author sets himself, behind a wide space at the end or before one."""
    spaces = [
        place
        for place, (token, depth) in enumerate(with_depth(tokens))
        if (token.text in _FAR or token.text[5:-1] in _LINES - {"array"}) and not depth
    ]
    if spaces and NUMBER.fullmatch(joined(tokens[spaces[-1] + 1 :])):
        last = spaces[-1]
        return list(tokens[: last + (tokens[last].text not in _FAR)])
    if spaces and tokens[spaces[0]].text in _FAR and NUMBER.fullmatch(joined(tokens[: spaces[0]])):
        return list(tokens[spaces[0] + 1 :])
    return list(tokens)


def _with_implications(tokens: list[Token]) -> list[Token]:
    """The arrow of a = b → c = d as the implication that it is; a map f: x → y stays one."""
    arrows = [
        place
        for place, (token, depth) in enumerate(with_depth(tokens))
        if token.text in _ARROWS and not depth
    ]
    made, ends = list(tokens), [-1, *arrows, len(tokens)]
    for place, before, after in zip(arrows, ends, ends[2:], strict=False):
        sides = (tokens[before + 1 : place], tokens[place + 1 : after])
        if all(any(token.text == "=" for token in top(side)) for side in sides):
            made[place] = tokens[place].standing_for("\\Rightarrow")
    return made


def _inside(tokens: list[Token]) -> list[Token] | None:
    """The rows inside of the one environment of lines that the tokens are; None if they are not one."""
    tokens = _stripped(tokens)
    if len(tokens) > 2 and tokens[0].text == "\\left" and tokens[-2].text == "\\right":
        tokens = _stripped(tokens[2:-2]) if tokens[1].text == "\\{" else tokens
    name = _environment(tokens[0]) if tokens else None
    if name in _MATRICES and _holds_equations(tokens):
        name = "gathered"
    if name is None or name not in _LINES:
        return tokens if any(token.text == "\\\\" for token in top(tokens)) else None
    depth = 0
    for place, token in enumerate(tokens):
        depth += token.text.startswith("\\begin{") - token.text.startswith("\\end{")
        if depth == 0:
            if place < len(tokens) - 1 and any(each.text not in _ENDS for each in tokens[place + 1 :]):
                return None
            inner = tokens[1:place]
            if name in ("array", "alignedat"):
                inner = inner[argument(inner, 0)[1] :]
            return _inside(inner) or inner
    return None


def _holds_equations(tokens: list[Token]) -> bool:
    """Whether each row of what is written as a matrix is one equation."""
    rows = [{token.text for token in top(row)} for row in _split(tokens[1:-1], "\\\\") if _stripped(row)]
    return all(row & EQUALITIES and "&" not in row for row in rows)


def _without_plus(row: list[Token], first: Token) -> list[Token]:
    """a + of a row before - b, where the sign stands at both ends: + b or - b is added."""
    kept = _stripped(row)
    return kept[:-1] if kept[-1].text == "+" and first.text in ("+", "-") else row


def _goes_on(before: Line, line: Line) -> bool:
    first, last = (_KINDS.get(token.text, "") for token in (line.tokens[0], _stripped(before.tokens)[-1]))
    if first == "IMPLICATION":  # a line of its own: what follows from the one before
        return False
    if last == "RELATION" != first and before.begins and line.begins:  # x &= … of a right side left out
        return False
    is_addend = line.opens or not (_relates(line) and _relates(before))
    return _left_open(before.tokens) or goes_on(last, first, is_addend)


def _is_remark(cell: Sequence[Token]) -> bool:
    """Whether a cell behind a formula holds nothing, or nothing but words, perhaps in a colour."""
    depth, waits = 0, False
    for token in cell:
        if depth:
            depth += (token.text == "{") - (token.text == "}")
        elif waits and token.text == "{":
            depth, waits = 1, False
        elif token.text in WORD_COMMANDS or token.text == "\\color":
            waits = True
        elif token.text not in _SPACES | {"{", "}", *_ENDS}:
            return False
    return True


def _is_rest(before: Line, line: Line) -> bool:
    """Whether the row of a multline is no formula of its own: only a mistaken one relates two in each."""
    return not (_relates(before) and _relates(line)) or _KINDS.get(line.tokens[0].text) == "SIGN"


def _relates(line: Line) -> bool:
    return any(token.text in RELATIONS for token in top(line.tokens))


def _columns(tokens: list[Token]) -> list[tuple[list[Token], bool, bool]]:
    """The formulas of a row, parted by every second alignment mark, whether each begins behind one, and
    whether it has something before one; the two marks of a &=& b part nothing."""
    cells: list[tuple[list[Token], bool, bool]] = [([], False, False)]
    marks = 0
    around = _around_signs(tokens)
    for token, depth in with_depth(tokens):
        cell, opens, begins = cells[-1]
        if id(token) in around:
            marks += around[id(token)]
            is_empty = not _stripped(cell)
            cells[-1] = (cell, opens or is_empty, begins or not (opens or is_empty))
            continue
        if token.text != "&" or depth:
            cell.append(token)
            continue
        marks += 1
        if marks % 2 == 0:
            cells.append(([], False, False))
        elif _is_formula(cell) and _begins_formula(behind := _up_to_mark(tokens, token)):
            cell.append(token if _may_be_condition(behind) else token.standing_for(","))
        else:
            is_empty = not _stripped(cell)
            cells[-1] = (cell, opens or is_empty, begins or not is_empty)
    return cells


def _up_to_mark(tokens: Sequence[Token], mark: Token) -> list[Token]:
    """What stands between an alignment mark and the next one."""
    start = next(place for place, token in enumerate(tokens) if token is mark) + 1
    return trimmed(_split(tokens[start:], "&")[0])


def _is_formula(tokens: Sequence[Token]) -> bool:
    """Whether it relates something to what does not still come."""
    tokens = _stripped(tokens)
    return any(token.text in RELATIONS for token in top(tokens)) and tokens[-1].text not in _KINDS


def _begins_formula(tokens: Sequence[Token]) -> bool:
    return bool(tokens) and _is_formula(tokens) and tokens[0].text not in _KINDS.keys() | WORD_COMMANDS


def _may_be_condition(tokens: Sequence[Token]) -> bool:
    """Whether x = 0 behind an equation may say where that holds, and not what x is."""
    sides = _split(tokens, "=")
    return len(sides) == 2 and all(len(trimmed(side)) <= 1 for side in sides)


def _around_signs(tokens: list[Token]) -> dict[int, int]:
    """The marks of &=&, and of the && that a row begins with, and 1 for the one that counts: in eqnarray a
    sign has a column of its own. Where && a &= b follows, the first pair of columns is empty."""
    marks = [
        (place, token)
        for place, (token, depth) in enumerate(with_depth(tokens))
        if token.text == "&" and not depth
    ]
    found: dict[int, int] = {}
    for (start, first), (end, second) in pairwise(marks):
        inside = _stripped(tokens[start + 1 : end])
        is_sign = all(token.text in RELATIONS for token in inside or tokens[:start] if token.text != " ")
        opens = not _stripped(tokens[:start]) and not _begins_pair(tokens, marks[2:])
        if id(first) not in found and is_sign and (inside or opens):
            found |= {id(first): 1, id(second): 0}
    return found


def _begins_pair(tokens: list[Token], marks: Sequence[tuple[int, Token]]) -> bool:
    """Whether the next mark stands before a sign, as in a &= b."""
    behind = _stripped(tokens[marks[0][0] + 1 :]) if marks else []
    return bool(behind) and behind[0].text in RELATIONS


def _environment(token: Token) -> str | None:
    return token.text[7:-1] if token.text.startswith("\\begin{") else None


def with_depth(tokens: Sequence[Token]) -> Iterator[tuple[Token, int]]:
    """Each token with the number of brackets and environments around it; a script has one more."""
    depth, before = 0, ""
    for token in tokens:
        text = token.text
        if text.startswith("\\end{") or text in _CLOSE or text in ("\\}", "\\rangle"):
            depth = max(0, depth - 1)
        yield token, depth + (before in ("_", "^"))
        before = text
        if text.startswith("\\begin{") or text in _OPEN or text in ("\\{", "\\langle"):
            depth += 1


def top(tokens: Sequence[Token]) -> Iterator[Token]:
    return (token for token, depth in with_depth(tokens) if depth == 0)


def _left_open(tokens: Sequence[Token]) -> bool:
    texts = [token.text for token in tokens]
    return texts.count("\\left") > texts.count("\\right")


def _split(tokens: Sequence[Token], mark: str) -> list[list[Token]]:
    rows: list[list[Token]] = [[]]
    for token, depth in with_depth(tokens):
        if depth == 0 and token.text == mark:
            rows.append([])
        else:
            rows[-1].append(token)
    return [_without_length(row) for row in rows]


def _without_length(row: list[Token]) -> list[Token]:
    """Without the [2pt] of \\\\[2pt]."""
    if row and row[0].text == "[":
        texts = joined(row[:12])
        length, bracket, _ = texts[1:].partition("]")
        if bracket and length.strip()[-2:] in ("pt", "ex", "em", "mm", "cm"):
            end = next(place for place, token in enumerate(row) if token.text == "]")
            return row[end + 1 :]
    return row


def _stripped(tokens: Sequence[Token]) -> list[Token]:
    first, last = 0, len(tokens)
    while first < last and tokens[first].text in _SPACES:
        first += 1
    while first < last and tokens[last - 1].text in _SPACES:
        last -= 1
    return list(tokens[first:last])


def trimmed(tokens: Sequence[Token]) -> list[Token]:
    """Without spaces around, and without the punctuation at the end, which may stand in a \\text."""
    tokens = _stripped(tokens)
    while tokens:
        is_ellipsis = [token.text for token in tokens[-2:]] == [".", "."]
        if tokens[-1].text in _ENDS | WIDE and not is_ellipsis:
            tokens = _stripped(tokens[:-1])
        elif tokens[0].text in WIDE | {",", ";"}:
            tokens = _stripped(tokens[1:])
        elif len(tokens) > 3 and tokens[-1].text == "}" and (start := _closing_words(tokens)) is not None:
            tokens = _stripped(tokens[:start])
        else:
            return tokens
    return tokens


def _closing_words(tokens: list[Token]) -> int | None:
    """Where a last \\text{.} begins."""
    for start in range(len(tokens) - 2, max(-1, len(tokens) - 8), -1):
        if tokens[start].text in WORD_COMMANDS:
            inside = joined(tokens[start + 2 : -1]).strip()
            return start if all(character in " .,;:" for character in inside) else None
    return None
