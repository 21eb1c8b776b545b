"""Texts with a model, judged: what the tests of contexts share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Verdict
from workbench.papers import load_paper

KINDS = {"a": "vector", "b": "vector", "f": "scalar", "g": "scalar", "x": "scalar", "R": "rotation"}

#: Formulas about all vectors, scalars and rotations, and what an edit makes of them.
TRUE = [
    r"a \times b = -b \times a",
    r"(a + b) \cdot (a - b) = a \cdot a - b \cdot b",
    r"\frac{d}{dt} (f a) = \dot{f} a + f \dot{a}",
    r"R (a \times b) = (R a) \times (R b)",
    r"\cos^2 x + \sin^2 x = 1",
    r"f (g a) = g f a",
]
FALSE = [
    r"a \times b = b \times a",
    r"(a + b) \cdot (a + b) = a \cdot a + b \cdot b",
    r"\frac{d}{dt} (f a \cdot a) = \dot{f} a \cdot a + f \dot{a} \cdot a",
    r"R (a \times b) = (R a) \times b + R b - R b",
    r"\cos^2 x - \sin^2 x = 1",
    r"f (g + f) = f g + f",
]


def model(kinds: Mapping[str, str] = KINDS, more: str = "") -> str:
    """Returns the model of `p.md`, with symbols of these kinds."""
    symbols = "\n".join(f"'{name}' = \"{kind}\"" for name, kind in kinds.items())
    return f'source = "p.md"\n{more if more.startswith("[conv") else ""}[symbols]\n{symbols}\n' + (
        "" if more.startswith("[conv") else more
    )


def judged(folder: Path, text: str, of: str | None = None) -> list[Verdict]:
    """Returns the verdicts on the displays of a text, in their order."""
    (folder / "p.md").write_text(text, encoding="utf-8")
    (folder / "p.toml").write_text(model() if of is None else of, encoding="utf-8")
    paper = load_paper(folder / "p.toml", faults=[])
    assert not paper.faults, paper.faults
    return [result.verdict for result in judge_paper(paper, motions=False, jobs=1)]


def text_of(displays: Sequence[str], words: str = "We have") -> str:
    return "\n\n".join(f"{words}\n\n$$\n{display}\n$$" for display in displays) + "\n"


def seen(verdict: Verdict) -> tuple[object, ...]:
    """Returns what a change that does not matter leaves alone."""
    return verdict.outcome, verdict.grade, verdict.basis, verdict.reason, verdict.unless, verdict.hypothesis
