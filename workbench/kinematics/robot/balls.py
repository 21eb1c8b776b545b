"""Balls of a robot: the rotation and the angular velocity of a quaternion and of roll, pitch and yaw."""

from __future__ import annotations

from math import factorial

import numpy as np

from workbench.algebra.dual_tensors import cross
from workbench.kinematics.chain import Joint, SerialChain


def rotation_of_rpy(rpy: np.ndarray) -> np.ndarray:
    """Returns R = Rz(yaw) Ry(pitch) Rx(roll) of (roll, pitch, yaw), (..., 3) → (..., 3, 3)."""
    (cx, cy, cz), (sx, sy, sz) = (np.moveaxis(f(rpy), -1, 0) for f in (np.cos, np.sin))
    rows = [
        [cy * cz, sx * sy * cz - cx * sz, cx * sy * cz + sx * sz],
        [cy * sz, sx * sy * sz + cx * cz, cx * sy * sz - sx * cz],
        [-sy, sx * cy, cx * cy],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def quaternion_of_rpy(rpy: np.ndarray) -> np.ndarray:
    """Returns the unit quaternion (..., 4), w x y z, of (roll, pitch, yaw), (..., 3)."""
    (cx, cy, cz), (sx, sy, sz) = (np.moveaxis(f(rpy / 2), -1, 0) for f in (np.cos, np.sin))
    return np.stack(
        [
            cx * cy * cz + sx * sy * sz,
            sx * cy * cz - cx * sy * sz,
            cx * sy * cz + sx * cy * sz,
            cx * cy * sz - sx * sy * cz,
        ],
        axis=-1,
    )


def quaternion_of_rotation(R: np.ndarray) -> np.ndarray:
    """Returns the unit quaternion (..., 4), w x y z with w >= 0, of a rotation (..., 3, 3), from the
    largest of its four squares (Shepperd's method)."""
    xx, yy, zz = (R[..., i, i] for i in range(3))
    squares = np.stack([1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz], axis=-1)
    wx, wy, wz = (R[..., i, j] - R[..., j, i] for i, j in ((2, 1), (0, 2), (1, 0)))
    xy, yz, zx = (R[..., i, j] + R[..., j, i] for i, j in ((0, 1), (1, 2), (2, 0)))
    s0, s1, s2, s3 = np.moveaxis(squares, -1, 0)
    rows = np.stack(
        [
            np.stack([s0, wx, wy, wz], axis=-1),
            np.stack([wx, s1, xy, zx], axis=-1),
            np.stack([wy, xy, s2, yz], axis=-1),
            np.stack([wz, zx, yz, s3], axis=-1),
        ],
        axis=-2,
    )
    best = np.argmax(squares, axis=-1)[..., None, None]
    row = np.take_along_axis(rows, best, axis=-2)[..., 0, :]
    row = np.where(row[..., :1] < 0, -row, row)
    return row / np.linalg.norm(row, axis=-1, keepdims=True)


def rpy_of_rotation(R: np.ndarray) -> np.ndarray:
    """Returns (roll, pitch, yaw), (..., 3), of a rotation (..., 3, 3). Yaw is taken out before roll is
    measured, so that R is met next to pitch = ±π/2, too; there roll is 0."""
    level = np.hypot(R[..., 0, 0], R[..., 1, 0])
    straight = level < 1e-12
    yaw = np.where(straight, np.arctan2(-R[..., 0, 1], R[..., 1, 1]), np.arctan2(R[..., 1, 0], R[..., 0, 0]))
    pitch = np.arctan2(-R[..., 2, 0], level)
    c, s = np.cos(yaw), np.sin(yaw)
    roll = np.arctan2(s * R[..., 0, 2] - c * R[..., 1, 2], c * R[..., 1, 1] - s * R[..., 0, 1])
    return np.stack([np.where(straight, 0.0, roll), pitch, yaw], axis=-1)


def unit_quaternion(kind: str, coordinates: np.ndarray) -> np.ndarray:
    """Returns the unit quaternion (..., 4) of a ball's coordinates, of the kind "quaternion" or "rpy"."""
    if kind == "rpy":
        return quaternion_of_rpy(coordinates)
    largest = np.abs(coordinates).max(axis=-1, keepdims=True)  # its square may be too small for a double
    scaled = coordinates / largest
    return scaled / np.linalg.norm(scaled, axis=-1, keepdims=True)


_YAW_PITCH_ROLL = (Joint.revolute([0, 0, 1]), Joint.revolute([0, 1, 0]), Joint.revolute([1, 0, 0]))


def angular_velocity_of_rpy(rpy: np.ndarray) -> np.ndarray:
    """Returns ω and its derivatives (N, ..., 3), in the frame that is turned from, of (roll, pitch, yaw)
    (N + 1, ..., 3)."""
    return SerialChain(_YAW_PITCH_ROLL).twist_derivatives(rpy[..., ::-1], order=len(rpy) - 2)[..., :3]


def angular_velocity_of_quaternion(q: np.ndarray) -> np.ndarray:
    """Returns ω and its derivatives (N, ..., 3), in the frame that is turned from, of a quaternion (N + 1,
    ..., 4).

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
