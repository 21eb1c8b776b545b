"""Suggestions for a misspelled name: the known names that are close to it."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

#: The most names that are suggested.
_MOST = 3


def close_names(name: str, known: Iterable[str]) -> list[str]:
    """Returns the known names that are close to `name` or contain it, ignoring case, the closest first."""
    wanted = name.casefold()
    by_folded = {each.casefold(): each for each in known}
    found = get_close_matches(wanted, by_folded, n=_MOST, cutoff=0.6)
    inside = [each for each in by_folded if len(wanted) > 2 and wanted in each and each not in found]
    return [by_folded[each] for each in [*found, *inside][:_MOST]]


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Returns the question "Did you mean …?", or "" if no known name is close."""
    close = close_names(name, known)
    if not close:
        return ""
    return f"Did you mean {' or '.join([', '.join(close[:-1]), close[-1]] if close[1:] else close)}?"
