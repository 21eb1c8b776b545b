"""What bad input gets: one error that says what is wrong, at which line and column, at once."""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import replace

import pytest

from tests.language.reading_tables import tables
from tests.language.test_readings import SECTIONS
from workbench.core.formula_errors import Fault, IllFormedAt, ReadError, TypeMismatch
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.elaboration.statements import clauses_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Chain
from workbench.language.naming.reading_conventions import Conventions, Gradient
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term

TABLE = tables()["weights"]
#: Rows of `readings/bad_formulas.txt`.
ROWS = [latex for name, *_, lines in SECTIONS if name == "bad_formulas" for latex in lines]

# what no row can hold, or what is read with n: formula, column of the fault in its line, a part of the message
UNREADABLE = [
    ("", 1, "nothing"),
    ("   ", 1, "nothing"),
    (r"\omega & = 0", 8, "& outside"),
    (r"\omega^{(n)} = 0", 10, "integer expression"),
    (r"\frac{d^n}{dt^n} \omega = 0", 9, "integer expression"),
    ("\\omega\0 = 0", 7, "U+0000"),
    ("\\omega\x1b[31m = 0", 7, "U+001B"),
    ("\\omega\ud800 = 0", 7, "U+D800"),
    ("\\omega\u200b = 0", 7, "U+200B"),
]


@pytest.mark.parametrize(("latex", "column", "part"), UNREADABLE)
def test_unreadable(latex: str, column: int, part: str) -> None:
    with pytest.raises(ReadError) as caught:
        read(latex, TABLE)
    assert (caught.value.line, caught.value.column) == (1, column), str(caught.value)
    assert part in caught.value.message


@pytest.mark.parametrize("latex", [*ROWS, *(latex for latex, _, _ in UNREADABLE)])
def test_a_fault_leaves_nothing_behind(latex: str) -> None:
    with suppress(Fault):
        for clause in clauses_of(parse(latex)):
            for side in clause.sides if isinstance(clause, Chain) else (clause,):
                scope = Elaborator(TABLE, frozenset({"n"}))
                with suppress(Fault, TypeMismatch):
                    scope.term(side)
                assert (scope.depth, scope.variables) == (0, {"n"})


def test_the_place_counts_lines() -> None:
    with pytest.raises(ReadError) as caught:
        read("\\begin{cases}\n  \\omega = 0 \\\\\n  \\omega = \\gamma\n\\end{cases}", TABLE)
    assert (caught.value.line, caught.value.column) == (3, 12)


def test_vector_beside_vector_offers_the_scalar_product() -> None:
    with pytest.raises(IllFormedAt) as caught:
        read(r"\alpha = \omega \mathbf{v}", TABLE)
    assert r"\cdot" in caught.value.intent


def test_a_function_name_that_is_also_a_product_is_refused() -> None:
    table = SymbolTable.build({"t": {"kind": "tensor"}, "r": {"kind": "scalar"}, "A": {"kind": "tensor"}})
    with pytest.raises(ReadError, match="a function and a product of symbols"):
        read_term("tr A", table)
    assert read_term(r"\operatorname{tr} A", table) == read_term("trace A", table)
    assert read_term("t r A", table) != read_term("trace A", table)


def test_the_integer_that_is_also_a_symbol_is_refused() -> None:
    table = SymbolTable.build({"n": {"kind": "scalar"}})
    with pytest.raises(ReadError, match="integer variable and a declared symbol"):
        read_term("n + 1", table, {"n"})


HUGE = {
    "a megabyte of braces": "{" * 1_000_000,
    "a megabyte of matched braces": "{" * 500_000 + "}" * 500_000,
    "a megabyte of letters": "x" * 1_000_000,
    "brackets in brackets": "(" * 20_000 + r"\omega" + ")" * 20_000 + " = 0",
    "scripts in scripts": r"\alpha^{" * 5_000 + "2" + "}" * 5_000 + " = 0",
    "fractions in fractions": r"\frac{1}{" * 4_000 + r"\alpha" + "}" * 4_000 + " = 0",
    "dots on dots": r"\dot" * 10_000 + r"\omega = 0",
    "styles on styles": r"\mathbf" * 5_000 + r"\omega = 0",
    "functions of functions": r"\sin " * 9_000 + r"\beta = 0",
    "a long product": r"\alpha " * 7_000 + "= 0",
    "a long row of scripts": r"x^2" * 15_000,
    "environments in environments": r"\begin{cases}" * 3_000,
    "bars in bars": "|" * 40_000,
    "a number of 40000 digits": "9" * 40_000 + r"\alpha = 0",
    "a long cross product": r"\omega \times " * 3_000 + r"\omega = 0",
    "determinants in a row": r"\det \Phi_1 " * 4_000 + "= 0",
    "sums of sums": r"\sum_{k=0}^{2} " * 2_500 + r"\omega = 0",
    "minus signs": "-" * 40_000 + r"\omega = 0",
    "factorials": "3" + "!" * 40_000 + " = 0",
    "primes": r"\omega" + "'" * 40_000 + " = 0",
    "a chain of sides": " = ".join(["\\gamma"] * 6_000),
    "commas": r"\omega = 0" + "," * 40_000,
}


@pytest.mark.parametrize("latex", HUGE.values(), ids=HUGE.keys())
def test_huge_input_gets_an_error_at_once(latex: str) -> None:
    began = time.process_time()
    with pytest.raises((ReadError, IllFormedAt)) as caught:
        read(latex, TABLE)
    assert time.process_time() - began < 5
    assert caught.value.line == 1
    assert caught.value.column >= 1
    assert len(caught.value.message) < 300


def test_the_bound_on_brackets_is_named_where_it_is_crossed() -> None:
    with pytest.raises(ReadError, match="nested deeper than 40") as caught:
        read("(" * 41, TABLE)
    assert caught.value.column == 41


def test_a_derivative_of_three_indices_is_not_read() -> None:
    for gradient in Gradient:
        table = replace(TABLE, conventions=Conventions(gradient=gradient))
        with pytest.raises(ReadError, match="more than two indices") as caught:
            read(r"\frac{\partial \Phi_1}{\partial \omega} = 0", table)
        assert not isinstance(caught.value, IllFormedAt)


def test_a_product_of_as_many_factors_as_terms_may_nest_is_read() -> None:
    product = r"\alpha " * 120
    assert read(f"{product} = {product}", TABLE)
    with pytest.raises(ReadError, match="nests deeper than 120") as caught:
        read(f"{product} = {product} \\alpha", TABLE)
    assert caught.value.column == len(product) + 4
