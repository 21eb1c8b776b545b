"""Derivatives as authors write them: by the names of the package physics, and seen from a frame."""

from __future__ import annotations

from workbench.papers.respell.places import braced, group, past, printed
from workbench.papers.texts import Token

_BY_NAME = {"\\dv": "d", "\\pdv": "\\partial"}
#: What opens before the quotient → what closes behind it, before the subscript that names the frame.
_AROUND = {("\\left", "."): ["\\right", "|"], ("\\left", "("): ["\\right", ")"], ("(",): [")"]}
_OF_TIME = (["d", "t", "^"], ["(", "d", "t", "^"])


def derivative_by_name(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """\\dv[2]{x}{t} as \\frac{d^2 x}{d t^2}."""
    head = tokens[place]
    if head.text not in _BY_NAME:
        return None
    order: list[Token] = []
    position = past(tokens, place + 1)
    if position < len(tokens) and tokens[position].text == "[":
        end = next((i for i in range(position, len(tokens)) if tokens[i].text == "]"), len(tokens))
        order = [head.standing_for("^"), *braced(head, tokens[position + 1 : end])]
        position = past(tokens, end + 1)
    groups: list[list[Token]] = []
    while len(groups) < 2 and position < len(tokens) and tokens[position].text == "{":
        inside, position = group(tokens, position)
        groups.append(inside)
    if not groups:
        return None
    d, space = head.standing_for(_BY_NAME[head.text]), head.standing_for(" ")
    above = [d, *order, space, *(groups[0] if len(groups) == 2 else [])]
    below = [d, space, *groups[-1], *order]
    return [head.standing_for("\\frac"), *braced(head, above), *braced(head, below)], position


def seen_from(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """\\left. \\frac{dx}{dt} \\right|_B, \\left( … \\right)_B and \\frac{dx}{dt^B} as \\frac{{}^B dx}{dt}."""
    texts = tuple(token.text for token in tokens[place : place + 2])
    opening = next((each for each in _AROUND if texts[: len(each)] == each), ())
    closing = _AROUND.get(opening, [])
    quotient = past(tokens, place + len(opening)) if opening else place
    if quotient >= len(tokens) or tokens[quotient].text != "\\frac":
        return None
    over, middle = group(tokens, past(tokens, quotient + 1))
    under, end = group(tokens, past(tokens, middle))
    if closing:
        end = past(tokens, end)
        behind_it = end + len(closing)
        if [token.text for token in tokens[end:behind_it]] != closing:
            return None
        script = past(tokens, behind_it)
        if printed(tokens[script : script + 1]) != ["_"] or printed(under) != ["d", "t"]:
            return None
        label, end = group(tokens, past(tokens, script + 1))
    else:
        mark = next((place for place, token in enumerate(under) if token.text == "^"), len(under))
        if printed(under[: mark + 1]) not in _OF_TIME:
            return None
        label, after = group(under, past(under, mark + 1))
        under = [token for token in [*under[:mark], *under[after:]] if token.text not in ("(", ")")]
    if printed(over)[:1] != ["d"] or not _is_label(label):
        return None
    head = tokens[quotient]
    seen = [*(head.standing_for(text) for text in "{}^"), *braced(head, label), *over]
    return [head, *braced(head, seen), *braced(head, under)], end


def _is_label(label: list[Token]) -> bool:
    """Whether it names a frame, and is no power or condition."""
    texts = [text for text in printed(label) if text not in ("{", "}")]
    return bool(texts) and (texts[0].startswith("\\") or texts[0].isupper()) and "=" not in texts
