"""Rows of formulas and their verdicts: sections in text files, each with its symbols.

A row is `formula  ‖ assume: …  ‖ define: …  ‖ orders: …  ⟶  outcome for scope CODE`; what is not needed is left out.
A line `symbols: …` declares, as in a TOML table, what the rows below it are read with.

`python -m tests.verdict_rows FOLDER` writes the verdicts of today; the commit says why each changed one is right.
"""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from workbench import check
from workbench.core.codes.engine_codes import EngineCode
from workbench.core.formula_errors import ReadError, SpecError
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Verdict

ARROW, OPTION = "  ⟶  ", "  ‖ "


class Section(NamedTuple):
    """name: what its rows have in common.   rows: the symbols, the row and its verdict."""

    name: str
    rows: list[tuple[dict[str, Any], str, str]]

    def told(self) -> list[str]:
        """Returns the rows with the verdicts of today."""
        return [f"{row}{ARROW}{said_of(row, symbols)}" for symbols, row, _ in self.rows]

    def expected(self) -> list[str]:
        return [f"{row}{ARROW}{verdict}" for _, row, verdict in self.rows]


def sections(folder: Path) -> Iterator[Section]:
    """Yields the sections of all text files of the folder."""
    for path in sorted(folder.glob("*.txt")):
        yield from _sections_of(path)


def _sections_of(path: Path) -> Iterator[Section]:
    section, symbols = Section(path.stem, []), {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if ARROW in line:
            row, verdict = line.split(ARROW)
            section.rows.append((symbols, row, verdict))
        elif line.startswith("symbols: "):
            symbols = tomllib.loads(f"symbols = {{ {line.removeprefix('symbols: ')} }}")["symbols"]
        elif line.startswith("["):
            if section.rows:
                yield section
            section = Section(f"{path.stem}: {line.strip('[]')}", [])
    yield section


def said_of(row: str, symbols: dict[str, Any]) -> str:
    """Returns the verdicts on the row's lines, or the code of what is wrong with it."""
    formula, *options = row.split(OPTION)
    pairs = [option.split(": ", 1) for option in options]
    assume, define, orders = (
        [text for key, text in pairs if key == name] for name in ("assume", "define", "orders")
    )
    try:
        found = check(formula, symbols, assume=assume, definitions=define, orders=next(iter(orders), None))
    except (ReadError, SpecError) as error:
        return f"refused {error.code.name}"
    except PaperError as error:
        return f"refused {error.reason.code.name}"
    return " ;; ".join(_told(each.verdict) for each in (found if isinstance(found, tuple) else [found]))


def _told(verdict: Verdict) -> str:
    scope = "" if verdict.scope is None else f" for {verdict.scope}"
    code = "" if verdict.code is None else f" {verdict.code.name}"
    general = f": {verdict.reason}" if verdict.code is EngineCode.NOT_EVALUATED else ""
    return f"{verdict.outcome}{scope}{code}{general}"


def parametrized(folder: Path) -> pytest.MarkDecorator:
    found = list(sections(folder))
    return pytest.mark.parametrize("section", found, ids=[each.name for each in found])


def main(folder: str) -> None:
    for path in Path(folder).glob("*.txt"):
        text = path.read_text(encoding="utf-8")
        for section in _sections_of(path):
            for before, after in zip(section.expected(), section.told(), strict=True):
                text = text.replace(f"\n{before}\n", f"\n{after}\n", 1)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
