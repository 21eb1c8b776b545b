"""Vectors and tensors of Euclidean 3-space as batched arrays over any scalars.

A vector is an array (..., 3), a tensor an array (..., 3, 3); leading axes broadcast. The scalars are
float64, or (dtype object) Python ints, `fractions.Fraction`, `flint.fmpq` and `pydrake.symbolic.Expression`.
Everything here is written with +, -, * and division by an integer, so exact scalars stay exact and
symbolic ones stay symbolic. (Drake keeps Expressions as NaNs with a payload, which makes NumPy warn of
invalid values in sound results: work on them under `np.errstate(invalid="ignore")`.)
"""

from __future__ import annotations

from fractions import Fraction
from numbers import Rational

import numpy as np


def as_vectors(x, name: str) -> np.ndarray:
    """`x` as an array (..., 3): float64, or object where its scalars are exact or symbolic.

    Raises ValueError if the last axis is not 3 long or a float is not finite.
    """
    return _as_array(x, (3,), name)


def as_tensors(x, name: str) -> np.ndarray:
    """`x` as an array (..., 3, 3), by the rules of `as_vectors`."""
    return _as_array(x, (3, 3), name)


def _as_array(x, core: tuple[int, ...], name: str) -> np.ndarray:
    try:
        array = np.asarray(x)
    except ValueError as error:
        raise ValueError(
            f"{name}: expected an array of shape {_shape_text(core)}: {error}"
        ) from None
    if array.shape[-len(core) :] != core:
        raise ValueError(f"{name}: expected shape {_shape_text(core)}, got {array.shape}")
    if array.dtype == object:
        return array
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{name}: expected real numbers, got an array of {array.dtype}")
    array = array.astype(float)
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers, got a NaN or an infinity")
    return array


def _shape_text(core: tuple[int, ...]) -> str:
    return f"(..., {', '.join(map(str, core))})"


def _is_exact_scalar(x) -> bool:
    if isinstance(x, Rational):
        return True
    return type(x).__module__.startswith("flint") and type(x).__name__ in ("fmpq", "fmpz")


def scalar_kind(*arrays: np.ndarray) -> str:
    """'float', 'exact' (rational numbers) or 'symbolic' (anything else, such as a Drake Expression).

    Mixed with floats, exact scalars count as floats: what was computed from a float is not exact.
    """
    scalars = [x for array in arrays if array.dtype == object for x in array.flat]
    floats = any(array.dtype != object and array.size for array in arrays)
    floats = floats or any(isinstance(x, float) for x in scalars)
    if all(isinstance(x, float) or _is_exact_scalar(x) for x in scalars):
        return "float" if floats or not scalars else "exact"
    return "symbolic"


def _divided_scalar(x, y):
    if isinstance(x, int) and isinstance(y, int):
        return Fraction(x, y)
    if type(x).__name__ == "fmpz" and _is_exact_scalar(y):
        from flint import fmpq

        return fmpq(x, 1) / y
    return x / y


_divide_objects = np.frompyfunc(_divided_scalar, 2, 1)


def divide(x, y) -> np.ndarray:
    """x / y elementwise, exact on exact scalars (two Python ints give a Fraction)."""
    x, y = np.asarray(x), np.asarray(y)
    return np.asarray(_divide_objects(x, y)) if object in (x.dtype, y.dtype) else x / y


def _zero_like(x: np.ndarray) -> np.ndarray:
    """Zeros of x's own scalar type (a plain int 0 would not do in an array of Expressions)."""
    return 0 * x if x.dtype == object else np.zeros_like(x)


def identity_like(T: np.ndarray) -> np.ndarray:
    """The unit tensor I in the shape and scalar type of the tensors T."""
    return _zero_like(T) + np.eye(3, dtype=int)


def dot(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """x · y, (...)."""
    return x[..., 0] * y[..., 0] + x[..., 1] * y[..., 1] + x[..., 2] * y[..., 2]


def cross(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """x × y, (..., 3)."""
    return np.stack(
        [
            x[..., 1] * y[..., 2] - x[..., 2] * y[..., 1],
            x[..., 2] * y[..., 0] - x[..., 0] * y[..., 2],
            x[..., 0] * y[..., 1] - x[..., 1] * y[..., 0],
        ],
        axis=-1,
    )


def outer(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """x ⊗ y, (..., 3, 3): (x ⊗ y) z = x (y · z)."""
    return x[..., :, None] * y[..., None, :]


def apply(T: np.ndarray, x: np.ndarray) -> np.ndarray:
    """T x, (..., 3)."""
    return (
        T[..., :, 0] * x[..., None, 0]
        + T[..., :, 1] * x[..., None, 1]
        + T[..., :, 2] * x[..., None, 2]
    )


def compose(T: np.ndarray, U: np.ndarray) -> np.ndarray:
    """T U, (..., 3, 3)."""
    return (
        outer(T[..., :, 0], U[..., 0, :])
        + outer(T[..., :, 1], U[..., 1, :])
        + outer(T[..., :, 2], U[..., 2, :])
    )


def transpose(T: np.ndarray) -> np.ndarray:
    """Tᵀ."""
    return np.swapaxes(T, -1, -2)


def skew(x: np.ndarray) -> np.ndarray:
    """x̃, (..., 3, 3): x̃ y = x × y."""
    zero = _zero_like(x[..., 0])
    x1, x2, x3 = x[..., 0], x[..., 1], x[..., 2]
    rows = [[zero, -x3, x2], [x3, zero, -x1], [-x2, x1, zero]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def vect(T: np.ndarray) -> np.ndarray:
    """The axial vector t of T, (..., 3): t̃ = (T - Tᵀ)/2."""
    twice = [T[..., 2, 1] - T[..., 1, 2], T[..., 0, 2] - T[..., 2, 0], T[..., 1, 0] - T[..., 0, 1]]
    return divide(np.stack(twice, axis=-1), 2)


def sym(T: np.ndarray) -> np.ndarray:
    """S = (T + Tᵀ)/2, (..., 3, 3), so that T = t̃ + S with t = vect T."""
    return divide(T + transpose(T), 2)


def trace(T: np.ndarray) -> np.ndarray:
    """tr T, (...)."""
    return T[..., 0, 0] + T[..., 1, 1] + T[..., 2, 2]


def det(T: np.ndarray) -> np.ndarray:
    """det T, (...), as the triple product of the rows."""
    return dot(T[..., 0, :], cross(T[..., 1, :], T[..., 2, :]))


def adjugate(T: np.ndarray) -> np.ndarray:
    """T*, (..., 3, 3): T T* = T* T = (det T) I, of a singular T too (its columns: rows crossed)."""
    row1, row2, row3 = T[..., 0, :], T[..., 1, :], T[..., 2, :]
    return np.stack([cross(row2, row3), cross(row3, row1), cross(row1, row2)], axis=-1)
