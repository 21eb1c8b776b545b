"""The neighbouring steps of a claim in its chain, with which a proposal must agree."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

from workbench.context.claims import Claim
from workbench.core.construct import relation
from workbench.core.terms import IllFormed, Relation, Statement, Symbol
from workbench.repair.screening.screen import Screen
from workbench.repair.screening.vacuous import has_cancelling_addends, is_trivial


@dataclass(frozen=True)
class Neighbours:
    """The formulas of the neighbouring steps, as statements (if they are read) and as LaTeX.

    Attributes:
        before: The step that ends with the claim's left side.
        behind: The step that begins with the claim's right side.
    """

    before: Statement | None = None
    behind: Statement | None = None
    before_latex: str = ""
    behind_latex: str = ""

    @property
    def key(self) -> str:
        """The inputs of proposals apart from the claim, as a cache key."""
        return f"{self.before_latex}\n{self.behind_latex}"

    def agree_with(self, candidate: Statement, printed: Statement, screen: Screen) -> bool:
        """True if the neighbouring steps hold at the screen's points with the sides of the candidate.

        A step that gives the value of a free symbol agrees with any candidate.
        """
        if not (isinstance(candidate, Relation) and isinstance(printed, Relation)):
            return True
        before, behind = self.before, self.behind
        if isinstance(before, Relation) and before.right == printed.left:
            is_said = isinstance(before.left, Symbol) and not _holds(before, printed, True, screen)
            if not is_said and not _holds(before, candidate, True, screen):
                return False
        if isinstance(behind, Relation) and behind.left == printed.right:
            return _holds(behind, candidate, False, screen)
        return True

    def joined(self, candidate: Statement) -> Statement:
        """Returns the statement to judge for a candidate.

        For a step with two equal sides it is the equation of a side with the far side of a neighbour.
        """
        if not isinstance(candidate, Relation) or not is_trivial(candidate):
            return candidate
        if has_cancelling_addends(candidate):
            return candidate
        with suppress(IllFormed):
            before, behind = self.before, self.behind
            if (
                isinstance(before, Relation)
                and before.operator == "="
                and not isinstance(before.left, Symbol)
            ):
                return relation("=", before.left, candidate.right)
            if isinstance(behind, Relation) and behind.operator == "=":
                return relation("=", candidate.left, behind.right)
        return candidate

    def repeat(self, candidate: Statement, changes: int) -> bool:
        """True if several changes only join a side of the claim with a side of a neighbour, and omit the
        printed side."""
        if not isinstance(candidate, Relation) or changes == 1:
            return False
        first = self.before.left if isinstance(self.before, Relation) else None
        last = self.behind.right if isinstance(self.behind, Relation) else None
        return candidate.left == first or candidate.right == last


#: The neighbours of a claim that is no step of a chain.
ALONE = Neighbours()


def _holds(neighbour: Relation, candidate: Relation, is_before: bool, screen: Screen) -> bool:
    sides = (neighbour.left, candidate.left) if is_before else (candidate.right, neighbour.right)
    try:
        return screen.vanishes(relation("=", *sides))
    except IllFormed:
        return False


def neighbours_of(claims: Sequence[Claim]) -> Mapping[str, Neighbours]:
    """Returns the neighbours of all claims that are steps of chains, by id."""
    known = {claim.id: claim for claim in claims}
    behind = {claim.chain[-1]: claim for claim in claims if claim.chain}
    found = {}
    for claim in claims:
        first = known.get(claim.chain[-1]) if claim.chain else None
        last = behind.get(claim.id)
        if first is not None or last is not None:
            found[claim.id] = Neighbours(
                None if first is None else first.printed.statement,
                None if last is None else last.printed.statement,
                "" if first is None else first.printed.latex,
                "" if last is None else last.printed.latex,
            )
    return found
