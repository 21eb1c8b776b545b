"""Which of the two implementations computes: plain NumPy at once, or the compiled kernel.

Loading the kernel takes some tenths of a second (some seconds the first time on a machine, which
compiles it and keeps it on disk), so the first small tasks of a process are done in NumPy. Once
these add up to about what loading costs, or a task is large, the kernel is loaded. Both follow the
same recursion and differ by rounding only.
"""

from collections.abc import Callable
from functools import partial
from math import factorial, inf

import numpy as np
from numpy import empty, ndarray
from numpy.typing import ArrayLike

from workbench.kinematics import chain_series
from workbench.kinematics.chain_geometry import Links

DOUBLE = np.dtype(float)
HIGHEST_DERIVATIVE_ORDER = 170  # 170! is the last factorial that a double can hold

PLAIN_ORDER = 4  # tasks to this order
PLAIN_STATES = 32  # of at most so many states are done in NumPy
PLAIN_TASKS = 2000  # so often for one chain, unless the kernel is there already

_twist_kernel = None


def load_kernel() -> None:
    """Load the compiled kernel now, compiling it if this machine has not done so before."""
    global _twist_kernel
    if _twist_kernel is None:
        from workbench.kinematics.chain_kernel import twist_kernel

        _twist_kernel = twist_kernel


class Engine:
    """Evaluates the recursion of one chain, on joint derivatives or on Taylor coefficients."""

    def __init__(self, links: Links, *, taylor: bool):
        self.links = links
        self.taylor = taylor
        self._plain_tasks = 0
        self._plans: dict[tuple[int, int], tuple] = {}  # shape of a state → see _address_of_plan

    def twist(self, q: ArrayLike, out: np.ndarray | None = None) -> np.ndarray:
        """(n + 2, ..., dof) → (n + 1, ..., 6). Raises ValueError for what the chain cannot take."""
        if type(q) is ndarray and q.dtype is DOUBLE and q.shape in self._plans and out is None:
            numbers = q.ravel()
            if numbers.dot(numbers) < inf:
                return self.twist_of_finite(q)
        return self._twist(q, out)

    def twist_of_finite(self, q: np.ndarray) -> np.ndarray:
        """`twist` of doubles that are known to be finite."""
        if q.shape in self._plans:  # a state as before: only its numbers are new
            address, shape, _ = self._plans[q.shape]
            result = empty(shape)
            if _twist_kernel(q[:, None], address, result[:, None]):
                return result
        return self._twist(q, None)

    def _twist(self, q: ArrayLike, out: np.ndarray | None) -> np.ndarray:
        q = self._checked(q)
        out = self._checked_result(q, out)
        if _twist_kernel is None and self._is_small(q):
            out[...] = self._in_numpy(q)
            return out
        load_kernel()
        rows = _states_in_a_row(out)
        results = rows if np.may_share_memory(rows, out) else empty(rows.shape)
        if not _twist_kernel(_states_in_a_row(q), self._address_of_plan(q), results):
            out[...] = self._in_numpy(q)
        elif results is not rows:
            out[...] = results.reshape(out.shape)
        return out

    def bind(self, q: np.ndarray, out: np.ndarray) -> Callable[[], bool]:
        """A call that computes `out` from what is then in `q`, with no checks and no new memory."""
        if type(q) is not np.ndarray or q.dtype != np.float64:
            raise ValueError("q: expected an array of doubles")
        arrays = self._checked(q), self._checked_result(q, out)
        rows = [_states_in_a_row(array) for array in arrays]
        if q.size and not all(np.may_share_memory(*pair) for pair in zip(arrays, rows, strict=True)):
            raise ValueError("q and out: expected arrays whose axes of states are one in memory")
        load_kernel()
        call = partial(_twist_kernel, rows[0], self._address_of_plan(q), rows[1])
        call.plan = self._plans[q.shape[0], q.shape[-1]]  # what the address points to must live as long
        return call

    def _address_of_plan(self, q):
        """Of the plan for one state of q; kept by the shape of a state, (n + 2, dof)."""
        shape = len(q), q.shape[-1]
        if shape not in self._plans:
            plan = self._plan(len(q) - 1)
            self._plans[shape] = plan.ctypes.data, (len(q) - 1, 6), plan
        return self._plans[shape][0]

    @staticmethod
    def _checked_result(q, out):
        shape = (len(q) - 1, *q.shape[1:-1], 6)
        if out is None:
            if q.ndim > 2 and q.strides[-2] == q.itemsize:  # side by side in memory, as those of q
                return np.moveaxis(empty((shape[0], 6, *shape[1:-1])), 1, -1)
            return empty(shape)
        if out.shape != shape or out.dtype != np.float64 or not out.flags.writeable:
            raise ValueError(
                f"out: expected a writable array of doubles of shape {shape}, "
                f"got {out.dtype} of shape {out.shape}"
            )
        return out

    def _checked(self, q):
        q = np.asarray(q)
        if q.dtype != np.float64:
            if q.dtype.kind not in "fiu":
                raise ValueError(f"expected real joint derivatives, got an array of {q.dtype}")
            q = q.astype(float)
        dof = self.links.dof
        if q.ndim < 2 or q.shape[-1] != dof or q.shape[0] < 2:
            raise ValueError(
                f"expected joint derivatives of shape (n + 2, ..., {dof}) with n ≥ 0, the order first "
                f"(coordinates, velocities, …) and the {dof} coordinates last, got {q.shape}"
            )
        order = q.shape[0] - 2
        if order > HIGHEST_DERIVATIVE_ORDER and not self.taylor:
            raise ValueError(
                f"expected derivatives to order at most {HIGHEST_DERIVATIVE_ORDER}, got {order}; "
                "use twist_taylor for Taylor coefficients of higher order"
            )
        if not np.isfinite(q).all():
            raise ValueError("expected finite joint derivatives, got a NaN or an infinity")
        return q

    def _in_numpy(self, q):
        terms = len(q) - 1
        rate_factors, twist_factors = (factors[:, None] for factors in self._factors(terms))
        states_last = np.moveaxis(_states_in_a_row(q), 1, -1).copy()
        states_last[1:] *= (rate_factors / np.arange(1, terms + 1)[:, None])[..., None]
        series = chain_series.twist(self.links, states_last)
        return (series * twist_factors[..., None]).swapaxes(1, 2).reshape(terms, *q.shape[1:-1], 6)

    def _plan(self, terms):
        """Everything constant in the kernel's work, as one array. In order: joints, how many blocks of
        states take turns, the base's turn (cos, sin); the factors of the n + 2 derivatives of each
        coordinate; those of the twist; 0, 1, 1/2, 1/3, …; then for each joint its angle, slide, pitch,
        twist angle (cos, sin), shift, the offset along the axis before, its turn (cos, sin); the
        kernel's workspace."""
        from workbench.kinematics.chain_kernel import workspace

        links = self.links
        together, size = workspace(links.dof, len(links.angle), terms)
        rate_factors, twist_factors = self._factors(terms)
        input_factors = np.tile([1.0, *rate_factors], links.dof)
        joints = np.column_stack(
            [
                links.angle,
                links.slide,
                links.pitch,
                links.twist_angle,
                links.shift,
                links.offset[:-1],
                links.turn[1:],
            ]
        )
        return np.concatenate(
            [
                [len(joints), together, *links.turn[0]],
                input_factors,
                twist_factors,
                [0.0],
                1 / np.arange(1.0, terms),
                joints.ravel(),
                np.zeros(size),
            ]
        )

    def _factors(self, terms):
        """From q^{(k+1)} or q_{k+1} to the k-th Taylor coefficient of the rate q', and from the
        k-th Taylor coefficient of the twist to the result."""
        if self.taylor:
            return np.arange(1.0, terms + 1), np.ones(terms)
        factorials = np.array([float(factorial(k)) for k in range(terms)])
        return 1 / factorials, factorials

    def _is_small(self, q):
        states = q[0].size // q.shape[-1]
        if len(q) - 2 > PLAIN_ORDER or states > PLAIN_STATES or self._plain_tasks == PLAIN_TASKS:
            return False
        self._plain_tasks += 1
        return True


def _states_in_a_row(array: np.ndarray) -> np.ndarray:
    """(orders, ..., parts) as (orders, states, parts), a view where the axes of states are one in memory."""
    return array.reshape(len(array), -1, array.shape[-1])
