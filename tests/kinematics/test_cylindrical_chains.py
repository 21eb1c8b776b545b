"""Cylindrical chains: the closed forms against the chain engine, laws, the printed text."""

from fractions import Fraction
from itertools import chain

import numpy as np
import pytest

from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import apply, cross, scale
from workbench.core.construct import relation
from workbench.core.verdict import Outcome
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.kinematics.chain import Joint, SerialChain
from workbench.kinematics.cylindrical_chains import (
    current_lines,
    latex_2c,
    latex_3c,
    twist_derivatives,
    twist_derivatives_2c,
    twist_derivatives_3c,
)
from workbench.kinematics.lines import line_through
from workbench.kinematics.screws import from_rodrigues_vector
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term
from workbench.prover.decide.decide import Judge

CLOSED_FORMS = {2: twist_derivatives_2c, 3: twist_derivatives_3c}


def rational(rng):
    return Fraction(int(rng.integers(-9, 10)), int(rng.integers(1, 6)))


def rational_line(rng):
    """A rational unit direction: the first axis turned by a rational rotation."""
    b = np.array([rational(rng) for _ in range(3)], dtype=object)
    direction = from_rodrigues_vector(Dual(b)).re[:, 0]
    return line_through(np.array([rational(rng) for _ in range(3)], dtype=object), direction)


def rational_chain(seed, joints, entries=4):
    rng = np.random.default_rng(seed)
    lines = [rational_line(rng) for _ in range(joints)]
    rates = [[Dual(rational(rng), rational(rng)) for _ in range(entries)] for _ in range(joints)]
    return lines, rates


def float_chain(seed, joints, entries, states=()):
    """Joints, their derivatives for the engine, and the same as lines and rates."""
    rng = np.random.default_rng(seed)
    directions, points = rng.normal(size=(2, joints, 3))
    engine = SerialChain([Joint.cylindrical(u, p) for u, p in zip(directions, points, strict=True)])
    q = rng.normal(size=(entries + 1, *states, 2 * joints))
    angles = [Dual(q[0, ..., 2 * i], q[0, ..., 2 * i + 1]) for i in range(joints)]
    homes = [line_through(p, u) for u, p in zip(directions, points, strict=True)]
    rates = [
        [Dual(q[k, ..., 2 * i], q[k, ..., 2 * i + 1]) for k in range(1, entries + 1)] for i in range(joints)
    ]
    return engine, q, current_lines(homes, angles), rates


def assert_close(actual, expected):
    actual = np.stack([np.concatenate([a.re, a.du], axis=-1) for a in actual])
    np.testing.assert_allclose(actual, expected, rtol=0, atol=1e-13 * np.abs(expected).max())


# -- laws -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("joints", [2, 3])
@pytest.mark.parametrize("seed", range(10))
def test_the_closed_forms_are_what_the_chain_engine_computes(joints, seed):
    engine, q, lines, rates = float_chain(seed, joints, 4)
    assert_close(CLOSED_FORMS[joints](lines, rates), engine.twist_derivatives(q))


@pytest.mark.parametrize("joints", [1, 2, 3, 5])
@pytest.mark.parametrize("entries", [1, 2, 5, 9])
def test_any_chain_at_any_order(joints, entries):
    engine, q, lines, rates = float_chain(3, joints, entries)
    assert_close(twist_derivatives(lines, rates), engine.twist_derivatives(q))


@pytest.mark.parametrize("joints", [2, 3])
@pytest.mark.parametrize("seed", range(10))
def test_closed_and_nested_forms_agree_exactly(joints, seed):
    lines, rates = rational_chain(seed, joints)
    assert CLOSED_FORMS[joints](lines, rates) == twist_derivatives(lines, rates)


@pytest.mark.parametrize("states", [(1,), (7,), (2, 3)])
def test_batches(states):
    engine, q, lines, rates = float_chain(1, 3, 4, states)
    assert_close(twist_derivatives_3c(lines, rates), engine.twist_derivatives(q))
    assert_close(twist_derivatives(lines, rates), engine.twist_derivatives(q))


@pytest.mark.parametrize("seed", range(5))
def test_equivariance_under_rational_displacements(seed):
    lines, rates = rational_chain(seed, 3)
    rng = np.random.default_rng(100 + seed)
    b = Dual(*(np.array([rational(rng) for _ in range(3)], dtype=object) for _ in range(2)))
    R = from_rodrigues_vector(b)
    moved = twist_derivatives_3c([apply(R, u) for u in lines], rates)
    assert moved == tuple(apply(R, w) for w in twist_derivatives_3c(lines, rates))


@pytest.mark.parametrize("resting", [0, 1, 2])
def test_a_joint_at_rest_is_no_joint(resting):
    lines, rates = rational_chain(1, 3)
    rates[resting] = [Dual(0)] * 4
    others = [i for i in range(3) if i != resting]
    expected = twist_derivatives_2c([lines[i] for i in others], [rates[i] for i in others])
    assert twist_derivatives_3c(lines, rates) == expected


@pytest.mark.parametrize("first", [0, 1])
def test_two_joints_on_one_line_are_one_joint(first):
    (u, v), rates = rational_chain(2, 2)
    extra = rational_chain(4, 2)[1][0]
    lines = [u, u, v] if first == 0 else [u, v, v]
    both = [*rates[: first + 1], extra, *rates[first + 1 :]]
    merged = [list(row) for row in rates]
    merged[first] = [a + b for a, b in zip(rates[first], extra, strict=True)]
    assert twist_derivatives_3c(lines, both) == twist_derivatives_2c([u, v], merged)


def test_steady_rotation_about_two_lines():
    """Constant rates: ω̲̇ = ω̲₁ω̲₂ u̲₁ × u̲₂, as for a disc that spins on a turning arm, and ω̲₁ u̲₁
    turns it on: each further derivative is ω̲₁ u̲₁ × the one before."""
    (u1, u2), rates = rational_chain(7, 2)
    (w1, *_), (w2, *_) = rates
    rates = [[w, Dual(0), Dual(0), Dual(0)] for w in (w1, w2)]
    _, first, second, third = twist_derivatives_2c([u1, u2], rates)
    assert first == scale(w1 * w2, cross(u1, u2))
    assert second == scale(w1, cross(u1, first))
    assert third == scale(w1, cross(u1, second))


# -- the printed text -----------------------------------------------------------------------------

#: Section 8 with the marks that the transcription lost put back: two dots on ω₁ in ω̲̈₁ω̲₂.
CHAPTER = (
    r"W = w_1 u_1 + w_2 u_2",
    r"\dot{W} = \dot{w}_1 u_1 + \dot{w}_2 u_2 + w_1 w_2 u_1 \times u_2",
    r"\ddot{W} = \ddot{w}_1 u_1 + \ddot{w}_2 u_2 + (2 w_1 \dot{w}_2 + \dot{w}_1 w_2) u_1 \times u_2"
    r" + w_1^2 w_2 u_1 \times (u_1 \times u_2)",
    r"\dddot{W} = \dddot{w}_1 u_1 + \dddot{w}_2 u_2 + (\ddot{w}_1 w_2 + 3 \dot{w}_1 \dot{w}_2"
    r" + 3 w_1 \ddot{w}_2 - w_1^3 w_2) u_1 \times u_2"
    r" + 3 (w_1^2 \dot{w}_2 + \dot{w}_1 w_1 w_2) u_1 \times (u_1 \times u_2)",
    r"\dddot{W} = [\dddot{w}_1 + 3 (w_1^2 \dot{w}_2 + \dot{w}_1 w_1 w_2) u_1 \cdot u_2] u_1"
    r" + [\dddot{w}_2 - 3 (w_1^2 \dot{w}_2 + \dot{w}_1 w_1 w_2)] u_2 + (\ddot{w}_1 w_2"
    r" + 3 \dot{w}_1 \dot{w}_2 + 3 w_1 \ddot{w}_2 - w_1^3 w_2) u_1 \times u_2",
)


def notation(joints):
    table = {r"\underline{\boldsymbol{\omega}}": {"kind": "dual vector", "weight": 1}}
    table[r"\underline{\boldsymbol{\omega}}"]["aliases"] = ["W"]
    for i in range(1, joints + 1):
        table[rf"\underline{{\omega}}_{i}"] = {
            "kind": "dual scalar",
            "weight": 1,
            "aliases": [f"w_{i}"],
        }
        table[rf"\underline{{\mathbf{{u}}}}_{i}"] = {
            "kind": "dual vector",
            "weight": 0,
            "aliases": [f"u_{i}"],
            "unit": i < joints,
        }
    return SymbolTable.build(table)


def test_2c_is_printed_as_in_the_chapter():
    table = notation(2)
    ours = (*latex_2c(), latex_2c(expanded=True)[3])
    for mine, printed in zip(ours, CHAPTER, strict=True):
        (a,), (b,) = read(mine, table), read(printed, table)
        assert a.left == b.left
        if a.right != b.right:
            verdict = Judge(Definitions()).judge(relation("=", a.right, b.right))
            assert verdict.outcome == Outcome.PROVED


@pytest.mark.parametrize("expanded", [False, True])
@pytest.mark.parametrize(("joints", "latex"), [(2, latex_2c), (3, latex_3c)])
def test_each_printed_line_is_a_derivative_of_the_twist(joints, latex, expanded):
    """Reading checks that every addend carries one power of time more than the line before."""
    formulas = latex(expanded)
    assert len(formulas) == 4
    for dots, formula in zip(("", r"\dot", r"\ddot", r"\dddot"), formulas, strict=True):
        (statement,) = read(formula, notation(joints))
        twist = r"\underline{\boldsymbol{\omega}}"
        assert (
            read(f"{dots}{{{twist}}} = 0" if dots else f"{twist} = 0", notation(joints))[0].left
            == statement.left
        )
        assert to_latex(statement)


def _as_printed(joints, formulas):
    """The right sides, the lines and the rates, in polynomials over the letters."""
    table = notation(joints)
    lines = [read_term(f"u_{i}", table) for i in range(1, joints + 1)]
    dots = ("{}", r"\dot{{{}}}", r"\ddot{{{}}}", r"\dddot{{{}}}")
    rates = [[read_term(d.format(f"w_{i}"), table) for d in dots] for i in range(1, joints + 1)]
    sides = [read(formula, table)[0].right for formula in formulas]
    inventory = take_inventory([*sides, *lines, *chain.from_iterable(rates)], Definitions())
    engine = ExactEngine(inventory, Definitions())

    def value(term):
        parts = engine.parts(engine.value(term))
        if len(parts) == 2:
            return Dual(*parts)
        columns = np.empty(6, dtype=object)
        columns[:] = parts
        return Dual(columns[:3], columns[3:])

    reduced = np.frompyfunc(engine.ring.reduce, 1, 1)
    values = [value(u) for u in lines], [[value(w) for w in row] for row in rates]
    return [value(side) for side in sides], *values, reduced


@pytest.mark.parametrize("expanded", [False, True])
@pytest.mark.parametrize(("joints", "latex"), [(2, latex_2c), (3, latex_3c)])
def test_the_functions_compute_what_is_printed(joints, latex, expanded):
    formulas = latex(expanded)
    wrong = [*formulas[:3], formulas[3].replace("3", "2", 1)]
    for said, same in ((formulas, [True] * 4), (wrong, [True, True, True, False])):
        sides, lines, rates, reduced = _as_printed(joints, said)
        found = [side - own for side, own in zip(sides, CLOSED_FORMS[joints](lines, rates), strict=True)]
        assert [not any([*reduced(d.re), *reduced(d.du)]) for d in found] == same


# -- bad input ------------------------------------------------------------------------------------


def test_counts_that_do_not_fit():
    lines, rates = rational_chain(0, 3)
    with pytest.raises(ValueError, match="expected 2 lines, got 3"):
        twist_derivatives_2c(lines, rates)
    with pytest.raises(ValueError, match="expected the rates of 3 joints, got those of 2"):
        twist_derivatives_3c(lines, rates[:2])
    with pytest.raises(ValueError, match="joint 2: expected its rate and 3 derivatives"):
        twist_derivatives_3c(lines, [rates[0], rates[1][:3], rates[2]])
    with pytest.raises(ValueError, match="joint 3: expected its rate and 3 derivatives"):
        twist_derivatives(lines, [*rates[:2], rates[2][:2]])
    with pytest.raises(ValueError, match="expected at least 1 lines"):
        twist_derivatives([], [])
