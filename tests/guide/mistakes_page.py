"""The page "what it finds, misses, gets wrong", made from the recorded results of the public misprints.

`python -m tests.guide.mistakes_page` writes it."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from workbench.guide.pages import FOLDER

ERRATA = Path(__file__).parents[1] / "errata"
MEASURED = Path(__file__).parents[1] / "campaigns/public_texts/measured.json"
PAGE = FOLDER / "explanation" / "mistakes.md"
_KINDS = {"with a model": "With a model", "drafted": "Without a model: everything is guessed"}


def page() -> str:
    """Returns the page as Markdown."""
    recorded = json.loads((ERRATA / "expected.json").read_text(encoding="utf-8"))
    parts = [
        "# What it finds, misses and gets wrong",
        "Public misprints that people reported or corrected, judged as printed before the correction.",
        "*Decidable* means: the text says enough to show that the formula is false."
        " *Place* means: the false line is named, and no other.",
        "`uv run python -m tests.errata` measures the table again; it is made from tests/errata.",
    ]
    for kind, title in _KINDS.items():
        if rows := recorded.get(kind):
            parts += [f"## {title}", _summary(rows)]
    parts += ["## Public texts without a model", _TEXTS, _runs()]
    parts += [f"## Case by case\n\n{_table(recorded)}", _LIMITS]
    return "\n\n".join(parts) + "\n"


_LIMITS = """## What it gets wrong, by kind

- A text can be misread: the verdict is about `read as`, not about what the author meant.
- A guessed kind can be wrong; such a verdict is a warning and names the guess.
- A falsehood in a display that is not read stays silent. The summary counts these displays.
- A sentence that the lexicon does not know is not a fact.
- A first display `x = …` defines x where nothing else does, so an error in it shows only where x is used.
- Limits, integrals and series are not computed; of the first two the linearity is known."""


_TEXTS = """Texts on kinematics, rotations and robots from public repositories, by `workbench check` in 20 s each.
Each warning and error was looked at by eye; findings.tsv beside the list of the texts says which are right.
`python -m tests.campaigns.public_texts` measures them again."""

_COUNTS = ("texts", "judged", "displays", "formulas", "read", "decided", "ok", "note", "warning", "error")
_EYE = ("right", "wrong", "unclear", "out of time", "crashed", "seconds")


def _runs() -> str:
    """Returns the table of the campaigns on public texts; the columns are the campaigns."""
    runs = json.loads(MEASURED.read_text(encoding="utf-8"))["runs"]
    lines = ["| | " + " | ".join(run["name"] for run in runs) + " |", "|---" * (len(runs) + 1) + "|"]
    for key in (*_COUNTS, *_EYE):
        lines.append(f"| {key} | " + " | ".join(f"{run[key]:,}" for run in runs) + " |")
    return "\n".join(lines)


def _summary(rows: Sequence[Mapping[str, Any]]) -> str:
    decidable = [row for row in rows if row["decidable"]]
    found = [row for row in decidable if row["found"]]
    lines = [
        f"- Cases: {len(rows)}, of which {len(decidable)} are decidable.",
        f"- Found: {len(found)} of {len(decidable)}; at their place: {sum(row['place'] for row in found)}.",
        f"- Corrected as by the author: {sum(row['correction'] in ('first', 'among') for row in found)},"
        f" by the first proposal: {sum(row['correction'] == 'first' for row in found)};"
        f" otherwise: {sum(row['correction'] == 'other' for row in found)}.",
        f"- False alarms in the corrected texts: {sum(row['alarms'] for row in rows)}.",
    ]
    return "\n".join(lines)


def _table(recorded: Mapping[str, Sequence[Mapping[str, Any]]]) -> str:
    lines = ["| case | what is wrong | decidable | found | place | correction |", "|---|---|---|---|---|---|"]
    for row in recorded["with a model"]:
        with (ERRATA / row["name"] / "case.toml").open("rb") as file:
            wrong = " ".join(str(tomllib.load(file)["wrong"]).replace("|", "\\|").split())
        flags = " | ".join("yes" if row[key] else "–" for key in ("decidable", "found", "place"))
        lines.append(f"| {row['name']} | {wrong} | {flags} | {row['correction']} |")
    return "\n".join(lines)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
