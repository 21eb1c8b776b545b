"""Steps that look at whole chains: (119), (132) and (133) written out, for up to five bodies and order 8."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from typing import Any

from tests.proofs.chain_poses import drake_residuals, rational_residuals
from tests.proofs.chain_words import (
    Coefficient,
    closed_form,
    derivatives_of_twist,
    multinomial,
    printed_multinomial,
    products_of_Phi,
    total_Phi,
)
from workbench.judge.theorems.arguments import Engine, Step, Way, vanishing, vanishing_to

MOST_BODIES, HIGHEST_ORDER = 5, 8
DRAKE_TOLERANCE = 1e-10  # of the largest entry; the references' own errors are below 1e-13 of it


def expanded_tensors() -> Step:
    """(132) beside (130) applied k times; the coefficients on poses are those that (133) has from it."""
    return Step(
        f"(132) expanded: up to {MOST_BODIES - 1} twists and order {HIGHEST_ORDER}",
        Way(Engine.WORDS, partial(_same_Phi, multinomial), partial(_same_Phi, printed_multinomial)),
        _on_poses(range(HIGHEST_ORDER + 1)),
        by_example=True,
    )


def expanded_twists() -> Step:
    """(133) beside the twist differentiated n times, of every chain up to these sizes."""
    orders = range(HIGHEST_ORDER + 1)
    return Step(
        f"(133) expanded: up to {MOST_BODIES} bodies and order {HIGHEST_ORDER}",
        Way(Engine.WORDS, partial(_same_twists, multinomial), partial(_same_twists, printed_multinomial)),
        _on_poses(orders),
        Way(
            Engine.DRAKE,
            vanishing_to(DRAKE_TOLERANCE, partial(drake_residuals, range(5), multinomial)),
            vanishing_to(DRAKE_TOLERANCE, partial(drake_residuals, range(5), printed_multinomial)),
        ),
        by_example=True,
    )


def twists_of_chains() -> Step:
    """(119) on whole chains; the controls do not turn Ω̲ₖ to C₀."""
    return Step(
        "₀ω̲ₘ = Σ R̲ₖ₋₁ Ω̲ₖ on poses of five bodies and on Drake's chain",
        Way(
            Engine.FRACTIONS,
            vanishing(partial(rational_residuals, MOST_BODIES, (0,), multinomial)),
            vanishing(partial(rational_residuals, MOST_BODIES, (0,), multinomial, turned=False)),
        ),
        Way(
            Engine.DRAKE,
            vanishing_to(DRAKE_TOLERANCE, partial(drake_residuals, (0,), multinomial)),
            vanishing_to(DRAKE_TOLERANCE, partial(drake_residuals, (0,), multinomial, turned=False)),
        ),
        by_example=True,
    )


def _on_poses(orders: Iterable[int]) -> Way:
    def residuals(coefficient: Coefficient) -> Iterator[Any]:
        for bodies in range(1, MOST_BODIES + 1):
            yield from rational_residuals(bodies, orders, coefficient)

    return Way(
        Engine.FRACTIONS,
        vanishing(partial(residuals, multinomial)),
        vanishing(partial(residuals, printed_multinomial)),
    )


def _same_twists(coefficient: Coefficient) -> Iterator[bool]:
    for body in range(1, MOST_BODIES + 1):
        for n, derivative in enumerate(derivatives_of_twist(body, HIGHEST_ORDER)):
            yield derivative == closed_form(body, n, coefficient)


def _same_Phi(coefficient: Coefficient) -> Iterator[bool]:
    """(132) for the n that (133) goes on to put it in: any n from k on, here k + 1."""
    for bodies in range(1, MOST_BODIES):
        for k in range(HIGHEST_ORDER + 1):
            yield total_Phi(bodies, k) == products_of_Phi(bodies, k, coefficient, k + 1)
