"""Proposals on a terminal, in the manner of `workbench.terminal`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from rich.text import Text

from workbench.terminal import outcome_text


def repair_lines(repair: Mapping[str, Any]) -> Iterator[Text]:
    """The proposals for one claim, by `Repair.to_dict`."""
    yield Text(repair["id"], style="bold")
    yield from _field("printed", repair["printed"])
    yield from proposal_lines(repair)
    if not repair["proposed"]:
        yield from _field("proposed", f"nothing, of {repair['candidates']} candidates")


def proposal_lines(claim: Mapping[str, Any]) -> Iterator[Text]:
    """What stands under the key "proposed" of a claim of the report."""
    for proposal in claim["proposed"]:
        yield from _field("proposed", proposal["latex"])
        yield from _field("edit", proposal["edit"])
        yield Text.assemble(" " * 17, outcome_text(proposal["verdict"]))


def _field(name: str, value: str) -> Iterator[Text]:
    yield Text(f"{name:>15}  {' '.join(value.split())}")
