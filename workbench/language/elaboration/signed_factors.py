"""Signs of factors: a \\times -b c is a \\times (-b) c."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.language.grammar.syntax import Group, Infix, Node, Product, Sum
from workbench.language.naming.scope import Scope

_Addend = tuple[str, int, Node]

#: The signs of products that are linear in the factor behind them.
_PRODUCTS = "·×*⊗"


def with_signed_factors(scope: Scope, addends: Sequence[_Addend]) -> list[_Addend]:
    """Returns the addends of a sum; a sign behind that of a product belongs to the factor behind it.

    Exception: an addend that ends with a sign as the paper spells an operation, such as x \\times.
    """
    found: list[_Addend] = []
    for sign, at, addend in addends:
        if found and sign and _waits(scope, found[-1][2]):
            before, place, head = found[-1]
            first, *rest = _factors(addend)
            factor = Group(at, (Sum(at, ((sign, at, first),)),))
            found[-1] = (before, place, Product(head.at, (*_factors(head), factor, *rest)))
        else:
            found.append((sign, at, addend))
    return found


def _waits(scope: Scope, addend: Node) -> bool:
    """True if a product ends with a sign whose second operand is missing."""
    *before, last = _factors(addend)
    if not before or not isinstance(last, Infix) or last.operator not in _PRODUCTS:
        return False
    return scope.spelt(Product(last.at, (before[-1], last))) is None


def _factors(addend: Node) -> tuple[Node, ...]:
    return addend.items if isinstance(addend, Product) else (addend,)
