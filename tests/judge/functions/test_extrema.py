r"""\min and \max: the bound and where it is reached, against numbers that are computed apart; distances that
anyone knows; false values, forms without a bound, and what is refused."""

from fractions import Fraction
from random import Random

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definition
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

TABLE = SymbolTable.build(
    {
        **{name: {"kind": "vector"} for name in ("a", "b", "m", "w")},
        "u": {"kind": "vector", "unit": True},
        **{name: {"kind": "scalar"} for name in ("f", "s")},
        "A": {"kind": "tensor"},
        "a_x": {"kind": "vector"},
        "p": {"kind": "vector", "weight": 1},
        "q": {"kind": "vector", "weight": 2},
        r"\underline{a}": {"kind": "dual scalar"},
    }
)


def verdict(latex, *assume, definitions=(), table=TABLE):
    (statement,) = read(latex, table)
    supposed = [said for condition in assume for said in read(condition, table)]
    return Judge(Definitions(definitions)).judge(statement, supposed)


def outcome(latex, *assume):
    return verdict(latex, *assume).outcome


def column(entries):
    return r"\begin{bmatrix} " + r" \\ ".join(map(str, entries)) + r" \end{bmatrix}"


def number(value):
    value = Fraction(value)
    return str(value) if value.denominator == 1 else rf"\frac{{{value.numerator}}}{{{value.denominator}}}"


def least_square(p, directions):
    """min ‖p + Σ tᵢ lᵢ‖² by Gram and Schmidt."""
    basis = []
    for vector in (*directions, p):
        rest = list(map(Fraction, vector))
        for e in basis:
            scale = sum(x * y for x, y in zip(rest, e, strict=True)) / sum(x * x for x in e)
            rest = [x - scale * y for x, y in zip(rest, e, strict=True)]
        if vector is p:
            return sum(x * x for x in rest)
        if any(rest):
            basis.append(rest)


class TestNumbers:
    """The least values of forms with numbers for coefficients, of any rank."""

    CASES = range(5)

    @staticmethod
    def sides(seed):
        random = Random(seed)
        count = random.choice((1, 2, 3))
        directions = [[random.randint(-2, 2) for _ in range(3)] for _ in range(count)]
        if count == 3 and seed % 2:
            directions[2] = [x - y for x, y in zip(directions[0], directions[1], strict=True)]
        p = [random.randint(-3, 3) for _ in range(3)]
        letters = "xyz"[:count]
        body = " + ".join(
            [column(p), *(f"{t} {column(d)}" for t, d in zip(letters, directions, strict=True))]
        )
        over = ", ".join(letters) + r" \in \mathbb{R}"
        return over, body, least_square(p, directions)

    @pytest.mark.parametrize("seed", CASES)
    def test_the_least_square(self, seed):
        over, body, value = self.sides(seed)
        assert outcome(rf"\min_{{{over}}} ({body})^2 = {number(value)}") == Outcome.PROVED
        assert outcome(rf"\min_{{{over}}} \| {body} \| = \sqrt{{{number(value)}}}") == Outcome.PROVED
        for wrong in (value + 1, value - Fraction(1, 7)):
            assert outcome(rf"\min_{{{over}}} ({body})^2 = {number(wrong)}") == Outcome.REFUTED

    @pytest.mark.parametrize("seed", CASES[::4])
    def test_the_greatest_of_the_opposite(self, seed):
        over, body, value = self.sides(seed)
        assert outcome(rf"\max_{{{over}}} (3 - ({body})^2) = {number(3 - value)}") == Outcome.PROVED
        found = verdict(rf"\max_{{{over}}} (3 - ({body})^2) = {number(4 - value)}")
        assert found.outcome == Outcome.REFUTED
        assert found.counterexample.right == (str(4 - value),)


#: Distances and least speeds, each with a wrong value beside the right one.
KNOWN = [
    (r"\min_{x \in V_3} \|x - a\|", "0", "1"),
    (r"\min_{t \in \mathbb{R}} \|a + t u - b\|", r"\|u \times (a - b)\|", r"|u \cdot (a - b)|"),
    (r"\min_{t \in \mathbb{R}} (a + t u)^2", r"a^2 - (u \cdot a)^2", r"a^2"),
    (r"\min_{x \in V_3} (x^2 + 2 a \cdot x + f)", "f - a^2", "f + a^2"),
    (r"\max_{s} (2 f s - s^2)", "f^2", "2 f^2"),
    (r"\max_{x \in S^2} x \cdot a", r"\|a\|", r"-\|a\|"),
    (r"\min_{x \in S^2} (f + x \cdot (a \times b))", r"f - \|a \times b\|", r"f + \|a \times b\|"),
    (r"\max_{u} u \cdot a", r"\|a\|", "0"),
    (r"\min_{s, t, k \in \mathbb{R}} ((s - f)^2 + (t - 2)^2 + (k - s)^2)", "0", "1"),
    (r"\min_{x \in V_3} \|m + w \times x\|", r"|\operatorname{Du} |w + \varepsilon m||", r"\|m\|"),
]


class TestKnown:
    def test_the_minimum_at_a_rank_deficiency_counts(self):
        """(x − 1)² + (f y + 3)² is 0 somewhere, and at least 9 where f = 0."""
        found = verdict(r"\min_{x, y \in \mathbb{R}} ((x - 1)^2 + (f y + 3)^2) = 0")
        assert found.outcome == Outcome.REFUTED and found.reason == "the least value is another one"
        assert (found.counterexample.values, found.counterexample.left) == ({"f": ("0",)}, ("9",))

    def test_of_numbers_on_a_line(self):
        assert outcome(r"\min_{x \in \mathbb{R}} \|f x + 3\| = 0, f \neq 0") == Outcome.PROVED
        assert outcome(r"\min_{x \in \mathbb{R}} \|f x + 3\| = 3, f \neq 0") == Outcome.REFUTED

    @pytest.mark.parametrize(("left", "right", "wrong"), KNOWN)
    def test_right_and_wrong_values(self, left, right, wrong):
        assert outcome(f"{left} = {right}") == Outcome.PROVED
        assert outcome(f"{left} = {wrong}") == Outcome.REFUTED

    def test_directions_with_an_undefined_value_are_excluded(self):
        pitch = r"\min_{x \in V_3} \|m + w \times x\| = \frac{|w \cdot m|}{\|w\|}"
        assert outcome(pitch) == Outcome.CONDITIONAL
        assert outcome(pitch, r"w \neq \mathbf{0}") == Outcome.PROVED

    @pytest.mark.slow
    def test_the_distance_of_two_lines(self):
        skew = r"\min_{s, t \in \mathbb{R}} \|a + s u - b - t w\| = \frac{|(a - b) \cdot (u \times w)|}{\|u \times w\|}"
        assert outcome(skew) == Outcome.CONDITIONAL
        assert outcome(skew, r"u \times w \neq \mathbf{0}") == Outcome.PROVED

    def test_where_the_rank_falls_another_value_refutes(self):
        found = verdict(r"\min_{x \in V_3} \|A x - b\| = 0")
        assert found.outcome == Outcome.REFUTED and set(found.counterexample.values) == {"A", "b"}
        assert outcome(r"\min_{x \in V_3} \|A x - b\| = 0", r"\det A \neq 0") == Outcome.PROVED
        found = verdict(r"\min_{x \in V_3} (a \cdot x - 1)^2 = 0")
        assert found.outcome == Outcome.REFUTED and found.counterexample.left == ("1",)
        assert found.counterexample.values == {"a": ("0", "0", "0")}
        assert outcome(r"\min_{x \in V_3} (a \cdot x - 1)^2 = 0", r"a \neq \mathbf{0}") == Outcome.PROVED

    @pytest.mark.parametrize("inside", ["f x", "f x - f a", "f x - (f + 1) a"])
    def test_quotients_of_a_proof_do_not_limit_an_extremum(self, inside):
        """0 is defined everywhere: it is the least value, or another one is."""
        found = verdict(rf"\min_{{x \in V_3}} \|{inside}\| = 0")
        is_false = "f + 1" in inside
        assert found.outcome == (Outcome.REFUTED if is_false else Outcome.PROVED)
        assert not is_false or found.counterexample.values["f"] == ("0",)

    def test_definitions_are_written_out(self):
        known, table = read_definition(r"\rho", r"a + w \times b", TABLE)
        latex = r"\min_{b \in V_3} \|\rho\| = \frac{|w \cdot a|}{\|w\|}"
        found = verdict(latex, r"w \neq \mathbf{0}", definitions=[known], table=table)
        assert found.outcome == Outcome.PROVED

    def test_under_a_premise(self):
        assert (
            outcome(r"w = \mathbf{0} \Rightarrow \min_{x \in V_3} \|m + w \times x\| = \|m\|")
            == Outcome.PROVED
        )


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\min \|a\| = 0", "over what"),
        (r"\min_x \|a\| = 0", "over which set"),
        (r"\min_{x \in SO(3)} \|a\| = 0", r"over SO_{3}"),
        (r"\min_{x \in V_3, x \cdot a = 1} \|x\| = 0", "a condition under"),
        (r"\min_{n \in \mathbb{N}} n = 0", "over"),
        (r"\min_{s} s^2 + 1 = 1", "stands alone on a side"),
        (r"2 \min_{s} s^2 = 0", "stands alone on a side"),
        (r"\min_{s} s^2 \geq 0", "before the bound"),
        (r"\min_{s} s^2 \neq 0", "≠ is not read here"),
        (r"\min_{s} s^2 = \min_{b} b^2", "such a side"),
        (r"\min_{s} \min_{b} (s + b^2) = 0", "within another"),
        (r"\min_{u \in V_3} u \cdot a = 0", "declared as another thing"),
        (r"\min^2_{s} s^2 = 0", "nothing but letters"),
        (r"\inf_{s} s^2 = 0", "need not be reached"),
        (r"\min_{s} a = a", "expected a real scalar"),
        (r"\min_{s} \underline{a} = 0", "expected a real scalar"),
        (r"\min_{s} s^2 = a", "the other side a vector"),
        (r"\min_{s} s^2 = s", "stands on the other side"),
        (r"\min_{s} p^2 = q^2", "weight"),
    ],
)
def test_invalid_extrema_are_rejected(latex, message):
    with pytest.raises((ReadError, IllFormedAt)) as error:
        read(latex, TABLE)
    assert message in str(error.value)


@pytest.mark.parametrize(
    "latex",
    [
        r"\min_{x, y \in V_3, t \in \mathbb{R}} (x + t y)^2 = 0",
        r"\max_{u} (u \cdot a + f) = \|a\| + f",
        r"\max_{x \in \mathbb{S}^2} x \cdot a = \|a\|",
    ],
)
def test_read_back(latex):
    (statement,) = read(latex, TABLE)
    assert read(to_latex(statement), TABLE) == (statement,)
