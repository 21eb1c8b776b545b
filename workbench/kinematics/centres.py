"""The points of a rigid body that have a prescribed n-th order acceleration, also when det Φₙ = 0.

The points with n-th order acceleration a* solve Φₙ ρ = a* - aₙ (Eq. (49)); with a* = 0 they are the
n-th order acceleration centres Gₙ (Eq. (50)). By the rank of Φₙ:

    rank 3   one point                    rank 2   a line, or no point
    rank 1   a plane, or no point         rank 0   every point, or no point
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual import divide
from workbench.algebra.dual_tensors import adjugate, apply, cross, determinant, dot, outer, skew, transpose
from workbench.kinematics.tensors import as_tensors, as_vectors, scalar_kind

from .fields import paired_derivatives, solve

KINDS = {-1: "none", 0: "point", 1: "line", 2: "plane", 3: "space"}


@dataclass(frozen=True)
class Locus:
    """The points ρ of the body with a prescribed n-th order acceleration, one set for each batch entry.

    dimension  (...) int: 0 a point, 1 a line, 2 a plane, 3 every point, -1 no point.
    rank       (...) int: the rank of Φₙ, by exact zeros or (floats) by the tolerance that was asked.
    point      (..., 3) in m: the point of the set nearest to the origin; of an empty set, the nearest
               point among those whose acceleration misses the prescribed one least.
    directions (..., 3, 3): its first `dimension` rows span the set from `point`, the other rows are 0.
               Orthonormal on floats, orthogonal on exact scalars.
    residual   (..., 3) in m/sⁿ: Φₙ point + aₙ - a*, by which `point` misses; not 0 where no point fits.
    """

    dimension: np.ndarray
    rank: np.ndarray
    point: np.ndarray
    directions: np.ndarray
    residual: np.ndarray

    @property
    def kind(self) -> Any:
        """'none', 'point', 'line', 'plane' or 'space'; an array of these for a batch."""
        kinds = np.vectorize(KINDS.get, otypes=[object])(self.dimension)
        return kinds.item() if kinds.ndim == 0 else kinds

    def __str__(self) -> str:
        if self.dimension.ndim:
            return f"{self.dimension.size} loci: {', '.join(self.kind.flat)}"
        dimension = int(self.dimension)
        if dimension < 0:
            return "no point"
        if dimension == 3:
            return "every point"
        spans = " and ".join(_triple(row) for row in self.directions[:dimension])
        through = f"through {_triple(self.point)} m along {spans}"
        return f"point {_triple(self.point)} m" if dimension == 0 else f"{self.kind} {through}"


def _triple(x: np.ndarray) -> str:
    return "(" + ", ".join(f"{c:.6g}" if isinstance(c, float) else str(c) for c in x) + ")"


def acceleration_centre(
    Phi: ArrayLike, a: ArrayLike, *, rtol: float = 1e-9, Phi_scale: ArrayLike = 0.0, a_scale: ArrayLike = 0.0
) -> Locus:
    """Returns Gₙ, the points of zero n-th order acceleration, of Φₙ (..., 3, 3) and aₙ (..., 3); Eq. (50).

    For n = 1 these are a line exactly if ω · v = 0 and ω ≠ 0 (a pure rotation's axis).
    Tolerance and errors: see `points_with_acceleration`.

    >>> print(acceleration_centre([[-4, 0, 0], [0, -4, 0], [0, 0, 0]], [0, 2, 0]))
    line through (0, 0.5, 0) m along (0, 0, 1)
    """
    a = as_vectors(a, "a")
    return points_with_acceleration(Phi, a, 0 * a, rtol=rtol, Phi_scale=Phi_scale, a_scale=a_scale)


def points_with_acceleration(
    Phi: ArrayLike,
    a: ArrayLike,
    prescribed: ArrayLike,
    *,
    rtol: float = 1e-9,
    Phi_scale: ArrayLike = 0.0,
    a_scale: ArrayLike = 0.0,
) -> Locus:
    """Returns the points with n-th order acceleration `prescribed` (..., 3) in m/sⁿ; Eqs. (11), (49).

    Phi (..., 3, 3) in 1/sⁿ and a (..., 3) in m/sⁿ are Φₙ and aₙ.

    Exact scalars are decided exactly and nothing else is looked at. On floats a singular value of Φₙ
    counts as zero if it is <= rtol · max(the largest one, Phi_scale), and a* - aₙ is in the range of Φₙ
    if its part outside is <= rtol · max(|a*| + |aₙ|, a_scale). The scales (scalars or (...)) are the sizes
    of the terms that Φₙ and aₙ were summed from: give them where Φₙ or aₙ may be nothing but rounding
    (`field_scales` has them for a twist). rtol >= 0, below 1.

    Raises ValueError for wrong shapes or a wrong rtol, TypeError for symbolic scalars, whose rank nobody
    can decide: use `regular_point`.
    """
    Phi, a = as_tensors(Phi, "Phi"), as_vectors(a, "a")
    wanted = as_vectors(prescribed, "prescribed")
    kind = scalar_kind(Phi, a, wanted)
    if kind == "symbolic":
        raise TypeError("symbolic Phi, a: expected numbers, whose rank can be decided")
    if not 0 <= rtol < 1:
        raise ValueError(f"rtol: expected 0 <= rtol < 1, got {rtol}")
    batch = np.broadcast_shapes(Phi.shape[:-2], a.shape[:-1], wanted.shape[:-1])
    Phi = np.broadcast_to(Phi, (*batch, 3, 3))
    a, wanted = np.broadcast_to(a, (*batch, 3)), np.broadcast_to(wanted, (*batch, 3))
    if kind == "exact":
        return _exact_locus(Phi, wanted - a)
    Phi, a, wanted = Phi.astype(float), a.astype(float), wanted.astype(float)
    size = np.linalg.norm(a, axis=-1) + np.linalg.norm(wanted, axis=-1)
    return _float_locus(Phi, wanted - a, rtol, Phi_scale, np.maximum(size, a_scale))


def regular_point(Phi: ArrayLike, a: ArrayLike, prescribed: ArrayLike = 0) -> np.ndarray:
    """Returns ρ = Φₙ⁻¹ (a* - aₙ), (..., 3) in m, for a regular Φₙ and any scalars, symbolic too; Eqs. (49),
    (50).

    Raises ValueError where an exact or float Φₙ is singular; symbolic ones are taken to be regular.
    """
    return solve(Phi, np.asarray(prescribed) - as_vectors(a, "a"))


def field_scales(omega: ArrayLike, v: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns the sizes of the terms of Φₙ and aₙ, each (N+1, ...), of float omega, v (N, ..., 3).

    The norms' own recurrence: s₀ = 1, sₙ₊₁ = Σₖ C(n,k) |ω⁽ⁿ⁻ᵏ⁾| sₖ; b₀ = 0, bₙ₊₁ = |v⁽ⁿ⁾| + Σₖ C(n,k)
    |ω⁽ⁿ⁻ᵏ⁾| bₖ. So ‖Φₙ‖ <= sₙ, |aₙ| <= bₙ, and their rounding errors are a small multiple of eps times these.
    """
    omega, v = paired_derivatives(omega, v, ("omega", "v"))
    w, u = np.linalg.norm(omega.astype(float), axis=-1), np.linalg.norm(v.astype(float), axis=-1)
    s, b = [np.ones(w.shape[1:])], [np.zeros(u.shape[1:])]
    for n in range(len(w)):
        s.append(sum(comb(n, k) * w[n - k] * s[k] for k in range(n + 1)))
        b.append(u[n] + sum(comb(n, k) * w[n - k] * b[k] for k in range(n + 1)))
    return np.stack(s), np.stack(b)


def _float_locus(
    Phi: np.ndarray, target: np.ndarray, rtol: float, Phi_scale: ArrayLike, a_scale: np.ndarray
) -> Locus:
    U, s, Vt = np.linalg.svd(Phi)
    zero = s <= rtol * np.maximum(s[..., 0], Phi_scale)[..., None]
    components = apply(transpose(U), target)
    outside = np.linalg.norm(np.where(zero, components, 0), axis=-1)
    coordinates = np.where(zero, 0, components) / np.where(zero, 1, s)
    point = apply(transpose(Vt), coordinates)
    rank = 3 - zero.sum(axis=-1)
    solvable = outside <= rtol * a_scale
    null_first = np.where(zero[..., None], Vt, 0)[..., ::-1, :]
    return Locus(
        dimension=np.where(solvable, 3 - rank, -1),
        rank=rank,
        point=point,
        directions=np.where(solvable[..., None, None], null_first, 0),
        residual=apply(Phi, point) - target,
    )


def _exact_locus(Phi: np.ndarray, target: np.ndarray) -> Locus:
    batch = Phi.shape[:-2]
    dimension, rank = np.empty(batch, dtype=int), np.empty(batch, dtype=int)
    point, directions = np.empty((*batch, 3), dtype=object), np.empty((*batch, 3, 3), dtype=object)
    for i in np.ndindex(batch):
        rank[i], spans, point[i] = _exact_solution(Phi[i], target[i])
        missed = np.any(apply(Phi[i], point[i]) != target[i])
        dimension[i] = -1 if missed else len(spans)
        directions[i] = 0
        if not missed and spans:
            directions[i][: len(spans)] = spans
    return Locus(dimension, rank, point, directions, residual=apply(Phi, point) - target)


def _exact_solution(Phi: np.ndarray, b: np.ndarray) -> tuple[int, list[np.ndarray], np.ndarray]:
    """Returns (rank, basis of the null space, shortest least-squares solution ρ of Φ ρ = b) in rationals
    only."""
    cofactors = adjugate(Phi)
    if determinant(Phi) != 0:
        return 3, [], divide(apply(cofactors, b), determinant(Phi))
    if np.any(cofactors != 0):
        # Φ* is a multiple of right ⊗ left, the null vectors of Φ and Φᵀ. The bordered tensor is regular,
        # and for a target across `left` its solution is across `right`: the shortest one.
        right, left = _longest_row(transpose(cofactors)), _longest_row(cofactors)
        reachable = b - divide(dot(left, b) * left, dot(left, left))
        return 2, [right], solve(Phi + outer(left, right), reachable)
    y = _longest_row(Phi)
    if np.any(y != 0):
        x = divide(apply(Phi, y), dot(y, y))
        across = _longest_row(skew(y))
        return 1, [across, cross(y, across)], divide(dot(x, b) * y, dot(x, x) * dot(y, y))
    return 0, list(np.eye(3, dtype=int).astype(object)), 0 * b


def _longest_row(T: np.ndarray) -> np.ndarray:
    return T[np.argmax(dot(T, T))]
