"""Differentiable functions of dual numbers: f(a + ε a₀) = f(a) + ε a₀ f′(a), Eq. (72).

Each function takes a dual or a real number over any scalar that has that function: floats, float arrays
(entry by entry), Drake ``Expression`` and ``AutoDiffXd``. Over exact scalars (int, Fraction, ``fmpq``,
``fmpq_mpoly``) only exact values are computed: sin 0, cos 0, exp 0, log 1, the root of a square (of a
polynomial: one of the two). All other values raise a `TypeError`; nothing is rounded.
"""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

from workbench.algebra.dual import Dual, Re, ZeroDivisor, _is_flint, _vanishes, divide


def extend(f: Callable[[Any], Any], fprime: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Returns the extension of a real function to dual numbers, Eq. (72).

    ``f`` and its derivative ``fprime`` take and return real scalars (or arrays, entry by entry). A real
    argument gives ``f`` itself.
    """

    def extended(a: Any) -> Any:
        if not isinstance(a, Dual):
            return f(a)
        return Dual(f(a.re), a.du * fprime(a.re))

    return extended


def _is_exact(a: Any) -> bool:
    return isinstance(a, int | Fraction) or _is_flint(a)


class NoExactValue(TypeError):
    """A function of exact scalars whose value is not exact, such as a square root."""


def _real_function(name: str, ufunc: np.ufunc, exact: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Returns a function that applies ``exact`` to exact scalars and ``ufunc`` to others.

    ``exact`` returns None if the value is not exact.
    """

    def on_scalar(a: Any) -> Any:
        if not _is_exact(a):
            return ufunc(a)
        value = exact(a)
        if value is None:
            raise NoExactValue(f"{name}({a}): no exact value; expected a float, got {type(a).__name__}")
        return value

    on_objects = np.frompyfunc(on_scalar, 1, 1)

    def on_any(a: Any) -> Any:
        if isinstance(a, np.ndarray):
            return on_objects(a) if a.dtype == object else ufunc(a)
        return on_scalar(a)

    on_any.__name__ = name
    return on_any


def _only_at(point: int, value: int) -> Callable[[Any], Any]:
    return lambda a: 0 * a + value if a == point else None


def _exact_root(a: Any) -> Any:
    """Returns the root of a square in the ring of a (for a rational the non-negative one); else None."""
    if isinstance(a, int | Fraction):
        if a < 0:
            return None
        n, d = Fraction(a).as_integer_ratio()
        root = Fraction(math.isqrt(n), math.isqrt(d))
        return type(a)(root) if root * root == a else None
    from flint import fmpq, fmpz
    from flint.utils.flint_exceptions import DomainError

    if isinstance(a, fmpz | fmpq):
        root = _exact_root(Fraction(int(a.numerator), int(a.denominator)))
        return None if root is None else fmpq(root.numerator, root.denominator)
    try:
        return a.sqrt()
    except DomainError:
        return None


_sin = _real_function("sin", np.sin, _only_at(0, 0))
_cos = _real_function("cos", np.cos, _only_at(0, 1))
_exp = _real_function("exp", np.exp, _only_at(0, 1))
_log = _real_function("log", np.log, _only_at(1, 0))
_sqrt = _real_function("sqrt", np.sqrt, _exact_root)

sin = extend(_sin, _cos)
cos = extend(_cos, lambda a: -_sin(a))
exp = extend(_exp, _exp)


def sqrt(a: Any) -> Any:
    """Returns the root of a dual number, √a + ε a₀ / (2 √a), entry by entry.

    Raises `ZeroDivisor` if Re(a) is zero (the function is not differentiable there), `ValueError` if it is a
    negative float, `TypeError` if it is exact and not a square.
    """
    _require_not_negative("sqrt", Re(a))
    root = _sqrt(Re(a))
    if not isinstance(a, Dual):
        return root
    if _vanishes(a.re):
        raise ZeroDivisor(f"sqrt({a!r}): expected a real part that is not zero")
    return Dual(root, divide(a.du, 2 * root))


def log(a: Any) -> Any:
    """Returns the natural logarithm of a dual number, entry by entry; errors as for `sqrt`."""
    if _vanishes(Re(a)):
        raise ZeroDivisor(f"log({a!r}): expected a real part that is not zero")
    _require_not_negative("log", Re(a))
    return Dual(_log(a.re), divide(a.du, a.re)) if isinstance(a, Dual) else _log(a)


def atan2(y: Any, x: Any) -> Any:
    """Returns the dual angle of the dual point (x, y): atan2(y, x) + ε (x y₀ − y x₀)/(x²+y²), entry by entry.

    Raises `ZeroDivisor` if both real parts are zero and an argument is dual. Over exact scalars only the
    angle 0 is exact.
    """
    if not (isinstance(y, Dual) or isinstance(x, Dual)):
        return _real_atan2(y, x)
    y, x = y + Dual(0), x + Dual(0)
    radius_squared = x.re * x.re + y.re * y.re
    if _vanishes(radius_squared):
        raise ZeroDivisor(f"atan2({y!r}, {x!r}): both real parts are zero")
    return Dual(_real_atan2(y.re, x.re), divide(x.re * y.du - y.re * x.du, radius_squared))


def _real_atan2(y: Any, x: Any) -> Any:
    if not (_is_exact(y) and _is_exact(x)):
        return np.arctan2(y, x)
    if y == 0 and not hasattr(x, "context") and x > 0:  # polynomials have a context and no sign
        return y
    raise NoExactValue(f"atan2({y}, {x}): no exact value; expected floats")


def _require_not_negative(name: str, a: Any) -> None:
    is_float = isinstance(a, float | np.floating) or (isinstance(a, np.ndarray) and a.dtype != object)
    if is_float and np.any(np.asarray(a) < 0):
        raise ValueError(f"{name}: expected a real part > 0, got {a}")
