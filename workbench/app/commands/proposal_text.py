"""Proposals on a terminal, in the style of `workbench.app.commands.terminal`."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.text import Text

from workbench.app.commands.terminal import outcome_text
from workbench.source.typeset.differences import in_one_line

if TYPE_CHECKING:
    from workbench.papers import Claim
    from workbench.prover.results.proposed_form import Proposed
    from workbench.repair.propose.proposal import Repair
    from workbench.repair.propose.search_limits import Limits

_GONE, _NEW = "red strike", "bold green underline"
_INDENT = 17
#: The number of candidates between redraws of a bar.
_STRIDE = 50


def repair_lines(repair: Repair, coloured: bool = False) -> Iterator[Text]:
    """Yields the result of the search for one claim."""
    proposed = repair.proposed()
    yield from proposed_lines(repair.claim, proposed, coloured)
    if not proposed:
        yield from _field("proposed", f"nothing, of {repair.candidates} candidates")
    if not repair.complete:
        yield from _field("", "the search was not finished")


def proposed_lines(claim: Claim, proposed: Sequence[Proposed], coloured: bool) -> Iterator[Text]:
    yield Text(claim.id, style="bold")
    yield from _field("our formula" if claim.sentence.ours else "printed", claim.printed.latex)
    yield from proposal_lines(proposed, coloured)


def proposal_lines(proposed: Sequence[Proposed], coloured: bool) -> Iterator[Text]:
    """Yields proposals. coloured: with differences in colours, else as [-printed-] and {+proposed+}."""
    for proposal in proposed:
        yield from _field("proposed", proposal.latex)
        yield from _field("edit", proposal.edit)
        label = Text(f"{'difference':>{_INDENT - 2}}  ")
        yield label.append_text(difference_text(proposal.difference, coloured))
        yield Text.assemble(" " * _INDENT, outcome_text(proposal.verdict))


def difference_text(parts: Sequence[Mapping[str, str]], coloured: bool) -> Text:
    """Returns a difference (`Difference.parts`) in one line."""
    if not coloured:
        return Text(in_one_line(parts))
    styles = {"same": "", "printed": _GONE, "proposed": _NEW}
    pieces = [Text(part[key], style=styles[key]) for part in parts for key in part if part[key]]
    return Text(" ").join(pieces)


@contextmanager
def search_bar(name: str, limits: Limits) -> Iterator[Callable[[Repair], None]]:
    """Shows a progress bar for the search on standard error, if that is a terminal.

    The bar shows how much of the time or of the candidates is used. Yields the function to call with each
    candidate.
    """
    if not sys.stderr.isatty():
        yield lambda found: None
        return
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(f"repairing {name}", total=1.0)

        def advance(found: Repair) -> None:
            if found.candidates % _STRIDE == 1:
                elapsed = progress.tasks[0].elapsed or 0.0
                used = max(found.candidates / limits.candidates, elapsed / limits.seconds)
                said = f"repairing {name}: {found.candidates} candidates, {len(found.proposals)} proved"
                progress.update(task, completed=min(used, 1.0), description=said)

        yield advance


def _field(name: str, value: str) -> Iterator[Text]:
    yield Text(f"{name:>{_INDENT - 2}}  {' '.join(value.split())}")
