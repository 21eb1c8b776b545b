"""What a search for the right form of a claim returns: its proposals, and how far it went."""

from __future__ import annotations

from dataclasses import dataclass, field

from workbench.context.claims import Claim
from workbench.core.verdict import Verdict
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.prover.results.proposed_form import Proposed
from workbench.repair.terms.changes import Change
from workbench.repair.terms.false_members import membership
from workbench.repair.trees.as_printed import as_printed
from workbench.source.typeset.differences import difference, in_one_line
from workbench.source.typeset.latex_atoms import in_colour


@dataclass(frozen=True)
class Proposal:
    """A proved form, as LaTeX that reads as what was proved, and its changes."""

    latex: str
    changes: tuple[Change, ...]
    verdict: Verdict

    @property
    def edit(self) -> str:
        """The changes in words."""
        return "; ".join(change.description for change in self.changes)

    def difference(self, printed: str) -> list[dict[str, str]]:
        """Returns both forms aligned (`Difference.parts`); only the proposal if one form cannot be
        aligned."""
        found = difference(printed, self.latex)
        return list(found.parts) if found else [{"same": self.latex}]

    def in_colour(self, printed: str) -> str:
        """Returns LaTeX with the differences from the printed form in green."""
        found = difference(printed, self.latex)
        return in_colour(self.latex, found.marked_after if found else ())

    def beside(self, printed: str) -> Proposed:
        """Returns the proposal as part of a result."""
        return Proposed(self.latex, self.edit, self.difference(printed), self.verdict.outcome)


@dataclass(repr=False)
class Repair:
    """The result of a repair.

    Attributes:
        candidates: The number of candidates considered.
        complete: Whether the search finished.
        interrupted: Whether Ctrl-C stopped it.
    """

    claim: Claim
    proposals: list[Proposal] = field(default_factory=list)
    candidates: int = 0
    seconds: float = 0.0
    complete: bool = False
    interrupted: bool = False

    @property
    def printed(self) -> str:
        """The printed form in the spelling of the proposals: canonical, with the printed letters, if it can
        be read."""
        formula = self.claim.printed
        if formula.statement is None or membership(formula.latex) is not None:
            return formula.latex
        integers = self.claim.orders.variables if self.claim.orders else ()
        table = self.claim.notation.symbols
        with printed_for(self.claim.notation.author_notation):
            canonical = to_latex(formula.statement)
        return as_printed(canonical, formula.latex, table, integers)

    def proposed(self) -> tuple[Proposed, ...]:
        return tuple(proposal.beside(self.printed) for proposal in self.proposals)

    def __str__(self) -> str:
        lines = [
            f"{p.latex}\n    {p.edit} ({p.verdict.outcome})\n    {in_one_line(p.difference(self.printed))}"
            for p in self.proposals
        ]
        return "\n".join(lines) or f"no proposal among {self.candidates} candidates"

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        lines = [
            f"$$ {p.in_colour(self.printed)} $$\n\n{p.edit} (**{p.verdict.outcome}**)" for p in self.proposals
        ]
        return "\n\n".join(lines) or f"no proposal among {self.candidates} candidates"
