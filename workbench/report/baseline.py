"""Baselines: findings that are already known, identified by the displayed formula, not by its line."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path

from workbench.papers import PaperError
from workbench.prover.results.claim_results import ClaimResult
from workbench.report.findings import place_of
from workbench.source.toml.file_bytes import file_bytes

_MOST_BYTES = 20_000_000
_EXPECTED = "a baseline that `workbench check --write-baseline` wrote"


@dataclass(frozen=True, order=True)
class Known:
    """A known finding.

    Attributes:
        file: Relative to the folder of the baseline.
        formula: As printed, without blanks.
    """

    file: str
    formula: str
    verdict: str
    grade: str


def known_of(result: ClaimResult, folder: Path) -> Known | None:
    """Returns a result as a finding; None if there is no fault."""
    if not result.is_wrong:
        return None
    file = os.path.relpath(place_of(result).file.resolve(), folder.resolve())
    return Known(Path(file).as_posix(), content_of(result), str(result.verdict.outcome), str(result.shown))


def content_of(result: ClaimResult) -> str:
    """Returns the displayed formula without blanks."""
    return " ".join((result.claim.shown or result.claim.id).split())


def all_known(results: Iterable[ClaimResult], folder: Path) -> Counter[Known]:
    """Returns the findings with their multiplicities."""
    return Counter(known for result in results if (known := known_of(result, folder)) is not None)


def as_known(results: Sequence[ClaimResult], known: Counter[Known], folder: Path) -> list[ClaimResult]:
    """Returns the results with known ones marked, and removes these from `known`."""
    made = []
    for result in results:
        own = known_of(result, folder)
        is_known = own is not None and known[own] > 0
        if is_known and own is not None:
            known[own] -= 1
        made.append(replace(result, known=True) if is_known else result)
    return made


def baseline_text(known: Counter[Known]) -> str:
    """Returns the content of a baseline; equal findings give equal bytes."""
    entries = [asdict(each) for each in sorted(known.elements())]
    return json.dumps({"version": 1, "known": entries}, ensure_ascii=False, indent=2) + "\n"


def read_baseline(path: Path) -> Counter[Known]:
    """Returns the findings of a baseline file. Raises PaperError if it is none."""
    try:
        data = json.loads(file_bytes(path, _EXPECTED, _MOST_BYTES))
        names = {each.name for each in fields(Known)}
        if data["version"] == 1 and all(_is_entry(each, names) for each in data["known"]):
            return Counter(Known(**each) for each in data["known"])
    except PaperError:
        raise
    except (ValueError, LookupError, TypeError, RecursionError):
        pass
    raise PaperError(path, None, None, f"expected {_EXPECTED}")


def _is_entry(entry: dict[str, object], names: set[str]) -> bool:
    return set(entry) == names and all(isinstance(value, str) for value in entry.values())
