"""Numbers of claims by outcome, and versions of the software: the same in every report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from importlib.metadata import version

from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.motion_summary import ALGEBRA
from workbench.report.shown_kinds import VERDICTS

_PACKAGES = {
    "workbench": "kinematics-workbench",
    "drake": "drake",
    "python-flint": "python-flint",
    "sympy": "sympy",
    "numpy": "numpy",
}


def versions() -> dict[str, str]:
    """Returns the versions of the workbench and of the libraries that decide verdicts."""
    return {name: version(package) for name, package in _PACKAGES.items()}


def summary(results: Sequence[ClaimResult]) -> dict[str, int]:
    """Returns the number of claims with each verdict."""
    counts: Counter[str] = Counter(result.verdict.outcome for result in results)
    return {name: counts[name] for name in VERDICTS if counts[name]}


def witness_counts(results: Sequence[ClaimResult]) -> dict[str, int]:
    """Returns the number of claims that were evaluated on Drake's motions, have no motion, or were not for
    another reason."""
    counts = Counter(result.on_motions.witness for result in results)
    return {name: counts[name] for name in ("Drake", ALGEBRA, "none")}
