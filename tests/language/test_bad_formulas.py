"""What bad input gets: one error that says what is wrong, at which line and column, at once."""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import replace

import pytest

from workbench.core.formula_errors import Fault, IllFormedAt, ReadError, TypeMismatch
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.elaboration.statements import clauses_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Chain
from workbench.language.naming.reading_conventions import Conventions, Gradient
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term

TABLE = SymbolTable.build(
    {
        r"\omega": {"kind": "vector", "weight": 1},
        r"\mathbf{v}": {"kind": "vector", "weight": 1},
        r"\mathbf{S}": {"kind": "tensor", "weight": 1},
        r"\Phi_n": {"kind": "tensor", "weight": "n"},
        r"\mathbf{P}_n": {"kind": "operator"},
        r"\alpha": {"kind": "scalar", "weight": 1},
        r"\beta": {"kind": "scalar", "weight": 0},
        r"\underline{\mathbf{a}}": {"kind": "dual vector", "weight": 1},
    }
)

# formula, column of the fault in its line, a part of the message
UNREADABLE = [
    ("", 1, "nothing"),
    ("   ", 1, "nothing"),
    (r"\omega", 1, "relation"),
    (r"\omega =", 9, "too early"),
    (r"= \omega", 1, "unexpected ="),
    (r"\omega = = \omega", 10, "unexpected ="),
    (r"\omega + = \omega", 10, "unexpected ="),
    (r"\omega + + \omega = 0", 10, "unexpected +"),
    (r"\omega - - \omega = 0", 10, "unexpected -"),
    (r"\omega \times - \omega = 0", 8, "nothing after"),
    (r"\omega \times \times \omega = 0", 15, "nothing before"),
    (r"\omega \times = 0", 8, "nothing after"),
    (r"\times \omega = 0", 1, "nothing before"),
    (r"\cdot = 0", 1, "a sign without its operands"),
    (r"(\omega = 0", 1, "never closed"),
    (r"\omega) = 0", 7, "closes nothing"),
    (r"(\omega] = 0", 8, "] cannot close the ( opened before it"),
    (r"[\omega) = 0", 8, "cannot close"),
    (r"\left(\omega = 0", 6, "never closed"),
    (r"\left \omega = 0", 7, "bracket"),
    (r"\left. \omega \right. = 0", 6, "one-sided"),
    (r"\omega \right| = 0", 14, "closes nothing"),
    (r"\bigl x = 0", 7, "bracket"),
    (r"\left\langle \omega, \omega \right) = 0", 35, "cannot close"),
    (r"|\omega = 0", 1, "never closed"),
    (r"\|\omega| = 0", 9, "never closed"),
    (r"{\omega = 0", 1, "never closed"),
    (r"\omega} = 0", 7, "closes nothing"),
    (r"() = 0", 2, "unexpected"),
    (r"{} = 0", 1, "braces"),
    (r"\tan\langle \omega, \omega \rangle = 0", 5, "triple product has three"),
    (r"(\omega, \omega, \omega, \omega) = 0", 1, "triple product has three"),
    (r"\langle \omega \rangle = 0", 1, "triple product has three"),
    (r"[\omega, \omega, \omega] = 0", 1, "triple product has three"),
    (r"(\omega = \omega) = 0", 9, "inside an expression"),
    (r"\foo = 0", 1, r"unknown command \foo"),
    (r"\hat{\omega} = 0", 6, r"unknown symbol \hat{\omega}"),
    (r"\int \omega = 0", 1, "an integral without a differential"),
    (r"\omega \approx \omega", 8, "an approximation is not read"),
    (r"\operatorname{Log} R = \omega", 1, "of two logarithms"),
    (r"\lim \omega = 0", 1, "a limit without its place"),
    (r"\sum_k \omega = 0", 1, "a sum without bounds is not read"),
    (r"\input{/etc/passwd} = 0", 1, r"unknown command \input"),
    (r"\def\x{1} = 0", 1, r"unknown command \def"),
    (r"\begin{foo} \omega = 0 \end{foo}", 1, "unknown environment"),
    (r"\begin{cases} \omega = 0", 1, "never closed"),
    (r"\omega = 0 \end{cases}", 12, "closes nothing"),
    (r"\begin{cases} \omega = 0 \end{aligned}", 26, "cannot close"),
    (r"\begin{bmatrix} \omega \end{bmatrix", 24, "unknown command"),
    (r"\begin{bmatrix} & \end{bmatrix} = 0", 1, "without any entry"),
    (r"\omega & = 0", 8, "& outside"),
    (r"\omeg = 0", 1, r"unknown command \omeg"),
    (r"\gamma = 0", 1, r"unknown symbol \gamma"),
    (r"\boldsymbol{\omega} = 0", 13, r"known and close: \omega"),
    (r"\underline{\omega} = 0", 12, r"known and close: \omega"),
    (r"\omega_1 = 0", 1, r"unknown symbol \omega_{1}"),
    (r"\omega' = 0", 1, "unknown symbol"),
    (r"\Phi = 0", 1, r"close: \Phi_{n}"),
    (r"\Phi_{1,2} = 0", 1, "unknown symbol"),
    (r"\Phi_q = 0", 1, "unknown symbol"),
    (r"{}^1\Phi_1 = 0", 5, "unknown symbol"),
    (r"{}_0 + \omega = 0", 1, "before a symbol"),
    (r"{}_0 (\omega) = 0", 1, "before a symbol"),
    (r"\omega^ = 0", 9, "unexpected ="),
    (r"\omega_ = 0", 9, "unexpected ="),
    (r"^2 = 0", 1, "unexpected ^"),
    (r"\omega^2^2 = 0", 9, "second superscript"),
    (r"\Phi_1_1 = 0", 7, "second subscript"),
    (r"(\Phi_1)_2 = 0", 1, "subscript on an expression"),
    (r"{\dot{\Phi}_1}_2 = 0", 7, "unknown symbol"),
    (r"\omega^{x} = 0", 8, "superscript"),
    (r"\omega^{} = 0", 8, "superscript"),
    (r"\omega^{2,3} = 0", 8, "superscript"),
    (r"\omega^{[2]} = 0", 8, "superscript"),
    (r"\omega^\omega = 0", 8, "superscript"),
    (r"\omega^{1/3} = 0", 8, "superscript"),
    (r"\alpha^{0.5} = 0", 8, "root of a quantity of weight 1"),
    (r"\alpha^{02} = 0", 8, "superscript"),
    (r"\alpha^12 = 0", 8, "first digit"),
    (r"\alpha^{1001} = 0", 9, "too large"),
    (r"\alpha^{99999999999999999999} = 0", 9, "too large"),
    (r"\omega^{(n)} = 0", 10, "integer expression"),
    (r"\omega^{(2000)} = 0", 10, "too large"),
    (r"\Phi_{123456789012} = 0", 7, "too large"),
    (r"\dot = 0", 6, "unexpected ="),
    (r"\dot{} = 0", 5, "braces"),
    (r"\tilde = 0", 8, "unexpected ="),
    (r"\mathbf = 0", 9, "unexpected ="),
    (r"\mathbf{a + b} = 0", 9, "more than one symbol"),
    (r"\boldsymbol{\omega \times \omega} = 0", 13, "more than one symbol"),
    (r"\frac{1} = 0", 10, "unexpected ="),
    (r"\frac = 0", 7, "unexpected ="),
    (r"\frac{1}{} = 0", 9, "braces"),
    (r"\frac{1}{0} = 0", 9, "division by zero"),
    (r"\frac{\alpha}{\mathbf{0}} = 0", 14, "division by zero"),
    (r"\frac123 \alpha = 0", 6, "first digit"),
    (r"\frac{d}{dt} \Phi_1 \times \omega = 0", 1, "how far does d/dt reach"),
    (r"\frac{d}{dt} (\omega)^2 = 0", 14, "bracket it"),
    (r"\frac{d^n}{dt^n} \omega = 0", 9, "integer expression"),
    (r"\binom{\omega}{2} = 0", 7, "integer expression"),
    (r"\binom{2} = 0", 11, "unexpected ="),
    (r"C_{\omega}^2 = 0", 3, "integer expression"),
    (r"\omega! = 0", 1, "integer expression"),
    (r"3!! = 0", 3, "factorial"),
    (r"2^2! = 0", 1, "factorial"),
    (r"\sum = 0", 1, "bounds"),
    (r"\sum \omega = 0", 1, "bounds"),
    (r"\sum_{k} \omega = 0", 1, "bounds"),
    (r"\sum_{k=0} \omega = 0", 1, "upper bound"),
    (r"\sum_{k=0}^{\infty} \omega = 0", 12, "infinite"),
    (r"\sum_{k=0}^{k_1 k_2} \omega = 0", 12, "integer expression"),
    (r"\sum_{k=0}^{3} = 0", 1, "no body"),
    (r"\sum_{k=0}^{3} \sum_{k=0}^{3} \omega = 0", 16, "already has a meaning"),
    (r"\sum_{k_1+k_1=3} \omega = 0", 1, "already has a meaning"),
    (r"\sum_{k_1+k_2=3}^{3} \omega = 0", 18, "no upper bound"),
    (r"\sum_{k_1+\omega=3} \omega = 0", 7, "summation variables"),
    (r"\sum_{\omega=1}^3 \omega = 0", 7, "summation variables"),
    (r"\sum_{k=0}^{99999} \omega = 0", 13, "too large"),
    (r"\omega + \dots + \omega = 0", 10, r"write the sum with \sum"),
    (r"\det = 0", 1, "det of nothing"),
    (r"\operatorname{sym} + \omega = 0", 1, "sym of nothing"),
    (r"\operatorname{foo} \omega = 0", 1, "words in a formula"),
    (r"\text{we know that } \omega = 0", 1, "words in a formula"),
    (r"\det(\Phi_1)^2 = 0", 5, "bracket it"),
    (r"\sin^{-1} \beta = 0", 1, "inverse"),
    (r"\det_2 \Phi_1 = 0", 1, "only a power"),
    (r"\sin \beta \beta = 0", 1, "how far does sin reach"),
    (r"\operatorname{Re} \underline{\mathbf{a}} \beta = 0", 1, "how far does Re reach"),
    (r"\exp \Phi_1 \omega = 0", 1, "how far does exp reach"),
    (r"\omega \times \mathbf{v} \times \omega = 0", 26, "ambiguous"),
    (r"\omega \cdot \mathbf{v} \times \omega = 0", 25, "ambiguous"),
    (r"\omega \cdot \mathbf{v} \cdot \omega = 0", 25, "ambiguous"),
    (r"\omega \otimes \mathbf{v} \otimes \omega = 0", 27, "ambiguous"),
    (r"\omega = 0 \Rightarrow", 23, "too early"),
    (r"\omega > 0", 1, "integer variable"),
    (r"\omega \geq 0", 1, "integer variable"),
    (r"\omega = 0, n \in \omega \times \omega", 19, "set"),
    (r"\omega = 0, n", 13, "relation"),
    (r"\omega = 0, , \omega = 0", 13, "unexpected ,"),
    (r"\omega . \mathbf{v} = 0", 8, "full stop"),
    (r"\omega / 2 \omega = 0", 8, "how far does / reach"),
    (r"\omega / 0 = 0", 10, "division by zero"),
    (r"\omega < 2", 8, "<: inequalities are not read"),
    (r"$\omega = 0$", 1, "unexpected character '$'"),
    (r"\omega = 0 % note", 12, "unexpected character '%'"),
    (r"\omega # = 0", 8, "unexpected character '#'"),
    ("ж = 0", 1, "U+0436"),
    ("\\omega\0 = 0", 7, "U+0000"),
    ("\\omega\x1b[31m = 0", 7, "U+001B"),
    ("\\omega\ud800 = 0", 7, "U+D800"),
    ("\\omega\u200b = 0", 7, "U+200B"),
    (r"\verb|x| = 0", 1, "unknown command"),
    (r"__import__('os') = 0", 1, "unexpected _"),
    (r"\omega = \mathbf{0}_{0 \times 2}", 21, "shape"),
    (r"\omega = \mathbf{0}_1", 21, "shape"),
    (r"e^{\omega} = 1", 3, "the exponential of a vector"),
    (r"\omega \mathbf{v} = 0", 8, r"\cdot, or dyads?"),
    (r"\omega \cdot \Phi_1 = 0", 8, "dyads?"),
    (r"\Phi_1 \times \omega = 0", 8, "dyads?"),
    (r"\Phi_1 \otimes \omega = 0", 8, "of vectors it is the dyad"),
    (r"\|\Phi_1\| = 0", 1, "which norm of a tensor?"),
    (r"\left\|\begin{matrix} \omega & \omega \\ 1 & 2 \end{matrix}\right\| = 0", 6, "which norm of a matrix"),
    (r"\alpha^* = 0", 8, "* on a scalar"),
    (r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}^* = 0", 46, "* on a matrix 2×2"),
    (
        r"\begin{bmatrix} 1 \\ 2 \end{bmatrix} \times \begin{bmatrix} 1 \\ 2 \end{bmatrix} = 0",
        38,
        "between vectors",
    ),
    (r"\Phi_1 \times \Phi_2 = 0", 8, "between vectors"),
    (r"\alpha \circ \beta = \alpha", 8, "a function of the other?"),
    (r"\omega \circ \omega = \alpha", 8, "a function of the other?"),
    (r"\frac{\partial \alpha}{\partial \Phi_1} = 0", 1, "rows or columns?"),
    (r"\sqrt{\Phi_1} = 0", 1, "the root of a tensor is not read"),
    (r"\omega^0 = 0", 8, "a power, or a label?"),
    (r"\omega^1 = 0", 8, "a power, or a label?"),
    (r"(\omega + \omega)^0 = 0", 19, "a power, or a label?"),
]

# formula, column of the operation at fault, a part of the message
ILL_FORMED = [
    (r"\omega = \Phi_1", 8, "differ in type: vector and tensor"),
    (r"\omega = \dot{\omega}", 8, "differ in weight (power of 1/time): 1 and 2"),
    (r"\omega + \Phi_1 = 0", 8, "differ in type"),
    (r"\omega + \mathbf{v} + \dot{\omega} = 0", 21, "differ in weight"),
    (r"\omega \Phi_1 = 0", 8, "juxtaposition of a vector and a tensor"),
    (r"\omega \times \alpha = 0", 8, "expected a vector"),
    (r"\mathbf{P}_1 \circ \omega = 0", 14, "expected an operator or tensor"),
    (r"\tilde{\Phi}_1 = 0", 1, "under the tilde"),
    (r"\tilde{\alpha} = 0", 1, "expected a vector"),
    (r"\widetilde{\omega \cdot \omega} = 0", 1, "expected a vector"),
    (r"\dot{\mathbf{P}}_1 = 0", 1, "operator"),
    (r"\omega^3 = 0", 8, "odd power"),
    (r"\omega^{-1} = 0", 8, "inverse of a vector"),
    (r"\alpha^T = 0", 8, "transpose of a scalar"),
    (r"\operatorname{tr} \alpha = 0", 1, "expected a"),
    (r"\det \omega = 0", 1, "expected a tensor"),
    (r"\operatorname{vect} \omega = 0", 1, "expected a tensor"),
    (r"\sin \alpha = 0", 1, "transcendental function has weight 1"),
    (r"\sin \omega = 0", 1, "expected a scalar"),
    (r"(\omega, \alpha, \omega) = 0", 1, "expected a vector"),
    (r"\frac{1}{\omega} = 0", 1, "division by a vector"),
    (r"\frac{d^2}{dt^3} \omega = 0", 1, "order 2 above and 3 below"),
    (r"\sum_{k=0}^{3} \omega^{(k)} = 0", 1, "differ in weight"),
    (r"\begin{bmatrix} \omega & \Phi_1 \\ \omega \end{bmatrix} = 0", 1, "unequal lengths"),
    (r"\begin{bmatrix} \omega & \Phi_1 \\ \Phi_1 & \omega \end{bmatrix} = 0", 1, "blocks of size"),
    (r"\mathbf{P}_1 \alpha = 0", 14, "operator"),
]


@pytest.mark.parametrize(("latex", "column", "part"), UNREADABLE)
def test_unreadable(latex: str, column: int, part: str) -> None:
    with pytest.raises(ReadError) as caught:
        read(latex, TABLE)
    assert (caught.value.line, caught.value.column) == (1, column), str(caught.value)
    assert part in caught.value.message


@pytest.mark.parametrize(("latex", "column", "part"), ILL_FORMED)
def test_ill_formed(latex: str, column: int, part: str) -> None:
    with pytest.raises(IllFormedAt) as caught:
        read(latex, TABLE)
    assert (caught.value.line, caught.value.column) == (1, column), str(caught.value)
    assert part in caught.value.message


@pytest.mark.parametrize("latex", [latex for latex, _, _ in UNREADABLE + ILL_FORMED])
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
