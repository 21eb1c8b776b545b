"""Equations that are meant as identities: solved for a symbol, most of their symbols would cancel."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from workbench.algebra.differential_ring import Polynomial
from workbench.context.claims import Claim
from workbench.context.free_symbols import equations_of
from workbench.core.terms import IllFormed, Relation, Symbol, Term, sides_of
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.prover.decide.zero_sets import factors_of

#: An identity has at least this many symbols that the value of the symbol would not depend on.
_FEWEST = 3
_PROBLEMS = (NotExact, IllFormed, RecursionError, ZeroDivisionError, ValueError)


def is_near_identity(claim: Claim, own: Symbol) -> bool:
    """True if an equation, as one that says what a symbol is, would give it by less than half of its symbols.

    (M ẋ² + m ẋ² + m l² θ̇²) / 2 = (ẋ² + m l² θ̇²) / 2 is no way to say that M is 1 − m.
    """
    said, definitions = claim.printed.statement, claim.notation.definitions
    if not isinstance(said, Relation) or own.index:
        return False
    with suppress(*_PROBLEMS):
        engine = ExactEngine(take_inventory(sides_of(said), definitions), definitions)
        values = [engine.ring.clear(p) for side in sides_of(said) for p in engine.parts(engine.value(side))]
        residuals = [p for p in engine.residuals(said) if not p.is_zero()]
        factors = [_quantities(engine, f) for p in residuals for f in factors_of(engine, p)]
        needed = {each for quantities in factors if (own, 0) in quantities for each in quantities}
        written = {each for p in values for each in _quantities(engine, p)}
        return bool(needed) and len(written - needed) >= _FEWEST and 2 * len(needed) <= len(written)
    return False


def is_without(claim: Claim, symbols: Sequence[Symbol]) -> bool:
    """True if the sides of the equations differ by what contains none of the symbols: they say nothing of it.

    ∂/∂s (s x, z) = (−x, 0) is no condition for z.
    """
    definitions = claim.notation.definitions
    with suppress(*_PROBLEMS, StopIteration):  # a norm or a reciprocal is of any symbol
        for said in equations_of(claim.printed.parsed):
            engine = ExactEngine(take_inventory(sides_of(said), definitions), definitions)
            for residual in engine.residuals(said):
                parameters = [engine.parameter_of(each).symbol for each in _generators(residual)]
                if not set(symbols).isdisjoint(parameters):
                    return False
        return True
    return False


def _generators(p: Polynomial) -> Iterator[Polynomial]:
    return (p.context().gen(place) for place, degree in enumerate(p.degrees()) if degree > 0)


def _quantities(engine: ExactEngine, p: Polynomial) -> set[tuple[Term, int]]:
    """Returns the symbols of a polynomial, each with the order of its rate."""
    found: set[tuple[Term, int]] = set()
    for each in _generators(p):
        with suppress(StopIteration):  # a norm or a reciprocal
            parameter = engine.parameter_of(each)
            found.add((parameter.symbol, parameter.order))
    return found
