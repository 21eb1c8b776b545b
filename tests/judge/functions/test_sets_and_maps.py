r"""Sets given by their members and maps between sets: what is right by its kind or by equations, what is not of
the kind that it is said to be, what is false, what is left undecided, and what is refused."""

import pytest

from workbench import check
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

TABLE = SymbolTable.build(
    {
        "a": {"kind": "vector"},
        "n": {"kind": "vector"},
        "s": {"kind": "scalar"},
        "u": {"kind": "vector", "unit": True},
        "T": {"kind": "tensor"},
        r"\mathbf{R}": {"kind": "rotation"},
        r"\rho": {"kind": "vector"},
        r"\underline{a}": {"kind": "dual vector"},
    }
)
DUAL = r"\underline{\mathbf{V}}_3"
TENSORS = rf"\mathbf{{L}}({DUAL}, {DUAL})"


def verdict(latex):
    (statement,) = read(latex, TABLE)
    assert read(to_latex(statement), TABLE) == (statement,)
    return Judge(Definitions()).judge(statement)


#: Of each set or map what makes it one, and a change that no longer does.
PAIRS = [
    (r"S^2 = \{ x \in V_3 \mid x^2 = 1 \}", "1 ", "2 "),
    (rf"\underline{{SO}}_3 = \{{ Q \in {TENSORS} \mid Q Q^T = \mathbf{{I}}, \det Q = 1 \}}", r", \det Q = 1", ""),
    (r"\mathfrak{so}_3 = \{ A \in L(V_3, V_3) \mid A = -A^T \}", "-A", "A"),
    (rf"{DUAL} = \{{ b + \varepsilon c; b, c \in V_3, \varepsilon^2 = 0 \}}", "^2 = 0", "^2 = 1"),
    (r"f : V_3 \to \mathfrak{so}_3, f(x) = \tilde{x}", r"\mathfrak{so}_3", "SO(3)"),
    (r"f : SO(3) \to SO(3), Q \mapsto Q^T \mathbf{R}", r"\mathbf{R}", r"T \mathbf{R}"),
    (r"f : \mathbb{SE}_3 \to \underline{SO}_3, f(\begin{bmatrix} \mathbf{R} & \rho \\ \mathbf{0} & 1 \end{bmatrix})"
     r" = (\mathbf{I} + \varepsilon \tilde{\rho}) \mathbf{R}", r"\underline{SO}_3", "SO(3)"),
    (r"f : V_3 \to \mathbb{R}, f(x) = a \cdot x", "a", r"\underline{a}"),
    (r"f^{-1} : SO(3) \to SE(3), f^{-1}(Q) = \begin{bmatrix} Q & Q a \\ \mathbf{0} & 1 \end{bmatrix}", "{ Q &", "{ 2 Q &"),
]  # fmt: skip


class TestPairs:
    @pytest.mark.parametrize(("latex", "old", "new"), PAIRS)
    def test_right_and_wrong(self, latex, old, new):
        assert verdict(latex).outcome == Outcome.DEFINITION
        old, new = (
            (old.replace("{ Q", "} Q"), new.replace("{ 2", "} 2")) if old.startswith("{ Q") else (old, new)
        )
        assert old in latex
        found = verdict(
            latex.replace(old, new, 1) if old != "a" else latex.replace("a \\cdot", new + " \\cdot")
        )
        assert found.outcome == Outcome.REFUTED and found.counterexample is not None


def test_undecided_set_equations_have_a_reason():
    found = verdict(r"so(3) = \{ \tilde{x} \mid x \in S^2 \}")
    assert found.reason == "whether all members of so(3) are so is not decided"


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\mathcal{A} = \{ A \in \mathcal{M}_{3 \times 3}(\mathbb{R}) \mid A = \begin{bmatrix} B & b \\ \mathbf{0} & 0 \end{bmatrix};"
         r" B \in L(V_3, V_3), b \in V_3 \}", "tensor and matrix 4×4"),
        (r"f : V_3 \to \mathbb{R}, f(x) = x", "here it is a vector"),
        (r"f : \mathbb{R} \to V_3, f(a) = a", "a member of \\mathbb{R} is a scalar"),
        (r"f : V_3 \to so(3), f(x) = \{ A \in so(3) \mid A x = \mathbf{0} \}", "values of the map are sets"),
        (r"\underline{\mathbb{R}} = \{ x \mid x \in V_3 \}", "is a dual scalar"),
        (r"f : V_3 \to S^2, g(x) = x", "a map is said by"),
        (r"f : V_3 \to S^2", "a map is said by"),
        (r"f : Q \to V_3, f(x) = x", "the set Q is not known"),
        (r"x \mapsto x^2", "of which set"),
        (r"f : SO(3) \leftrightarrow SE(3), f(Q) = Q", "goes one way"),
        (r"P = \{ x \mid x \in S \}", "the set S is not known"),
        (r"P = \{ x, y \mid s = 0 \}", "expected a set behind it"),
        (r"f : SO(3) \to SE(3), f(Q) = Q T", "here it is a tensor"),
        (r"S \subset V_3", "a part of a set"),
    ],
)  # fmt: skip
def test_ill_typed_sets_are_rejected(latex, message):
    with pytest.raises((ReadError, IllFormedAt)) as error:
        read(latex, TABLE)
    assert message in str(error.value)


@pytest.mark.parametrize(("value", "found"), [("x^2", Outcome.DEFINITION), ("x^3", Outcome.REFUTED)])
def test_a_defined_map_has_its_stated_values(value, found):
    said = rf"f : \mathbb{{R}} \to \mathbb{{R}}, f(x) = {value}"
    assert check(said, symbols={"x": "scalar"}, definitions=["f(x) = x^2"]).outcome == found
