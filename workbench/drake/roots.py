"""Check of reference motions against their plants: derivatives against MultibodyPlant's own terms.

At each sample time, in doubles: the pose, the spatial velocity and acceleration of the body, the acceleration
again as Jacobian times v̇ plus Drake's bias term, and the jerk by AutoDiffXd.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from workbench.drake.bound_jets import Motion
from workbench.drake.gate import AutoDiffXd, ExtractGradient, ExtractValue, JacobianWrtVariable
from workbench.drake.plants import body_motion, body_named, set_state
from workbench.drake.references import twist_derivatives

#: The greatest allowed deviation of a motion from its plant, in multiples of their error estimates.
ALLOWED = 16.0


class MotionError(RuntimeError):
    """The derivatives of a motion are not those of its plant: a defect of the workbench."""


def disagreements(motion: Motion) -> Iterator[tuple[str, float, float]]:
    """Yields (what, difference, its error estimate) at all samples of the motion."""
    for time in motion.samples:
        p, v, w, R = (motion.jet(name, 3, time) for name in ("p_WBo", "v_WBo", "w_WB", "R_WB"))
        error = {n: motion.errors(n, 3, time) for n in ("p_WBo", "v_WBo", "w_WB", "R_WB")}
        twist = np.hstack([w, v])
        errors = error["w_WB"] + error["v_WBo"]
        state = _state(motion, time)
        native = body_motion(motion.plant, motion.body, *state)
        yield "rotation", _largest(R[0] - native.R_WB), error["R_WB"][0]
        yield "position", _largest(p[0] - native.p_WBp), error["p_WBo"][0]
        yield "velocity", _largest(twist[0] - native.V_WBp), errors[0]
        yield "acceleration", _largest(twist[1] - native.A_WBp), errors[1]
        if motion.plant.IsVelocityEqualToQDot():
            jerk = twist_derivatives(motion.plant, motion.body, motion.path, time, 3)[2]
            yield f"jerk by {jerk.method}", _largest(twist[2] - jerk.value), errors[2] + jerk.error
        yield "rate of the position", _largest(p[1] - v[0]), error["p_WBo"][1] + error["v_WBo"][0]
        rate = np.cross(w[0], R[0].T).T
        yield "rate of the rotation", _largest(R[1] - rate), error["R_WB"][1] + 4 * error["w_WB"][0]
        biased = _acceleration_with_bias(motion, *state)
        yield "acceleration by Jacobian and bias", _largest(twist[1] - biased), errors[1] + errors[0]


def require_agreement(motion: Motion) -> None:
    """Raises MotionError for a motion that disagrees with its plant, with the term and the difference."""
    for what, difference, error in disagreements(motion):
        if not difference <= ALLOWED * error:
            raise MotionError(
                f"{motion.name}: {what} differs from the plant's by {difference:.2g}, expected {error:.2g}"
            )


def _state(motion: Motion, time: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns q, v and v̇; for v = N⁺(q) q̇ the rate by AutoDiffXd."""
    jet = motion.path.jet(time, 2)
    if motion.plant.IsVelocityEqualToQDot():
        return tuple(jet)
    plant = motion.plant.ToAutoDiffXd()
    context = plant.CreateDefaultContext()
    q, qdot = (
        np.array([AutoDiffXd(x, [rate]) for x, rate in zip(values, rates, strict=True)])
        for values, rates in pairwise(jet)
    )
    plant.SetPositions(context, q)
    v = np.ravel(plant.MapQDotToVelocity(context, qdot))
    return jet[0], ExtractValue(v).ravel(), ExtractGradient(v).ravel()


def _acceleration_with_bias(motion: Motion, q: np.ndarray, v: np.ndarray, vdot: np.ndarray) -> np.ndarray:
    plant, world = motion.plant, motion.plant.world_frame()
    frame = body_named(plant, motion.body).body_frame()
    context = plant.CreateDefaultContext()
    set_state(plant, context, q, v)
    arguments = (context, JacobianWrtVariable.kV, frame, np.zeros(3), world, world)
    bias = plant.CalcBiasSpatialAcceleration(*arguments)
    return plant.CalcJacobianSpatialVelocity(*arguments) @ vdot + bias.get_coeffs()


def _largest(difference: np.ndarray) -> float:
    return float(np.max(np.abs(difference)))
