"""The reference of spellings that are read, made from spellings.toml."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

_DATA = Path(__file__).parent / "spellings.toml"


@dataclass(frozen=True)
class Spelling:
    """A spelling with a formula that uses it.

    Attributes:
        written: The spelling.
        meaning: In words.
        example: A formula.
        symbols: Those of the example.
        outcome: The verdict on the example.
        only_in_texts: Whether only texts support it, not `check`.
    """

    group: str
    written: str
    meaning: str
    example: str
    symbols: dict[str, Any]
    outcome: str
    only_in_texts: bool


def spellings() -> Iterator[Spelling]:
    """Yields the rows of spellings.toml."""
    with _DATA.open("rb") as file:
        for row in tomllib.load(file)["spelling"]:
            yield Spelling(
                row["group"], row["written"], row["meaning"], row["example"],
                row.get("symbols", {}), row.get("outcome", "proved"), row.get("only_in_texts", False),
            )  # fmt: skip


def spelling_page() -> str:
    """Returns one table for each group of spellings."""
    rows = list(spellings())
    parts = ["# Spellings", "What authors write, and what it is read as: one example a row."]
    for group in dict.fromkeys(row.group for row in rows):
        table = ["| written | means | example |", "|---|---|---|"]
        table += [
            " | ".join(
                [
                    f"| `{_cell(r.written)}`",
                    r.meaning + " (in texts)" * r.only_in_texts,
                    f"`{_cell(r.example)}` |",
                ]
            )
            for r in rows
            if r.group == group
        ]
        parts.append(f"## {group}\n\n" + "\n".join(table))
    return "\n\n".join(parts) + "\n"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")
