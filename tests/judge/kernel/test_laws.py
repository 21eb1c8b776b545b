"""What can be solved for a free symbol's derivative is a law, and neither true nor false."""

from __future__ import annotations

from dataclasses import replace

import pytest
from evaluator.identities import TABLE

from workbench import check
from workbench.context.claims import Notation
from workbench.context.read_formulas import read_statement
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Derivative, Relation
from workbench.core.verdict import Outcome
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.definitions import Definitions
from workbench.prover.decide.law_statements import law_for

SYMBOLS = {
    **{name: "vector" for name in ("p", "g", "a", "b", "v", "F", r"\omega", "M", "d")},
    **{name: "scalar" for name in ("f", "h")},
    "m": {"kind": "scalar", "constant": True},
    r"\mu": {"kind": "scalar", "constant": True},
    "J": {"kind": "tensor", "symmetric": True, "constant": True},
    "T": "tensor",
    "R": "rotation",
    "u": {"kind": "vector", "unit": True},
    "q": {"kind": "hamilton quaternion", "unit": True},
}


@pytest.mark.parametrize(
    ("law", "derivative"),
    [
        (r"m \ddot{p} = m g", r"\ddot{p}"),
        (r"\frac{d}{dt}(m v) = F", r"\dot{v}"),
        (r"J \dot{\omega} + \omega \times (J \omega) = M", r"\dot{\omega}"),
        (r"\frac{d}{dt}(J \omega) = -\omega \times (J \omega)", r"\dot{\omega}"),
        (r"\dot{R} = \tilde{\omega} R", r"\dot{R}"),
        (r"\dot{u} = \omega \times u", r"\dot{u}"),
        (r"\dot{q} = \frac{1}{2} \operatorname{quat}(0, \omega) q", r"\dot{q}"),
        (r"\ddot{p} = -\frac{\mu}{\|p\|^3} p", r"\ddot{p}"),
    ],
)
def test_laws(law: str, derivative: str) -> None:
    said = check(law, SYMBOLS)
    assert said.outcome == Outcome.UNCHECKED
    assert f"states a law for {derivative}," in said.verdict.reason


@pytest.mark.parametrize(
    "falsehood",
    [
        r"\frac{d}{dt}(f h) = f \dot{h}",
        r"\frac{d}{dt}(a \times b) = \dot{a} \times b",
        r"\frac{d}{dt}(T a) = \dot{T} a - T \dot{a}",
        r"\dot{u} = 2 u",
        r"\dot{R} = R",
        r"\dot{q} = q",
        r"u \cdot \dot{u} = f",
        r"a = b",
    ],
)
def test_falsehoods_about_derivatives_are_no_laws(falsehood: str) -> None:
    assert check(falsehood, SYMBOLS).outcome in (Outcome.REFUTED, Outcome.ILL_FORMED)


UNIT_COLUMNS = ("(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)")
COORDINATES = {
    **{name: {"kind": "scalar", "independent": True} for name in ("x", "y")},
    "V": {"kind": "scalar", "of": ["x", "y"]},
}


@pytest.mark.parametrize(
    "wrong",
    [
        r"\dot{V} = \frac{\partial V}{\partial x} \dot{x} - \frac{\partial V}{\partial y} \dot{y}",
        r"\dot{V} = \frac{\partial V}{\partial x} \dot{x}",
    ],
)
def test_a_mistaken_chain_rule_is_no_law(wrong: str) -> None:
    """The rates of x and y stand in dV/dt, too."""
    assert check(wrong, COORDINATES).outcome == Outcome.REFUTED
    law = check(r"\ddot{x} = -\frac{\partial V}{\partial x}", COORDINATES)
    assert law.outcome == Outcome.UNCHECKED and "law" in law.verdict.reason


COLUMN = {"z": r"\begin{bmatrix} x \\ y \\ f \end{bmatrix}"}
NUMBERS = {name: "scalar" for name in ("x", "y", "f", "h")}


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\dot{z} = R v", Outcome.UNCHECKED),
        (r"\frac{d}{dt}(h z) = v", Outcome.UNCHECKED),
        (r"\dot{z} = x v", Outcome.UNCHECKED),
        (r"\dot{z} = 2 \dot{z}", Outcome.REFUTED),
        (r"\frac{d}{dt}(h z) = h \dot{z}", Outcome.REFUTED),
        (r"\dot{z} = \dot{x} v", Outcome.REFUTED),
        (r"\begin{bmatrix} 0 & 0 & 1 \end{bmatrix} z = x", Outcome.REFUTED),
    ],
)
def test_a_column_of_free_symbols_is_free(formula: str, outcome: Outcome) -> None:
    symbols = {"R": "rotation", "v": "vector", **NUMBERS}
    definitions = [f"{name} = {body}" for name, body in COLUMN.items()]
    said = check(formula, symbols, definitions=definitions)
    assert said.outcome == outcome
    if outcome is Outcome.UNCHECKED:
        assert r"states a law for \dot{z}," in said.verdict.reason


TURNING = {
    "Q": r"\begin{bmatrix} \cos(n t) & -\sin(n t) & 0 \\ \sin(n t) & \cos(n t) & 0 \\ 0 & 0 & 1 \end{bmatrix}",
    "r": r"x Q e_x + y Q e_y + f Q e_z",
    r"\omega": r"n e_z",
}


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"m \ddot{r} = F", Outcome.UNCHECKED),
        (r"\ddot{r} = -\frac{\mu}{m} r", Outcome.UNCHECKED),
        (r"\dot{r} = \omega \times r", Outcome.REFUTED),
        (r"\ddot{r} = \omega \times (\omega \times r)", Outcome.REFUTED),
        (r"\ddot{r} = \ddot{x} Q e_x + \ddot{y} Q e_y + F", Outcome.REFUTED),
        (r"\ddot{r} = \ddot{r} + F", Outcome.REFUTED),
    ],
)
def test_forces_move_what_has_components_in_turning_axes(formula: str, outcome: Outcome) -> None:
    """A mistake in what r̈ is by its components has no symbol that they do not have."""
    constants = {name: {"kind": "scalar", "constant": True} for name in ("m", r"\mu", "n")}
    axes = {f"e_{axis}": "vector" for axis in "xyz"}
    columns = {f"e_{a}": [r"1\\0\\0", r"0\\1\\0", r"0\\0\\1"][i] for i, a in enumerate("xyz")}
    units = {name: rf"\begin{{bmatrix}} {entries} \end{{bmatrix}}" for name, entries in columns.items()}
    symbols = {
        "Q": "tensor",
        "r": "vector",
        "F": "vector",
        r"\omega": "vector",
        **axes,
        **constants,
        **NUMBERS,
    }
    said = check(formula, symbols, definitions={**units, **TURNING})
    assert said.outcome == outcome
    if outcome is Outcome.UNCHECKED:
        assert r"states a law for \ddot{r}," in said.verdict.reason


MEMBERS = {"z": r"\begin{bmatrix} x_1 \\ x_2 \\ x_3 \end{bmatrix}"}


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\dot{z} = (1 - z \cdot z) v + z \times v", Outcome.UNCHECKED),
        (r"\dot{x}_2 = f", Outcome.UNCHECKED),
        (r"\frac{d}{dt}(x_2 f) = x_2 \dot{f}", Outcome.REFUTED),
        (r"\dot{y}_2 = f", Outcome.REFUTED),
    ],
)
def test_members_of_an_undefined_family_are_free(formula: str, outcome: Outcome) -> None:
    symbols = {"v": "vector", "x_n": "scalar", "y_n": "scalar", "f": "scalar"}
    definitions = [*(f"{name} = {body}" for name, body in MEMBERS.items()), r"y_{n+1} = \dot{y}_n"]
    assert check(formula, symbols, definitions=definitions).outcome == outcome


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\dot{q} = \frac{1}{2} \operatorname{quat}(0, v) q", Outcome.UNCHECKED),
        (r"\dot{q}^* = -\frac{1}{2} q^* \operatorname{quat}(0, v)", Outcome.UNCHECKED),
        (r"\frac{d}{dt}(f q) = f \dot{q}", Outcome.REFUTED),
        (r"\dot{p} = \operatorname{quat}(0, v) p", Outcome.REFUTED),
    ],
)
def test_a_quaternion_of_free_components_is_free(formula: str, outcome: Outcome) -> None:
    symbols = {"v": "vector", "q": "hamilton quaternion", "p": "hamilton quaternion", **NUMBERS}
    symbols |= {name: "scalar" for name in ("a", "b", "c", "d")}
    q = r"\operatorname{quat}(a, \begin{bmatrix} b \\ c \\ d \end{bmatrix})"
    p = r"\operatorname{quat}(a, \begin{bmatrix} b \\ c \\ c \end{bmatrix})"
    definitions = [f"q = {q}", f"p = {p}"]
    assert check(formula, symbols, definitions=definitions).outcome == outcome


WRITTEN_BY_UNITS = {
    **{
        name: rf"\operatorname{{quat}}(0, {column})" for name, column in zip("IJK", UNIT_COLUMNS, strict=True)
    },
    "q": "h + I x + J y + K f",
    "W": r"2 \dot{q} q^{-1}",
    "H": r"K I x + J y",
}


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\dot{q} = \frac{1}{2} q I", Outcome.UNCHECKED),
        (r"\dot{q} = \frac{1}{2} V q", Outcome.UNCHECKED),
        (r"\dot{q}^* = -q^* V", Outcome.UNCHECKED),
        (r"\dot{q} = \frac{1}{2} W q", Outcome.CONDITIONAL),
        (r"\dot{q} = \frac{1}{2} q W", Outcome.REFUTED),
        (r"\dot{q} = \dot{h} + I \dot{x} + J \dot{y} - K \dot{f}", Outcome.REFUTED),
        (r"\dot{q} = \frac{d}{dt}(h + I x)", Outcome.REFUTED),
        (r"\frac{d}{dt}(V q) = V \dot{q}", Outcome.REFUTED),
        (r"\dot{H} = I", Outcome.REFUTED),
        (r"q = V", Outcome.REFUTED),
    ],
)
def test_a_quaternion_that_is_a_sum_along_its_units_is_free(formula: str, outcome: Outcome) -> None:
    symbols = {**dict.fromkeys((*WRITTEN_BY_UNITS, "V"), "hamilton quaternion"), **NUMBERS}
    assert check(formula, symbols, definitions=WRITTEN_BY_UNITS).outcome == outcome


RESOLVED = {**dict(zip(("e_1", "e_2", "e_3"), UNIT_COLUMNS, strict=True)), "r": "x e_1 + y e_2 + f e_3"}


@pytest.mark.parametrize(
    ("formula", "named"),
    [
        (r"\ddot{r} = -r", r"\ddot{r}"),
        (r"\dot{v} = -v", r"\dot{v}"),
        (r"v = 2 r", "v"),
        (r"\dot{v} = g", r"\dot{v}"),
        (r"\dot{r} = \dot{x} e_1 + \dot{y} e_2", None),
        (r"v = \dot{x} e_1 + \dot{y} e_2", None),
        (r"\dot{v} = \ddot{x} e_1 + g", None),
        (r"\frac{d}{dt}(h r) = h v", None),
        ("r = g", None),
    ],
)
def test_a_sum_along_fixed_axes_is_free(formula: str, named: str | None) -> None:
    symbols = {**dict.fromkeys(("e_1", "e_2", "e_3", "r", "v", "g"), "vector"), **NUMBERS}
    said = check(formula, symbols, definitions={**RESOLVED, "v": r"\dot{r}"})
    if named is None:
        assert said.outcome == Outcome.REFUTED
    else:
        assert f"states a law for {named}," in (said.verdict.reason or "")


def test_laws_of_defined_symbols_are_found() -> None:
    said = check(r"\dot{L} + \omega \times L = \mathbf{0}", SYMBOLS, definitions=[r"L = J \omega"])
    assert said.outcome == Outcome.UNCHECKED and r"a law for \dot{\omega}," in said.verdict.reason


def test_an_equation_between_defined_symbols_is_no_law() -> None:
    definitions = {"k": r"\operatorname{vect}(\dot{R} R^T)"}
    symbols = {"R": "rotation", "a": "vector"}
    assert check(r"\dot{R} = \tilde{k} R", symbols, definitions=definitions).outcome == Outcome.PROVED
    assert check(r"\dot{R} = R \tilde{k}", symbols, definitions=definitions).outcome == Outcome.REFUTED


def test_a_law_that_is_assumed_proves() -> None:
    said = check(r"\dot{p} \cdot \ddot{p} = \dot{p} \cdot g", SYMBOLS, assume=[r"\ddot{p} = g"])
    assert said.outcome == Outcome.PROVED


@pytest.mark.parametrize(
    ("rate", "outcome"), [(r"\ddot\phi", "refuted"), (r"\dot\phi", "proved"), (r"2 \dot\phi", "refuted")]
)
def test_a_wrong_rate_of_what_is_defined_is_no_law(rate: str, outcome: str) -> None:
    """ė = φ̈ n of e = (cos φ, sin φ, 0) was a law for φ̈."""
    columns = {"e": r"\cos\phi \\ \sin\phi", "n": r"-\sin\phi \\ \cos\phi"}
    known = [rf"{name} = \begin{{bmatrix}} {body} \\ 0 \end{{bmatrix}}" for name, body in columns.items()]
    symbols = {r"\phi": "scalar", "g": {"kind": "scalar", "constant": True}}
    assert check(rf"\dot e = {rate} n", symbols=symbols, definitions=known).outcome == outcome


def test_a_derivative_of_a_general_order_is_no_law() -> None:
    """The text of notebook 2 states aₙ = v⁽ⁿ⁾ + … for each n."""
    notation = Notation(TABLE, Definitions([]), {})
    relation = read_statement(r"\dot{a} = \dot{b}", notation, None)[0]
    assert isinstance(relation, Relation) and isinstance(relation.left, Derivative)
    general = replace(relation, left=replace(relation.left, order=Linear.variable("n")))
    inventory = take_inventory([relation.left, relation.right], notation.definitions)
    assert law_for(relation, inventory, notation.definitions) is not None
    assert law_for(general, inventory, notation.definitions) is None
