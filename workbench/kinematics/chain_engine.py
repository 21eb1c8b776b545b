"""Which of the two implementations computes: plain NumPy at once, or the compiled kernel.

Loading the kernel takes some tenths of a second (some seconds on the first run on a machine, which
compiles it and keeps it on disk), so the first small tasks of a process are done in NumPy. Once
these add up to about what loading costs, or a task is large, the kernel is loaded. Both follow the
same recursion and differ by rounding only.
"""

from functools import lru_cache
from math import factorial

import numpy as np

from workbench.kinematics import chain_series
from workbench.kinematics.chain_geometry import Links

PLAIN_ORDER = 4  # tasks to this order
PLAIN_STATES = 32  # of at most so many states may be done in NumPy
PLAIN_TASKS = 2000  # so often

_plain_tasks_left = PLAIN_TASKS
_kernel = None


def load_kernel():
    """Load the compiled kernel now, compiling it if this machine has not done so before."""
    global _kernel
    if _kernel is None:
        from workbench.kinematics import chain_kernel

        _kernel = chain_kernel
    return _kernel


class Engine:
    """Evaluates the recursion of one chain."""

    def __init__(self, links: Links):
        self.links = links
        self._packed = None

    def twist(self, q: np.ndarray, scales: np.ndarray) -> np.ndarray:
        """(..., dof, n + 2) → (..., n + 1, 6), scaled as by `scales_of_…`."""
        terms = q.shape[-1] - 1
        states = q.shape[:-2]
        if _kernel is None and self._is_small(q):
            return self._in_numpy(q, scales)
        if self._packed is None:
            self._packed = load_kernel().pack_links(self.links)
        q = np.require(q, dtype=float, requirements=["C", "W"]).reshape(-1, terms + 1)
        out = np.empty((*states, terms, 6))
        _kernel.twist_kernel(q, self._packed, scales, out.reshape(-1, 6))
        return out

    def _in_numpy(self, q, scales):
        terms = q.shape[-1] - 1
        rates, results = scales[:terms], scales[terms : 2 * terms]
        series = q.copy()
        series[..., 1:] *= rates / np.arange(1, terms + 1)
        return chain_series.twist(self.links, series) * results[:, None]

    def _is_small(self, q):
        global _plain_tasks_left
        terms = q.shape[-1] - 1
        states = q.size // (self.links.dof * (terms + 1))
        if terms - 1 > PLAIN_ORDER or states > PLAIN_STATES or _plain_tasks_left == 0:
            return False
        _plain_tasks_left -= 1
        return True


@lru_cache(maxsize=256)
def scales_of_derivatives(terms: int) -> np.ndarray:
    """Factors of q^{(k+1)} on the way in, of V^{(k)} on the way out, and the reciprocals of k."""
    factorials = np.array([float(factorial(k)) for k in range(terms)])
    return np.concatenate([1 / factorials, factorials, _reciprocals(terms)])


@lru_cache(maxsize=256)
def scales_of_taylor(terms: int) -> np.ndarray:
    """The same for Taylor coefficients: the rate of q_k t^k is k q_k t^{k-1}."""
    return np.concatenate([np.arange(1.0, terms + 1), np.ones(terms), _reciprocals(terms)])


def _reciprocals(terms: int) -> np.ndarray:
    return np.concatenate([[0.0], 1 / np.arange(1, terms)])
