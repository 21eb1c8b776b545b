"""The table of the public misprints, its sums, and what it was before."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from errata_cases import Row

_HEAD = (
    f"{'case':6} {'decidable':9} {'read':>5} {'found':5} {'place':5} {'correction':10} {'alarms':>6} {'s':>6}"
)


def table(rows: Mapping[Row, float]) -> str:
    """The rows with their seconds, and the sums over the decidable cases."""
    lines = [_HEAD]
    for row, seconds in rows.items():
        flags = [_yes(flag) for flag in (row.decidable, row.found, row.place)]
        lines.append(
            f"{row.name:6} {flags[0]:9} {row.read:>5} {flags[1]:5} {flags[2]:5} {row.correction:10}"
            f" {row.alarms:>6} {seconds:>6.1f}"
        )
    return "\n".join([*lines, summary(list(rows))])


def summary(rows: Sequence[Row]) -> str:
    """How many of the decidable cases are found, at their place, corrected as by the author."""
    decidable = [row for row in rows if row.decidable]
    found = [row for row in decidable if row.found]
    place = sum(row.place for row in found)
    same = sum(row.correction in ("first", "among") for row in found)
    first = sum(row.correction == "first" for row in found)
    other = sum(row.correction == "other" for row in found)
    alarms = sum(row.alarms for row in rows)
    return (
        f"{len(rows)} cases, {len(decidable)} decidable: {len(found)} found, {place} at their place, "
        f"{same} corrected as by the author ({first} by the first proposal), {other} otherwise; {alarms} false alarms"
    )


def differences(rows: Sequence[Row], before: Mapping[str, Mapping[str, object]]) -> list[str]:
    """What is not as expected, line by line."""
    return [
        f"{row.name}: {key} is {value}, expected {before[row.name][key]}"
        for row in rows
        if row.name in before
        for key, value in row.to_dict().items()
        if before[row.name][key] != value
    ]


def expected(folder: Path, drafted: bool) -> dict[str, dict[str, object]]:
    """The frozen rows of a folder by name; none where nothing is frozen."""
    path = folder / "expected.json"
    if not path.exists():
        return {}
    rows = json.loads(path.read_text(encoding="utf-8")).get(_kind(drafted), [])
    return {row["name"]: row for row in rows}


def write_expected(folder: Path, drafted: bool, rows: Sequence[Row]) -> None:
    """Freezes the rows beside those of other cases."""
    path = folder / "expected.json"
    kept = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    named = expected(folder, drafted) | {row.name: row.to_dict() for row in rows}
    kept[_kind(drafted)] = [named[name] for name in sorted(named)]
    path.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def _kind(drafted: bool) -> str:
    return "drafted" if drafted else "with a model"


def _yes(flag: bool) -> str:
    return "yes" if flag else "-"
