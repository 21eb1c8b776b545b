"""Polynomials over ℚ with a derivation d/dt, in FLINT: the ring of the polynomial engine.

Every derivative of a free function is an indeterminate, and d/dt maps each to the next. Sines and cosines,
unit vectors, rotations (as unit quaternions) and norms are indeterminates with one relation each,

    s² = 1 − c²,   u₀² = 1 − u₁² − u₂²,   q₀² = 1 − q₁² − q₂² − q₃²,   N² = x·x,

whose leading squares are powers of different indeterminates. By Buchberger's first criterion such relations
are a Gröbner basis in a lexicographic order that ranks each squared indeterminate above those of its right
side. The remainder modulo them is therefore a normal form: 0 exactly for the polynomials that vanish modulo
them. A reciprocal 1/d is an indeterminate z with z·d = 1, cleared at the end.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from functools import cache, partial

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

Polynomial = fmpq_mpoly
Derivation = Callable[[Polynomial], Polynomial]


class DifferentialRing:
    """The ring over a list of generator names, highest rank first. `derive_as` sets the time derivative of a
    generator, `square_as` its square."""

    def __init__(self, names: Sequence[str]) -> None:
        self._context = fmpq_mpoly_ctx.get(tuple(names), Ordering.lex)
        self.names = tuple(names)
        self.generators = dict(zip(names, self._context.gens(), strict=True))
        self.zero = self._context.constant(0)
        self.one = self._context.constant(1)
        self._rates: dict[int, Polynomial] = {}
        self._followers: dict[int, Callable[[Derivation], Polynomial]] = {}
        self._places = {name: place for place, name in enumerate(names)}
        self._squares: dict[str, Polynomial] = {}
        self._reciprocals: list[tuple[str, Polynomial]] = []
        self._removable = False
        self._divided: set[str] = set()
        self._partials = {name: partial(self.partial, name=name) for name in names}

    def constant(self, value: Fraction | int) -> Polynomial:
        value = Fraction(value)
        return self._context.constant(fmpq(value.numerator, value.denominator))

    def number(self, p: Polynomial) -> Fraction:
        """Returns a constant polynomial as a fraction."""
        if not p.is_constant():
            raise ValueError("expected a constant polynomial")
        value = fmpq(0) if p.is_zero() else p.leading_coefficient()
        return Fraction(int(value.p), int(value.q))

    def derive_as(self, name: str, rate: Polynomial) -> None:
        """Sets the time derivative of a generator; a generator without one must not be differentiated."""
        self._rates[self._places[name]] = rate

    def derive_by(self, name: str, chain: Callable[[Derivation], Polynomial]) -> None:
        """Sets the derivative of a generator that stands for a function of others, for any derivation of
        these."""
        self._followers[self._places[name]] = cache(chain)

    def square_as(self, name: str, value: Polynomial) -> None:
        """Sets name² = value. `value` must not contain `name`, and its generators must rank below it."""
        self._squares[name] = value

    def derive(self, p: Polynomial) -> Polynomial:
        """Returns dp/dt by the chain rule over the generators that occur in p."""
        rate = self.zero
        for place, degree in enumerate(p.degrees()):
            if degree > 0:
                if place in self._followers:
                    follows = self._followers[place](self.derive)
                elif place in self._rates:
                    follows = self._rates[place]
                else:
                    raise ValueError(f"{self.names[place]} was not given a time derivative")
                rate = rate + p.derivative(place) * follows
        return self.reduce(rate)

    def partial(self, p: Polynomial, name: str) -> Polynomial:
        """Returns ∂p/∂name, including norms and reciprocals that depend on it; `name` must have no square
        relation."""
        rate = p.derivative(self._places[name])
        for place, chain in tuple(self._followers.items()):
            if p.degrees()[place] > 0:
                rate = rate + p.derivative(place) * chain(self._partials[name])
        return self.reduce(rate)

    def reduce(self, p: Polynomial) -> Polynomial:
        """Returns the normal form modulo the square relations."""
        while high := self._squared_in(p):
            for name in high:
                p = divmod(p, self.generators[name] ** 2 - self._squares[name])[1]
        return p

    def _squared_in(self, p: Polynomial) -> list[str]:
        degrees = p.degrees() if self._squares else ()
        return [name for name in self._squares if degrees[self._places[name]] > 1]

    def reciprocal(self, d: Polynomial, spare: Sequence[str]) -> tuple[Polynomial, Fraction]:
        """Returns (z, factor) with 1/d = factor·z. Denominators that differ by a number share one z. `spare`
        names the generators reserved for reciprocals."""
        if d.is_zero():
            raise ZeroDivisionError("division by an expression that is identically zero")
        leading = d.leading_coefficient()
        if d.is_constant():
            return self.one, Fraction(int(leading.q), int(leading.p))
        monic = d / leading
        factor = Fraction(int(leading.q), int(leading.p))
        for name, known in self._reciprocals:
            if known == monic:
                if not self._removable:
                    self._divided.add(name)
                return self.generators[name], factor
        name = spare[len(self._reciprocals)]
        self._reciprocals.append((name, monic))
        if not self._removable:
            self._divided.add(name)
        z = self.generators[name]
        self.derive_by(name, lambda derivation: -(z**2) * derivation(monic))
        return z, factor

    @contextmanager
    def removable(self) -> Iterator[None]:
        """Marks divisors in this context as removable singularities: the quotients are analytic where the
        divisor vanishes, as sin x / x is at 0. An identity that holds near such a point therefore holds
        there. Equations may leave no point near it."""
        outer, self._removable = self._removable, True
        yield
        self._removable = outer

    @property
    def squared(self) -> frozenset[str]:
        """The generators with a square relation, and those in its right side."""
        bound = set(self._squares)
        for value in self._squares.values():
            bound |= {self.names[i] for i, degree in enumerate(value.degrees()) if degree > 0}
        return frozenset(bound)

    @property
    def square_names(self) -> frozenset[str]:
        """The generators with a square relation."""
        return frozenset(self._squares)

    def square_of(self, p: Polynomial) -> Polynomial:
        """Returns p² in normal form if p is a single generator with a square relation, such as a norm; else
        p."""
        for name, value in self._squares.items():
            if p == self.generators[name]:
                return value
        return p

    @property
    def denominators(self) -> tuple[Polynomial, ...]:
        """The divisors of non-analytic quotients, up to numbers, in normal form."""
        return tuple(d for name, d in self._reciprocals if name in self._divided)

    @property
    def limits(self) -> tuple[Polynomial, ...]:
        """The divisors of analytic quotients, which are limits where the divisor vanishes."""
        return tuple(d for name, d in self._reciprocals if name not in self._divided)

    @property
    def relations(self) -> tuple[Polynomial, ...]:
        """The square relations as polynomials that are 0."""
        return tuple(self.generators[name] ** 2 - value for name, value in self._squares.items())

    def clear(self, p: Polynomial) -> Polynomial:
        """Returns p times powers of the denominators such that no reciprocal is left.

        It is 0 exactly if p is, where no denominator vanishes. A later reciprocal can contain earlier ones,
        so the last one is cleared first.
        """
        for name, d in reversed(self._reciprocals):
            if p.degrees()[self._places[name]] <= 0:
                continue
            rows = []  # by rising power of the reciprocal
            while not p.is_zero():
                p, row = divmod(p, self.generators[name])
                rows.append(row)
            for row in rows:
                p = p * d + row
            p = self.reduce(p)
        return p

    @property
    def reciprocals(self) -> Sequence[tuple[str, Polynomial]]:
        """The generators that stand for 1/d with their d, in order of creation."""
        return self._reciprocals

    def at(self, p: Polynomial, values: dict[str, Fraction]) -> Fraction:
        """Returns the value of p at a rational point; every generator of p must have a value."""
        used = {self.names[i] for i, degree in enumerate(p.degrees()) if degree > 0}
        if missing := used - values.keys():
            raise ValueError(f"no value for {', '.join(sorted(missing))}")
        point = [values.get(name, Fraction(0)) for name in self.names]
        result = p(*(fmpq(v.numerator, v.denominator) for v in point))
        return Fraction(int(result.p), int(result.q))
