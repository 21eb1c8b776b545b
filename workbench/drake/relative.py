"""Derivatives of a body's twist relative to another moving body, computed by Drake.

Order 1 is Drake's V_AB_A in doubles, order 2 its derivative by AutoDiffXd. All others are derivatives of the
velocity by Chebyshev interpolation; error and method as in `workbench.drake.references`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from workbench.drake import chebyshev
from workbench.drake.gate import AutoDiffXd, Context, ExtractGradient, MultibodyPlant
from workbench.drake.joint_paths import Path
from workbench.drake.magnitudes import Reach
from workbench.drake.plants import Numbers, body_named, set_state
from workbench.drake.references import TURNS, BodyPoint, Reference


def relative_twist_derivatives(
    plant: MultibodyPlant,
    body: str,
    other: str,
    path: Path,
    t: float,
    order: int,
    p_BoBp_B: Sequence[float] = (0.0, 0.0, 0.0),
) -> list[Reference]:
    """Returns V_ABp_A and its derivatives in the moving body A (`other`): ``order`` references, [k] for d^k V
    / dt^k.

    Arguments and errors as for `workbench.drake.references.twist_derivatives`.
    """
    point = BodyPoint(plant, body, path, t, p_BoBp_B)
    frame = BodyPoint(plant, other, path, t, np.zeros(3))
    point.reach = Reach(
        point.reach.rotations + frame.reach.rotations,
        point.reach.translations + frame.reach.translations,
        point.reach.length + frame.reach.length,
    )
    context = plant.CreateDefaultContext()

    def velocity(s: float) -> np.ndarray:
        q, v = point.path.jet(s, 1)
        return _velocity(plant, context, q, v, body, other, point.p_BoBp_B)

    found = [Reference(velocity(0.0), point.rounding(0), "double")]
    if order > 1:
        q, v, vdot = point.path.jet(0.0, 2)
        moving = plant.ToAutoDiffXd()
        q_t, v_t = (
            [AutoDiffXd(x, [rate]) for x, rate in zip(values, rates, strict=True)]
            for values, rates in ((q, v), (v, vdot))
        )
        value = _velocity(moving, moving.CreateDefaultContext(), q_t, v_t, body, other, point.p_BoBp_B)
        gradient = ExtractGradient(value)
        rate = gradient[:, 0] if gradient.size else np.zeros(6)
        found.append(Reference(rate, point.rounding(1), "AutoDiffXd"))
    if order > 2:
        derivatives = chebyshev.derivatives(
            velocity, point.reach.half_widths(point.path, TURNS), highest=order - 1
        )
        found += [
            Reference(d.value, d.error + point.rounding(k), "Chebyshev")
            for k, d in enumerate(derivatives[1:], start=2)
        ]
    return found


def _velocity(
    plant: MultibodyPlant,
    context: Context,
    q: Numbers,
    v: Numbers,
    body: str,
    other: str,
    p_BoBp_B: np.ndarray,
) -> np.ndarray:
    set_state(plant, context, q, v)
    B, A = (body_named(plant, name).body_frame() for name in (body, other))
    p_BoBp_A = B.CalcPose(context, A).rotation() @ p_BoBp_B
    return B.CalcSpatialVelocity(context, A, A).Shift(p_BoBp_A).get_coeffs()
