"""Denominators of a statement."""

from __future__ import annotations

from workbench.core.terms import Apply, Power, Statement, Term
from workbench.repair.terms.subterm_positions import places
from workbench.repair.terms.term_arithmetic import factors_of


def divisors(statement: Statement) -> set[Term]:
    """Returns the factors of all denominators, without their exponents, and the arguments of inverses."""
    parts = (term for _, term in places(statement) if isinstance(term, Apply))
    below = (each.arguments[-1] for each in parts if each.head in ("div", "inverse"))
    factors = (factor for each in below for factor in factors_of(each))
    return {factor.base if isinstance(factor, Power) else factor for factor in factors}
