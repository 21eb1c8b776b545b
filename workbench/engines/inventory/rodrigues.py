"""Arguments of the exponential: an angle times a unit vector or any vector, as a skew tensor, as a quaternion
without a scalar part, or as the skew tensor of a twist matrix."""

from __future__ import annotations

from fractions import Fraction

from workbench.core.construct import apply, number
from workbench.core.shapes import filling, multiple
from workbench.core.terms import Apply, Block, IllFormed, Number, Symbol, Term
from workbench.core.types import TENSOR, VECTOR
from workbench.engines.inventory import Lookup


def angle_and_axis(term: Term, definitions: Lookup) -> tuple[Term, Term] | None:
    """Returns (α, u) for c α ũ, ũ c α, the skew tensor of c α u, the quaternion (0, c α u) and similar terms.

    A number c multiplies the angle. Returns None for other terms.
    """
    coefficient, angles = Fraction(1), []
    while not _is_unit(term):
        match term:
            case Symbol() if (body := definitions.lookup(term)) is not None:
                term = body
            case Apply(head="skew", arguments=(inner,)):
                term = inner
            case Apply(head="quaternion", arguments=(scalar, inner)) if filling(scalar) == "zero":
                term = inner
            case Apply(head="neg", arguments=(inner,)):
                coefficient, term = -coefficient, inner
            case Apply(head="div", arguments=(inner, Number(value=value))):
                coefficient, term = coefficient / value, inner
            case Apply(head="mul", arguments=(left, right)) if "scalar" in (left.type.kind, right.type.kind):
                factor, term = (left, right) if left.type.kind == "scalar" else (right, left)
                if isinstance(factor, Number):
                    coefficient *= factor.value
                else:
                    angles.append(factor)
            case _:
                return None
    if not angles:
        return None
    angle = angles[0]
    for factor in angles[1:]:
        angle = apply("mul", angle, factor)
    return (angle if coefficient == 1 else apply("mul", number(coefficient), angle)), term


def _is_unit(term: Term) -> bool:
    """True for a vector declared as a unit vector, or a numeric vector of length 1."""
    if isinstance(term, Symbol):
        return term.declaration.unit and term.type.kind == "vector"
    if not isinstance(term, Block) or term.type.kind != "vector" or term.type.dual:
        return False
    entries = [entry for (entry,) in term.entries] if len(term.entries[0]) == 1 else []
    if not all(isinstance(entry, Number) or filling(entry) == "zero" for entry in entries):
        return False
    return sum(entry.value**2 for entry in entries if isinstance(entry, Number)) == 1


def rotation_vector(term: Term, definitions: Lookup) -> Term | None:
    """Returns x if the term is the skew tensor of x or the quaternion (0, x), both real; else None."""
    if term.type.dual:
        return None
    match term:
        case Symbol() if (body := definitions.lookup(term)) is not None:
            return rotation_vector(body, definitions)
        case Apply(head="skew", arguments=(inner,)):
            return inner
        case Apply(head="quaternion", arguments=(scalar, inner)) if filling(scalar) == "zero":
            return inner
        case Apply(head="neg" | "div" | "mul" | "add", arguments=arguments):
            places = [i for i, a in enumerate(arguments) if a.type.kind in ("tensor", "quaternion")]
            vectors = [rotation_vector(arguments[i], definitions) for i in places]
            found = [vector for vector in vectors if vector is not None]
            if not found or len(found) < len(vectors) or not (len(places) == 1 or term.head == "add"):
                return None
            parts = list(arguments)
            for place, vector in zip(places, found, strict=True):
                parts[place] = vector
            try:
                return apply(term.head, *parts)
            except IllFormed:
                return None
    return None


def twist_parts(term: Term, definitions: Lookup) -> tuple[Term, Term] | None:
    """Returns (X, v) of a 4×4 matrix [X v; 0 0] with a real tensor and a vector, or of multiples and sums of
    such."""
    if term.type.dual:
        return None
    match term:
        case Symbol() if (body := definitions.lookup(term)) is not None:
            return twist_parts(body, definitions)
        case Block(entries=((turning, moving), lowest)) if turning.type == TENSOR and moving.type == VECTOR:
            return (turning, moving) if all(multiple(each) == "zero" for each in lowest) else None
        case Apply(head="neg" | "div" | "mul" | "add", arguments=arguments):
            places = [i for i, a in enumerate(arguments) if a.type == term.type]
            pairs = [twist_parts(arguments[i], definitions) for i in places]
            found = [pair for pair in pairs if pair is not None]
            if len(found) < len(pairs) or not (len(places) == 1 or term.head == "add"):
                return None
            made = []
            for which in (0, 1):
                parts = list(arguments)
                for place, pair in zip(places, found, strict=True):
                    parts[place] = pair[which]
                made.append(apply(term.head, *parts))
            return made[0], made[1]
    return None
