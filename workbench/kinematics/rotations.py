"""Rotations of Euclidean 3-space by angle and axis, in floats, accurate at every angle.

Batched over leading axes: an angle has shape (...) and is in radians, an axis (..., 3) and is a unit
vector, a rotation tensor (..., 3, 3).
"""

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual_tensors import skew
from workbench.kinematics.tensors import as_vectors


def sine_and_versine(angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns sin α and 1 − cos α, the latter without cancellation near α = 0."""
    return np.sin(angle), 2 * np.sin(angle / 2) ** 2


def rotation(angle: ArrayLike, axis: ArrayLike) -> np.ndarray:
    """Returns R = I + sin α ũ + (1 − cos α) ũ², (..., 3, 3), the first line of Eq. (83).

    angle (...) in rad, axis (..., 3), a unit vector; their leading axes broadcast. Raises
    ValueError for an axis of another shape and for one that is not finite.
    """
    sine, versine = sine_and_versine(np.asarray(angle))
    u = skew(as_vectors(axis, "axis"))
    return np.eye(3) + sine[..., None, None] * u + versine[..., None, None] * (u @ u)


def length_and_direction(a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns ‖a‖ and a / ‖a‖, the direction of the zero vector being e₃: (..., 3) → (...), (..., 3)."""
    length = np.hypot(np.hypot(a[..., 0], a[..., 1]), a[..., 2])
    is_zero = (length == 0)[..., None]
    return length, np.where(is_zero, [0.0, 0.0, 1.0], a / np.where(is_zero, 1, length[..., None]))


def angle_and_axis(R: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the angle in [0, π] and the axis of a rotation tensor; the axis is e₃ for R = I.

    At α = π, where u and −u give the same rotation, u is the one whose first component that is not
    zero is positive. The tensor is not checked; see `workbench.kinematics.screws.log`.
    """
    q = _quaternion(R)
    sine_of_half, axis = length_and_direction(q[..., 1:])
    return 2 * np.arctan2(sine_of_half, q[..., 0]), axis


def _quaternion(R: np.ndarray) -> np.ndarray:
    """Returns the unit quaternion (w, x, y, z) of R with w ≥ 0, up to sign if w = 0: Shepperd's method.

    Each row of the symmetric 4 q ⊗ q can be read off R; the row of the largest entry of q is the
    one where nothing cancels.
    """
    diagonal = R[..., range(3), range(3)]
    off = {(i, j): R[..., i, j] for i in range(3) for j in range(3) if i != j}
    x, y, z = (off[k, j] - off[j, k] for j, k in ((1, 2), (2, 0), (0, 1)))
    xy, yz, zx = (off[j, k] + off[k, j] for j, k in ((0, 1), (1, 2), (2, 0)))
    ww, xx, yy, zz = (1 + diagonal @ signs for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)))
    rows = np.stack([ww, x, y, z, x, xx, xy, zx, y, xy, yy, yz, z, zx, yz, zz], axis=-1)
    rows = rows.reshape((*R.shape[:-2], 4, 4))
    largest = np.argmax(np.stack([ww, xx, yy, zz], axis=-1), axis=-1)
    q = np.take_along_axis(rows, largest[..., None, None], axis=-2)[..., 0, :]
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    leading = np.take_along_axis(q, np.argmax(q != 0, axis=-1)[..., None], axis=-1)
    return np.where(leading < 0, -q, q)
