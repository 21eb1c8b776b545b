"""The independent quantities on which the free symbols of a statement depend at one instant.

A free function x(t) has its value and each of its derivatives; these can be chosen at will at one instant.
What is bound by a relation at all times is written by quantities that are free, so that no derivative of the
relation is needed:

    unit vector     u·u = 1        u̇ = s × u,   s(t) free            (any curve on the sphere has such an s)
    rotation        R Rᵀ = I       R = R(q), |q| = 1,   Ṙ = s̃ R      (s is the angular velocity)
    dual unit       u + ε u₀       u₀ = m × u,  m(t) free            (u·u₀ = 0 has exactly these solutions)
    dual rotation   (I + ε ρ̃) R    ρ(t) free                         (Du·Rᵀ is skew exactly for these)
    angle           α, sin α, cos α with sin² + cos² = 1

Both engines name their indeterminates by these parameters, so that a point of one is a point of the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from workbench.judge.inventory import Inventory, NotExact
from workbench.language.terms import Symbol

#: Parts whose components lie on a unit sphere, and how many components they have.
SPHERES = {"circle": 2, "unit": 3, "quaternion": 4}


@dataclass(frozen=True, slots=True)
class Parameter:
    """Component `component` of the `order`-th derivative of one part of a symbol.

    part: "value", "dual", "unit", "spin", "moment", "quaternion", "translation", or "circle" (cos, sin).
    """

    symbol: Symbol
    part: str
    order: int
    component: int


def parameters(inventory: Inventory) -> Iterator[Parameter]:
    """All parameters of the inventory's symbols, symbol by symbol, in order of derivative."""
    for symbol, order in inventory.orders.items():
        for part, count, orders in parts(symbol, order):
            for k in range(orders):
                for component in range(count):
                    yield Parameter(symbol, part, k, component)
    for angle in inventory.angles:
        for component in range(SPHERES["circle"]):
            yield Parameter(angle, "circle", 0, component)


def parts(symbol: Symbol, order: int) -> tuple[tuple[str, int, int], ...]:
    """(part, components, how many orders) for each part of the symbol differentiated up to `order` times."""
    declaration = symbol.declaration
    dual = symbol.type.dual
    moving = 0 if declaration.constant else order
    if declaration.unit:
        moment = (("moment", 3, moving + 1),) if dual else ()
        return (("unit", 3, 1), ("spin", 3, moving), *moment)
    if declaration.rotation:
        translation = (("translation", 3, moving + 1),) if dual else ()
        return (("quaternion", 4, 1), ("spin", 3, moving), *translation)
    count = _components(symbol)
    dual_part = (("dual", count, moving + 1),) if dual else ()
    return (("value", count, moving + 1), *dual_part)


def _components(symbol: Symbol) -> int:
    type_ = symbol.type
    if type_.kind == "block":
        return sum(type_.rows) * sum(type_.columns)
    counts = {"scalar": 1, "vector": 3, "covector": 3, "tensor": 9}
    if type_.kind not in counts:
        raise NotExact(f"{symbol.declaration.name} is an undefined {type_}")
    return counts[type_.kind]
