"""Zeros of polynomials: membership in an ideal, factors that must not vanish, equal zero sets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from flint import fmpq_mpoly_vec

from workbench.algebra.differential_ring import Polynomial
from workbench.judge.exact import ExactEngine
from workbench.judge.verdict import EngineDisagreement, Evidence, Outcome, Verdict
from workbench.language.terms import Relation

if TYPE_CHECKING:
    from workbench.judge.judge import _Case


def unimplied(engine: ExactEngine, nonzero: Sequence[Relation]) -> list[Polynomial]:
    """The irreducible factors of the denominators that the inequations do not keep from vanishing.

    A scalar p ≠ 0 excludes the zeros of every factor of p; a vector or tensor x ≠ 0 those of x·x. A factor
    that is a positive number plus a sum of squares of monomials has no real zero.
    """
    excluded: list[Polynomial] = []
    for relation in nonzero:
        residuals = engine.residuals(relation)
        p = residuals[0] if len(residuals) == 1 else sum((r * r for r in residuals), engine.ring.zero)
        excluded += [factor for factor, _ in engine.ring.reduce(p).factor()[1]]
        if len(residuals) == 1:
            continue
        excluded += [p]
    gaps = []
    for denominator in engine.ring.denominators:
        for factor, _ in engine.ring.square_of(denominator).factor()[1]:
            if not any(_proportional(factor, known) for known in excluded) and not _positive(factor):
                gaps.append(factor)
    return gaps


def _proportional(p: Polynomial, q: Polynomial) -> bool:
    return p * q.leading_coefficient() == q * p.leading_coefficient()


def _positive(p: Polynomial) -> bool:
    terms = list(p.terms())
    constant = any(not any(exponents) for exponents, _ in terms)
    even = all(all(e % 2 == 0 for e in exponents) and coefficient > 0 for exponents, coefficient in terms)
    return constant and even


def ideal_of(engine: ExactEngine, equations: Sequence[Relation]) -> list[Polynomial]:
    """A Gröbner basis of the equations' residuals at the instant."""
    residuals = [p for e in equations for p in engine.residuals(e) if p != 0]
    if not residuals:
        return []
    basis = fmpq_mpoly_vec([*residuals, *engine.ring.relations], residuals[0].context())
    return list(basis.buchberger_naive().autoreduction()) if len(residuals) else []


def in_ideal(p: Polynomial, basis: Sequence[Polynomial]) -> bool:
    """Whether the remainder of p by the basis is 0."""
    changed = True
    while changed and p != 0:
        changed = False
        for divisor in basis:
            remainder = divmod(p, divisor)[1]
            if remainder != p:
                p, changed = remainder, True
    return p == 0


def same_zeros(case: _Case, left: Relation, right: Relation, both_ways: bool, second_engine: bool) -> Verdict:
    """left ≠ 0 ⇔ right ≠ 0 (or ⇒), proved by factors.

    A vector x vanishes exactly where x·x does. If every irreducible factor of the one scalar divides the other,
    the other vanishes wherever the one does. The second engine checks the division that says so.
    """
    p, q = (_scalar(case, relation) for relation in (left, right))
    if unimplied(case.exact, case.assumptions.nonzero) or case.assumptions.equations:
        return Verdict(Outcome.UNCHECKED, reason="an equivalence with denominators, or under an equation")
    needed = [(q, p)] if left.operator == "≠" else [(p, q)]
    if both_ways:
        needed = [(p, q), (q, p)]
    for of, divides in needed:
        if any(divmod(divides, factor)[1] != 0 for factor, _ in of.factor()[1]):
            reason = "the factors of the two sides differ, and no point tells them apart"
            return Verdict(Outcome.UNCHECKED, reason=reason)
    evidence = [Evidence("exact ring over ℚ (FLINT)", "the two sides have the same irreducible factors")]
    if not second_engine:
        return Verdict(Outcome.PROBABLE, reason="second engine left out", evidence=tuple(evidence))
    from workbench.judge.sympy_ring import recheck_division

    if not recheck_division(left, right, both_ways, case.inventory, case.definitions):
        raise EngineDisagreement("FLINT and SymPy differ on the factors of an equivalence")
    evidence.append(Evidence("SymPy PolyRing on Python integers", "each side divides a power of the other"))
    return Verdict(Outcome.PROVED, evidence=tuple(evidence))


def _scalar(case: _Case, relation: Relation) -> Polynomial:
    residuals = case.exact.residuals(relation)
    if len(residuals) == 1:
        return residuals[0]
    return case.exact.ring.reduce(sum((p * p for p in residuals), case.exact.ring.zero))
