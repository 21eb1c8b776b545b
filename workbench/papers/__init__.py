"""Paper files: the claims, symbols and definitions of a paper, as TOML files or texts state them.

What is this? The loaders of paper files, of notation tables and of texts with their models; `drafting`
guesses a model for a text. When do I come here? To add a key (core/schema.py) or a table. What may it import?
core, language, source, engines, drake, context, prover, repair. What checks it? tests/papers, tests/texts,
tests/ingest.

The loaders are imported on first use, because a single formula needs none of them.
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
