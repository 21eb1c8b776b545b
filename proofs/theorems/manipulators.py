"""Section 8: the 2C manipulator, Eqs. (143)–(147), and the 3C manipulator that it leaves to the reader.

Each theorem is proved twice over polynomials, from two different descriptions of the motion:

* FLINT: the lines go through free points, which move as points of the bodies before them do;
  the twist Σ ω̲ᵢ u̲ᵢ is differentiated by the ring's derivation.
* SymPy: the bodies' poses are products of 4×4 matrix exponentials in truncated powers of t,
  Eqs. (117) and (136)–(138), and the twist is Ṫ T⁻¹, Eq. (118). The first line is the z axis and
  the x axis is normal to the first two lines: a frame that every pair of lines has.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache, lru_cache, partial
from math import factorial
from typing import Any

import numpy as np

from workbench.algebra.differential_ring import DifferentialRing
from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import cross, scale
from workbench.judge.first.exact import ExactEngine
from workbench.judge.second.jets import JetEngine
from workbench.judge.second.rings import PointSource
from workbench.judge.subject.inventory import take_inventory
from workbench.judge.theorems.arguments import Engine, Step, Way, argue, vanishing, vanishing_to
from workbench.judge.verdict import Verdict
from workbench.kinematics.cylindrical_chains import (
    current_lines,
    latex_2c,
    latex_3c,
    twist_derivatives,
    twist_derivatives_2c,
    twist_derivatives_3c,
)
from workbench.kinematics.frames import chapter_twist
from workbench.kinematics.lines import line_through
from workbench.language.definitions import Definitions
from workbench.language.reader import read, read_term
from workbench.language.symbols import SymbolTable

TwistDerivatives = Callable[[Sequence[Dual], Sequence[Sequence[Dual]]], tuple[Dual, ...]]

DRAKE_TOLERANCE = 1e-9  # of the largest entry; the references' own errors reach 1e-11 of it


@cache
def closed_form_2c() -> Verdict:
    """Eqs. (143)–(147) give the dual twist of the 2C manipulator and its first three derivatives."""
    return _closed_form(2, twist_derivatives_2c, latex_2c)


@cache
def closed_form_3c() -> Verdict:
    """`latex_3c` gives the dual twist of the 3C manipulator and its first three derivatives."""
    return _closed_form(3, twist_derivatives_3c, latex_3c)


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        closed_form_2c,
        closed_form_3c,
    )
}


def _closed_form(
    joints: int, formulas: TwistDerivatives, latex: Callable[[bool], tuple[str, ...]]
) -> Verdict:
    name = f"the {joints}C manipulator"
    return argue(
        [
            Step(
                f"{name}: the closed forms are the twist and its derivatives to order 3",
                *_ways(joints, formulas, entries=4),
            ),
            Step(
                f"{name}: Eq. (133) nested gives the same to order 4",
                *_ways(joints, twist_derivatives, entries=5),
            ),
            Step(
                f"{name}: the printed products say the same",
                *_printed_ways(joints, latex(False), formulas),
            ),
            Step(
                f"{name}: expanded as in (147), they say the same",
                *_printed_ways(joints, latex(True), formulas),
            ),
        ]
    )


def _ways(joints: int, formulas: TwistDerivatives, entries: int) -> list[Way]:
    wrong = _misprinted(formulas)
    ways = [
        Way(
            engine,
            vanishing(partial(chain(joints, entries).residuals, formulas)),
            but_not=vanishing(partial(chain(joints, entries).residuals, wrong)),
        )
        for engine, chain in ((Engine.FLINT, FlintChain), (Engine.SYMPY, SympyChain))
    ]
    check = vanishing_to(DRAKE_TOLERANCE, partial(_drake_residuals, joints, formulas, entries))
    but_not = vanishing_to(DRAKE_TOLERANCE, partial(_drake_residuals, joints, wrong, entries))
    return [*ways, Way(Engine.DRAKE, check, but_not)]


def _printed_ways(joints: int, latex: Sequence[str], formulas: TwistDerivatives) -> Iterator[Way]:
    for engine, printed in (
        (Engine.FLINT, _printed_in_flint),
        (Engine.SYMPY, _printed_in_sympy),
    ):
        yield Way(
            engine,
            vanishing(partial(printed, joints, latex, formulas)),
            but_not=vanishing(partial(printed, joints, latex, _misprinted(formulas))),
        )


def _misprinted(formulas: TwistDerivatives) -> TwistDerivatives:
    """The formulas with one coefficient of ω̲⃛ wrong: −ω̲₁³ω̲₂ u̲₁ × u̲₂ stands there twice."""

    def misprinted(lines: Sequence[Dual], rates: Sequence[Sequence[Dual]]) -> tuple[Dual, ...]:
        right = formulas(lines, rates)
        w1, w2 = rates[0][0], rates[1][0]
        extra = scale(-(w1 * w1 * w1 * w2), cross(lines[0], lines[1]))
        return (*right[:3], right[3] + extra, *right[4:])

    return misprinted


def _rates(joints: int, entries: int, value: Callable[[str], Any]) -> list[list[Dual]]:
    """ω̲ᵢ⁽ᵏ⁾ = wi_k + ε di_k for every joint i and k < entries."""
    return [[Dual(value(f"w{i}_{k}"), value(f"d{i}_{k}")) for k in range(entries)] for i in range(joints)]


def _rate_names(joints: int, entries: int) -> list[str]:
    return [f"{part}{i}_{k}" for i in range(joints) for k in range(entries) for part in "wd"]


def _array(entries: Sequence[Any]) -> np.ndarray:
    array = np.empty(len(entries), dtype=object)
    array[:] = entries
    return array


class FlintChain:
    """Unit directions and points of the lines are free; points and directions are carried along."""

    def __init__(self, joints: int, entries: int) -> None:
        directions = [[f"{axis}{i}" for axis in "abc"] for i in range(joints)]
        points = [[f"{axis}{i}" for axis in "xyz"] for i in range(joints)]
        names = [n[0] for n in directions] + [name for n in directions for name in n[1:]]
        rates = _rate_names(joints, entries)
        self.ring = ring = DifferentialRing([*names, *(n for p in points for n in p), *rates])
        generator = ring.generators
        self._u = [_array([generator[n] for n in names]) for names in directions]
        self._p = [_array([generator[n] for n in names]) for names in points]
        self.rates = _rates(joints, entries, generator.__getitem__)
        for i in range(joints):
            a, b, c = directions[i]
            ring.square_as(a, ring.one - generator[b] ** 2 - generator[c] ** 2)
            for name, rate in zip(directions[i], self._rate_of_direction(i), strict=True):
                ring.derive_as(name, rate)
            for name, rate in zip(points[i], self._rate_of_point(i), strict=True):
                ring.derive_as(name, rate)
            for k in range(entries - 1):
                ring.derive_as(f"w{i}_{k}", generator[f"w{i}_{k + 1}"])
                ring.derive_as(f"d{i}_{k}", generator[f"d{i}_{k + 1}"])
        self.lines = [Dual(u, cross(p, u)) for u, p in zip(self._u, self._p, strict=True)]

    def _rate_of_direction(self, i: int) -> np.ndarray:
        rate = _array([self.ring.zero] * 3)
        for j in range(i):
            rate = rate + scale(self.rates[j][0].re, cross(self._u[j], self._u[i]))
        return rate

    def _rate_of_point(self, i: int) -> np.ndarray:
        velocity = _array([self.ring.zero] * 3)
        for j in range(i):
            turn = cross(self._u[j], self._p[i] - self._p[j])
            rate = self.rates[j][0]
            velocity = velocity + scale(rate.re, turn) + scale(rate.du, self._u[j])
        return velocity

    def residuals(self, formulas: TwistDerivatives) -> Iterator[Dual]:
        derive, reduce = (np.frompyfunc(f, 1, 1) for f in (self.ring.derive, self.ring.reduce))
        twist = Dual(_array([self.ring.zero] * 3))
        for u, w in zip(self.lines, self.rates, strict=True):
            twist = twist + scale(w[0], u)
        for k, claimed in enumerate(formulas(self.lines, self.rates)):
            if k > 0:
                twist = Dual(derive(twist.re), derive(twist.du))
            difference = twist - claimed
            yield Dual(reduce(difference.re), reduce(difference.du))


class SympyChain:
    """Poses as products of exponentials of 4×4 matrices, in powers of t up to that of `entries`."""

    def __init__(self, joints: int, entries: int) -> None:
        from workbench.judge.second.sympy_gate import QQ, lex, polynomial_ring

        self.order, self._fraction = entries, QQ
        names = ["s", "c", "l", *(f"{part}{axis}" for part in "vm" for axis in "xyz")]
        ring, *generators = polynomial_ring([*names, *_rate_names(joints, entries)], QQ, lex)
        g = dict(zip([*names, *_rate_names(joints, entries)], generators, strict=True))
        zero, one = ring.zero, ring.one
        relation = [g["s"] ** 2 + g["c"] ** 2 - 1]
        self._reduce = np.frompyfunc(lambda p: p.rem(relation), 1, 1)
        self._zero = _array([zero] * 16).reshape(4, 4)
        self._one = self._zero.copy()
        np.fill_diagonal(self._one, one)
        self.lines = [
            Dual(_array([zero, zero, one]), _array([zero] * 3)),
            Dual(_array([zero, -g["s"], g["c"]]), _array([zero, -g["l"] * g["c"], -g["l"] * g["s"]])),
            Dual(*(_array([g[f"{part}{axis}"] for axis in "xyz"]) for part in "vm")),
        ][:joints]
        self.rates = _rates(joints, entries, g.__getitem__)

    def residuals(self, formulas: TwistDerivatives) -> Iterator[np.ndarray]:
        for claimed, twist in zip(formulas(self.lines, self.rates), self._twist_derivatives(), strict=True):
            yield self._reduce(_array([*claimed.re, *claimed.du]) - twist)

    def _twist_derivatives(self) -> Iterator[np.ndarray]:
        pose, inverse = self._identity(), self._identity()
        for i in range(len(self.lines)):
            pose = self._product(pose, self._exponential(self._joint(i, 1)))
            inverse = self._product(self._exponential(self._joint(i, -1)), inverse)
        velocity = [pose[k + 1] * (k + 1) for k in range(self.order)]
        for k in range(self.order):
            V = sum((velocity[j] @ inverse[k - j] for j in range(k + 1)), self._zero)
            yield _array([V[2, 1], V[0, 2], V[1, 0], *V[:3, 3]]) * factorial(k)

    def _joint(self, i: int, sign: int) -> list[np.ndarray]:
        """±(α(t) û + d(t) [0 u; 0 0]): the powers of t of the joint's matrix, α(0) = d(0) = 0."""
        u, u0 = self.lines[i].re, self.lines[i].du
        powers = [self._zero]
        for k, rate in enumerate(self.rates[i]):
            factor = self._fraction(sign, factorial(k + 1))
            matrix = self._zero.copy()
            matrix[0, 1], matrix[0, 2], matrix[1, 2] = -u[2], u[1], -u[0]
            matrix[1, 0], matrix[2, 0], matrix[2, 1] = u[2], -u[1], u[0]
            matrix = matrix * (rate.re * factor)
            matrix[:3, 3] = u0 * (rate.re * factor) + u * (rate.du * factor)
            powers.append(matrix)
        return powers

    def _identity(self) -> list[np.ndarray]:
        return [self._one, *[self._zero] * self.order]

    def _exponential(self, exponent: list[np.ndarray]) -> list[np.ndarray]:
        """The exponent has no constant term, so the sum is finite up to the highest power of t."""
        power = total = self._identity()
        for k in range(1, self.order + 1):
            power = self._product(power, exponent)
            inverse = self._fraction(1, factorial(k))
            total = [a + b * inverse for a, b in zip(total, power, strict=True)]
        return total

    def _product(self, A: list[np.ndarray], B: list[np.ndarray]) -> list[np.ndarray]:
        return [
            self._reduce(sum((A[j] @ B[k - j] for j in range(k + 1)), self._zero))
            for k in range(self.order + 1)
        ]


@lru_cache(maxsize=1)
def _drake_motion(joints: int, order: int) -> tuple[Any, ...]:
    """Lines and joint derivatives at an instant of a plant, and Drake's dual twist and derivatives."""
    from workbench.drake.joint_paths import JointPath
    from workbench.drake.plants import CylindricalAxis, body_motion, cylindrical_chain
    from workbench.drake.references import twist_derivatives as drake_twist_derivatives

    random = np.random.default_rng(8)
    directions = random.normal(size=(joints, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    points = random.normal(size=(joints, 3))
    names = [f"C{i + 1}" for i in range(joints)]
    axes = [CylindricalAxis(*map(tuple, pair)) for pair in zip(directions, points, strict=True)]
    plant = cylindrical_chain(axes, names)
    q = random.normal(size=(order + 1, 2 * joints))
    path = JointPath.from_derivatives(q)
    references = drake_twist_derivatives(plant, names[-1], path, 0.0, order)
    V_WBo = np.array([reference.value for reference in references])
    p_WBo = body_motion(plant, names[-1], q[0], q[1], q[2]).p_WBp
    homes = [line_through(p, u) for p, u in zip(points, directions, strict=True)]
    angles = [Dual(q[:, 2 * i + 1], q[:, 2 * i]) for i in range(joints)]
    lines = current_lines(homes, [angle[0] for angle in angles])
    rates = [[angle[k + 1] for k in range(order)] for angle in angles]
    return lines, rates, chapter_twist(V_WBo[:, :3], V_WBo[:, 3:], p_WBo)


def _drake_residuals(joints: int, formulas: TwistDerivatives, entries: int) -> Iterator[np.ndarray]:
    lines, rates, (omega, v) = _drake_motion(joints, entries)
    for k, claimed in enumerate(formulas(lines, rates)):
        scale_of_k = max(np.abs(omega[k]).max(), np.abs(v[k]).max())
        yield (claimed.re - omega[k]) / scale_of_k
        yield (claimed.du - v[k]) / scale_of_k


def _notation(joints: int) -> SymbolTable:
    """The letters of the printed forms; the last line need not be a unit vector."""
    specs: dict[str, dict[str, Any]] = {}
    for i in range(1, joints + 1):
        specs[rf"\underline{{\omega}}_{i}"] = {"kind": "dual scalar", "weight": 1}
        specs[rf"\underline{{\mathbf{{u}}}}_{i}"] = {"kind": "dual vector", "weight": 0}
        specs[rf"\underline{{\mathbf{{u}}}}_{i}"]["unit"] = i < joints
    specs[r"\underline{\boldsymbol{\omega}}"] = {"kind": "dual vector", "weight": 1}
    return SymbolTable.build(specs)


_DOTS = ("", r"\dot", r"\ddot", r"\dddot")


def _printed(
    joints: int, latex: Sequence[str], formulas: TwistDerivatives, engine_over: Callable
) -> Iterator[Any]:
    """Right sides as read − as computed: engine_over(terms) evaluates a term to its components."""
    table = _notation(joints)
    right_sides = [read(formula, table)[0].right for formula in latex]
    lines = [read_term(rf"\underline{{\mathbf{{u}}}}_{i}", table) for i in range(1, joints + 1)]
    rates = [
        [
            read_term(rf"{dots}{{\underline{{\omega}}}}_{i}" if dots else rf"\underline{{\omega}}_{i}", table)
            for dots in _DOTS
        ]
        for i in range(1, joints + 1)
    ]
    components, normal = engine_over([*right_sides, *lines, *(w for row in rates for w in row)])

    def value(term: Any) -> Dual:
        entries = components(term)
        half = len(entries) // 2
        if half == 1:
            return Dual(*entries)
        return Dual(_array(entries[:half]), _array(entries[half:]))

    claimed = formulas([value(u) for u in lines], [[value(w) for w in row] for row in rates])
    for right, computed in zip(right_sides, claimed, strict=True):
        difference = value(right) - computed
        yield _array([normal(entry) for entry in (*difference.re, *difference.du)])


def _printed_in_flint(joints: int, latex: Sequence[str], formulas: TwistDerivatives) -> Iterator[Any]:
    def engine_over(terms: Sequence[Any]) -> tuple[Callable, Callable]:
        engine = ExactEngine(take_inventory(terms, Definitions()), Definitions())
        return lambda term: engine.parts(engine.value(term)), engine.ring.reduce

    return _printed(joints, latex, formulas, engine_over)


def _printed_in_sympy(joints: int, latex: Sequence[str], formulas: TwistDerivatives) -> Iterator[Any]:
    def engine_over(terms: Sequence[Any]) -> tuple[Callable, Callable]:
        from workbench.judge.second.sympy_ring import SympyRing

        inventory = take_inventory(terms, Definitions())
        ring = SympyRing(inventory)
        engine = JetEngine(PointSource(ring, ring.point), Definitions())
        return engine.components, lambda entry: ring.normal(ring.lift(entry).top)

    return _printed(joints, latex, formulas, engine_over)
