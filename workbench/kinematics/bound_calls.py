"""Calls of compiled code that are bound to the arrays which they read and write."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from workbench.kinematics.compiled_kernels import BoundKernel


class BoundCall(partial[Any]):
    """A call without arguments. It keeps alive what the compiled code has the addresses of: the plan, q
    (orders, states, coordinates) and out (frames, states, orders, parts), whose memory must not move."""

    kept: tuple[object, ...]

    def __new__(cls, kernel: BoundKernel, plan: Any, q: np.ndarray, out: np.ndarray) -> BoundCall:
        """kernel: see `BoundKernel`; plan: a `Plan`."""
        of_q, of_out = [q.ctypes.data, *q.shape, *q.strides], [out.ctypes.data, *out.shape, *out.strides]
        arguments = np.array([*of_q, plan.address, *of_out], dtype=float)  # an address has less than 53 bits
        call = super().__new__(cls, kernel, arguments.ctypes.data)
        call.kept = plan, q, out, arguments
        return call
