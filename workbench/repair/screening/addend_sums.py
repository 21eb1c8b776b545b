"""Meet-in-the-middle search for one alternative of each addend such that all add up to zero."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from workbench.engines.jet.rings import PRIME

#: The most sums of one half.
MOST_SUMS = 3_000_000


def zero_sums(values: Sequence[Sequence[int]]) -> Iterator[tuple[int, ...]] | None:
    """Returns the choices, as indices in the lists, whose values add up to 0 modulo the prime.

    Returns None if there are too many sums.
    """
    left, right = values[::2], values[1::2]
    if any(_count(half) > MOST_SUMS for half in (left, right)):
        return None
    return _matching(left, right)


def _count(lists: Sequence[Sequence[int]]) -> int:
    count = 1
    for values in lists:
        count *= len(values)
    return count


def _matching(left: Sequence[Sequence[int]], right: Sequence[Sequence[int]]) -> Iterator[tuple[int, ...]]:
    sums, wanted = _all_sums(left), (PRIME - _all_sums(right)) % PRIME
    order = np.argsort(sums, kind="stable")
    ordered = sums[order]
    start = np.searchsorted(ordered, wanted, side="left")
    end = np.searchsorted(ordered, wanted, side="right")
    for number in np.flatnonzero(end > start):
        second = _places(int(number), right)
        for match in order[start[number] : end[number]]:
            first = _places(int(match), left)
            yield tuple(
                (first if index % 2 == 0 else second)[index // 2] for index in range(len(left) + len(right))
            )


def _all_sums(lists: Sequence[Sequence[int]]) -> np.ndarray:
    """Returns all sums of one value of each list; the last list varies fastest. The sums stay below 2^62."""
    sums = np.zeros(1, dtype=np.int64)
    for values in lists:
        sums = ((sums[:, None] + np.array(values, dtype=np.int64)[None, :]) % PRIME).ravel()
    return sums


def _places(number: int, lists: Sequence[Sequence[int]]) -> list[int]:
    places = []
    for values in reversed(lists):
        number, place = divmod(number, len(values))
        places.append(place)
    return places[::-1]
