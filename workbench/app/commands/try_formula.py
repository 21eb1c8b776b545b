"""`workbench try`: judges one formula, with given or inferred kinds of symbols."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click
from rich.text import Text

from workbench.app.commands.options import Unusable, json_flag, print_json, reports_faults
from workbench.core.code_labels import suffix
from workbench.core.codes.input_codes import InputCode
from workbench.core.reasons import reason_of
from workbench.core.verdict import Outcome, Verdict

if TYPE_CHECKING:
    from workbench import Checked
    from workbench.papers.drafting.drafted_texts import Draft
    from workbench.prover.results.claim_results import ClaimResult


@click.command("try")
@click.argument("formula")
@click.option(
    "--symbol", "-s", "given", multiple=True, metavar="NAME=KIND", help="What a symbol is, as in a=vector."
)
@click.option("--assume", "-a", multiple=True, metavar="FORMULA", help="A relation that is assumed.")
@click.option("--paper", metavar="NAME", help="Take the notation of a paper, as in chapter.")
@click.option("--proposals/--no-proposals", default=True, help="Search for the right form.")
@json_flag
@reports_faults
def try_formula(
    formula: str,
    given: Sequence[str],
    assume: Sequence[str],
    paper: str | None,
    proposals: bool,
    as_json: bool,
) -> None:
    """Judge one formula. Kinds that are not given are inferred from the formula, and named.

    `$…$`, an equation environment and signs such as × are understood. Exit status: 0 if it holds, 1 if not,
    2 if it cannot be read or was not decided."""
    from workbench.prover.results.claim_results import HOLDS
    from workbench.source.rewriting.pasted_formulas import as_typed

    for remark in as_typed(formula)[1]:
        click.echo(remark, err=True)
    try:
        lines, inferred = judged_formula(formula, dict(_symbol(each) for each in given), assume, paper)
    except ValueError as error:
        raise Unusable(reason_of(error, InputCode.COMMAND_LINE)) from None
    if as_json:
        from workbench.report.to_json import claim_json

        told = [claim_json(each.result) for each in lines]
        print_json(told if len(told) > 1 else told[0])
    else:
        _print(lines, inferred, proposals)
    outcomes = {each.outcome for each in lines}
    if outcomes <= HOLDS:
        sys.exit(0)
    sys.exit(1 if outcomes & {Outcome.REFUTED, Outcome.ILL_FORMED} else 2)


def judged_formula(
    formula: str, symbols: Mapping[str, str], assume: Sequence[str], paper: str | None = None
) -> tuple[list[Checked], dict[str, dict[str, object]]]:
    """Returns the verdicts on the lines of a typed formula, and the inferred kinds.

    Raises:
        ValueError: The formula cannot be read.
    """
    from workbench import Checked, check
    from workbench.source.rewriting.pasted_formulas import as_typed

    latex = as_typed(formula)[0]
    if not latex:
        raise ValueError("the formula is empty")
    if paper:
        found = check(latex, symbols, paper, assume)
        return ([found] if isinstance(found, Checked) else list(found)), {}
    draft, results = _as_a_text(latex, symbols, assume)
    inferred = {name: guess.spec for name, guess in draft.ingested.guesses.items() if not guess.free}
    return [Checked(result) for result in results], inferred


def _as_a_text(
    latex: str, symbols: Mapping[str, str], assume: Sequence[str]
) -> tuple[Draft, list[ClaimResult]]:
    """Returns the draft of a text that has the formula only, and the verdicts on it.

    A symbol whose kind is given may have any value of that kind: the formula does not say what it is."""
    from workbench.app.checked import with_assumptions
    from workbench.app.pipeline.judge_claims import judge_claims
    from workbench.app.pipeline.verdict_keys import Memory
    from workbench.language.naming.symbols import SymbolTable
    from workbench.papers.drafting.draft_model import ingested
    from workbench.papers.drafting.drafted_texts import draft_from
    from workbench.papers.drafting.typefaces import Guess, GuessOrigin
    from workbench.runtime.store import standard
    from workbench.source.documents import read_text

    SymbolTable.build({name: {"kind": kind} for name, kind in symbols.items()})  # refuses an unknown kind
    given = [
        Guess(name, kind, "the text says so", free=True, origin=GuessOrigin.WORDS)
        for name, kind in symbols.items()
    ]
    with TemporaryDirectory(prefix="workbench-") as folder, standard(Memory) as memory:
        path = Path(folder) / "formula.tex"
        path.write_text(f"\\[\n{latex}\n\\]\n", encoding="utf-8")
        draft = draft_from(ingested(read_text(path), given=given))
        claims = [with_assumptions(claim, assume) for claim in draft.paper.claims]
        return draft, judge_claims(claims, memory=memory)


def _symbol(text: str) -> tuple[str, str]:
    name, sign, kind = (part.strip() for part in text.rpartition("="))
    if not sign or not name or not kind:
        raise Unusable(f"-s: expected NAME=KIND, as in a=vector, got {text!r}")
    return name, kind


def _print(lines: Sequence[Checked], inferred: dict[str, dict[str, object]], proposals: bool) -> None:
    from workbench.app.commands.terminal import console
    from workbench.source.typeset.plain_text import plain_text

    terminal = console(sys.stdout)
    for checked in lines:
        for line in _verdict_lines(checked, proposals):
            terminal.print(line, soft_wrap=True)
    if inferred:
        kinds = ", ".join(f"{plain_text(name)} {spec['kind']}" for name, spec in inferred.items())
        terminal.print(f"Taken as: {kinds}. Another kind: -s NAME=KIND.", markup=False, soft_wrap=True)


def _verdict_lines(checked: Checked, proposals: bool) -> Iterator[Text]:
    """Yields the verdict in a line, then the counterexample and the right form, if there are any."""
    from workbench.app.commands.listing_text import MARKS, STYLES, example_lines
    from workbench.report.counterexamples import told
    from workbench.source.typeset.plain_text import in_plain_text

    verdict = checked.verdict
    proposed = checked.repair().proposed() if proposals else ()
    what = _in_words(verdict)
    if proposed:
        what += f"; {in_plain_text(proposed[0].edit)}"
    grade = verdict.grade
    yield Text.assemble((MARKS[grade], STYLES.get(grade, "")), f" {what}")
    if verdict.read_back:
        yield Text(f"  read as {verdict.read_back}")
    if verdict.counterexample is not None:
        yield from example_lines(told(verdict.counterexample, checked.latex))
    if proposed:
        is_proved = " (proved)" if proposed[0].verdict is Outcome.PROVED else ""
        yield Text(f"  right   {proposed[0].latex}{is_proved}")


def _in_words(verdict: Verdict) -> str:
    from workbench.source.typeset.plain_text import in_plain_text

    reason = in_plain_text(str(verdict.reason or "")) + suffix(verdict.reason)
    match verdict.outcome:
        case Outcome.PROVED:
            return f"holds for {verdict.scope}" if verdict.scope else "holds"
        case Outcome.CONDITIONAL if verdict.hypothesis:
            return f"holds if {in_plain_text(verdict.hypothesis.prose)}"
        case Outcome.REFUTED:
            return f"does not hold: {reason}" if reason else "does not hold"
        case Outcome.ILL_FORMED:
            return f"the parts do not fit: {reason}"
        case Outcome.UNCHECKED:
            return f"not judged: {reason}"
    return f"{verdict.outcome}: {reason}" if reason else str(verdict.outcome)
