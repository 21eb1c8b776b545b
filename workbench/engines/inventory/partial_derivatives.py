"""Partial derivatives: their variables, and the functions `of` coordinates that they differentiate.

At one instant a function f of q is its value and its partial derivatives, the parameters f_α. A smooth
function may have any values of these:

    d f_α = Σᵢ f_{α+eᵢ} d qᵢ      for every derivation d, d/dt and ∂/∂q alike

∂/∂q keeps everything else fixed: other coordinates, t, and q̇ next to q. A symbol is independent of q only if
it is declared so: as a constant, as a coordinate that functions are `of`, or as a function of other
coordinates.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import NamedTuple

from workbench.core.codes.engine_codes import EngineCode
from workbench.core.operations import PARTIALS
from workbench.core.terms import Apply, Block, Derivative, Head, Number, Symbol, Term
from workbench.core.types import Declaration
from workbench.engines.inventory import Lookup, NotExact, reached


class Seed(NamedTuple):
    """A component of a derivative of a free symbol; the variable is `factor` times this component."""

    symbol: Symbol
    order: int
    component: int
    factor: Fraction


def seeds(by: Term, definitions: Lookup) -> list[Seed]:
    """Returns the components of the variable of a partial derivative. Raises NotExact if they are not
    free."""
    match by:
        case Derivative(order=order):
            return [seed._replace(order=seed.order + int(order)) for seed in seeds(by.body, definitions)]
        case Block(entries=entries) if all(len(row) == 1 for row in entries):
            found = [seed for (entry,) in entries for seed in seeds(entry, definitions)]
            if len({seed[:3] for seed in found}) == len(found):
                return found
        case Apply(head="mul", arguments=(Number(value=value), Symbol() as part)):
            return [seed._replace(factor=seed.factor * value) for seed in seeds(part, definitions)]
        case Symbol() if (body := definitions.lookup(by)) is not None:
            return seeds(body, definitions)
        case Symbol() if not (by.type.dual or _is_constrained(by.declaration)):
            count = by.type.rows * by.type.columns
            return [Seed(by, 0, component, Fraction(1)) for component in range(count)]
    raise NotExact("a partial derivative by what is no free coordinate")


def _is_constrained(of: Declaration) -> bool:
    """True if the components cannot change one by one."""
    return of.unit or of.rotation or of.transform or of.symmetric or of.diagonal


def positive_coordinates(sides: Iterable[Term], definitions: Lookup) -> frozenset[Symbol]:
    """Returns the positive symbols that partial derivatives differentiate by. None is free: each is a
    square."""
    parts = list(reached(definitions, *sides))
    by = [part.arguments[1] for part in parts if isinstance(part, Apply) and part.head in PARTIALS]
    symbols = (part for part in reached(definitions, *by) if isinstance(part, Symbol))
    return frozenset(s for s in symbols if s.declaration.positive and definitions.lookup(s) is not None)


def require_known_dependence(
    head: Head, by: Iterable[Seed], symbols: Iterable[Symbol], moving: Collection[Symbol]
) -> None:
    """Raises NotExact for a symbol whose dependence on the variable is unknown.

    By a function f only a function can be differentiated that has f as an argument, whose other arguments are
    kept, or that is of f alone. No rate of a point can be by the position in a field.
    moving: the symbols under a time derivative.
    """
    varied = {seed.symbol for seed in by}
    by_function = any(symbol.declaration.of for symbol in varied)
    by_place = all(symbol.declaration.coordinate for symbol in varied)
    for symbol in symbols:
        declaration = symbol.declaration
        if by_place and symbol in moving and (symbol in varied or _moved_by(symbol, varied) & varied):
            raise NotExact(f"the rate of {declaration.name} depends on the place as the motion says")
        if symbol in varied or declaration.constant or (by_place and declaration.uniform):
            continue
        name = declaration.name
        if not (declaration.independent or declaration.of):
            raise NotExact(EngineCode.PARTIAL_MAY_DEPEND(name=name))
        others = {each for each in _moved_by(symbol, varied) if not each.declaration.clock} - varied
        is_slot = head == "partial" and not varied.isdisjoint(declaration.of)
        if by_function and ((others and not is_slot) or not declaration.of):
            raise NotExact(f"{name} is no function of that alone by which it is differentiated")
        if head == "total" and (others or (not declaration.of and not declaration.clock)):
            raise NotExact(f"{name} in the derivative d/dx may change with x; write \\partial if it is kept")


def _moved_by(symbol: Symbol, varied: set[Symbol]) -> set[Symbol]:
    """Returns the arguments of a function, resolved down to the symbols in `varied`."""
    found: set[Symbol] = set()
    for each in symbol.declaration.of:
        found |= _moved_by(each, varied) if each.declaration.of and each not in varied else {each}
    return found


def indices(count: int, degree: int) -> list[tuple[int, ...]]:
    """Returns the partial derivatives of a degree by `count` coordinates, each as sorted coordinate
    indices."""
    return list(combinations_with_replacement(range(count), degree))


def coordinate_count(symbol: Symbol) -> int:
    return sum(argument.type.rows for argument in symbol.declaration.of)
