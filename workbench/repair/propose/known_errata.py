"""Comparison of the proposals for the known errata of a paper with the recorded corrections."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from typing import Any

from rich.table import Table
from rich.text import Text

from workbench.context.claims import Claim, Formula
from workbench.context.read_formulas import read_statement
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.repair.propose.proposal import Proposal, Repair
from workbench.repair.screening.sameness import Sameness

_STYLES = {"same": "green", "different": "yellow", "none": "red"}


@dataclass(frozen=True)
class Erratum:
    """The result of repairing one erratum.

    Attributes:
        result: "same" as the recorded correction; "different", but also proved; or "none".
        latex: The proposal that is the same, else the first one.
        edit: The changes of this proposal.
    """

    id: str
    equation: str | None
    printed: str
    by_hand: str
    result: str
    latex: str | None
    edit: str | None
    candidates: int
    complete: bool

    @property
    def is_same(self) -> bool:
        return self.result == "same"

    @property
    def why(self) -> str:
        """The edit, or why there is none."""
        if self.edit is not None:
            return self.edit
        ended = "all near forms were looked at" if self.complete else "the limit was reached"
        return f"nothing proved among {self.candidates} candidates; {ended}"

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


def known_errata(claims: Sequence[Claim]) -> list[Claim]:
    """Returns the claims with a recorded correction or reading, except those that only a theorem can
    decide."""
    return [claim for claim in claims if claim.proof.theorem is None and _by_hand(claim) is not None]


def _by_hand(claim: Claim) -> Formula | None:
    return claim.corrected or claim.reading


def compared(repair: Repair) -> Erratum:
    """Returns the comparison of the proposals with the recorded correction, which the search does not use."""
    claim, by_hand = repair.claim, _by_hand(repair.claim)
    assert by_hand is not None, f"{claim.id} is not corrected by hand"
    same = [proposal for proposal in repair.proposals if _says_the_same(claim, proposal, by_hand)]
    shown = (*same, *repair.proposals, None)[0]
    return Erratum(
        id=claim.id,
        equation=claim.equation,
        printed=claim.printed.latex,
        by_hand=by_hand.latex,
        result="same" if same else "different" if repair.proposals else "none",
        latex=shown.latex if shown else None,
        edit=shown.edit if shown else None,
        candidates=repair.candidates,
        complete=repair.complete,
    )


def _says_the_same(claim: Claim, proposal: Proposal, by_hand: Formula) -> bool:
    if by_hand.statement is None:
        return False
    with suppress(ReadError, IllFormedAt):
        proposed, _ = read_statement(proposal.latex, claim.notation, claim.orders)
        return Sameness.under(claim).same(proposed, by_hand.statement)
    return False


def errata_table(rows: Sequence[Erratum]) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for heading in ("id", "by the machine", "edit"):
        table.add_column(heading, overflow="fold")
    for row in rows:
        table.add_row(Text(row.id), Text(row.result, style=_STYLES[row.result]), Text(row.why))
    return table


def summary(rows: Sequence[Erratum]) -> str:
    counts = {result: sum(row.result == result for row in rows) for result in _STYLES}
    return (
        f"{counts['same']} of {len(rows)} errata corrected by the machine as by hand; "
        f"{counts['different']} otherwise, but proved; {counts['none']} not"
    )
