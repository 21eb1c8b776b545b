"""Neighbourhood search of a false statement: coefficients, one edit, one missing addend, two edits.

Candidates come cheapest first, and only those whose residual vanishes at random points modulo the prime; the
judge decides. Two edits are not tried in all pairs: if they change different addends, their effects on the
residual add up, so that the partner of an edit is looked up by the contribution that it must make.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain

from workbench.core.terms import Apply, Conjunction, IllFormed, Relation, Statement, Term
from workbench.engines.jet.rings import PRIME
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.addend_products import Supply
from workbench.repair.terms.changes import Candidate, Change, rescaled
from workbench.repair.terms.coefficients import Scaling, Vector, rational, scaled, scalings
from workbench.repair.terms.matrix_entries import entrywise, wrong_places
from workbench.repair.terms.missing_addend import MissingAddends
from workbench.repair.terms.scalar_factors import other_factors
from workbench.repair.terms.subterm_positions import Place, node_at, places, replaced, subterm
from workbench.repair.terms.term_arithmetic import times, with_addend
from workbench.repair.terms.term_edits import KINDS, Edit, Refused, edits, without

#: The most possible addends of a side that are tried together with another edit.
MOST_PAIRED = 300


@dataclass
class Neighbour:
    """A one-position edit.

    Attributes:
        delta: Its effect on the residual.
        scalable: Whether the effect is proportional to the change.
    """

    edit: Edit
    delta: Vector
    scalable: bool = False


@dataclass
class Neighbourhood:
    """The candidates near a statement.

    Attributes:
        screen: The first test.
        second: Further tests at other points and values of the integers.
        replacements: Terms that may replace a symbol, likely ones.
        farther: The less likely ones.
        is_one_of_many: Whether the statement is one of several readings. Missing addends are then tried only
            after likelier misprints of all readings.
        tick: Called for each candidate; may raise to end the search.
    """

    statement: Statement
    screen: Screen
    second: Sequence[Screen]
    replacements: Sequence[Term] = ()
    farther: Sequence[Term] = ()
    is_one_of_many: bool = False
    tick: Callable[[], None] = lambda: None
    neighbours: list[Neighbour] = field(default_factory=list)

    def stages(self) -> Iterator[Iterator[Candidate]]:
        """Yields the stages, likely ones first.

        The stages are one change, several coefficients, rarer single changes, two changes in different
        addends, and two in one addend.
        """
        kept = self.screen.keep(self.statement)
        self._point = self.screen.points[-1]
        residual = None if kept is None else self._point.residual(self.statement)
        if residual is None:
            yield self._without_residual()
            return
        self._scalings = list(self._find_scalings())
        supply = Supply(self.statement, self.replacements, self._components)
        self._missing = MissingAddends(self.statement, self.screen, supply, self.tick)
        missing = self._with_addends(chain(self._missing.outer(), self._missing.inner()))
        inside = set(self._places_of_entries())
        yield chain(self._scaled(1), self._singles(residual, apart=inside), self._of_factors())
        yield self._of_entries()
        yield self._singles(residual, within=inside) if inside else iter(())
        yield iter(()) if self.is_one_of_many else missing
        yield self._scaled(2)
        yield chain(missing, self._singles(residual, self.farther))
        yield chain(self._pairs(residual), self._with_two_addends())
        yield self._nested_pairs()

    def _passes(self, statement: Statement) -> bool:
        self.tick()
        return all(screen.vanishes(statement) for screen in (self.screen, *self.second))

    def _components(self, product: Term) -> Vector | None:
        self.tick()
        return self._point.components(product)

    def _without_residual(self) -> Iterator[Candidate]:
        """Yields unscreened one-position edits of a statement that is no equation."""
        for edit in sorted(edits(self.statement, self.replacements), key=cost):
            if isinstance(edit, Edit):
                yield candidate_of(edit)

    def _find_scalings(self) -> Iterator[tuple[Place, Relation, Scaling]]:
        """Yields the scalings, with the position of their equation in the statement."""
        match self.statement:
            case Relation():
                yield from (((), self.statement, s) for s in scalings(self.statement, self.screen))
            case Conjunction(parts=parts):
                for number, part in enumerate(parts):
                    if isinstance(part, Relation) and not self.screen.vanishes(part):
                        yield from (((number,), part, s) for s in scalings(part, self.screen))

    def _scaled(self, changes: int) -> Iterator[Candidate]:
        """Yields scaled candidates. changes: 1, or 2 for more than one."""
        for under, relation, scaling in self._scalings:
            if (len(scaling.factors) > 1) != (changes > 1):
                continue
            made = scaled(relation, scaling)
            if made is None:
                continue
            changed: Statement = made
            if under:
                (side,) = {place[0] for place, _ in scaling.factors}
                if side == 0 and under != (0,):
                    continue  # the right side of the previous part
                changed = replaced(self.statement, (*under, side), subterm(made, (side,)))
            if self._passes(changed):
                said = tuple(rescaled(relation, p, f) for p, f in scaling.factors)
                kinds = [KINDS.index(change.kind) for change in said]
                yield Candidate(changed, said, None, (max(kinds), -scaling.factors[0][0][0]))

    def _of_entries(self) -> Iterator[Candidate]:
        for under, relation in self._false_equations():
            for found in entrywise(relation, self.screen, self.replacements, self.tick):
                yield from self._put_under(found, under)

    def _of_factors(self) -> Iterator[Candidate]:
        for under, relation in self._false_equations():
            for found in other_factors(relation, self.screen, self.replacements):
                yield from self._put_under(found, under)

    def _places_of_entries(self) -> Iterator[Place]:
        """Yields the entries of matrices in which no single change corrects the equation."""
        for under, relation in self._false_equations():
            yield from ((*under, *place) for place in wrong_places(relation, self.screen))

    def _put_under(self, found: Candidate, under: Place) -> Iterator[Candidate]:
        """Yields the candidate for one equation as a candidate for the whole statement."""
        made: Statement = found.statement
        if under and isinstance(made, Relation):
            made = replaced(self.statement, (*under, 1), made.right)
            if isinstance(found.statement, Relation) and node_at(made, under) != found.statement:
                return  # the left side is the right side of the previous part
        if self._passes(made):
            yield replace(found, statement=made)

    def _false_equations(self) -> Iterator[tuple[Place, Relation]]:
        """Yields the equations of the statement that do not hold at the points, with their positions."""
        match self.statement:
            case Relation(operator="="):
                yield (), self.statement
            case Conjunction(parts=parts):
                for number, part in enumerate(parts):
                    if isinstance(part, Relation) and not self.screen.vanishes(part):
                        yield (number,), part

    def _singles(
        self,
        residual: Vector,
        replacements: Sequence[Term] = (),
        apart: Collection[Place] = (),
        within: Collection[Place] = (),
    ) -> Iterator[Candidate]:
        """Yields candidates with one edit.

        replacements: if given, only symbols are changed, to one of these.
        apart: positions in which nothing is changed.
        within: the only positions in which something is changed.
        """
        found = edits(self.statement, replacements or self.replacements)
        for edit in sorted(found, key=cost):
            if isinstance(edit, Refused) or (replacements and edit.kind != "symbol"):
                continue
            if (apart and _lies_in(edit.place, apart)) or (within and not _lies_in(edit.place, within)):
                continue
            self.tick()
            changed = self._point.residual(edit.statement)
            if changed is None and self._passes(edit.statement):
                yield candidate_of(edit)  # a root has no value at this point
            if changed is None or len(changed) != len(residual):
                continue
            delta = tuple((x - y) % PRIME for x, y in zip(changed, residual, strict=True))
            is_factor = edit.kind == "coefficient" and edit.new == _twice(edit.old)
            self.neighbours.append(Neighbour(edit, delta, is_factor))
            if not any(changed) and self._passes(edit.statement):
                yield candidate_of(edit)

    def _with_addends(self, found: Iterator[Edit]) -> Iterator[Candidate]:
        for edit in found:
            if self._passes(edit.statement):
                yield candidate_of(edit)

    def _with_two_addends(self) -> Iterator[Candidate]:
        for first, second in self._missing.pairs():
            if self._passes(second.statement):
                changes = (Change(first.kind, first.description), Change(second.kind, second.description))
                yield Candidate(second.statement, changes, None, cost(second))

    def _pairs(self, residual: Vector) -> Iterator[Candidate]:
        rows = len(residual)
        for edit, effect in self._missing.effects(MOST_PAIRED):
            self.neighbours.append(Neighbour(edit, effect[-rows:], scalable=True))
        exact: dict[Vector, list[Neighbour]] = {}
        directions: dict[Vector, list[Neighbour]] = {}
        for neighbour in self.neighbours:
            if not any(neighbour.delta):
                continue
            if neighbour.edit.kind != "addend added":
                exact.setdefault(neighbour.delta, []).append(neighbour)
            if neighbour.scalable:
                directions.setdefault(_direction(neighbour.delta), []).append(neighbour)
        for first in self.neighbours:
            if first.edit.kind == "addend added" or not any(first.delta):
                continue
            self.tick()
            left = tuple((r + d) % PRIME for r, d in zip(residual, first.delta, strict=True))
            for other in exact.get(tuple(-x % PRIME for x in left), ()):
                if other is not first:
                    yield from self._built(first.edit.statement, (first,), other, Fraction(1))
            if any(left):
                for other in directions.get(_direction(left), ()):
                    factor = _ratio(left, other.delta)
                    if factor is not None and other is not first:
                        yield from self._built(first.edit.statement, (first,), other, factor)

    def _nested_pairs(self) -> Iterator[Candidate]:
        """Yields candidates whose second edit is in the addend that the first edit changed."""
        firsts = [n.edit for n in self.neighbours if n.edit.kind not in ("addend added", "addend dropped")]
        for first in firsts:
            for second in edits(first.statement, self.replacements, within=self._addend_of(first.place)):
                if isinstance(second, Refused):
                    continue
                if self._passes(second.statement):
                    changes = (Change(first.kind, first.description), Change(second.kind, second.description))
                    unlikely = (max(cost(first)[0], cost(second)[0]),)
                    yield Candidate(second.statement, changes, None, unlikely)

    def _addend_of(self, place: Place) -> Place:
        """Returns the position of the outermost addend around a position."""
        for length in range(1, len(place)):
            term = node_at(self.statement, place[:length])
            if isinstance(term, Apply) and term.head == "add":
                return place[: length + 1]
        return place[:1]

    def _built(
        self, statement: Statement, before: tuple[Neighbour, ...], last: Neighbour, factor: Fraction
    ) -> Iterator[Candidate]:
        """Yields the statement with the last edit applied, `factor` times as large.

        Its position is found by identity, because the previous edit may have shifted it.
        """
        edit = last.edit
        place = next((p for p, term in places(statement) if term is edit.old), None)
        if place is None:
            return
        changed: Statement | None
        try:
            if not last.scalable or (factor == 1 and edit.kind != "addend added"):
                changed, change = replaced(statement, place, edit.new), Change(edit.kind, edit.description)
            elif edit.kind == "addend added":
                addend = times(factor, edit.new.children[-1])
                edit = _with_addend(statement, place, addend)
                changed, change = edit.statement, Change(edit.kind, edit.description)
            else:
                changed = _scaled_at(statement, place, 1 + factor)
                change = rescaled(statement, place, 1 + factor)
        except IllFormed:
            return
        if changed is not None and self._passes(changed):
            changes = tuple(Change(n.edit.kind, n.edit.description) for n in before)
            unlikely = (max(cost(n.edit)[0] for n in (*before, last)),)
            yield Candidate(changed, (*changes, change), None, unlikely)


def _lies_in(place: Place, others: Collection[Place]) -> bool:
    return any(place[:length] in others for length in range(1, len(place) + 1))


def cost(edit: Edit | Refused) -> tuple[int, int]:
    """Returns the sort key: likely misprints first, and those on the right side before those on the left."""
    return KINDS.index(edit.kind), -edit.place[0]


def candidate_of(edit: Edit) -> Candidate:
    return Candidate(edit.statement, (Change(edit.kind, edit.description),), None, cost(edit))


def _twice(term: Term) -> Term | None:
    try:
        return times(2, term)
    except IllFormed:
        return None


def _with_addend(statement: Statement, place: Place, addend: Term) -> Edit:
    old = subterm(statement, place)
    new = with_addend(old, addend)
    said = ("add {}", addend)
    return Edit("addend added", place, said, old, new, replaced(statement, place, new))


def _scaled_at(statement: Statement, place: Place, factor: Fraction) -> Statement | None:
    if factor == 0:
        return without(statement, place)
    return replaced(statement, place, times(factor, subterm(statement, place)))


def _direction(vector: Vector) -> Vector:
    leading = next(x for x in vector if x)
    inverse = pow(leading, -1, PRIME)
    return tuple(x * inverse % PRIME for x in vector)


def _ratio(residual: Vector, delta: Vector) -> Fraction | None:
    """Returns s with residual + s·delta = 0, if it is a small number."""
    leading = next((i for i, x in enumerate(delta) if x), None)
    if leading is None or not residual[leading]:
        return None
    s = -residual[leading] * pow(delta[leading], -1, PRIME) % PRIME
    if any((r + s * d) % PRIME for r, d in zip(residual, delta, strict=True)):
        return None
    return rational(s)
