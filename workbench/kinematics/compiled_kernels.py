"""Compiled kernels, cached on disk: (q, address of a plan, out, exactly) → whether `out` is valid."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numba import njit

Kernel = Callable[[np.ndarray, int, np.ndarray, bool], bool]
BoundKernel = Callable[[int], bool]
OF_BOUND = "boolean(int64)"  # its call passes no arrays, which saves 0.15 µs
OF_KERNEL = "boolean(float64[:,:,:], int64, float64[:,:,:,:], boolean)"


def compiled_kernel(
    function: Callable[..., bool],
    parts: Sequence[ModuleType],
    options: Mapping[str, Any],
    of: str = OF_KERNEL,
) -> Callable[..., bool]:
    """Returns the function compiled with the Numba signature `of`, cached on disk if possible.

    Numba does not notice changes of the functions that it calls, the `parts`; a cache that is older than
    their files is therefore removed first.

    The function is called without Numba's check of the argument types, which takes 0.1 µs. Only arguments of
    the signature may be passed: arrays of native doubles with that many axes. The workspace is the end of the
    plan; two calls cannot meet there, because Python's global lock is held throughout.
    """
    try:
        kernel = njit(cache=True, **options)(function)
        changed = max(Path(part.__file__).stat().st_mtime for part in parts if part.__file__)
        name = f"{function.__module__.rpartition('.')[2]}.{function.__name__}"
        for index in Path(kernel.stats.cache_path).glob(f"{name}*.nbi"):
            if index.stat().st_mtime < changed:
                index.unlink(missing_ok=True)
    except (RuntimeError, OSError):
        kernel = njit(**options)(function)
    kernel.compile(of)
    kernel.disable_compile()
    (overload,) = kernel.overloads.values()
    return overload.entry_point
