"""Rows of formulas and their verdicts: sections in text files, each with its symbols.

A row is `formula  ‖ assume: …  ‖ define: …  ‖ orders: …  ⟶  outcome for scope CODE`; what is not needed is left out.
A line `symbols: …` declares, as in a TOML table, what the rows below it are read with, and lines `define: …` behind
it give definitions of all these rows.

`python -m tests.verdict_rows FOLDER` writes the verdicts of today; the commit says why each changed one is right.
"""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from workbench import check
from workbench.core.codes.engine_codes import EngineCode
from workbench.core.formula_errors import ReadError, SpecError
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Verdict

ARROW, OPTION = "  ⟶  ", "  ‖ "


class Given(NamedTuple):
    """What rows are read with."""

    symbols: dict[str, Any]
    definitions: list[str]


class Section(NamedTuple):
    """name: what its rows have in common.   rows: what it is read with, the row and its verdict."""

    name: str
    rows: list[tuple[Given, str, str]]

    def told(self, said: Callable[[str, Given], str]) -> list[str]:
        """Returns the rows with the verdicts of today, as `said` tells them."""
        return [f"{row}{ARROW}{said(row, given)}" for given, row, _ in self.rows]

    def expected(self) -> list[str]:
        return [f"{row}{ARROW}{verdict}" for _, row, verdict in self.rows]


def sections(folder: Path) -> Iterator[Section]:
    """Yields the sections of all text files of the folder."""
    for path in sorted(folder.glob("*.txt")):
        yield from _sections_of(path)


def _sections_of(path: Path) -> Iterator[Section]:
    section, given = Section(path.stem, []), Given({}, [])
    for line in path.read_text(encoding="utf-8").splitlines():
        if ARROW in line:
            row, verdict = line.split(ARROW)
            section.rows.append((given, row, verdict))
        elif line.startswith("symbols: "):
            given = Given(tomllib.loads(f"symbols = {{ {line.removeprefix('symbols: ')} }}")["symbols"], [])
        elif line.startswith("define: "):
            given.definitions.append(line.removeprefix("define: "))
        elif line.startswith("["):
            if section.rows:
                yield section
            section = Section(f"{path.stem}: {line.strip('[]')}", [])
    yield section


def said_of(row: str, given: Given) -> str:
    """Returns the verdicts on the row's lines, or the code of what is wrong with it."""
    formula, *options = row.split(OPTION)
    pairs = [option.split(": ", 1) for option in options]
    assume, define, orders = (
        [text for key, text in pairs if key == name] for name in ("assume", "define", "orders")
    )
    try:
        definitions = [*given.definitions, *define]
        found = check(
            formula, given.symbols, assume=assume, definitions=definitions, orders=next(iter(orders), None)
        )
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


def main(folder: str, said: Callable[[str, Given], str] = said_of) -> None:
    for path in Path(folder).glob("*.txt"):
        text = path.read_text(encoding="utf-8")
        for section in _sections_of(path):
            for before, after in zip(section.expected(), section.told(said), strict=True):
                text = text.replace(f"\n{before}\n", f"\n{after}\n", 1)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
