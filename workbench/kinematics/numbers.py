"""Conversion of the arguments of functions of lines, screws and reduced accelerations.

Lists become arrays. Exact and symbolic scalars are kept. A float that is not finite is rejected, as by
`workbench.kinematics.tensors.as_vectors`. Integers and fractions are exact scalars; if the result needs a
root or an angle, which the rational numbers do not have, they become floats.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from numbers import Real
from typing import Any, ParamSpec, TypeVar

import numpy as np

from workbench.algebra.dual import Dual, as_array
from workbench.algebra.dual_functions import NoExactValue

P = ParamSpec("P")
T = TypeVar("T")


def takes_numbers(function: Callable[P, T]) -> Callable[P, T]:
    """Returns the function on arrays of finite numbers, made of its positional arguments. Raises
    ValueError."""

    @wraps(function)
    def on_arrays(*arguments: Any, **options: Any) -> Any:
        return function(*(_arrays(argument, function.__name__) for argument in arguments), **options)

    return on_arrays


def takes_reals(function: Callable[P, T]) -> Callable[P, T]:
    """As `takes_numbers`; integers and fractions that have no exact result are taken for floats."""

    @wraps(function)
    def on_reals(*arguments: Any, **options: Any) -> Any:
        exact = [_arrays(argument, function.__name__) for argument in arguments]
        try:
            return function(*exact, **options)
        except (TypeError, AttributeError) as error:
            # NumPy asks objects for methods of the names of its functions: an AttributeError
            has_no_value = isinstance(error, NoExactValue | AttributeError)
            if not _are_all(Real if has_no_value else int | np.integer, exact):
                raise
            return function(*map(_floats, exact), **options)

    return on_reals


def _arrays(argument: Any, name: str) -> Any:
    if isinstance(argument, Dual):
        return Dual(*(_finite(as_array(part), name) for part in (argument.re, argument.du)))
    if isinstance(argument, np.ndarray | list | tuple):
        return _finite(as_array(argument), name)
    return argument


def _finite(entries: np.ndarray, name: str) -> np.ndarray:
    if entries.dtype.kind == "f" and not np.isfinite(entries).all():
        raise ValueError(f"{name}: expected finite numbers, got a NaN or an infinity")
    return entries


def _are_all(kind: Any, arguments: list[Any]) -> bool:
    parts = [part for x in arguments for part in ((x.re, x.du) if isinstance(x, Dual) else (x,))]
    return all(isinstance(entry, kind) for part in parts for entry in np.asarray(part).flat)


def _floats(argument: Any) -> Any:
    if isinstance(argument, Dual):
        return Dual(*(np.asarray(part).astype(float) for part in (argument.re, argument.du)))
    return argument.astype(float) if isinstance(argument, np.ndarray) else argument
