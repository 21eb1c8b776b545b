"""Substitution of integers in formulas: n := 3 in Φ_{n+1}, in Σ_{k=0}^{n}, in x^{(n)} and in binomials."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from math import comb, factorial
from typing import overload

from workbench.core.codes.type_codes import TypeCode
from workbench.core.construct import (
    apply,
    big_sum,
    counting,
    derivative,
    identity,
    integer,
    number,
    power,
    relation,
    symbol,
    with_children,
    zero,
)
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.terms import (
    BigSum,
    Conjunction,
    Counting,
    CountingName,
    Derivative,
    Equivalence,
    Extremum,
    IllFormed,
    Implication,
    Integer,
    Naming,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
)

#: The largest number of addends of an expanded sum.
LARGEST = 2000
#: The largest argument of a factorial, a binomial or a multinomial; its digits can be printed.
MOST_COUNTED = 1000

_FRESH = "klmnijpqrsabcdefgh"


@overload
def instantiate(formula: Term, values: Mapping[str, Linear | int]) -> Term: ...
@overload
def instantiate(formula: Statement, values: Mapping[str, Linear | int]) -> Statement: ...
def instantiate(formula: Term | Statement, values: Mapping[str, Linear | int]) -> Term | Statement:
    """Returns the formula with integer variables replaced by numbers or by linear expressions in other
    variables.

    Numbers are evaluated: sums with numeric bounds are expanded (an empty sum is the 0 of its type),
    factorials and binomials become numbers, x^{(0)} becomes x. Shared subterms stay shared. Raises IllFormed
    for a negative index or order, for sums beyond LARGEST and factorials beyond MOST_COUNTED.
    """
    return Instantiation({name: as_linear(value) for name, value in values.items()}).formula(formula)


class Instantiation:
    """One substitution. Each shared subterm is visited once: `done` maps the id of a term to its result, in
    the order of the visits."""

    def __init__(self, values: Mapping[str, Linear]) -> None:
        self.values = values
        self.done: dict[int, tuple[Term, Term]] = {}

    @overload
    def formula(self, formula: Term) -> Term: ...
    @overload
    def formula(self, formula: Statement) -> Statement: ...
    def formula(self, formula: Term | Statement) -> Term | Statement:
        match formula:
            case Relation():
                return relation(formula.operator, self.term(formula.left), self.term(formula.right))
            case Equivalence() | Implication():
                return type(formula)(self.formula(formula.left), self.formula(formula.right))
            case Conjunction():
                return Conjunction(tuple(self.formula(part) for part in formula.parts))
            case Naming():
                parts, given = (tuple(self.formula(p) for p in s) for s in (formula.parts, formula.given))
                return replace(formula, terms=tuple(map(self.term, formula.terms)), parts=parts, given=given)
            case Extremum():
                sides = self.term(formula.body), self.term(formula.value)
                return Extremum.of(formula.least, formula.letters, *sides)
        return self.term(formula)

    def term(self, term: Term) -> Term:
        known = self.done.get(id(term))
        if known is None:
            known = self.done[id(term)] = (term, self._term(term))  # keeping the term keeps its id valid
        return known[1]

    def _term(self, term: Term) -> Term:
        match term:
            case Integer():
                value = self.linear(term.value)
                return zero() if value == Linear(0) else integer(value)
            case Counting():
                return count(term.name, tuple(self.linear(a) for a in term.arguments))
            case Symbol():
                index = tuple(self.index(term, i) for i in term.index)
                if index in term.declaration.apart:
                    member = term.declaration.name.latex(index)
                    raise IllFormed(TypeCode.MEMBER_DECLARED_APART(member=member, name=term.declaration.name))
                arguments = tuple(self.term(a) for a in term.arguments)
                if index == term.index and _same(arguments, term.arguments):
                    return term
                return symbol(term.declaration, index, arguments)
            case Derivative():
                body, order = self.term(term.body), self.linear(term.order)
                if order == Linear(0):
                    return body
                return term if body is term.body and order == term.order else derivative(body, order)
            case Power():
                base, exponent = self.term(term.base), self.linear(term.exponent)
                if base is term.base and exponent == term.exponent:
                    return term
                return raised(base, exponent)
            case BigSum():
                return self._big_sum(term)
        return with_children(term, self.term)

    def linear(self, value: Linear) -> Linear:
        return value.substitute(self.values)

    def index(self, owner: Symbol, value: Linear) -> Linear:
        value = self.linear(value)
        if value.is_number and value.constant < 0:
            raise IllFormed(TypeCode.NEGATIVE_INDEX(name=owner.declaration.name, value=value))
        return value

    def _big_sum(self, term: BigSum) -> Term:
        upper = self.linear(term.upper)
        lower = None if term.lower is None else self.linear(term.lower)
        if upper.is_number and (lower is None or lower.is_number):
            addends = [
                Instantiation({**self.values, **values}).term(term.body)
                for values in _sum_values(term.variables, lower, upper)
            ]
            if not addends:
                return zero(Instantiation(self.values).without(term.variables).term(term.body).type)
            return addends[0] if len(addends) == 1 else apply("add", *addends)
        return self._symbolic_sum(term, lower, upper)

    def _symbolic_sum(self, term: BigSum, lower: Linear | None, upper: Linear) -> Term:
        taken = set().union(*(value.variables for value in self.values.values()), term.variables)
        inner = self.without(term.variables)
        variables = list(term.variables)
        values = dict(inner.values)
        for place, name in enumerate(variables):
            if any(name in value.variables for value in values.values()):
                fresh = next((letter for letter in _FRESH if letter not in taken), None)
                if fresh is None:
                    raise IllFormed(TypeCode.NO_LETTER_LEFT(name=name))
                taken.add(fresh)
                values[name] = Linear.variable(fresh)
                variables[place] = fresh
        body = Instantiation(values).term(term.body)
        if body is term.body and (lower, upper) == (term.lower, term.upper):
            return term
        return big_sum(variables, lower, upper, body)

    def without(self, names: tuple[str, ...]) -> Instantiation:
        return Instantiation({name: value for name, value in self.values.items() if name not in names})


def _same(new: tuple[Term, ...], old: tuple[Term, ...]) -> bool:
    return all(a is b for a, b in zip(new, old, strict=True))


def raised(base: Term, exponent: Linear) -> Term:
    """Returns base^exponent; x^0 and x^1 are evaluated, x^-n is the inverse of x^n."""
    if exponent == Linear(1) and not base.type.is_column:
        return base
    if exponent == Linear(0):
        is_number = base.type.kind in ("scalar", "quaternion") or base.type.is_column
        return number(1) if is_number else identity(base.type.with_dual(False))
    if exponent.is_number and exponent.constant < 0 and not base.type.is_column:
        return apply("inverse", raised(base, -exponent))
    return power(base, exponent)


def count(name: CountingName, arguments: tuple[Linear, ...]) -> Term:
    """Returns a factorial, binomial or multinomial; a number if all arguments are numbers."""
    if not all(argument.is_number for argument in arguments):
        return counting(name, *arguments)
    top, *parts = (int(argument) for argument in arguments)
    if top < 0:
        raise IllFormed(TypeCode.NEGATIVE_NUMBER(name=name, top=top))
    if top > MOST_COUNTED:
        raise IllFormed(TypeCode.NUMBER_TOO_LARGE(name=name, top=top, most=MOST_COUNTED))
    if name == "factorial":
        return number(factorial(top))
    if name == "binomial":
        value = comb(top, parts[0]) if parts[0] >= 0 else 0
    else:
        if sum(parts) != top or min(parts) < 0:
            raise IllFormed(TypeCode.MULTINOMIAL_PARTS(top=top, parts=parts))
        value = factorial(top)
        for part in parts:
            value //= factorial(part)
    return number(value) if value else zero()


def _sum_values(
    variables: tuple[str, ...], lower: Linear | None, upper: Linear
) -> Iterator[dict[str, Linear]]:
    """Yields the values of the summation variables, in increasing order."""
    total = int(upper)
    if lower is not None:
        addends = total - int(lower) + 1
    else:
        addends = comb(total + len(variables) - 1, len(variables) - 1) if total >= 0 else 0
    if addends > LARGEST:
        raise IllFormed(TypeCode.TOO_MANY_ADDENDS(addends=addends, most=LARGEST))
    if lower is not None:
        (name,) = variables
        yield from ({name: Linear(k)} for k in range(int(lower), total + 1))
    elif total >= 0:
        places = total + len(variables) - 1
        for bars in combinations(range(places), len(variables) - 1):
            edges = (-1, *bars, places)
            parts = (edges[i + 1] - edges[i] - 1 for i in range(len(variables)))
            yield {name: Linear(part) for name, part in zip(variables, parts, strict=True)}


def free_integers(term: Term) -> frozenset[str]:
    """Returns the free integer variables of the term, without those that its sums bind."""
    names = frozenset().union(*(free_integers(child) for child in term.children))
    match term:
        case Symbol(index=index):
            return names.union(*(place.variables for place in index))
        case Derivative(order=order):
            return names | order.variables
        case Power(exponent=exponent):
            return names | exponent.variables
        case Counting(arguments=arguments):
            return names.union(*(argument.variables for argument in arguments))
        case Integer(value=value):
            return names | value.variables
        case BigSum(variables=bound, lower=lower, upper=upper):
            inner = names - frozenset(bound)
            return inner | upper.variables | (frozenset() if lower is None else lower.variables)
    return names
