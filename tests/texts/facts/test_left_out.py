r"""What a model leaves out of matrices and numbers: a formula that holds with it is asked about, and one that is
false with it, too, is refuted."""

from pathlib import Path

import pytest

from tests.texts.written import doubts, shown, symbols_of, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome, Verdict
from workbench.papers.load import load_paper

TURN = r"\begin{bmatrix} c_\theta & -s_\theta \\ s_\theta & c_\theta \end{bmatrix}"
SQUARES = "q_0^2 + q_1^2 - q_2^2 - q_3^2"
OF_A_TURN = r"2 s v^T v - (s^2 + v^T v)^2 s = 2 s v^T v - s"

#: The formula, what it holds for, and the same formula where it is false for that, too.
LEFT_OUT = [
    ("R^{-1} = R^T", ": rotation", "R^{-1} = -R^T"),
    ("R^T S R = R^{-1} S R", ": rotation", "R^T S R = R^{-1} R S"),
    (r"\|R x\|^2 + \|R y\|^2 = \|x\|^2 + \|y\|^2", ": rotation", r"\|R x\|^2 + \|R y\|^2 = \|x\|^2 - \|y\|^2"),
    (r"Q \Omega Q^T \in \mathfrak{so}(3)", r"\Omega: skew", r"Q \Omega Q^T + \Omega^2 = \Omega^2 + \Omega"),
    (r"a^T \Omega b + b^T \Omega a = 0", r"\Omega: skew", r"a^T \Omega b + b^T \Omega a = a^T b"),
    ("M = M^T", "M: symmetric", "M = 2 M^T"),
    ("x^T S y = y^T S x", "S: symmetric", "x^T S y = 2 y^T S x"),
    (f"\\det {TURN} = 1", r"c_{\theta}, s_{\theta}: the cosine", f"\\det {TURN} = 2"),
    (f"q_0 q_1 ({SQUARES}) = q_0 q_1 (1 - 2 (q_2^2 + q_3^2))", "q_{0}, q_{1}, q_{2}, q_{3}: of length 1", f"q_0 q_1 ({SQUARES}) = q_0 q_1 (1 - q_2^2 - q_3^2)"),
    (r"a \sin\theta = a \theta", r"\theta: small", r"a \sin\theta = 2 a \theta"),
    (r"\exp \tilde{v} = \mathbf{I} + \tilde{v}", "v: small", r"\exp \tilde{v} = \mathbf{I} - \tilde{v}"),
    ("Q Q^T I a = I^2 a", "I: the identity", "Q Q^T I a = 2 I^2 a"),
    ("R^{-1} R E x = E^2 x", "E: the identity", "R^{-1} R E x = -E^2 x"),
    (OF_A_TURN, "s, v: of length 1", OF_A_TURN.replace("- s =", "+ s =").replace("- s", "- 2 s")),
]  # fmt: skip
KINDS = {
    **dict.fromkeys(("R", "S"), "matrix 2×2"), "M": "matrix 6×6", "E": "matrix 2×2", "I": "tensor", **dict.fromkeys("xy", "matrix 2×1"),
    **dict.fromkeys((r"c_\theta", r"s_\theta", "q_0", "q_1", "q_2", "q_3", "s"), "scalar"), "v": "vector",
    "K": "matrix 2×2", "Q": "rotation", r"\Omega": "tensor", "a": "vector", "b": "vector", r"\Delta": "scalar", r"\theta": "scalar",
}  # fmt: skip


def judged(folder: Path, *displays: str) -> list[Verdict]:
    return verdicts(folder, shown(*displays), symbols_of(KINDS))


@pytest.mark.parametrize(("formula", "what", "false"), LEFT_OUT)
def test_a_property_that_the_model_leaves_out_is_asked_for(
    tmp_path: Path, formula: str, what: str, false: str
) -> None:
    (asked,) = judged(tmp_path, formula)
    is_hinted = "the cosine" in what or "the identity" in what
    assert told(asked) == ("conditional" if is_hinted else "doubtful") and what in doubts(asked)
    (refuted,) = judged(tmp_path, false)
    assert refuted.outcome is Outcome.REFUTED


def test_a_symbol_that_is_declared_free_has_no_property(tmp_path: Path) -> None:
    free = "{ kind = 'matrix 2×2', free = true }"
    (verdict,) = verdicts(
        tmp_path, "$$ R^{-1} S = R^T S $$", f"source = 'p.md'\n[symbols]\nR = {free}\nS = {free}\n"
    )
    assert verdict.outcome is Outcome.REFUTED


def test_a_matrix_of_numbers_may_be_an_example(tmp_path: Path) -> None:
    """It says what K is, of a free angle; what K makes then for some angle is an example, and one that holds
    for no angle, since nothing in K is free, is false."""
    applied = r"K \begin{bmatrix} 1 \\ 0 \end{bmatrix} = \begin{bmatrix} 0 \\ 1 \end{bmatrix}"
    turning = r"K = \begin{bmatrix} \cos\Delta & -\sin\Delta \\ \sin\Delta & \cos\Delta \end{bmatrix}"
    _, example = judged(tmp_path, turning, applied)
    assert told(example) == "said" and "says what" in doubts(example)
    _, false = judged(tmp_path, r"K = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}", applied)
    assert false.outcome is Outcome.REFUTED


def test_a_unit_matrix_has_the_letter_of_another_one(tmp_path: Path) -> None:
    """A text with an inertia I, which its model defines, writes R R^T = I all the same."""
    model = "source = 'p.md'\n[symbols]\nQ = 'rotation'\nI = 'tensor'\n[definitions]\n"
    model += r"I = '\begin{bmatrix} 2 & 0 & 0 \\ 0 & 3 & 0 \\ 0 & 0 & 4 \end{bmatrix}'"
    meant, also, false = verdicts(tmp_path, "$$ Q Q^T = I $$\n\n$$ Q I = I Q $$\n\n$$ Q Q^T = -I $$", model)
    assert [told(each) for each in (meant, also)] == ["conditional"] * 2
    assert "I: the identity" in doubts(meant) and false.outcome is Outcome.REFUTED


COORDINATES = """source = 'p.md'
[symbols]
q_n = { kind = "scalar", independent = true }
x = { kind = "vector", of = ['q_1', 'q_2'] }
[definitions]
'g_n' = '\\frac{\\partial x}{\\partial q_n}'
"""


def test_an_equation_of_slopes_constrains_the_function(tmp_path: Path) -> None:
    """Of coordinates that are to be orthogonal, in words of any language; a false identity is no condition."""
    square = r"\dot x^2 = (g_1 \dot q_1)^2 + (g_2 \dot q_2)^2"
    formulas = [r"g_1 \cdot g_2 = 0", square, r"\frac{\partial \dot x}{\partial q_1} = 2 \dot g_1"]
    condition, follows, false = verdicts(
        tmp_path, "\n\n".join(f"$$ {each} $$" for each in formulas), COORDINATES
    )
    assert told(condition) == "said" and "says what x is" in doubts(condition)
    assert told(follows) == "conditional" and "(L1)" in doubts(follows)
    assert false.outcome is not Outcome.PROVED
    (tmp_path / "p.toml").write_text(COORDINATES.replace("'q_2'] }", "'q_2'], free = true }"))
    free, *_ = (result.verdict for result in judge_paper(load_paper(tmp_path / "p.toml")))
    assert free.outcome is Outcome.REFUTED
