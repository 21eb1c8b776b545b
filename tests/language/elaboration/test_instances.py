"""Formulas at given integers: sums written out against sums by hand, and the laws of substitution."""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.language.generated import TABLE, VARIABLES, terms
from workbench.core.construct import apply, big_sum, counting, identity, integer, number, power, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import LARGEST, MOST_COUNTED, count, free_integers, instantiate, raised
from workbench.core.terms import BigSum, Counting, IllFormed, Integer, Number, Term, Zero
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term


def at(latex: str, **values: int) -> str:
    return to_latex(instantiate(read_term(latex, TABLE, VARIABLES), values))


@pytest.mark.parametrize(
    ("latex", "n", "expected"),
    [
        (r"\Phi_{n+1}", 2, r"\Phi_{3}"),
        (r"\omega^{(n)}", 0, r"\omega"),
        (r"\omega^{(n)}", 3, r"\dddot{\omega}"),
        (r"\mathbf{S}^n", 1, r"\mathbf{S}"),
        (r"\mathbf{S}^n", 0, r"\mathbf{I}"),
        (r"\alpha^n", 0, "1"),
        (r"n \omega", 3, r"3 \omega"),
        (r"(-1)^n", 3, r"\left(-1\right)^{3}"),
        (r"\sum_{k=1}^{n} \Phi_k", 3, r"\Phi_{1} + \Phi_{2} + \Phi_{3}"),
        (r"\sum_{k=1}^{n} \Phi_k", 1, r"\Phi_{1}"),
        (r"\sum_{k=1}^{n-2} \Phi_k", 2, r"\mathbf{0}_{3 \times 3}"),
        (r"\sum_{k=1}^{n-2} \omega", 1, r"\mathbf{0}"),
        (
            r"\sum_{k=0}^{n} C_n^k \omega^{(k)} \times \mathbf{v}^{(n-k)}",
            2,
            r"1 \omega \times \ddot{\mathbf{v}} + 2 \dot{\omega} \times \dot{\mathbf{v}} + 1 \ddot{\omega} \times \mathbf{v}",
        ),
        (
            r"\sum_{p_1+p_2=n} C_n^{p_1,p_2} \Phi_{p_1} \Phi_{p_2}",
            2,
            r"1 \Phi_{0} \Phi_{2} + 2 \Phi_{1} \Phi_{1} + 1 \Phi_{2} \Phi_{0}",
        ),
        (
            r"\sum_{k=1}^{n} \sum_{j=1}^{k} \lambda_{k,j}",
            2,
            r"\lambda_{1,1} + \left(\lambda_{2,1} + \lambda_{2,2}\right)",
        ),
    ],
)
def test_written_out(latex: str, n: int, expected: str) -> None:
    assert at(latex, n=n) == expected


@pytest.mark.parametrize(
    ("latex", "part"),
    [
        (r"\Phi_{n-3}", "negative index -1"),
        (r"\omega^{(n-3)}", "negative order -1"),
        (r"\omega^{2n-6}", "negative exponent -2"),
        (r"(n-3)!", "negative number -1"),
        (r"\sum_{k=0}^{1000 n} \omega", "at most 2000"),
        (r"\sum_{p_1+p_2+p_3=100n} \omega", "at most 2000"),
        (r"(1000n+1)!", "at most 1000"),
        (r"C_n^{m,m}", "add up to 2"),
    ],
)
def test_instances_without_a_value_are_ill_formed(latex: str, part: str) -> None:
    with pytest.raises(IllFormed, match=part):
        instantiate(read_term(latex, TABLE, VARIABLES), {"n": 2, "m": 2})


@given(n=st.integers(0, 12), k=st.integers(0, 12))
def test_counting_coefficients_are_numbers(n: int, k: int) -> None:
    values = {"n": n, "m": k}
    assert instantiate(read_term("n!", TABLE, VARIABLES), values).value == factorial(n)
    binomial = instantiate(read_term("C_n^m", TABLE, VARIABLES), values)
    assert isinstance(binomial, Zero) if k > n else binomial.value == comb(n, k)
    multinomial = read_term("C_{n+m}^{n,m}", TABLE, VARIABLES)
    assert instantiate(multinomial, values).value == Fraction(comb(n + k, k))


@settings(max_examples=200)
@given(terms)
def test_no_integer_is_left(term: Term) -> None:
    try:
        instance = instantiate(term, {"n": 2, "m": 1, "k_1": 3})
    except IllFormed:
        return
    assert not any(isinstance(t, Integer | BigSum | Counting) for t in instance.walk())


@settings(max_examples=200)
@given(terms)
def test_first_n_to_m_plus_1_then_m_to_2_is_n_to_3(term: Term) -> None:
    m = Linear.variable("m")
    try:
        two_steps = instantiate(instantiate(term, {"n": m + 1}), {"m": 2, "k_1": 1})
        one_step = instantiate(term, {"n": 3, "m": 2, "k_1": 1})
    except IllFormed:
        return
    assert two_steps == one_step


def test_a_bound_variable_is_renamed_rather_than_captured() -> None:
    term = read_term(r"\sum_{k=0}^{n} \lambda_{k,n}", TABLE, {"n"})
    moved = instantiate(term, {"n": Linear.variable("k")})
    assert instantiate(moved, {"k": 2}) == instantiate(term, {"n": 2})


def test_unchanged_terms_stay_the_same_object() -> None:
    term = read_term(r"\mathbf{S} \omega + \Phi_n \omega", TABLE, {"n"})
    assert instantiate(term, {"n": 2}).arguments[0] is term.arguments[0]
    assert instantiate(term, {"m": 2}) is term


def test_statements_are_instantiated_side_by_side() -> None:
    (statement,) = read(r"\Phi_n = \mathbf{S}^n \Rightarrow \omega^{(n)} = \mathbf{0}", TABLE, {"n"})
    assert to_latex(instantiate(statement, {"n": 2})) == (
        r"\Phi_{2} = \mathbf{S}^{2} \Rightarrow \ddot{\omega} = \mathbf{0}"
    )


def test_a_number_is_exact() -> None:
    term = instantiate(read_term(r"\frac{1}{3} \alpha", TABLE), {})
    assert isinstance(term.arguments[0], Number) and term.arguments[0].value == Fraction(1, 3)


def test_a_value_for_a_bound_variable_changes_nothing() -> None:
    term = read_term(r"\sum_{k=0}^{n} \lambda_{k,n}", TABLE, {"n"})
    assert instantiate(term, {"k": 5}) == term


def test_two_bound_variables_are_renamed_apart() -> None:
    term = read_term(r"\sum_{p_1+p_2=n} \lambda_{p_1,p_2} \lambda_{n,n}", TABLE, {"n"})
    both = Linear.variable("p_1") + Linear.variable("p_2")
    moved = instantiate(term, {"n": both})
    assert instantiate(moved, {"p_1": 1, "p_2": 1}) == instantiate(term, {"n": 2})


@pytest.mark.parametrize(("count", "largest"), [(1, 3000), (2, LARGEST - 1), (3, 61), (4, 20)])
def test_a_sum_over_parts_has_as_many_addends_as_there_are_ways(count: int, largest: int) -> None:
    """n as a sum of so many integers from 0 on; at most LARGEST ways are written out."""
    names = "jklm"[:count]
    body = (
        apply("add", *(integer(Linear.variable(name)) for name in names))
        if count > 1
        else integer(Linear.variable("j"))
    )
    parts = big_sum(names, None, Linear.variable("n"), body)
    ways = comb(largest + count - 1, count - 1)
    written = instantiate(parts, {"n": largest})
    assert len(written.arguments if count > 1 else (written,)) == ways <= LARGEST
    if count > 1:
        with pytest.raises(IllFormed, match=f"a sum of {comb(largest + count, count - 1)} addends"):
            instantiate(parts, {"n": largest + 1})


def test_the_norm_of_a_row_misfits() -> None:
    with pytest.raises(IllFormed, match="expected a quaternion or scalar or vector, got a covector"):
        apply("norm", read_term(r"\omega^T", TABLE))


@pytest.mark.parametrize(
    ("name", "arguments", "expected"),
    [
        ("factorial", (0,), 1),
        ("factorial", (5,), 120),
        ("binomial", (5, 2), 10),
        ("binomial", (5, 5), 1),
        ("binomial", (5, 6), 0),
        ("binomial", (5, -1), 0),
        ("binomial", (0, 0), 1),
        ("multinomial", (5, 2, 2, 1), 30),
        ("multinomial", (3, 0, 3), 1),
        ("multinomial", (3, 1, 1), "must add up to 3"),
        ("multinomial", (3, 4, -1), "must add up to 3"),
        ("factorial", (-1,), "factorial of the negative number -1"),
        ("binomial", (-1, 0), "binomial of the negative number -1"),
        ("binomial", (MOST_COUNTED, 1), MOST_COUNTED),
        ("binomial", (MOST_COUNTED + 1, 1), f"at most {MOST_COUNTED}"),
    ],
)
def test_counting_functions_have_their_values(
    name: str, arguments: tuple[int, ...], expected: int | str
) -> None:
    given = tuple(map(Linear, arguments))
    if isinstance(expected, str):
        with pytest.raises(IllFormed, match=expected):
            count(name, given)
    else:
        assert count(name, given) == (number(expected) if expected else zero())
    if len(arguments) > 1:
        open_ = (*given[:-1], Linear.variable("n"))
        assert count(name, open_) == counting(name, *open_)


@pytest.mark.parametrize("lower", [0, 1, 7])
def test_the_longest_sum_that_is_written_out(lower: int) -> None:
    sum_ = big_sum(["k"], lower, Linear.variable("n"), integer(Linear.variable("k")))
    assert len(instantiate(sum_, {"n": LARGEST + lower - 1}).children) == LARGEST
    with pytest.raises(IllFormed, match=f"a sum of {LARGEST + 1} addends"):
        instantiate(sum_, {"n": LARGEST + lower})


@pytest.mark.parametrize("latex", [r"\alpha", r"\mathbf{S}", r"\omega", r"\lambda_{1,2}"])
@pytest.mark.parametrize("exponent", range(-3, 4))
def test_a_power_at_a_number(latex: str, exponent: int) -> None:
    base = read_term(latex, TABLE, VARIABLES)
    if base.type.is_column:
        if exponent % 2 or exponent < 0:
            with pytest.raises(IllFormed, match="power"):
                raised(base, Linear(exponent))
        else:
            assert raised(base, Linear(exponent)) == (number(1) if exponent == 0 else power(base, exponent))
        return
    one = identity() if base.type.kind == "tensor" else number(1)
    positive = {0: one, 1: base}.get(abs(exponent), power(base, abs(exponent)))
    assert raised(base, Linear(exponent)) == (positive if exponent >= 0 else apply("inverse", positive))


@pytest.mark.parametrize(
    ("latex", "free"),
    [
        (r"\Phi_{n+m}", "nm"),
        (r"\omega^{(n)}", "n"),
        (r"\alpha^{m}", "m"),
        (r"\alpha^{m} \omega^{(n)}", "nm"),
        (r"n!", "n"),
        (r"\binom{n}{m}", "nm"),
        (r"2 n", "n"),
        (r"\sum_{k=1}^{n} \Phi_k", "n"),
        (r"\sum_{k=m}^{n} \Phi_k", "nm"),
        (r"\sum_{k=1}^{3} \Phi_{k+n}", "n"),
        (r"\sum_{i+j=n} \Phi_i \Phi_j", "n"),
        (r"\sum_{i+j=3} \Phi_{i} \omega^{(j)}", ""),
        (r"\Phi_n^{T} + m \mathbf{S}", "nm"),
        (r"\alpha \omega", ""),
    ],
)
def test_free_integers(latex: str, free: str) -> None:
    assert free_integers(read_term(latex, TABLE, VARIABLES)) == frozenset(free)
