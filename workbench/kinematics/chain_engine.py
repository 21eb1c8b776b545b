"""Which of the two implementations computes: plain NumPy at once, or the compiled kernel.

Loading the kernel takes some tenths of a second (some seconds the first time on a machine, which
compiles it and keeps it on disk), so the first small tasks of a process are done in NumPy. Once
these add up to about what loading costs, or a task is large, the kernel is loaded. Both follow the
same recursion and differ by rounding only.
"""

from math import factorial

import numpy as np

from workbench.kinematics import chain_series
from workbench.kinematics.chain_geometry import Links

PLAIN_ORDER = 4  # tasks to this order
PLAIN_STATES = 32  # of at most so many states are done in NumPy
PLAIN_TASKS = 2000  # so often in a process, unless the kernel is there already

_plain_tasks_left = PLAIN_TASKS
_kernel = None


def load_kernel() -> None:
    """Load the compiled kernel now, compiling it if this machine has not done so before."""
    global _kernel
    if _kernel is None:
        from workbench.kinematics import chain_kernel

        _kernel = chain_kernel


class Engine:
    """Evaluates the recursion of one chain, on joint derivatives or on Taylor coefficients."""

    def __init__(self, links: Links, *, taylor: bool):
        self.links = links
        self.taylor = taylor
        self._plans: dict[int, np.ndarray] = {}

    def twist(self, q: np.ndarray) -> np.ndarray:
        """(..., dof, n + 2) doubles → (..., n + 1, 6)."""
        if _kernel is None:
            if self._is_small(q):
                return self._in_numpy(q)
            load_kernel()
        terms = q.shape[-1] - 1
        plan = self._plans.get(terms)
        if plan is None:
            plan = self._plans[terms] = _kernel.plan_of(self.links, terms, *self._factors(terms))
        if q.ndim == 2:
            out = np.empty((terms, 6))
            within_range = self._run(q, plan, out)
        else:
            out = np.empty((*q.shape[:-2], terms, 6))
            within_range = self._run(q.reshape(-1, terms + 1), plan, out.reshape(-1, 6))
        return out if within_range else self._in_numpy(q)

    @staticmethod
    def _run(q, plan, out):
        try:
            return _kernel.twist_kernel(q, plan, out)
        except TypeError:  # the kernel takes contiguous, writable arrays only
            return _kernel.twist_kernel(np.array(q, order="C"), plan, out)

    def _in_numpy(self, q):
        terms = q.shape[-1] - 1
        rate_factors, twist_factors = self._factors(terms)
        series = q.copy()
        series[..., 1:] *= rate_factors / np.arange(1, terms + 1)
        return chain_series.twist(self.links, series) * twist_factors[:, None]

    def _factors(self, terms):
        """From q^{(k+1)} or q_{k+1} to the k-th Taylor coefficient of the rate q', and from the
        k-th Taylor coefficient of the twist to the result."""
        if self.taylor:
            return np.arange(1.0, terms + 1), np.ones(terms)
        factorials = np.array([float(factorial(k)) for k in range(terms)])
        return 1 / factorials, factorials

    def _is_small(self, q):
        global _plain_tasks_left
        states = q.size // (q.shape[-2] * q.shape[-1])
        if q.shape[-1] - 2 > PLAIN_ORDER or states > PLAIN_STATES or _plain_tasks_left == 0:
            return False
        _plain_tasks_left -= 1
        return True
