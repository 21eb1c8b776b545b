"""Exponentials e^x of scalars, replaced by symbols with known derivatives that are not 0.

In e^{2x + xy/3} the exponent is a sum of products of scalars. Each product p has a symbol E = e^{p/n} with Ė
= ṗ E/n. What holds for all such E holds for exponentials, and e^x e^y = e^{x+y} becomes a law of powers. A
statement that fails for some E may still hold for exponentials: it is refuted only at E = e^{p/n}.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import lcm
from typing import NamedTuple

from workbench.core.construct import apply, derivative, number, rebuild, relation, symbol, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import raised
from workbench.core.names import Name
from workbench.core.operations import PARTIALS
from workbench.core.terms import Apply, Derivative, Relation, Statement, Symbol, Term
from workbench.core.types import SCALAR, Declaration
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.angle_combinations import Sum, sum_of_products, trigonometric_terms
from workbench.language.definitions import Lookup, expand
from workbench.language.printing.printer import to_latex

#: Highest order of the derivatives, and largest power, of an exponential.
_HIGHEST, _LARGEST = 4, 20


class Exponentials(NamedTuple):
    """relation: with symbols for exponentials.   supposed: the known statements about these symbols.
    exponents: the exponent of each symbol.   varied: True if the relation has partial derivatives."""

    relation: Relation
    supposed: tuple[Statement, ...]
    exponents: Mapping[Symbol, Term]
    varied: bool


def holds_exponentials(said: Relation, definitions: Lookup) -> bool:
    return any(map(_is_exponential, trigonometric_terms((said.left, said.right), definitions, set())))


def without_exponentials(said: Relation, definitions: Lookup) -> Exponentials:
    """Returns the relation without exponentials. Raises NotExact for powers and derivatives beyond the
    limits."""
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    sizes: dict[tuple[Term, ...], int] = {}
    varied = _differentiated_by(sides)
    _Pass(sizes, bool(varied)).all(sides, definitions)
    made = _Pass(sizes, bool(varied))
    left, right = made.all(sides, definitions)
    highest = max(map(_order, sides))
    if highest > _HIGHEST:
        raise NotExact(f"a derivative of order {highest} of an exponential")
    supposed: list[Statement] = []
    for factors, own in made.symbols.items():
        supposed.append(relation("≠", own, zero()))
        rate = apply("mul", derivative(_exponent(factors, sizes[factors]), 1), own)
        for order in range(highest):
            known = derivative(rate, order) if order else rate
            supposed.append(relation("=", derivative(own, order + 1), known))
        slopes = [by for by in varied if by in own.declaration.of]
        for by in slopes:
            known = apply("mul", own, apply("partial", _exponent(factors, sizes[factors]), by))
            supposed.append(relation("=", apply("partial", own, by), known))
            for again in slopes:
                twice = apply("partial", apply("partial", own, by), again)
                supposed.append(relation("=", twice, apply("partial", known, again)))
    exponents = {own: _exponent(factors, sizes[factors]) for factors, own in made.symbols.items()}
    return Exponentials(relation("=", left, right), tuple(supposed), exponents, bool(varied))


def _is_exponential(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "exp" and term.type == SCALAR


class _Pass:
    """One pass over the sides.

    sizes: the common denominator of the coefficients of each product in exponents.
    varied: True if there is a partial derivative, so that an exponential is a function of the coordinates of
    its exponent."""

    def __init__(self, sizes: dict[tuple[Term, ...], int], varied: bool) -> None:
        self.sizes, self.varied = sizes, varied
        self.symbols: dict[tuple[Term, ...], Symbol] = {}
        self.done: dict[int, Term] = {}

    def all(self, sides: Sequence[Term], definitions: Lookup) -> list[Term]:
        return [self.term(side, definitions) for side in sides]

    def term(self, term: Term, definitions: Lookup) -> Term:
        if id(term) not in self.done:
            children = [self.term(child, definitions) for child in term.children]
            if _is_exponential(term):
                new = self.power(sum_of_products(children[0], definitions))
            else:
                same = all(a is b for a, b in zip(children, term.children, strict=True))
                new = term if same else rebuild(term, children)
            self.done[id(term)] = new
        return self.done[id(term)]

    def power(self, exponent: Sum) -> Term:
        result: Term = number(1)
        for factors, coefficient in exponent.items():
            size = self.sizes[factors] = lcm(self.sizes.get(factors, 1), coefficient.denominator)
            count = coefficient * size
            if abs(count) > _LARGEST:
                raise NotExact(f"the power {count} of an exponential")
            if count:
                result = apply("mul", result, raised(self.own(factors, size), Linear(int(count))))
        return result

    def own(self, factors: tuple[Term, ...], size: int) -> Symbol:
        if factors not in self.symbols:
            exponent = _exponent(factors, size)
            name = Name(f"e^{{{to_latex(exponent)}}}", of=(exponent,))
            of = _coordinates(factors) if self.varied else ()
            own = Declaration(name, SCALAR, Linear(0), of=of).with_flags(constant=not factors)
            self.symbols[factors] = symbol(own)
        return self.symbols[factors]


def _exponent(factors: tuple[Term, ...], size: int) -> Term:
    parts = factors if size == 1 and factors else (number(Fraction(1, size)), *factors)
    return reduce(lambda one, other: apply("mul", one, other), parts)


def _differentiated_by(sides: Sequence[Term]) -> list[Term]:
    """Returns the scalars that partial derivatives differentiate by."""
    parts = [part for side in sides for part in side.walk()]
    found = (p.arguments[1] for p in parts if isinstance(p, Apply) and p.head in PARTIALS)
    return list(dict.fromkeys(by for by in found if by.type == SCALAR))


def _coordinates(factors: Sequence[Term]) -> tuple[Symbol, ...]:
    """Returns the coordinates of the factors if all are functions of coordinates only, else ()."""
    found: list[Symbol] = []
    for part in (part for factor in factors for part in factor.walk()):
        if isinstance(part, Derivative):
            return ()
        if isinstance(part, Symbol) and not part.declaration.constant:
            own = part.declaration
            if not (own.independent or own.of):
                return ()
            found += own.of or (part,)
    return tuple(dict.fromkeys(found))


def _order(term: Term) -> int:
    """Returns the nesting depth of time derivatives in the term, counted with their orders."""
    if isinstance(term, Derivative) and not term.order.is_number:
        raise NotExact("a derivative of order n of an exponential")
    own = int(term.order) if isinstance(term, Derivative) else 0
    return own + max(map(_order, term.children), default=0)
