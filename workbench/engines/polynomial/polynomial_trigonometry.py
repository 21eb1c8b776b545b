"""Sines, cosines and exponentials of the polynomial engine."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from workbench.algebra.differential_ring import Polynomial
from workbench.algebra.dual import Dual
from workbench.algebra.matrices import Entry, Matrix, add, flat, product, real_part, skew
from workbench.core.codes.engine_codes import EngineCode
from workbench.core.construct import apply
from workbench.core.terms import Apply, Term
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.rodrigues import (
    angle_and_axis,
    rotation_vector,
    twist_parts,
)
from workbench.engines.polynomial.polynomial_matrices import ExactAlgebra
from workbench.engines.polynomial.polynomial_operators import scaled
from workbench.engines.polynomial.polynomial_symbols import FreeSymbols


class Trigonometry:
    """value: evaluates a term in the engine.   circles: the terms that have their own sine and cosine."""

    def __init__(
        self,
        value: Callable[[Term], Matrix],
        algebra: ExactAlgebra,
        free: FreeSymbols,
        circles: Sequence[Term],
        definitions: Lookup,
    ) -> None:
        self._value, self._algebra, self._free = value, algebra, free
        self._circles, self._definitions = circles, definitions

    def circle(self, angle: Term) -> tuple[Entry, Entry]:
        """Returns (cos, sin) of an integer combination of free angles; dual parts by Eq. (72)."""
        value = self._value(angle)[0][0]
        cosine, sine = self._algebra.ring.one, self._algebra.ring.zero
        circles = {circle: self.part_of(circle) for circle in self._circles}
        for circle, count in self._free.multiples(self.part_of(angle), circles):
            c, s = self._free.circle(circle, count)
            cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        if isinstance(value, Dual):
            return Dual(cosine, -value.du * sine), Dual(sine, value.du * cosine)
        return cosine, sine

    def part_of(self, circle: Term) -> Polynomial:
        """Returns the value of ω t, ‖x‖, …, or of the part of it that has its own sine and cosine."""
        ((value,),) = self._value(circle)
        return self._algebra.ring.reduce(self._algebra.polynomial(real_part(value)))

    def exp(self, term: Apply) -> Matrix:
        """Returns the exponential.

        For a purely dual x it is 1 + x. For α ũ with a unit vector u it is Rodrigues' formula, for any x̃ the
        same with sin ‖x‖/‖x‖, and similarly for quaternions without a scalar part. For [x̃ v; 0 0] it is the
        rotation with the column v + (1 − cos α)/α u × v + (1 − sin α/α) u × (u × v).
        """
        argument = term.arguments[0]
        value = self._value(argument)
        real = [self._algebra.ring.reduce(self._algebra.polynomial(real_part(e))) for r in value for e in r]
        if term.type.dual and not any(real):
            return add(self._algebra.diagonal(1, len(value), len(value[0])), value)
        if len(value) == 4 and term.type.kind == "matrix":
            return self._moved(argument)
        cosine, sine, axis, _ = self._turn(argument)
        if term.type.kind == "quaternion":
            return ((cosine,), *scaled(sine, axis))
        return self._rotation(cosine, sine, axis)

    def _turn(self, argument: Term) -> tuple[Entry, Entry, Matrix, Entry]:
        """Returns cos α, sin α, the unit vector u and 1/α of α ũ; at α = 0 these are limits, unless α is a
        symbol."""
        turn = angle_and_axis(argument, self._definitions)
        vector = rotation_vector(argument, self._definitions) if turn is None else None
        if turn is not None:
            cosine, sine = self.circle(turn[0])
            return cosine, sine, self._value(turn[1]), None
        if vector is None:
            raise NotExact(EngineCode.EXPONENT())
        angle = apply("norm", vector)
        cosine, sine = self.circle(angle)
        inverse = self._over(angle)
        return cosine, sine, scaled(inverse, self._value(vector)), inverse

    def _over(self, angle: Term) -> Entry:
        with self._algebra.ring.removable():
            return self._algebra.reciprocal(self._value(angle)[0][0])

    def _rotation(self, cosine: Entry, sine: Entry, axis: Matrix) -> Matrix:
        across = skew(flat(axis))
        turned = add(scaled(sine, across), scaled(1 - cosine, product(across, across)))
        return add(self._algebra.diagonal(1), turned)

    def _moved(self, argument: Term) -> Matrix:
        parts = twist_parts(argument, self._definitions)
        if parts is None:
            raise NotExact(EngineCode.EXPONENT())
        cosine, sine, axis, inverse = self._turn(parts[0])
        if inverse is None:
            turn = angle_and_axis(parts[0], self._definitions)
            assert turn is not None, "the angle by name"
            inverse = self._over(turn[0])
        across, along = skew(flat(axis)), self._value(parts[1])
        once = product(across, along)
        moved = add(along, scaled((1 - cosine) * inverse, once))
        moved = add(moved, scaled(1 - sine * inverse, product(across, once)))
        zero, one = self._algebra.ring.zero, self._algebra.ring.one
        rows = zip(self._rotation(cosine, sine, axis), moved, strict=True)
        return (*((*row, *entry) for row, entry in rows), (zero, zero, zero, one))
