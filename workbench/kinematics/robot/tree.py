"""Poses, twists and Jacobian columns of all bodies of a tree of joints, with their derivatives to any order.

A body's twist is that of its parent plus its own joint's, V = V_P + Σ C q̇, where the column C (the joint's
unit screw in world coordinates, ∂V/∂q̇) is carried along by the parent, Ċ = [V_P, C]. In Taylor coefficients

    (k + 1) C₍ₖ₊₁₎ = Σᵢ ad(V_P₍ᵢ₎) C₍ₖ₋ᵢ₎,      V₍ₖ₎ = V_P₍ₖ₎ + Σᵢ C₍ᵢ₎ v₍ₖ₋ᵢ₎:

O(m n²) operations for m joints and n orders give every body's twist derivatives and dᵏJ/dtᵏ at once.
All is about the world's origin and in its axes; states are a batch.
"""

from __future__ import annotations

from math import factorial
from typing import NamedTuple

import numpy as np

from workbench.algebra.dual_tensors import cross, skew
from workbench.kinematics.chain import SerialChain
from workbench.kinematics.chain_geometry import Joint, motion

WORLD = -1  # the step before the first ones: the world


class Step(NamedTuple):
    """One motion of the tree: X_WM = X_WP · before · (the motion), P being the frame that `parent` reaches.

    joint: of one coordinate, or "quaternion" or "rpy", a ball; positions, velocities: its own among the
    tree's.
    """

    parent: int
    before: np.ndarray
    joint: Joint | str
    positions: slice
    velocities: slice


class TreeMotion(NamedTuple):
    """poses (steps, S, 4, 4); twists (N, steps, S, 6); columns (N + 1, velocities, S, 6), derivatives at
    [k]."""

    poses: np.ndarray
    twists: np.ndarray
    columns: np.ndarray


def poses(steps: tuple[Step, ...], q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of states q (S, coordinates): the poses X_WM after, and the poses X_WF before each motion, (steps, S,
    4, 4)."""
    after, before = np.empty((2, len(steps), len(q), 4, 4))
    for i, step in enumerate(steps):
        before[i] = step.before if step.parent == WORLD else after[step.parent] @ step.before
        after[i] = before[i] @ step_motion(step, q)
    return after, before


def tree_motion(steps: tuple[Step, ...], q: np.ndarray, rates: np.ndarray) -> TreeMotion:
    """Of states q (S, coordinates) with velocities and derivatives, rates (N, S, velocities)."""
    orders, states = rates.shape[:2]
    factorials = np.array([float(factorial(k)) for k in range(orders + 1)])[:, None, None, None]
    series = rates / factorials[:orders, 0]
    after, before = poses(steps, q)
    twists = np.zeros((orders, len(steps), states, 6))
    columns = np.zeros((orders + 1, rates.shape[2], states, 6))
    carriers: dict[int, np.ndarray] = {}  # step → ad of its twist's Taylor coefficients, (N, S, 6, 6)
    for i, step in enumerate(steps):
        own = step.velocities
        columns[0, own] = _columns(step, before[i])
        if step.parent != WORLD:
            if step.parent not in carriers:
                carriers[step.parent] = _ad(twists[:, step.parent])
            _carry(columns[:, own], carriers[step.parent])
            twists[:, i] = twists[:, step.parent]
        for c in range(own.start, own.stop):
            for k in range(orders):
                twists[k, i] += (columns[: k + 1, c] * series[k::-1, :, c, None]).sum(axis=0)
    return TreeMotion(after, twists * factorials[:orders], columns * factorials)


def _carry(columns: np.ndarray, ad: np.ndarray) -> None:
    """Fill the Taylor coefficients of columns (N + 1, c, S, 6), of which the first is there: Ċ = ad C."""
    series = columns.swapaxes(1, 2).swapaxes(2, 3)  # (N + 1, S, 6, c), a view
    for k in range(len(ad)):
        series[k + 1] = (ad[: k + 1] @ series[k::-1]).sum(axis=0) / (k + 1)


def _ad(twist: np.ndarray) -> np.ndarray:
    """The matrix of C ↦ [V, C] = (ω × c; ω × c₀ + v × c), (..., 6, 6)."""
    omega, v = skew(twist[..., :3]), skew(twist[..., 3:])
    return np.concatenate(
        [
            np.concatenate([omega, np.zeros_like(omega)], axis=-1),
            np.concatenate([v, omega], axis=-1),
        ],
        axis=-2,
    )


def _columns(step: Step, X_WF: np.ndarray) -> np.ndarray:
    """The unit screws (c, S, 6) of a step's velocities, its frame F being at X_WF (S, 4, 4)."""
    R, p = X_WF[:, :3, :3], X_WF[:, :3, 3]
    if isinstance(step.joint, str):
        axes = R.transpose(2, 0, 1)
        return np.concatenate([axes, cross(p[None], axes)], axis=-1)
    axis = R @ step.joint.axis
    if step.joint.kind == "prismatic":
        return np.concatenate([np.zeros_like(axis), axis], axis=-1)[None]
    pitch = step.joint.pitch if step.joint.kind == "helical" else 0.0
    point = R @ step.joint.point + p
    return np.concatenate([axis, cross(point, axis) + pitch * axis], axis=-1)[None]


def step_motion(step: Step, q: np.ndarray) -> np.ndarray:
    """X_FM (S, 4, 4) of a step at the states q (S, coordinates)."""
    q = q[:, step.positions]
    if not isinstance(step.joint, str):
        return motion(step.joint, q)
    X = np.zeros((len(q), 4, 4))
    X[:, :3, :3] = rotation_of_quaternion(q) if step.joint == "quaternion" else rotation_of_rpy(q)
    X[:, 3, 3] = 1
    return X


def rotation_of_quaternion(q: np.ndarray) -> np.ndarray:
    """The rotation (..., 3, 3) of a quaternion (..., 4), w x y z, of any length but zero."""
    w, u = q[..., 0], skew(q[..., 1:])
    square = (q * q).sum(axis=-1)[..., None, None]
    return np.eye(3) + 2 * (w[..., None, None] * u + u @ u) / square


_YAW_PITCH_ROLL = (Joint.revolute([0, 0, 1]), Joint.revolute([0, 1, 0]), Joint.revolute([1, 0, 0]))


def rotation_of_rpy(rpy: np.ndarray) -> np.ndarray:
    """R = Rz(yaw) Ry(pitch) Rx(roll) of (roll, pitch, yaw), (..., 3) → (..., 3, 3)."""
    yaw, pitch, roll = (
        motion(joint, rpy[..., 2 - i : 3 - i])[..., :3, :3] for i, joint in enumerate(_YAW_PITCH_ROLL)
    )
    return yaw @ pitch @ roll


def angular_velocity_of_rpy(rpy: np.ndarray) -> np.ndarray:
    """ω and its derivatives (N, ..., 3), in the frame that is turned from, of (roll, pitch, yaw) (N + 1,
    ..., 3)."""
    return SerialChain(_YAW_PITCH_ROLL).twist_derivatives(rpy[..., ::-1])[..., :3]


def angular_velocity_of_quaternion(q: np.ndarray) -> np.ndarray:
    """ω and its derivatives (N, ..., 3), in the frame that is turned from, of a quaternion (N + 1, ..., 4).

    ω = 2 Im(q̇ q̄) / |q|², by division of Taylor series.
    """
    terms = len(q) - 1
    factorials = np.array([float(factorial(k)) for k in range(terms + 1)]).reshape(-1, *[1] * (q.ndim - 1))
    series = q / factorials
    rate = series[1:] * np.arange(1, terms + 1).reshape(-1, *[1] * (q.ndim - 1))
    numerator, square = np.zeros((terms, *q.shape[1:-1], 3)), np.zeros((terms, *q.shape[1:-1], 1))
    for k in range(terms):
        for i in range(k + 1):
            w, u, W, U = rate[i][..., :1], rate[i][..., 1:], series[k - i][..., :1], series[k - i][..., 1:]
            numerator[k] += 2 * (W * u - w * U - cross(u, U))
            square[k] += (series[i] * series[k - i]).sum(axis=-1, keepdims=True)
    omega = np.zeros_like(numerator)
    for k in range(terms):
        known = sum((square[i] * omega[k - i] for i in range(1, k + 1)), start=0.0)
        omega[k] = (numerator[k] - known) / square[0]
    return omega * factorials[:terms]
