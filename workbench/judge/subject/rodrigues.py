"""Which terms are an angle times a unit vector's skew tensor: what exp is taken of by Rodrigues' formula."""

from __future__ import annotations

from fractions import Fraction

from workbench.language.construct import apply, number
from workbench.language.terms import Apply, Number, Symbol, Term


def angle_and_axis(term: Term) -> tuple[Term, Symbol] | None:
    """(α, u) for c α ũ, ũ c α, the skew tensor of c α u and the like, with a number c that goes to the angle;
    None for anything else."""
    coefficient, angles = Fraction(1), []
    while not isinstance(term, Symbol):
        match term:
            case Apply(head="skew", arguments=(inner,)):
                term = inner
            case Apply(head="neg", arguments=(inner,)):
                coefficient, term = -coefficient, inner
            case Apply(head="mul", arguments=(left, right)) if "scalar" in (left.type.kind, right.type.kind):
                factor, term = (left, right) if left.type.kind == "scalar" else (right, left)
                if isinstance(factor, Number):
                    coefficient *= factor.value
                else:
                    angles.append(factor)
            case _:
                return None
    if len(angles) != 1 or not term.declaration.unit:
        return None
    angle = angles[0]
    return (angle if coefficient == 1 else apply("mul", number(coefficient), angle)), term
