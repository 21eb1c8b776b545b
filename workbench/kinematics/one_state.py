"""Decides whether a table (rows, coordinates) holds the derivatives of one state or several states.

The shape does not decide it. If the caller gives the order, the order decides. Otherwise the table is read as
one state, with one row per order, and a warning says so.
"""

from __future__ import annotations

import warnings

import numpy as np


def require_order(
    q: np.ndarray, order: int | None, others: str, most: int | None = None, extra: int = 1, calls: int = 1
) -> None:
    """Raises ValueError unless q (rows, ..., coordinates) has order + extra rows; without `order` it warns of
    a table of two axes.

    others: how a table of states is given. most: rows of one state that are taken without `order`. calls:
    from the user's to this one, for the place of the warning."""
    given = f"; a table of states is given as {others}"
    if order is not None:
        if type(order) is not int or len(q) != order + extra:
            raise ValueError(
                f"order: expected {len(q) - extra} for the shape {q.shape}, whose first axis is the order, "
                f"got {order!r}{given}"
            )
        return
    if q.ndim != 2:
        return
    if most is not None and len(q) > most:
        raise ValueError(
            f"q_derivatives: expected at most {most} rows, one an order of one state, got {len(q)}{given}; "
            f"for one state say order={len(q) - extra}"
        )
    warnings.warn(
        f"q_derivatives: {len(q)} rows, taken for one state with derivatives to the order {len(q) - 1}; "
        f"if it is, say order={len(q) - extra}{given}",
        stacklevel=2 + calls,
    )
