"""Ideals of equations: membership, and proofs that no real numbers satisfy some assumptions."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import lcm
from typing import Any

from flint import Ordering, fmpq_mpoly_ctx, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_mpoly_vec

from workbench.algebra.differential_ring import Polynomial
from workbench.core.terms import Relation
from workbench.engines.inventory.assumptions import Assumptions
from workbench.engines.polynomial.polynomial_engine import ExactEngine

#: Limits on a basis: polynomials, terms of a polynomial, bits of a coefficient.
LIMITS = (60, 400, 4096)


def square_of(engine: ExactEngine, relation: Relation) -> Polynomial:
    """Returns a polynomial that is 0 exactly where the sides are equal: the difference of scalars, else the
    sum of the squares of the components."""
    residuals = engine.residuals(relation)
    if len(residuals) == 1:
        return residuals[0]
    return engine.ring.reduce(sum((r * r for r in residuals), engine.ring.zero))


def impossible(engine: ExactEngine, assumptions: Assumptions) -> bool:
    """True if 1 is in the ideal of the equations, or a polynomial of it has no real zero.

    A disequation p ≠ 0 is w p = 1 with another indeterminate w. False means that nothing was proved.
    """
    ring = engine.ring
    for relation in assumptions.nonzero:
        if not any(engine.residuals(relation)):
            return True
    equations = [p for e in assumptions.equations for p in engine.residuals(e)]
    nonzero = [square_of(engine, relation) for relation in assumptions.nonzero]
    nonzero += [ring.clear(d) for d in ring.denominators]
    names = (*ring.names, *(f"apart{i}" for i in range(len(nonzero))))
    context = fmpz_mpoly_ctx.get(names, Ordering.lex)
    generators = [_integral(p, context) for p in (*equations, *ring.relations)]
    apart = context.gens()[len(ring.names) :]
    generators += [w * _integral(p, context) - 1 for w, p in zip(apart, nonzero, strict=True)]
    return any(is_nowhere_zero(p, engine.norm_places) for p in _basis(generators, context))


class Ideal:
    """The ideal of some vanishing polynomials, as far as a basis is found within the limits."""

    def __init__(self, names: tuple[str, ...], generators: Sequence[Polynomial]) -> None:
        context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
        found = _basis([_integral(p, context) for p in generators], context)
        self._context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        self._basis = [self._context.from_dict(dict(p.terms())) for p in found]

    def holds(self, p: Polynomial) -> bool:
        """True if division by the basis shows that p is in the ideal."""
        rest, before = self._context.from_dict(dict(p.terms())), None
        while rest != before:
            before = rest
            for divisor in self._basis:
                rest = divmod(rest, divisor)[1]
        return not rest


def _basis(generators: Sequence[fmpz_mpoly], context: fmpz_mpoly_ctx) -> fmpz_mpoly_vec:
    """Returns a Gröbner basis of the ideal, or the part of it that was found within the limits."""
    found: Any
    found, finished = fmpz_mpoly_vec(generators, context).buchberger_naive(limits=LIMITS)
    basis: fmpz_mpoly_vec = found.autoreduction() if finished else found
    return basis


def _integral(p: Polynomial, context: fmpz_mpoly_ctx) -> fmpz_mpoly:
    """Returns an integral multiple of p, in the larger ring."""
    below = lcm(*(int(c.q) for _, c in p.terms()))
    more = (0,) * (context.nvars() - p.context().nvars())
    return context.from_dict({(*e, *more): int(c.p) * (below // int(c.q)) for e, c in p.terms()})


def is_nowhere_zero(
    p: Polynomial | fmpz_mpoly, norms: Collection[int], apart: Collection[int] = frozenset()
) -> bool:
    """True for a non-zero number plus monomials of its sign in which all squares and norms are non-negative.

    norms: the positions of the generators that stand for norms. apart: those of generators that are not 0,
    whose product can replace the number.
    """
    terms: list[Any] = list(p.terms())
    same_sign = len({c > 0 for _, c in terms}) == 1
    is_there = any(all(place in apart for place, e in enumerate(powers) if e) for powers, _ in terms)
    return same_sign and is_there and has_even_powers(p, norms)


def has_even_powers(p: Polynomial | fmpz_mpoly, norms: Collection[int]) -> bool:
    """True if each monomial is a product of squares and norms, and so is nowhere negative."""
    powers = (exponents for exponents, _ in p.terms())
    return all(e % 2 == 0 or place in norms for exponents in powers for place, e in enumerate(exponents))
