"""The functions of the Python API apart from `check`: load, draft, judge, repair, certify, report."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.certificates.certify import Certified
    from workbench.papers import Claim, Paper
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.repair.propose.proposal import Repair


def load(source: Path | str | None = None) -> Paper:
    """Returns a paper: of a paper file, of a text or its model, or an installed one.

    Args:
        source: A path (.toml, .tex, .md, .rst, .html, .ipynb) or the name of an installed paper; "chapter" if
            it is None.

    Raises:
        PaperError: The file cannot be used; `faults` are all faults, each with its position.

    >>> from workbench import load
    >>> load("vectors").title
    'Learn Multibody Dynamics: Vectors'
    """
    from workbench.app.pipeline.verdict_keys import Memory
    from workbench.papers import find_paper
    from workbench.runtime.store import standard

    with standard(Memory) as memory:
        return find_paper(None if source is None else str(source), memory)


def draft(text: Path | str) -> str:
    r"""Returns the first model of a text, as `workbench draft` writes it beside the text: TOML.

    It has the kinds of the symbols, each with its reason, proposed definitions, and questions to the author.

    Args:
        text: The path of a text: .tex, .md, .rst, .html, .ipynb.

    Raises:
        PaperError: The text cannot be read, or it has no display.

    >>> import tempfile
    >>> from workbench import draft
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     note = Path(folder, "note.md")
    ...     _ = note.write_text(r"For vectors $a$, $b$: $$a \times b = -b \times a$$")
    ...     model = draft(note)
    >>> [line for line in model.splitlines() if line.startswith("'a'")]
    ['\'a\' = { kind = "vector" }  # guessed: the text says "vectors" near it']
    """
    from workbench.papers.drafting import ingest, meant, model_text

    path = Path(text)
    return model_text(meant(ingest(path)), path.with_suffix(".toml"))


def judge(
    paper: Paper,
    select: Sequence[str] = (),
    *,
    second_engine: bool = True,
    motions: bool = True,
    seconds: float | None = None,
    megabytes: float | None = None,
    cache: bool = True,
    jobs: int | None = None,
) -> list[ClaimResult]:
    """Returns the results of the claims of a paper, in reading order.

    Args:
        paper: What `load` returned.
        select: Equations ("58"), ranges ("45-70"), ids ("58.det"), sections ("4.1"), patterns ("58.*"); all
            claims if it is empty.
        second_engine: Recheck each proof; without it nothing counts as proved.
        motions: Evaluate claims whose symbols are bound on simulated motions.
        seconds: The processor time for each judgement.
        megabytes: The memory for each judgement.
        cache: Take the verdicts of earlier runs.
        jobs: The number of processes.

    Raises:
        ValueError: A selection means no claim.

    >>> from workbench import judge, load
    >>> [str(result.verdict.outcome) for result in judge(load(), ["58.det"])]
    ['proved']
    """
    from contextlib import nullcontext

    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.app.pipeline.verdict_keys import Memory
    from workbench.runtime import Budget
    from workbench.runtime.store import standard

    budget = Budget.of(seconds=seconds, megabytes=megabytes)
    with standard(Memory) if cache else nullcontext() as memory:
        return judge_paper(
            paper,
            select,
            jobs=jobs,
            budget=budget,
            memory=memory,
            second_engine=second_engine,
            motions=motions,
        )


def repair(claim: Claim | ClaimResult, seconds: float = 25.0) -> Repair:
    """Returns the right forms of a claim that is refuted or ill-formed as printed; each is proved.

    Args:
        claim: A claim, or its result.
        seconds: The limit of the search.

    >>> from workbench import judge, load, repair
    >>> found = repair(judge(load(), ["70.div"])[0])
    >>> found.proposals[0].edit
    'change the sign of $\\\\omega^{4}$'
    """
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.repair.propose.repair import repair as search
    from workbench.repair.propose.search_limits import Limits

    return search(claim.claim if isinstance(claim, ClaimResult) else claim, Limits(seconds=seconds))


def certify(result: ClaimResult) -> dict[str, Certified]:
    """Returns the Coq theorems of the exact forms of a claim: printed, reading, corrected.

    Coq is asked by `Certified.check`, not here.

    Args:
        result: A result of `judge`. A form has a theorem if it is proved or refuted by exact arithmetic.

    >>> from workbench import certify, judge, load
    >>> print(certify(judge(load(), ["58.det"])[0])["printed"].statement)
    Theorem claim_58_det_printed (K : diff_ring) (omega : vector K) :
      let Phi_1 := skew omega in
      let Phi_2 := D Phi_1 + Phi_1 ∘ Phi_1 in
      det Phi_2 ≡ - square (omega × D omega).
    """
    from workbench.certificates.certify import exact_forms, written

    return {form.name: written(form, verdict) for form, _, verdict in exact_forms([result])}


def report(paper: Paper, results: Sequence[ClaimResult], out: Path | str = "report") -> list[Path]:
    """Writes the report of a paper to a folder; returns the files: JSON, HTML, Markdown, LaTeX.

    Args:
        paper: What `load` returned.
        results: What `judge` returned.
        out: The folder, which is made if it does not exist.

    Raises:
        ReportError: A character cannot be set.
        OSError: The folder cannot be written.

    >>> import tempfile
    >>> from workbench import judge, load, report
    >>> paper = load()
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     sorted(path.name for path in report(paper, judge(paper, ["58.det"]), folder))
    ['errata.json', 'erratum.tex', 'report.html', 'report.json', 'report.md']
    """
    from workbench.certificates.certify import with_certificates
    from workbench.report.render import write_report

    cited = replace(paper, citation={"recheck": "workbench report", **paper.citation})
    return list(write_report(cited, with_certificates(list(results), paper), Path(out)))
