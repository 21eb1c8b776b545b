"""The neighbourhood of a false statement: other coefficients, one edit, one missing addend, two edits.

Candidates come cheapest first, and only those whose residual vanishes at random points modulo the prime; the
judge has the last word. Two edits are not tried in all pairs: where they change different addends their
effects on the residual add up, so the partner of an edit is looked up by what it must contribute.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain

from workbench.judge.rings import PRIME
from workbench.language.printer import to_latex
from workbench.language.terms import Apply, IllFormed, Relation, Statement, Term
from workbench.repair.addends import missing_addends
from workbench.repair.coefficients import Scaling, Vector, rational, scaled, scalings
from workbench.repair.edits import KINDS, Edit, edits, without
from workbench.repair.places import Place, places, replaced, sides, subterm
from workbench.repair.screen import Screen
from workbench.repair.variants import times, with_addend


@dataclass(frozen=True)
class Change:
    """One edit in words, formulas between dollar signs."""

    kind: str
    description: str


@dataclass(frozen=True)
class Candidate:
    """A statement that may be what was meant, and how it differs from the printed one. latex: as it would
    have been printed; the canonical one if None."""

    statement: Statement
    changes: tuple[Change, ...]
    latex: str | None = None


@dataclass
class Neighbour:
    """A one-place edit, what it does to the residual, and whether it does twice that at twice the change."""

    edit: Edit
    delta: Vector
    scalable: bool = False


@dataclass
class Neighbourhood:
    """`screen` looks first, `second` again at other points and values of the integers. `tick` is called
    for each candidate, and may raise to end the search."""

    statement: Statement
    screen: Screen
    second: Sequence[Screen]
    replacements: Sequence[Term] = ()
    tick: Callable[[], None] = lambda: None
    neighbours: list[Neighbour] = field(default_factory=list)

    def stages(self) -> Iterator[Iterator[Candidate]]:
        """Cheapest first: one coefficient, one edit, one addend, more coefficients, two edits."""
        residual = self.screen.keep(self.statement)
        if residual is None:
            yield self._without_residual()
            return
        self._scalings = self._find_scalings()
        yield chain(self._scaled(1), self._singles(residual))
        yield self._scaled(2)
        yield self._missing(residual)
        yield self._pairs(residual)

    def _passes(self, statement: Statement) -> bool:
        self.tick()
        for screen in (self.screen, *self.second):
            residual = screen.residual(statement)
            if residual is None or any(residual):
                return False
        return True

    def _without_residual(self) -> Iterator[Candidate]:
        """Statements that are no equations: one-place edits, unscreened."""
        for edit in sorted(edits(self.statement, self.replacements), key=cost):
            if edit.statement is not None:
                yield Candidate(edit.statement, (Change(edit.kind, edit.description),))

    # coefficients

    def _find_scalings(self) -> list[tuple[Relation, Scaling]]:
        if not isinstance(self.statement, Relation):
            return []
        return [(self.statement, s) for s in scalings(self.statement, self.screen)]

    def _scaled(self, changes: int) -> Iterator[Candidate]:
        """changes: 1, or 2 for more than one."""
        for relation, scaling in self._scalings:
            if (len(scaling.factors) > 1) != (changes > 1):
                continue
            changed = scaled(relation, scaling)
            if changed is not None and self._passes(changed):
                yield Candidate(changed, tuple(_rescaled(relation, p, f) for p, f in scaling.factors))

    # one edit

    def _singles(self, residual: Vector) -> Iterator[Candidate]:
        for edit in sorted(edits(self.statement, self.replacements), key=cost):
            if edit.statement is None:
                continue
            self.tick()
            changed = self.screen.residual(edit.statement)
            if changed is None or len(changed) != len(residual):
                continue
            delta = tuple((x - y) % PRIME for x, y in zip(changed, residual, strict=True))
            is_factor = edit.kind == "coefficient" and edit.new == _twice(edit.old)
            self.neighbours.append(Neighbour(edit, delta, is_factor))
            if not any(changed) and self._passes(edit.statement):
                yield Candidate(edit.statement, (Change(edit.kind, edit.description),))

    def _missing(self, residual: Vector) -> Iterator[Candidate]:
        """An addend of the right type and weight, with the coefficient that it must have."""
        lists: dict[tuple, list[Term]] = {}
        for place, term in _sums(self.statement):
            key = (term.type.kind, term.weight)
            if key not in lists:
                lists[key] = missing_addends(self.statement, *key, self.replacements)
            for addend in lists[key]:
                try:
                    edit = _with_addend(self.statement, place, addend)
                except IllFormed:
                    continue
                self.tick()
                changed = self.screen.residual(edit.statement)
                if changed is None or len(changed) != len(residual):
                    continue
                delta = tuple((x - y) % PRIME for x, y in zip(changed, residual, strict=True))
                neighbour = Neighbour(edit, delta, scalable=True)
                self.neighbours.append(neighbour)
                factor = _ratio(residual, delta)
                if factor is not None:
                    yield from self._built(self.statement, (), neighbour, factor)

    # two edits

    def _pairs(self, residual: Vector) -> Iterator[Candidate]:
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
            left = tuple((r + d) % PRIME for r, d in zip(residual, first.delta, strict=True))
            for other in exact.get(tuple(-x % PRIME for x in left), ()):
                if other is not first:
                    yield from self._built(first.edit.statement, (first,), other, Fraction(1))
            if any(left):
                for other in directions.get(_direction(left), ()):
                    factor = _ratio(left, other.delta)
                    if factor is not None and other is not first:
                        yield from self._built(first.edit.statement, (first,), other, factor)
        yield from self._nested_pairs()

    def _nested_pairs(self) -> Iterator[Candidate]:
        """The second edit within the addend that the first one changed, or of what it made."""
        firsts = [n.edit for n in self.neighbours if n.edit.kind not in ("addend added", "addend dropped")]
        for first in firsts:
            for second in edits(first.statement, self.replacements, within=self._addend_of(first.place)):
                if second.statement is None:
                    continue
                if self._passes(second.statement):
                    changes = (Change(first.kind, first.description), Change(second.kind, second.description))
                    yield Candidate(second.statement, changes)

    def _addend_of(self, place: Place) -> Place:
        """The place of the outermost addend around a place."""
        for length in range(1, len(place)):
            term = subterm(self.statement, place[:length])
            if isinstance(term, Apply) and term.head == "add":
                return place[: length + 1]
        return place[:1]

    def _built(
        self, statement: Statement, before: tuple[Neighbour, ...], last: Neighbour, factor: Fraction
    ) -> Iterator[Candidate]:
        """The statement with the last edit put in, `factor` times as large; its place is found by identity:
        the edit before may have moved it."""
        edit = last.edit
        place = next((p for p, term in places(statement) if term is edit.old), None)
        if place is None:
            return
        try:
            if not last.scalable or (factor == 1 and edit.kind != "addend added"):
                changed, change = replaced(statement, place, edit.new), Change(edit.kind, edit.description)
            elif edit.kind == "addend added":
                addend = times(factor, edit.new.arguments[-1])
                edit = _with_addend(statement, place, addend)
                changed, change = edit.statement, Change(edit.kind, edit.description)
            else:
                changed = _scaled_at(statement, place, 1 + factor)
                change = _rescaled(statement, place, 1 + factor)
        except IllFormed:
            return
        if changed is not None and self._passes(changed):
            changes = tuple(Change(n.edit.kind, n.edit.description) for n in before)
            yield Candidate(changed, (*changes, change))


def cost(edit: Edit) -> tuple[int, int]:
    """Likely misprints first; of equally likely ones that on the right side."""
    return KINDS.index(edit.kind), -edit.place[0]


def _twice(term: Term) -> Term | None:
    try:
        return times(2, term)
    except IllFormed:
        return None


def _sums(statement: Statement) -> Iterator[tuple[Place, Term]]:
    """Sums, and sides that are a single addend."""
    whole = {place for place, _ in sides(statement)}
    for place, term in places(statement):
        if (isinstance(term, Apply) and term.head == "add") or place in whole:
            yield place, term


def _with_addend(statement: Statement, place: Place, addend: Term) -> Edit:
    old = subterm(statement, place)
    new = with_addend(old, addend)
    said = ("the addend {} is missing", addend)
    return Edit("addend added", place, said, old, new, replaced(statement, place, new))


def _scaled_at(statement: Statement, place: Place, factor: Fraction) -> Statement | None:
    if factor == 0:
        return without(statement, place)
    return replaced(statement, place, times(factor, subterm(statement, place)))


def _rescaled(statement: Statement, place: Place, factor: Fraction) -> Change:
    """What a changed coefficient is called."""
    term = subterm(statement, place)
    bare = term.arguments[0] if isinstance(term, Apply) and term.head == "neg" else term
    shown = f"${to_latex(bare)}$"
    if factor == 0:
        return Change("addend dropped", f"the addend {shown} does not belong there")
    if factor == -1:
        return Change("sign", f"the sign of {shown} is wrong")
    sign = " and the sign is wrong" if factor < 0 else ""
    size = abs(factor)
    if size.numerator == 1:
        return Change("coefficient", f"{shown} has the factor {size.denominator} too much{sign}")
    return Change("coefficient", f"the factor {size} of {shown} is missing{sign}")


def _direction(vector: Vector) -> Vector:
    leading = next(x for x in vector if x)
    inverse = pow(leading, -1, PRIME)
    return tuple(x * inverse % PRIME for x in vector)


def _ratio(residual: Vector, delta: Vector) -> Fraction | None:
    """s with residual + s·delta = 0, if it is a small number."""
    leading = next((i for i, x in enumerate(delta) if x), None)
    if leading is None or not residual[leading]:
        return None
    s = -residual[leading] * pow(delta[leading], -1, PRIME) % PRIME
    if any((r + s * d) % PRIME for r, d in zip(residual, delta, strict=True)):
        return None
    return rational(s)
