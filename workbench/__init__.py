"""Checks the printed formulas of kinematics papers: LaTeX in, exact verdict and evidence out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbench.api import judge, load, repair, report
    from workbench.checked import Checked, CheckedLines
    from workbench.judge.verdict import Counterexample, Outcome, Verdict
    from workbench.kinematics import Robot
    from workbench.language.typed.errors import ReadError
    from workbench.papers import Claim, Paper, PaperError
    from workbench.repair.propose.repair import Repair
    from workbench.verify.results import ClaimResult

__all__ = [
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
    "check",
    "judge",
    "load",
    "repair",
    "report",
]

#: Where each public name is defined; it is imported at its first use. judge, repair and report are packages,
#: too, and callable.
_PLACES = {
    "Checked": "workbench.checked",
    "CheckedLines": "workbench.checked",
    "Claim": "workbench.papers.model",
    "ClaimResult": "workbench.verify.results",
    "Counterexample": "workbench.judge.verdict",
    "Outcome": "workbench.judge.verdict",
    "Paper": "workbench.papers.model",
    "PaperError": "workbench.papers.model",
    "ReadError": "workbench.language.typed.errors",
    "Repair": "workbench.repair.propose.repair",
    "Robot": "workbench.kinematics",
    "Verdict": "workbench.judge.verdict",
    "load": "workbench.api",
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name == "__version__":
        from importlib.metadata import version

        return version("kinematics-workbench")
    if name in _PLACES:
        return getattr(import_module(_PLACES[name]), name)
    if name in ("judge", "repair", "report"):
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

    latex: an equation; several lines (aligned, cases) give several verdicts.
    symbols: LaTeX → what it is, as in a paper file, or just its kind: {r"u": "vector"}; weightless then.
    paper: whose notation is meant: a paper file, an installed paper's name, or a Paper. If neither is given,
        the notation is that of the installed paper "chapter"; if both are, `symbols` come after the paper's.
    assume: relations (= or \\neq) to be assumed.   orders: the values of the indices, such as "n = 1..8".
    definitions: what more symbols stand for, in order, each by what is known before it, recurrences too:
        {r"K": r"a \\times b"} or [r"K = a \\times b"].
    notation: a TOML file with [symbols] and [definitions] (claims are not needed), in place of a paper's.
    at: the equation, id or section of the paper whose notation is meant, where its files have symbols of
        their own: "32".
    seconds, megabytes: of processor time and memory for each judgement, beyond which the verdict is
        `unchecked`; 20 s and 4000 MB if neither is given.

    What was judged before by this version is not judged again; it is kept under WORKBENCH_CACHE, or where
    the system keeps such files.

    Raises ReadError (a ValueError, with line and column) for what cannot be read, PaperError for a paper that
    cannot be used, and ValueError for arguments that say nothing. What can be read but makes no sense gets
    the verdict `ill-formed`.
    """
    from workbench.budget import Budget
    from workbench.checked import check

    budget = Budget.of(seconds=seconds, megabytes=megabytes)
    return check(latex, symbols, paper, assume, orders, definitions, notation, at, budget)
