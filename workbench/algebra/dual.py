"""Dual numbers a + ε a₀ with ε² = 0 over any scalar ring, Eqs. (71)–(72).

The parts may be floats, ints, Fractions, flint ``fmpq`` or ``fmpq_mpoly``, Drake ``Expression``
or ``AutoDiffXd``, or NumPy arrays of any of these. Over arrays every operation acts entry by entry,
and a dual vector or tensor is such a dual number: see `workbench.algebra.dual_tensors`.
No arithmetic is done in floating point unless a part is a float already: int / int is a Fraction.
"""

import math
import operator
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import numpy as np


class ZeroDivisor(ZeroDivisionError):
    """A dual number with real part zero is a zero divisor: it has no inverse."""


class Dual:
    """The dual number ``re + ε du``, Eq. (71). Immutable; `Re` and `Du` return the parts.

    ``==`` is equality of both parts (for arrays: of all entries; for Drake Expressions: of the
    expanded polynomials, so it may miss an equality that needs sin² + cos² = 1).

    >>> Dual(2, 3) * Dual(5, 7)
    Dual(10, 29)
    """

    __slots__ = ("du", "re")
    __array_ufunc__ = None  # ndarray * Dual is Dual.__rmul__, never an array of Duals

    re: Any
    du: Any

    def __init__(self, re: Any, du: Any = 0) -> None:
        if isinstance(re, Dual) or isinstance(du, Dual):
            raise TypeError("a dual number over dual numbers: expected re and du in a real ring")
        if isinstance(re, np.ndarray | list | tuple) or isinstance(du, np.ndarray | list | tuple):
            re, du = _entries(re, du)
        else:
            re, du = _in_one_ring(re, du)
        object.__setattr__(self, "re", re)
        object.__setattr__(self, "du", du)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"a dual number is immutable: cannot set {name}")

    def __reduce__(self) -> tuple[type["Dual"], tuple[Any, Any]]:
        return Dual, (self.re, self.du)

    def __repr__(self) -> str:
        return f"Dual({self.re!r}, {self.du!r})"

    def __pos__(self) -> "Dual":
        return self

    def __neg__(self) -> "Dual":
        return Dual(-self.re, -self.du)

    def __add__(self, other: Any) -> "Dual":
        re, du = _parts(other)
        return Dual(_add(self.re, re), _add(self.du, du))

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Dual":
        difference: Dual = self + (-other)
        return difference

    def __rsub__(self, other: Any) -> "Dual":
        difference: Dual = -self + other
        return difference

    def __mul__(self, other: Any) -> "Dual":
        if not isinstance(other, Dual):
            return Dual(_mul(self.re, other), _mul(self.du, other))
        return Dual(_mul(self.re, other.re), _add(_mul(self.re, other.du), _mul(self.du, other.re)))

    __rmul__ = __mul__

    def __matmul__(self, other: Any) -> "Dual":
        """Returns the product of dual matrices and vectors (parts: NumPy arrays with matching axes)."""
        if not isinstance(other, Dual):
            return Dual(self.re @ other, self.du @ other)
        return Dual(self.re @ other.re, self.re @ other.du + self.du @ other.re)

    def __rmatmul__(self, other: Any) -> "Dual":
        return Dual(other @ self.re, other @ self.du)

    def __truediv__(self, other: Any) -> "Dual":
        """Returns the quotient; raises `ZeroDivisor` if the divisor's real part is (anywhere) zero.

        Over a polynomial ring the quotient must exist in the ring; otherwise the ring's error propagates.
        """
        re, du = _parts(other)
        if _vanishes(re):
            raise ZeroDivisor(f"division by {other!r}: its real part is zero, so it has no inverse")
        quotient = divide(self.re, re)
        return Dual(quotient, divide(_add(self.du, -_mul(quotient, du)), re))

    def __rtruediv__(self, other: Any) -> "Dual":
        return Dual(other, 0 * self.du) / self

    def __pow__(self, n: int) -> "Dual":
        """Returns the n-th power for an integer n; entry by entry if the parts are arrays."""
        try:
            n = operator.index(n)
        except TypeError:
            raise TypeError(f"power of a dual number: expected an integer exponent, got {n!r}") from None
        if n < 0:
            return 1 / self**-n
        if n == 0:
            return Dual(self.re**0, 0 * self.du)
        return Dual(self.re**n, _mul(n * self.re ** (n - 1), self.du))

    def __eq__(self, other: Any) -> bool:
        try:
            difference = self - other
        except (TypeError, ValueError):
            return NotImplemented
        return is_zero(difference.re) and is_zero(difference.du)

    def __hash__(self) -> int:
        return hash(self.re) if is_zero(self.du) else hash((self.re, self.du))

    def __getitem__(self, index: Any) -> "Dual":
        """Returns the entries ``index`` of a dual array."""
        return Dual(self.re[index], self.du[index])


def Re(a: Any) -> Any:
    """Returns the real part of a dual number; a real number unchanged."""
    return a.re if isinstance(a, Dual) else a


def Du(a: Any) -> Any:
    """Returns the dual part of a dual number; zero for a real number."""
    return a.du if isinstance(a, Dual) else 0 * a


def _parts(a: Any) -> tuple[Any, Any]:
    return (a.re, a.du) if isinstance(a, Dual) else (a, 0)


def _is_flint(a: Any) -> bool:
    return type(a).__module__.startswith("flint")


def as_array(a: Any) -> np.ndarray:
    """Returns a scalar or nested lists of scalars of any ring as an array.

    NumPy would treat a flint polynomial as a sequence of its coefficients; here it is one entry.
    """
    if isinstance(a, np.ndarray):
        return a
    leaves = list(_leaves(a))
    if not any(_is_flint(leaf) for leaf in leaves):
        return np.asarray(a)
    shape = _nesting(a)
    if len(leaves) != math.prod(shape):
        raise ValueError(f"expected lists of equal lengths, got {a!r}")
    entries = np.empty(len(leaves), dtype=object)
    entries[:] = leaves
    return entries.reshape(shape)


def _leaves(a: Any) -> Iterator[Any]:
    if isinstance(a, list | tuple):
        for entry in a:
            yield from _leaves(entry)
    else:
        yield a


def _nesting(a: Any) -> tuple[int, ...]:
    return (len(a), *_nesting(a[0])) if isinstance(a, list | tuple) else ()


def _entries(re: Any, du: Any) -> tuple[Any, Any]:
    """Returns re and du as arrays of one shape (scalars if it is ()) over one ring.

    Integers become Python integers, which cannot overflow.
    """
    re, du = np.broadcast_arrays(as_array(re), as_array(du))
    if np.issubdtype(np.result_type(re, du), np.integer):
        re, du = re.astype(object), du.astype(object)
    if re.ndim == 0:
        return _in_one_ring(re[()], du[()])
    if any(_is_flint(entry) for part in (re, du) if part.dtype == object for entry in part.flat):
        return _without_fractions(re), _without_fractions(du)
    return re, du


def _in_one_ring(a: Any, b: Any) -> tuple[Any, Any]:
    """Returns a and b as operands of one ring: flint rejects Fractions, so they become fmpq."""
    if type(a) is Fraction and _is_flint(b):
        return _fmpq(a), b
    if type(b) is Fraction and _is_flint(a):
        return a, _fmpq(b)
    return a, b


def _fmpq(a: Fraction) -> Any:
    from flint import fmpq

    return fmpq(a.numerator, a.denominator)


_without_fractions = np.frompyfunc(lambda a: _fmpq(a) if isinstance(a, Fraction) else a, 1, 1)


def _exact_quotient(a: Any, b: Any) -> Any:
    if isinstance(a, int) and isinstance(b, int):
        return Fraction(a, b)
    if type(a).__name__ == "fmpz" and (isinstance(b, int) or _is_flint(b)):
        from flint import fmpq

        return fmpq(a, 1) / b
    return a / b


def _ring_operation(operation: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    """Returns the operation for two scalars of a ring, or entry by entry for arrays."""

    def on_scalars(a: Any, b: Any) -> Any:
        return operation(*_in_one_ring(a, b))

    on_objects = np.frompyfunc(on_scalars, 2, 1)

    def on_any(a: Any, b: Any) -> Any:
        if not (isinstance(a, np.ndarray) or isinstance(b, np.ndarray)):
            return on_scalars(a, b)
        a, b = as_array(a), as_array(b)
        if a.dtype == object or b.dtype == object:
            return on_objects(a, b)
        return operation(a, b)

    return on_any


_add = _ring_operation(operator.add)
_mul = _ring_operation(operator.mul)
divide = _ring_operation(_exact_quotient)


def is_zero(a: Any) -> bool:
    """True if a (for an array: every entry of it) is zero."""
    if isinstance(a, np.ndarray):
        return all(is_zero(x) for x in a.flat) if a.dtype == object else not np.any(a)
    if type(a).__module__.startswith("pydrake.symbolic"):
        return bool((1 * a).Expand().EqualTo(0))  # 1 * makes an Expression of a Variable
    return bool(a == 0)


def _vanishes(a: Any) -> bool:
    """True if a (for an array: some entry of it) is zero."""
    if isinstance(a, np.ndarray):
        return any(is_zero(x) for x in a.flat) if a.dtype == object else not np.all(a)
    return is_zero(a)


EPSILON = Dual(0, 1)
