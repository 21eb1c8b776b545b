"""SymPy's polynomials in many indeterminates, packed as polynomials in one.

Indeterminate number i is x^(2^(w i)), so a monomial is one integer whose digits of w bits are its powers, and
the product of two monomials is the sum of two integers. As long as every power is below 2^w, packing
preserves sums and products and is injective. The first bit of each digit stays 0, so that the sum of two such
integers has no carry. `normal` and `checked` reject polynomials that violate this, and each product is
checked before it is multiplied again.
"""

from __future__ import annotations

from functools import cache, reduce
from operator import lshift, or_
from typing import Any

from workbench.engines.inventory import NotExact
from workbench.engines.jet.sympy_gate import QQ, ZZ, PolyElement, PolyRing, lex, polynomial_ring

#: The number of bits of a power.
WIDTH = 16
_DIGIT = (1 << WIDTH) - 1


class PackedPolynomials:
    """Polynomials in a growing list of indeterminates, identified by their positions; the last one ranks
    highest. The squares of some of them are rewritten."""

    def __init__(self) -> None:
        self.integers, _ = polynomial_ring("x", ZZ, lex)
        self.rationals: PolyRing = self.integers.clone(domain=QQ)
        self.generators: list[PolyElement] = []
        self.squares: dict[int, PolyElement] = {}
        self._tops = self._ones = 0
        self._large = 0  # mask of the squared generators; no normal form matches it

    def make(self) -> int:
        """Creates an indeterminate and returns its position."""
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
        """Sets the square of a generator. It may not contain a generator whose own square is set later."""
        self.squares[place] = square
        self._large |= (_DIGIT - 1) << WIDTH * place

    @property
    def relations(self) -> list[PolyElement]:
        """Returns the vanishing polynomials generator² − square."""
        return [self._power(place, 2) - square for place, square in self.squares.items()]

    def normal(self, p: PolyElement) -> PolyElement:
        """Returns the remainder modulo the relations, which are a Gröbner basis (see `differential_ring.py`).

        Squares are rewritten from the last one set to the first. Raises NotExact if a power is too high.
        """
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
        """Returns the polynomial if it can be multiplied again; raises NotExact if a power is too high."""
        if _met(p) & self._tops:
            raise NotExact(f"a power of {1 << (WIDTH - 1)} or more")
        return p

    def rewritten(
        self, p: PolyElement, place: int, power: int, value: PolyElement, over: PolyElement | None = None
    ) -> PolyElement:
        """Returns p with each x^power replaced by the value, where x is the indeterminate at the position
        `place`.

        over: a divisor of the value; p is multiplied by the power of it that clears it.
        """
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
        """Returns c of p = c x + r, neither of which contains x; None if x is missing or has a higher
        power."""
        shift = WIDTH * place
        if any(self._at(place, powers) > 1 for (powers,) in p):
            return None
        terms = {(e - (1 << shift),): c for (e,), c in p.items() if self._at(place, e)}
        return p.new(terms) if terms else None

    def _at(self, place: int, powers: int) -> int:
        return powers >> WIDTH * place & _DIGIT

    def places(self, p: PolyElement) -> set[int]:
        """Returns the positions of the indeterminates in a polynomial."""
        return self._places(_met(p))

    def odd_places(self, p: PolyElement) -> set[int]:
        """Returns the positions of the indeterminates that occur with an odd power."""
        return self._places(reduce(or_, (powers & self._ones for (powers,) in p), 0))

    def _places(self, powers: int) -> set[int]:
        return {place for place in range(len(self.generators)) if self._at(place, powers)}

    def is_alone(self, place: int, p: PolyElement) -> bool:
        """True if a polynomial contains the indeterminate in exactly one term, c · x."""
        (x,) = self.generators[place]
        return x in p and sum(self._at(place, powers) > 0 for (powers,) in p) == 1

    def spread(self, p: PolyElement, ring: PolyRing) -> PolyElement:
        """Returns a packed polynomial as an element of a ring with all generators, such as `many`."""
        falling = range(len(self.generators) - 1, -1, -1)
        terms = {tuple(self._at(place, e) for place in falling) or (0,): c for (e,), c in p.items()}
        return ring.from_dict(terms, p.ring.domain)

    def packed(self, p: PolyElement) -> PolyElement:
        """Inverts `spread`, over the rationals."""
        shifts = range(WIDTH * len(self.generators) - WIDTH, -1, -WIDTH) or [0]
        terms = {(sum(map(lshift, powers, shifts)),): c for powers, c in p.items()}
        return self.rationals.from_dict(terms)

    @property
    def many(self) -> PolyRing:
        """The polynomials over ℚ with one indeterminate per generator, in which SymPy divides and factors."""
        return _rational_polynomials(len(self.generators))

    def factors(self, p: PolyElement) -> list[tuple[PolyElement, int]]:
        """Returns the factors over the rationals with their powers, without the numeric factor."""
        return [(self.packed(q), power) for q, power in self.spread(p, self.many).factor_list()[1]]


def _met(p: PolyElement) -> int:
    """Returns the union of the bits of all monomials."""
    met = 0
    for (powers,) in p:
        met |= powers
    return met


@cache
def _rational_polynomials(count: int) -> PolyRing:
    return polynomial_ring([f"y{i}" for i in range(count)] or "y", QQ, lex)[0]
