"""Checks the printed formulas of kinematics papers: LaTeX in, exact verdict and evidence out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbench.app.api import certify, draft, judge, load, repair, report
    from workbench.app.checked import Checked, CheckedLines
    from workbench.certificates.certify import Certified
    from workbench.core.formula_errors import ReadError
    from workbench.core.verdict import Counterexample, Outcome, Verdict
    from workbench.kinematics import Robot
    from workbench.papers import Claim, Paper, PaperError
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.repair.propose.proposal import Repair

__all__ = [
    "Certified",
    "Checked",
    "CheckedLines",
    "Claim",
    "ClaimResult",
    "Counterexample",
    "Outcome",
    "Paper",
    "PaperError",
    "ReadError",
    "Repair",
    "Robot",
    "Verdict",
    "__version__",
    "certify",
    "check",
    "draft",
    "judge",
    "load",
    "repair",
    "report",
]

#: Where each public name is defined; it is imported at its first use. repair and report are packages, too,
#: and callable.
_PLACES = {
    "Certified": "workbench.certificates.certify",
    "Checked": "workbench.app.checked",
    "CheckedLines": "workbench.app.checked",
    "Claim": "workbench.context.claims",
    "ClaimResult": "workbench.prover.results.claim_results",
    "Counterexample": "workbench.core.verdict",
    "Outcome": "workbench.core.verdict",
    "Paper": "workbench.context.claims",
    "PaperError": "workbench.context.claims",
    "ReadError": "workbench.core.formula_errors",
    "Repair": "workbench.repair.propose.proposal",
    "Robot": "workbench.kinematics",
    "Verdict": "workbench.core.verdict",
    "certify": "workbench.app.api",
    "draft": "workbench.app.api",
    "judge": "workbench.app.api",
    "load": "workbench.app.api",
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name == "__version__":
        from importlib.metadata import version

        return version("kinematics-workbench")
    if name in _PLACES:
        return getattr(import_module(_PLACES[name]), name)
    if name in ("repair", "report"):
        return import_module(f"workbench.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def check(
    latex: str,
    symbols: Mapping[str, str | Mapping[str, Any]] | None = None,
    paper: Paper | Path | str | None = None,
    assume: Sequence[str] = (),
    orders: str | None = None,
    *,
    definitions: Mapping[str, str] | Sequence[str] = (),
    notation: Path | str | None = None,
    at: str | None = None,
    seconds: float | None = None,
    megabytes: float | None = None,
) -> Checked | CheckedLines:
    """Returns the verdict on a printed formula, which displays itself in Jupyter and on a terminal.

    Args:
        latex: An equation; several lines (aligned, cases) give several verdicts.
        symbols: LaTeX → what it is, as in a paper file, or just its kind: {r"u": "vector"}.
        paper: Whose notation is meant: a paper file, an installed paper's name such as "chapter", or a Paper;
            `symbols` come after it. Without it, only `symbols`, `definitions` and `notation` are known.
        assume: Relations (= or \\neq) that are assumed.
        orders: The values of the indices, such as "n = 1..8".
        definitions: What more symbols stand for, in order: {r"K": r"a \\times b"} or [r"K = a \\times b"].
        notation: A TOML file with [symbols] and [definitions], in place of a paper's.
        at: The equation, id or section of a paper whose notation is meant: "32"; without `paper`, "chapter".
        seconds: The processor time for each judgement, beyond which it is `unchecked`; 20 by default.
        megabytes: The memory for each judgement; 4000 by default.

    Raises:
        ReadError: The formula cannot be read; a ValueError with line and column.
        PaperError: The paper or the notation cannot be used.
        ValueError: An argument makes no sense.

    What can be read but does not fit together gets the verdict `ill-formed`. Verdicts are remembered under
    WORKBENCH_CACHE, or where the system keeps such files.

    >>> from workbench import check
    >>> check(r"a \\times b = b \\times a", symbols={"a": "vector", "b": "vector"}).outcome
    <Outcome.REFUTED: 'refuted'>
    """
    from workbench.app.checked import check
    from workbench.runtime import Budget

    budget = Budget.of(seconds=seconds, megabytes=megabytes)
    return check(latex, symbols, paper, assume, orders, definitions, notation, at, budget)


def load_ipython_extension(shell: Any) -> None:
    """Makes %%check known to a notebook: `%load_ext workbench`."""
    from workbench.app.notebook_magic import register

    register(shell)
