"""Plain TeX: scripts without a base, typeface switches for the rest of a group, kerns, notes on signs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from workbench.source.documents import Token
from workbench.source.rewriting.token_groups import braced, closing, group

_SPACING = r"\, \; \: \! \> ~ \enspace \thinspace \quad \qquad"
_LENGTHS = r"\hspace \hskip \mspace \kern"
_NO_NUCLEI = r"""
    ( [ { , ; & \\ = + - / < > \times \cdot \otimes \circ \wedge \pm \mp \equiv \neq \ne \approx \simeq \in
    \triangleq \coloneqq \coloneq \defeq \leq \le \geq \ge \Rightarrow \Leftrightarrow \implies \iff \lbrace
    \lbrack \lparen
"""
_AS_POWERS = r"T \top * \ast \prime -T"
_SPACES, _SPACES_WITH_ARGUMENT = frozenset([*_SPACING.split(), "\\ "]), frozenset(_LENGTHS.split())
_SIGNS, _OPERATIONS = frozenset(_NO_NUCLEI.split()), frozenset(_AS_POWERS.split())
_KERNS = frozenset({"\\mkern", "\\kern", "\\mskip", "\\hskip"})
_POINTS = {"mu": 0.56, "pt": 1, "em": 10, "ex": 4.3, "mm": 2.8, "cm": 28, "in": 72}
_LENGTH = re.compile(rf"\s*(-?\s*\d*\.?\d+)\s*({'|'.join(_POINTS)})")
_BRACED_LENGTH = re.compile(rf"\*?\s*\{{{_LENGTH.pattern}\s*\}}")
#: Least width (em) of a space that separates, as \quad does.
_WIDE = 5
_SWITCHES = {
    "\\rm": "\\mathrm",
    "\\bf": "\\mathbf",
    "\\it": "\\mathit",
    "\\sf": "\\mathsf",
    "\\cal": "\\mathcal",
    "\\frak": "\\mathfrak",
}


def with_typefaces(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens with {\\rm v} as \\mathrm{v}, and \\bf{v} likewise, as authors mean it."""
    skip_to = -1
    for place, token in enumerate(tokens):
        if place < skip_to:
            continue
        after = _past_spaces(tokens, place + 1)
        following = _text(tokens, after)
        if token.text in _SWITCHES and following == "{":
            yield token.standing_for(_SWITCHES[token.text])
            continue
        inside = _past_spaces(tokens, after + 1)
        while following in _SWITCHES and _text(tokens, inside) in _SWITCHES:  # {\rm\bf I}
            after, following = inside, _text(tokens, inside)
            inside = _past_spaces(tokens, after + 1)
        if token.text == "{" and following in _SWITCHES and _text(tokens, inside) != "{":
            yield tokens[after].standing_for(_SWITCHES[following])
            skip_to = inside
        yield token


def without_kerns(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens without \\mkern-1pt and repeated \\\\, and with \\hspace{1cm} as \\quad."""
    skip_to, before = -1, ""
    tokens = list(with_plain_relations(tokens))
    for place, token in enumerate(tokens):
        if place < skip_to:
            continue
        length = _length_behind(tokens, place)
        if length is not None:
            skip_to = _behind(tokens, place + 1, length.end())
            if float(length[1].replace(" ", "")) * _POINTS[length[2]] >= _WIDE:
                yield token.standing_for("\\quad")
                before = "\\quad"
        elif token.text != "\\\\" or before != token.text:
            yield token
            before = token.text if token.text != " " else before


def with_plain_relations(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens with \\buildrel (1) \\over = and \\mathop{=}\\limits^{(1)} as \\overset{(1)}{=}."""
    place = 0
    while place < len(tokens):
        noted = _buildrel(tokens, place) or _sign_with_limits(tokens, place)
        if noted is None:
            yield tokens[place]
            place += 1
            continue
        note, sign, place = noted
        if note:
            yield from (sign.standing_for("\\overset"), *braced(sign, note), *braced(sign, [sign]))
        else:
            yield sign


def _buildrel(tokens: Sequence[Token], place: int) -> tuple[list[Token], Token, int] | None:
    """Returns the note, the sign and the index after \\buildrel note \\over sign; else None."""
    if tokens[place].text != "\\buildrel":
        return None
    near = range(place + 1, min(place + 24, len(tokens)))
    over = next((at for at in near if tokens[at].text == "\\over"), None)
    sign = len(tokens) if over is None else _past_spaces(tokens, over + 1)
    if over is None or sign >= len(tokens):
        return None
    inside, end = group(tokens, sign)
    if [token.text for token in inside if token.text != " "] != ["="]:
        return None
    note = [token for token in tokens[place + 1 : over] if token.text != " "]
    return note, next(token for token in inside if token.text == "="), end


def _sign_with_limits(tokens: Sequence[Token], place: int) -> tuple[list[Token], Token, int] | None:
    """Returns the note, the = and the index after \\mathop{=}\\limits_{note}^{note}; else None."""
    if tokens[place].text != "\\mathop":
        return None
    inside, end = group(tokens, _past_spaces(tokens, place + 1))
    limits = _past_spaces(tokens, end)
    if [token.text for token in inside if token.text != " "] != ["="] or _text(tokens, limits) != "\\limits":
        return None
    note: list[Token] = []
    end = limits + 1
    while _text(tokens, script := _past_spaces(tokens, end)) in ("_", "^"):
        above, end = group(tokens, _past_spaces(tokens, script + 1))
        note += above
    return note, next(token for token in inside if token.text == "="), end


def _length_behind(tokens: Sequence[Token], place: int) -> re.Match[str] | None:
    """Returns the match of the width of the space at this index, else None."""
    space = tokens[place].text
    if space not in _KERNS | _SPACES_WITH_ARGUMENT:
        return None
    pattern = _LENGTH if space in _KERNS else _BRACED_LENGTH
    return pattern.match("".join(each.text for each in tokens[place + 1 : place + 16]))


def _behind(tokens: Sequence[Token], place: int, characters: int) -> int:
    while characters > 0:
        characters -= len(tokens[place].text)
        place += 1
    return place


def with_nuclei(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens with {} before a script after a sign or a space: = ^A R_B becomes = {}^A R_B.

    Only a number, a transpose or a star after a space is a power.
    """
    is_bare, is_spaced, is_script = True, False, False
    length_until = empty_until = -1
    for place, token in enumerate(tokens):
        text = token.text
        if place < length_until:
            yield token
            continue
        if place < empty_until:
            continue
        if text == "{" and not is_bare and (power := _bare_inverse(tokens, place)):
            empty_until = power
            continue
        if text in ("^", "_") and is_bare and not (is_spaced and _is_operation(tokens, place)):
            yield token.standing_for("{")
            yield token.standing_for("}")
        yield token
        if text == " ":
            continue
        is_spaced = text in _SPACES or text in _SPACES_WITH_ARGUMENT
        is_bare = is_spaced or (text in _SIGNS and not is_script) or text.startswith("\\begin{")
        is_script = text in ("^", "_")  # a sign without braces is the script, as in [x]_\times^2
        if text in _SPACES_WITH_ARGUMENT or text == "\\begin{array}":
            length_until = _behind_group(tokens, place + 1)


def _bare_inverse(tokens: Sequence[Token], place: int) -> int:
    """Returns the index of the ^{-1} after empty braces that open here, as in I{}^{-1}; else 0."""
    behind = _past_spaces(tokens, _behind_group(tokens, place))
    is_empty = all(token.text in "{} " for token in tokens[place:behind])
    power = "".join(token.text for token in tokens[behind : _behind_group(tokens, behind + 1)])
    return behind if is_empty and power in ("^{-1}", "^{-T}") else 0


def _is_operation(tokens: Sequence[Token], place: int) -> bool:
    inside = "".join(each.text for each in tokens[place + 1 : _behind_group(tokens, place + 1)]).strip("{} ")
    return tokens[place].text == "^" and (inside.lstrip("-").isdecimal() or inside in _OPERATIONS)


def _behind_group(tokens: Sequence[Token], place: int) -> int:
    place = _past_spaces(tokens, place)
    return len(tokens) if place >= len(tokens) else closing(tokens, place) or len(tokens)


def _text(tokens: Sequence[Token], place: int) -> str:
    return tokens[place].text if place < len(tokens) else ""


def _past_spaces(tokens: Sequence[Token], place: int) -> int:
    while place < len(tokens) and tokens[place].text == " ":
        place += 1
    return place
