"""The codes that the example of an entry of messages.toml gives."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from tests.guide.example_blocks import folder_of, run
from workbench import check
from workbench.app.pipeline.judged_files import judged_file
from workbench.core.code_labels import label
from workbench.core.reasons import Reason
from workbench.papers import PaperError

#: The keys of an entry that make an example.
EXAMPLES = ("example", "text", "paper", "command", "python")


def told_codes(entry: Mapping[str, Any], folder: Path) -> set[str]:
    """Returns the labels of all reasons that the example gives, in verdicts or in an error."""
    if "command" in entry:
        _write(entry, folder)
        with folder_of(folder):
            return set(re.findall(r"\[(WB-[\w-]+)\]", "\n".join(run(entry["command"]))))
    if "python" in entry:
        _write(entry, folder)
        with folder_of(folder):
            found = _of_session(entry["python"])
    else:
        found = _of_formula(entry, folder) if "example" in entry else _of_file(_write(entry, folder))
    return {label(code) for reason in found for code in reason.codes}


def _of_session(source: str) -> list[Reason]:
    """Returns the reasons in what the Python lines call `found`, or those of their error."""
    names: dict[str, Any] = {}
    try:
        exec(source, names)  # of our own messages.toml
    except ValueError as error:
        return list(_reasons(list(error.args)))
    return list(_reasons(names["found"]))


def _of_formula(entry: Mapping[str, Any], folder: Path) -> list[Reason]:
    given: dict[str, Any] = {key: entry[key] for key in ("symbols", "definitions", "assume") if key in entry}
    if "notation" in entry:
        given["notation"] = folder / "notation.toml"
        given["notation"].write_text(entry["notation"], encoding="utf-8")
    try:
        found = check(entry["example"], **given)
    except ValueError as error:
        return list(_reasons((*error.args, *vars(error).values())))
    return list(_reasons([each.verdict for each in (found if isinstance(found, tuple) else [found])]))


def _write(entry: Mapping[str, Any], folder: Path) -> Path:
    """Writes the files of the example: paper.toml, or paper.md with paper.toml as its model."""
    text, model = folder / "paper.md", folder / "paper.toml"
    if "text" in entry:
        text.write_text(entry["text"], encoding="utf-8")
    if toml := entry.get("paper", entry.get("model")):
        model.write_text(toml, encoding="utf-8")
    return text if "text" in entry else model


def _of_file(path: Path) -> list[Reason]:
    try:
        judged = judged_file(path, motions="[motion]" in path.read_text(encoding="utf-8"))
    except PaperError as error:
        return list(_reasons([fault.reason for fault in error.faults]))
    results = [(*each.verdicts.values(), each.why_not, each.claim.printed) for each in judged.results]
    return list(_reasons((results, [fault.reason for fault in judged.paper.faults])))


def _reasons(value: Any) -> Iterator[Reason]:
    """Yields the reasons in a value, in its items and its fields."""
    if isinstance(value, Reason):
        yield value
    elif isinstance(value, list | tuple):
        for each in value:
            yield from _reasons(each)
    elif is_dataclass(value):
        yield from _reasons([getattr(value, field.name) for field in fields(value)])
