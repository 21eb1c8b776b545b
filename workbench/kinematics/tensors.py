"""Checks and conversions of vectors and tensors with exact, floating or symbolic entries.

A vector is an array (..., 3), a tensor an array (..., 3, 3); leading axes broadcast. The products are those
of `workbench.algebra.dual_tensors`, which take real arrays too. The scalars are float64, or (dtype object)
Python ints, `fractions.Fraction`, `flint.fmpq` and `pydrake.symbolic.Expression`. (Drake keeps Expressions as
NaNs with a payload, which makes NumPy warn of invalid values in sound results: work on them under
`np.errstate(invalid="ignore")`.)
"""

from __future__ import annotations

from numbers import Rational

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual import divide
from workbench.algebra.dual_tensors import transpose


def as_vectors(x: ArrayLike, name: str) -> np.ndarray:
    """Returns `x` as an array (..., 3): float64, or object where its scalars are exact or symbolic.

    Raises ValueError if the last axis is not 3 long or a float is not finite.
    """
    return _as_array(x, (3,), name)


def as_tensors(x: ArrayLike, name: str) -> np.ndarray:
    """Returns `x` as an array (..., 3, 3), by the rules of `as_vectors`."""
    return _as_array(x, (3, 3), name)


def _as_array(x: ArrayLike, core: tuple[int, ...], name: str) -> np.ndarray:
    try:
        array = np.asarray(x)
    except ValueError as error:
        raise ValueError(f"{name}: expected an array of shape {_shape_text(core)}: {error}") from None
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


def _is_exact_scalar(x: ArrayLike) -> bool:
    if isinstance(x, Rational):
        return True
    return type(x).__module__.startswith("flint") and type(x).__name__ in ("fmpq", "fmpz")


def scalar_kind(*arrays: np.ndarray) -> str:
    """Returns 'float', 'exact' (rational numbers) or 'symbolic' (anything else, such as a Drake Expression).

    Mixed with floats, exact scalars count as floats: what was computed from a float is not exact.
    """
    scalars = [x for array in arrays if array.dtype == object for x in array.flat]
    floats = any(array.dtype != object and array.size for array in arrays)
    floats = floats or any(isinstance(x, float) for x in scalars)
    if all(isinstance(x, float) or _is_exact_scalar(x) for x in scalars):
        return "float" if floats or not scalars else "exact"
    return "symbolic"


def identity_like(T: np.ndarray) -> np.ndarray:
    """Returns the unit tensor I in the shape and scalar type of the tensors T."""
    return 0 * T + np.eye(3, dtype=int)


def sym(T: np.ndarray) -> np.ndarray:
    """Returns S = (T + Tᵀ)/2, (..., 3, 3), so that T = t̃ + S with t = vect T."""
    return divide(T + transpose(T), 2)
