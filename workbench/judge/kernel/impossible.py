"""When it is proved that nothing satisfies some assumptions, over the real numbers."""

from __future__ import annotations

from math import lcm

from flint import Ordering, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_mpoly_vec

from workbench.algebra.differential_ring import Polynomial
from workbench.judge.first.exact import ExactEngine
from workbench.judge.subject.assumptions import Assumptions

#: Beyond these sizes (polynomials of a basis, terms of one, bits of a coefficient) a basis is not sought.
LIMITS = (60, 400, 4096)


def impossible(engine: ExactEngine, assumptions: Assumptions) -> bool:
    """Whether 1 is in the ideal of the equations, or a polynomial of it has no real zero. An inequation p ≠ 0
    is w p = 1 with another indeterminate w; False says that nothing was proved."""
    ring = engine.ring
    for relation in assumptions.nonzero:
        if not any(engine.residuals(relation)):
            return True
    equations = [p for e in assumptions.equations for p in engine.residuals(e)]
    nonzero = []
    for relation in assumptions.nonzero:
        residuals = engine.residuals(relation)
        nonzero.append(residuals[0] if len(residuals) == 1 else sum((p * p for p in residuals), ring.zero))
    nonzero += [ring.clear(d) for d in ring.denominators]
    names = (*ring.names, *(f"apart{i}" for i in range(len(nonzero))))
    context = fmpz_mpoly_ctx.get(names, Ordering.lex)
    basis = [_integral(p, context) for p in (*equations, *ring.relations)]
    apart = context.gens()[len(ring.names) :]
    basis += [w * _integral(p, context) - 1 for w, p in zip(apart, nonzero, strict=True)]
    found, finished = fmpz_mpoly_vec(basis, context).buchberger_naive(limits=LIMITS)
    if finished:
        found = found.autoreduction()
    norms = frozenset(place for place, name in enumerate(ring.names) if name in engine.norms)
    return any(_never_zero(p, norms) for p in found)  # of a basis that is not finished, too


def _integral(p: Polynomial, context: fmpz_mpoly_ctx) -> fmpz_mpoly:
    """A multiple of p by a number, in the larger ring."""
    below = lcm(*(int(c.q) for _, c in p.terms()))
    more = (0,) * (context.nvars() - p.context().nvars())
    return context.from_dict({(*e, *more): int(c.p) * (below // int(c.q)) for e, c in p.terms()})


def _never_zero(p: fmpz_mpoly, norms: frozenset[int]) -> bool:
    """A number that is not 0 plus monomials of its sign, whose squares and norms are not negative."""
    terms = list(p.terms())
    same_sign = len({c > 0 for _, c in terms}) == 1
    constant = any(not any(exponents) for exponents, _ in terms)
    even = all(e % 2 == 0 or place in norms for exponents, _ in terms for place, e in enumerate(exponents))
    return same_sign and constant and even
