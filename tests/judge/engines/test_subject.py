"""What both engines take from `engines/inventory`: they would be wrong together, so each part is compared with what was
found by hand, and with what is found where definitions are written out."""

from itertools import product

import pytest

from workbench.engines.inventory import NotExact
from workbench.engines.inventory.angle_combinations import angles_of, sum_of_products, with_parts_of_angles
from workbench.engines.inventory.divisions import never_divides
from workbench.engines.inventory.elementary_functions import without_functions
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.inventory.parameters import parts
from workbench.engines.inventory.rodrigues import angle_and_axis, rotation_vector
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import expand
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula, read_term
from workbench.prover.decide.decide import Judge

KINDS = {
    **{name: {"kind": "vector"} for name in "abx"},
    **{name: {"kind": "scalar"} for name in ("f", "g", r"\alpha", r"\beta", "q", "p")},
    "c": {"kind": "scalar", "constant": True},
    "u": {"kind": "vector", "unit": True},
    r"\underline{u}": {"kind": "dual vector", "unit": True},
    "T": {"kind": "tensor"},
    "S": {"kind": "tensor", "symmetric": True},
    "R": {"kind": "rotation"},
    "r": {"kind": "vector", "of": ["q", "p"]},
    r"\underline{R}": {"kind": "dual rotation"},
    r"\underline{a}": {"kind": "dual vector"},
    "A": {"kind": "operator"},
    "Q": {"kind": "hamilton quaternion", "unit": True},
}
DEFINED = {
    "P": r"\mathbf{D} + T",
    "Z": "P P",
    "h": "2",
    "k": r"\frac{h f}{3}",
    "y": "-a",
    "z": r"\frac{y}{2}",
    "d": r"\ddot{a}",
    "W": r"\alpha \tilde{u}",
    "Y": r"-\frac{h}{4} W",
    "V": r"f \tilde{x}",
}
DEFINITIONS, TABLE = read_definitions(DEFINED, SymbolTable.build(KINDS))


def term(latex):
    return read_term(latex, TABLE, {})


#: The orders of the symbols, the circles of angles, how many reciprocals and norms.
INVENTORIES = {
    r"\dot{a}": ({"a": 1}, [], 0, 0),
    "d": ({"a": 2}, [], 0, 0),
    "P a": ({"T": 0, "a": 1}, [], 0, 0),
    "Z a": ({"T": 1, "a": 2}, [], 0, 0),
    "P d": ({"T": 0, "a": 3}, [], 0, 0),
    r"(\mathbf{D} + T)^3 a": ({"T": 2, "a": 3}, [], 0, 0),
    r"(\mathbf{D} T) (\mathbf{D} a)": ({"T": 1, "a": 1}, [], 0, 0),
    "P^2 P a": ({"T": 2, "a": 3}, [], 0, 0),
    r"\frac{d}{dt} (P a) - T a": ({"T": 1, "a": 2}, [], 0, 0),
    "A a": ({"A": 0, "a": 0}, [], 0, 0),
    r"\frac{a}{f} + T^{-1} b": ({"a": 0, "f": 0, "T": 0, "b": 0}, [], 2, 0),
    r"\|a\| + \sqrt{f}": ({"a": 0, "f": 0}, [], 2, 2),
    r"\sin \alpha + \cos(2 \beta)": ({r"\alpha": 0, r"\beta": 0}, [r"\alpha", r"\beta"], 0, 0),
    r"\sin(\frac{f g}{3}) + \sin(\frac{g f}{2})": ({"f": 0, "g": 0}, [r"\frac{1}{6} \left(f g\right)"], 2, 0),
    r"\sin \|z\|": ({"a": 0}, [r"\frac{1}{2} \left\|a\right\|"], 4, 2),
    r"\sin k": ({"f": 0}, ["f"], 1, 0),
    r"\exp W": ({r"\alpha": 0, "u": 0}, [r"\alpha"], 0, 0),
    r"\exp V": ({"f": 0, "x": 0}, [r"\left\|f x\right\|"], 2, 1),
    r"\frac{\partial r}{\partial q}": ({"r": 1, "q": 1, "p": 1}, [], 0, 0),
    r"\frac{\partial^2 r}{\partial q \partial p}": ({"r": 2, "q": 2, "p": 2}, [], 0, 0),
    r"\frac{\partial \dot{r}}{\partial \dot{q}}": ({"r": 2, "q": 2, "p": 2}, [], 0, 0),
    r"\ddot{r}": ({"r": 2, "q": 2, "p": 2}, [], 0, 0),
}


def told(terms, definitions):
    found = take_inventory(terms, definitions)
    orders = {to_latex(symbol): order for symbol, order in found.orders.items()}
    circles = [to_latex(angle) for angle in (*found.angles, *found.circles.values())]
    return orders, circles, found.reciprocals, found.norms


@pytest.mark.parametrize("latex", INVENTORIES)
def test_the_inventory_of_a_term_is_complete(latex):
    assert told([term(latex)], DEFINITIONS) == INVENTORIES[latex]


@pytest.mark.parametrize("one", INVENTORIES)
def test_the_inventory_of_two_terms_is_the_union(one):
    for other in INVENTORIES:
        both = [term(one), term(other)]
        orders, circles, *counts = told(both, DEFINITIONS)
        written = told([expand(each, DEFINITIONS) for each in both], DEFINITIONS)
        assert (orders, circles) == written[:2]
        mine, others = INVENTORIES[one], INVENTORIES[other]
        assert orders == {s: max(mine[0].get(s, 0), others[0].get(s, 0)) for s in {**mine[0], **others[0]}}
        assert all(max(a, b) <= n <= a + b for n, a, b in zip(counts, mine[2:], others[2:], strict=True))


@pytest.mark.parametrize(
    ("latex", "never"),
    [
        ("f^n", True),
        ("f^{n+1}", True),
        ("f^{n-1}", False),
        ("f^{1-n}", False),
        ("f^{-1}", False),
        (r"\frac{f}{g}", False),
        (r"\|a\|", False),
        ("T^{-1}", False),
        (r"\mathbf{D}^{n}", True),
        (r"T a \cdot b", True),
        (r"\sin f", True),
    ],
)
def test_terms_without_division_are_recognized(latex, never):
    assert never_divides(read_term(latex, TABLE, {"n": 0})) == never


@pytest.mark.parametrize(
    ("latex", "products"),
    [
        ("k", {"f": "2/3"}),
        ("3 f - 2 f", {"f": "1"}),
        ("f g f - 2 g f^2", {"f f g": "-1"}),
        ("(f + g)^2", {"f f": "1", "f g": "2", "g g": "1"}),
        ("f^0", {"": "1"}),
        (r"\frac{f + g}{h}", {"f": "1/2", "g": "1/2"}),
        (r"\frac{f}{2 g}", {r"\frac{1}{2 g} f": "1"}),
        (r"\frac{f}{h - 2}", {r"\frac{1}{h - 2} f": "1"}),
        (r"\frac{f}{f - f}", {r"\frac{1}{f - f} f": "1"}),
        ("-(f + 2)", {"f": "-1", "": "-2"}),
        ("0 f", {}),
        ("f - f", {"f": "0"}),
        (r"a \cdot b", {r"a \cdot b": "1"}),
        (r"\|2 a\|", {r"\left\|a\right\|": "2"}),
        (r"\|-f\|", {r"\left\|f\right\|": "1"}),
        ("\\|y\\|", {r"\left\|a\right\|": "1"}),
        ("\\|z\\|", {r"\left\|a\right\|": "1/2"}),
        (r"\|\frac{2 a}{3}\|", {r"\left\|a\right\|": "2/3"}),
        (r"\|-(2 (-3 a))\|", {r"\left\|a\right\|": "6"}),
        (r"\|f a\|", {r"\left\|f a\right\|": "1"}),
    ],
)
def test_scalars_multiplied_out(latex, products):
    found = sum_of_products(term(latex), DEFINITIONS)
    assert {" ".join(map(to_latex, factors)): str(c) for factors, c in found.items()} == products


@pytest.mark.parametrize(
    ("latex", "turn", "vector"),
    [
        ("W", (r"\alpha", "u"), r"\alpha u"),
        (
            "Y",
            (r"\left(-1\right) \left(\frac{h}{4} \alpha\right)", "u"),
            r"-\frac{h}{4} \left(\alpha u\right)",
        ),
        (r"\tilde{u}", None, "u"),
        (r"2 \widetilde{\alpha u} g", (r"2 \left(g \alpha\right)", "u"), r"2 \left(\alpha u\right) g"),
        (r"\widetilde{\frac{\alpha u}{2}}", (r"\frac{1}{2} \alpha", "u"), r"\frac{\alpha u}{2}"),
        (r"\tilde{u} \frac{f}{3} g", (r"g \frac{f}{3}", "u"), r"u \frac{f}{3} g"),
        ("V", None, "f x"),
        (r"-\frac{V}{2}", None, r"-\frac{f x}{2}"),
        (r"\tilde{x} - \tilde{a}", None, "x - a"),
        (r"\tilde{x} \tilde{a}", None, None),
        (r"\tilde{x} + T", None, None),
        (r"\alpha T", None, None),
        (r"\underline{f} \widetilde{\underline{u}}", (r"\underline{f}", r"\underline{u}"), None),
        (r"\widetilde{\underline{a}}", None, None),
    ],
)
def test_angle_and_axis_of_an_exponential_are_found(latex, turn, vector):
    table = TABLE.build(KINDS | {r"\underline{f}": {"kind": "dual scalar"}})
    read = read_term(latex, read_definitions(DEFINED, table)[1], {})
    found = angle_and_axis(read, DEFINITIONS)
    assert (found and tuple(map(to_latex, found))) == turn
    moved = rotation_vector(read, DEFINITIONS)
    assert (moved and to_latex(moved)) == vector


def test_of_an_angle_that_is_divided_the_part_is_free():
    halves = [
        term(r"\sin(\frac{\alpha}{2})"),
        term(r"\cos(\frac{\alpha}{h 3})"),
        term(r"\exp(-\frac{3}{4} f \tilde{u})"),
    ]
    known = with_parts_of_angles(halves, DEFINITIONS)
    parts_ = [{to_latex(a): str(c) for a, c in angles_of(each, known).items()} for each in halves]
    sixth, quarter = r"\frac{\alpha}{6}", r"\frac{f}{4}"
    assert parts_ == [{sixth: "3"}, {sixth: "1"}, {quarter: "-3"}]


@pytest.mark.parametrize(
    ("latex", "order", "found"),
    [
        ("a", 2, [("value", 3, 3)]),
        ("c", 2, [("value", 1, 1)]),
        ("S", 1, [("value", 6, 2)]),
        ("u", 2, [("unit", 3, 1), ("spin", 3, 2)]),
        ("R", 1, [("quaternion", 4, 1), ("spin", 3, 1)]),
        ("Q", 1, [("quaternion", 4, 1), ("spin", 3, 1)]),
        (r"\underline{u}", 1, [("unit", 3, 1), ("spin", 3, 1), ("moment", 3, 2)]),
        (r"\underline{R}", 1, [("quaternion", 4, 1), ("spin", 3, 1), ("translation", 3, 2)]),
        (r"\underline{a}", 1, [("value", 3, 2), ("dual", 3, 2)]),
        ("r", 2, [("value", 3, 1), ("slope1", 6, 1), ("slope2", 9, 1)]),
    ],
)
def test_the_parts_that_a_symbol_depends_on_are_found(latex, order, found):
    assert list(parts(term(latex), order)) == found


@pytest.mark.parametrize(
    ("formula", "supposed"),
    [
        (r"e^{2 f} e^{g - g} = e^{-f}", ["e^{f} \\neq 0"]),
        (
            r"\frac{d^2}{dt^2} e^{\frac{f}{2}} = g",
            [
                r"e^{\frac{1}{2} f} \neq 0",
                r"\dot{e^{\frac{1}{2} f}} = \left(\frac{1}{2} f\right)^{(1)} e^{\frac{1}{2} f}",
                r"\ddot{e^{\frac{1}{2} f}} = \left(\left(\frac{1}{2} f\right)^{(1)} e^{\frac{1}{2} f}\right)^{(1)}",
            ],
        ),
        (r"e^{\frac{f}{2}} e^{\frac{f}{3}} = e^k", [r"e^{\frac{1}{6} f} \neq 0"]),
    ],
)
def test_exponentials_get_their_premises(formula, supposed):
    (said,) = read_formula(formula, TABLE, {}).statements
    assert list(map(to_latex, without_functions(said, DEFINITIONS).supposed)) == supposed


@pytest.mark.parametrize(
    "formula", ["e^{21 f} = g", r"\frac{d^5}{dt^5} e^f = g", r"g = \frac{d}{dt} \frac{d^4}{dt^4} e^f"]
)
def test_unsupported_exponentials_are_not_exact(formula):
    (said,) = read_formula(formula, TABLE, {}).statements
    with pytest.raises(NotExact):
        without_functions(said, DEFINITIONS)


@pytest.mark.parametrize(
    ("size", "factor"), list(product((1, 2, 3), ("1", "2", r"\frac{1}{2}", r"\frac{1}{3}")))
)
def test_the_rate_of_an_exponential_has_the_chain_factor(size, factor):
    rate = rf"\frac{{d}}{{dt}} e^{{\frac{{f}}{{{size}}}}} = {factor} \dot{{f}} e^{{\frac{{f}}{{{size}}}}}"
    is_right = factor == (rf"\frac{{1}}{{{size}}}" if size > 1 else "1")
    (said,) = read_formula(rate, TABLE, {}).statements
    assert Judge(DEFINITIONS).judge(said).outcome == ("proved" if is_right else "refuted")
