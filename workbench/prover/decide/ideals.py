"""Ideals of equations: what is in them, and when no real numbers at all satisfy some assumptions."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import lcm
from typing import Any

from flint import Ordering, fmpq_mpoly_ctx, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_mpoly_vec

from workbench.algebra.differential_ring import Polynomial
from workbench.core.terms import Relation
from workbench.engines.inventory.assumptions import Assumptions
from workbench.engines.polynomial.polynomial_engine import ExactEngine

#: Beyond these sizes (polynomials of a basis, terms of one, bits of a coefficient) a basis is not sought.
LIMITS = (60, 400, 4096)


def square_of(engine: ExactEngine, relation: Relation) -> Polynomial:
    """What is 0 just where both sides are the same: of scalars their difference, else the sum of its
    components' squares."""
    residuals = engine.residuals(relation)
    if len(residuals) == 1:
        return residuals[0]
    return engine.ring.reduce(sum((r * r for r in residuals), engine.ring.zero))


def impossible(engine: ExactEngine, assumptions: Assumptions) -> bool:
    """Whether 1 is in the ideal of the equations, or a polynomial of it has no real zero. An inequation p ≠ 0
    is w p = 1 with another indeterminate w; False says that nothing was proved."""
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
    """What follows from polynomials that vanish, as far as a basis of them is found within the limits."""

    def __init__(self, names: tuple[str, ...], generators: Sequence[Polynomial]) -> None:
        context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
        found = _basis([_integral(p, context) for p in generators], context)
        self._context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        self._basis = [self._context.from_dict(dict(p.terms())) for p in found]

    def holds(self, p: Polynomial) -> bool:
        """Whether p is seen to be in it: each division takes a multiple of one of its members away."""
        rest, before = self._context.from_dict(dict(p.terms())), None
        while rest != before:
            before = rest
            for divisor in self._basis:
                rest = divmod(rest, divisor)[1]
        return rest == 0


def _basis(generators: Sequence[fmpz_mpoly], context: fmpz_mpoly_ctx) -> fmpz_mpoly_vec:
    """A Gröbner basis of the ideal, or what was found of it within the limits."""
    found: Any
    found, finished = fmpz_mpoly_vec(generators, context).buchberger_naive(limits=LIMITS)
    return found.autoreduction() if finished else found


def _integral(p: Polynomial, context: fmpz_mpoly_ctx) -> fmpz_mpoly:
    """A multiple of p by a number, in the larger ring."""
    below = lcm(*(int(c.q) for _, c in p.terms()))
    more = (0,) * (context.nvars() - p.context().nvars())
    return context.from_dict({(*e, *more): int(c.p) * (below // int(c.q)) for e, c in p.terms()})


def is_nowhere_zero(
    p: Polynomial | fmpz_mpoly, norms: Collection[int], apart: Collection[int] = frozenset()
) -> bool:
    """A number that is not 0 plus monomials of its sign, whose squares and norms are not negative. norms: the
    places of the generators that stand for such. apart: those of generators that are not 0, whose product
    does as well as a number."""
    terms: list[Any] = list(p.terms())
    same_sign = len({c > 0 for _, c in terms}) == 1
    is_there = any(all(place in apart for place, e in enumerate(powers) if e) for powers, _ in terms)
    return same_sign and is_there and has_even_powers(p, norms)


def has_even_powers(p: Polynomial | fmpz_mpoly, norms: Collection[int]) -> bool:
    """Whether each monomial is a product of squares and norms, and so is nowhere negative."""
    powers = (exponents for exponents, _ in p.terms())
    return all(e % 2 == 0 or place in norms for exponents in powers for place, e in enumerate(exponents))
