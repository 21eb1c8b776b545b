"""Dual vectors and dual tensors of Euclidean 3-space, Eqs. (73)–(78), over any scalar ring.

A dual vector is a `Dual` whose parts have shape (..., 3), a dual tensor one whose parts have shape (..., 3,
3); leading axes are a batch. Every function also takes real arrays, and then returns real ones. ``T @ S`` and
``apply(T, a)`` are the products; ``*`` acts entry by entry, so multiply a batch by its scalars with `scale`.
Arrays of dtype object carry exact or symbolic scalars.
"""

from collections.abc import Callable
from typing import Any, Protocol, overload

import numpy as np

from workbench.algebra.dual import Du, Dual, Re, ZeroDivisor, _vanishes, as_array, divide, is_zero
from workbench.algebra.dual_functions import sqrt

Array = np.ndarray | Dual


class Bilinear(Protocol):
    """A bilinear product; its value is dual if one of its factors is."""

    @overload
    def __call__(self, a: np.ndarray, b: np.ndarray, /) -> np.ndarray: ...
    @overload
    def __call__(self, a: Dual, b: Array, /) -> Dual: ...
    @overload
    def __call__(self, a: np.ndarray, b: Dual, /) -> Dual: ...
    @overload
    def __call__(self, a: Array, b: Array, /) -> Array: ...


class LinearMap(Protocol):
    """A linear map; its value is dual if its argument is."""

    @overload
    def __call__(self, a: np.ndarray, /) -> np.ndarray: ...
    @overload
    def __call__(self, a: Dual, /) -> Dual: ...
    @overload
    def __call__(self, a: Array, /) -> Array: ...


def vector(re: Any, du: Any = None) -> Dual:
    """Returns the dual vector re + ε du from arrays or lists of shape (..., 3), Eq. (73).

    Raises `ValueError` for another shape. A missing dual part is zero.
    """
    return _dual_array(re, du, (3,))


def tensor(re: Any, du: Any = None) -> Dual:
    """Returns the dual tensor re + ε du from arrays or lists of shape (..., 3, 3); errors as for `vector`."""
    return _dual_array(re, du, (3, 3))


def as_vector(a: Any) -> np.ndarray:
    """Returns a real vector of shape (..., 3), exact if its entries are; errors as for `vector`."""
    entries: np.ndarray = vector(a).re
    return entries


def _dual_array(re: Any, du: Any, shape: tuple[int, ...]) -> Dual:
    re = as_array(re)
    du = 0 * re if du is None else as_array(du)
    for part, entries in (("real", re), ("dual", du)):
        if entries.shape[-len(shape) :] != shape:
            expected = ", ".join(map(str, shape))
            raise ValueError(f"{part} part: expected shape (..., {expected}), got {entries.shape}")
    return Dual(re, du)


def bilinear(product: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> Bilinear:
    """Returns the extension of a bilinear product of real arrays to dual ones (ε commutes with it)."""

    def extended(a: Any, b: Any) -> Any:
        if isinstance(a, Dual):
            if isinstance(b, Dual):
                return Dual(product(a.re, b.re), product(a.re, b.du) + product(a.du, b.re))
            return Dual(product(a.re, b), product(a.du, b))
        if isinstance(b, Dual):
            return Dual(product(a, b.re), product(a, b.du))
        return product(a, b)

    extended.__doc__ = product.__doc__
    extended.__name__ = product.__name__
    return extended


def linear(map_: Callable[[np.ndarray], np.ndarray]) -> LinearMap:
    """Returns the extension of a linear map of real arrays to dual ones."""

    def extended(a: Any) -> Any:
        return Dual(map_(a.re), map_(a.du)) if isinstance(a, Dual) else map_(a)

    extended.__doc__ = map_.__doc__
    extended.__name__ = map_.__name__
    return extended


def _components(a: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns the three components as arrays of shape (..., 1); a single scalar might be a sequence."""
    return a[..., 0:1], a[..., 1:2], a[..., 2:3]


@bilinear
def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns the scalar product a · b: (..., 3), (..., 3) → (...)."""
    total: np.ndarray = (a * b).sum(axis=-1)
    return total


@bilinear
def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns the cross product a × b: (..., 3), (..., 3) → (..., 3)."""
    (a1, a2, a3), (b1, b2, b3) = _components(a), _components(b)
    return np.concatenate([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1], axis=-1)


@bilinear
def outer(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns the tensor a ⊗ b: (..., 3), (..., 3) → (..., 3, 3)."""
    products: np.ndarray = a[..., :, None] * b[..., None, :]
    return products


@bilinear
def apply(T: np.ndarray, a: np.ndarray) -> np.ndarray:
    """Returns the vector T a: (..., 3, 3), (..., 3) → (..., 3)."""
    image: np.ndarray = (T @ a[..., None])[..., 0]
    return image


@overload
def scale(c: Dual, a: Array, rank: int = 1) -> Dual: ...
@overload
def scale(c: Any, a: Dual, rank: int = 1) -> Dual: ...
@overload
def scale(c: Any, a: np.ndarray, rank: int = 1) -> np.ndarray: ...
@overload
def scale(c: Any, a: Array, rank: int = 1) -> Array: ...
def scale(c: Any, a: Array, rank: int = 1) -> Array:
    """Returns c a for scalars c of shape (...) and vectors a (rank 1) or tensors a (rank 2)."""
    return _with_axes(c, rank) * a


def _with_axes(c: Any, rank: int) -> Array:
    """Returns scalars of shape (...) as an array of shape (..., 1, …, 1), to act on arrays of that rank."""
    if isinstance(c, Dual):
        return Dual(_with_axes(c.re, rank), _with_axes(c.du, rank))
    return as_array(c)[(..., *(None,) * rank)]


@linear
def skew(a: np.ndarray) -> np.ndarray:
    """Returns the tensor ã with ã b = a × b: (..., 3) → (..., 3, 3)."""
    a1, a2, a3 = _components(a)
    zero = 0 * a1
    entries = [zero, -a3, a2, a3, zero, -a1, -a2, a1, zero]
    return np.concatenate(entries, axis=-1).reshape((*a.shape, 3))


@linear
def vect(T: np.ndarray) -> np.ndarray:
    """Returns the axial vector of the skew part of T, so that vect(ã) = a: (..., 3, 3) → (..., 3)."""
    twice = [T[..., k, j : j + 1] - T[..., j, k : k + 1] for j, k in ((1, 2), (2, 0), (0, 1))]
    axis: np.ndarray = divide(np.concatenate(twice, axis=-1), 2)
    return axis


@linear
def transpose(T: np.ndarray) -> np.ndarray:
    """Returns the transposed tensor, u · (T v) = v · (Tᵀ u); in Eq. (76) the first v̲₁ should be v̲₂."""
    return np.swapaxes(T, -1, -2)


@linear
def trace(T: np.ndarray) -> np.ndarray:
    """Returns the trace: (..., 3, 3) → (...)."""
    total: np.ndarray = T[..., range(3), range(3)].sum(axis=-1)
    return total


def triple(a: Array, b: Array, c: Array) -> Any:
    """Returns the triple product ⟨a, b, c⟩ = a · (b × c)."""
    return dot(a, cross(b, c))


def _columns(T: Array) -> tuple[Array, Array, Array]:
    return T[..., :, 0], T[..., :, 1], T[..., :, 2]


def determinant(T: Array) -> Any:
    """Returns the determinant, ⟨T a, T b, T c⟩ = det T ⟨a, b, c⟩, Eq. (77)."""
    return triple(*_columns(T))


@overload
def adjugate(T: Dual) -> Dual: ...
@overload
def adjugate(T: np.ndarray) -> np.ndarray: ...
def adjugate(T: Array) -> Array:
    """Returns the adjugate, T adj T = adj T T = (det T) I: (..., 3, 3) → (..., 3, 3)."""
    c1, c2, c3 = _columns(T)
    rows = [cross(c2, c3), cross(c3, c1), cross(c1, c2)]
    re = np.stack([Re(row) for row in rows], axis=-2)
    if not isinstance(T, Dual):
        return re
    return Dual(re, np.stack([Du(row) for row in rows], axis=-2))


@overload
def inverse(T: np.ndarray) -> np.ndarray: ...
@overload
def inverse(T: Dual) -> Dual: ...
@overload
def inverse(T: Array) -> Array: ...
def inverse(T: Array) -> Array:
    """Returns T⁻¹ = adj T / det T; raises `ZeroDivisor` if Re(det T) is (anywhere) zero."""
    dual = T if isinstance(T, Dual) else Dual(T)
    inverted = adjugate(dual) / _with_axes(determinant(dual), 2)
    return inverted if isinstance(T, Dual) else inverted.re


def norm(a: Array) -> Any:
    """Returns the magnitude of a dual vector, Eq. (74), in both its cases: (..., 3) → (...).

    |a| = ‖a‖ + ε a₀·a/‖a‖ if Re a ≠ 0, and ε ‖a₀‖ if Re a = 0. The case is decided exactly,
    separately for each vector of a batch. Over exact scalars a length that is not a square root in the ring
    raises a `TypeError`.
    """
    if not isinstance(a, Dual):
        return _length(a)
    if a.re.dtype != object and a.du.dtype != object:
        return _norm_of_floats(a.re, a.du)
    re = np.empty(a.re.shape[:-1], dtype=object)
    du = np.empty_like(re)
    for i in np.ndindex(re.shape):
        re[i], du[i] = _norm_of_objects(a.re[i], a.du[i])
    return Dual(re, du)


def _norm_of_objects(a: np.ndarray, a0: np.ndarray) -> tuple[Any, Any]:
    if is_zero(a):
        return 0 * a[0], sqrt(dot(a0, a0))
    length = sqrt(dot(a, a))
    return length, divide(dot(a0, a), length)


def _norm_of_floats(a: np.ndarray, a0: np.ndarray) -> Dual:
    length = _length(a)
    is_pure = length == 0
    direction = a / np.where(is_pure, 1.0, length)[..., None]
    return Dual(length, np.where(is_pure, _length(a0), (a0 * direction).sum(axis=-1)))


def _length(a: np.ndarray) -> Any:
    """Returns ‖a‖ for real vectors; the squares of floats neither overflow nor underflow."""
    if a.dtype == object:
        return sqrt(dot(a, a))
    return np.hypot(np.hypot(a[..., 0], a[..., 1]), a[..., 2])


@overload
def unit(a: np.ndarray) -> np.ndarray: ...
@overload
def unit(a: Dual) -> Dual: ...
@overload
def unit(a: Array) -> Array: ...
def unit(a: Array) -> Array:
    """Returns the unit dual vector a / |a|; raises `ZeroDivisor` if Re a = 0, where no such vector exists."""
    length = norm(a)
    if _vanishes(Re(length)):
        raise ZeroDivisor("no unit vector: expected a dual vector with a real part that is not 0")
    return a / _with_axes(length, 1)


def identity() -> np.ndarray:
    """Returns the unit tensor, shape (3, 3), of dtype object so that it belongs to every scalar ring."""
    return np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=object)


def is_orthogonal(T: Array, tolerance: float = 0.0) -> bool:
    """True if every T of the batch is in the group of Eq. (78): T Tᵀ = I and det T = 1.

    With ``tolerance`` 0 the test is exact, as required for exact scalars. Otherwise the entries of T Tᵀ − I
    may deviate by it, those of the dual part by it times max(1, the largest in Du T).
    """
    dual = T if isinstance(T, Dual) else Dual(T)
    product = dual @ transpose(dual)
    if tolerance == 0:
        return product - identity() == 0 and determinant(dual) == 1
    defect = product - np.eye(3)
    length = np.maximum(1.0, np.abs(dual.du).max(axis=(-2, -1)))[..., None, None]
    is_close = np.abs(defect.re) <= tolerance, np.abs(defect.du) <= tolerance * length
    return bool(np.all(is_close[0]) and np.all(is_close[1]) and np.all(determinant(dual).re > 0))
