"""Signs in a typeface, dots after a bracket, bars of conversion tools, degrees."""

from __future__ import annotations

from itertools import pairwise

from workbench.core.brackets import outside
from workbench.language.grammar.vocabulary import SIZES
from workbench.source.documents import Token
from workbench.source.rewriting.token_groups import (
    FACES,
    ahead,
    braced,
    closing,
    group,
    is_one_symbol,
    past,
    printed,
)

#: Sizes that make a sign an opening or a closing bracket.
_SIDED = frozenset(f"\\{size}" for size in SIZES if size.endswith(("left", "right", "l", "r")))

_BESIDE_A_SUM = frozenset({*"()[]{}=+-&,.", "\\\\", "\\right"})


def _in_a_face(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Returns the contents of the braces of a typeface at this index, and the index after them; else None."""
    start = past(tokens, place + 1)
    is_faced = tokens[place].text in FACES and printed(tokens[start : start + 1]) == ["{"]
    return group(tokens, start) if is_faced else None


def summed(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\mathbf{a - b} to \\mathbf{a} - \\mathbf{b}, if the terms are symbols and the sum stands
    alone."""
    if (faced := _in_a_face(tokens, place)) is None:
        return None
    inside, end = faced
    before = ahead(tokens, place)
    sides = [*([] if before is None else [tokens[before]]), *tokens[past(tokens, end) :][:1]]
    if any(token.text not in _BESIDE_A_SUM for token in sides):
        return None
    free = outside(token.text for token in inside)
    signs = [at for at in free if inside[at].text in ("+", "-")]
    first, *others = (list(inside[a:b]) for a, b in pairwise([0, *signs, len(inside)]))
    if not others or not all(map(is_one_symbol, (first, *(part[1:] for part in others)))):
        return None
    head = tokens[place]
    made = [head, *braced(head, first)]
    for sign, *part in others:
        made += [sign, head, *braced(head, part)]
    return made, end


def angle(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\left< a, b \\right> to the angle brackets that it prints."""
    size, sign = tokens[place], tokens[place + 1 : place + 2]
    bracket = {"<": "\\langle", ">": "\\rangle"}.get(sign[0].text) if sign else None
    if bracket is None or size.text not in _SIDED:
        return None
    return [size, sign[0].standing_for(bracket)], place + 2


def signed(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\mathbf{-v}, one symbol with a sign, to (-\\mathbf{v})."""
    if (faced := _in_a_face(tokens, place)) is None:
        return None
    inside, end = faced
    sign, head = past(inside, 0), tokens[place]
    is_one = printed(inside[sign : sign + 1]) == ["-"] and is_one_symbol(inside[sign + 1 :])
    if not is_one or printed(tokens[past(tokens, end) :])[:1] in (["^"], ["_"]):
        return None
    made = [inside[sign], head, *braced(head, inside[sign + 1 :])]
    return [head.standing_for("("), *made, head.standing_for(")")], end


def dotted_bracket(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites (a b)\\dot{}, with the dot after the bracket, and (a b)^\\cdot to \\dot{(a b)}."""
    start = place + (tokens[place].text == "\\left")
    closed = {"(": ")", "[": "]"}.get(tokens[start].text) if start < len(tokens) else None
    end = None if closed is None else closing(tokens, start, tokens[start].text, closed)
    dot = len(tokens) if end is None else past(tokens, end)
    mark = printed(tokens[dot : dot + 1])
    if mark not in (["\\dot"], ["^"]):
        return None
    inside, after = group(tokens, past(tokens, dot + 1))
    if printed(inside) != ([] if mark == ["\\dot"] else ["\\cdot"]):
        return None
    return [tokens[dot].standing_for("\\dot"), *braced(tokens[dot], tokens[place:end])], after


def empty_bars(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\left|\\right|, with which a tool prints half of a norm sign, to \\|."""
    is_pair = [token.text for token in tokens[place : place + 4]] == ["\\left", "|", "\\right", "|"]
    return ([tokens[place].standing_for("\\|")], place + 4) if is_pair else None


def degrees(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites 90^\\circ to \\frac{90}{180}\\pi."""
    head, end = tokens[place], place
    while end < len(tokens) and tokens[end].text.isdecimal():
        end += 1
    is_number = end > place and not (
        place and (tokens[place - 1].text.isdecimal() or tokens[place - 1].text == ".")
    )
    sign, behind = past(tokens, end), end
    if is_number and printed(tokens[sign : sign + 1]) == ["^"]:
        power, behind = group(tokens, past(tokens, sign + 1))
        is_number = printed(power) == ["\\circ"]
    elif is_number:
        is_number, behind = printed(tokens[sign : sign + 1]) == ["\\degree"], sign + 1
    if not is_number:
        return None
    half_turn = [head.standing_for(text) for text in "180"]
    quotient = [head.standing_for("\\frac"), *braced(head, tokens[place:end]), *braced(head, half_turn)]
    return [*quotient, head.standing_for("\\pi"), head.standing_for(" ")], behind
