"""Names that have a meaning of their own: no declaration may silently change how a formula is read."""

from __future__ import annotations

import pickle
from contextlib import nullcontext

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.terms import Counting, Derivative, DualUnit, Identity, TimeOperator
from workbench.language.definition_entries import read_definition
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term

SCALAR, VECTOR, TENSOR = ({"kind": kind} for kind in ("scalar", "vector", "tensor"))


def table(**symbols: dict) -> SymbolTable:
    return SymbolTable.build({"x": VECTOR, r"\alpha": SCALAR, **symbols})


# d/dt


@pytest.mark.parametrize(
    "latex", [r"\frac{d}{dt} x", r"\frac{dx}{dt}", r"\frac{\mathrm{d}x}{\mathrm{d}t}", r"\frac{d x}{d t}"]
)
@pytest.mark.parametrize(
    "more", [{}, {"d": SCALAR}, {"d": VECTOR}, {"t": VECTOR}, {"t": TENSOR}, {"t_n": SCALAR}]
)
def test_the_derivative_stays_one_whatever_is_declared(latex: str, more: dict) -> None:
    assert read_term(latex, table(**more)) == read_term(r"\dot{x}", table(**more))


@pytest.mark.parametrize("latex", [r"\frac{d}{dt} x", r"\frac{dx}{dt}", r"\frac{d^2 x}{d t^2}"])
def test_the_derivative_beside_symbols_d_and_t_is_refused(latex: str) -> None:
    with pytest.raises(ReadError, match=r"column 1: a derivative, or a quotient of the symbols d and t"):
        read_term(latex, table(d=SCALAR, t=VECTOR))
    with pytest.raises(ReadError, match="a derivative, or a quotient"):
        read_term(latex, table(d=SCALAR), {"t"})


def test_an_upright_d_is_the_derivative_beside_symbols_d_and_t() -> None:
    both = table(d=SCALAR, t=VECTOR)
    assert isinstance(read_term(r"\frac{\mathrm{d}x}{\mathrm{d}t}", both), Derivative)
    assert isinstance(read_term(r"\frac{\mathrm{d}^2}{\mathrm{d}t^2} x", both), Derivative)


# names that cannot be declared

RESERVED = {
    r"\varepsilon": ("the dual unit", DualUnit),
    r"\mathbf{I}": ("the unit tensor", Identity),
    r"\underline{\mathbf{I}}": ("the unit tensor", Identity),
    r"\mathbf{D}": ("the operator d/dt", TimeOperator),
}


@pytest.mark.parametrize("name", RESERVED)
def test_a_name_with_a_meaning_is_neither_declared_nor_defined(name: str) -> None:
    meaning, kind = RESERVED[name]
    assert isinstance(read_term(name, table()), kind)
    for entries in ({name: TENSOR}, {"A": {"kind": "tensor", "aliases": [name]}}):
        if name != r"\mathbf{I}":
            with pytest.raises(SpecError, match=meaning):
                SymbolTable.build({**entries, "u": {"kind": "dual vector"}})
    with pytest.raises(SpecError, match=meaning):
        read_definition(name, r"2 \alpha", table())


@pytest.mark.parametrize("name", [r"\varepsilon", r"\mathbf{I}", r"\mathbf{D}"])
def test_a_declaration_replaces_a_name_that_only_dual_papers_use(name: str) -> None:
    term = read_term(rf"{name} x", table(**{name: SCALAR}))
    assert str(term.type) == "vector" and not any(isinstance(part, RESERVED[name][1]) for part in term.walk())
    with pytest.raises(SpecError, match=RESERVED[name][0]) if name != r"\mathbf{I}" else nullcontext():
        table(**{name: SCALAR, "P": {"kind": "dual operator"}})


def test_a_letter_in_another_font_or_with_an_index_is_free() -> None:
    more = {
        r"\boldsymbol{\varepsilon}": VECTOR,
        r"\mathbf{I}_n": TENSOR,
        "I": SCALAR,
        "D": TENSOR,
        r"\mathbf{D}_n": TENSOR,
    }
    assert set(map(str, (read_term(n, table(**more), {"n"}).type for n in more))) == {
        "vector",
        "tensor",
        "scalar",
    }


def test_the_time_is_no_scalar_symbol() -> None:
    with pytest.raises(SpecError, match=r"t is the time of x\(t\)"):
        table(t=SCALAR)
    with pytest.raises(SpecError, match=r"t is the time of x\(t\)"):
        read_definition("t", r"2 \alpha", table())
    assert str(read_term("t", table(t=VECTOR)).type) == "vector"


# a bracket behind a symbol


def test_x_of_t_is_x() -> None:
    assert read_term(r"\dot{x}(t) + x(t)", table()) == read_term(r"\dot{x} + x", table())


@pytest.mark.parametrize(
    "latex",
    [
        "x(0)",
        r"x(\alpha)",
        r"R(\alpha)",
        r"\alpha(x)",
        r"R(\alpha)^T",
        r"\alpha(t)",
        r"R (\dot\alpha)",
        r"\dot{x}(\alpha_1)",
        "x_2(1)",
    ],
)
def test_a_bracket_that_may_be_an_argument_is_refused(latex: str) -> None:
    more = {"R": {"kind": "rotation"}, "t": VECTOR, r"\alpha_1": SCALAR, "x_n": VECTOR}
    with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
        read_term(latex, table(**more))


@pytest.mark.parametrize(
    ("latex", "plain"),
    [
        (r"\alpha (\alpha + 2) x", r"[\alpha + 2] x \alpha"),
        ("R(x)", "R x"),
        (r"R(\tilde{x})", r"R \tilde{x}"),
        (r"\alpha [\alpha]", r"\alpha^2"),
    ],
)
def test_a_bracket_that_is_a_factor(latex: str, plain: str) -> None:
    more = table(R={"kind": "rotation"})
    assert read(f"{latex} = {plain}", more)


# letters that mean something in one place


def test_e_is_the_exponential_unless_it_is_declared() -> None:
    assert read_term(r"e^{\alpha}", table()) == read_term(r"\exp \alpha", table())
    assert read_term("e^2", table(e=VECTOR)).base == read_term("e", table(e=VECTOR))
    with pytest.raises(ReadError, match="as superscript"):
        read_term(r"e^{\alpha}", table(e=SCALAR))
    assert read_term(r"\mathrm{e}^{\alpha}", table(e=SCALAR)) == read_term(r"\exp \alpha", table())


def test_c_n_k_counts_combinations_unless_c_is_a_symbol() -> None:
    assert isinstance(read_term("C_n^k", table(), {"n", "k"}), Counting)
    assert isinstance(read_term("C_n^k", table(**{r"\mathbf{C}": TENSOR}), {"n", "k"}), Counting)
    for declared in ({"C": TENSOR}, {"C_0": VECTOR}):
        with pytest.raises(ReadError, match=r"C is a symbol too; write .* \\binom"):
            read_term("C_2^1", table(**declared))


def test_the_superscript_t_is_the_transpose_whatever_t_is() -> None:
    more = table(T=TENSOR, A=TENSOR)
    assert read_term("A^T", more).head == "transpose"
    with pytest.raises(ReadError, match="the transpose, or a power"):
        read_term("A^T", table(A=TENSOR), {"T"})


@pytest.mark.parametrize("mark", ["-T", r"-\top", r"-\mathrm{T}", r"{-\mathsf T}"])
def test_minus_t_is_the_transpose_of_the_inverse(mark: str) -> None:
    known = table(A=TENSOR)
    assert read_term(f"A^{{{mark}}}", known) == read_term("(A^{-1})^T", known)
    for bad in ("A^{-1-T}", "A^{-2T}"):
        with pytest.raises(ReadError, match="expected an integer, -1, T, -T"):
            read_term(bad, known)
    with pytest.raises(ReadError, match="the transpose, or a power"):
        read_term("A^{-T}", known, {"T"})


@pytest.mark.parametrize(
    "name",
    [
        r"\det",
        r"\sin",
        r"\exp",
        "sym",
        "tr",
        "T^T",
        "2",
        r"\dot{x}",
        r"\frac{d}{dt}",
        r"\cdot",
        r"\mathbf{0}",
    ],
)
def test_an_operation_is_no_symbol(name: str) -> None:
    with pytest.raises(SpecError):
        SymbolTable.build({name: SCALAR})


def test_function_names_made_of_known_letters_are_rejected() -> None:
    with pytest.raises(ReadError, match="a function and a product of symbols"):
        read_term("tr A", table(t=VECTOR, r=SCALAR, A=TENSOR))
    with pytest.raises(ReadError, match="a function and a product of symbols"):
        read_term("adj A", table(a=SCALAR, d=SCALAR, A=TENSOR), {"j"})


@pytest.mark.parametrize(("text", "key"), [("x = ", "x"), ("x x = 0", "x"), ("x = 0", r"\varepsilon")])
def test_an_error_comes_through_from_another_process(text: str, key: str) -> None:
    """Also where tracebacks are pickled with their contexts, as Dask does."""
    pytest.importorskip("tblib.pickling_support").install()
    with pytest.raises((ReadError, IllFormedAt, SpecError)) as caught:
        read(text, SymbolTable.build({key: VECTOR}))
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (type(copy), str(copy), vars(copy)) == (caught.type, str(caught.value), vars(caught.value))


def test_two_bars_are_one_sign() -> None:
    known = table(A=TENSOR, a=VECTOR, b=VECTOR)
    for inside in ("a", "a + b", r"A a \times b"):
        for bars in ("|| {} ||", "||{}||", r"\left|\left|{}\right|\right|", "| |{}| |"):
            assert read_term(bars.format(inside), known) == read_term(rf"\|{inside}\|", known)
    assert read_term("|A|", known).head == "det"
    with pytest.raises(ReadError, match="which norm of a tensor"):
        read_term("||A||", known)
    inner = read_term("||a| - |b||", known).arguments[0]
    assert inner == read_term("|a| - |b|", known)


def test_three_numbers_in_a_bracket_are_a_column() -> None:
    known = table(x=SCALAR, y=SCALAR, z=SCALAR, a=VECTOR, b=VECTOR, c=VECTOR)
    assert read_term("(x, 2 y, z + 1)", known) == read_term(
        r"\begin{bmatrix} x \\ 2 y \\ z + 1 \end{bmatrix}", known
    )
    assert read_term("(a, b, c)", known).head == "triple"
    with pytest.raises(IllFormedAt):
        read_term("(a, x, b)", known)
