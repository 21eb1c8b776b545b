"""`workbench draft`: writes a first model for a text."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from workbench.app.commands.judging_options import write_atomically
from workbench.app.commands.options import Unusable, json_text, reports_faults

if TYPE_CHECKING:
    from workbench.papers.drafting import Ingested


@click.command("draft")
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    help="The model, - for standard output; FILE with the ending .toml if none.",
)
@click.option(
    "--json",
    "json_out",
    is_flag=False,
    flag_value="-",
    metavar="OUT",
    help="Write every display as JSON to OUT (standard output if OUT is - or missing).",
)
@click.option(
    "--macros", type=click.Path(path_type=Path), help="A TeX file of macros that stand elsewhere; they win."
)
@click.option("--force", is_flag=True, help="Write over a model that is there.")
@reports_faults
def draft_text(file: Path, out: Path | None, json_out: str | None, macros: Path | None, force: bool) -> None:
    """Write a first model for a text: kinds guessed, each with its reason, definitions proposed, questions on
    top, and what could not be read. Exit status 1 if no display was read."""
    from workbench.papers.drafting import ingest, meant, model_text

    is_printed = out is not None and str(out) == "-"
    if is_printed and json_out == "-":
        raise Unusable("--out and --json: expected one of them on standard output, got both")
    out = file.with_suffix(".toml") if out is None or is_printed else out
    if out.exists() and not force and not is_printed:
        raise Unusable(f"{out}: is there already; --force writes over it")
    found = meant(ingest(file, macros))
    if is_printed:
        click.echo(model_text(found, out), nl=False)
    else:
        write_atomically(out, model_text(found, out))
    if json_out == "-":
        click.echo(json_text(found.to_dict()), nl=False)
    elif json_out is not None:
        write_atomically(Path(json_out), json_text(found.to_dict()))
    if not is_printed and json_out != "-":
        _print_table(found, out)
    if click.get_current_context().info_name == "ingest":
        click.echo("`workbench ingest` is now `workbench draft`", err=True)
    sys.exit(0 if len(found.text.displays) > sum(found.missing().values()) else 1)


def _print_table(found: Ingested, out: Path) -> None:
    from workbench.app.commands.carets import printable
    from workbench.app.commands.terminal import console

    terminal = console(sys.stdout)
    missing = found.missing()
    displays = len(found.text.displays)
    for warning in found.text.warnings:
        terminal.print(printable(f"warning: {warning}"), markup=False)
    rows = [
        ("displays", displays),
        ("read", displays - sum(missing.values())),
        ("claims", len(found.formulas)),
        ("symbols guessed", len(found.guesses)),
        ("definitions proposed", len(found.definitions)),
        ("questions", len(found.questions)),
    ]
    for name, count in rows:
        terminal.print(f"{count:>6}  {name}", markup=False)
    if missing:
        terminal.print("unread displays, by what they need:", markup=False)
        for feature, count in missing.most_common():
            terminal.print(printable(f"{count:>6}  {feature}"), markup=False)
    terminal.print(
        printable(f"the model is {out}; look at its questions, then: workbench check {out}"), markup=False
    )
