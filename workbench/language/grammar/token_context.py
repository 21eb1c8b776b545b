"""Tokens that depend on their neighbours: signs in scripts are marks, fonts of formulas those of letters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from lark import Token

from workbench.language.grammar.vocabulary import ENDS_A_FACTOR, ORIENTATIONS


def marked(tokens: list[Token]) -> list[Token]:
    """Returns the tokens with lone signs in scripts as marks: q^+, [x]_\\times, x^{\\wedge}, v_\\perp,
    x_{\\max}."""
    found = []
    tokens = _with_own_fonts(tokens)
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


#: Fonts that stand over whole formulas; \\mathrm stands over words.
_BOLD = frozenset({"\\mathbf", "\\boldsymbol"})
_OPERATORS = frozenset({"RELATION", "SIGN", "INFIX"})


def _with_own_fonts(tokens: list[Token]) -> list[Token]:
    """Returns the tokens with a bold font of a formula as that of its letters: \\mathbf{a = b \\times c}."""
    found: list[Token] = []
    place = 0
    while place < len(tokens):
        end = _end_of_braces(tokens, place + 1) if tokens[place] in _BOLD else place
        inside = tokens[place + 2 : end]
        if any(token.type in _OPERATORS for token in _outside_scripts(inside)):
            letters = list(_with_font(tokens[place], inside))
            is_group = all(token.type != "RELATION" for token in inside)
            found += [tokens[place + 1], *letters, tokens[end]] if is_group else letters
            place = end + 1
        else:
            found.append(tokens[place])
            place += 1
    return found


def _end_of_braces(tokens: Sequence[Token], start: int) -> int:
    """Returns the place of the brace that closes the one at `start`; `start` if none opens there."""
    depth = 0
    for place in range(start, len(tokens)):
        depth += {"LBRACE": 1, "RBRACE": -1}.get(tokens[place].type, 0)
        if depth == 0:
            return place
    return start


def _outside_scripts(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens that stand in no braces."""
    depth = 0
    for token in tokens:
        depth += {"LBRACE": 1, "RBRACE": -1}.get(token.type, 0)
        if depth == 0:
            yield token


def _with_font(font: Token, tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens with the font before each letter that has none and stands in no script."""
    behind = 0
    for place, token in enumerate(tokens):
        before = tokens[place - 1].type if place else ""
        if before in ("SUB", "SUP", "STYLE") and token.type != "STYLE":
            behind = max(behind, _end_of_braces(tokens, place) + 1)
        if token.type == "LETTER" and place >= behind:
            yield Token.new_borrow_pos("STYLE", str(font), token)
        yield token
