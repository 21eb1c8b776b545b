"""The plan of a pass over a serial chain: the frames in which its recursion is cheapest, all constants and
the workspace, one array.

Between the axes of two neighbouring joints lie two frames, `leaving` on the inner axis and `entering` on the
outer one, both with z along their axis and sharing their x axis, which is perpendicular to both axes. From
the one to the other leads a rotation about x by the twist angle and a shift (a, b, 0); from the entering to
the leaving frame of one joint leads a constant dual angle about z (Denavit and Hartenberg's joint angle and
offset). Where two axes are nearly parallel their common normal may lie far away; there b ≠ 0 replaces it, so
that no length gets large.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial

import numpy as np

from workbench.kinematics.chain_joints import Joint
from workbench.kinematics.chain_kernel import HEAD, ROW, bound_chain_kernel, chain_kernel
from workbench.kinematics.simd_lanes import WIDTH
from workbench.kinematics.trees.tree_plan import Plan

NEAR = 3500  # doubles of the first-level cache (32 KB or more) that alternating blocks may fill
NEARLY_PARALLEL = 0.1  # below this sine the foot of the common normal is not used


def plan_of_chain(joints: Sequence[Joint], dof: int, order: int, taylor: bool) -> Plan:
    """Returns the plan for inputs with `order` derivatives; taylor: Taylor coefficients in and out, not
    derivatives.

    In order: how many joints, how many blocks take turns, the base's turn (cos, sin); the factors of the
    inputs, those of the results; 0, 1, 1/2, …; the rows of the joints; the workspace."""
    first_turn, rows = _rows(joints)
    size = WIDTH * (dof * (order + 1) + 2 * order * len(rows) + 12 * order)
    together = max(1, min(8, NEAR // size))
    if taylor:
        in_factors, out_factors = np.arange(1.0, order + 1), np.ones(order)
    else:
        out_factors = np.array([float(factorial(k)) for k in range(order)])
        in_factors = 1 / out_factors
    memory = np.concatenate(
        [
            [len(rows), together, *first_turn],
            np.tile([1.0, *in_factors], dof),
            out_factors,
            [0.0],
            1 / np.arange(1.0, order),
            rows.ravel(),
            np.zeros(together * size + WIDTH * (order + 2)),
        ]
    )
    assert rows.shape[1] == ROW and 2 + len(first_turn) == HEAD
    return Plan(memory, memory.ctypes.data, 6 * order, chain_kernel(), bound_chain_kernel)


def _rows(joints: Sequence[Joint]) -> tuple[tuple[float, float], np.ndarray]:
    """Returns the base's turn, and a row of each moving joint: the coordinates of its rotation and
    translation (−1: it has none), the translation's factor; twist angle (cos, sin), shift and offset of
    the step from the leaving frame before; its turn (cos, sin), from its entering to its leaving frame."""
    X, dof, rows, turns = np.eye(4), 0, [], []
    x, z, origin = np.array([1.0, 0, 0]), np.array([0, 0, 1.0]), np.zeros(3)
    for joint in joints:
        if joint.kind == "fixed":
            X = X @ joint.transform
            continue
        next_z, point = X[:3, :3] @ joint.axis, X[:3, :3] @ joint.point + X[:3, 3]
        next_x, next_origin, foot = _common_normal(z, origin, next_z, point)
        turns.append(_unit2(float(next_x @ x), float(next_x @ np.cross(z, x))))
        twist_angle = _unit2(z @ next_z, np.cross(z, next_z) @ next_x)
        shift = (next_origin - foot) @ next_x, (next_origin - foot) @ np.cross(z, next_x)
        angle = -1 if joint.kind == "prismatic" else dof
        sliding = {"revolute": -1, "cylindrical": dof + 1}.get(joint.kind, dof)
        pitch = joint.pitch if joint.kind == "helical" else 1.0
        rows.append([angle, sliding, pitch, *twist_angle, *shift, (foot - origin) @ z])
        x, z, origin, dof = next_x - next_z * (next_x @ next_z), next_z, next_origin, dof + joint.dof
        x = x / np.linalg.norm(x)
    return turns[0], np.column_stack([rows, [*turns[1:], (1.0, 0.0)]])


def _common_normal(
    z: np.ndarray, origin: np.ndarray, next_z: np.ndarray, next_point: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns the shared x axis, the origin of the entering frame on the next axis, and on this axis the
    origin of the leaving frame: the foot of the perpendicular from there."""
    across = np.cross(z, next_z)
    sine = np.linalg.norm(across)
    between = next_point - origin
    if sine > NEARLY_PARALLEL:
        x = across / sine
        next_origin = next_point + next_z * (np.cross(z, x) @ between / sine)
    else:
        next_origin = next_point - next_z * (next_z @ between)
        sideways = next_origin - origin
        sideways = sideways - z * (z @ sideways)
        distance = np.linalg.norm(sideways)
        if sine > 1e-14:
            x = across / sine
        elif distance > 0:
            x = sideways / distance
        else:
            x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    x = x - z * (z @ x)
    return x / np.linalg.norm(x), next_origin, origin + z * (z @ (next_origin - origin))


def _unit2(cosine: float, sine: float) -> tuple[float, float]:
    length = np.hypot(cosine, sine)
    return cosine / length, sine / length
