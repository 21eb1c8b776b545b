"""Paper files: the claims of a paper, its symbols and its definitions, as TOML says them."""

from workbench.papers.load import (
    find_paper,
    installed_notation,
    load_installed,
    load_notation,
    load_paper,
    merge,
)
from workbench.papers.model import Claim, Formula, InstalledPaper, Notation, Paper, PaperError
from workbench.papers.orders import Orders

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
