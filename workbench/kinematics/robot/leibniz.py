"""Products of things that are known with their time derivatives, by Leibniz' rule, and changes of frame.

An array (n + 1, ...) holds a quantity and its derivatives, the order first. A twist is (ω; v), (n + 1, ...,
6), v being the velocity of the origin of the moving frame (Drake's), unless it is said to be that of the body
point at the origin of the frame it is measured in (the chapter's v).
"""

from __future__ import annotations

from collections.abc import Callable
from math import comb

import numpy as np

from workbench.algebra.dual_tensors import apply, cross, transpose
from workbench.kinematics.fields import acceleration_tensors


def product_derivatives(
    product: Callable[[np.ndarray, np.ndarray], np.ndarray], x: np.ndarray, y: np.ndarray
) -> np.ndarray:
    """Returns (x ∘ y)⁽ᵏ⁾ = Σᵢ C(k,i) x⁽ⁱ⁾ ∘ y⁽ᵏ⁻ⁱ⁾ of a bilinear product; as many orders as the shorter one
    has."""
    orders = min(len(x), len(y))
    return np.stack([sum(comb(k, i) * product(x[i], y[k - i]) for i in range(k + 1)) for k in range(orders)])


def about_moving_point(twist: np.ndarray, p: np.ndarray) -> np.ndarray:
    """Returns (ω; v + ω × p) with its derivatives: the velocity of the body point that passes p(t), (n +
    1, ..., 3)."""
    omega, v = twist[..., :3], twist[..., 3:]
    carried = product_derivatives(cross, omega, p)
    return np.concatenate([omega[: len(carried)], v[: len(carried)] + carried], axis=-1)


def turned(R: np.ndarray, twist: np.ndarray) -> np.ndarray:
    """Returns (R ω; R v) with its derivatives, of R(t) (n + 1, ..., 3, 3)."""
    return np.concatenate(
        [product_derivatives(apply, R, part) for part in (twist[..., :3], twist[..., 3:])], axis=-1
    )


def rotation_derivatives(omega: np.ndarray, R: np.ndarray) -> np.ndarray:
    """Returns R, Ṙ, …, R⁽ᴺ⁾ (N + 1, ..., 3, 3) of ω (N, ..., 3) and R (..., 3, 3): R⁽ⁿ⁾ = Φₙ R, Eq. (15)."""
    return acceleration_tensors(omega) @ R


def carried_vector(omega: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Returns r, ṙ, …, r⁽ᴺ⁾ (N + 1, ..., 3) of a vector r (..., 3) fixed in what turns with ω (N, ..., 3):
    ṙ = ω × r."""
    found = [np.broadcast_to(r, (*omega.shape[1:-1], 3))]
    for n in range(len(omega)):
        found.append(sum(comb(n, k) * cross(omega[n - k], found[k]) for k in range(n + 1)))
    return np.stack(found)


def origin_derivatives(twist: np.ndarray, p: np.ndarray) -> np.ndarray:
    """Returns p, ṗ, …, p⁽ᴺ⁾ (N + 1, ..., 3) of a frame's origin at p (..., 3), from its twist (N, ..., 6)."""
    return np.concatenate([np.broadcast_to(p, (*twist.shape[1:-1], 3))[None], twist[..., 3:]])


def about_world_origin(twist: np.ndarray, p: np.ndarray) -> np.ndarray:
    """Returns the chapter's twist, of the body point at the world's origin, of the twist of a frame at p
    (..., 3)."""
    return about_moving_point(twist, -origin_derivatives(twist, p))


def relative_twist(
    twist_WA: np.ndarray, X_WA: np.ndarray, twist_WB: np.ndarray, X_WB: np.ndarray
) -> np.ndarray:
    """Returns the twist of B as an observer in A sees it, in A's axes, with its derivatives there.

    twist_WA, twist_WB (N, ..., 6): in W. X_WA, X_WB (..., 4, 4). The twist composes by addition (Eq. (118)):
    at Bo it is V_WB − V_WA; the derivatives are those of its components in the moving A."""
    p_AB = X_WB[..., :3, 3] - X_WA[..., :3, 3]
    between = np.concatenate([p_AB[None], twist_WB[..., 3:] - twist_WA[..., 3:]])
    R = rotation_derivatives(twist_WA[..., :3], X_WA[..., :3, :3])
    return turned(transpose(R), twist_WB - about_moving_point(twist_WA, between))


def inverse_pose(X: np.ndarray) -> np.ndarray:
    """Returns X⁻¹ of rigid X (..., 4, 4)."""
    R = transpose(X[..., :3, :3])
    inverse = np.zeros_like(X)
    inverse[..., :3, :3], inverse[..., :3, 3], inverse[..., 3, 3] = R, -apply(R, X[..., :3, 3]), 1
    return inverse
