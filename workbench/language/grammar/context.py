"""What tokens are by those around them: signs in scripts are marks, and some lines go on in the next."""

from __future__ import annotations

from lark import Token

from workbench.language.grammar.vocabulary import ENDS_A_FACTOR, ORIENTATIONS, goes_on

_OPENS = frozenset({"OPEN", "LBRACE", "BEGIN_MATRIX", "BEGIN_LINES"})
_CLOSES = frozenset({"CLOSE", "RBRACE", "END_MATRIX", "END_LINES"})


def marked(tokens: list[Token]) -> list[Token]:
    """A sign that stands alone in a script is a mark: q^+, [x]_\\times, x^{\\wedge}, v_\\perp, x_{\\max}."""
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


def join_lines(tokens: list[Token]) -> list[Token]:
    """A line goes on after a break if it ends with a sign, if the next begins with =, × and the like, or if
    the next begins with a sign and relates nothing. A comma before such a break goes."""
    joined: list[Token] = []
    in_cases: list[bool] = [False]  # of each environment: whether its lines are the values of a side
    for place, token in enumerate(tokens):
        if token.type == "BEGIN_LINES":
            in_cases.append(any(each.type == "RELATION" for each in joined[-1:]))
        elif token.type == "END_LINES":
            in_cases.pop()
        elif token.type == "BREAK" and joined and place + 1 < len(tokens):
            before, after = joined[-1], tokens[place + 1]
            is_addend = (
                after.type == "SIGN"
                and not in_cases[-1]
                and _takes_addends(joined)
                and not _relates(tokens[place + 1 :])
            )
            if goes_on(before.type, after.type, is_addend):
                if before.type == "COMMA" or (before.type == "SIGN" and after == before):
                    joined.pop()  # a sign that is repeated on the next line
                continue
        joined.append(token)
    return joined


def _relates(tokens: list[Token]) -> bool:
    """Whether the clause that begins here says something, and is not the rest of a side."""
    depth = 0
    for token in tokens:
        depth += (token.type in _OPENS) - (token.type in _CLOSES)
        if depth < 0 or (depth == 0 and token.type in ("COMMA", "BREAK", "GIVEN")):
            return False
        if depth == 0 and token.type == "RELATION":
            return True
    return False


def _takes_addends(tokens: list[Token]) -> bool:
    """Whether the line that ends here ends with a side, and not with a condition."""
    relation, has_comma = "", False
    for token in reversed(tokens):
        if token.type in ("BREAK", "BEGIN_LINES"):
            break
        if token.type == "GIVEN":
            return False
        if token.type == "RELATION":
            relation = relation or str(token)
        has_comma = has_comma or (token.type == "COMMA" and token is not tokens[-1])
    return relation == "=" or (relation != "" and not has_comma)
