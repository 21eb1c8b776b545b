"""Groups of tokens, and the invisible tokens between them."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from workbench.core.brackets import end_of_group
from workbench.source.documents import Token

_FACE_NAMES = r"\mathcal \mathscr \mathsf \mathrm \mathbf \boldsymbol \mathfrak"
_MARK_NAMES = r"\dot \ddot \dddot \vec \hat \bar \tilde \widehat \overline \underline"
_GAP_NAMES = r"\, \; \: \! ~"
FACES, TEXTS = frozenset(_FACE_NAMES.split()), frozenset({"\\text", "\\mbox", "\\textrm"})
MARKS = frozenset(_MARK_NAMES.split())
GAPS = frozenset([" ", "\\ ", "\\\n", *_GAP_NAMES.split()])


def behind(tokens: Sequence[Token], place: int) -> int:
    """Returns the index after the group, or the one token, at `place`."""
    if place >= len(tokens) or tokens[place].text != "{":
        is_faced = place < len(tokens) and tokens[place].text in FACES | TEXTS
        return behind(tokens, past(tokens, place + 1)) if is_faced else min(place + 1, len(tokens))
    return closing(tokens, place) or len(tokens)


def closing(
    tokens: Sequence[Token], place: int, opening: Collection[str] = "{", closed: Collection[str] = "}"
) -> int | None:
    """Returns the index after the bracket that closes the one at `place`; None if it stays open."""
    length = end_of_group((tokens[at].text for at in range(place, len(tokens))), opening, closed)
    return None if length is None else place + length


def past(tokens: Sequence[Token], place: int) -> int:
    while place < len(tokens) and tokens[place].text in GAPS:
        place += 1
    return place


def ahead(tokens: Sequence[Token], place: int) -> int | None:
    place -= 1
    while place >= 0 and tokens[place].text in GAPS:
        place -= 1
    return None if place < 0 else place


def printed(tokens: Sequence[Token]) -> list[str]:
    return [token.text for token in tokens if token.text not in GAPS]


def braced(head: Token, inside: Sequence[Token]) -> list[Token]:
    return [head.standing_for("{"), *inside, head.standing_for("}")]


def group(tokens: Sequence[Token], place: int) -> tuple[list[Token], int]:
    """Returns the contents of the braces at `place`, or the one token, and the index after it."""
    end = behind(tokens, place)
    has_braces = place < len(tokens) and tokens[place].text == "{"
    return list(tokens[place + 1 : end - 1] if has_braces else tokens[place:end]), end


def is_one_symbol(tokens: Sequence[Token]) -> bool:
    """True if the tokens are one letter with its marks and scripts."""
    inside = [token for token in tokens if token.text not in GAPS]
    place = 0
    while place < len(inside) and inside[place].text in FACES | MARKS:
        place += 1
    if place == len(inside):
        return False
    body, place = group(inside, place)
    while place < len(inside) and inside[place].text in ("_", "^", "'"):
        place = place + 1 if inside[place].text == "'" else behind(inside, place + 1)
    is_letter = len(body) == 1 and (body[0].text.isalpha() or body[0].word is not None)
    return place == len(inside) and (is_letter or (len(body) > 1 and is_one_symbol(body)))
