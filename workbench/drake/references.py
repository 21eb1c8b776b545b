"""Derivatives of a body's twist and of its points along a joint path, made by Drake.

Each is a `Reference`: value, estimated error, and how it was made.

=====================  ==========  ===============================================================
derivative of V_WB     method      error
=====================  ==========  ===============================================================
0 velocity             double      rounding
1 acceleration         double      rounding
2 jerk                 AutoDiffXd  rounding: the acceleration is differentiated exactly
3, ... small plant     Expression  rounding: Drake's Expression.Differentiate
3, ... large plant     Chebyshev   estimated: noise and decay of the coefficients, and two windows
=====================  ==========  ===============================================================

A twist is V_WBp = [w_WB; v_WBp], Drake's order, in rad/s and m/s, expressed in W.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from workbench.drake import chebyshev
from workbench.drake.gate import AutoDiffXd, ExtractGradient, MultibodyPlant, Variable
from workbench.drake.joint_paths import Path, ShiftedPath
from workbench.drake.magnitudes import Reach, reach
from workbench.drake.plants import BodyMotion, Numbers, PlantError, body_motion
from workbench.drake.symbolic_motions import SymbolicMotion, evaluated

SMALL_PLANT = 3
"""As many joints between W and the body keep an Expression small along any path."""

TURNS = (3.0, 5.0, 8.0, 12.0, 18.0)
"""Sums of joint angles, in rad, swept in half of a window: five windows to choose from."""

METHODS = ("auto", "expression", "chebyshev")


@dataclass(frozen=True)
class Reference:
    """A derivative computed by Drake.

    ``value``: shape (6,) for a twist, (3,) for a point; ``error``: estimated bound on the absolute error of
    every entry; ``method``: double, AutoDiffXd, Expression or Chebyshev.
    """

    value: np.ndarray
    error: float
    method: str


def twist_derivatives(
    plant: MultibodyPlant,
    body: str,
    path: Path,
    t: float,
    order: int,
    p_BoBp_B: Sequence[float] = (0.0, 0.0, 0.0),
    method: str = "auto",
) -> list[Reference]:
    """Returns V_WBp and its time derivatives at time ``t``: ``order`` references, [k] for d^k V / dt^k.

    The order counts as in Eq. (13): 1 is velocity, 2 acceleration, 3 jerk. ``p_BoBp_B``: the point Bp fixed
    in the body, from Bo, in m; Bo itself by default. ``method``: how derivatives beyond the jerk are
    computed; "auto" uses Expression on small plants, Chebyshev on large ones. Raises PlantError for an
    unknown body, a path that does not fit the plant, or a plant with joints whose velocities are not the
    rates of their positions; ValueError for a bad order, time or method.

    >>> from importlib.resources import files
    >>> from workbench.drake import JointPath, load_urdf
    >>> plant = load_urdf(str(files("workbench.guide") / "examples/arm.urdf"))
    >>> path = JointPath([[0.0, 0.0], [1.0, 0.5]])
    >>> for found in twist_derivatives(plant, "hand", path, t=0.0, order=3):
    ...     print(found.method, found.value[:3].round(3))
    double [0.  0.  1.5]
    double [0. 0. 0.]
    AutoDiffXd [0. 0. 0.]
    """
    if order < 1:
        raise ValueError(f"order: expected an integer >= 1, got {order}")
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    if not np.isfinite(t):
        raise ValueError(f"t: expected a finite time in s, got {t}")
    motion = BodyPoint(plant, body, path, t, p_BoBp_B)
    found = motion.double()
    if order > 2:
        found.append(motion.jerk())
    if order > 3:
        small = motion.reach.joints <= SMALL_PLANT
        by_expression = method == "expression" or (method == "auto" and small)
        found += motion.by_expression(order) if by_expression else motion.by_chebyshev(order)
    return found[:order]


def point_derivatives(
    plant: MultibodyPlant,
    body: str,
    p_BoP_B: Sequence[float],
    path: Path,
    t: float,
    order: int,
    method: str = "auto",
) -> list[Reference]:
    """Returns p_WP and its time derivatives: ``order`` + 1 references, [n] for dⁿ p_WP / dtⁿ, Eq. (13).

    Arguments and errors as for `twist_derivatives`; ``p_BoP_B``: the point P fixed in the body, in m.

    >>> from importlib.resources import files
    >>> from workbench.drake import JointPath, load_urdf
    >>> plant = load_urdf(str(files("workbench.guide") / "examples/arm.urdf"))
    >>> path = JointPath([[0.0, 0.0], [1.0, 0.5]])
    >>> point_derivatives(plant, "hand", (0, 0, 0), path, t=0.0, order=2)[2].value.round(3)
    array([-1.,  0.,  0.])
    """
    rates = twist_derivatives(plant, body, path, t, order, p_BoP_B, method)
    motion = BodyPoint(plant, body, path, t, p_BoP_B)
    return [motion.position(), *(Reference(r.value[3:], r.error, r.method) for r in rates)]


class BodyPoint:
    """A point Bp of a body of the plant, moved along a path whose time starts now."""

    def __init__(self, plant: MultibodyPlant, body: str, path: Path, t: float, p_BoBp_B: Numbers):
        if path.joints != plant.num_positions():
            raise PlantError(
                f"the path has {path.joints} joints, the plant {plant.num_positions()} positions"
            )
        if not plant.IsVelocityEqualToQDot():
            raise PlantError(
                "references need joints whose velocities are the rates of their positions; "
                "this plant has a ball joint or a floating base"
            )
        self.plant, self.body, self.p_BoBp_B = plant, body, np.asarray(p_BoBp_B, dtype=float)
        self.path = ShiftedPath(path, t)
        self.reach: Reach = reach(plant, body, self.p_BoBp_B)
        self._context = plant.CreateDefaultContext()

    def rounding(self, derivative_of_V: int) -> float:
        return self.reach.rounding_error(self.path, 0.0, derivative_of_V + 1)

    def _at(self, s: float) -> BodyMotion:
        q, v, vdot = self.path.jet(s, 2)
        return body_motion(self.plant, self.body, q, v, vdot, self.p_BoBp_B, self._context)

    def position(self) -> Reference:
        return Reference(self._at(0.0).p_WBp, self.reach.rounding_error(self.path, 0.0, 0), "double")

    def double(self) -> list[Reference]:
        now = self._at(0.0)
        return [
            Reference(now.V_WBp, self.rounding(0), "double"),
            Reference(now.A_WBp, self.rounding(1), "double"),
        ]

    def jerk(self) -> Reference:
        jet = self.path.jet(0.0, 3)
        q, v, vdot = (
            [AutoDiffXd(x, [x_dot]) for x, x_dot in zip(values, rates, strict=True)]
            for values, rates in pairwise(jet)
        )
        moving = body_motion(self.plant.ToAutoDiffXd(), self.body, q, v, vdot, self.p_BoBp_B)
        gradient = ExtractGradient(moving.A_WBp)
        value = gradient[:, 0] if gradient.size else np.zeros(6)
        return Reference(value, self.rounding(2), "AutoDiffXd")

    def by_expression(self, order: int) -> list[Reference]:
        """Returns d^k V / dt^k for k = 3 .. order - 1. Powers of t that cannot contribute are left out."""
        t = Variable("t")
        motion = SymbolicMotion(self.plant, self.path.taylor(0.0, order), t)
        derivative = motion.twist(self.body, self.p_BoBp_B)
        found = []
        for k in range(order):
            if k > 2:
                value = evaluated(derivative, t, 0.0)
                found.append(Reference(value, self.rounding(k), "Expression"))
            derivative = motion.rate(derivative)
        return found

    def by_chebyshev(self, order: int) -> list[Reference]:
        """Returns d^k V / dt^k for k = 3 .. order - 1, from the acceleration."""
        found = chebyshev.derivatives(
            lambda s: self._at(s).A_WBp, self.reach.half_widths(self.path, TURNS), highest=order - 2
        )
        return [
            Reference(d.value, d.error + self.rounding(k), "Chebyshev")
            for k, d in enumerate(found[1:], start=3)
        ]
