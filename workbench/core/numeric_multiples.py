"""Terms as multiples of other terms by a number."""

from __future__ import annotations

from fractions import Fraction

from workbench.core.terms import Apply, Number, Term


def numeric_multiple(term: Term) -> tuple[Fraction, Term]:
    """Returns c and X of the term c X, with all signs, numbers and divisors around X in c; c is not 0."""
    match term:
        case Apply(head="neg", arguments=(inner,)):
            factor = Fraction(-1)
        case Apply(head="mul", arguments=(Number(value=factor), inner) | (inner, Number(value=factor))):
            pass
        case Apply(head="div", arguments=(inner, Number(value=below))) if below:
            factor = 1 / Fraction(below)
        case _:
            return Fraction(1), term
    if not factor:
        return Fraction(1), term
    more, rest = numeric_multiple(inner)
    return factor * more, rest
