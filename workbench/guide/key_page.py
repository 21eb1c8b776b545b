"""The reference of the keys of paper files and models, made from the schema."""

from __future__ import annotations

from workbench.core.schema import SCHEMA, Key

_TITLES = {
    "paper file": "A paper file: the top level",
    "notation file": "A notation file",
    "model": "A model of a text: the top level",
    "directive": "A comment in a text: `%! workbench: KEY = VALUE`",
    "symbol": "A symbol: `[symbols]`",
    "notation entry": "A spelling: `[notation]`",
    "conventions": "`[conventions]`",
    "frames": "`[frames]`",
    "points": "`[points]`",
    "motion robot": "`[motion.robot]`",
    "motion claim": "`[motion.claims.'ID']`",
    "budget": "`[budget]`",
    "citation": "`[citation]`",
    "claim of a paper file": "A claim of a paper file: `[[claim]]`",
    "claim of a model": "A claim of a model: `[[claim]]`",
    "scope": "A scope of a model: `[[scope]]`",
}


def key_page() -> str:
    """Returns one table for each place where keys may stand."""
    parts = [
        "# Model keys",
        "Every key of a paper file, of a model and of a notation file: its type, its meaning, an example.",
        "A key that is not listed is an error; the message names the closest known key.",
        "In `[symbols]`, `[definitions]`, `[notation]` and `[motion]` the keys are the author's LaTeX.",
    ]
    for table, keys in SCHEMA.items():
        rows = [_row(key) for key in keys]
        parts.append(
            f"## {_TITLES[table]}\n\n| key | type | meaning | example |\n|---|---|---|---|\n"
            + "\n".join(rows)
        )
    return "\n\n".join(parts) + "\n"


def _row(key: Key) -> str:
    choices = " or ".join(f'`"{each}"`' for each in key.choices)
    meaning = f"{key.meaning} Values: {choices}." if choices else key.meaning
    example = f"`{key.example}`" if key.example else ""
    return " | ".join([f"| `{key.name}`", key.type, meaning.replace("|", "\\|"), f"{example} |"])
