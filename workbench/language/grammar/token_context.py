"""Tokens that depend on their neighbours: signs in scripts are marks."""

from __future__ import annotations

from lark import Token

from workbench.language.grammar.vocabulary import ENDS_A_FACTOR, ORIENTATIONS


def marked(tokens: list[Token]) -> list[Token]:
    """Returns the tokens with lone signs in scripts as marks: q^+, [x]_\\times, x^{\\wedge}, v_\\perp,
    x_{\\max}."""
    found = []
    for place, token in enumerate(tokens):
        if token.type in ("INFIX", "SIGN", "MARK", "EXTREMAL") or token in ORIENTATIONS:
            before = [t.type for t in tokens[max(place - 2, 0) : place]]
            closes = place + 1 < len(tokens) and tokens[place + 1].type == "RBRACE"
            alone = before[-1:] in (["SUP"], ["SUB"]) or (
                before in (["SUP", "LBRACE"], ["SUB", "LBRACE"]) and closes
            )
            if token == "*" and token.type == "MARK" and ENDS_A_FACTOR.intersection(before[-1:]):
                token = Token.new_borrow_pos("INFIX", "*", token)
            elif alone:
                text = f"\\{token}" if token.type == "EXTREMAL" else str(token)
                token = Token.new_borrow_pos("MARK", text, token)
        found.append(token)
    return found
