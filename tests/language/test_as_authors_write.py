"""What texts print without a word of explanation is read as the same term as the long form of it."""

import pytest

from tests.language.reading_tables import tables
from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_formula, read_term

KINDS = {
    "x": "scalar",
    "y": "scalar",
    "z": "scalar",
    r"\alpha": "scalar",
    r"\beta": "scalar",
    r"\Delta t": "scalar",
    r"\Delta": "scalar",
    r"\Delta\mathbf{x}_k": "vector",
    r"\mathbf{p}": "tensor",
    r"\mathbf{q}": "tensor",
    r"\mathbf{q}_n": "vector",
    r"q_{t+1}": "scalar",
    "v": "vector",
    "w": "vector",
    "R": "rotation",
    r"R_{\text{3-2-1}}": "rotation",
    r"v_\mathcal{B}": "vector",
    r"{x_D}_0": "scalar",
    r"\vec{v_a}_b": "vector",
    r"R_{i \to b}": "rotation",
    r"R_{b \to i}": "rotation",
    r"R_{\text{3-1-3}}": "rotation",
}
TABLE = tables()["authors"]


_CASES = r"x = \begin{cases} y & \text{if } z = 0 \\ 2 y & \text{if } z \neq 0 \end{cases}"


@pytest.mark.parametrize(
    "spelt",
    [
        r"x = \begin{cases} y & z = 0 \\ 2 y & z \neq 0 \end{cases}",
        r"x = \begin{cases} y, & z = 0, \\ 2 y, & \text{for } z \neq 0 \end{cases}",
        r"x = \left\{ \begin{matrix} y & z = 0 \\ 2 y & z \neq 0 \end{matrix} \right.",
        r"x = \left\{ \begin{array}{ll} y & z = 0 \\ 2 y & z \neq 0 \end{array} \right.",
    ],
)
def test_text_after_the_value_of_a_case_is_its_condition(spelt: str) -> None:
    assert read(spelt, TABLE) == read(_CASES, TABLE)
    assert len(read(_CASES, TABLE)) == 2


def test_a_system_has_no_cases() -> None:
    said = read(r"\begin{cases} x &= y \\ y &= z \end{cases}", TABLE)
    assert [to_latex(each) for each in said] == ["x = y", "y = z"]
    with pytest.raises(ReadError):
        read(r"x = \begin{cases} y & \text{otherwise} \\ z & y = 0 \end{cases}", TABLE)


def test_both_signs_are_claimed() -> None:
    said = read(r"x \pm y = z \mp x", TABLE)
    assert [to_latex(each) for each in said] == ["x + y = z - x", "x - y = z + x"]


@pytest.mark.parametrize(
    ("formula", "x", "outcome"),
    [
        (r"x = \pm y", "-y", Outcome.PROVED),
        (r"x = \pm y", "y", Outcome.PROVED),
        (r"x = \pm 2 y", "y", Outcome.REFUTED),
        (r"x = z \pm y", "z - y", Outcome.PROVED),
        (r"x = z \mp y", "-z - y", Outcome.REFUTED),
        (r"\pm x = \|v\|", r"-\sqrt{v \cdot v}", Outcome.PROVED),
    ],
)
def test_one_sign_on_one_side_says_that_one_of_the_two_holds(formula: str, x: str, outcome: Outcome) -> None:
    assert check(formula, symbols=KINDS, definitions=[f"x = {x}"]).outcome is outcome


def test_implications_in_a_row_are_each_claimed() -> None:
    (said,) = read(r"x = y \Rightarrow y = z \Leftrightarrow z = y", TABLE)
    assert [type(part).__name__ for part in said.parts] == ["Implication", "Equivalence"]


def test_an_index_without_a_range_is_any() -> None:
    found = read_formula(r"\mathbf{q}_n \times \mathbf{q}_{n+1} = v", TABLE)
    assert [(each.variable, each.generic) for each in found.ranges] == [("n", True)]
    found = read_formula(r"\sum_{k=1}^{N_P} \mathbf{q}_k = \sum_{k=1}^{N_P} \mathbf{q}_k", TABLE)
    assert [(each.variable, each.generic) for each in found.ranges] == [("N_P", True)]
    assert to_latex(found.statements[0].left) == r"\sum_{k=1}^{N_P} \mathbf{q}_{k}"


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"c_n \times c_{n+1} = -c_{n+1} \times c_n", Outcome.PROVED),
        (r"c_n \times c_{n+1} = c_{n+1} \times c_n", Outcome.REFUTED),
        (r"c_n \times c_m = c_n \times c_n", Outcome.REFUTED),
        (r"c_n = c_n + (n - 1) (n - 2) (n - 3) c_n", Outcome.UNCHECKED),
        (r"c_n + c_m = c_n + c_m + (n - m) c_n", Outcome.REFUTED),
        (r"c_n + c_m = c_n + c_m + (n-m-2)(n-m-1)(n-m)(n-m+1)(n-m+2) c_n", Outcome.UNCHECKED),
        (r"c_n + c_m = c_n + c_m + (n-m-2)(n-m-1)(n-m+1)(n-m+2) c_n", Outcome.UNCHECKED),
        (r"\cos(\alpha \pm \beta) = \cos\alpha \cos\beta \mp \sin\alpha \sin\beta", Outcome.PROVED),
        (r"\cos(\alpha \pm \beta) = \cos\alpha \cos\beta \pm \sin\alpha \sin\beta", Outcome.REFUTED),
    ],
)
def test_they_are_judged(formula: str, outcome: Outcome) -> None:
    symbols = {"c_n": "vector", r"\alpha": "scalar", r"\beta": "scalar"}
    assert check(formula, symbols=symbols).outcome == outcome


def test_contradictory_premises_of_later_members_claim_nothing() -> None:
    """The premise has no values at n = 9, the largest number in the formula."""
    symbols = {"f": "scalar", "g": "scalar"}
    found = check(
        r"\frac{(n - 9) g f}{(n - 9) g} = f, n \geq 0", symbols=symbols, assume=[r"(n - 9) g \neq 0"]
    )
    assert found.outcome == Outcome.UNCHECKED
    assert "holds for n = 0..4" in found.verdict.reason


PREFIXED = SymbolTable.build(
    {
        **{
            name: {"kind": "vector"}
            for name in ("{}^A v", "{}^A_B w", "{}_B w", "{}^{A_0} v", "{}^A v_1", "v")
        },
        "{}^A R^B": {"kind": "rotation"},
        r"\hbar": {"kind": "scalar"},
        r"\prescript{C}{}{v}": {"kind": "vector"},
    }
)


@pytest.mark.parametrize(
    ("spelt", "meant"),
    [
        (r"\prescript{A}{}{v}", "{}^A v"),
        (r"\prescript{A}{B}{w}", "{}^A_B w"),
        (r"\prescript{}{B}{w}", "{}_B w"),
        (r"\prescript{A_0}{}{v}", "{}^{A_0} v"),
        (r"\prescript{A}{}{v}_1", "{}^A v_1"),
        (r"\prescript{A}{}{\dot{v}}", r"{}^A \dot{v}"),
        (r"\prescript{A}{}{R}^B \prescript{A}{}{v}", "{}^A R^B {}^A v"),
        (r"\hbar \prescript{C}{}{v}", r"\hbar {}^C v"),
    ],
)
def test_scripts_on_the_left_by_a_command(spelt: str, meant: str) -> None:
    assert read_term(spelt, PREFIXED) == read_term(meant, PREFIXED)


@pytest.mark.parametrize(
    "formula", [r"\prescript{A}{v}", r"\prescript A{}{v}", r"\prescript{}{}{v}", r"\prescript{A}{}{v + v}"]
)
def test_a_command_without_its_scripts_is_refused(formula: str) -> None:
    with pytest.raises(ReadError):
        read_term(formula, PREFIXED)
