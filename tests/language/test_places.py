"""A bracket that says only what a symbol depends on says where it is taken: f(x) and f(y) are two values."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.names import Name
from workbench.language.definition_entries import read_definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read

LETTERS = ("x", "y", "z")
KINDS = dict.fromkeys((*LETTERS, "f", "g", "v"), "vector") | {"A": "rotation", "s": "scalar"}
TABLE = replace(
    SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()}),
    arguments=frozenset(map(Name, LETTERS)),
)
TWO_PLACES = [
    "f(X) = f(Y)",
    "f(X) + v = f(Y)",
    r"A^T(X) A(Y) = A A^T",
    r"\dot{f}(X) = f(Y)",
    "f(X, Y) = f(Y, X)",
]
ONE_PLACE = ["f(X) = g(Y)", "f(X) = f", r"\dot{f}(X) = s f(X)", "f(t) = f(X)", r"f(X, \dot{X}) = g(X)"]


def at(formula: str, x: str, y: str) -> str:
    return formula.replace("X", x).replace("Y", y)


@pytest.mark.parametrize("formula", TWO_PLACES)
def test_a_symbol_at_two_places_is_refused(formula: str) -> None:
    for x, y in permutations(LETTERS, 2):
        with pytest.raises(ReadError, match="at two places"):
            read(at(formula, x, y), TABLE)


@pytest.mark.parametrize("formula", ONE_PLACE)
def test_at_one_place_the_bracket_says_nothing(formula: str) -> None:
    for x, y in permutations(LETTERS, 2):
        (said,) = read(at(formula, x, y), TABLE)
        assert "(" not in to_latex(said)


@pytest.mark.parametrize("place", ["k + 1", "k - h", "2 k", "-k"])
def test_another_place_of_an_argument_is_no_factor(place: str) -> None:
    """f(k + 1) is the next f, and no product of f and k + 1, unless f is a constant."""
    kinds = {name: {"kind": "scalar"} for name in "fukh"}
    table = replace(
        SymbolTable.build({**kinds, "c": {"kind": "scalar", "constant": True}}),
        arguments=frozenset({Name("k")}),
    )
    for formula in (f"f({place}) = f(k) + u(k)", f"f(k) = u({place})", rf"h \dot{{f}}({place}) = 1"):
        with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
            read(formula, table)
    (said,) = read(f"f = c({place})", table)
    assert "k" in to_latex(said)


STEPS = {
    **{name: {"kind": "scalar"} for name in ("f", "h", r"\Delta t", r"\Delta k", r"\Delta t_i")},
    "g": {"kind": "vector"},
    "q": {"kind": "hamilton quaternion"},
    "T": {"kind": "tensor"},
    "c": {"kind": "scalar", "constant": True},
}
STEPPED = replace(SymbolTable.build(STEPS), arguments=frozenset({Name("t"), Name("k")}))


@pytest.mark.parametrize("symbol", ["f", "g", "q", "T", r"\dot{q}", r"\dot{g}"])
@pytest.mark.parametrize(
    "step", [r"\Delta t", r"\Delta k", r"2 \Delta t", r"-\Delta t_1", r"\frac{\Delta t}{2}"]
)
def test_a_step_of_an_argument_is_no_factor(symbol: str, step: str) -> None:
    with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
        read(f"{symbol}({step}) = {symbol}", STEPPED)
    assert read(f"{symbol} [{step}] = ({step}) {symbol}", STEPPED)
    assert read(f"c({step}) = c", STEPPED)
    if step in (r"\Delta t", r"\Delta k"):  # a symbol, as f(h) of a scalar h is asked about, too
        with pytest.raises(ReadError, match="or a product"):
            read(f"{symbol}({step}) = {symbol}", replace(STEPPED, arguments=frozenset()))


@pytest.mark.parametrize("argument", ["t", "k"])
@pytest.mark.parametrize("symbol", ["f", "g", "q"])
def test_symbols_with_an_argument_are_no_factors_elsewhere(symbol: str, argument: str) -> None:
    for formula in ("F(A) = F(2 h) + F", "F(2 h) + F = F(A)", r"\dot{F}(A) = F(h + c)"):
        with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
            read(formula.replace("F", symbol).replace("A", argument), STEPPED)
    for product in ("F(2 h) = 2 h F", "F(A) = [2 h] F(A)", "F(A) = c(2 h) F"):
        assert read(product.replace("F", symbol).replace("A", argument), STEPPED)


@pytest.mark.parametrize("symbol", ["f", "g"])
def test_a_function_defined_by_x_is_not_evaluated_at_y(symbol: str) -> None:
    for x, y in permutations(LETTERS, 2):
        _, table = read_definitions({"f": f"s {x}", "g": f"f + {x}"}, TABLE)
        assert read(f"{symbol}({x}) = v", table) and read(rf"{symbol}({x}, \dot{{{y}}}) = v", table)
        with pytest.raises(ReadError, match=f"defined by {x}, and taken at another place"):
            read(f"{symbol}({y}) = v", table)


def test_a_column_of_them_says_all_that_it_is_made_of() -> None:
    for x, y in permutations(LETTERS, 2):
        _, table = read_definitions({"g": rf"s {x} + {y}", "f": rf"{x} \times {y}"}, TABLE)
        table = replace(table, arguments=table.arguments | {Name("g")})
        assert read("f(g) = v", table)


def test_braces_around_the_bracket_change_nothing() -> None:
    for x in LETTERS:
        assert read(f"f{{({x})}} = v", TABLE) == read(f"f({x}) = v", TABLE)


@pytest.mark.parametrize("symbol", ["s", "v", "B", "B^T", "B^{-1}", r"\dot{B}", "s^2"])
@pytest.mark.parametrize("inside", ["r", "r, w", "r, w, r", "v, w, v", "r + w, r, w", "-r, w, r", "w - r"])
def test_a_symbol_before_a_bracket_may_be_a_function(symbol: str, inside: str) -> None:
    """B(φ, θ, ψ) is no product with a column, and B(v, w, v) none with a triple product; square ones are."""
    kinds = {"r": "scalar", "w": "scalar", "s": "scalar", "v": "vector", "B": "tensor"}
    kinds |= {"w": "vector"} if inside == "v, w, v" else {}
    table = SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()})
    is_product = inside == "w - r" and symbol not in ("B", r"\dot{B}")  # as in x = v (t_2 - t_1)
    if is_product:
        assert read(rf"{symbol}({inside}) = {symbol} w - {symbol} r", table)
    else:
        with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
            read(f"{symbol}({inside}) = {symbol}", table)
    if inside == "w - r":
        assert read(rf"{symbol} [{inside}] = {symbol} w - {symbol} r", table)


@pytest.mark.parametrize("symbol", ["s", "v", "A", r"\dot{v}", r"\ddot{s}"])
@pytest.mark.parametrize("time", ["t + s", "s - t", "2 t", "-t", "t^2", r"\frac{t}{2}", "t - x_0"])
def test_a_value_at_another_time_is_no_product(symbol: str, time: str) -> None:
    """x(t + h) = x(t) + h ẋ(t) was refuted, with x (t + h) a product."""
    table = SymbolTable.build(
        {"s": {"kind": "scalar"}, "v": {"kind": "vector"}, "A": {"kind": "tensor"}, "x_0": {"kind": "scalar"}}
    )
    with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
        read(f"{symbol}({time}) = {symbol}(t)", table)
    (product,) = read(f"{symbol} [{time}] = {symbol} [{time}] + {symbol} - {symbol}", table)
    assert read(to_latex(product), table) == (product,)


@pytest.mark.parametrize("inside", [r"1 + \cos(\omega t)", r"\sin(\omega t) - e^{-\omega t}"])
def test_a_function_of_time_is_not_the_time(inside: str) -> None:
    kinds = {
        "s": {"kind": "scalar"},
        "b": {"kind": "scalar", "constant": True},
        r"\omega": {"kind": "scalar"},
    }
    table = SymbolTable.build(kinds)
    for factor in ("s", "b"):
        assert read(rf"s = {factor} ({inside})", table) == read(rf"s = {factor} [{inside}]", table)
    assert read("s = b (t - 2)", table) == read("s = b [t - 2]", table)
    with pytest.raises(ReadError, match="or a product"):
        read("s = s (t - 2)", table)


@pytest.mark.parametrize(("formula", "read_as"), [("s(Q) = s", "s = s"), ("c(q) = q c", "c q = q c")])
def test_of_two_scalars_one_that_is_constant_is_a_factor(formula: str, read_as: str) -> None:
    kinds = {"s": "scalar", "q": "scalar", "c": {"kind": "scalar", "constant": True}}
    specs = {name: {"kind": kind} if isinstance(kind, str) else kind for name, kind in kinds.items()}
    table = replace(SymbolTable.build(specs), arguments=frozenset({Name("q"), Name("t")}))
    for variable in "qt" if "Q" in formula else "q":
        (said,) = read(formula.replace("Q", variable), table)
        assert to_latex(said) == read_as


@pytest.mark.parametrize("formula", ["A(x) v = f", "[A(x)] v = f", r"\dot{A}(x) v = f", r"f + s v(x) = g"])
def test_a_bracket_that_fits_only_as_arguments_raises_a_question(formula: str) -> None:
    for table in (
        replace(TABLE, arguments=frozenset()),
        replace(TABLE, arguments=frozenset(map(Name, "yz"))),
    ):
        with pytest.raises(ReadError, match="or a product"):
            read(formula, table)
    with pytest.raises(IllFormedAt, match="juxtaposition"):
        read("A(x) v y = f", TABLE)
    assert to_latex(*read("A(x) = f", replace(TABLE, arguments=frozenset()))) == "A x = f"


@pytest.mark.parametrize("written", [r"J(q) v + \dot J(q, \dot q) u", r"J(q) v + \dot J(q, \dot{q}) u"])
def test_a_rate_beside_what_it_is_of_is_no_other_place(written: str) -> None:
    kinds = {"q": "vector", "J": "tensor", "v": "vector", "u": "vector", "M": "tensor", r"\tau": "vector"}
    kinds |= {"g": "vector", "C": "tensor"}
    table = replace(
        SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()}),
        arguments=frozenset({Name("q")}),
    )
    assert read(f"{written} = v", table) == read(r"J v + \dot J u = v", table)
    with pytest.raises(ReadError, match="at two places"):
        read(r"J(q) v + \dot J(\dot q) u = v", table)
    forces = r"\tau - C(q, \dot q) \dot q - g(q)"
    assert read(rf"M^{{-1}}(q) ({forces}) = v", table) == read(r"M^{-1} [\tau - C \dot q - g] = v", table)
    for place in ("q + v", "2 q"):
        with pytest.raises(ReadError, match="or a product"):
            read(f"M({place}) = v", table)


@pytest.mark.parametrize("inside", [r"\dot\theta e", r"\theta e", r"\ddot\theta e", r"e \times f"])
def test_a_vector_is_no_other_place_of_a_number(inside: str) -> None:
    """r(θ̇ e) is a product where something depends on θ."""
    kinds = {"r": "scalar", r"\theta": "scalar", "e": "vector", "f": "vector"}
    table = replace(
        SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()}),
        arguments=frozenset({Name("\\theta"), Name("t")}),
    )
    assert read(rf"\dot r({inside}) = f", table) == read(rf"\dot r [{inside}] = f", table)
    for scalar in (r"2 \theta", r"\theta + 1", r"\Delta \theta"):
        with pytest.raises(ReadError):
            read(rf"r({scalar}) = r", table)


@pytest.mark.parametrize("symbol", ["v^T", "s", "v"])
def test_arguments_of_other_symbols_are_no_functions(symbol: str) -> None:
    """v^T (u - B v) was refused where B(v) is B: the u - B v holds the argument v."""
    kinds = {"s": "scalar", "h": "scalar", "v": "vector", "u": "vector", "B": "tensor"}
    table = SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()})
    table = replace(table, arguments=frozenset({Name("v"), Name("s")}))
    inside = "u - B(v) v" if symbol == "v^T" else "h - s"
    (product,) = read(f"{symbol}({inside}) = {symbol} [{inside}] + 0", table)
    assert read(to_latex(product), table) == (product,)
    with pytest.raises(ReadError, match="or a product"):
        read("h(h - s) = h", table)
