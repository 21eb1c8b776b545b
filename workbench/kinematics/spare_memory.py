"""Memory of large arrays that is used again when no array holds it any more.

The system clears each new page, which takes longer than the kernel takes to fill it.
"""

from __future__ import annotations

from sys import getrefcount
from threading import Lock

import numpy as np

#: Arrays of at least LEAST doubles are kept, MOST doubles in total.
LEAST, MOST = 500_000, 32_000_000
_kept: list[np.ndarray] = []
_lock = Lock()
_FREE = 2  # references to memory that no array holds: the list's, and the argument's


def spare_memory(size: int) -> np.ndarray:
    """Returns an array of doubles (size,) with any content, in memory of its own."""
    if not LEAST <= size <= MOST:
        return np.empty(size)
    with _lock:
        for at in range(len(_kept)):
            if size <= _kept[at].size <= 2 * size and getrefcount(_kept[at]) == _FREE:
                _kept.append(_kept.pop(at))
                return _kept[-1][:size]
        while _kept and sum(memory.size for memory in _kept) + size > MOST:
            _kept.pop(0)
        _kept.append(np.empty(size))
        return _kept[-1][:]
