"""Tells whether an equation holds, or is one usual misprint away from an equation that holds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import Enum
from itertools import chain
from time import process_time

from workbench.core.terms import Derivative, IllFormed, Power, Relation, Statement, Symbol
from workbench.engines.inventory import Lookup, NotExact
from workbench.repair.screening.screen import Screen
from workbench.repair.screening.vacuous import has_cancelling_addends, is_vacuous, says_less
from workbench.repair.terms.matrix_entries import entrywise
from workbench.repair.terms.scalar_factors import other_factors
from workbench.repair.terms.term_edits import Edit, edits

#: Changes by which the right formula of another quantity may differ, too.
_UNUSUAL = frozenset({"addend dropped", "addend added", "bound", "mark", "tilde"})
#: Random points of a test of changes.
_POINTS = 2
_PROBLEMS = (NotExact, IllFormed, ValueError, RecursionError, ZeroDivisionError)


class Nearness(Enum):
    """What is known of an equation at random points."""

    HOLDS = "it holds"
    NEAR = "it holds after one change"
    FAR = "it does not hold after one change"
    OPEN = "it has no value at random points, or the time is over"


class Points:
    """Random points at which an equation is tested under its definitions and assumptions."""

    def __init__(
        self,
        statement: Statement,
        definitions: Lookup,
        assume: Sequence[Statement] = (),
        instances: Sequence[Mapping[str, int]] = ({},),
        count: int = 1,
    ) -> None:
        some = list(instances[:count]) * (count if len(instances) == 1 else 1)
        self.statement = statement
        self.screen: Screen | None = None
        try:
            self.screen = Screen(definitions, assume, some, seed=5, about=statement)
        except _PROBLEMS:
            return

    def has_value(self) -> bool:
        """True if the equation has a value at the points, whose parts are kept for its changes."""
        try:
            return self.screen is not None and self.screen.keep(self.statement) is not None
        except _PROBLEMS:
            return False

    def vanishes(self, changed: Statement | None = None) -> bool:
        """True if the equation, or a changed one, holds at the points."""
        try:
            return self.screen is not None and self.screen.vanishes(changed or self.statement)
        except _PROBLEMS:
            return False


def nearness(
    statement: Statement,
    definitions: Lookup,
    assume: Sequence[Statement] = (),
    instances: Sequence[Mapping[str, int]] = ({},),
    seconds: float = 1.0,
    left_too: bool = False,
    factors: bool = False,
) -> Nearness:
    """Returns whether an equation holds at random points, or does after one change of its right side.

    left_too: the left side may be changed, too.   factors: an addend may have another factor.
    """
    end = process_time() + seconds
    points = Points(statement, definitions, assume, instances, _POINTS)
    if not isinstance(statement, Relation) or not points.has_value():
        return Nearness.OPEN
    if points.vanishes():
        return Nearness.HOLDS
    for changed in _changed(statement, points, left_too, factors):
        if process_time() > end:
            return Nearness.OPEN
        if points.vanishes(changed):
            return Nearness.NEAR
    return Nearness.FAR


def usual_changes(statement: Relation, left_too: bool = False) -> Iterator[Statement]:
    """Yields the equation after each usual change of its right side, or of both sides.

    It may repeat a left side that is a formula, but not one that is a symbol.
    """
    is_bare = left_too or isinstance(statement.left, Symbol | Derivative | Power)
    for edit in edits(statement):
        if not isinstance(edit, Edit) or edit.kind in _UNUSUAL or not (left_too or edit.place[0] == 1):
            continue
        is_empty = is_vacuous(edit.statement) if is_bare else has_cancelling_addends(edit.statement)
        if not is_empty and not says_less(edit.statement, statement):
            yield edit.statement


def _changed(statement: Relation, points: Points, left_too: bool, factors: bool) -> Iterator[Statement]:
    yield from usual_changes(statement, left_too)
    if points.screen is None:
        return
    with_factors = other_factors(statement, points.screen, ()) if factors else ()
    for found in chain(entrywise(statement, points.screen, (), lambda: None), with_factors):
        is_kept = isinstance(found.statement, Relation) and found.statement.left == statement.left
        if len(found.changes) == 1 and (left_too or is_kept):
            yield found.statement
