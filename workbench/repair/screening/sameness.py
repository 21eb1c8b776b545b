"""Equivalence of two true statements.

Two true equations are equivalent if the values of their sides agree up to a common factor, under the
definitions. They are also equivalent if one is the other rearranged: then the differences of their sides are
proportional, with all symbols free or under the definitions. Both are tested at random points modulo a 61-bit
prime. Statements that do not hold by themselves, such as the sides of an equivalence, can only be rearranged.
Chains, equivalences and implications are compared part by part.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from workbench.context.claims import Claim
from workbench.core.terms import (
    Apply,
    Conjunction,
    Equivalence,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
)
from workbench.engines.inventory import Lookup, NoDefinitions, NotExact
from workbench.engines.inventory.inventory import has_gradient
from workbench.engines.jet.rings import PRIME
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.coefficients import Vector, factor_between
from workbench.repair.terms.subterm_positions import places
from workbench.repair.terms.term_arithmetic import number_and_rest


class Sameness:
    """Compares statements under the definitions and assumptions of one claim, for given integers."""

    def __init__(
        self, definitions: Lookup, assume: Sequence[Statement], instances: Sequence[Mapping[str, int]]
    ) -> None:
        self._as_supposed = _screen(definitions, assume, instances, seed=11)
        self._elsewhere = _screen(definitions, assume, instances, seed=911)
        self._defined = self._as_supposed if not assume else _screen(definitions, (), instances, seed=12)
        self._free = _screen(NoDefinitions(), (), instances, seed=13)

    @classmethod
    def under(cls, claim: Claim) -> Sameness:
        """Returns a comparison for forms of the claim, at the last two assignments of its integers."""
        return cls(claim.notation.definitions, claim.supposed, claim.instances[-2:])

    def same(self, one: Statement, other: Statement) -> bool:
        """True if two true statements are equivalent."""
        if one == other:
            return True
        match one, other:
            case Conjunction(), Conjunction():
                pairs = zip(one.parts, other.parts, strict=False)
                return len(one.parts) == len(other.parts) and all(self.same(a, b) for a, b in pairs)
            case Relation(operator="="), Relation(operator="="):
                swapped = (one.left, one.right) == (other.right, other.left)
                return swapped or self._have_same_sides(one, other) or self._rearranged(one, other)
            case Implication(), Implication():
                return self._same_condition(one.left, other.left) and self._same_condition(
                    one.right, other.right
                )
            case Equivalence(), Equivalence():
                straight = self._same_condition(one.left, other.left) and self._same_condition(
                    one.right, other.right
                )
                return straight or (
                    self._same_condition(one.left, other.right)
                    and self._same_condition(one.right, other.left)
                )
        return self._same_condition(one, other)

    def _same_condition(self, one: Statement, other: Statement) -> bool:
        if one == other:
            return True
        match one, other:
            case Conjunction(), Conjunction():
                pairs = zip(one.parts, other.parts, strict=False)
                return len(one.parts) == len(other.parts) and all(
                    self._same_condition(a, b) for a, b in pairs
                )
            case Relation(), Relation():
                return one.operator == other.operator and self._rearranged(one, other)
        return False

    def _have_same_sides(self, one: Relation, other: Relation) -> bool:
        screen = self._as_supposed
        if screen is None:
            return False
        values = [
            screen.components(side, one.left) for side in (one.left, one.right, other.left, other.right)
        ]
        sides = [value for value in values if value is not None]
        if len(sides) < len(values) or not any(sides[0]):
            return False
        if self._is_constant(one.left, sides[0]) and (
            _symbols(one) != _symbols(other) or self._are_numbers(_symbols(one))
        ):
            return False
        factors = {factor_between(sides[0], sides[2]), factor_between(sides[1], sides[3])}
        crossed = {factor_between(sides[0], sides[3]), factor_between(sides[1], sides[2])}
        return any(len(f) == 1 and None not in f for f in (factors, crossed))

    def _is_constant(self, side: Term, components: Vector) -> bool:
        """True if the side has this value at all points, as both sides of R Rᵀ = I have."""
        return self._elsewhere is not None and self._elsewhere.components(side, side) == components

    def _are_numbers(self, symbols: Iterable[Symbol]) -> bool:
        """True if the definitions give the values of the symbols, as those of the units i, j, k."""
        assert self._as_supposed is not None
        for each in symbols:
            found = self._as_supposed.components(each, each)
            if found is None or not self._is_constant(each, found):
                return False
        return True

    def _rearranged(self, one: Relation, other: Relation) -> bool:
        # a free symbol does not depend on the coordinate, so its div and curl would be 0
        is_field = has_gradient([one.left, one.right, other.left, other.right])
        for screen in (None if is_field else self._free, self._defined):
            if screen is not None:
                before, after = (_difference(screen, r, one.left) for r in (one, other))
                if before and after and any(before) and factor_between(before, after) is not None:
                    return True
        numbers, others = _numbers(one), _numbers(other)
        ratios = {others[key] / numbers[key] for key in numbers} if numbers.keys() == others.keys() else ()
        return len(ratios) == 1


def _symbols(statement: Statement) -> frozenset[Symbol]:
    return frozenset(term for _, term in places(statement) if isinstance(term, Symbol))


def _numbers(statement: Relation) -> dict[tuple[Term, ...], Fraction]:
    """Returns the addends of left − right → their coefficients."""
    found: dict[tuple[Term, ...], Fraction] = {}
    for sign, side in ((1, statement.left), (-1, statement.right)):
        for number, rest in _addends(side):
            found[rest] = found.get(rest, 0) + sign * number
    return {rest: number for rest, number in found.items() if number}


def _addends(term: Term) -> Iterator[tuple[Fraction, tuple[Term, ...]]]:
    """Yields each addend as a number and its other factors, with numbers before sums multiplied out."""
    number, rest = number_and_rest(term)
    match rest:
        case (Apply(head="add", arguments=arguments),):
            yield from ((number * inner, own) for argument in arguments for inner, own in _addends(argument))
        case (Zero(),):
            return
        case _:
            yield number, rest


def _screen(
    definitions: Lookup, assume: Sequence[Statement], instances: Sequence[Mapping[str, int]], seed: int
) -> Screen | None:
    try:
        return Screen(definitions, assume, instances, seed)
    except NotExact:
        return None


def _difference(screen: Screen, statement: Relation, shape: Term) -> Vector | None:
    left, right = (screen.components(side, shape) for side in (statement.left, statement.right))
    if left is None or right is None:
        return None
    return tuple((x - y) % PRIME for x, y in zip(left, right, strict=True))
