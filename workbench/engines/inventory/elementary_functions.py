"""Exponentials, logarithms, powers and inverse functions of angles, of scalars, replaced by symbols.

A symbol F stands for f(u, v, …). What is known of it: its derivative, Ḟ = Σ ∂f/∂u u̇, and equations such as
F³ = u of u^{1/3}. What holds for all such F holds for the functions; the rest is decided at real points.

    e^{2x + xy/3} = (e^x)² e^{xy/3}     each product has a symbol E = e^{p/n}, which is not 0
    ln (u² v) = 2 ln u + ln v           for u > 0
    u^v = e^{v ln u}                    where u > 0
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import lcm
from typing import NamedTuple

from workbench.core.construct import apply, derivative, number, power, relation, symbol, with_children, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import raised
from workbench.core.names import Name
from workbench.core.operations import PARTIALS
from workbench.core.terms import Apply, Derivative, Head, Number, Power, Relation, Statement, Symbol, Term
from workbench.core.types import SCALAR, Declaration
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.engines.inventory.angle_combinations import sum_of_products
from workbench.engines.inventory.functions_of_scalars import FUNCTIONS, ONE, over
from workbench.language.definitions import expand, number_behind
from workbench.language.printing.printer import to_latex

#: Highest order of the derivatives, and largest power, of an exponential.
_HIGHEST, _LARGEST = 4, 20
#: Largest number whose prime factors are looked for.
_FACTORED = 10**6


class Value(NamedTuple):
    """f(u, …), which a symbol stands for.   slopes: ∂f/∂u."""

    head: Head
    arguments: tuple[Term, ...]
    slopes: tuple[Term, ...]

    def slope(self, of: Callable[[Term], Term]) -> Term:
        """Returns Σ ∂f/∂u of(u)."""
        pairs = zip(self.arguments, self.slopes, strict=True)
        return _total(apply("mul", of(u), slope) for u, slope in pairs)


@dataclass(frozen=True)
class Replaced:
    """relation: with symbols for functions.   supposed: the known statements about these symbols.
    values: what each symbol stands for.   domain: terms that are > 0 where all functions are
    defined.   varied: True if the relation has partial derivatives."""

    relation: Relation
    supposed: tuple[Statement, ...]
    values: Mapping[Symbol, Value]
    domain: tuple[Term, ...]
    varied: bool

    @property
    def only_exponentials(self) -> bool:
        return all(value.head == "exp" for value in self.values.values()) and not self.domain


def holds_functions(said: Relation, definitions: Lookup) -> bool:
    return any(_is_elementary(part) for part in reached(definitions, said.left, said.right))


def holds_roots(said: Relation, definitions: Lookup) -> bool:
    """True if there is a root of a real scalar, or a function whose slope has one."""
    parts = reached(definitions, said.left, said.right)
    return any(_is_root(part) or _is_arc(part) for part in parts)


def without_functions(said: Relation, definitions: Lookup, roots: bool = False) -> Replaced:
    """Returns the relation without elementary functions.

    roots: True to replace √u by u^{1/2}, too. Raises NotExact for powers and derivatives beyond the limits.
    """
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    variables = _differentiated_by(sides)
    varied = [each for each in variables if each.type == SCALAR]
    by = frozenset(symbol for each in variables for symbol in each.symbols())
    made = _Pass(definitions, by, roots, {}, ())
    for _ in range(2):  # for what is positive, and for the sizes
        made.all(sides)
        made = _Pass(definitions, by, roots, made.sizes, made.domain)
    (left, right), circles = made.all(sides)
    highest = max(map(derivative_order, sides))
    if highest > _HIGHEST:
        raise NotExact(f"a derivative of order {highest} of an exponential")
    supposed: list[Statement] = []
    for own, value in made.values.items():
        supposed += made.laws.get(own, [])
        supposed += _rates(own, value, highest)
        supposed += _slopes(own, value, [by for by in varied if by in own.declaration.of])
    supposed += circles
    domain = tuple(dict.fromkeys(made.domain))
    return Replaced(relation("=", left, right), tuple(supposed), made.values, domain, bool(varied))


def _rates(own: Symbol, value: Value, highest: int) -> Iterator[Statement]:
    rate = value.slope(lambda u: derivative(u, 1))
    for order in range(highest):
        known = derivative(rate, order) if order else rate
        yield relation("=", derivative(own, order + 1), known)


def _slopes(own: Symbol, value: Value, varied: Sequence[Term]) -> Iterator[Statement]:
    for by in varied:
        known = value.slope(lambda u, by=by: apply("partial", u, by))  # type: ignore[misc]
        yield relation("=", apply("partial", own, by), known)
        for again in varied:
            twice = apply("partial", apply("partial", own, by), again)
            yield relation("=", twice, apply("partial", known, again))


def _is_root(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "root" and term.type == SCALAR


def _is_arc(term: Term) -> bool:
    return isinstance(term, Apply) and term.head in ("arcsin", "arccos")


def _is_elementary(term: Term) -> bool:
    is_function = isinstance(term, Apply) and (term.head in FUNCTIONS or term.head == "pow")
    return is_function and term.type == SCALAR


class _Pass:
    """One pass over the sides.

    varied: the variables of partial derivatives. If there are any, a function's value is one of the
    coordinates of its arguments.   sizes: the common denominator of the coefficients of each product in
    exponents.   positive: the terms that are known to be > 0."""

    def __init__(
        self,
        definitions: Lookup,
        varied: Collection[Symbol],
        roots: bool,
        sizes: dict[tuple[Term, ...], int],
        positive: Sequence[Term],
    ) -> None:
        self.definitions, self.varied, self.roots = definitions, varied, roots
        self.sizes, self.positive = sizes, positive
        self.values: dict[Symbol, Value] = {}
        self.laws: dict[Symbol, list[Statement]] = {}
        self.domain: list[Term] = []
        self.known: dict[object, Symbol] = {}
        self.done: dict[int, tuple[Term, Term]] = {}

    def all(self, sides: Sequence[Term]) -> tuple[list[Term], list[Statement]]:
        """Returns the sides without functions, and what the cosines and sines of inverse functions in them
        are."""
        replaced = [self.term(side) for side in sides]
        arcs = [own for own, value in self.values.items() if FUNCTIONS[value.head].circle is not None]
        parts = (part for side in replaced for part in side.walk())
        inside = [part for part in parts if isinstance(part, Apply) and part.head in ("sin", "cos")]
        is_turned = any(own in part.walk() for part in inside for own in arcs)
        return replaced, [each for own in arcs for each in self._circle(own)] if is_turned else []

    def term(self, term: Term) -> Term:
        if id(term) not in self.done:
            is_function = (self.roots and _is_root(term)) or _is_elementary(term)
            new = self._function(term) if is_function else with_children(term, self.term)
            self.done[id(term)] = term, new
        return self.done[id(term)][1]

    def _function(self, term: Term) -> Term:
        assert isinstance(term, Apply), "a function"
        match term:
            case Apply(head="exp", arguments=(exponent,)):
                return self._power(self.term(exponent))
            case Apply(head="pow", arguments=(base, exponent)):
                self.domain.append(self.term(base))
                return self._power(apply("mul", self.term(exponent), self._logarithm(base)))
            case Apply(head="log", arguments=(inside,)):
                self.domain.append(self.term(inside))
                return self._logarithm(inside)
            case Apply(head="root", arguments=(inside,)):
                self.domain.append(self.term(inside))
                return self._power(apply("mul", number(Fraction(1, 2)), self._logarithm(inside)))
        arguments = [self.term(child) for child in term.arguments]
        self.domain += FUNCTIONS[term.head].domain(arguments)
        return self._own(apply(term.head, *arguments), (term.head, *map(self._key, arguments)))

    def _key(self, term: Term) -> object:
        return frozenset(sum_of_products(term, self.definitions).items())

    def _logarithm(self, term: Term) -> Term:
        """Returns ln term, as a sum over the factors that are known to be positive, and over the rest."""
        addends: list[Term] = []
        rest: Term = ONE
        for factor, count in self._factors(term):
            if isinstance(factor, Number):
                rest = apply("mul", rest, number(-1)) if factor.value < 0 else rest
                primes = _primes(abs(factor.value))
                addends += [apply("mul", number(n * count), self._log_of(number(p))) for p, n in primes]
            elif isinstance(factor, Apply) and factor.head == "exp":
                addends.append(apply("mul", number(count), factor.arguments[0]))
            elif self._is_positive(factor):
                addends.append(apply("mul", number(count), self._log_of(factor)))
            elif count.denominator == 1:
                rest = apply("mul", rest, raised(factor, Linear(int(count))))
            else:
                raise NotExact("the root of a factor whose sign is not known")
        if rest != ONE:
            addends.append(self._log_of(rest))
        return _total(addends)

    def _is_positive(self, factor: Term) -> bool:
        if isinstance(factor, Symbol) and number_behind(factor) != factor:
            self.domain.append(factor)  # the root of a positive number may be taken as positive
            return True
        return factor in self.positive or (isinstance(factor, Apply) and factor.head == "norm")

    def _factors(self, term: Term) -> Iterator[tuple[Term, Fraction]]:
        """Yields the factors of the term with their exponents; e^x as an exponential."""
        match term:
            case Apply(head="mul", arguments=factors):
                for factor in factors:
                    yield from self._factors(factor)
            case Apply(head="div", arguments=(above, below)):
                yield from self._factors(above)
                yield from _raised(self._factors(below), Fraction(-1))
            case Apply(head="neg", arguments=(inside,)):
                yield number(-1), Fraction(1)
                yield from self._factors(inside)
            case Apply(head="inverse", arguments=(inside,)):
                yield from _raised(self._factors(inside), Fraction(-1))
            case Apply(head="root", arguments=(inside,)):
                self.domain.append(self.term(inside))
                yield from _raised(self._factors(inside), Fraction(1, 2))
            case Power(base=base, exponent=exponent) if base.type == SCALAR and exponent.is_number:
                yield from _raised(self._factors(base), Fraction(int(exponent)))
            case Apply(head="exp", arguments=(exponent,)) if term.type == SCALAR:
                yield apply("exp", self.term(exponent)), Fraction(1)
            case Apply(head="pow", arguments=(base, exponent)):
                self.domain.append(self.term(base))
                yield apply("exp", apply("mul", self.term(exponent), self._logarithm(base))), Fraction(1)
            case _:
                yield from self._products(self.term(term))

    def _products(self, term: Term) -> Iterator[tuple[Term, Fraction]]:
        """Yields the factors of a scalar without functions; of a sum its first coefficient and the rest."""
        products = sorted(sum_of_products(term, self.definitions).items(), key=lambda item: repr(item[0]))
        if len(products) == 1:
            ((factors, coefficient),) = products
            yield number(coefficient), Fraction(1)
            yield from ((factor, Fraction(1)) for factor in factors)
        elif products:
            size = abs(products[0][1])
            yield number(size), Fraction(1)
            yield (term if size == 1 else apply("mul", number(1 / size), term)), Fraction(1)
        else:
            yield number(0), Fraction(1)

    def _log_of(self, term: Term) -> Symbol:
        return self._own(apply("log", term), ("log", self._key(term)))

    def _power(self, exponent: Term) -> Term:
        result: Term = ONE
        for factors, coefficient in sum_of_products(exponent, self.definitions).items():
            size = self.sizes[factors] = lcm(self.sizes.get(factors, 1), coefficient.denominator)
            count = coefficient * size
            if abs(count) > _LARGEST:
                raise NotExact(f"the power {count} of an exponential")
            if count:
                result = apply("mul", result, raised(self._base(factors, size), Linear(int(count))))
        return result

    def _base(self, factors: tuple[Term, ...], size: int) -> Term:
        """Returns e^{factors/size}: of ln u the root of u."""
        under = self._under_logarithm(factors)
        if under is not None and size == 1:
            return under
        exponent = _exponent(factors, size)
        own = self._own(apply("exp", exponent), ("exp", factors, size))
        laws: list[Statement] = [relation("≠", own, zero())]
        if under is not None:
            laws.append(relation("=", power(own, size), under))
        self.laws.setdefault(own, laws)
        return own

    def _under_logarithm(self, factors: tuple[Term, ...]) -> Term | None:
        """Returns u of the factor ln u alone, which is positive; else None."""
        value = self.values.get(factors[0]) if len(factors) == 1 and isinstance(factors[0], Symbol) else None
        return value.arguments[0] if value is not None and value.head == "log" else None

    def _own(self, value: Term, key: object) -> Symbol:
        assert isinstance(value, Apply), "a function"
        if key not in self.known:
            is_exponential = value.head == "exp"
            name = f"e^{{{to_latex(value.arguments[0])}}}" if is_exponential else to_latex(value)
            of = self._coordinates(value.arguments) if self.varied else ()
            constant = all(map(self._is_number, value.symbols()))
            own = Declaration(Name(name, of=value.arguments), SCALAR, Linear(0), of=of).with_flags(
                constant=constant
            )
            made = self.known[key] = symbol(own)
            self.values[made] = Value(value.head, value.arguments, ())
            slopes = tuple(map(self.term, FUNCTIONS[value.head].slopes(value.arguments, made)))
            self.values[made] = self.values[made]._replace(slopes=slopes)
        return self.known[key]

    def _is_number(self, part: Symbol) -> bool:
        """True if the symbol stands for a function of numbers, as ln 3."""
        return part in self.values and part.declaration.constant

    def _coordinates(self, arguments: Sequence[Term]) -> tuple[Symbol, ...]:
        """Returns the coordinates of the arguments if all are functions of coordinates only, else ()."""
        found: list[Symbol] = []
        for part in (part for argument in arguments for part in argument.walk()):
            if isinstance(part, Derivative) or (part in self.varied and part.type != SCALAR):
                return ()
            if isinstance(part, Symbol) and (part in self.varied or not part.declaration.constant):
                own = part.declaration
                if not (own.independent or own.of or part in self.varied):
                    return ()
                found += own.of or (part,)
        return tuple(dict.fromkeys(found))

    def _circle(self, own: Symbol) -> Iterator[Statement]:
        """Yields what the cosine and the sine of the value of an inverse function are; may add values."""
        value = self.values[own]
        of = FUNCTIONS[value.head].circle
        assert of is not None, "an inverse function"
        cosine, sine, length = map(self.term, of(value.arguments))
        yield relation("=", apply("cos", own), over(cosine, length))
        yield relation("=", apply("sin", own), over(sine, length))


def _total(parts: Iterable[Term]) -> Term:
    found = list(parts)
    return found[0] if len(found) == 1 else apply("add", *found) if found else zero()


def _raised(factors: Iterable[tuple[Term, Fraction]], by: Fraction) -> Iterator[tuple[Term, Fraction]]:
    return ((factor, count * by) for factor, count in factors)


def _primes(value: Fraction) -> Iterator[tuple[int, int]]:
    """Yields the prime factors of a number with their counts, negative ones for the denominator's."""
    for whole, sign in ((value.numerator, 1), (value.denominator, -1)):
        if not 0 < whole <= _FACTORED:
            raise NotExact("the logarithm of 0 or of a number of many digits")
        prime = 2
        while whole > 1:
            count = 0
            while whole % prime == 0:
                whole, count = whole // prime, count + 1
            if count:
                yield prime, sign * count
            prime += 1


def _exponent(factors: tuple[Term, ...], size: int) -> Term:
    parts = factors if size == 1 and factors else (number(Fraction(1, size)), *factors)
    return reduce(lambda one, other: apply("mul", one, other), parts)


def _differentiated_by(sides: Sequence[Term]) -> list[Term]:
    """Returns the variables of the partial derivatives."""
    parts = [part for side in sides for part in side.walk()]
    found = (p.arguments[1] for p in parts if isinstance(p, Apply) and p.head in PARTIALS)
    return list(dict.fromkeys(found))


def derivative_order(term: Term) -> int:
    """Returns the nesting depth of time derivatives in the term, counted with their orders."""
    if isinstance(term, Derivative) and not term.order.is_number:
        raise NotExact("a derivative of order n of an exponential")
    own = int(term.order) if isinstance(term, Derivative) else 0
    return own + max(map(derivative_order, term.children), default=0)
