"""The places where the symbols of a formula are defined: in the displays of its text, and in its model."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.app.pipeline.judged_files import Judged
from workbench.core.spans import Span

if TYPE_CHECKING:
    from workbench.core.names import Name
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.source.toml.toml_file import TomlFile

_SIGN = re.compile(r"\\[A-Za-z]+|[^\W\d_]")
_TABLES = ("symbols", "definitions")


def defining_places(judged: Judged, result: ClaimResult, sign: str = "") -> list[Span]:
    """Returns the places that define the symbols of a formula, in its text first.

    sign: a letter or command of a symbol; all symbols if none is written with it.
    """
    from workbench.context.free_symbols import names_in

    statement = result.claim.printed.statement
    if statement is None:
        return []
    names = names_in(statement)
    wanted = {name for name in names if sign in _SIGN.findall(str(name))} or names
    return [*_in_displays(judged, result, wanted), *_in_models(judged, wanted)]


def sign_at(line: str, column: int) -> str:
    """Returns the letter or the command at a position of a line, counted from 0; "" if there is none."""
    return next((each[0] for each in _SIGN.finditer(line) if each.start() <= column < each.end()), "")


def _in_displays(judged: Judged, asked: ClaimResult, names: set[Name]) -> Iterator[Span]:
    from workbench.context.facts import Act
    from workbench.context.formula_acts import act_of
    from workbench.report.findings import place_of

    for result in judged.results:
        act, symbol = act_of(result.claim.printed, result.claim.notation)
        is_wanted = symbol is not None and symbol.declaration.name in names
        if act is Act.DEFINE and is_wanted and result.claim.id != asked.claim.id:
            yield result.claim.context.span or place_of(result)


def _in_models(judged: Judged, names: set[Name]) -> Iterator[Span]:
    from workbench.core.formula_errors import SpecError
    from workbench.core.paper_errors import PaperError
    from workbench.language.naming.declarations import read_key
    from workbench.source.toml.toml_file import TomlFile

    for path in dict.fromkeys(
        (*judged.paper.paths, *(each.with_suffix(".toml") for each in judged.paper.paths))
    ):
        if path.suffix != ".toml" or not path.exists():
            continue
        try:
            toml = TomlFile(path)
        except PaperError:
            continue
        scopes = [("scope", place) for place, _ in enumerate(toml.data.get("scope", ()))]
        for table in ((*scope, part) for scope in ((), *scopes) for part in _TABLES):
            for key in toml.value(table, dict, {}):
                try:
                    name, *_ = read_key(key)
                except SpecError:
                    continue
                if name in names:
                    yield _of_key(path, toml, (*table, key))


def _of_key(path: Path, toml: TomlFile, key: tuple[str | int, ...]) -> Span:
    line, column = toml.places.of_key(key)
    return Span(path, line, column, line, column + len(str(key[-1])))
