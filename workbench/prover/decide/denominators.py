"""Names the denominators of an equation that may be 0, in the author's symbols."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from contextlib import suppress

from workbench.algebra.differential_ring import Polynomial
from workbench.core.construct import apply
from workbench.core.terms import Apply, IllFormed, Symbol, Term
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.zero_sets import factors_of


def denominators_named(
    engine: ExactEngine, sides: Iterable[Term], definitions: Lookup, gaps: Collection[Polynomial]
) -> str:
    """Returns "the denominator x", or "one of the denominators x, y", whose factors are among the gaps.

    sides: the terms to search; the definitions of their symbols are searched, too.   gaps: polynomials of
    the engine's ring that may be 0.   Returns "a denominator" if no divisor of the terms has such a factor.
    """
    named = dict.fromkeys(
        to_latex(divisor)
        for divisor in divisors_in(sides, definitions)
        if not factors_in(engine, divisor).isdisjoint(map(str, gaps))
    )
    if not named:
        return "a denominator"
    return f"{'the denominator' if len(named) == 1 else 'one of the denominators'} {', '.join(named)}"


def factors_in(engine: ExactEngine, divisor: Term) -> set[str]:
    """Returns the irreducible factors of a divisor, as text; none where the engine does not take it."""
    with suppress(NotExact, ZeroDivisionError):
        return {str(factor) for p in engine.parts(engine.value(divisor)) for factor in factors_of(engine, p)}
    return set()


def divisors_in(sides: Iterable[Term], definitions: Lookup) -> Iterator[Term]:
    """Yields what the terms divide by, from left to right: denominators, determinants of inverted matrices,
    and roots, by which their derivatives divide."""
    waiting, seen = list(sides)[::-1], set()
    while waiting:
        term = waiting.pop()
        if term in seen:
            continue
        seen.add(term)
        if isinstance(term, Apply):
            yield from _divisor(term)
        body = definitions.lookup(term) if isinstance(term, Symbol) else None
        waiting += [body] if body is not None else reversed(term.children)


def _divisor(term: Apply) -> Iterator[Term]:
    match term.head:
        case "div":
            yield term.arguments[1]
        case "norm" | "root":
            yield term
        case "inverse":
            (inverted,) = term.arguments
            with suppress(IllFormed):
                yield inverted if inverted.type.kind == "scalar" else apply("det", inverted)
