"""The commands repair and errata, and the proposals in other commands."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.options import (
    Unusable,
    json_flag,
    named_paper,
    paper_option,
    print_json,
    reports_faults,
)
from workbench.app.pipeline.verdict_memory import memory_of_verdicts
from workbench.repair.propose.search_limits import STANDARD, Limits

if TYPE_CHECKING:
    from workbench.papers import Claim, Paper
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.repair.propose.proposal import Repair


def _seconds_option(command: Callable[..., None]) -> Callable[..., None]:
    """Adds the option for the limit of a search; its old name `--seconds` limits one judgement elsewhere."""
    limit = click.option(
        "--search-seconds",
        "seconds",
        default=STANDARD.seconds,
        show_default=True,
        callback=lambda ctx, _, value: ctx.meta.get("workbench.seconds", value),
        help="The limit on time for the search about one claim.",
    )
    old = click.option(
        "--seconds",
        "old_seconds",
        type=float,
        hidden=True,
        is_eager=True,
        expose_value=False,
        callback=_renamed,
    )
    return limit(old(command))


def _renamed(ctx: click.Context, _parameter: click.Parameter, value: float | None) -> None:
    if value is not None:
        click.echo("--seconds is called --search-seconds here", err=True)
        ctx.meta["workbench.seconds"] = value


@click.command("repair")
@click.argument("select", nargs=-1, required=True, metavar="ID...")
@paper_option
@_seconds_option
@click.option("--definitions", is_flag=True, help="Change the definitions that the claims share instead.")
@json_flag
@reports_faults
def repair_claim(
    select: Sequence[str], paper_name: str | None, seconds: float, definitions: bool, as_json: bool
) -> None:
    """Propose the right form of claims, from their printed forms alone; only proved forms are proposed.
    Ctrl-C keeps what was found. Exit status 0 if there is a proposal for each, 1 if not."""
    from workbench.app.commands.proposal_text import repair_lines
    from workbench.app.commands.terminal import console
    from workbench.papers.selection import select_claims

    limits = _limits(seconds)
    claims = select_claims(named_paper(paper_name).claims, select)
    if definitions:
        _repair_definitions(claims, seconds, as_json)
    repairs = _repaired(claims, limits)
    if as_json:
        found = [_repair_json(repair) for repair in repairs]
        print_json(found[0] if len(found) == 1 else found)
    else:
        terminal = console(sys.stdout)
        for repair in repairs:
            for line in repair_lines(repair, coloured=terminal.is_terminal):
                terminal.print(line)
    done = len(repairs) == len(claims) and all(repair.proposals for repair in repairs)
    sys.exit(0 if done else 1)


@click.command()
@click.argument("select", nargs=-1)
@paper_option
@_seconds_option
@json_flag
@reports_faults
def errata(select: Sequence[str], paper_name: str | None, seconds: float, as_json: bool) -> None:
    """Show which known errata the repair corrects from the printed form alone, as they were corrected by
    hand. SELECT as for verify. Ctrl-C keeps what was found. Exit status 0 if it corrects all of them."""
    from workbench.app.commands.terminal import console
    from workbench.papers.selection import select_claims
    from workbench.repair.propose.known_errata import compared, errata_table, known_errata, summary

    limits = _limits(seconds)
    claims = known_errata(select_claims(named_paper(paper_name).claims, select))
    rows = [compared(repair) for repair in _repaired(claims, limits)]
    if as_json:
        print_json([row.to_dict() for row in rows])
    else:
        terminal = console(sys.stdout)
        terminal.print(errata_table(rows))
        terminal.print(summary(rows), markup=False)
    sys.exit(0 if len(rows) == len(claims) and all(row.is_same for row in rows) else 1)


def _repair_json(repair: Repair) -> dict[str, Any]:
    return {
        "id": repair.claim.id,
        "printed": repair.claim.printed.latex,
        "proposed": [asdict(proposed) for proposed in repair.proposed()],
        "candidates": repair.candidates,
        "complete": repair.complete,
    }


def _limits(seconds: float) -> Limits:
    if not 0 < seconds < math.inf:
        raise Unusable(f"seconds: expected a positive number, got {seconds}")
    return Limits(seconds=seconds)


def _repaired(claims: Sequence[Claim], limits: Limits) -> list[Repair]:
    """Returns the repairs, with a progress bar over the search of a single claim, or over several claims."""
    from workbench.app.commands.proposal_text import search_bar
    from workbench.app.commands.terminal import progress_bar
    from workbench.repair.propose.parallel_repairs import repair_claims
    from workbench.repair.propose.repair import repair

    if len(claims) == 1:
        with search_bar(claims[0].id, limits) as advance:
            return [repair(claims[0], limits, progress=advance)]
    with progress_bar(len(claims), "repairing") as advance:
        return repair_claims(claims, limits, advance)


def _repair_definitions(claims: Sequence[Claim], seconds: float, as_json: bool) -> None:
    """Prints the changes of definitions that correct two or more of these false claims, and exits."""
    from workbench.repair.propose.definition_repair import repair_definitions

    repairs = repair_definitions(claims, seconds=seconds * len(claims))
    if as_json:
        print_json([{**asdict(repair), "edit": repair.edit} for repair in repairs])
    else:
        click.echo("\n".join(r.edit for r in repairs) or "no change of definitions mends two of these claims")
    sys.exit(0 if repairs else 1)


def with_proposals(
    results: Sequence[ClaimResult],
    wanted: bool,
    cache: bool = True,
    beside_right: bool = True,
    paper: Paper | None = None,
    seconds: float = STANDARD.seconds,
) -> list[ClaimResult]:
    """Returns the results with proposals for printed forms that are refuted or ill-formed.

    wanted: whether to search at all.
    beside_right: whether also to search if a proved right form is given.
    paper: if it is a text, its own characters are edited.
    seconds: the limit of the search for one claim.
    """
    from workbench.app.commands.terminal import progress_bar
    from workbench.app.pipeline.result_proposals import with_proposals
    from workbench.papers.texts.text_paper import TextPaper

    limits = replace(STANDARD, seconds=seconds) if wanted else None
    with memory_of_verdicts(cache) as memory, progress_bar(len(results) * wanted, "repairing") as advance:
        text = paper.text if isinstance(paper, TextPaper) else None
        return with_proposals(results, limits, advance, memory, beside_right, text)
