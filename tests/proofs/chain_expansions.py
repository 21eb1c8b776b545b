"""Whole chains: (119), (132) and (133) written out, for up to five bodies and order 8, by words, on poses in whole
numbers and on Drake's chains. Each yields for every single thing that it looks at whether it is so."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from tests.proofs.chain_poses import drake_residuals, rational_residuals
from tests.proofs.chain_words import (
    Coefficient,
    closed_form,
    derivatives_of_twist,
    multinomial,
    products_of_Phi,
    total_Phi,
)

MOST_BODIES, HIGHEST_ORDER = 5, 8
ORDERS = range(HIGHEST_ORDER + 1)
DRAKE_TOLERANCE = 1e-10  # of the largest entry; the references' own errors are below 1e-13 of it


def tensors_in_words(coefficient: Coefficient) -> Iterator[bool]:
    """(132) beside (130) applied k times, for the n that (133) goes on to put it in: any n from k on, here k + 1."""
    for bodies in range(1, MOST_BODIES):
        for k in ORDERS:
            yield total_Phi(bodies, k) == products_of_Phi(bodies, k, coefficient, k + 1)


def twists_in_words(coefficient: Coefficient) -> Iterator[bool]:
    """(133) beside the twist differentiated n times, of every chain up to these sizes."""
    for body in range(1, MOST_BODIES + 1):
        for n, derivative in enumerate(derivatives_of_twist(body, HIGHEST_ORDER)):
            yield derivative == closed_form(body, n, coefficient)


def twists_on_poses(coefficient: Coefficient) -> Iterator[bool]:
    """(133), whose coefficients are those of (132), on poses of every chain up to these sizes."""
    for bodies in range(1, MOST_BODIES + 1):
        yield from _vanish(rational_residuals(bodies, ORDERS, coefficient))


def twists_in_drake(coefficient: Coefficient) -> Iterator[bool]:
    """(133) of two bodies on Drake's chains."""
    yield from _vanish(drake_residuals(range(5), coefficient), DRAKE_TOLERANCE)


def relative_twists_on_poses(turned: bool) -> Iterator[bool]:
    """(119) on whole chains; not `turned`: without Ω̲ₖ turned to C₀."""
    yield from _vanish(rational_residuals(MOST_BODIES, (0,), multinomial, turned=turned))


def relative_twists_in_drake(turned: bool) -> Iterator[bool]:
    yield from _vanish(drake_residuals((0,), multinomial, turned=turned), DRAKE_TOLERANCE)


def _vanish(residuals: Iterable[np.ndarray], tolerance: float = 0) -> Iterator[bool]:
    for residual in residuals:
        yield bool((np.abs(residual) <= tolerance).all())
