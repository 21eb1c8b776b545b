"""What authors and their tools write in other ways than the claim language: the tables of MathType, labels
within typefaces, R(t)^T."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from workbench.papers.texts import Token

_FACE_NAMES = r"\mathcal \mathscr \mathsf \mathrm \mathbf \boldsymbol \mathfrak"
_LETTERS = r"""
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi
    chi psi omega
"""
_GAP_NAMES = r"\, \; \: \! ~"
_FACES, _TEXTS = frozenset(_FACE_NAMES.split()), frozenset({"\\text", "\\mbox", "\\textrm"})
_GAPS = frozenset([" ", "\\ ", "\\\n", *_GAP_NAMES.split()])
_GREEK = frozenset(_LETTERS.split())
_CAPITALS = "Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
_VARIANTS = frozenset(_CAPITALS.split())


def as_read(tokens: Sequence[Token]) -> list[Token]:
    """Every token stays in its place."""
    made = list(tokens)
    for pattern in (
        _variant, _buildrel, _table, _grouped_table, _label, _nested_text, _prime, _of_time, _left_script, _wide, _row,
    ):  # fmt: skip
        made = _everywhere(made, pattern)
    return made


def _everywhere(
    tokens: list[Token], pattern: Callable[[list[Token], int], tuple[list[Token], int] | None]
) -> list[Token]:
    made: list[Token] = []
    place = 0
    while place < len(tokens):
        found = pattern(tokens, place)
        made += [tokens[place]] if found is None else found[0]
        place = place + 1 if found is None else found[1]
    return made


def _variant(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """\\varOmega as \\mathit{\\Omega}."""
    token = tokens[place]
    if not token.text.startswith("\\var") or token.text[4:] not in _VARIANTS:
        return None
    return [token.standing_for(text) for text in ("\\mathit", "{", f"\\{token.text[4:]}", "}")], place + 1


def _buildrel(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """\\buildrel\\Delta\\over= as := ."""
    if tokens[place].text != "\\buildrel":
        return None
    over = next(
        (i for i in range(place + 1, min(place + 12, len(tokens))) if tokens[i].text == "\\over"), None
    )
    sign = None if over is None else _past(tokens, over + 1)
    if sign is None or sign >= len(tokens) or tokens[sign].text != "=":
        return None
    return [tokens[sign].standing_for(":=")], sign + 1


def _table(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """The columns {*{20}{c}} of an array, which the reader counts itself."""
    if tokens[place].text != "\\begin{array}":
        return None
    start = _past(tokens, place + 1)
    if start >= len(tokens) or tokens[start].text != "{":
        return None
    end = _behind(tokens, start)
    if not any(token.text in "*@!>" for token in tokens[start:end]):
        return None
    return [tokens[place], tokens[start], tokens[start].standing_for("c"), tokens[end - 1]], end


def _grouped_table(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """{\\begin{array}…\\end{array}}, in braces that print nothing."""
    first = _past(tokens, place + 1)
    if tokens[place].text != "{" or first >= len(tokens) or not tokens[first].text.startswith("\\begin{"):
        return None
    end = _behind(tokens, place)
    last = _ahead(tokens, end - 1)
    if last is None or tokens[last].text != tokens[first].text.replace("\\begin", "\\end"):
        return None
    before = _ahead(tokens, place)
    opens = before is not None and (
        tokens[before].text in ("[", "(", "|", "\\|") or tokens[before].text == "="
    )
    return (tokens[place + 1 : end - 1], end) if opens else None


def _label(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """_\\mathcal{B/N} as _{\\mathcal{B}/\\mathcal{N}}."""
    if tokens[place].text not in _FACES or place + 1 >= len(tokens) or tokens[place + 1].text != "{":
        return None
    end = _behind(tokens, place + 1)
    inside = [token for token in tokens[place + 2 : end - 1] if token.text not in ("{", "}", " ")]
    if [token.text for token in inside[1::2]] != ["/"] or len(inside) != 3:
        return None
    face = tokens[place]
    one, slash, other = inside
    made = [face.standing_for("{")]
    for token in (one, slash, other):
        is_slash = token is slash
        made += [token] if is_slash else [face, face.standing_for("{"), token, face.standing_for("}")]
    return [*made, face.standing_for("}")], end


def _nested_text(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """\\text{\\text{sc}} as \\text{sc}; \\textit{sc} too, which is a label as well."""
    if tokens[place].text in ("\\textit", "\\textsf", "\\textup", "\\textnormal", "\\textsl", "\\texttt"):
        return [tokens[place].standing_for("\\text")], place + 1
    if tokens[place].text not in _TEXTS or place + 2 >= len(tokens) or tokens[place + 1].text != "{":
        return None
    inner = tokens[place + 2].text in _TEXTS and _behind(tokens, place + 3) == _behind(tokens, place + 1) - 1
    return (tokens[place + 2 : _behind(tokens, place + 1) - 1], _behind(tokens, place + 1)) if inner else None


def _prime(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """^{\\prime\\prime} as ''."""
    if tokens[place].text != "^":
        return None
    start = _past(tokens, place + 1)
    end = _behind(tokens, start)
    primes = [token for token in tokens[start:end] if token.text not in ("{", "}", " ")]
    if not primes or any(token.text != "\\prime" for token in primes):
        return None
    return [token.standing_for("'") for token in primes], end


def _of_time(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """R(t)^T as R^T: that R depends on the time says nothing of it."""
    if tokens[place].text not in ("(", "\\left", "{"):
        return None
    texts = [token.text for token in tokens[place : place + 14] if token.text not in _GAPS]
    opening = next((each for each in _TIMES if texts[: len(each)] == list(each)), None)
    before = _ahead(tokens, place)
    is_after = before is not None and (tokens[before].text == "}" or _is_letter(tokens[before]))
    if opening is None or not is_after:
        return None
    count, end = len(opening), place
    while count:
        count -= tokens[end].text not in _GAPS
        end += 1
    after = _past(tokens, end)
    if after >= len(tokens) or tokens[after].text not in ("^", "'"):
        return None
    if tokens[place].text != "{":
        return [], after
    close = _behind(tokens, place)
    return tokens[after : close - 1], close


def _left_script(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """^A x behind a sign, a bracket or a space that prints as {}^A x."""
    if tokens[place].text not in ("^", "_"):
        return None
    before = tokens[place - 1] if place else None
    if before is not None and before.text == " ":
        before = next((token for token in reversed(tokens[:place]) if token.text != " "), None)
    follows_nothing = before is None or before.text in _NO_NUCLEUS or before.text.startswith("\\begin{")
    if not follows_nothing:
        return None
    return [*(tokens[place].standing_for(text) for text in "{}"), tokens[place]], place + 1


def _wide(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Two spaces or more as the wide one that they print."""
    if tokens[place].text not in _SPACES_OF_A_WORD:
        return None
    end = _past(tokens, place)
    count = sum(token.text in _SPACES_OF_A_WORD for token in tokens[place:end])
    return ([tokens[place].standing_for("\\quad")], end) if count > 1 else None


def _row(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """[a \\quad b], in which nothing else stands between the two, as a row of a matrix."""
    if tokens[place].text != "[":
        return None
    parts: list[list[Token]] = [[]]
    depth = 0
    for end in range(place + 1, len(tokens)):
        text = tokens[end].text
        if depth == 0 and text == "]":
            break
        if depth == 0 and (text in _APART or text in _BETWEEN):
            if text not in _APART:
                return None
            parts.append([tokens[end].standing_for("&")])
            continue
        depth += (text in _OPEN) - (text in _CLOSE)
        parts[-1].append(tokens[end])
    else:
        return None
    if len(parts) < 2 or not all(any(t.text not in _GAPS | {"&"} for t in part) for part in parts):
        return None
    if tokens[end - 1].text in ("\\right", "\\big", "\\Big") or (place and tokens[place - 1].text == "\\left"):
        return None
    first, last = tokens[place], tokens[end]
    inside = [token for part in parts for token in part]
    return [first.standing_for("\\begin{bmatrix}"), *inside, last.standing_for("\\end{bmatrix}")], end + 1


_SPACES_OF_A_WORD = frozenset({"\\ ", "\\\n", "~", "\\;", "\\enspace"})
_APART = frozenset({"\\quad", "\\qquad", "\\enspace"})
#: What relates or separates the parts of a bracket in another way.
_BETWEEN = frozenset(["=", ",", ";", "+", "-", "|", "&", "\\\\", "\\times", "\\cdot", "\\text", "\\mathrm", "\\in"])
_OPEN = frozenset({"(", "[", "{", "\\{"})
_CLOSE = frozenset({")", "]", "}", "\\}"})
#: What no script can belong to.
_NO_NUCLEUS = frozenset(("=", "+", "-", "&", "(", "[", ",", "\\\\", "\\times", "\\cdot", "\\otimes", "\\circ", ":=", "\\equiv"))
_NO_NUCLEUS |= _GAPS - {" "}
_TIMES = (("(", "t", ")"), ("\\left", "(", "t", "\\right", ")"), ("{", "(", "t", ")"))


def _is_letter(token: Token) -> bool:
    word = token.word
    is_greek = word is not None and word.removeprefix("var").lower() in _GREEK
    return (len(token.text) == 1 and token.text.isalpha()) or is_greek


def _behind(tokens: Sequence[Token], place: int) -> int:
    """The place behind the group, or the one token, that stands at `place`."""
    if place >= len(tokens) or tokens[place].text != "{":
        is_faced = place < len(tokens) and tokens[place].text in _FACES | _TEXTS
        return _behind(tokens, _past(tokens, place + 1)) if is_faced else min(place + 1, len(tokens))
    return _closing(tokens, place) or len(tokens)


def _closing(tokens: Sequence[Token], place: int) -> int | None:
    depth = 0
    for end in range(place, len(tokens)):
        depth += (tokens[end].text == "{") - (tokens[end].text == "}")
        if depth == 0:
            return end + 1
    return None


def _past(tokens: Sequence[Token], place: int) -> int:
    while place < len(tokens) and tokens[place].text in _GAPS:
        place += 1
    return place


def _ahead(tokens: Sequence[Token], place: int) -> int | None:
    place -= 1
    while place >= 0 and tokens[place].text in _GAPS:
        place -= 1
    return None if place < 0 else place
