"""Small rational points: where assumptions hold, and where a claim fails."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import compress
from random import Random
from typing import Any, NamedTuple

import numpy as np

from workbench.core.construct import apply, derivative
from workbench.core.terms import Derivative, Relation, Symbol, Term
from workbench.core.types import SCALAR, Type
from workbench.core.verdict import Counterexample
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import SPHERES, Parameter
from workbench.engines.inventory.partial_derivatives import indices
from workbench.engines.jet.batched_scalars import LaneRing, Lanes
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, RationalRing, sample
from workbench.language.definitions import number_behind
from workbench.language.printing.printer import to_latex

#: Coordinates to draw from, and the number of points to try with them.
STAGES = (((-1, 0, 1), 240), ((-2, -1, 0, 1, 2), 160), ((-3, -2, -1, 1, 2, 3), 120))

#: Differences above rounding errors of doubles, at points with such coordinates.
_CLEARLY = 1e-6

#: Function that completes a point with the parameters that the assumed equations determine.
Completion = Callable[[dict[Parameter, Fraction]], dict[Parameter, Fraction]]


@dataclass(frozen=True)
class Trial:
    """The values of two terms at one point; None if a side is undefined there."""

    point: dict[Parameter, Fraction]
    engine: JetEngine
    real: bool = False  # True if the numbers are balls

    def components(self, term: Term) -> list[Fraction] | None:
        try:
            return self.engine.components(term)
        except ZeroDivisionError:
            return None

    def differences(self, relation: Relation) -> list[Fraction] | None:
        try:
            return self.engine.differences(relation.left, relation.right)
        except ZeroDivisionError:
            return None

    def holds(self, relation: Relation) -> bool:
        """True if the relation holds at this point; False if it is undefined."""
        differences = self.differences(relation)
        if differences is None:
            return False
        return any(differences) == (relation.operator == "≠")

    def meets(self, bound: Relation) -> bool:
        """True if a ≥ b certainly holds at this point; False if a side is undefined."""
        differences = self.differences(bound)
        return differences is not None and all(bool(each >= 0) for each in differences)


def trials(inventory: Inventory, definitions: Lookup, complete: Completion) -> Iterator[Trial]:
    """Yields random points, simple ones first. In each stage a parameter is non-zero with growing
    probability.

    The last points are simple again, on the other side of their circles.
    """
    random = Random(0)
    for entries, count in STAGES:
        ring = RationalRing(entries)
        for i in range(count):
            density = 0.3 + 0.7 * i / count
            point = sample(inventory, ring, random, partial(_is_drawn, random, density))
            yield trial_at(complete(point), definitions)
    entries, count = STAGES[0]
    ring = RationalRing(entries)
    for _ in range(count):
        point = sample(inventory, ring, random, lambda _: random.random() < 0.8)
        yield trial_at(complete(_mirrored(point, random)), definitions)


def _mirrored(point: dict[Parameter, Fraction], random: Random) -> dict[Parameter, Fraction]:
    """Returns the point with the first coordinate negated on some spheres: the projection never gives -1, cos
    π."""
    turned = {p for p in point if p.part in SPHERES and p.component == 0 and random.random() < 0.5}
    return {p: -value if p in turned else value for p, value in point.items()}


def trial_at(point: dict[Parameter, Any], definitions: Lookup, ring: Any = None) -> Trial:
    return Trial(point, JetEngine(PointSource(ring or RationalRing(), point), definitions))


def first_trial(
    inventory: Inventory,
    definitions: Lookup,
    accept: Callable[[Trial], bool],
    complete: Completion,
    positive_nowhere: Term | None = None,
) -> Trial | None:
    """Returns the first accepted point, simplified as long as it stays accepted; None if there is none.

    positive_nowhere: a scalar that is > 0 at none of the accepted points, which rules out most points
    quickly.
    """
    candidates = trials(inventory, definitions, complete)
    if positive_nowhere is not None:
        candidates = _where_not_positive(list(candidates), positive_nowhere, definitions)
    for trial in candidates:
        if accepted(trial, accept):
            return _simplified(trial, definitions, accept, complete)
    return None


def _where_not_positive(candidates: list[Trial], term: Term, definitions: Lookup) -> Iterator[Trial]:
    """Yields the trials at which the term is not clearly > 0, evaluated in doubles at all points at once."""
    lanes = {
        parameter: Lanes(np.array([trial.point[parameter] for trial in candidates], dtype=float))
        for parameter in candidates[0].point
    }
    try:
        found: Any = trial_at(lanes, definitions, LaneRing(len(candidates), 1)).components(term)
    except NotExact:
        found = None
    if found is None:
        return iter(candidates)
    positive = np.broadcast_to(found[0].values > _CLEARLY, len(candidates))
    return compress(candidates, ~positive)


def accepted(trial: Trial, accept: Callable[[Trial], bool]) -> bool:
    try:
        return accept(trial)
    except NotExact:  # a norm that is not rational at this point
        return False


def _simplified(
    trial: Trial, definitions: Lookup, accept: Callable[[Trial], bool], complete: Completion
) -> Trial:
    """Returns the trial with entries set to 0 or made positive, highest derivatives first, while it stays
    accepted."""
    for parameter in sorted(trial.point, key=lambda p: -p.order):
        if parameter.part in SPHERES:
            continue
        for simpler in (Fraction(0), abs(trial.point[parameter])):
            if simpler == trial.point[parameter]:
                break
            candidate = trial_at(complete({**trial.point, parameter: simpler}), definitions)
            if accepted(candidate, accept):
                trial = candidate
                break
    return trial


def with_zeros(trial: Trial, definitions: Lookup, accept: Callable[[Trial], bool], ring: Any) -> Trial:
    """Returns the trial with entries set to 0, highest derivatives first, while it stays accepted."""
    for parameter in sorted(trial.point, key=lambda p: -p.order):
        if parameter.part not in SPHERES and trial.point[parameter] != 0:
            candidate = trial_at({**trial.point, parameter: Fraction(0)}, definitions, ring)
            trial = candidate if accepted(candidate, accept) else trial
    return trial


def counterexample(
    trial: Trial, relation: Relation, inventory: Inventory, turned: Collection[Symbol]
) -> Counterexample:
    """Returns the point as values of the symbols and their derivatives, with the values of the two sides.

    An angle in `turned` is given by its cosine and sine, other angles by their value; that is 0 if both
    occur.
    """
    values: dict[str, _Value] = {}
    behind: list[str] = []
    spoken_of = list(_symbols(relation.left, relation.right))
    for primitive, order in inventory.orders.items():
        symbol = number_behind(primitive)
        if symbol.declaration.of or symbol.declaration.clock:
            values |= _of_function(trial, symbol, order)
            continue
        for k in range(order + 1):
            if k and symbol.declaration.constant:
                break
            if not k and symbol in turned:
                if symbol.type.dual:  # cosine and sine alone give its real part
                    dual_part = apply("du", symbol)
                    values[to_latex(dual_part)] = _value(trial, dual_part)
                continue
            term = derivative(symbol, k) if k else symbol
            values[to_latex(term)] = _value(trial, term)
            behind += [] if symbol in spoken_of else [to_latex(term)]
    for angle in turned:
        name = to_latex(angle)
        for function, number in zip((r"\cos", r"\sin"), trial.engine.circle(angle), strict=True):
            values[f"{function} {name}"] = _Value((str(number),), SCALAR)
    defined = _defined(trial, relation, inventory)
    return Counterexample(
        {name: value.entries for name, value in values.items()},
        _value(trial, relation.left).entries,
        _value(trial, relation.right).entries,
        {name: value.entries for name, value in defined.items()},
        tuple(behind),
        {name: str(value.type) for name, value in (*values.items(), *defined.items())},
        str(_wider(relation.left.type, relation.right.type)),
    )


def _is_drawn(random: Random, density: float, _: Parameter) -> bool:
    return random.random() < density


class _Value(NamedTuple):
    entries: tuple[str, ...]
    type: Type


def _value(trial: Trial, term: Term) -> _Value:
    return _Value(_strings(trial.components(term)), term.type)


def _wider(one: Type, other: Type) -> Type:
    """Returns the type of both sides, dual if one of them is dual."""
    return one.with_dual(one.dual or other.dual)


def _defined(trial: Trial, relation: Relation, inventory: Inventory) -> dict[str, _Value]:
    """Returns the values of the defined symbols of the formula at the point."""
    found: dict[str, _Value] = {}
    valued = {number_behind(primitive) for primitive in inventory.orders}
    for term in _named(relation.left, relation.right):
        symbol = term.body if isinstance(term, Derivative) else term
        if symbol not in valued and term.type.kind in ("scalar", "vector", "tensor"):
            with suppress(NotExact, KeyError):  # the point has no values for the symbols of the definition
                found[to_latex(term)] = _value(trial, term)
    return found


def _named(*terms: Term) -> Iterator[Symbol | Derivative]:
    """Yields the symbols, and the derivatives of symbols, that occur in the terms."""
    for term in terms:
        if isinstance(term, Symbol) or (isinstance(term, Derivative) and isinstance(term.body, Symbol)):
            yield term
        else:
            yield from _named(*term.children)


def _symbols(*terms: Term) -> Iterator[Symbol]:
    for term in terms:
        if isinstance(term, Symbol):
            yield term
        yield from _symbols(*term.children)


def _of_function(trial: Trial, symbol: Symbol, order: int) -> dict[str, _Value]:
    """Returns a function's value and its non-zero partial derivatives; for the time its value."""
    name = to_latex(symbol)
    values = {name: _value(trial, symbol)}
    size = symbol.type.rows * symbol.type.columns
    arguments = [
        (to_latex(a), f"{to_latex(a)}_{{{i + 1}}}")[a.type.rows > 1]
        for a in symbol.declaration.of
        for i in range(a.type.rows)
    ]
    for degree in range(1, order + 1 if symbol.declaration.of else 1):
        for number, places in enumerate(indices(len(arguments), degree)):
            slopes = [
                trial.point[Parameter(symbol, f"slope{degree}", 0, number * size + i)] for i in range(size)
            ]
            if any(slopes):
                above = "\\partial" if degree == 1 else f"\\partial^{{{degree}}}"
                below = " ".join(f"\\partial {arguments[place]}" for place in places)
                values[f"\\frac{{{above} {name}}}{{{below}}}"] = _Value(_strings(slopes), symbol.type)
    return values


def _strings(components: list[Any] | None) -> tuple[str, ...]:
    return ("undefined",) if components is None else tuple(map(_text, components))


def _text(number: Any) -> str:
    """Returns a fraction exactly, a ball by the first digits of its midpoint."""
    return str(number) if isinstance(number, Fraction | int) else format(float(number), ".6g")
