"""Values of definite integrals and of limits at a number, by derivatives that are taken term by term.

∫ₐᵇ g dh    g⁽ⁿ⁾ = 0            Σ g⁽ʲ⁾(a) (b − a)ʲ⁺¹ / (j + 1)!
            g⁗ + K g′ = 0       (g + g″/K)(a) (b − a) − (g′(b) − g′(a)) / K,  as of sines and rotations
            g″ − λ g′ = 0       (g − g′/λ)(a) (b − a) + (g′(b) − g′(a)) / λ²
lim N/D     the first derivatives of N and D that are not both 0 at the place
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from math import factorial

from workbench.core.construct import apply, block, number, power, rebuild, relation, with_children, zero
from workbench.core.numeric_multiples import numeric_multiple
from workbench.core.operations import LINEAR
from workbench.core.terms import (
    Apply,
    Block,
    Derivative,
    Identity,
    Integral,
    Power,
    Relation,
    Symbol,
    Term,
    Zero,
)
from workbench.core.types import PI
from workbench.engines.inventory import NotExact

#: The highest derivative that is taken.
MOST_DERIVATIVES = 6

#: Whether an equation is proved.
Holds = Callable[[Relation], bool]


def with_values(term: Term, holds: Holds) -> Term:
    """Returns the term with the value of each integral and limit that has one."""
    made = with_children(term, lambda child: with_values(child, holds))
    if not isinstance(made, Integral) or len(made.place) < 2:
        return made
    variable, *bounds = made.place
    try:
        if len(bounds) == 1:
            return _limit(made.body, variable, bounds[0], holds)
        return _sum([_definite(part, variable, bounds[0], bounds[1], holds) for part in _addends(made.body)])
    except NotExact:
        return made


def changing_in(term: Term) -> list[Symbol]:
    """Returns the symbols below the integrals of a term that may change with the variable of one."""
    found = [part for part in term.walk() if isinstance(part, Integral) and len(part.place) == 3]
    return list(dict.fromkeys(each for part in found for each in _others(part.body, part.place[0])))


def _others(body: Term, variable: Term) -> Iterator[Symbol]:
    bound = {variable, *(part.place[0] for part in body.walk() if isinstance(part, Integral) and part.place)}
    for part in body.walk():
        if isinstance(part, Symbol) and part not in bound and part.declaration.name != PI.name:
            yield from () if part.declaration.constant or part.declaration.independent else (part,)


def _definite(body: Term, variable: Term, lower: Term, upper: Term, holds: Holds) -> Term:
    """Returns the integral of one addend. Raises NotExact."""
    stands = _holds(body, variable)
    is_clock = isinstance(variable, Symbol) and variable.declaration.clock
    if any(_others(body, variable)) and (is_clock or not stands):
        raise NotExact("an integral of what may change")
    rates = [body]
    for order in range(MOST_DERIVATIVES):
        if _is_zero(rates[-1], holds):
            return _of_polynomial(rates[:order], variable, lower, upper, body)
        rates.append(differentiated_by(rates[-1], variable))
    _, first, second, third, *_ = rates
    length = _minus(upper, lower)
    change = _minus(_at(first, variable, upper), _at(first, variable, lower))
    for rate in _exponents(body, variable):
        if _is_zero(_minus(second, _times(rate, first)), holds):
            mean = _minus(body, _over(first, rate))
            return _sum([_mean(mean, length, variable, lower, holds), _over(change, power(rate, 2))])
    for square in _squares(body, variable):
        if _is_zero(_sum([third, _times(square, first)]), holds):
            mean = _sum([body, _over(second, square)])
            return _minus(_mean(mean, length, variable, lower, holds), _over(change, square))
    raise NotExact("an integral without a known value")


def _mean(mean: Term, length: Term, variable: Term, lower: Term, holds: Holds) -> Term:
    return zero(mean.type) if _is_zero(mean, holds) else _times(length, _at(mean, variable, lower))


def _of_polynomial(rates: list[Term], variable: Term, lower: Term, upper: Term, body: Term) -> Term:
    length, addends = _minus(upper, lower), []
    for order, rate in enumerate(rates):
        factor = number(Fraction(1, factorial(order + 1)))
        by = length if order == 0 else power(length, order + 1)
        addends.append(_times(apply("mul", factor, by), _at(rate, variable, lower)))
    return _sum(addends) if addends else zero(body.type)


def _exponents(body: Term, variable: Term) -> Iterator[Term]:
    for part in body.walk():
        if isinstance(part, Apply) and part.head == "exp" and part.type.kind == "scalar":
            rate = differentiated_by(part.arguments[0], variable)
            if not isinstance(rate, Zero) and not _holds(rate, variable):
                yield rate
                yield _times(number(2), rate)


def _squares(body: Term, variable: Term) -> Iterator[Term]:
    """Yields the squares of the rates of its angles, of twice these, and of its rotations."""
    for part in dict.fromkeys(body.walk()):
        if not isinstance(part, Apply) or part.head not in ("sin", "cos", "exp"):
            continue
        rate = differentiated_by(part.arguments[0], variable)
        if isinstance(rate, Zero) or _holds(rate, variable):
            continue
        if part.head != "exp":
            yield power(rate, 2)
            yield apply("mul", number(4), power(rate, 2))
        elif part.type.kind == "tensor":
            yield apply(
                "mul", number(Fraction(1, 2)), apply("trace", apply("mul", apply("transpose", rate), rate))
            )


def _limit(term: Term, variable: Term, place: Term, holds: Holds) -> Term:
    """Returns the limit. Raises NotExact where the term is not seen to be continuous."""
    if not _holds(term, variable):
        return term
    match term:
        case Apply(head="mul", arguments=(Apply(head="div", arguments=(one, below)), other)):
            return _quotient(_times(one, other), below, variable, place, holds)
        case Apply(head="div", arguments=(above, below)):
            return _quotient(above, below, variable, place, holds)
        case Symbol():
            return _at(term, variable, place)
        case Apply(head="add" | "neg" | "sin" | "cos" | "exp") | Block() | Power():
            pass
        case Apply(head=head) if head in LINEAR:
            pass
        case _:
            raise NotExact("a limit without a known value")
    return _rebuilt(term, [_limit(child, variable, place, holds) for child in term.children])


def _quotient(above: Term, below: Term, variable: Term, place: Term, holds: Holds) -> Term:
    for _ in range(MOST_DERIVATIVES):
        value = _limit(below, variable, place, holds)
        if not _is_zero(value, holds):
            return _over(_limit(above, variable, place, holds), value)
        if not _is_zero(_limit(above, variable, place, holds), holds):
            break
        above, below = differentiated_by(above, variable), differentiated_by(below, variable)
    raise NotExact("a limit without a known value")


def differentiated_by(term: Term, variable: Term) -> Term:
    """Returns the derivative, with all other symbols kept fixed. Raises NotExact below other operations."""
    if term == variable:
        return number(1)
    if not _holds(term, variable):
        return zero(term.type)
    match term:
        case Apply(head="div", arguments=(above, below)):
            one = _over(differentiated_by(above, variable), below)
            return _minus(one, _over(_times(differentiated_by(below, variable), above), power(below, 2)))
        case Apply(head="sin" | "cos" | "exp" as head, arguments=(inner,)):
            rate = differentiated_by(inner, variable)
            if term.type.kind != "scalar" and _holds(rate, variable):
                raise NotExact("a derivative of an exponential that may not commute")
            if head == "exp":
                return _times(rate, term)
            return _times(rate, apply("cos", inner) if head == "sin" else apply("neg", apply("sin", inner)))
        case Power(base=base, exponent=exponent) if exponent.is_number and base.type.kind == "scalar":
            degree = int(exponent)
            lowered = number(1) if degree == 1 else base if degree == 2 else power(base, degree - 1)
            return _times(apply("mul", number(degree), lowered), differentiated_by(base, variable))
        case Block(entries=entries):
            return block([[differentiated_by(entry, variable) for entry in row] for row in entries])
        case Apply(head="add", arguments=arguments):
            return _sum([differentiated_by(each, variable) for each in arguments])
        case Apply(head=head, arguments=arguments) if head == "neg" or head in LINEAR:
            return _sum(
                [
                    apply(head, *arguments[:at], differentiated_by(each, variable), *arguments[at + 1 :])
                    for at, each in enumerate(arguments)
                    if _holds(each, variable)
                ]
            )
    raise NotExact("a derivative of another operation")


def _holds(term: Term, variable: Term) -> bool:
    return any(part == variable for part in term.walk())


def _at(term: Term, variable: Term, value: Term) -> Term:
    if term == variable:
        return value
    if isinstance(term, Derivative) and _holds(term, variable):
        raise NotExact("a rate of the variable")
    return _rebuilt(term, [_at(child, variable, value) for child in term.children]) if term.children else term


def _rebuilt(term: Term, children: list[Term]) -> Term:
    """Returns the term with other factors and angles; 0 · x, exp 0 and sines of quarter turns are known."""
    made = rebuild(term, children)
    if not isinstance(made, Apply):
        return made
    if made.head == "mul" and any(isinstance(each, Zero) for each in made.arguments):
        return zero(made.type)
    if made.head == "exp" and isinstance(made.arguments[0], Zero):
        return number(1) if made.type.kind == "scalar" else Identity(made.type, made.weight)
    turns = _turns(made.arguments[0]) if made.head in ("sin", "cos") else None
    if turns is not None and (2 * turns).denominator == 1:
        return number((0, 1, 0, -1)[int(2 * turns + (made.head == "cos")) % 4])
    return made


def _turns(angle: Term) -> Fraction | None:
    """Returns n for an angle n π."""
    factor, inner = numeric_multiple(angle)
    if isinstance(inner, Zero):
        return Fraction(0)
    return factor if isinstance(inner, Symbol) and inner.declaration.name == PI.name else None


def _is_zero(term: Term, holds: Holds) -> bool:
    return isinstance(term, Zero) or holds(relation("=", term, zero(term.type)))


def _addends(term: Term) -> list[Term]:
    return list(term.arguments) if isinstance(term, Apply) and term.head == "add" else [term]


def _sum(terms: list[Term]) -> Term:
    some = [each for each in terms if not isinstance(each, Zero)]
    return apply("add", *some) if len(some) > 1 else some[0] if some else terms[0]


def _minus(one: Term, other: Term) -> Term:
    return one if isinstance(other, Zero) else _sum([one, apply("neg", other)])


def _times(one: Term, other: Term) -> Term:
    zeros = [each for each in (one, other) if isinstance(each, Zero)]
    return (
        apply("mul", one, other)
        if not zeros
        else zero(one.type if other.type.kind == "scalar" else other.type)
    )


def _over(above: Term, below: Term) -> Term:
    return above if isinstance(above, Zero) else apply("div", above, below)
