"""Guess for unexpandable macros: a pair of brackets around the argument."""

from __future__ import annotations

from workbench.source.documents.tex.expander_state import Macro


def fence_of(macro: Macro) -> str | None:
    """Returns the body of a macro that opens and closes one pair of brackets around one argument; else None.

    It is a guess: everything else in the macro is assumed to be size and space.
    """
    content = [place for place, parameter in enumerate(macro.parameters, 1) if parameter.kind == "braces"]
    lefts, rights, used = set(), set(), set()
    for token, following in zip(macro.body, macro.body[1:], strict=False):
        if token.text == "\\left":
            lefts.add(following.text)
        elif token.text == "\\right":
            rights.add(following.text)
        elif token.text[:1] == "#" and token.text[1:].isdecimal():
            used.add(int(token.text[1:]))
    lefts.discard(".")
    rights.discard(".")
    if len(content) != 1 or content[0] not in used or len(lefts) != 1 or len(rights) != 1:
        return None
    return f"\\left{lefts.pop()} #1\\right{rights.pop()}"
