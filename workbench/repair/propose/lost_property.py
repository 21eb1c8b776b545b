"""Corrections of a definition whose value lacks a property that the text states of its symbol.

The property is judged, and not the equation: R = … defines R. Where the printed value would have the property
by a convention only, such as that of unit quaternions, each guess is assumed in turn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import combinations

from workbench.context.claims import Claim, Formula
from workbench.context.conventions import conventional
from workbench.context.facts import Act, Supposition
from workbench.context.formula_acts import subject_of
from workbench.context.free_symbols import body_of
from workbench.core.terms import Conjunction, IllFormed, Relation, Statement, Symbol
from workbench.core.verdict import Outcome, Verdict
from workbench.engines.jet.rings import PRIME
from workbench.language.printing.printer import to_latex
from workbench.prover.explain.stated_properties import stated_property, turned
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.changes import Candidate, Change
from workbench.repair.terms.edit_search import candidate_of, cost
from workbench.repair.terms.subterm_positions import Place, replaced
from workbench.repair.terms.term_edits import Edit, edits

#: The verdict on a value that has the property: nothing tells it from other values that have it.
HAS_PROPERTY = Verdict(Outcome.UNCHECKED)
#: The most signs that are changed together, and the most signs of which some are.
_MOST_CHANGED, _MOST_SIGNS = 3, 48


def property_stated_of(claim: Claim) -> Callable[[Statement], Statement] | None:
    """Returns the function from an equation to the statement that its right side has the stated properties;
    None for a claim that defines no such symbol."""
    said, names = claim.printed.statement, [name for name, _ in claim.context.properties]
    if not names or not isinstance(said, Relation) or not isinstance(said.left, Symbol):
        return None
    body = body_of(said.left, claim.notation.definitions)
    if claim.context.act[0] is not Act.DEFINE if body is None else body != said.right:
        return None

    def of_value(statement: Statement) -> Statement:
        assert isinstance(statement, Relation)
        parts = tuple(stated_property(name, statement.right) for name in names)
        return parts[0] if len(parts) == 1 else Conjunction(parts)

    return of_value


def under_guesses(claim: Claim) -> Iterator[tuple[Claim, int]]:
    """Yields the claim, and the most signs that are changed together.

    A definition with a stated property is tried under each guess, with one change first.
    """
    yield claim, 1
    of_value, said = property_stated_of(claim), claim.printed.statement
    if of_value is None or said is None:
        return
    guessed = [claim]
    with suppress(IllFormed):
        asked = replace(claim, printed=Formula(claim.printed.latex, of_value(said)))
        for facts in conventional(subject_of(asked)).alternatives:
            if equations := _equations_of([fact.content for fact in facts]):
                guessed.append(replace(claim, assume=(*claim.assume, *equations)))
    yield from ((each, 1) for each in guessed[1:])
    yield from ((each, _MOST_CHANGED) for each in guessed)


def _equations_of(contents: Sequence[object]) -> list[Formula]:
    """Returns the equations of suppositions that replace no term."""
    made: list[Formula] = []
    for content in contents:
        if not isinstance(content, Supposition) or content.terms:
            return []
        made += [Formula(to_latex(each), each) for each in content.equations]
    return made


def other_values(
    printed: Statement,
    of_value: Callable[[Statement], Statement],
    screen: Screen,
    most: int,
    tick: Callable[[], None],
) -> Iterator[Iterator[Candidate]]:
    """Yields the stages: values with the property at random points, with one change or `most` other signs."""

    def has_property(statement: Statement) -> bool:
        tick()
        with suppress(IllFormed):
            return screen.vanishes(of_value(statement))
        return False

    found = [each for each in edits(printed, within=(1,)) if isinstance(each, Edit)]
    if most == 1:
        yield (candidate_of(edit) for edit in sorted(found, key=cost) if has_property(edit.statement))
        return
    signs = [edit for edit in found if edit.kind == "sign"][:_MOST_SIGNS]
    near = _Near(printed, screen, signs)
    for size in range(2, most + 1):
        groups = (_changed(printed, group) for group in combinations(signs, size) if near.may_turn(group))
        yield (each for each in groups if each is not None and has_property(each.statement))


class _Near:
    """The entries of the printed matrix at random points, and how each edit changes them."""

    def __init__(self, printed: Statement, screen: Screen, found: Sequence[Edit]) -> None:
        self._before = self._entries(printed, screen)
        self._changes: dict[Place, list[int]] = {}
        for edit in found:
            after = self._entries(edit.statement, screen)
            self._changes[edit.place] = [x - y for x, y in zip(after, self._before, strict=True)]

    def _entries(self, statement: Statement, screen: Screen) -> tuple[int, ...]:
        assert isinstance(statement, Relation)
        value = turned(statement.right)
        self._size = value.type.rows
        return screen.components(value, value) or ()

    def may_turn(self, group: Sequence[Edit]) -> bool:
        """True if the rows with these changes are orthonormal modulo the prime, at the first point."""
        if not self._before:
            return True
        size = self._size
        vectors = [self._before, *(self._changes[edit.place] for edit in group)]
        entries = [sum(each) for each in zip(*(vector[: size * size] for vector in vectors), strict=True)]
        rows = [entries[size * at : size * at + size] for at in range(size)]
        return all(
            (sum(x * y for x, y in zip(rows[i], rows[j], strict=True)) - (i == j)) % PRIME == 0
            for i in range(size)
            for j in range(i + 1)
        )


def _changed(printed: Statement, group: Sequence[Edit]) -> Candidate | None:
    """Returns the statement with several changes; None if one lies inside of another."""
    places = [edit.place for edit in group]
    if any(one != other and other[: len(one)] == one for one in places for other in places):
        return None
    statement = printed
    with suppress(IllFormed):
        for edit in group:
            statement = replaced(statement, edit.place, edit.new)
        changes = tuple(Change(edit.kind, edit.description) for edit in group)
        return Candidate(statement, changes, None, max(map(cost, group)))
    return None
