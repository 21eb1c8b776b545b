"""Functions that a sentence writes with their arguments: in a formula, a bracket after such a symbol may
contain its argument, and not a factor."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

from workbench.context.claims import Claim
from workbench.core.brackets import end_of_group
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import SpecError
from workbench.language.elaboration.arguments import line_of_arguments, question_of
from workbench.language.grammar.latex_keys import Ignored, latex_key
from workbench.language.naming.declarations import read_key
from workbench.source.documents import Text

_IGNORED = Ignored.BRACES | Ignored.SIZES
_FUNCTION = re.compile(r"(\\?[A-Za-z]+(?:_\w+)?)\([^()]+\)")


def functions_in(text: Text) -> frozenset[str]:
    """Returns the symbols, without braces, that sentences of the text write with an argument: x of $x(z)$."""
    found = (_FUNCTION.fullmatch(latex_key(each.latex, _IGNORED)) for each in text.inline)
    return frozenset(match[1] for match in found if match is not None)


def asked_if_function(claim: Claim, functions: Collection[str]) -> Claim:
    """Returns the claim as unread, with the question, if its product of vectors x (y) may be the value of a
    function."""
    printed = claim.printed
    if printed.ill_formed is None or TypeCode.JUXTAPOSITION not in printed.ill_formed.codes:
        return claim
    flat = latex_key(printed.latex, _IGNORED)
    own = next((each for each in sorted(functions) if f"{each}(" in flat), None)
    if own is None:
        return claim
    behind = flat[flat.index(f"{own}(") + len(own) :]
    end = end_of_group(behind, "(", ")")
    inside = behind[1:] if end is None else behind[1 : end - 1]
    unread = SyntaxCode.CANNOT_BE_READ(why=question_of(own, inside, _line_of(inside)))
    return replace(claim, printed=replace(printed, ill_formed=None, unread=unread))


def _line_of(inside: str) -> str | None:
    """Returns the line that makes the content of a bracket arguments; None if they are not all names."""
    parts = inside.split(",")
    try:
        for part in parts:
            read_key(part)
    except SpecError:
        return None
    return line_of_arguments(parts)
