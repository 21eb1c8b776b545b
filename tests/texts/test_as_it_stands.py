"""What a model may say of one claim or spelling, and what one scope or false premise must not do to others."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.paper_errors import PaperError
from workbench.language.printing.printer import to_latex
from workbench.papers.load import load_paper
from workbench.prover.decide.decide import Judge
from workbench.runtime import Budget


def outcomes(folder: Path, text: str, model: str, suffix: str = "md") -> list[str]:
    return [told(each) for each in verdicts(folder, text, model, suffix)]


@pytest.mark.parametrize(
    ("claim", "excused", "alone"),
    [
        (r"w = a \times b", "said", "refuted"),
        (r"a \times (b + c) = a \times b + a \times c", "proved", "proved"),
        (r"\dot a = a \times b", "said", "refuted"),
    ],
)
def test_a_closed_context_excuses_nothing(tmp_path: Path, claim: str, excused: str, alone: str) -> None:
    text = shown("a = 2 d", "b = c", claim)
    model = "[symbols]\na = 'vector'\nb = 'vector'\nc = 'vector'\nd = 'vector'\nw = 'vector'\n"
    assert outcomes(tmp_path, text, model)[-1] == excused
    assert outcomes(tmp_path, text, f"{model}[[claim]]\nat = 'line 5'\ngiven = []\n")[-1] == alone


FALSE = "y = 3 x"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (shown(FALSE, "y = 5 x"), "[[claim]]\nat = 'line 3'\ngiven = ['line 1']\n"),
        (shown(rf"{FALSE} \Rightarrow y = 5 x"), ""),
    ],
)
def test_nothing_is_proved_from_what_contradicts_its_definition(tmp_path: Path, text: str, said: str) -> None:
    model = f"[symbols]\nx = 'scalar'\n[definitions]\ny = '2 x'\n{said}"
    assert outcomes(tmp_path, text, model)[-1] == "conditional"


def test_a_law_is_one_in_its_own_scope(tmp_path: Path) -> None:
    text = (
        shown(r"\dot x = k y", r"\dot x = 2 y") + "\n\n# Other\n\n" + shown(r"\dot x = 3 y", r"\dot x = k y")
    )
    model = "[symbols]\nx = 'scalar'\ny = 'scalar'\n[definitions]\nk = '2'\n"
    scope = "[[scope]]\nfrom = 'Other'\ndefinitions = { k = '3' }\n"
    assert outcomes(tmp_path, text, model + scope) == ["said", "conditional", "said", "conditional"]


def test_a_symbol_of_another_size_in_a_later_scope_ends_nothing(tmp_path: Path) -> None:
    """It was an error of matmul, and no formula had a verdict."""
    rows = r"\begin{bmatrix} u_1 \\ u_2 \end{bmatrix}"
    text = shown(r"\dot w = B \dot u", r"\dot w = \begin{bmatrix} \dot u_1 \\ \dot u_2 \\ 0 \end{bmatrix}")
    model = (
        "[symbols]\nw = 'vector'\nu_1 = 'scalar'\nu_2 = 'scalar'\n[definitions]\n"
        rf"u = '{rows}'" "\n"
        r"B = '\begin{bmatrix} 1 & 0 \\ 0 & 1 \\ 0 & 0 \end{bmatrix}'"
        "\n[[scope]]\nfrom = 'Other'\nsymbols = { u_3 = 'scalar' }\n"
        r"definitions = { u = '\begin{bmatrix} u_1 \\ u_2 \\ u_3 \end{bmatrix}' }"
        "\n"
    )  # fmt: skip
    both = text + "\n\n# Other\n\n" + shown(r"\dot w = \dot u")
    assert outcomes(tmp_path, both, model) == ["said", "conditional", "said"]


ROWS = {
    r"y = \Big(2 x\Big) \\ \Big/ \Big(2\Big)": "proved",
    r"y = (2 x) \\ / (2)": "proved",
    r"y = \frac{1}{2} \\ (2 x)": "proved",
    r"y = \frac{1}{2} (x \\ + x)": "proved",
    r"y = \frac{1}{2} \\ (3 x)": "refuted",
    r"y^2 + y \\ - x y = y": "proved",
    r"y^2 + y \\ - x y + x = y": "refuted",
    r"y = 2 x \\ - x = y": "proved",
}


@pytest.mark.parametrize("rows", ROWS)
def test_the_rows_of_a_multline_are_one_formula(tmp_path: Path, rows: str) -> None:
    text = rf"\begin{{document}}\begin{{multline}}{rows}\end{{multline}}\end{{document}}"
    model = "[symbols]\nx = { kind = 'scalar', free = true }\n[definitions]\ny = 'x'\n"
    assert set(outcomes(tmp_path, text, model, "tex")) == {ROWS[rows]}


@pytest.mark.parametrize("remark", [r"\text{double}", r"\color{gray}{\textrm{(Eq. 1)}}"])
def test_words_in_a_column_of_their_own_are_a_remark(tmp_path: Path, remark: str) -> None:
    rows = rf"\begin{{align}} y &= 2 x & {remark} \\ y - x &= x & \text{{and}} \end{{align}}"
    model = "[symbols]\nx = { kind = 'scalar', free = true }\n[definitions]\ny = '2 x'\n"
    assert outcomes(tmp_path, rows, model) == ["definition", "proved"]


def test_such_words_may_say_where_a_row_holds(tmp_path: Path) -> None:
    rows = r"\begin{align} y &= 3 x & \text{for small angles} \\ y &= 4 x & \text{by (3)} \end{align}"
    model = "[symbols]\nx = { kind = 'scalar', free = true }\n[definitions]\ny = '2 x'\n"
    assert outcomes(tmp_path, rows, model) == ["doubtful", "refuted"]


def test_a_typeface_may_hold_a_sum_and_an_angle_be_typed(tmp_path: Path) -> None:
    text = shown(
        r"(\mathbf{u - v}) \cdot \mathbf{u} = \left< \mathbf{u}, \mathbf{u} \right> - \left<\mathbf{u}, \mathbf{v}\right>"
    )
    model = r"""[symbols]
'\mathbf{u}' = "vector"
'\mathbf{v}' = "vector"
[notation]
'\langle x, y \rangle' = { where = { x = "vector", y = "vector" }, means = 'x \cdot y' }
"""
    assert outcomes(tmp_path, text, model) == ["proved"]


@pytest.mark.parametrize(("kind", "expected"), [("dual quaternion", "proved"), ("quaternion", "refuted")])
def test_the_notation_explains_signs_of_dual_quaternions(tmp_path: Path, kind: str, expected: str) -> None:
    model = f"""[conventions]
quaternion = "hamilton, scalar first"
[notation]
'x \\circ y' = {{ where = {{ x = "{kind}", y = "{kind}" }}, means = 'y x' }}
[symbols]
p = "dual quaternion"
q = "dual quaternion"
"""
    assert outcomes(tmp_path, shown(r"(p \circ q)^* = p^* q^*"), model) == [expected]


RESOLVED = r"""[frames]
base = "N"
names = ["H"]
dot = "N"
axes = { H = ['i', 'j', 'k'] }
'{}^F r' = 'r resolved in F'
orientation = { H = '\begin{bmatrix} \cos a & -\sin a & 0 \\ \sin a & \cos a & 0 \\ 0 & 0 & 1 \end{bmatrix}' }
"""


@pytest.mark.parametrize(
    ("rates", "expected"),
    [("", "unchecked"), ("rates = 'resolved'\n", "proved"), ("rates = 'of components'\n", "refuted")],
)
def test_whose_rate_a_dot_inside_is_has_to_be_said(tmp_path: Path, rates: str, expected: str) -> None:
    """The velocity on a circle, in components of the turning frame: (0, c ȧ, 0), where those of r are constant."""
    model = f"{RESOLVED}{rates}[symbols]\nr = 'vector'\na = {{ kind = 'scalar', free = true }}\n"
    model += "c = { kind = 'scalar', constant = true, free = true }\n[definitions]\nr = 'c i'\n"
    text = shown(r"{}^H\dot{r} = \begin{bmatrix} 0 \\ c \dot a \\ 0 \end{bmatrix}")
    assert outcomes(tmp_path, text, model) == [expected]


def test_a_model_says_what_a_judgement_may_cost(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text(shown("1 = 1"))
    (tmp_path / "p.toml").write_text("source = 'p.md'\nbudget = { seconds = 3 }\n")
    assert load_paper(tmp_path / "p.toml").budget == Budget(seconds=3)
    (tmp_path / "p.toml").write_text("source = 'p.md'\nbudget = { seconds = -1 }\n")
    with pytest.raises(PaperError, match="budget: seconds: expected a positive number"):
        load_paper(tmp_path / "p.toml")


def test_a_sentence_that_is_indented_is_none_of_the_display(tmp_path: Path) -> None:
    text = (
        "T\n\n.. math::\n\n   y = 2 x\n\n Since :math:`y = x` here, it holds.\n\n.. math::\n\n   y - x = x\n"
    )
    model = "[symbols]\nx = { kind = 'scalar', free = true }\n[definitions]\ny = '2 x'\n"
    assert outcomes(tmp_path, text, model, "rst") == ["definition", "proved"]


def test_an_identity_with_an_extra_term_is_no_law(tmp_path: Path) -> None:
    """The velocity of the middle of two links, with a term too much: it was a law, q̇_2 = 0, and the next row held by it."""
    text = shown(
        r"v = l \dot{q}_1 e + l \dot{q}_2 d",
        r"v = l \dot{q}_1 e + l \dot{q}_2 d",
        r"v = l \dot{q}_1 e",
        r"\ddot{q}_1 + \dot{q}_2 = 0",
    )
    column = r"\begin{bmatrix} %s_%d \\ %s_%d \\ 0 \end{bmatrix}"
    along = [column % (r"\cos q", n, r"\sin q", n) for n in (1, 2)]
    across = [column % (r"-\sin q", n, r"\cos q", n) for n in (1, 2)]
    model = f"""[symbols]
q_1 = "scalar"
q_2 = "scalar"
l = {{ kind = "scalar", constant = true }}
[definitions]
e = '{across[0]}'
d = '{across[1]}'
r = 'l {along[0]}'
v = '\\dot{{r}}'
"""
    assert outcomes(tmp_path, text, model) == ["refuted", "refuted", "proved", "said"]


def test_two_rates_beside_each_other_are_no_rate_of_a_product(tmp_path: Path) -> None:
    text = shown(
        r"L = \frac{k \frac{d}{d t} x \frac{d}{d t} y}{k}",
        r"L = \frac{k \frac{d}{d t} x \frac{d}{d t} y}{2 k}",
    )
    model = "[symbols]\nx = 'scalar'\ny = 'scalar'\nk = { kind = 'scalar', constant = true, free = true }\n"
    assert outcomes(tmp_path, text, f"{model}[definitions]\nL = '\\dot x \\dot y'\n") == [
        "unchecked",
        "refuted",
    ]


def test_a_base_that_no_definition_reaches_may_be_said(tmp_path: Path) -> None:
    model = "[symbols]\n'w_i' = 'vector'\n'a_i' = 'vector'\n[definitions]\n'a_{i+1}' = '\\dot{w}_{i+1}'\n"
    assert outcomes(tmp_path, shown("a_0 = 0", r"a_1 = 2 \dot{w}_1"), model) == ["said", "refuted"]


def test_a_crash_on_one_formula_keeps_the_other_verdicts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def judge(self: Judge, statement, *arguments, **options):
        if "b" in to_latex(statement):
            raise ValueError("matmul: a mismatch")
        return whole(self, statement, *arguments, **options)

    whole = Judge.judge
    monkeypatch.setattr(Judge, "judge", judge)
    (tmp_path / "p.md").write_text(shown("a + a = 2 a", "b + b = 2 b"))
    (tmp_path / "p.toml").write_text("source = 'p.md'\n[symbols]\na = 'scalar'\nb = 'scalar'\n")
    first, second = (result.verdict for result in judge_paper(load_paper(tmp_path / "p.toml")))
    assert (first.outcome, second.outcome) == ("proved", "unchecked")
    assert "a defect of the workbench" in second.reason and "matmul" in second.reason
