"""Derivatives by the macros of the packages physics, derivative and commath, and derivatives in a frame."""

from __future__ import annotations

from workbench.source.documents import Token
from workbench.source.rewriting.token_groups import braced, group, is_one_symbol, past, printed

_BY_NAME = dict.fromkeys((r"\dv", r"\od", r"\odv", r"\derivative"), "d")
_BY_NAME |= dict.fromkeys((r"\pdv", r"\pd", r"\partialderivative"), r"\partial")
#: Opening before the quotient → closing after it, before the subscript that names the frame.
_AROUND = {
    ("\\left", "."): ["\\right", "|"],
    ("\\left", "("): ["\\right", ")"],
    ("\\left", "["): ["\\right", "]"],
    ("(",): [")"],
    ("[",): ["]"],
}
_DOTS = {"\\dot": "", "\\ddot": "2", "\\dddot": "3"}
_OF_TIME = (["d", "t", "^"], ["(", "d", "t", "^"])


def derivative_by_name(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\dv[2]{x}{t} to \\frac{d^2 x}{d t^2}, and \\pdv{x}{s}{t} to the mixed derivative."""
    head = tokens[place]
    if head.text not in _BY_NAME:
        return None
    order: list[Token] = []
    position = past(tokens, place + 1)
    if position < len(tokens) and tokens[position].text == "*":
        position = past(tokens, position + 1)
    if position < len(tokens) and tokens[position].text == "[":
        end = next((i for i in range(position, len(tokens)) if tokens[i].text == "]"), len(tokens))
        order = [head.standing_for("^"), *braced(head, tokens[position + 1 : end])]
        position = past(tokens, end + 1)
    groups: list[list[Token]] = []
    most = 3 if _BY_NAME[head.text] != "d" and not order else 2
    while len(groups) < most and position < len(tokens) and tokens[position].text == "{":
        inside, position = group(tokens, position)
        groups.append(inside)
    if not groups:
        return None
    d, space = head.standing_for(_BY_NAME[head.text]), head.standing_for(" ")
    if len(groups) == 3:
        order = [head.standing_for(text) for text in "^2"]
        above = [d, *order, space, *groups[0]]
        below = [d, space, *groups[1], space, d, space, *groups[2]]
    else:
        above = [d, *order, space, *(groups[0] if len(groups) == 2 else [])]
        below = [d, space, *groups[-1], *order]
    return [head.standing_for("\\frac"), *braced(head, above), *braced(head, below)], position


def seen_from(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\left. \\frac{dx}{dt} \\right|_B, \\left( … \\right)_B and \\frac{dx}{dt^B} to \\frac{{}^B
    dx}{dt}."""
    texts = tuple(token.text for token in tokens[place : place + 2])
    opening = next((each for each in _AROUND if texts[: len(each)] == each), ())
    closing = _AROUND.get(opening, [])
    quotient = past(tokens, place + len(opening)) if opening else place
    if opening and quotient < len(tokens) and tokens[quotient].text in _DOTS:
        return _dotted(tokens, quotient, closing)
    if quotient >= len(tokens) or tokens[quotient].text != "\\frac":
        return None
    over, middle = group(tokens, past(tokens, quotient + 1))
    under, end = group(tokens, past(tokens, middle))
    if closing:
        found = _label_behind(tokens, end, closing)
        if found is None or printed(under)[:2] != ["d", "t"]:
            return None
        label, end = found
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


def at_a_label(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\left. x \\right|_B, for one symbol x, to (x)_B."""
    if [token.text for token in tokens[place : place + 2]] != ["\\left", "."]:
        return None
    end = next((i for i in range(place, len(tokens)) if tokens[i].text == "\\right"), len(tokens))
    closing = [token.text for token in tokens[end : end + 2]]
    found = _label_behind(tokens, end, closing) if closing[1:] in (["|"], [")"]) else None
    inside = tokens[place + 2 : end]
    if found is None or "=" in printed(found[0]) or not is_one_symbol(inside):
        return None
    head = tokens[place]
    return [head, head.standing_for("("), *inside, tokens[end], head.standing_for(")")], end + 2


def _dotted(tokens: list[Token], dot: int, closing: list[str]) -> tuple[list[Token], int] | None:
    """Rewrites (\\dot{x})_B, if the brackets contain only x."""
    body, end = group(tokens, past(tokens, dot + 1))
    while past(tokens, end) < len(tokens) and tokens[past(tokens, end)].text in ("_", "^"):
        script = past(tokens, end)
        _, end = group(tokens, past(tokens, script + 1))
        body += tokens[script:end]
    found = _label_behind(tokens, end, closing)
    if found is None or not _is_label(found[0]):
        return None
    head, order = tokens[dot], _DOTS[tokens[dot].text]
    power = [head.standing_for(text) for text in ("^", order) if order]
    label = braced(head, found[0])
    over = [*(head.standing_for(text) for text in "{}^"), *label, head.standing_for("d"), *power]
    under = [*(head.standing_for(text) for text in "dt"), *power]
    made = [head.standing_for("\\frac"), *braced(head, [*over, head.standing_for(" "), *body])]
    return [*made, *braced(head, under)], found[1]


def _label_behind(tokens: list[Token], end: int, closing: list[str]) -> tuple[list[Token], int] | None:
    """Returns the subscript of the bracket that closes at `end`, and the index after it; None if there is
    none."""
    end = past(tokens, end)
    script = past(tokens, end + len(closing))
    is_closed = [token.text for token in tokens[end : end + len(closing)]] == closing
    if not is_closed or printed(tokens[script : script + 1]) != ["_"]:
        return None
    return group(tokens, past(tokens, script + 1))


def _is_label(label: list[Token]) -> bool:
    """True if the subscript names a frame, and is not a power or condition."""
    texts = [text for text in printed(label) if text not in ("{", "}")]
    if texts[:1] in (["\\times"], ["\\wedge"], ["\\vee"]):
        return False  # [\dot{x}]_\times
    is_word = len(texts) > 2 and all(text.isalpha() for text in texts)
    return bool(texts) and (texts[0].startswith("\\") or texts[0].isupper() or is_word) and "=" not in texts
