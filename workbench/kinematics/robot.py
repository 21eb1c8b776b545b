"""Higher-order kinematics of one body of a real robot, from the derivatives of its joint positions.

Everything is measured and expressed in the world frame W. Orders count as in Eq. (13): 1 velocity,
2 acceleration, 3 jerk, ... The plant serves only for the geometry of the joints; the numbers are our own
(`chain`), so that they can stand beside Drake's (`motion_report`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import comb, factorial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from .centres import Locus, acceleration_centre, field_scales
from .chain import SerialChain
from .chain_from_plant import serial_chain_from_plant
from .fields import acceleration_tensors, invariant_vectors
from .frames import drake_twist
from .tensors import apply, as_vectors, det, sym, vect

if TYPE_CHECKING:
    from pydrake.multibody.plant import MultibodyPlant

    from workbench.drake.joint_paths import JointPath

ROUNDING = 1e-13
"""Of a bound on its terms: what of Φₙ or aₙ of a chain of joints is taken for rounding."""

RANK_TOLERANCE = 1e-9


@dataclass(frozen=True)
class RobotMotion:
    """The motion of a body B at one instant, to order N, in W.

    X_WB (4, 4) pose; p_WP (3,) the position in m of the body point P that was asked.
    w_WB, v_WBo (N, 3): Drake's twist and its derivatives [k]: rad/s¹⁺ᵏ, m/s¹⁺ᵏ (velocity of Bo).
    v (N, 3): the chapter's v and its derivatives (of the body point at Wo); its ω is w_WB.
    Phi (N+1, 3, 3), a (N+1, 3): Φₙ and aₙ at [n], Eqs. (15), (16); Phi[0] = I, a[0] = 0.
    accelerations (N+1, 3): [n] is dⁿ p_WP / dtⁿ in m/sⁿ, [0] = p_WP; Eq. (19).
    centres (N,): [n-1] is where the n-th order acceleration vanishes, Eq. (50).
    """

    X_WB: np.ndarray
    p_WP: np.ndarray
    w_WB: np.ndarray
    v_WBo: np.ndarray
    v: np.ndarray
    Phi: np.ndarray
    a: np.ndarray
    accelerations: np.ndarray
    centres: tuple[Locus, ...]

    @property
    def order(self) -> int:
        return len(self.v)


def robot_motion(
    plant: MultibodyPlant, body: str, q_derivatives: ArrayLike, point: ArrayLike = (0, 0, 0)
) -> RobotMotion:
    """The motion of `body` of a finalized plant to the order N = q_derivatives.shape[1] - 1.

    q_derivatives (plant.num_positions(), N+1): the k-th time derivative of each position at [:, k].
    point (3,): p_BoP_B in m, the body point P in the body's own frame.
    Raises ValueError for an unknown body (its message lists the bodies), a wrong shape, N < 1, numbers
    that are not finite, and a body that the world does not reach by angles and lengths.
    """
    from workbench.drake.plants import body_named

    q = np.asarray(q_derivatives, dtype=float)
    count = plant.num_positions()
    if q.ndim != 2 or q.shape[0] != count or q.shape[1] < 2 or not np.isfinite(q).all():
        raise ValueError(
            f"q_derivatives: expected finite numbers of shape ({count}, N+1) with N >= 1, one row a "
            f"position of the plant, got shape {q.shape}"
        )
    p_BoP_B = as_vectors(point, "point")
    if p_BoP_B.shape != (3,):
        raise ValueError(f"point: expected three coordinates, got shape {p_BoP_B.shape}")
    chain, positions = serial_chain_from_plant(plant, body_named(plant, body))
    q = q[positions]
    twist = chain.twist_derivatives(q)
    omega, v = twist[:, :3], twist[:, 3:]
    X_WB = chain.pose(q[:, 0])
    p_WP = X_WB[:3, :3] @ p_BoP_B + X_WB[:3, 3]
    Phi, a = acceleration_tensors(omega), invariant_vectors(omega, v)
    Phi_scale, a_scale = (ROUNDING / RANK_TOLERANCE * s for s in _chain_scales(chain, q))
    centres = tuple(
        acceleration_centre(
            Phi[n], a[n], rtol=RANK_TOLERANCE, Phi_scale=Phi_scale[n], a_scale=a_scale[n]
        )
        for n in range(1, len(Phi))
    )
    w_WB, v_WBo = drake_twist(omega, v, X_WB[:3, 3])
    accelerations = a + apply(Phi, p_WP)
    return RobotMotion(X_WB, p_WP, w_WB, v_WBo, v, Phi, a, accelerations, centres)


def _chain_scales(chain: SerialChain, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The sizes of the terms of Φₙ and aₙ, each (N+1,), of one state q (dof, N+1).

    With unit axes turning as uᵢ' = ω × uᵢ, the norms in ω = Σ q̇ᵢ uᵢ bound ω⁽ᵏ⁾ without seeing terms
    cancel; v is taken to be as large as these at the chain's reach.
    """
    rates = np.abs(q[:, 1:]).sum(axis=0)
    turning, axes = [], [1.0]
    for k in range(len(rates)):
        turning.append(sum(comb(k, j) * rates[k - j] * axes[j] for j in range(k + 1)))
        axes.append(sum(comb(k, j) * turning[k - j] * axes[j] for j in range(k + 1)))
    lengths = [np.linalg.norm(j.transform[:3, 3]) + np.linalg.norm(j.point) for j in chain.joints]
    reach = 1 + sum(lengths) + np.abs(q[:, 0]).sum()
    bound = np.outer(turning, (1.0, 0.0, 0.0))
    return field_scales(bound, reach * bound)


@dataclass(frozen=True)
class DrakeCheck:
    """Drake's own number for one order beside ours.

    drakes (6,): the (n-1)-th derivative of V_WP = [w_WB; v_WP], so that its lower half is the n-th order
    acceleration of the body point P; method: how Drake made it; error: the estimated error of Drake's
    number, residual: how far ours is from it, both as the largest of the six components.
    """

    order: int
    drakes: np.ndarray
    method: str
    error: float
    residual: float

    @property
    def agrees(self) -> bool:
        return self.residual <= self.error


@dataclass(frozen=True)
class MotionReport:
    """The motion of a robot's body at the time `at` (s) on a joint path, beside Drake's numbers.

    joints: the names of the plant's positions, one column of `path` each.
    point (3,): p_BoP_B in m, the body point P in the body's own frame.
    """

    urdf: str
    body: str
    point: np.ndarray
    at: float
    joints: tuple[str, ...]
    path: JointPath
    motion: RobotMotion
    checks: tuple[DrakeCheck, ...]

    def to_dict(self) -> dict:
        """Plain numbers, lists and strings, for JSON; orders[n-1] holds what belongs to order n."""
        motion = self.motion
        rows = self.path.coefficients.T.tolist()
        return {
            "urdf": self.urdf,
            "body": self.body,
            "point_B": self.point.tolist(),
            "time": self.at,
            "joint_coefficients": dict(zip(self.joints, rows, strict=True)),
            "X_WB": motion.X_WB.tolist(),
            "p_WP": motion.p_WP.tolist(),
            "orders": [
                {
                    "order": n,
                    "w_WB": motion.w_WB[n - 1].tolist(),
                    "v_WBo": motion.v_WBo[n - 1].tolist(),
                    "v": motion.v[n - 1].tolist(),
                    "Phi": motion.Phi[n].tolist(),
                    "a": motion.a[n].tolist(),
                    "t": vect(motion.Phi[n]).tolist(),
                    "S": sym(motion.Phi[n]).tolist(),
                    "det_Phi": float(det(motion.Phi[n])),
                    "point_acceleration": motion.accelerations[n].tolist(),
                    "centre": _centre_dict(motion.centres[n - 1]),
                    "drake": {
                        "V_WP_derivative": check.drakes.tolist(),
                        "method": check.method,
                        "error": check.error,
                        "residual": check.residual,
                        "agrees": check.agrees,
                    },
                }
                for n, check in enumerate(self.checks, start=1)
            ],
        }


def _centre_dict(centre: Locus) -> dict:
    dimension = int(centre.dimension)
    return {
        "kind": centre.kind,
        "point": None if dimension < 0 else centre.point.tolist(),
        "directions": centre.directions[: max(dimension, 0)].tolist(),
    }


def motion_report(
    urdf: Path | str,
    body: str,
    point: ArrayLike = (0, 0, 0),
    order: int = 4,
    at: float = 0.0,
    joints: Mapping[str, Sequence[float]] | Sequence[Sequence[float]] | None = None,
) -> MotionReport:
    """The motion of a URDF robot's body to the `order`, beside Drake's own numbers.

    The base of the robot is welded to the world. point: p_BoP_B in m. at: time in s. joints: the
    coefficients c₀, c₁, ... of qᵢ(t) = Σₖ cₖ tᵏ (rad or m, per sᵏ), a row for every position of the
    plant in its order, or by name (those not named stay at 0). Without it, position i = 1, 2, ...
    follows the Taylor polynomial of sin(t + i)/2 of degree order + 2.
    Raises ValueError for a file that is missing or that Drake cannot read, an unknown body, an order
    below 1, and joints, a point or a time that do not fit; each message says what was expected.
    """
    if not isinstance(order, int) or order < 1:
        raise ValueError(f"order: expected an integer >= 1, got {order!r}")
    if not np.isfinite(at):
        raise ValueError(f"at: expected a finite time in s, got {at}")
    from workbench.drake.plants import load_urdf
    from workbench.drake.references import twist_derivatives

    plant = load_urdf(urdf)
    names = tuple(plant.GetPositionNames(False, False))
    path = _joint_path(joints, names, order)
    motion = robot_motion(plant, body, path.jet(at, order).T, point)
    checks = []
    references = twist_derivatives(plant, body, path, at, order, p_BoBp_B=point)
    for n, reference in enumerate(references, start=1):
        ours = np.concatenate([motion.w_WB[n - 1], motion.accelerations[n]])
        residual = float(np.abs(ours - reference.value).max())
        checks.append(
            DrakeCheck(n, reference.value, reference.method, float(reference.error), residual)
        )
    return MotionReport(
        urdf=str(urdf),
        body=body,
        point=as_vectors(point, "point"),
        at=float(at),
        joints=names,
        path=path,
        motion=motion,
        checks=tuple(checks),
    )


def _joint_path(joints, names: tuple[str, ...], order: int) -> JointPath:
    from workbench.drake.joint_paths import JointPath

    if joints is None:
        starts, powers = np.arange(1, len(names) + 1), np.arange(order + 3)[:, None]
        factorials = np.array([[float(factorial(k))] for k in powers[:, 0]])
        return JointPath(np.sin(starts + powers * np.pi / 2) / 2 / factorials)
    if isinstance(joints, Mapping):
        unknown = [name for name in joints if name not in names]
        if unknown:
            raise ValueError(f"unknown joint {unknown[0]!r}: expected one of {', '.join(names)}")
        rows = [joints.get(name, (0.0,)) for name in names]
    else:
        rows = list(joints)
    if len(rows) != len(names):
        raise ValueError(
            f"joints: expected coefficients for {len(names)} joints ({', '.join(names)}), "
            f"got {len(rows)}"
        )
    table = np.zeros((max((len(row) for row in rows), default=0), len(names)))
    for name, column, row in zip(names, table.T, rows, strict=True):
        if len(row) == 0:
            raise ValueError(f"joint {name!r}: expected at least one coefficient, got none")
        column[: len(row)] = row
    return JointPath(table)
