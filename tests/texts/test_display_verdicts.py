"""Verdicts on displays whose layout, conditions and reasons decide what they state."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import told
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers.load import load_paper

MODEL = r"""
source = "x.tex"
[symbols]
a = "vector"
b = "vector"
c = "vector"
f = "scalar"
g = "scalar"
h = "scalar"
x = "scalar"
y = "scalar"
T = "tensor"
R = "rotation"
u = { kind = "vector", unit = true }
"""
TRUE, FALSE = {"proved"}, {"refuted"}
OPEN = {"unchecked", "said", "doubtful", "conditional"}


def verdicts(tmp_path: Path, body: str) -> dict[str, set[str]]:
    """The verdicts on the claims, by the label of each."""
    (tmp_path / "x.tex").write_text(f"\\begin{{document}}\n{body}\n\\end{{document}}\n")
    (tmp_path / "x.toml").write_text(MODEL)
    found: dict[str, set[str]] = {}
    for result in judge_paper(load_paper(tmp_path / "x.toml")):
        label = result.claim.id.partition(".")[0]
        found.setdefault(label, set()).add(told(result.verdict))
    return found


DISPLAYS = {
    r"""\begin{align} & u \cdot \dot{u} = 0 \label{x} \\ & -u \cdot \ddot{u} = \dot{u}^2 \label{y} \end{align}""": {"x": TRUE, "y": TRUE},
    r"""\begin{flalign} & u \cdot \dot{u} = 0 \label{x} \\ & -u \cdot \ddot{u} = \dot{u}^2 \label{y} \end{flalign}""": {"x": TRUE, "y": TRUE},
    r"""\begin{equation}\label{x}\begin{split} & u \cdot \dot{u} = 0 \\ & -u \cdot \ddot{u} = \dot{u}^2 \end{split}\end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x}\begin{cases} & u \cdot \dot{u} = 0 \\ & -u \cdot \ddot{u} = \dot{u}^2 \end{cases}\end{equation}""": {"x": TRUE},
    r"""\begin{align} & (f + g)^2 = f^2 + 2 f g + g^2 \label{x} \\ & - (f - g)^2 = - f^2 + 2 f g - g^2 \label{y} \end{align}""": {"x": TRUE, "y": TRUE},
    r"""\begin{align} & \dot{R} R^T + R \dot{R}^T = 0 \label{x} \\ & -\frac{d}{dt}(R^T) = R^T \dot{R} R^T \label{y} \end{align}""": {"x": TRUE, "y": TRUE},
    r"""\begin{align} & (a + b)^2 = a^2 + 2 a \cdot b \label{x} \\ & + b^2 = b \cdot b \label{y} \end{align}""": {"x": FALSE},
    r"""\begin{equation}\label{x} [f \quad -g] \begin{bmatrix} x \\ y \end{bmatrix} = f x - g y \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} [f \; g] [x \; y]^T = f x + g y \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} \begin{pmatrix} f \; -g \end{pmatrix} \begin{pmatrix} x \\ y \end{pmatrix} = f x - g y \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{where } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{with } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{given that } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{whenever } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{because } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{as } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{using } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \text{such that } a \cdot b = 0 \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \quad \forall a \perp b \end{equation}""": {"x": TRUE},
    r"""\begin{align} (a+b)^2 &= a^2+b^2 && (a \perp b) \label{x}\end{align}""": {"x": TRUE},
    r"""\begin{align} (a+b)^2 &= a^2+b^2 && \text{along the axis} \label{x}\end{align}""": {"x": OPEN},
    r"""\begin{align} (a+b)^2 &= a^2 + 2 a \cdot b + b^2 \\ &= a^2 + b^2 \quad \text{(since } a \cdot b = 0\text{)} \label{x}\end{align}""": {"x": TRUE},
    r"""\begin{align} (a+b)^2 &= a^2 + 2 a \cdot b + b^2 \\ &= a^2 + b^2 && \text{because $a \cdot b = 0$} \label{x}\end{align}""": {"x": TRUE},
    r"""\begin{align} (a+b)^2 &= a^2 + 2 a \cdot b + b^2 \\ \intertext{and, as $a \cdot b = 0$,} &= a^2 + b^2 \label{x}\end{align}""": {"x": TRUE},
    r"""\begin{align} (a+b)^2 &= a^2 + \cancel{2 a \cdot b} + b^2 = a^2 + b^2 \label{x}\end{align}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a+b)^2 = a^2 + b^2, \end{equation}
because the two vectors are perpendicular.""": {"x": OPEN},
    r"""\begin{align} (a+b)^2 &= a^2 + 2 a \cdot b + b^2 \\ &= a^2 + b^2 \tag{since $a \cdot b = 0$} \label{x}\end{align}""": {"x": TRUE},
    r"""\begin{equation}\label{x}\begin{array}{rcrcl} a \cdot b & + & b \cdot a & = & 2 a \cdot b \\ (a + b)^2 & - & a^2 & = & 2 a \cdot b + b^2 \end{array}\end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x}\begin{array}{rcrcr} (f + g)^2 & - & f^2 & = & 2 f g + g^2 \end{array}\end{equation}""": {"x": TRUE},
    r"""\begin{alignat}{2} (a + b)^2 & = a^2 + b^2 && + 2 a \cdot b \label{x} \\ (a - b)^2 &= a^2 + b^2 && - 2 a \cdot b \label{y}\end{alignat}""": {"x": TRUE, "y": TRUE},
    r"""\begin{alignat}{2} (a + b)^2 & = a^2 + 2 a \cdot b + b^2 && + f \label{x}\end{alignat}""": {"x": OPEN},
    r"""\begin{equation}\label{x} c + a \times b \overset{\circ}{f} g = c + a \times b \overset{\circ}{f} g \end{equation}""": {"x": OPEN},
    r"""\begin{equation}\label{x} \text{Wrong: } a \times b = - b \times a \end{equation}""": {"x": OPEN},
}  # fmt: skip


@pytest.mark.parametrize("body", DISPLAYS)
def test_a_display_has_the_verdict_of_what_it_states(tmp_path: Path, body: str) -> None:
    found = verdicts(tmp_path, body)
    for label, wanted in DISPLAYS[body].items():
        assert label in found and found[label] <= wanted, found


BESIDE = [
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad a \cdot b = 0 \end{equation}""",
    r"""\begin{equation}\label{x}\begin{cases} (a + b)^2 = a^2 + b^2, & a \cdot b = 0 \\ (a - b)^2 = a^2 + b^2, & b \cdot a = 0 \end{cases}\end{equation}""",
]  # fmt: skip


@pytest.mark.parametrize("body", BESIDE)
def test_an_equation_beside_a_formula_may_be_its_condition(tmp_path: Path, body: str) -> None:
    found = verdicts(tmp_path, body)
    assert "proved" not in found["x"]
    claims = load_paper(tmp_path / "x.toml").claims
    assert [claim.ambiguity.perhaps[0].latex for claim in claims[::2]] == [
        claim.printed.latex for claim in claims[1::2]
    ]


WITH_A_SUM = [body for body in DISPLAYS if "a^2 + b^2" in body or "a^2+b^2" in body]


@pytest.mark.parametrize("body", WITH_A_SUM)
def test_a_false_formula_is_not_proved_by_what_is_beside_it(tmp_path: Path, body: str) -> None:
    wrong = body.replace("a^2 + b^2", "a^2 - b^2").replace("a^2+b^2", "a^2-b^2")
    found = verdicts(tmp_path, wrong)
    is_limited = DISPLAYS[body]["x"] == OPEN
    assert found["x"] <= OPEN | FALSE if is_limited else "refuted" in found["x"]
