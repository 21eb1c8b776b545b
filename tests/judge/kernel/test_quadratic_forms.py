"""What varies in a quadratic form, its coefficients and its stationary values, against numbers and NumPy."""

from dataclasses import replace
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from judge.functions.test_extrema import TABLE, verdict

from workbench.core.construct import apply, big_sum, derivative, power
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.inventory.signs import is_seen_nonnegative
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term
from workbench.prover.decide.objective import Objective, at_zero_part
from workbench.prover.decide.quadratic_forms import Quadratic, solved

FREE = Definitions()
THREE = SymbolTable.build({name: {"kind": "scalar"} for name in "xyz"})


def number(term):
    engine = ExactEngine(take_inventory([term], FREE), FREE)
    (p,) = engine.parts(engine.value(term))
    return engine.ring.number(p)


def symmetric(random, size, rank):
    """A symmetric matrix of whole numbers, of the rank or a lower one."""
    rows = [[random.randint(-2, 2) for _ in range(size)] for _ in range(rank)]
    return [[sum(row[i] * row[j] for row in rows) for j in range(size)] for i in range(size)]


def test_each_unknown_is_put_in_its_own_place():
    letters = r"x \in \mathbb{R}, y \in \mathbb{R}, z \in \mathbb{R}"
    (said,) = read(rf"\min_{{{letters}}} (x^2 + 2 y + 4 z + 8) = 0", THREE)
    varied = Objective.of(said, FREE, ())
    assert [number(varied.at({place: 1})) for place in range(varied.count)] == [9, 10, 12]
    assert number(varied.at({0: 3, 1: 5, 2: 7})) == 9 + 10 + 28 + 8


@pytest.mark.parametrize("seed", [0, 3, 4, 5])
def test_the_coefficients_are_those_that_were_written(seed):
    """x is a number, b a vector: 4 unknowns. A greatest value is the least one of the opposite."""
    random = Random(seed)
    rank = 4 if seed < 3 else random.randint(1, 3)
    matrix, rest = symmetric(random, 4, rank), random.randint(-3, 3)
    centre = [random.randint(-2, 2) for _ in range(4)]
    slopes = [-sum(a * x for a, x in zip(row, centre, strict=True)) for row in matrix]
    units = [
        r"\begin{bmatrix} " + r" \\ ".join(str(int(i == j)) for j in range(3)) + r" \end{bmatrix}"
        for i in range(3)
    ]
    letters = ["x", *(rf"({unit} \cdot b)" for unit in units)]
    body = str(rest) + "".join(f" {2 * c:+d} {y}" for c, y in zip(slopes, letters, strict=True))
    for row, y in zip(matrix, letters, strict=True):
        body += "".join(f" {c:+d} {y} {z}" for c, z in zip(row, letters, strict=True))
    for word, sign in (("min", 1), ("max", -1)):
        (said,) = read(rf"\{word}_{{x \in \mathbb{{R}}, b \in V_3}} ({body}) = 0", TABLE)
        quadratic = Quadratic(Objective.of(said, FREE, ()), said.least)
        a, b, c = quadratic.coefficients
        assert [[number(entry) * sign for entry in row] for row in a] == matrix
        assert ([number(entry) * sign for entry in b], number(c) * sign) == (slopes, rest)
        found = [number(entry) for entry in quadratic.invariants]
        signs = (-sign) ** np.arange(5)
        assert np.allclose(np.array(found, float), np.poly(np.array(matrix, float)) * signs)
        assert len(quadratic.vanishing) == 16
        rank = max(k for k in range(5) if found[k])
        assert rank == np.linalg.matrix_rank(np.array(matrix))
        point = [number(y) / found[rank] for y in quadratic.stationary(rank)]
        assert [sum(x * y for x, y in zip(row, point, strict=True)) for row in matrix] == [-s for s in slopes]
        least = rest + sum(s * y for s, y in zip(slopes, point, strict=True))
        assert number(quadratic.value_at_rank(rank)) == sign * least
        assert number(quadratic.value_at_rank(0)) == sign * rest


@pytest.mark.parametrize("seed", range(12))
def test_solutions_solve_the_system_with_free_unknowns_0(seed):
    random = Random(seed)
    size = random.randint(1, 4)
    matrix = symmetric(random, size, random.randint(1, size))
    b = [random.randint(-2, 2) for _ in range(size)]
    if seed % 2:
        b = [sum(row) for row in matrix]
    rows = [[*map(Fraction, row), Fraction(c)] for row, c in zip(matrix, b, strict=True)]
    before = [list(row) for row in rows]
    found = solved(rows)
    assert rows == before
    ranks = [np.linalg.matrix_rank(np.array(m, float)) for m in (matrix, before)]
    assert (found is None) == (ranks[0] != ranks[1])
    if found is not None:
        assert [sum(a * x for a, x in zip(row, found, strict=True)) for row in matrix] == b
        assert sum(x != 0 for x in found) <= ranks[0]


NOT_NEGATIVE = [
    "0",
    "3",
    r"\|a\|",
    r"\sqrt{f}",
    "f^2",
    "a^2",
    r"\|a\|^3",
    "f^2 + 3",
    r"f^2 \|b\|",
    r"\frac{f^2}{\|b\|}",
    "(f^2 + 1)^3",
    r"a \cdot a + f f",
    r"\det(T T^T)",
    r"\det(T^T T) + f^2",
]
PERHAPS_NEGATIVE = [
    "-3",
    "f",
    "f^3",
    r"-\|a\|",
    "f^2 + g",
    "g + f^2",
    "f^2 g",
    r"\frac{f^2}{g}",
    r"\frac{-1}{f^2}",
    r"f^2 - \|a\|",
    "f^n",
    r"|\underline{d}|",
    r"\underline{d}^2",
    r"\|a\| + \underline{d}^2",
    r"\sin f",
    "T^2",
    "T^2 f^2",
    r"a \cdot b",
    r"\det(T T)",
    r"\underline{d} \cdot \underline{d}",
    r"\det(T S^T)",
]


@pytest.mark.parametrize("latex", [*NOT_NEGATIVE, *PERHAPS_NEGATIVE])
def test_nonnegative_terms_are_recognized(latex):
    table = SymbolTable.build(
        {key: {"kind": "scalar"} for key in "fg"}
        | {key: {"kind": "vector"} for key in "ab"}
        | {"T": {"kind": "tensor"}, "S": {"kind": "tensor"}, r"\underline{d}": {"kind": "dual vector"}}
    )
    assert is_seen_nonnegative(read_term(latex, table, frozenset("n"))) == (latex in NOT_NEGATIVE)


MOVED = SymbolTable.build(
    {
        "s": {"kind": "scalar"},
        **{name: {"kind": "vector"} for name in ("a", "b", "x_b", "x_c", r"x_\omega", r"\omega")},
        "h": {"kind": "scalar", "of": ["s"]},
        "T": {"kind": "tensor"},
        "R": {"kind": "rotation"},
        r"\rho": {"kind": "vector", "coordinate": True},
        "q": {"kind": "scalar", "independent": True},
    }
)
RATE = "a rate or a sum over n of what depends on {}, which varies"
SLOPE = "a derivative of what depends on {}, which varies"
DEFINE = "{} may depend on {}, which varies; define it"


@pytest.mark.parametrize(
    ("latex", "reason"),
    [
        (r"\min_{b \in V_3} (a + \dot{b})^2 = 0", RATE.format("b")),
        (r"\min_{s \in \mathbb{R}} \operatorname{div}(s \rho) = 0", SLOPE.format("s")),
        (r"\min_{s \in \mathbb{R}} \frac{\partial (s q)}{\partial q} = 0", SLOPE.format("s")),
        (r"\min_{b \in V_3} ((\mathbf{D} + T) b)^2 = 0", SLOPE.format("b")),
        (r"\min_{s \in \mathbb{R}} (s + h)^2 = 0", DEFINE.format("h", "s")),
        (r"\min_{b \in V_3} (b + x_b)^2 = 0", DEFINE.format("x_{b}", "b")),
        (r"\min_{\omega \in V_3} (\omega + x_\omega)^2 = 0", DEFINE.format(r"x_{\omega}", r"\omega")),
    ],
)
def test_hidden_dependence_on_the_variable_is_unchecked(latex, reason):
    found = verdict(latex, table=MOVED)
    assert (found.outcome, found.reason) == (Outcome.UNCHECKED, reason)


@pytest.mark.parametrize(
    "latex",
    [
        r"\min_{b \in V_3} (b + x_c + \dot{a})^2 = 0",
        r"\min_{b \in V_3} (b + x_\omega + \operatorname{curl}(T \rho) + (\mathbf{D} + T) a)^2 = 0",
        r"\min_{a \in V_3} (h + a^2) = h",
    ],
)
def test_independent_symbols_do_not_vary(latex):
    table = replace(
        MOVED, symbols=MOVED.symbols | SymbolTable.build({"T": {"kind": "tensor", "uniform": True}}).symbols
    )
    (said,) = read(latex, table)
    assert Objective.of(said, FREE, ()).letters == said.letters


def test_a_sum_over_what_varies_is_refused():
    (said,) = read(r"\min_{b \in V_3} b^2 = 0", MOVED)
    total = big_sum(("k",), 1, 3, power(said.letters[0], 2))
    for body in (total, derivative(total, 1), apply("add", total, total)):
        with pytest.raises(NotExact, match="or a sum over n"):
            Objective.of(replace(said, body=body), FREE, ())


@pytest.mark.parametrize(
    ("premise", "reason"),
    [
        (r"b \cdot a = 1", "a premise about b, which varies"),
        (r"a \neq b", "a premise about b, which varies"),
        (r"a = \omega \text{ and } s = b^2", "a premise about b, which varies"),
        (r"a = \omega \Leftrightarrow s = 1", "a minimum or maximum under a premise that is no equation or inequation"),
    ],
)  # fmt: skip
def test_premises_that_are_refused(premise, reason):
    (said,), supposed = read(r"\min_{b \in V_3} b^2 = 0", MOVED), read(premise, MOVED)
    with pytest.raises(NotExact) as refused:
        Objective.of(said, FREE, supposed)
    assert str(refused.value) == reason


def test_a_dual_norm_where_its_real_part_is_0():
    """|a + ε b| is ε ‖b‖ there, wherever it stands; the others stay."""
    table = SymbolTable.build(
        {"f": {"kind": "scalar"}}
        | {key: {"kind": "dual vector"} for key in (r"\underline{x}", r"\underline{y}")}
        | {"a": {"kind": "vector"}}
    )

    def term(latex):
        return read_term(latex, table)

    before = term(r"f |\underline{x}| + |\underline{y}| + \|a\|")
    real = term(r"\operatorname{Re} \underline{x}")
    after = term(r"f (\varepsilon \|\operatorname{Du} \underline{x}\|) + |\underline{y}| + \|a\|")
    assert at_zero_part(before, lambda part: part == real) == after
    assert at_zero_part(before, lambda part: False) is before
