"""A rigid body's acceleration field from measurements at some of its points.

The points lie on the axis before the last: points (..., P, 3) in m, their n-th order accelerations (..., P,
3) in m/sⁿ. The answer is the least-squares solution for redundant or noisy measurements;
`fields.acceleration` at the points then shows the misfit.
"""

from __future__ import annotations

from math import comb

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual import divide
from workbench.algebra.dual_tensors import adjugate, apply, cross, determinant, dot, outer, skew, transpose
from workbench.kinematics.tensors import as_vectors, identity_like, scalar_kind

from .fields import solve

RELATIVE_FLATNESS = 1e-9
"""Float points are collinear (coplanar) when their spread across is below this part of their spread along,
or below the rounding of their coordinates. Exact points are so only when they are exactly."""


def field_from_points(points: ArrayLike, accelerations: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns (Φₙ, aₙ), (..., 3, 3) and (..., 3), from the n-th order accelerations of at least 4 points.

    points, accelerations (..., P, 3). Any affine field fits 4 points; whether it is that of a rigid body
    is not asked. Solves Eq. (17) about the centroid. Raises ValueError for a wrong shape, fewer than 4
    points, or coplanar ones.
    """
    points, accelerations = _measurements(points, accelerations, "accelerations", 4)
    _require_spread(points, 3)
    centroid, arms = _centred(points)
    mean, relative = _centred(accelerations)
    if scalar_kind(points, accelerations) == "float":
        Phi = transpose(np.linalg.pinv(arms.astype(float)) @ relative)
    else:
        moments = outer(arms, arms).sum(axis=-3)
        inverse = divide(adjugate(moments), np.asarray(determinant(moments))[..., None, None])
        Phi = outer(relative, arms).sum(axis=-3) @ inverse
    return Phi, mean - apply(Phi, centroid)


def twist_from_points(points: ArrayLike, accelerations: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns (omega, v), each (N, ..., 3), from the accelerations of orders 1..N of at least 3 points.

    points (..., P, 3); accelerations (N, ..., P, 3), accelerations[n-1] in m/sⁿ. Because the body is
    rigid, only ω⁽ⁿ⁻¹⁾ of Φₙ is not known from the orders below, and 3 points that are not collinear give
    it. With the arms dᵢ and the remaining accelerations rᵢ about the centroid,
        Σᵢ (dᵢ² I - dᵢ ⊗ dᵢ) ω⁽ⁿ⁻¹⁾ = Σᵢ dᵢ × rᵢ.
    Raises ValueError for a wrong shape, fewer than 3 points, or collinear ones.
    """
    accelerations = as_vectors(accelerations, "accelerations")
    if accelerations.ndim < 3 or len(accelerations) == 0:
        raise ValueError(
            f"accelerations: expected shape (N, ..., P, 3) with N >= 1, got {accelerations.shape}"
        )
    points, _ = _measurements(points, accelerations[0], "accelerations[0]", 3)
    _require_spread(points, 2)
    centroid, arms = _centred(points)
    omega: list[np.ndarray] = []
    v: list[np.ndarray] = []
    Phi, a = [identity_like(outer(centroid, centroid))], [0 * centroid]
    for n, measured in enumerate(accelerations):
        mean, relative = _centred(measured)
        known = sum(
            (comb(n, k) * skew(omega[n - k]) @ Phi[k] for k in range(1, n + 1)),
            start=0 * Phi[0],
        )
        omega.append(_turn(arms, relative - apply(known[..., None, :, :], arms)))
        Phi.append(known + skew(omega[n]))
        a.append(mean - apply(Phi[n + 1], centroid))
        lower = (comb(n, k) * cross(omega[n - k], a[k]) for k in range(1, n + 1))
        v.append(a[n + 1] - sum(lower, start=0 * a[0]))
    return np.stack(omega), np.stack(v)


def _turn(arms: np.ndarray, displacements: np.ndarray) -> np.ndarray:
    """Returns the ω with ω × arms = displacements, in least squares."""
    if scalar_kind(arms, displacements) == "float":
        arms, displacements = arms.astype(float), displacements.astype(float)
        rows = -skew(arms)
        rows = rows.reshape(*rows.shape[:-3], -1, 3)
        columns = displacements.reshape(*displacements.shape[:-2], -1, 1)
        return (np.linalg.pinv(rows) @ columns)[..., 0]
    dyads = outer(arms, arms)
    squares = np.asarray(dot(arms, arms))[..., None, None] * identity_like(dyads)
    return solve((squares - dyads).sum(axis=-3), cross(arms, displacements).sum(axis=-2))


def _measurements(
    points: ArrayLike, accelerations: ArrayLike, name: str, least: int
) -> tuple[np.ndarray, np.ndarray]:
    points, accelerations = as_vectors(points, "points"), as_vectors(accelerations, name)
    if points.ndim < 2 or points.shape[-2] < least:
        count = points.shape[-2] if points.ndim > 1 else 1
        raise ValueError(f"points: expected at least {least} points (..., P, 3), got {count}")
    if accelerations.ndim < 2 or accelerations.shape[-2] != points.shape[-2]:
        raise ValueError(
            f"{name}: expected one acceleration for each of the {points.shape[-2]} points, "
            f"got shape {accelerations.shape}"
        )
    return points, accelerations


def _centred(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    mean = divide(x.sum(axis=-2), x.shape[-2])
    return mean, x - mean[..., None, :]


def _require_spread(points: np.ndarray, dimension: int) -> None:
    """Raises ValueError unless the points span `dimension` (2: not collinear, 3: not coplanar)."""
    _, arms = _centred(points)
    kind = scalar_kind(points)
    if kind == "symbolic":
        return
    if kind == "exact":
        dyads = outer(arms, arms)
        if dimension == 2:
            dyads = np.asarray(dot(arms, arms))[..., None, None] * identity_like(dyads) - dyads
        flat = determinant(dyads.sum(axis=-3)) == 0
    else:
        spread = np.linalg.svd(arms.astype(float), compute_uv=False)
        rounding = 64 * np.finfo(float).eps * np.abs(points).max(axis=(-1, -2))
        least = np.maximum(RELATIVE_FLATNESS * spread[..., 0], rounding)
        flat = spread[..., dimension - 1] <= least
    if np.any(flat):
        shape = {2: "collinear", 3: "coplanar"}[dimension]
        raise ValueError(f"points: expected points that are not {shape}, got {shape} ones")
