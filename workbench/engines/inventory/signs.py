"""Non-negative scalars, recognized by their form."""

from __future__ import annotations

from workbench.core.terms import Apply, Number, Power, Term, Zero


def is_seen_nonnegative(term: Term) -> bool:
    """True if the form of the term shows that it is not negative where it is defined."""
    if term.type.dual or term.type.kind != "scalar":
        return False
    match term:
        case Zero() | Apply(head="norm" | "root"):
            return True
        case Number(value=value):
            return value >= 0
        case Power(base=base, exponent=exponent):
            return (exponent.is_number and int(exponent) % 2 == 0) or is_seen_nonnegative(base)
        case Apply(head="dot" | "mul", arguments=(left, right)) if left == right:
            return True
        case Apply(head="det", arguments=(Apply(head="mul", arguments=(left, right)),)):
            return _are_transposes(left, right)
        case Apply(head="add" | "mul" | "div", arguments=arguments):
            return all(map(is_seen_nonnegative, arguments))
    return False


def _are_transposes(left: Term, right: Term) -> bool:
    """True if one of two real matrices is the transpose of the other. det A Aᵀ is the sum of the squares of
    A's largest minors, or 0."""
    pairs = ((left, right), (right, left))
    return any(isinstance(a, Apply) and a.head == "transpose" and a.arguments == (b,) for a, b in pairs)
