"""The questions of a draft on the terminal; the answers are written to the model next to the text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from workbench.app.commands.judging_options import write_atomically

if TYPE_CHECKING:
    from workbench.papers.drafting.drafted_texts import Draft
    from workbench.prover.results.claim_results import ClaimResult


def print_questions(draft: Draft, results: Sequence[ClaimResult]) -> None:
    """Prints the questions to the author, with the lines of the model that answer them."""
    from workbench.papers.drafting.questions_to_author import questions_about

    questions = questions_about(draft, results)
    for question in questions:
        click.echo(f"? {question}")
        for answer in question.answers:
            click.echo(f"    {' '.join(answer.lines)}")
    if questions:
        click.echo(f"`workbench check {draft.ingested.text.path} --ask` asks, and writes the answers down")


def ask(draft: Draft, results: Sequence[ClaimResult]) -> Draft | None:
    """Asks the author, and writes the model; returns the draft with the answers, or None without answers."""
    from workbench.papers.drafting.drafted_texts import draft_from
    from workbench.papers.drafting.model_file import model_text
    from workbench.papers.drafting.questions_to_author import answered, questions_about

    ingested, path = draft.ingested, draft.ingested.text.path.with_suffix(".toml")
    questions = questions_about(draft, results)
    for question in questions:
        click.echo(f"\n{question}")
        for number, answer in enumerate(question.answers, start=1):
            click.echo(f"  {number}  {' '.join(answer.lines)}")
        choices = click.IntRange(0, len(question.answers))
        number = click.prompt("  answer (0 leaves it open)", type=choices, default=0, show_default=False)
        if number:
            ingested = answered(ingested, question.answers[number - 1])
    if ingested is draft.ingested:
        click.echo("nothing was answered" if questions else "nothing is to be asked")
        return None
    write_atomically(path, model_text(ingested, path))
    click.echo(f"\nthe answers are in {path}")
    return draft_from(ingested)
