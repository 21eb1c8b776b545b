"""Inverse dynamics and its time derivatives: the torques of a motion, τ, τ̇, τ̈, …

A body of mass m and inertia I about its centre of mass c needs the force m (v̇_c − g) and the moment d/dt(R
I Rᵀ ω). With these and their derivatives by Leibniz' rule and the derivatives of the Jacobian J of each c,

    τ⁽ᵏ⁾ = A v⁽ᵏ⁺¹⁾ + Σ over bodies Σᵢ C(k,i) J⁽ⁱ⁾ᵀ (moment; force)⁽ᵏ⁻ⁱ⁾,

d'Alembert's principle, differentiated. A are the joints' armatures: a rotor that turns n times as fast as
its joint has the energy n² I v²/2 (its gyroscopic moments are left out, as in Drake and MuJoCo). Friction and
springs are left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import comb
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual_tensors import apply
from workbench.kinematics.robot.leibniz import product_derivatives, rotation_derivatives
from workbench.kinematics.robot.structure import reals, whole

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States

GRAVITY = (0.0, 0.0, -9.81)
NO_INERTIAS = "expected a robot with inertias (`from_urdf`, `from_file`, `from_plant`)"


class Inertia(NamedTuple):
    """The inertia of a body: mass in kg, centre of mass (3,) in m and inertia (3, 3) about it in kg m², in
    its frame."""

    mass: float
    com: np.ndarray
    inertia: np.ndarray


def torques(
    motion: States, inertias: Mapping[str, Inertia], why: str, order: int, gravity: ArrayLike = GRAVITY
) -> np.ndarray:
    """See `Motion.torques`: (order + 1, ..., velocities); why: what to say where there are no inertias."""
    order = whole(order, "order", 0, motion.order - 2) if motion.order >= 2 else _too_low(motion)
    g = reals(gravity, "gravity")
    if g.shape != (3,):
        raise ValueError(f"gravity: expected three numbers in m/s², got shape {g.shape}")
    if not inertias:
        raise ValueError(f"{motion.robot.name}: {why}")
    found = motion.rates[1 : order + 2] * motion.robot.armatures
    for name, body in inertias.items():
        if body.mass == 0 and not body.inertia.any():
            continue
        frame = motion.frame(name)
        wrench = _wrench(frame.twists, frame.pose, frame.point(body.com).derivatives, body, order, g)
        J = frame.jacobian_derivatives(order, point=body.com).swapaxes(-1, -2)
        for k in range(order + 1):
            found[k] += sum(comb(k, i) * apply(J[i], wrench[k - i]) for i in range(k + 1))
    return found


def _wrench(
    twists: np.ndarray, pose: np.ndarray, of_com: np.ndarray, body: Inertia, order: int, g: np.ndarray
) -> np.ndarray:
    """Returns (order + 1, ..., 6): moment about the centre of mass, and force, with their derivatives, in W's
    axes."""
    omega = twists[: order + 2, ..., :3]
    R = rotation_derivatives(omega, pose[..., :3, :3])
    in_world = product_derivatives(np.matmul, R @ body.inertia, np.swapaxes(R, -1, -2))
    momentum = product_derivatives(apply, in_world, omega)
    force = body.mass * of_com[2 : order + 3]
    force[0] -= body.mass * g
    return np.concatenate([momentum[1 : order + 2], force], axis=-1)


def _too_low(motion: States) -> int:
    raise ValueError(f"expected a motion of order 2 (accelerations) or more, got order {motion.order}")
