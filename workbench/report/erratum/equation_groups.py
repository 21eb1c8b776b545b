"""Equations: the claims that a report counts as one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from workbench.context.claims import Claim, Paper
from workbench.core.spans import Span
from workbench.papers.texts.text_paper import TextPaper
from workbench.prover.results.claim_results import ClaimResult
from workbench.report.anchors import Heirs, is_counted
from workbench.report.claim_states import state_of, state_of_equation
from workbench.report.findings import place_of
from workbench.report.shown_kinds import SHOWN, Kind
from workbench.source.documents import Display


@dataclass(frozen=True)
class Group:
    """The claims of one equation. display: that of the text which holds them."""

    display: Display | None
    results: list[ClaimResult]


def groups_of(paper: Paper, results: Sequence[ClaimResult]) -> list[Group]:
    """Returns the results by equation, in the order of the paper.

    An equation is a numbered row, or a display without numbers; in a paper file all claims of one number or
    name.
    """
    displays = paper.text.displays if isinstance(paper, TextPaper) and paper.text else ()
    found: dict[tuple[str, str], Group] = {}
    for result in results:
        display = _display_of(result, displays)
        number = result.claim.equation or ""
        if display is not None:
            key = (f"{display.source.path}:{display.start}", number)
        else:
            key = ("", number) if number else (_first_step(result.claim), "")
        found.setdefault(key, Group(display, [])).results.append(result)
    return list(found.values())


def states_of(paper: Paper, results: Sequence[ClaimResult]) -> Iterator[tuple[Group, tuple[Kind, ...], Kind]]:
    """Yields each equation with the states of its claims and its own."""
    heirs = Heirs(results, {result.claim.id: (result.claim.id, "") for result in results})
    for group in groups_of(paper, results):
        states = tuple(state_of(result, bool(heirs.before(result.claim))) for result in group.results)
        yield group, states, state_of_equation(group.results, states)


def equation_counts(paper: Paper, results: Sequence[ClaimResult]) -> dict[str, int]:
    """Returns the number of equations in each state, without named theorems and remarks."""
    equations = states_of(paper, results)
    counts = Counter(state.name for group, _, state in equations if is_counted(group.results[0].claim))
    return {kind.name: counts[kind.name] for kind in SHOWN if counts[kind.name]}


def _first_step(claim: Claim) -> str:
    return claim.chain[0] if claim.chain else claim.id


def _display_of(result: ClaimResult, displays: Sequence[Display]) -> Display | None:
    span = result.claim.context.span or place_of(result)
    return next((each for each in displays if _holds(each, span)), None)


def _holds(display: Display, span: Span) -> bool:
    source = display.source
    if source.path != span.file:
        return False
    start, end = source.place(display.start), source.place(display.end)
    return start <= (span.line, span.column) and (span.end_line, span.end_column) <= end
