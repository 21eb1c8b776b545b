"""Search for a missing addend: the product, position and coefficient that make an equation hold.

The effect of an addend on the residual is linear in its components at each position where the statement is
linear. The components of a probe are therefore inserted one by one, and each product is only multiplied by
the response: x solves the equation if residual + c·(response · x) = 0 for one small rational c.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from flint import nmod

from workbench.core.construct import apply, power, symbol, time_operator
from workbench.core.names import Name
from workbench.core.operations import LINEAR
from workbench.core.terms import (
    Apply,
    Block,
    Derivative,
    Head,
    Identity,
    IllFormed,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.core.types import KINDS, Declaration, Type, Weight
from workbench.engines.jet.components import Value, array_shape
from workbench.engines.jet.rings import PRIME
from workbench.repair.screening.screen import Screen, ScreenPoint
from workbench.repair.terms.addend_products import Supply
from workbench.repair.terms.coefficients import Vector, combination, factor_between, rational
from workbench.repair.terms.subterm_positions import Place, node_at, places, replaced, sides, subterm
from workbench.repair.terms.term_arithmetic import number_and_rest, times, with_addend
from workbench.repair.terms.term_edits import Edit

#: The most solutions for one position.
_MOST = 3

_KINDS = frozenset(("scalar", "vector", "tensor", "operator", "matrix"))

#: (function from a product to an addend, required kind and weight of the product).
_Form = tuple[Callable[[Term], Term], str, Weight]


@dataclass(frozen=True)
class _Response:
    """The effect of the components of a probe on the residual at one point.

    Attributes:
        rows: For each component of the residual, the non-zero coefficients.
    """

    rows: tuple[tuple[tuple[int, int], ...], ...]
    residual: Vector

    def ratio(self, components: Vector) -> Fraction | None:
        """Returns c with residual + c·(response · components) = 0, if it is a small number other than 0."""
        factor = None
        for row, r in zip(self.rows, self.residual, strict=True):
            y = sum(a * components[i] for i, a in row if i < len(components)) % PRIME
            if factor is None:
                if not y and not r:
                    continue
                if not y or not r:
                    return None
                factor = -r * pow(y, -1, PRIME) % PRIME
            elif (r + factor * y) % PRIME:
                return None
        return None if factor is None else rational(factor)


class MissingAddends:
    """Searches one addend at all positions of a statement. tick: called for each product."""

    def __init__(
        self, statement: Statement, screen: Screen, supply: Supply, tick: Callable[[], None] = lambda: None
    ) -> None:
        self.statement, self.screen, self.supply, self.tick = statement, screen, supply, tick
        self._known: list[dict[int, Vector | None]] = [{} for _ in screen.points]
        self._residuals = [point.residual(statement) for point in screen.points]
        operators = [t for _, t in places(statement) if t.type.kind == "operator"]
        self._degree = max((1, *map(_degree, operators))) if operators else 0
        self._is_dual = any(side.type.dual for _, side in sides(statement))
        self._heads = {t.head for _, t in places(statement) if isinstance(t, Apply)}

    def outer(self) -> Iterator[Edit]:
        """Yields addends of a side; right sides come first, because an addend of the left side is
        equivalent."""
        for place, term in sorted(sides(self.statement), key=lambda entry: -entry[0][-1]):
            if not isinstance(term, Zero):
                found = list(self._at(place, term))
                yield from found
                if found:
                    return

    def inner(self) -> Iterator[Edit]:
        """Yields addends inside brackets, or of terms that may have been in brackets."""
        whole = {place for place, _ in sides(self.statement)}
        for place, term in places(self.statement):
            if place not in whole and not isinstance(term, Zero) and is_linear(self.statement, place):
                parent = node_at(self.statement, place[:-1])
                if not isinstance(parent, Apply) or parent.head not in ("add", "neg"):
                    yield from self._at(place, term)

    def pairs(self) -> Iterator[tuple[Edit, Edit]]:
        """Yields two addends of one side; the second edit applies to the result of the first.

        With residual r they satisfy r + a·x + b·y = 0, so x and y have the same direction modulo r.
        """
        last = len(self.screen.points) - 1
        for place, term in sorted(sides(self.statement), key=lambda entry: -entry[0][-1]):
            residual = self._residuals[last]
            if isinstance(term, Zero) or residual is None or not any(residual):
                continue
            found: dict[Vector, list[tuple[_Form, Term, Vector]]] = {}
            for form in self._forms(term):
                make, kind, weight = form
                responses = self._responses(place, term, make, kind)
                for product in self.supply.of(kind, weight) if responses else ():
                    self.tick()
                    y = self._effect(responses[last:], product, last)
                    direction = None if y is None else _direction_beside(y, residual)
                    if y is None or direction is None:
                        continue
                    for other, known, x in found.get(direction, ()):
                        yield from self._both(place, residual, (other, known, x), (form, product, y))
                    found.setdefault(direction, []).append((form, product, y))

    def _both(
        self,
        place: Place,
        residual: Vector,
        one: tuple[_Form, Term, Vector],
        two: tuple[_Form, Term, Vector],
    ) -> Iterator[tuple[Edit, Edit]]:
        goal = tuple(-x % PRIME for x in residual)
        factors = combination((one[2], two[2]), goal)
        if factors is None or 0 in factors:
            return
        first = self._edit(place, one[0][0], one[1], factors[0])
        second = self._edit(place, two[0][0], two[1], factors[1])
        if first is None or second is None:
            return
        new = with_addend(first.new, second.new.children[-1])
        changed = replaced(self.statement, place, new)
        yield first, Edit(second.kind, place, second.said, first.new, new, changed)

    def effects(self, most: int) -> Iterator[tuple[Edit, Vector]]:
        """Yields short addends of the sides, with their effect on the residual at all points."""
        for place, term in sides(self.statement):
            if isinstance(term, Zero):
                continue
            for make, kind, weight in self._forms(term)[:2]:
                responses = self._responses(place, term, make, kind)
                for product in self.supply.of(kind, weight)[:most] if responses else ():
                    self.tick()
                    effect = self._effect(responses, product)
                    edit = self._edit(place, make, product, Fraction(1))
                    if effect is not None and edit is not None:
                        yield edit, effect

    def _effect(self, responses: Sequence[_Response], product: Term, start: int = 0) -> Vector | None:
        effect: list[int] = []
        for number, response in enumerate(responses, start):
            components = self._components(number, product)
            if components is None:
                return None
            for row in response.rows:
                effect.append(sum(a * components[i] for i, a in row if i < len(components)) % PRIME)
        return tuple(effect)

    def _at(self, place: Place, term: Term) -> Iterator[Edit]:
        count = 0
        for make, kind, weight in self._forms(term):
            responses = self._responses(place, term, make, kind)
            for product in self.supply.of(kind, weight) if responses else ():
                self.tick()
                factor = self._factor(responses, product)
                edit = None if factor is None else self._edit(place, make, product, factor)
                if edit is not None:
                    yield edit
                    count += 1
                    if count == _MOST:
                        return

    def _factor(self, responses: Sequence[_Response], product: Term) -> Fraction | None:
        factor = None
        for number, response in enumerate(responses):
            components = self._components(number, product)
            ratio = None if components is None else response.ratio(components)
            if ratio is None or (factor is not None and ratio != factor):
                return None
            factor = ratio
        return factor

    def _forms(self, term: Term) -> list[_Form]:
        """Returns the forms of an addend: a product as it is; times D, D², …; under a tilde; symmetrized; and
        transposed or antisymmetric if the statement has such terms."""
        kind, weight = term.type.kind, term.weight
        if kind not in _KINDS:
            return []
        forms: list[_Form] = [(_itself, "tensor" if kind == "operator" else kind, weight)]
        if kind in ("operator", "tensor") and weight is not None:
            for power_ in range(1, self._degree + 1):
                forms.append((_before_operator(power_), "tensor", weight - power_))
        if kind == "tensor":
            forms.append((_under("symmetric"), "tensor", weight))
            for head in ("antisymmetric", "transpose"):
                if head in self._heads:
                    forms.append((_under(head), "tensor", weight))
            forms.append((_under("skew"), "vector", weight))
        return forms

    def _responses(
        self, place: Place, term: Term, make: Callable[[Term], Term], kind: str
    ) -> list[_Response]:
        """Returns the responses at all points; an empty list if one is unknown."""
        type_ = (term.type if kind == term.type.kind else KINDS[kind]).with_dual(self._is_dual)
        probe = symbol(Declaration(Name("probe"), type_, None))
        try:
            changed = replaced(self.statement, place, with_addend(term, make(probe)))
        except IllFormed:
            return []
        responses = []
        for point, residual in zip(self.screen.points, self._residuals, strict=True):
            response = None if residual is None else _response(point, changed, probe, residual)
            if response is None:
                return []
            responses.append(response)
        return responses

    def _components(self, number: int, product: Term) -> Vector | None:
        known = self._known[number]
        if id(product) not in known:
            known[id(product)] = self.screen.points[number].components(product)
        return known[id(product)]

    def _edit(
        self, place: Place, make: Callable[[Term], Term], product: Term, factor: Fraction
    ) -> Edit | None:
        """Returns the edit; None if a similar addend exists already, whose coefficient is then wrong."""
        old = subterm(self.statement, place)
        try:
            addend = times(factor, make(product))
            if any(self._is_multiple(addend, other) for other in self._addends_beside(place)):
                return None
            new = with_addend(old, addend)
            changed = replaced(self.statement, place, new)
        except IllFormed:
            return None
        return Edit("addend added", place, ("add {}", addend), old, new, changed)

    def _is_multiple(self, addend: Term, other: Term) -> bool:
        if number_and_rest(addend)[1] == number_and_rest(other)[1]:
            return True
        one, two = (self._components(len(self.screen.points) - 1, term) for term in (addend, other))
        return one is not None and two is not None and factor_between(one, two) is not None

    def _addends_beside(self, place: Place) -> Iterator[Term]:
        """Yields the addends at the position; those of all sides if it is a side itself."""
        at = [place]
        if isinstance(node_at(self.statement, place[:-1]), Relation):
            at = [side for side, _ in sides(self.statement)]
        for side in at:
            term = subterm(self.statement, side)
            yield from term.arguments if isinstance(term, Apply) and term.head == "add" else (term,)


def _response(point: ScreenPoint, changed: Statement, probe: Symbol, residual: Vector) -> _Response | None:
    """Returns the effect of each component of the probe; None if the residual has no value or another
    length."""
    columns = []
    count = int(np.prod(array_shape(probe.type), dtype=int))
    for component in range(count * (2 if probe.type.dual else 1)):
        point.engine.given[probe] = _unit(probe.type, component, count)
        moved = point.residual(changed)
        del point.engine.given[probe]
        if moved is None or len(moved) != len(residual):
            return None
        columns.append([(x - y) % PRIME for x, y in zip(moved, residual, strict=True)])
    rows = tuple(
        tuple((i, column[row]) for i, column in enumerate(columns) if column[row])
        for row in range(len(residual))
    )
    return _Response(rows, residual)


def _unit(type_: Type, component: int, count: int) -> Value:
    parts = []
    for part in range(2 if type_.dual else 1):
        array = np.empty(count, dtype=object)
        for i in range(count):
            array[i] = nmod(int(i + part * count == component), PRIME)
        parts.append([array.reshape(array_shape(type_))])
    return Value(*parts)


def is_linear(statement: Statement, place: Place) -> bool:
    """True if the statement is linear in the term at the position, by the operations around it."""
    for length in range(1, len(place)):
        parent = node_at(statement, place[:length])
        if not isinstance(parent, Term):
            continue
        match parent:
            case Apply(head=head) if head == "add" or head in LINEAR:
                continue
            case Apply(head="div") if place[length] == 0:
                continue
            case Block():
                continue
        return False
    return True


def _direction_beside(y: Vector, r: Vector) -> Vector | None:
    """Returns the direction of y modulo r; None if y is a multiple of r, or 0."""
    pivot = next(i for i, x in enumerate(r) if x)
    c = y[pivot] * pow(r[pivot], -1, PRIME) % PRIME
    rest = [(b - c * a) % PRIME for a, b in zip(r, y, strict=True)]
    leading = next((x for x in rest if x), None)
    if leading is None:
        return None
    inverse = pow(leading, -1, PRIME)
    return tuple(x * inverse % PRIME for x in rest)


def _degree(term: Term) -> int:
    """Returns the highest power of D that is written in the term, plus one."""
    match term:
        case TimeOperator():
            return 1
        case Apply() | Derivative():
            return max(map(_degree, term.children), default=0)
        case Power(base=TimeOperator(), exponent=exponent) if exponent.is_number:
            return int(exponent)
    return 0


def _itself(term: Term) -> Term:
    return term


def _under(head: Head) -> Callable[[Term], Term]:
    return lambda term: apply(head, term)


def _before_operator(exponent: int) -> Callable[[Term], Term]:
    operator = time_operator() if exponent == 1 else power(time_operator(), exponent)
    return lambda term: operator if isinstance(term, Identity) else apply("mul", term, operator)
