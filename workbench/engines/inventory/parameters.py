"""Parameters: the independent quantities that determine the free symbols of a statement at one instant.

A free function x(t) has its value and each of its derivatives; at one instant these can be chosen freely. A
quantity with a relation at all times is expressed by free quantities, so that no derivative of the relation
is needed:

    unit vector     u·u = 1        u̇ = s × u,   s(t) free            (any curve on the sphere has such an s)
    rotation        R Rᵀ = I       R = R(q), |q| = 1,   Ṙ = s̃ R      (s is the angular velocity)
    dual unit       u + ε u₀       u₀ = m × u,  m(t) free            (u·u₀ = 0 has exactly these solutions)
    dual rotation   (I + ε ρ̃) R    ρ(t) free                         (Du·Rᵀ is skew exactly for these)
    transform       [R p; 0 1]     R a rotation, p(t) free
    unit quaternion |q| = 1        q̇ = ½ (0, s) q,   s(t) free       (s is the angular velocity)
    dual of it      q + ε ½ ρ q    ρ(t) free                         (q · Du q = 0 has just these solutions)
    function f(q)   f_α free       d f_α = Σ f_{α+eᵢ} d qᵢ           (see `partial_derivatives.py`)
    angle           α, sin α, cos α with sin² + cos² = 1

Both engines name their indeterminates by these parameters, so that a point of one is a point of the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from workbench.core.properties import properties_of
from workbench.core.terms import Symbol, Term
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.partial_derivatives import coordinate_count, indices

#: Parts whose components lie on a unit sphere → the number of components.
SPHERES = {"circle": 2, "unit": 3, "quaternion": 4}


class Parameter(NamedTuple):
    """Component `component` of the `order`-th derivative of one part of a symbol, or of the circle of a term.

    part: "value", "dual", "unit", "spin", "moment", "quaternion", "translation", "circle" (cos, sin), or
    "slope1", "slope2", … for the partial derivatives of that degree, those of one component in sequence.
    """

    symbol: Symbol | Term
    part: str
    order: int
    component: int


def parameters(inventory: Inventory) -> Iterator[Parameter]:
    """Yields all parameters of the inventory's symbols, symbol by symbol, in order of derivative."""
    for symbol, order in inventory.orders.items():
        for part, count, orders in parts(symbol, order):
            for k in range(orders):
                for component in range(count):
                    yield Parameter(symbol, part, k, component)
    for angle in (*inventory.angles, *inventory.circles.values()):
        for component in range(SPHERES["circle"]):
            yield Parameter(angle, "circle", 0, component)


def parts(symbol: Symbol, order: int) -> tuple[tuple[str, int, int], ...]:
    """Returns (part, components, number of orders) for each part of the symbol, differentiated `order` times
    at most."""
    declaration = symbol.declaration
    dual = symbol.type.dual
    moving = 0 if declaration.constant or declaration.clock else order
    if declaration.of:
        count, among = components(symbol), coordinate_count(symbol)
        degrees = [("value" if k == 0 else f"slope{k}", indices(among, k)) for k in range(order + 1)]
        return tuple((part, count * len(places), 1) for part, places in degrees)
    if declaration.transform:
        return (("quaternion", 4, 1), ("spin", 3, moving), ("translation", 3, moving + 1))
    kind = symbol.type.kind
    charts = [each.chart[kind] for each in properties_of(declaration) if kind in each.chart]
    if charts:
        shift = "moment" if charts[0] == "unit" else "translation"
        shifted = ((shift, 3, moving + 1),) if dual else ()
        return ((charts[0], SPHERES[charts[0]], 1), ("spin", 3, moving), *shifted)
    count = components(symbol)
    dual_part = (("dual", count, moving + 1),) if dual else ()
    return (("value", count, moving + 1), *dual_part)


def components(symbol: Symbol) -> int:
    """Returns the number of scalars in a value of the symbol: of a symmetric matrix its upper triangle, of a
    diagonal one its diagonal."""
    type_ = symbol.type
    if type_.kind == "operator":
        raise NotExact(f"{symbol.declaration.name} is an undefined {type_}")
    free = [each.free(type_.rows) for each in properties_of(symbol.declaration) if each.free]
    return min(free, default=type_.rows * type_.columns)
