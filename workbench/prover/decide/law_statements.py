"""Recognizes equations that state a law: m p̈ = m g determines p̈, and is not an identity.

Such an equation contains the highest derivative of a free symbol exactly once, and can be solved for it. A
mistaken product rule such as d/dt(f g) = f ġ would be an equation for ḟ as well. It is told apart because in
a law the derivative stands alone, as p̈ does, or the other side has other symbols, as in d/dt(m v) = F.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from random import Random
from typing import NamedTuple

import numpy as np

from workbench.core.construct import derivative, with_children
from workbench.core.operations import PARTIALS
from workbench.core.terms import Apply, Block, Derivative, Relation, Symbol, Term
from workbench.core.types import SCALAR, Declaration
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import Parameter, parts
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import FloatRing, PointSource, RationalRing, sample
from workbench.language.definitions import number_behind

_LINEAR = frozenset(
    {"mul", "neg", "dot", "cross", "outer", "transpose", "skew", "vector part", "scalar part"}
)
_ENTRIES = (-3, -2, -1, 1, 2, 3)
_POINTS, _TRIES, _SEED = 3, 30, 0
_TOLERANCE = 1e-9
_ELSEWHERE = 2.0


@dataclass(frozen=True)
class _Occurrence:
    side: int
    order: int
    alone: bool  # the derivative is that of the symbol, or of its product with constants


def law_for(relation: Relation, inventory: Inventory, definitions: Lookup) -> Term | None:
    """Returns the derivative of a free symbol that the equation can be solved for; None if it is not a
    law."""
    sides = (relation.left, relation.right)
    used = reached(definitions, *sides)
    if relation.operator != "=" or any(map(_is_no_rate, used)) or _is_of_known_rates(sides, definitions):
        return None
    found: dict[Symbol, list[_Occurrence]] = defaultdict(list)
    named: dict[Symbol, list[_Occurrence]] = defaultdict(list)
    for side, term in enumerate(sides):
        for symbol, order, alone in _occurrences(term, definitions, 0, True):
            kept = found if definitions.lookup(symbol) is None else named
            kept[symbol].append(_Occurrence(side, order, alone))
    claimed = _claimed(found, sides, definitions)
    rates = {symbol: inventory.orders.get(symbol, 0) for symbol in found}
    if any(_rates_a_definition(symbol, named[symbol], rates, definitions) for symbol in named):
        return None
    for whole, entries in [*((s, (s,)) for s in found), *_composed(named, inventory, definitions)]:
        orders = {inventory.orders.get(symbol, 0) for symbol in entries}
        highest = [o for symbol in entries for o in found[symbol] if o.order in orders]
        free = [s for s in entries if _may_be_given(s.declaration) and s not in claimed]
        if len(orders) == 1 and all(orders) and len(entries) == len(highest) == len(free):
            (order,), place = orders, highest[0]
            if sum(map(len, found.values())) == len(entries):
                return None  # ẋ = 0 means that x is constant
            beyond = {s for s, others in found.items() if all(o.side != place.side for o in others)}
            alone = all(each.alone for each in highest)
            said = max(named.get(whole, highest), key=lambda each: each.order)
            if whole in named and _is_moved_by(entries, whole, definitions):
                alone = said.alone
            if whole.declaration.hidden:  # a law for the author's symbols, not for hidden ones
                written, occurrence = _written(whole, place.side, named, definitions)
                if written is None or occurrence is None:
                    continue
                whole, said = written, occurrence
                beyond, alone = {s for s in beyond if not s.declaration.hidden}, False
            if not (alone or beyond):
                continue
            if _has_solutions(relation, inventory, definitions, entries, order):
                whole = number_behind(whole)
                return derivative(whole, said.order) if said.order else whole
    return None


def _is_of_known_rates(sides: tuple[Term, Term], definitions: Lookup) -> bool:
    """True if the sides differ by the orders of rates only, or if one is a symbol defined by a rate of the
    other.

    With v = ṙ, m v = m r̈ is no law, nor is M = b ẋ − c ẋ with M = b ẋ − c ẏ. ẍ = ẋ and m ẍ = m x may be
    laws.
    """
    one, other = (_without_orders(side, definitions) for side in sides)
    if one == other and isinstance(one, Apply) and one.head in ("mul", "neg", "dot", "cross"):
        return True
    return any(
        not _rates_of(own, definitions).isdisjoint(_rates_of(value, definitions))
        for own, value in (sides, sides[::-1])
        if isinstance(own, Symbol) and definitions.lookup(own) is not None
    )


def _rates_of(term: Term, definitions: Lookup) -> set[tuple[Symbol, int]]:
    """Returns the free symbols that a term or its definitions differentiate, with the orders."""
    occurrences = _occurrences(term, definitions, 0, True)
    return {(s, order) for s, order, _ in occurrences if order and definitions.lookup(s) is None}


def _without_orders(term: Term, definitions: Lookup) -> Term:
    """Returns the term with ẋ for each rate of a symbol x, and for each symbol that is defined as one."""
    if isinstance(term, Derivative) and isinstance(term.body, Symbol):
        inner = _without_orders(term.body, definitions)
        return inner if isinstance(inner, Derivative) else derivative(inner, 1)
    if isinstance(term, Symbol):
        body = definitions.lookup(term)
        is_rate = isinstance(body, Derivative) and isinstance(body.body, Symbol)
        return _without_orders(body, definitions) if body is not None and is_rate else term
    return with_children(term, lambda child: _without_orders(child, definitions))


def _rates_a_definition(
    defined: Symbol, occurrences: list[_Occurrence], rates: Mapping[Symbol, int], definitions: Lookup
) -> bool:
    """True if the equation contains a rate of a symbol defined by its other symbols, and a higher rate of
    these.

    It then states the rate, perhaps wrongly, as ė = φ̈ n for e = (cos φ, sin φ).
    """
    inside = _occurrences(defined, definitions, max(each.order for each in occurrences), True)
    by_it = {symbol: order for symbol, order, _ in sorted(inside, key=lambda each: each[1])}
    is_moved = any(each.order for each in occurrences)
    return (
        is_moved
        and all(symbol in by_it for symbol in rates)
        and any(order > by_it[symbol] for symbol, order in rates.items())
    )


def _written(
    hidden: Symbol, side: int, named: Mapping[Symbol, list[_Occurrence]], definitions: Lookup
) -> tuple[Symbol | None, _Occurrence | None]:
    """Returns the author's symbol on the side that contains a hidden one, and its most differentiated
    occurrence."""
    for symbol, occurrences in named.items():
        own = [each for each in occurrences if each.side == side]
        if own and not symbol.declaration.hidden and hidden in _free_inside(symbol, definitions):
            return symbol, max(own, key=lambda each: each.order)
    return None, None


def _may_be_given(declared: Declaration) -> bool:
    return not (declared.constant or declared.of or declared.clock)


def _claimed(symbols: Iterable[Symbol], sides: Iterable[Term], definitions: Lookup) -> frozenset[Symbol]:
    """Returns the symbols that are declared free and related to other such symbols, so that the equation is a
    claim.

    A symbol that the equation differentiates by is a coordinate, for which it may be a law.
    """
    free = frozenset(each for each in symbols if each.declaration.free and not each.declaration.constant)
    slopes = (
        part.arguments[1]
        for side in sides
        for part in reached(definitions, side)
        if isinstance(part, Apply) and part.head in PARTIALS
    )
    by = {each.body if isinstance(each, Derivative) else each for each in slopes}
    return free - by if len(free) > 1 else frozenset()


def _composed(
    named: Iterable[Symbol], inventory: Inventory, definitions: Lookup
) -> Iterator[tuple[Symbol, tuple[Symbol, ...]]]:
    """Yields the columns and quaternions that definitions compose of symbols, as (x, y, z) or x i + y j + z
    k.

    Each comes with the components that the equation differentiates most often.
    """
    for whole in named:
        if whole.type.is_column or whole.type.kind == "quaternion":
            inside = (s for s in _free_inside(whole, definitions) if _may_be_given(s.declaration))
            orders = {symbol: inventory.orders.get(symbol, 0) for symbol in inside}
            entries = tuple(symbol for symbol in orders if orders[symbol] == max(orders.values()))
            if len(entries) > 1 and all(symbol.type == SCALAR for symbol in entries):
                yield whole, entries


def _is_moved_by(entries: tuple[Symbol, ...], whole: Symbol, definitions: Lookup) -> bool:
    """True if only the entries move in its definition, unlike i, j, k or a rotating matrix."""
    inside = _free_inside(whole, definitions)
    return all(symbol.declaration.constant or symbol in entries for symbol in inside)


def _free_inside(term: Term, definitions: Lookup) -> dict[Symbol, None]:
    """Returns the free symbols in the term and in its definitions, with the arguments of functions."""
    found: dict[Symbol, None] = {}
    waiting = [term]
    while waiting:
        parts = (part for part in reached(definitions, waiting.pop()) if isinstance(part, Symbol))
        for part in parts:
            if part not in found and definitions.lookup(part) is None:
                found[part] = None
                waiting += part.declaration.of
    return found


def _occurrences(
    term: Term, definitions: Lookup, order: int, alone: bool
) -> Iterator[tuple[Symbol, int, bool]]:
    """Yields the symbols in the term and in their definitions, with their orders.

    A momentum ∂L/∂q̇ contains q̇ once, regardless of how L is written.
    """
    if isinstance(term, Symbol):
        yield term, order, alone
        if (body := definitions.lookup(term)) is not None:
            yield from _occurrences(body, definitions, order, alone)
        else:
            for argument in term.declaration.of:  # the arguments of a function are differentiated with it
                yield from _occurrences(argument, definitions, order, False)
    elif isinstance(term, Derivative):
        yield from _occurrences(term.body, definitions, order + int(term.order), alone)
    elif (rate := _rate_of_momentum(term)) is not None and isinstance(rate.body, Symbol):
        inside = _occurrences(term.children[0], definitions, order, False)
        yield from (each for each in inside if each[0] != rate.body)
        yield rate.body, order + int(rate.order), alone
    else:
        for place, child in enumerate(term.children):
            others = (*term.children[:place], *term.children[place + 1 :])
            is_linear = isinstance(term, Block) or (
                isinstance(term, Apply)
                and term.head in _LINEAR
                and all(is_constant(other, definitions) for other in others)
            )
            yield from _occurrences(child, definitions, order, alone and (not order or is_linear))


def _is_no_rate(part: Term) -> bool:
    """True for an operator, and for a derivative of a general order, which is of no one rate."""
    return part.type.kind == "operator" or (isinstance(part, Derivative) and not part.order.is_number)


def _rate_of_momentum(term: Term) -> Derivative | None:
    """Returns the q̇ of ∂L/∂q̇, else None."""
    by = term.children[1] if isinstance(term, Apply) and term.head in PARTIALS else None
    return by if isinstance(by, Derivative) and isinstance(by.body, Symbol) else None


def is_constant(term: Term, definitions: Lookup) -> bool:
    return all(symbol.declaration.constant for symbol in _free_inside(term, definitions))


def _has_solutions(
    relation: Relation, inventory: Inventory, definitions: Lookup, symbols: tuple[Symbol, ...], order: int
) -> bool:
    """True if, at random values of the other symbols, some values of the derivatives satisfy the equation.

    An equation that forces an unrelated term to vanish is not a law: u_2 c_z × l c_x = 0 would mean u_2 = 0.
    """
    unknowns = [
        Parameter(symbol, part, orders - 1, component)
        for symbol in symbols
        for part, count, orders in parts(symbol, order)
        for component in range(count)
        if orders == order + (part != "spin")
    ]
    random = Random(_SEED)
    found: list[_Solved] = []
    for _ in range(_TRIES):
        drawn = sample(inventory, RationalRing(_ENTRIES), random)
        point = {parameter: float(value) for parameter, value in drawn.items()}
        with suppress(NotExact, ZeroDivisionError):
            one = _solved(relation, definitions, point, unknowns)
            if one is None:
                return False
            found.append(one)
        if len(found) == _POINTS:
            break
    if len(found) < _POINTS:
        return False
    is_identity = all(each.holds_without for each in found)
    return not is_identity or all(np.allclose(each.slopes, found[0].slopes) for each in found)


class _Solved(NamedTuple):
    """slopes: of left − right by the unknowns.   holds_without: True if the sides are equal, and not 0, where
    the unknowns are 0."""

    slopes: np.ndarray
    holds_without: bool


def _solved(
    relation: Relation, definitions: Lookup, point: dict[Parameter, float], unknowns: list[Parameter]
) -> _Solved | None:
    """Returns None if no values of the unknowns satisfy the equation, or it is not linear in them."""

    def engine(values: np.ndarray) -> JetEngine:
        at = {**point, **dict(zip(unknowns, values.tolist(), strict=True))}
        return JetEngine(PointSource(FloatRing(), at), definitions)

    def residual(values: np.ndarray) -> np.ndarray:
        return np.array(engine(values).differences(relation.left, relation.right), dtype=float)

    size = len(unknowns)
    without = engine(np.zeros(size))
    rest = np.array(without.differences(relation.left, relation.right), dtype=float)
    columns = np.column_stack([residual(unit) - rest for unit in np.eye(size)])
    other = np.arange(size) + _ELSEWHERE
    tolerance = _TOLERANCE * size * (1 + np.abs(rest).max() + np.abs(columns).max())
    solution = np.linalg.lstsq(columns, -rest, rcond=None)[0]
    errors = residual(other) - rest - columns @ other, columns @ solution + rest
    if not np.abs(errors).max() < tolerance:
        return None
    holds = np.abs(rest).max() < tolerance
    is_zero = holds and np.abs(np.array(without.components(relation.left), dtype=float)).max() < tolerance
    return _Solved(columns, bool(holds and not is_zero))
