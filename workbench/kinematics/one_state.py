"""Whether a table (rows, coordinates) holds one state's derivatives, one row an order, or one row a state.

Its shape does not tell. A caller who says the order is taken at his word; else what is doubtful is warned of.
"""

from __future__ import annotations

import warnings

import numpy as np

USUAL_ROWS = 5  # coordinates to snap
NEAR = 0.25  # of the largest value of a coordinate: rows that differ less are neighbours on a path


def require_order(
    q: np.ndarray, order: int | None, others: str, most: int | None = None, extra: int = 1, calls: int = 1
) -> None:
    """Warns, or raises ValueError, unless q (rows, ..., coordinates) are derivatives: order + extra rows.

    others: how a table of states is given. most: rows of one state that are taken without `order`.
    calls: from the user's to this one, for the place of the warning."""
    if order is not None:
        if type(order) is not int or len(q) != order + extra:
            raise ValueError(
                f"order: expected {len(q) - extra} for the shape {q.shape}, whose first axis is the order, "
                f"got {order!r}; a table of states is given as {others}"
            )
        return
    if q.ndim != 2:
        return
    read = f"{len(q)} rows, taken for one state with derivatives to the order {len(q) - 1}"
    if most is not None and len(q) > most:
        raise ValueError(
            f"q_derivatives: expected at most {most} rows, one an order of one state, got {len(q)}: "
            f"a table of states is given as {others}; for one state say order={len(q) - extra}"
        )
    if len(q) > USUAL_ROWS or (q.dtype != object and _neighbours(q)):
        warnings.warn(
            f"q_derivatives: {read}; if it is, say order={len(q) - extra}; "
            f"a table of states is given as {others}",
            stacklevel=2 + calls,
        )


def _neighbours(q: np.ndarray) -> bool:
    """True if each row is near the one before, as on a path through states."""
    steps = np.abs(np.diff(q, axis=0))
    return bool(steps.any() and (steps <= NEAR * np.abs(q).max(axis=0)).all())
