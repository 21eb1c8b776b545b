"""Claim ids of the sibling files of a paper file, for references between files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from workbench.core.paper_errors import PaperError
from workbench.papers.installed_papers import paper_of
from workbench.source.rows.formula_lines import split_lines
from workbench.source.toml.toml_file import TomlFile


def sisters_of(file: Path) -> tuple[Path, ...]:
    """Returns the other files of the installed paper that contains `file`, and files in its folder with the
    same notation file."""
    shared = _notation_name(file)
    beside = sorted(file.resolve().parent.glob("*.toml")) if shared else []
    files = [*paper_of(file).files, *(path for path in beside if _notation_name(path) == shared)]
    found = dict.fromkeys(path.resolve() for path in files)
    return tuple(path for path in found if path != file.resolve())


def claim_ids(files: Sequence[Path]) -> dict[str, list[str]]:
    """Returns each id of a claim table in the files → the ids of its claims, one for each printed line."""
    return {name: parts for file in files for name, parts in _ids(file)}


def _ids(file: Path) -> Iterator[tuple[str, list[str]]]:
    claims = _data(file).get("claim")
    for claim in claims if isinstance(claims, list) else ():
        if not isinstance(claim, dict):
            continue
        name, printed = claim.get("id"), claim.get("formula") or claim.get("printed")
        if isinstance(name, str) and isinstance(printed, str):
            lines = 1 if "theorem" in claim or "goal" in claim else len(split_lines(printed))
            parts = [name] if lines == 1 else [f"{name}.{number}" for number in range(1, lines + 1)]
            yield from ((part, [part]) for part in parts)
            yield name, parts
        elif isinstance(name, str):
            yield name, [name]


def _notation_name(file: Path) -> str | None:
    return _data(file).get("notation")


def _data(file: Path) -> dict:
    """Returns the content of the file; empty if it is no TOML, and thus has no claims to refer to."""
    try:
        return TomlFile(file).data
    except PaperError:
        return {}
