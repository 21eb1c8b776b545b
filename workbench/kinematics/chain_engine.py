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
            if _twist_kernel(q.T.copy(), address, result):
                return result
        return self._twist(q, None)

    def _twist(self, q: ArrayLike, out: np.ndarray | None) -> np.ndarray:
        rows = _by_state(self._checked(q))
        out = self._checked_result(rows, out)
        results = np.moveaxis(out, 0, -2)
        if _twist_kernel is None and self._is_small(rows):
            results[...] = self._in_numpy(rows)
            return out
        load_kernel()
        rows = np.require(rows, requirements=("C", "W"))
        in_place = results if results.flags.carray else np.empty(results.shape)
        address = self._address_of_plan(rows.shape[-2:])
        if not _twist_kernel(rows.reshape(-1, rows.shape[-1]), address, in_place.reshape(-1, 6)):
            in_place = self._in_numpy(rows)
        if in_place is not results:
            results[...] = in_place
        return out

    def bind(self, q: np.ndarray, out: np.ndarray) -> Callable[[], bool]:
        """A call that computes `out` from what is then in `q`, with no checks and no new memory."""
        if type(q) is not np.ndarray or q.dtype != np.float64:
            raise ValueError("q: expected an array of doubles")
        rows = _by_state(self._checked(q))
        results = np.moveaxis(self._checked_result(rows, out), 0, -2)
        if not (rows.flags.carray and results.flags.carray):
            raise ValueError("q and out: expected arrays in the memory layout of SerialChain.workspace")
        load_kernel()
        address = self._address_of_plan(rows.shape[-2:])
        call = partial(_twist_kernel, rows.reshape(-1, rows.shape[-1]), address, results.reshape(-1, 6))
        call.plan = self._plans[rows.shape[:-3:-1]]  # what the address points to must live as long
        return call

    def _address_of_plan(self, shape):
        """Of the plan for one state's rows (dof, n + 2); kept by the shape users give, (n + 2, dof)."""
        dof, terms = shape[0], shape[1] - 1
        if (terms + 1, dof) not in self._plans:
            plan = self._plan(terms)
            self._plans[terms + 1, dof] = plan.ctypes.data, (terms, 6), plan
        return self._plans[terms + 1, dof][0]

    @staticmethod
    def _checked_result(rows, out):
        *states, _dof, terms_and_one = rows.shape
        if out is None:
            return np.moveaxis(empty((*states, terms_and_one - 1, 6)), -2, 0)
        shape = (terms_and_one - 1, *states, 6)
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
        terms = q.shape[-1] - 1
        rate_factors, twist_factors = self._factors(terms)
        series = q.copy()
        series[..., 1:] *= rate_factors / np.arange(1, terms + 1)
        return chain_series.twist(self.links, series) * twist_factors[:, None]

    def _plan(self, terms):
        """Everything constant in the kernel's work, as one array. In order: joints, dof, terms, the
        base's turn (cos, sin); the factors of the n + 2 derivatives of each coordinate (at least
        as many numbers as the kernel is wide); those of the twist; 0, 1, 1/2, 1/3, …; then for each
        joint its angle, slide, pitch, twist angle (cos, sin), shift, the offset along the axis
        before, its turn (cos, sin); the kernel's workspace."""
        from workbench.kinematics.chain_kernel import WIDTH, workspace_size

        links = self.links
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
                [len(joints), links.dof, terms, *links.turn[0]],
                np.pad(input_factors, (0, max(0, WIDTH - len(input_factors)))),
                twist_factors,
                [0.0],
                1 / np.arange(1.0, terms),
                joints.ravel(),
                np.zeros(workspace_size(links.dof, len(joints), terms)),
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
        states = q.size // (q.shape[-2] * q.shape[-1])
        if q.shape[-1] - 2 > PLAIN_ORDER or states > PLAIN_STATES or self._plain_tasks == PLAIN_TASKS:
            return False
        self._plain_tasks += 1
        return True


def _by_state(q: np.ndarray) -> np.ndarray:
    """The kernel's layout (..., dof, n + 2) of (n + 2, ..., dof): a view."""
    return np.moveaxis(q, 0, -1)
