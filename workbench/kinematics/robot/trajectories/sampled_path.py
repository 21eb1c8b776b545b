"""The base class of paths whose derivatives are evaluated, and not summed from known terms."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from workbench.drake.joint_paths import Path

SCALE_SAMPLES = 257  # at which a path is looked at for the size of its derivatives


class SampledPath(Path):
    """A path whose terms are not known: the size of a derivative's terms is its largest value on the path."""

    def magnitudes(self, t: ArrayLike, order: int) -> np.ndarray:
        sizes = self._sizes(order).reshape(order + 1, *[1] * np.ndim(t), self.joints)
        return np.broadcast_to(sizes, (order + 1, *np.shape(t), self.joints))

    def _sizes(self, order: int) -> np.ndarray:
        if order not in self._size_of_order:
            times = np.linspace(self.start, self.end, SCALE_SAMPLES)
            self._size_of_order[order] = np.abs(self.derivatives(times, order)).max(axis=1)
        return self._size_of_order[order]

    @cached_property
    def _size_of_order(self) -> dict[int, np.ndarray]:
        return {}

    def _inside(self, t: ArrayLike) -> np.ndarray:
        t = np.asarray(t, dtype=float)
        slack = 1e-9 * (self.end - self.start) + 4e-16 * max(abs(self.start), abs(self.end))
        if not np.all((t >= self.start - slack) & (t <= self.end + slack)):
            raise ValueError(
                f"times: expected times from {self.start:.10g} to {self.end:.10g} s, "
                f"got {t.min()} to {t.max()}"
            )
        return np.clip(t, self.start, self.end)
