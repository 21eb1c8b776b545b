"""Formulas with two readings: read as a paper means them, or refused with one error that says what to write."""

from __future__ import annotations

import pytest

from language.field_kinds import TABLE
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.names import Name
from workbench.core.terms import Symbol
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_formula, read_term


def test_an_order_of_a_number_and_a_fraction_can_be_written() -> None:
    assert read_term(r"2 \cdot \frac{1}{2}", TABLE) == read_term(r"2 (\frac{1}{2})", TABLE)
    assert read_term(r"2 \frac{n}{2} a", TABLE, {"n"})


# ellipses


@pytest.mark.parametrize(
    "dots",
    [
        r"\dots",
        r"\ldots",
        r"\cdots",
        r"\vdots",
        r"\ddots",
        r"\dotsb",
        r"\dotsc",
        r"\dotsm",
        r"\dotsi",
        r"\dotso",
        "...",
        "…",
    ],
)
@pytest.mark.parametrize("formula", ["a = b + {} + c", "a_1 + {} + a_n = b", "a_n = b, n = 0, 1, {}"])
def test_an_ellipsis_gets_an_error_that_says_what_to_write(dots: str, formula: str) -> None:
    with pytest.raises(
        ReadError, match=r"leaves something to be guessed; write the sum with \\sum, the range as n \\geq 1$"
    ) as caught:
        read(formula.format(dots), TABLE, {"n"})
    assert (caught.value.line, caught.value.column) == (1, formula.index("{}") + 1)


# names


def test_numbers_with_a_leading_zero_are_labels() -> None:
    assert read_term(r"\omega_{01}", TABLE).declaration.name == Name(r"\omega", sub=("01",))
    assert read_term(r"\omega_1", TABLE).declaration.name == Name(r"\omega", sub=("", ""))
    with pytest.raises(ReadError, match=r"unknown symbol \\omega_\{02\}"):
        read_term(r"\omega_{02}", TABLE)
    with pytest.raises(ReadError, match="as superscript"):
        read_term(r"\alpha^{02}", TABLE)


@pytest.mark.parametrize(
    "latex",
    [
        "v_{rel}",
        r"v_{\mathrm{n}}",
        r"v_\mathrm{n}",
        r"v_{\text{rot}}",
        r"v_\text{rot}",
        r"v_{\mathrm{rot}}",
        r"v_{\operatorname{rot}}",
    ],
)
def test_words_and_upright_letters_are_labels(latex: str) -> None:
    for variables in (set(), {"n", "l", "t"}):
        term = read_term(latex, TABLE, variables)
        assert term.index == () and "curl" not in str(term.declaration.name)


def test_a_derivative_is_no_part_of_a_name() -> None:
    for name in ("a^{(n)}", "a^{(2)}", r"R^{\mathrm{T}}"):
        with pytest.raises(SpecError, match="would be read as"):
            SymbolTable.build({name: {"kind": "tensor"}})


def test_an_index_in_brackets_is_another_name() -> None:
    with pytest.raises(ReadError, match=r"unknown symbol a_\{\(1\)\}"):
        read_term("a_{(1)}", TABLE)


# conditions


def test_the_value_of_an_index_is_a_range() -> None:
    reading = read_formula("a_n = b, n = 1", TABLE)
    assert len(reading.statements) == 1
    ((variable, lower, upper),) = [(r.variable, str(r.lower), str(r.upper)) for r in reading.ranges]
    assert (variable, lower, upper) == ("n", "1", "1")


def test_the_value_of_a_symbol_is_a_statement() -> None:
    assert len(read(r"a = b, s = 1", TABLE)) == 2
    assert (
        len(
            read(
                r"a = b, n = 1",
                SymbolTable.build(
                    {n: {"kind": k} for n, k in (("a", "vector"), ("b", "vector"), ("n", "scalar"))}
                ),
            )
        )
        == 2
    )
    with pytest.raises(ReadError, match="unknown symbol q"):
        read(r"a = b, q = 1", TABLE)


@pytest.mark.parametrize("condition", [r"s \geq 0", "s > 0", r"s \in \mathbb{N}"])
def test_a_condition_on_a_symbol_is_not_dropped(condition: str) -> None:
    with pytest.raises(ReadError, match="s is a symbol; an assumption about symbols"):
        read(f"a = b, {condition}", TABLE)


def test_a_bold_letter_that_is_a_symbol_is_no_index() -> None:
    table = SymbolTable.build({"a": {"kind": "vector"}, r"\mathbf{n}": {"kind": "vector"}})
    with pytest.raises(ReadError, match="expected an integer variable"):
        read(r"a = a, \mathbf{n} = \overline{1, 3}", table)
    with pytest.raises(ReadError, match="expected integer variables"):
        read(r"a = a, \mathbf{n} \in \mathbb{N}", table)


def test_a_circle_over_a_letter_is_a_part_of_its_name() -> None:
    table = SymbolTable.build({r"\mathring{a}": {"kind": "vector"}})
    for spelt in (r"\overset{\circ}{a}", r"\overset {\circ} {a}", r"\mathring{a}"):
        assert to_latex(read_term(spelt, table)) == r"\mathring{a}"


LABELS = [
    r"v_\perp",
    r"v_{\parallel}",
    r"v_{\|}",
    r"x_{\max}",
    r"T^\dagger",
    r"x_{t|t-1}",
    r"x^\flat",
    r"v^\perp",
]


@pytest.mark.parametrize("name", LABELS)
def test_a_sign_alone_in_a_script_is_part_of_the_name(name: str) -> None:
    table = SymbolTable.build({name: {"kind": "vector"}, "a": {"kind": "vector"}})
    symbol = read_term(name, table)
    assert isinstance(symbol, Symbol)
    assert read_term(to_latex(symbol), table) == symbol
    assert read(rf"{name} \perp a", table) == read(rf"{name} \cdot a = 0", table)


@pytest.mark.parametrize(
    ("printed", "meant"),
    [
        (r"a \perp b", r"a \cdot b = 0"),
        (r"a \parallel b", r"a \times b = \mathbf{0}"),
        (r"a \perp b \perp u", r"a \cdot b = 0, \quad b \cdot u = 0"),
        (r"a = b, \quad a \perp b", r"a = b, \quad a \cdot b = 0"),
        (
            r"a \parallel b \Rightarrow T a \parallel T b",
            r"a \times b = \mathbf{0} \Rightarrow T a \times T b = \mathbf{0}",
        ),
    ],
)
def test_relations_of_directions(printed: str, meant: str) -> None:
    spelt = [to_latex(said) for said in read(printed, TABLE)]
    assert ", ".join(spelt).replace(r"\quad ", "") == ", ".join(
        to_latex(said) for said in read(meant, TABLE)
    ).replace(r"\quad ", "")


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        (r"a \perp T", "expected a vector"),
        (r"\perp a", "unexpected"),
        (r"\parallel a \parallel = s", "unexpected"),
        (r"a \perp", "ends too early"),
    ],
)
def test_directions_of_nothing(formula: str, message: str) -> None:
    with pytest.raises((ReadError, IllFormedAt), match=message):
        read(formula, TABLE)


@pytest.mark.parametrize(
    ("formula", "feature"),
    [
        (r"\inf_a s = 0", "a bound that need not be reached"),
        (r"a \mapsto b = 0", "a map is said by"),
        (r"S \subset T", "a part of a set is not read"),
    ],
)
def test_unsupported_notation_is_named(formula: str, feature: str) -> None:
    with pytest.raises(ReadError, match=feature):
        read(formula, TABLE)


def test_an_unclosed_bracket_is_reported_first() -> None:
    with pytest.raises(ReadError, match="never closed"):
        read(r"\min_a |s = 0", TABLE)


@pytest.mark.parametrize("bound", [r"n \leq 5", r"1 \leq n \leq 5", r"n \le 5", r"n \lt 5"])
def test_an_upper_bound_alone_says_what_to_write(bound: str) -> None:
    with pytest.raises(ReadError, match=r"a range is written n \\geq 1 or n = \\overline\{1,5\}"):
        read(f"a_n = b, {bound}", TABLE)


def test_the_article_fits() -> None:
    with pytest.raises(IllFormedAt, match="expected an operator or tensor"):
        read_term(r"T \circ a", TABLE)


def test_a_backslash_at_the_end_of_a_line_is_a_space_as_in_tex():
    assert read_term("a \\\n + a", TABLE) == read_term("a + a", TABLE)


@pytest.mark.parametrize("formula", [r"s = 1 - t", r"s = \cos t", r"s = 3 + t^2 \alpha"])
def test_the_time_may_stand_for_a_number(formula: str) -> None:
    assert read(formula, TABLE)


def test_a_superscript_digit_of_an_undeclared_matrix_is_a_label() -> None:
    """T^2_3, from frame 2 to 3; a power of T_3 where there is one."""
    kinds = {name: {"kind": "matrix 4×4"} for name in ("T^1_2", "T^2_3", "S")}
    table = SymbolTable.build(kinds)
    (said,) = read("T^1_2 T^2_3 = S", table)
    assert [str(each.declaration.name) for each in said.left.children] == ["T_{2}^{1}", "T_{3}^{2}"]
    for more in ({"T_3": {"kind": "matrix 4×4"}}, {"T_n": {"kind": "matrix 4×4"}}):
        with pytest.raises(SpecError, match="read as a power"):
            SymbolTable.build({**kinds, **more})
    for key, kind in (("x_3^2", "scalar"), ("v_3^2", "vector"), ("T^2", "tensor"), ("T_3^{-1}", "tensor")):
        with pytest.raises(SpecError, match="read as a power"):
            SymbolTable.build({key: {"kind": kind}})


def test_a_product_sign_between_matrices_needs_no_brackets() -> None:
    own = {"X . Y": {"where": {"X": "tensor", "Y": "tensor"}, "means": "X Y"}}
    table = SymbolTable.build({name: {"kind": "tensor"} for name in "ABC"})
    assert read_term("A . B . C", table.with_notations(own)) == read_term("A B C", table)
    crossed = {"X . Y": {"where": {"X": "tensor", "Y": "tensor"}, "means": "X Y - Y X"}}
    with pytest.raises(ReadError, match="without brackets"):
        read_term("A . B . C", table.with_notations(crossed))
