"""Variants of a scalar term with an operand at another place: b/a for a/b, f(x)/n for f(x/n), a b for a^b."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial

from workbench.core.construct import apply, power
from workbench.core.operations import OF_SCALARS
from workbench.core.terms import Apply, Head, Number, Symbol, Term
from workbench.core.types import SCALAR

#: (kind, the change in words, maker of the new term).
Moved = tuple[str, tuple, Callable[[], Term]]

_OUTSIDE = "the divisor {} stands outside of the function in {}"
_INSIDE = "the divisor {} stands inside of the function in {}"


def moved_operands(term: Apply) -> Iterator[Moved]:
    """Yields the variants of a quotient, a function of a quotient, a sum of letters and a power."""
    match term:
        case Apply(head="div", arguments=(Apply(head="sin") as sine, Apply(head="cos") as cosine)) if (
            sine.arguments == cosine.arguments
        ):
            yield from _divisor_outside(sine.arguments[0], term, _tangent)
        case Apply(head="div", arguments=(above, below)) if term.type == SCALAR:
            if not isinstance(above, Number):
                yield (
                    "product",
                    ("turn the quotient {} upside down", term),
                    partial(apply, "div", below, above),
                )
            if isinstance(above, Apply) and above.head in OF_SCALARS:
                said = (_INSIDE, below, term)
                yield "product", said, partial(_of_quotient, above.head, above.arguments[0], below)
        case Apply(head="pow", arguments=(base, exponent)):
            yield "product", ("{} is a factor of {}", exponent, base), partial(apply, "mul", base, exponent)
        case Apply(head="add", arguments=addends) if term.type == SCALAR and _are_letters(addends):
            yield "exponent", ("all addends of {} get the exponent 2", term), partial(_squares, addends)
        case Apply(head=head, arguments=(inner,)) if head in OF_SCALARS and term.type == SCALAR:
            yield from _divisor_outside(inner, term, partial(apply, head))


def _divisor_outside(inner: Term, term: Term, function: Callable[[Term], Term]) -> Iterator[Moved]:
    match inner:
        case Apply(head="div", arguments=(angle, divisor)):
            said = (_OUTSIDE, divisor, term)
            yield "product", said, lambda: apply("div", function(angle), divisor)


def _tangent(angle: Term) -> Term:
    return apply("div", apply("sin", angle), apply("cos", angle))


def _of_quotient(head: Head, inner: Term, divisor: Term) -> Term:
    return apply(head, apply("div", inner, divisor))


def _are_letters(addends: Sequence[Term]) -> bool:
    return all(isinstance(each, Symbol) for each in addends)


def _squares(addends: Sequence[Term]) -> Term:
    return apply("add", *(power(each, 2) for each in addends))
