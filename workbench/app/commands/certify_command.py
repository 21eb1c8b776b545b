"""`workbench certify`: the exact claims as Coq theorems."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from workbench.app.commands.options import Defect, Unusable, named_paper, paper_option, reports_faults

if TYPE_CHECKING:
    from workbench.certificates.certified_forms import Certificate
    from workbench.certificates.certify import Certified


@click.command()
@click.argument("select", nargs=-1)
@paper_option
@click.option(
    "--out", type=click.Path(path_type=Path), help="Write the .v files, and the library, to this directory."
)
@click.option("--check", "asked", is_flag=True, help="Have Coq check each certificate and print its axioms.")
@reports_faults
def certify(select: Sequence[str], paper_name: str | None, out: Path | None, asked: bool) -> None:
    """Write the proved and refuted forms of the claims that SELECT means as Coq theorems. With --check, exit
    status 3 if Coq refuses one of them."""
    from workbench.app.commands.judging_options import judged_claims
    from workbench.app.commands.terminal import certificates_table, console, progress_bar
    from workbench.certificates import coqc
    from workbench.certificates.certify import exact_forms, recalled, written
    from workbench.certificates.handwritten import by_hand
    from workbench.certificates.steps import all_steps

    if asked and coqc.version() is None:
        raise Unusable(f"no coqc is found, so no certificate can be checked; get it by {coqc.INSTALL}")
    if out is not None and out.exists() and not out.is_dir():
        raise Unusable(f"{out}: expected a directory for the certificates, got a file")
    paper = named_paper(paper_name)
    results = judged_claims(paper, select)
    made = [written(form, verdict) for form, _, verdict in exact_forms(results)]
    steps = all_steps(results, paper.theorems)
    if out is not None:
        _write(out, made, [s.whole.certificate for s in steps if s.whole.certificate])
    try:
        hand = [] if select else by_hand(paper)
        if asked:
            texts = {each.text for each in hand}
            texts = texts.union(*(each.texts for each in made), *(each.texts for each in steps))
            with progress_bar(len(texts), "checking") as advance:
                coqc.check_all(texts, advance)
            made = [recalled(each) for each in made]
        known = [(each.path.name, coqc.recall(each.text)) for each in hand if asked]
        refused = [name for name, said in known if said is None or not said.expected]
    except coqc.CoqFault as fault:
        raise Defect(str(fault)) from None
    terminal = console(sys.stdout)
    terminal.print(certificates_table(made))
    for each in steps:
        terminal.print(f"{each.claim.id}, theorem: {each.word}", markup=False)
    certified = [c for c in made if c.certificate is not None]
    done = [c for c in made if c.certified]
    asked_for = f", {len(done)} certified{_times(done)}" if asked else ""
    terminal.print(f"{len(made)} exact forms, {len(certified)} written{asked_for}", markup=False)
    if steps:
        whole = sum(s.is_one_theorem for s in steps)
        counts = f"{sum(len(s.certified) for s in steps)} of {sum(len(s.steps) for s in steps)} steps"
        terminal.print(
            f"{len(steps)} theorem claims, {whole} as one theorem; {counts} certified", markup=False
        )
    for file in hand:
        word = ": refused" if file.path.name in refused else ": certified" if asked else ""
        about = ", ".join(claim for claim, _, _ in file.about)
        terminal.print(f"{file.path.name}, written by hand, on {about}{word}", markup=False)
    wrong = [s.claim.id for s in steps if s.broken] if asked else []
    if broken := [*(c.form.identifier for c in made if c.broken), *wrong, *refused]:
        raise Defect(f"Coq refuses {len(broken)} of them, or they say something else: {', '.join(broken)}")


def _times(done: Sequence[Certified]) -> str:
    if not done:
        return ""
    total, slowest = sum(c.seconds for c in done), max(done, key=lambda c: c.seconds)
    longest = f"{slowest.form.identifier} the slowest in {slowest.seconds:.0f} s"
    return f" in {total / 60:.1f} min of processor time, {longest}"


def _write(out: Path, made: Sequence[Certified], goals: Sequence[Certificate]) -> None:
    from workbench.certificates import coqc

    try:
        (out / "library").mkdir(parents=True, exist_ok=True)
        for name in coqc.LIBRARY:
            (out / "library" / f"{name}.v").write_text(coqc.library_text(name), encoding="utf-8")
        for each in made:
            if each.certificate is not None:
                (out / f"{each.form.identifier}.v").write_text(each.certificate.text, encoding="utf-8")
                if (motions := each.certificate.motions) is not None:
                    (out / f"{each.form.identifier}_premises.v").write_text(motions.text, encoding="utf-8")
        for goal in goals:
            (out / f"{goal.theorems[0].name}_goal.v").write_text(goal.text, encoding="utf-8")
    except OSError as error:
        raise Unusable(f"{out}: the certificates cannot be written: {error.strerror or error}") from None
