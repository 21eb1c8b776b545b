"""One proposal for a model, and what the reader has with some of them."""

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
    """Entries of one table of a model, as TOML, and what they rest on. `stands`: kept unless it loses a
    formula; others, where formulas come further by it."""

    table: str
    entries: Mapping[str, str]
    why: str
    question: str
    trigger: re.Pattern[str]
    stands: bool = False


def tables_of(proposals: Sequence[Proposal]) -> dict[str, dict[str, tuple[str, str]]]:
    """Table → key → value as TOML, and why. Lists of one convention grow together."""
    tables: dict[str, dict[str, tuple[str, str]]] = {}
    for proposal in proposals:
        table = tables.setdefault(proposal.table, {})
        for key, value in proposal.entries.items():
            if key in table and value.startswith("["):
                value = f"{table[key][0][:-1]}, {value[1:]}"
            table[key] = (value, proposal.why)
    return tables


def ground_of(proposals: Sequence[Proposal]) -> SymbolTable:
    """The table that the reader has with these proposals alone. Raises PaperError."""
    lines = []
    for name, entries in tables_of(proposals).items():
        lines += [f"[{name}]", *(f"{key} = {value}" for key, (value, _) in entries.items())]
    return notation_of([TomlFile(Path("guessed"), "\n".join(lines) + "\n")]).symbols


def words_of(proposals: Sequence[Proposal]) -> frozenset[str]:
    """The functions that the text writes without a backslash."""
    texts = (p.entries["functions"] for p in proposals if "functions" in p.entries)
    return frozenset(re.findall(r"[a-z]+", " ".join(texts)))
