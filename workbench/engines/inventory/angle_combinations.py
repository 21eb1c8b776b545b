"""Arguments of sines and cosines: rational combinations of angles.

An angle is a free scalar, or a product, a norm, a quotient … such as ω t or ‖x‖, identified by its value. If
θ/2 occurs under a sine, θ is 2 h with a free angle h. For ω t the half angle is the parameter.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from math import lcm
from typing import TypeGuard

from workbench.core.codes.engine_codes import EngineCode
from workbench.core.construct import apply, number, symbol
from workbench.core.names import Name
from workbench.core.numeric_multiples import numeric_multiple
from workbench.core.terms import Apply, DualUnit, Number, Power, Symbol, Term, Zero
from workbench.engines.inventory import Lookup, NotExact, WithDefinitions
from workbench.engines.inventory.rodrigues import angle_and_axis, rotation_vector, twist_parts
from workbench.language.definitions import number_behind
from workbench.language.printing.printer import to_latex

#: A sum of products of scalars: the sorted factors of each product → its coefficient.
Sum = dict[tuple[Term, ...], Fraction]

_ROUND = frozenset({"sin", "cos", "exp"})


def with_parts_of_angles(terms: Iterable[Term], definitions: Lookup) -> Lookup:
    """Returns definitions under which each free angle in the terms is an integer multiple of a free angle."""
    denominators: dict[Symbol, int] = {}
    for argument in trigonometric_terms(terms, definitions, set()):
        for angle, part in _parts(argument, definitions):
            if is_free_angle(angle) and part.denominator > 1:
                denominators[angle] = lcm(denominators.get(angle, 1), part.denominator)
    multiples = {a: _multiple(a, size) for a, size in denominators.items()}
    return WithDefinitions(definitions, multiples) if multiples else definitions


def is_free_angle(angle: Term) -> TypeGuard[Symbol]:
    """True for a symbol other than the time. (The rate of t/2 is known, as that of ω t is, so no free symbol
    can replace it.)"""
    return isinstance(angle, Symbol) and not angle.declaration.clock


def angle_parts(angle: Term, definitions: Lookup) -> dict[Term, Fraction]:
    """Returns the angle as a rational combination of free scalars and of other terms: products, norms, ….

    Raises NotExact if it contains a number or a sine: the engines have no sine and cosine for these.
    """
    parts: dict[Term, Fraction] = {}
    for factors, coefficient in sum_of_products(angle, definitions).items():
        if not factors:
            raise NotExact(EngineCode.NO_ANGLE())
        if len(factors) > 1 and len(set(factors)) == 1 and not _is_positive(factors):
            raise NotExact(EngineCode.ANGLE_POWER())
        if not any(isinstance(factor, DualUnit) for factor in factors):
            term = factors[0]
            for factor in factors[1:]:
                term = apply("mul", term, factor)
            parts[term] = coefficient
    if next(trigonometric_terms(parts, definitions, set()), None) is not None:
        raise NotExact(EngineCode.NESTED_ANGLE())
    return parts


def _is_positive(factors: tuple[Term, ...]) -> bool:
    """True if the factors are the r r of a positive angle."""
    return len(factors) == 2 and isinstance(factors[0], Symbol) and number_behind(factors[0]) != factors[0]


def angles_of(term: Apply, definitions: Lookup) -> dict[Term, Fraction]:
    """Returns the angles of a sine, a cosine or an exponential; none for the exponential of a purely dual
    number."""
    (argument,) = term.arguments
    if term.head != "exp":
        return angle_parts(argument, definitions)
    if (parts := twist_parts(argument, definitions)) is not None:
        argument = parts[0]
    turn = angle_and_axis(argument, definitions)
    if turn is not None:
        return angle_parts(turn[0], definitions)
    vector = rotation_vector(argument, definitions)
    return {} if vector is None else angle_parts(apply("norm", vector), definitions)


def _parts(argument: Apply, definitions: Lookup) -> Iterable[tuple[Term, Fraction]]:
    try:
        return angles_of(argument, definitions).items()
    except NotExact:
        return ()  # the inventory reports it


def trigonometric_terms(terms: Iterable[Term], definitions: Lookup, seen: set[Term]) -> Iterator[Apply]:
    """Yields the sines, cosines and exponentials in the terms and in their definitions."""
    for term in terms:
        if term in seen:
            continue
        seen.add(term)
        if isinstance(term, Apply) and term.head in _ROUND:
            yield term
        body = definitions.lookup(term) if isinstance(term, Symbol) else None
        yield from trigonometric_terms(
            term.children if body is None else (body, *term.children), definitions, seen
        )


def sum_of_products(term: Term, definitions: Lookup) -> Sum:
    """Returns the expanded scalar."""
    match term:
        case Zero():
            return {}
        case Number(value=value):
            return {(): value}
        case Symbol() if (body := definitions.lookup(term)) is not None:
            return sum_of_products(body, definitions)
        case Apply(head="re", arguments=(inner,)):
            return sum_of_products(inner, definitions)
        case Apply(head="neg", arguments=(inner,)):
            return {factors: -c for factors, c in sum_of_products(inner, definitions).items()}
        case Apply(head="add", arguments=addends):
            total: Sum = {}
            for addend in addends:
                for factors, c in sum_of_products(addend, definitions).items():
                    total[factors] = total.get(factors, Fraction(0)) + c
            return total
        case Apply(head="mul", arguments=(left, right)) if left.type.kind == right.type.kind == "scalar":
            return _product(sum_of_products(left, definitions), sum_of_products(right, definitions))
        case Apply(head="mul", arguments=(left, right)):  # factors that do not commute, as in 2 xᵀ y
            (factor, one), (other_factor, other) = numeric_multiple(left), numeric_multiple(right)
            return {(apply("mul", one, other),): factor * other_factor}
        case Apply(head="div", arguments=(top, bottom)):
            return _product(sum_of_products(top, definitions), _reciprocal(bottom, definitions))
        case Power(base=base, exponent=exponent) if base.type.kind == "scalar" and exponent.is_number:
            total = {(): Fraction(1)}
            for _ in range(int(exponent)):
                total = _product(total, sum_of_products(base, definitions))
            return total
        case Apply(head="norm", arguments=(inner,)):
            size, rest = _scaled(inner, definitions)
            return {(apply("norm", rest),): abs(size)}
    return {(term,): Fraction(1)}


def _product(left: Sum, right: Sum) -> Sum:
    total: Sum = {}
    for a, x in left.items():
        for b, y in right.items():
            factors = tuple(sorted((*a, *b), key=to_latex))
            total[factors] = total.get(factors, Fraction(0)) + x * y
    return total


def _reciprocal(term: Term, definitions: Lookup) -> Sum:
    below = sum_of_products(term, definitions)
    if len(below) == 1 and () in below and below[()]:
        return {(): 1 / below[()]}
    return {(apply("div", number(1), term),): Fraction(1)}


def _scaled(term: Term, definitions: Lookup) -> tuple[Fraction, Term]:
    """Returns the numeric factor and the rest of a vector or scalar under a norm."""
    factor, inner = numeric_multiple(term)
    body = definitions.lookup(inner) if isinstance(inner, Symbol) else None
    size, rest = (Fraction(1), inner) if body is None else _scaled(body, definitions)
    return (factor * size, rest) if size != 1 else (factor, inner)


def _multiple(angle: Symbol, size: int) -> Term:
    name = Name(rf"\frac{{{to_latex(angle)}}}{{{size}}}", of=(angle, size))
    part = symbol(replace(angle.declaration, name=name, indices=0, weight=angle.weight, parameters=0))
    return apply("mul", number(size), part)
