"""a/b as a fraction, and where the factors and groups of a formula begin and end."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.papers.texts import Token

_FACE_NAMES = r"\mathcal \mathscr \mathsf \mathrm \mathbf \boldsymbol \mathfrak"
_ACCENT_NAMES = r"\hat \bar \vec \tilde \dot \ddot \widehat \overline"
_ENDS = r"""
    + - = & \\ , ; . ) ] } \} \right \quad \qquad \neq \cdot \times | \| \bigr \Bigr \biggr \Biggr \big \Big
    \leq \geq \le \ge < > \text
"""
_HEADS = r"""
    \sin \cos \tan \cot \sec \csc \exp \log \ln \sqrt \frac \arcsin \arccos \arctan \det \tr \left
    \operatorname \d \partial \int \sum \prod \sinh \cosh \tanh
"""
_LETTERS = r"""
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi
    chi psi omega
"""
_GAP_NAMES = r"\, \; \: \! ~"
FACES, TEXTS = frozenset(_FACE_NAMES.split()), frozenset({"\\text", "\\mbox", "\\textrm"})
GAPS = frozenset([" ", "\\ ", *_GAP_NAMES.split()])
_ACCENTS, _APART = frozenset(_ACCENT_NAMES.split()), frozenset(_ENDS.split())
_FUNCTIONS, _GREEK = frozenset(_HEADS.split()), frozenset(_LETTERS.split())
_PAIRS = {")": "(", "]": "[", "}": "{", "\\}": "\\{"}


def with_fractions(tokens: list[Token]) -> list[Token]:
    """a/b as a fraction where it cannot be read otherwise: with single factors around it, and nothing that it
    could go on with."""
    made: list[Token] = []
    place = 0
    while place < len(tokens):
        token = tokens[place]
        if token.text in ("_", "^") or token.text in TEXTS:
            end = behind(tokens, past(tokens, place + 1))
            made += tokens[place:end]
            place = end
            continue
        start = _factor_before(made) if token.text == "/" else None
        end = _factor_behind(tokens, place + 1) if start is not None else None
        if end is not None:
            top, bottom = made[start:], tokens[place + 1 : end]
            made[start:] = [token.standing_for("\\frac"), *_braced(top, token), *_braced(bottom, token)]
            place = end
        else:
            made.append(token)
            place += 1
    return made


def _braced(tokens: Sequence[Token], slash: Token) -> list[Token]:
    inside = [token for token in tokens if token.text not in GAPS]
    if inside[0].text == "(" and behind(inside, 0) == len(inside):
        inside = inside[1:-1]
    return [slash.standing_for("{"), *inside, slash.standing_for("}")]


def _factor_before(made: list[Token]) -> int | None:
    """Where the factor begins that ends here: one that no function and no other slash has before it."""
    place = ahead(made, len(made))
    if place is None:
        return None
    while place >= 0:
        text = made[place].text
        if text in _PAIRS:
            start = _opening(made, place)
            if start is None or text == "\\}":
                return None
            before = ahead(made, start)
            is_script = before is not None and made[before].text in ("_", "^")
            is_faced = text == "}" and before is not None and made[before].text in FACES | _ACCENTS
            if text == "}" and not (is_script or is_faced):
                return None
            place = before if is_script or is_faced else start
            if is_script:
                place = ahead(made, place)
                if place is None:
                    return None
                continue
            break
        before = ahead(made, place)
        if before is not None and made[before].text in ("_", "^"):
            place = ahead(made, before)
            if place is None:
                return None
            continue
        if text.isdigit():
            while place and (made[place - 1].text.isdigit() or made[place - 1].text == "."):
                place -= 1
        elif not is_letter(made[place]):
            return None
        break
    while (before := ahead(made, place)) is not None and made[before].text in _ACCENTS:
        place = before
    before = ahead(made, place)
    if before is None:
        return place
    text = made[before].text
    is_function = text in _FUNCTIONS or text in ("/", "}", "^", "_")
    goes_on = text == ")" or is_letter(made[before]) or text.isdigit()
    if is_function or (goes_on and _has_function(made[:place])):
        return None
    return place


def _has_function(tokens: Sequence[Token]) -> bool:
    """Whether a function stands in the product that ends here: sin a b/2."""
    depth = 0
    for token in reversed(tokens):
        depth += (token.text in _PAIRS) - (token.text in _PAIRS.values())
        if depth < 0 or (depth == 0 and token.text in ("+", "-", "=", "&", "\\\\", ",")):
            return False
        if token.text in _FUNCTIONS:
            return True
    return False


def _factor_behind(tokens: list[Token], place: int) -> int | None:
    """Where the factor ends that begins here, if nothing goes on with it."""
    start = place = past(tokens, place)
    if place >= len(tokens):
        return None
    text = tokens[place].text
    if text == "(":
        place = _closing(tokens, place)
    elif text.isdigit():
        while place < len(tokens) and tokens[place].text.isdigit():
            place += 1
    elif text in FACES | _ACCENTS:
        place = behind(tokens, past(tokens, place + 1))
    elif is_letter(tokens[place]):
        place += 1
    else:
        return None
    if place is None:
        return None
    while (after := past(tokens, place)) < len(tokens) and tokens[after].text in ("_", "^", "'"):
        place = after + 1 if tokens[after].text == "'" else behind(tokens, past(tokens, after + 1))
    after = past(tokens, place)
    ends = after >= len(tokens) or tokens[after].text in _APART or tokens[after].text.startswith("\\end{")
    return place if ends and place > start else None


def is_letter(token: Token) -> bool:
    word = token.word
    is_greek = word is not None and word.removeprefix("var").lower() in _GREEK
    return (len(token.text) == 1 and token.text.isalpha()) or is_greek


def behind(tokens: Sequence[Token], place: int) -> int:
    """The place behind the group, or the one token, that stands at `place`."""
    if place >= len(tokens) or tokens[place].text != "{":
        is_faced = place < len(tokens) and tokens[place].text in FACES | TEXTS
        return behind(tokens, past(tokens, place + 1)) if is_faced else min(place + 1, len(tokens))
    return _closing(tokens, place) or len(tokens)


def _closing(tokens: Sequence[Token], place: int) -> int | None:
    opening = tokens[place].text
    depth = 0
    for end in range(place, len(tokens)):
        depth += (tokens[end].text == opening) - (_PAIRS.get(tokens[end].text) == opening)
        if depth == 0:
            return end + 1
    return None


def _opening(tokens: Sequence[Token], place: int) -> int | None:
    closing, opening = tokens[place].text, _PAIRS[tokens[place].text]
    depth = 0
    for start in range(place, -1, -1):
        depth += (tokens[start].text == closing) - (tokens[start].text == opening)
        if depth == 0:
            return start
    return None


def past(tokens: Sequence[Token], place: int) -> int:
    while place < len(tokens) and tokens[place].text in GAPS:
        place += 1
    return place


def ahead(tokens: Sequence[Token], place: int) -> int | None:
    place -= 1
    while place >= 0 and tokens[place].text in GAPS:
        place -= 1
    return None if place < 0 else place
