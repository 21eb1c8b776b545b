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
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{with }\begin{gathered} a \cdot b = 0 \\ f = g \end{gathered} \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{with }\begin{cases} a \cdot b = 0 \\ f = g \end{cases} \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{with }\begin{array}{l} a \cdot b = 0 \\ f = g \end{array} \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{with }\substack{ a \cdot b = 0 \\ f = g } \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{where }\begin{gathered} a \cdot b = 0 \\ f = g \end{gathered} \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{where }\begin{cases} a \cdot b = 0 \\ f = g \end{cases} \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{where }\begin{array}{l} a \cdot b = 0 \\ f = g \end{array} \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \text{where }\substack{ a \cdot b = 0 \\ f = g } \end{equation}""": {"x": TRUE},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \begin{gathered} a \cdot b = 0 \\ f = g \end{gathered} \end{equation}""": {"x": OPEN},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \begin{cases} a \cdot b = 0 \\ f = g \end{cases} \end{equation}""": {"x": OPEN},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \begin{array}{l} a \cdot b = 0 \\ f = g \end{array} \end{equation}""": {"x": OPEN},
    r"""\begin{equation}\label{x} (a + b)^2 = a^2 + b^2, \quad \substack{ a \cdot b = 0 \\ f = g } \end{equation}""": {"x": OPEN},
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


#: What prints no sign before a sign: empty groups, spaces without braces, commands of spacing and numbers.
LEADS = [
    "{}", "{} ", r"\quad{}", r"\negmedspace {}", r"\null", r"\relax", r"\hskip 1em ", r"\kern 3pt ", r"\mskip-2mu",
    r"\mathrel{\phantom{=}}", r"\phantom{=}{}", r"\hphantom{{}={}}", r"\mbox{}", r"\strut", r"\nonumber{}",
]  # fmt: skip
SPLITS = [
    r"\begin{align} (f - g)^2 &= f^2 - 2 f g \\ & % + g^2 \label{x} \end{align}",
    r"\begin{eqnarray} (f - g)^2 &=& f^2 - 2 f g \\ && % + g^2 \label{x} \end{eqnarray}",
    r"\begin{IEEEeqnarray}{rCl} (f - g)^2 &=& f^2 - 2 f g \IEEEeqnarraynumspace\\ && % + g^2 \label{x} \end{IEEEeqnarray}",
    r"\begin{equation}\label{x}\begin{split} (f - g)^2 ={} & f^2 - 2 f g \\ & % + g^2 \end{split}\end{equation}",
    r"\begin{multline}\label{x} (f - g)^2 = f^2 - 2 f g \\ % + g^2 \end{multline}",
]


@pytest.mark.parametrize("split", SPLITS)
@pytest.mark.parametrize("lead", LEADS)
def test_a_row_that_begins_with_a_sign_goes_on(tmp_path: Path, split: str, lead: str) -> None:
    assert list(verdicts(tmp_path, split.replace("%", lead)).values()) == [TRUE]
    assert FALSE in verdicts(tmp_path, split.replace("%", lead).replace("+ g^2", "- g^2")).values()


BOXES = [
    r"\resizebox{.9\hsize}{!}{$%$}", r"\scalebox{0.8}{$\displaystyle %$}", r"\tcboxmath{%}", r"\boxed{%}",
    r"\fcolorbox{red}{white}{$%$}", r"\mathcolor{blue}{%}", r"\parbox{5cm}{\(%\)}", r"\colorbox[rgb]{1,0,0}{$%$}",
]  # fmt: skip


@pytest.mark.parametrize("box", BOXES)
def test_a_box_around_a_formula_changes_nothing(tmp_path: Path, box: str) -> None:
    for formula, wanted in ((r"a \times b = b \times a", FALSE), (r"a \cdot b = b \cdot a", TRUE)):
        assert verdicts(
            tmp_path, f"\\begin{{equation}}\\label{{x}} {box} \\end{{equation}}".replace("%", formula)
        ) == {"x": wanted}


@pytest.mark.parametrize("box", [r"\parbox{4cm}{%}", r"\scalebox{0.7}{%}", r"\resizebox{2cm}{!}{%}"])
def test_words_in_a_box_are_words(tmp_path: Path, box: str) -> None:
    begins = r"\begin{equation}\label{x} a \times b = b \times a \quad "
    for words, wanted in (("for all $f$", FALSE), ("if $a = 0$", TRUE), ("(a law)", FALSE)):
        body = begins + box.replace("%", words) + r"\end{equation}"
        assert verdicts(tmp_path, body)["x"] == wanted, words


#: Words before another row that end like a condition, and state none.
PRESENTING = [
    "After some algebra one arrives at", "Simplifying, we end up with", "This leaves us with", "which can be written as",
    "The right side is given by", "This is the same as", "Equivalently, it reads as", "We may conclude with", "that can be expressed as",
]  # fmt: skip


@pytest.mark.parametrize("words", PRESENTING)
def test_a_verb_before_a_row_makes_no_condition_of_it(tmp_path: Path, words: str) -> None:
    rows = (
        rf"a \times b &= -b \times a \label{{x}} \\ \intertext{{{words}}} a \cdot b &= -b \cdot a \label{{y}}"
    )
    assert verdicts(tmp_path, rf"\begin{{align}} {rows} \end{{align}}") == {"x": TRUE, "y": FALSE}


@pytest.mark.parametrize(
    "caption", [r"\caption{%}", r"\caption[The case]{%}", r"\captionof{figure}{{\bf Case} %}"]
)
def test_a_caption_speaks_of_its_picture(tmp_path: Path, caption: str) -> None:
    said = caption.replace("%", "For $a \\cdot b = 0$ the lengths add.")
    display = r"\begin{equation}\label{x} (a + b)^2 = a^2 + b^2 \end{equation}"
    assert verdicts(tmp_path, rf"\begin{{figure}}{said}\end{{figure}} {display}") == {"x": FALSE}
    assert verdicts(tmp_path, f"For $a \\cdot b = 0$ the lengths add. {display}") == {"x": {"conditional"}}


#: True and false formulas in the macros of the package physics.
PHYSICS = {
    r"\qty(f + g)^2 = f^2 + 2 f g + g^2": TRUE,
    r"\qty{f + g}^2 = f^2 + g^2": FALSE,
    r"\qty\Big[f + g]^2 = f^2 + g^2": FALSE,
    r"\pqty{f + g} \bqty*{f - g} = f^2 - g^2": TRUE,
    r"a \cp b = - b \cp a": TRUE,
    r"a \dotproduct b = - b \vdot a": FALSE,
    r"\mqty(f & g \\ 0 & 1) \pmqty{x \\ y} = \mqty[f x + g y \\ y]": TRUE,
    r"\left(\mqty{1 & 0 \\ 0 & 1}\right) \mqty(x \\ y) = \mqty(y \\ x)": FALSE,
    r"\dv*{(f g)}{t} = \dv{f}{t} g + f \derivative{g}{t}": TRUE,
    r"\dv[2]{f^2}{t} = 2 \dot{f}^2 + f \ddot{f}": FALSE,
    r"\sin[2](x) + \cos[2](x) = 1": TRUE,
    r"\sin[2](x) \cos(x) = \cos(x) - \cos[2](x)": FALSE,
    r"\norm{f a}^2 = \abs{f}^2 \norm{a}^2": TRUE,
    r"\flatfrac{f}{2} + \flatfrac{f}{2} = f": TRUE,
    r"(a + b)^2 = a^2 + b^2 \qif a \cdot b = 0": TRUE,
    r"(a + b)^2 = a^2 - b^2 \qgiven a \cdot b = 0": FALSE,
    r"(a + b)^2 = a^2 + b^2 \qq{where} a \cdot b = 0": TRUE,
}


@pytest.mark.parametrize("formula", PHYSICS)
def test_macros_of_the_package_physics_are_read(tmp_path: Path, formula: str) -> None:
    body = rf"\usepackage{{amsmath, physics}} \begin{{equation}}\label{{x}} {formula} \end{{equation}}"
    assert verdicts(tmp_path, body) == {"x": PHYSICS[formula]}


def test_own_macros_win_over_those_of_a_package(tmp_path: Path) -> None:
    own = r"\usepackage{physics} \renewcommand{\cp}{+} \newcommand{\dd}{2}"
    body = rf"{own} \begin{{equation}}\label{{x}} f \cp f = \dd f \end{{equation}}"
    assert verdicts(tmp_path, body) == {"x": TRUE}
