"""A proposal for a model, and the notation that several proposals give."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbench.language.naming.symbols import SymbolTable
from workbench.papers.notation_tables import notation_of
from workbench.source.toml.toml_file import TomlFile


@dataclass(frozen=True)
class Proposal:
    """Entries of one table of a model as TOML, with their reason.

    Attributes:
        stands: Whether the proposal is kept unless it loses a formula. Other proposals are kept only if they
            make more formulas readable.
    """

    table: str
    entries: Mapping[str, str]
    why: str
    question: str
    trigger: re.Pattern[str]
    stands: bool = False


def tables_of(proposals: Sequence[Proposal]) -> dict[str, dict[str, tuple[str, str]]]:
    """Returns table → key → (TOML value, reason). Lists of one convention are merged."""
    tables: dict[str, dict[str, tuple[str, str]]] = {}
    for proposal in proposals:
        table = tables.setdefault(proposal.table, {})
        for key, value in proposal.entries.items():
            if key in table and value.startswith("["):
                value = f"{table[key][0][:-1]}, {value[1:]}"
            table[key] = (value, proposal.why)
    return tables


def ground_of(proposals: Sequence[Proposal]) -> SymbolTable:
    """Returns the symbol table that these proposals alone give. Raises PaperError."""
    lines = []
    for name, entries in tables_of(proposals).items():
        lines += [f"[{name}]", *(f"{key} = {value}" for key, (value, _) in entries.items())]
    return notation_of([TomlFile(Path("guessed"), "\n".join(lines) + "\n")]).symbols


def words_of(proposals: Sequence[Proposal]) -> frozenset[str]:
    """Returns the functions that the text writes without a backslash."""
    texts = (p.entries["functions"] for p in proposals if "functions" in p.entries)
    return frozenset(re.findall(r"[a-z]+", " ".join(texts)))
