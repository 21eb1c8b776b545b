"""Checks the printed formulas of kinematics papers: LaTeX in, exact verdict and evidence out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbench.checked import Checked, CheckedLines
    from workbench.papers import Paper

__all__ = ["check"]


def check(
    latex: str,
    symbols: Mapping[str, str | Mapping[str, Any]] | None = None,
    paper: Paper | Path | str | None = None,
    assume: Sequence[str] = (),
    orders: str | None = None,
) -> Checked | CheckedLines:
    """The verdict on a printed formula, which displays itself in Jupyter and on a terminal.

    latex: an equation; several lines (aligned, cases) give several verdicts.
    symbols: LaTeX → what it is, as in a paper file, or just its kind: {r"u": "vector"}; weightless then.
    paper: whose notation is meant: a paper file, an installed paper's name, or a Paper. If neither is given,
        the notation is that of the installed paper "chapter"; if both are, `symbols` come after the paper's.
    assume: relations (= or \\neq) to be assumed.   orders: the values of the indices, such as "n = 1..8".

    Raises ReadError (a ValueError, with line and column) for what cannot be read, and PaperError for a paper
    that cannot be used. What can be read but makes no sense gets the verdict `ill-formed`.
    """
    from workbench.checked import check

    return check(latex, symbols, paper, assume, orders)
