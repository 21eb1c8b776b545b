"""What texts print without a word of explanation is read as the same term as the long form of it."""

import pytest

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
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()}).with_notations(
    {
        r"\lfloor a \rfloor_\times": {"where": {"a": "vector"}, "means": r"\tilde{a}"},
        r"[a \times]": {"where": {"a": "vector"}, "means": r"\tilde{a}"},
        "[a]": {"where": {"a": "vector"}, "means": r"\tilde{a}"},
    }
)
SAME = [
    (r"\left[\begin{matrix} x \\ y \\ z \end{matrix}\right]", r"\begin{bmatrix} x \\ y \\ z \end{bmatrix}"),
    (
        r"[w] \left[\begin{array}{c} x \\ y \\ z \end{array}\right]",
        r"\tilde{w} \begin{bmatrix} x \\ y \\ z \end{bmatrix}",
    ),
    (r"w \times w \times v", r"w \times (w \times v)"),
    (r"x w \times w \times y w \times v", r"(x w) \times (w \times ((y w) \times v))"),
    (r"\mathbf{pq}^T", r"\mathbf{p} (\mathbf{q}^T)"),
    (r"(\mathbf{pq})^T", r"(\mathbf{p} \mathbf{q})^T"),
    (r"\Delta t^2", r"(\Delta t)^2"),
    (r"\dot{\Delta t}", r"\Delta \dot{t}"),
    (r"\dot{\Delta\mathbf{x}}_1", r"\Delta\dot{\mathbf{x}}_1"),
    (r"{x (\mathbf{p} \mathbf{q})}^T", r"x (\mathbf{p} \mathbf{q})^T"),
    (r"{x v}_\mathcal{B}", r"x v_\mathcal{B}"),
    (r"{\Delta\mathbf{x}}_1", r"\Delta\mathbf{x}_1"),
    (r"[\Delta\mathbf{x}_1 \times] w", r"\widetilde{\Delta\mathbf{x}_1} w"),
    (r"[R v \times] w", r"\widetilde{R v} w"),
    (r"\Delta y", r"(\Delta) (y)"),
    (r"x/2", r"\frac{x}{2}"),
    (r"x y/(x + y)", r"\frac{x y}{x + y}"),
    (r"\sin(x/2)", r"\sin\frac{x}{2}"),
    (r"y \sin x/\cos\alpha", r"\frac{y \sin x}{\cos\alpha}"),
    (r"(x, y, z)^T", r"\begin{bmatrix} x \\ y \\ z \end{bmatrix}"),
    (r"[v^T, w^T]^T", r"\begin{bmatrix} v \\ w \end{bmatrix}"),
    (r"\lfloor v \rfloor_\times w", r"\tilde{v} w"),
    (r"[v \times] w", r"\tilde{v} w"),
    (r"\textrm{so we find: } x + y", "x + y"),
    (r"[I_{3\times3}] v + \mathbb{I}_{3 \times 3} w", r"\mathbf{I} v + \mathbf{I} w"),
    (r"[R]_\text{3-2-1} v", "R_{321} v"),
    (r"{x_D}_0 \vec{v_a}_b", r"x_{D,0} \vec{v}_{a,b}"),
    (r"R_{i \rightarrow b} v", r"R_{i\to b} v"),
    (r"R_{\text{3-1-3}}^T (v)_\mathcal{B}", r"R_{313}^T v_{\mathcal{B}}"),
    (r"\left(\tilde{v}\right)_{\mathcal{B}} [R]_{\text{3-1-3}}^T", r"\tilde{v}_{\mathcal{B}} R_{313}^T"),
    (r"\sum_{i}^{3} x", r"\sum_{i=1}^{3} x"),
    (
        r"\left[\arraycolsep=2pt \begin{array}{c} x \\ y \end{array}\right] \enskip z",
        r"\begin{bmatrix} x \\ y \end{bmatrix} z",
    ),
]


@pytest.mark.parametrize(("spelt", "meant"), SAME)
def test_the_short_form_is_the_long_one(spelt: str, meant: str) -> None:
    (relation,) = read(f"{spelt} = {meant}", TABLE)
    assert relation.left == relation.right
    assert read(to_latex(relation), TABLE) == (relation,)


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        (r"x/2y = z", "how far does / reach"),
        (r"x/y/z = z", "what is divided by what"),
        (r"v = \pm w", "says either"),
        (r"x = \pm y \pm z", "says either"),
        (r"xy = \pm y + \mp z", "says either"),
        (r"(v, w)^T = v", "columns beside each other"),
        (r"\lfloor x \rfloor = y", "between brackets"),
        (r"x \gets y", "an assignment"),
        (r"x \textrm{so: } = y", "words"),
    ],
)
def test_two_readings_are_refused(formula: str, message: str) -> None:
    with pytest.raises(ReadError, match=message):
        read(formula, TABLE)


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
