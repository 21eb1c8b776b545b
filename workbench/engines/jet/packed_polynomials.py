"""SymPy's polynomials in many indeterminates, as polynomials in one.

Indeterminate number i stands as x^(2^(w i)), and so a monomial as one integer, whose digits of w bits are its
powers: to multiply two monomials is to add two integers. As long as every power is below 2^w, this takes sums
to sums and products to products, and different polynomials to different ones. The first bit of each digit is
kept 0, so that the digits of two such integers have a sum without a carry: `normal` and `checked` refuse a
polynomial in which it is not, and no product is multiplied again before one of them has seen it.
"""

from __future__ import annotations

from functools import cache, reduce
from operator import lshift, or_
from typing import Any

from workbench.engines.inventory.inventory import NotExact
from workbench.engines.jet.sympy_gate import QQ, ZZ, PolyElement, PolyRing, lex, polynomial_ring

#: The bits of a power.
WIDTH = 16
_DIGIT = (1 << WIDTH) - 1


class PackedPolynomials:
    """Polynomials in as many indeterminates as are made, known by their places; the last one ranks highest.
    Some of them have a square that is rewritten."""

    def __init__(self) -> None:
        self.integers, _ = polynomial_ring("x", ZZ, lex)
        self.rationals: PolyRing = self.integers.clone(domain=QQ)
        self.generators: list[PolyElement] = []
        self.squares: dict[int, PolyElement] = {}
        self._tops = self._ones = 0
        self._large = 0  # what no monomial of a normal form meets

    def make(self) -> int:
        """The place of a new indeterminate."""
        place = len(self.generators)
        one = 1 << WIDTH * place
        self.generators.append(self._power(place, 1))
        self._ones |= one
        self._tops |= one << WIDTH - 1
        self._large |= one << WIDTH - 1
        return place

    def _power(self, place: int, exponent: int) -> PolyElement:
        return self.integers.from_dict({(exponent << WIDTH * place,): ZZ(1)})

    def set_square(self, place: int, square: PolyElement) -> None:
        """Has the square of a generator rewritten; in that none may occur whose square is not set yet, if it
        ever is."""
        self.squares[place] = square
        self._large |= (_DIGIT - 1) << WIDTH * place

    @property
    def relations(self) -> list[PolyElement]:
        """What vanishes: generator² − square."""
        return [self._power(place, 2) - square for place, square in self.squares.items()]

    def normal(self, p: PolyElement) -> PolyElement:
        """The remainder by the relations, which are a Gröbner basis (see `differential_ring.py`): squares are
        rewritten from the last one set to the first. Raises NotExact where a power grows too high."""
        met = _met(p)
        if not met & self._large:
            return p
        p = self.checked(p)
        for place in reversed(self.squares):
            if met >> WIDTH * place & (_DIGIT - 1):
                p = self.rewritten(p, place, 2, self.squares[place].set_ring(p.ring))
                met = _met(p)
        return p

    def checked(self, p: PolyElement) -> PolyElement:
        """The polynomial, fit to be multiplied again; raises NotExact where a power is too high."""
        if _met(p) & self._tops:
            raise NotExact(f"a power of {1 << (WIDTH - 1)} or more")
        return p

    def rewritten(
        self, p: PolyElement, place: int, power: int, value: PolyElement, over: PolyElement | None = None
    ) -> PolyElement:
        """p with each x^power replaced by the value, x being the indeterminate at that place; over: a divisor
        of the value, with as high a power of which p is multiplied as that takes."""
        shift = WIDTH * place
        parts: dict[int, dict[tuple[int], Any]] = {}
        for (powers,), coefficient in p.items():
            times = (powers >> shift & _DIGIT) // power
            parts.setdefault(times, {})[(powers - (times * power << shift),)] = coefficient
        total, below = p.ring.zero, p.ring.one
        for times in range(max(parts, default=0), -1, -1):
            part = p.new(parts.get(times, ()))
            total = self.checked(total * value) + (part if over is None else self.checked(part * below))
            below = below if over is None else self.checked(below * over)
        return total

    def slope(self, p: PolyElement, place: int) -> PolyElement | None:
        """c of p = c x + r, neither of which holds x; None where p has a higher power of x, or none."""
        shift = WIDTH * place
        if any(self._at(place, powers) > 1 for (powers,) in p):
            return None
        terms = {(e - (1 << shift),): c for (e,), c in p.items() if self._at(place, e)}
        return p.new(terms) if terms else None

    def _at(self, place: int, powers: int) -> int:
        return powers >> WIDTH * place & _DIGIT

    def places(self, p: PolyElement) -> set[int]:
        """The places of the indeterminates in a polynomial."""
        return self._places(_met(p))

    def odd_places(self, p: PolyElement) -> set[int]:
        """The places of those that are there with an odd power."""
        return self._places(reduce(or_, (powers & self._ones for (powers,) in p), 0))

    def _places(self, powers: int) -> set[int]:
        return {place for place in range(len(self.generators)) if self._at(place, powers)}

    def is_alone(self, place: int, p: PolyElement) -> bool:
        """Whether a polynomial holds the indeterminate in one term, c · x."""
        (x,) = self.generators[place]
        return x in p and sum(self._at(place, powers) > 0 for (powers,) in p) == 1

    def spread(self, p: PolyElement, ring: PolyRing) -> PolyElement:
        """The polynomial in a ring like `many`."""
        falling = range(len(self.generators) - 1, -1, -1)
        terms = {tuple(self._at(place, e) for place in falling) or (0,): c for (e,), c in p.items()}
        return ring.from_dict(terms, p.ring.domain)

    def packed(self, p: PolyElement) -> PolyElement:
        """The reverse of `spread`, over the rationals."""
        shifts = range(WIDTH * len(self.generators) - WIDTH, -1, -WIDTH) or [0]
        terms = {(sum(map(lshift, powers, shifts)),): c for powers, c in p.items()}
        return self.rationals.from_dict(terms)

    @property
    def many(self) -> PolyRing:
        """The polynomials over ℚ with an indeterminate for each: what SymPy divides and factors."""
        return _rational_polynomials(len(self.generators))

    def factors(self, p: PolyElement) -> list[tuple[PolyElement, int]]:
        """Over the rationals, with their powers; without the number before them."""
        return [(self.packed(q), power) for q, power in self.spread(p, self.many).factor_list()[1]]


def _met(p: PolyElement) -> int:
    """The bits that some monomial has."""
    met = 0
    for (powers,) in p:
        met |= powers
    return met


@cache
def _rational_polynomials(count: int) -> PolyRing:
    return polynomial_ring([f"y{i}" for i in range(count)] or "y", QQ, lex)[0]
