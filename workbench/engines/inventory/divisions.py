"""Operations that are defined and smooth wherever their arguments are."""

from __future__ import annotations

from workbench.core.operations import LINEAR, PRODUCTS
from workbench.core.terms import Apply, Power, Term

_EVERYWHERE = LINEAR | {*PRODUCTS, "add", "det", "sin", "cos", "exp"}


def never_divides(part: Term) -> bool:
    """True if the operation at the top of the term is defined and smooth everywhere. False means unknown."""
    if isinstance(part, Power):
        lowest = part.exponent.substitute(dict.fromkeys(part.exponent.variables, 0))
        grows = all(coefficient > 0 for _, coefficient in part.exponent.coefficients)
        return part.base.type.kind == "operator" or (grows and int(lowest) >= 0)
    return not isinstance(part, Apply) or part.head in _EVERYWHERE
