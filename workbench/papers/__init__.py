"""Paper files: the claims of a paper, its symbols and its definitions, as TOML says them.

What loads them, with all that a claim file can say, comes on first use: a single formula needs none of it.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from workbench.context.claims import Claim, Formula, InstalledPaper, Notation, Paper
from workbench.context.index_values import Orders
from workbench.core.paper_errors import PaperError

if TYPE_CHECKING:
    from workbench.papers.load import (
        find_paper,
        installed_notation,
        load_installed,
        load_notation,
        load_paper,
        merge,
    )

__all__ = [
    "Claim",
    "Formula",
    "InstalledPaper",
    "Notation",
    "Orders",
    "Paper",
    "PaperError",
    "find_paper",
    "installed_notation",
    "load_installed",
    "load_notation",
    "load_paper",
    "merge",
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return getattr(import_module("workbench.papers.load"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
