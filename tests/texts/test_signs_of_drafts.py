"""Texts without a model whose signs a draft must understand: a true and a false display of each."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade
from workbench.papers.drafting.judged_draft import on_drafted_kinds

TEXTS = {
    "cross behind in a bracket": (
        r"[\mathbf{a} \times] \mathbf{b} = -[\mathbf{b} \times] \mathbf{a}",
        r"[\mathbf{a} \times] \mathbf{b} = \mathbf{b} \times \mathbf{a}",
    ),
    "cross behind a sum": (
        r"\lfloor \mathbf{a} + \mathbf{c} \times \rfloor \mathbf{b} = \mathbf{a} \times \mathbf{b} + \mathbf{c} \times \mathbf{b}",
        r"\lfloor \mathbf{a} + \mathbf{c} \times \rfloor \mathbf{b} = \mathbf{a} \times \mathbf{b} - \mathbf{c} \times \mathbf{b}",
    ),
    "upright differential": (
        r"\mathrm{d}(x y) = x\, \mathrm{d}y + y\, \mathrm{d}x",
        r"\mathrm{d}(x y) = x\, \mathrm{d}y - y\, \mathrm{d}x",
    ),
    "italic differential": (r"d(x y) = x\, dy + y\, dx", r"d(x y) = x\, dy - y\, dx"),
    "distance": ("d x + d y = d (x + y)", "d x + d y = d (x + y) + x"),
    "gradient by several": (
        r"\nabla_{x,y} (x^2 y) = \begin{bmatrix} 2 x y \\ x^2 \end{bmatrix}",
        r"\nabla_{x,y} (x^2 y) = \begin{bmatrix} 2 x y \\ x \end{bmatrix}",
    ),
    "integral": (
        r"\int \mathbf{a} \times \mathbf{b}\, dm = -\int \mathbf{b} \times \mathbf{a}\, dm",
        r"\int \mathbf{a} \times \mathbf{b}\, dm = \int \mathbf{b} \times \mathbf{a}\, dm",
    ),
}


@pytest.mark.parametrize("name", TEXTS)
def test_true_display_holds_and_false_one_is_found(name: str, tmp_path: Path) -> None:
    displays = "\n\n".join(f"$$ {formula} $$" for formula in TEXTS[name])
    path = tmp_path / "p.md"
    path.write_text(f"We have\n\n{displays}\n", encoding="utf-8")
    draft = draft_of(path)
    right, wrong = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False, jobs=1))
    assert right.shown is Grade.OK
    assert wrong.shown is Grade.WARNING
