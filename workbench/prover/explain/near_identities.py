"""Equations that are meant as identities: solved for a symbol, most of their symbols would cancel."""

from __future__ import annotations

from contextlib import suppress

from workbench.algebra.differential_ring import Polynomial
from workbench.context.claims import Claim
from workbench.core.terms import IllFormed, Relation, Symbol, sides_of
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.prover.decide.zero_sets import factors_of

#: An identity has at least this many parameters that the value of the symbol would not depend on.
_FEWEST = 3


def is_near_identity(claim: Claim, own: Symbol) -> bool:
    """True if an equation, as one that says what a symbol is, would give it by less than half of its symbols.

    (M ẋ² + m ẋ² + m l² θ̇²) / 2 = (ẋ² + m l² θ̇²) / 2 is no way to say that M is 1 − m.
    """
    said, definitions = claim.printed.statement, claim.notation.definitions
    if not isinstance(said, Relation) or own.index:
        return False
    with suppress(NotExact, IllFormed, RecursionError, ZeroDivisionError, ValueError):
        engine = ExactEngine(take_inventory(sides_of(said), definitions), definitions)
        values = [engine.ring.clear(p) for side in sides_of(said) for p in engine.parts(engine.value(side))]
        about = {place for p in engine.parts(engine.value(own)) for place in _places(p)}
        factors = [f for p in engine.residuals(said) if not p.is_zero() for f in factors_of(engine, p)]
        needed = {place for factor in factors if about & _places(factor) for place in _places(factor)}
        written = {place for p in values for place in _places(p)}
        return bool(needed) and len(written - needed) >= _FEWEST and 2 * len(needed) <= len(written)
    return False


def _places(p: Polynomial) -> set[int]:
    degrees = p.degrees()
    return {place for place, degree in enumerate(degrees) if degree > 0}
