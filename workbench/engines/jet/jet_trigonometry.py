"""Sines, cosines and exponentials of the jet engine, as lists of time derivatives."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import Any, Protocol

import numpy as np

from workbench.core.codes.engine_codes import EngineCode
from workbench.core.construct import apply
from workbench.core.terms import Apply, Number, Symbol, Term, Zero
from workbench.core.types import Type
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.angle_combinations import angle_parts, is_free_angle
from workbench.engines.inventory.rodrigues import (
    angle_and_axis,
    rotation_vector,
    twist_parts,
)
from workbench.engines.jet.components import (
    Value,
    add,
    cross,
    dot,
    entry,
    leibniz,
    outer,
    product_of,
    skew,
    stack,
    turned,
)
from workbench.engines.jet.jet_algebra import JetAlgebra
from workbench.engines.jet.tangents import pushed
from workbench.engines.jet.term_source import Source

#: Multiples to try when an angle may be a multiple of another one that is written differently.
_MULTIPLES = range(1, 5)


class Engine(Protocol):
    """The engine that evaluates the arguments. `origin` is the same engine without displacements."""

    origin: Engine

    def value(self, term: Term, depth: int) -> Value: ...

    def one(self, type_: Type, depth: int) -> Value: ...


class Trigonometry:
    """Evaluation of rotations: angles by their sine and cosine, exponentials by Rodrigues' formula."""

    def __init__(self, engine: Engine, source: Source, algebra: JetAlgebra, definitions: Lookup) -> None:
        self._engine, self._source, self._algebra = engine, source, algebra
        self._definitions = definitions

    def circle(self, angle: Term, depth: int, factor: Fraction = Fraction(1)) -> tuple[Value, Value]:
        """Returns cos and sin of factor · angle: by the addition theorems on the term, and for a free angle
        by ċ = −s α̇, ṡ = c α̇."""
        match angle:
            case Zero():
                return self._algebra.constant(1, 1, depth), self._algebra.constant(0, 1, depth)
            case Symbol():
                body = self._definitions.lookup(angle)
                if body is not None:
                    return self.circle(body, depth, factor)
                if factor.denominator == 1 and is_free_angle(angle):
                    return self._repeated(self._free_circle(angle, depth), int(factor), depth)
            case Apply(head="re", arguments=(inner,)):
                cosine, sine = self.circle(inner, depth, factor)
                return Value(cosine.re), Value(sine.re)
            case Apply(head="neg", arguments=(inner,)):
                return self.circle(inner, depth, -factor)
            case Apply(head="add"):
                cosine, sine = self.circle(angle.arguments[0], depth, factor)
                for argument in angle.arguments[1:]:
                    cosine, sine = turned((cosine, sine), self.circle(argument, depth, factor))
                return cosine, sine
            case Apply(head="mul", arguments=(Number() as n, inner) | (inner, Number() as n)):
                return self.circle(inner, depth, factor * n.value)
            case Apply(head="div", arguments=(inner, Number() as n)):
                return self.circle(inner, depth, factor / n.value)
        value = self._engine.value(angle, depth)
        if value.du is not None and all(not x for x in np.ravel(value.re[0])):
            scale = self._algebra.constant(factor.numerator, factor.denominator, depth)
            return self._algebra.constant(1, 1, depth), product_of(np.multiply, scale, value)
        if value.du is not None:
            raise NotExact(EngineCode.NO_ANGLE())
        total = self._algebra.constant(1, 1, depth), self._algebra.constant(0, 1, depth)
        for part, coefficient in angle_parts(angle, self._definitions).items():
            if coefficient == 0:
                continue
            total = turned(total, self._part_of_circle(part, factor * coefficient, depth))
        return total

    def _part_of_circle(self, angle: Term, factor: Fraction, depth: int) -> tuple[Value, Value]:
        """Returns cos and sin of factor · ω t and similar terms, from those of the part that has its own
        circle."""
        for part in self._source.circles():
            own = angle_parts(part, self._definitions)
            if list(own) == [angle] and (factor / own[angle]).denominator == 1:
                return self._repeated(self._free_circle(part, depth), int(factor / own[angle]), depth)
        if isinstance(angle, Symbol) and factor.denominator == 1:
            return self._repeated(self._free_circle(angle, depth), int(factor), depth)
        raise NotExact(EngineCode.NO_ANGLE())

    def _repeated(self, once: tuple[Value, Value], count: int, depth: int) -> tuple[Value, Value]:
        if count < 0:
            once = (once[0], once[1].map(lambda x: -x))
        total = self._algebra.constant(1, 1, depth), self._algebra.constant(0, 1, depth)
        for _ in range(abs(count)):
            total = turned(total, once)
        return total

    def _free_circle(self, angle: Term, depth: int) -> tuple[Value, Value]:
        """Returns cos and sin of a free angle by ċ = −s α̇, ṡ = c α̇, from the source's values without
        displacement."""
        value = self._engine.value(angle, depth)
        step = value.re[0][()] - self._engine.origin.value(angle, 0).re[0][()]
        c, s = pushed(self._circle_now(angle), step, self._algebra.ring)
        cosine, sine = [c], [s]
        rate = value.re[1:]
        for k in range(depth):
            cosine.append(-leibniz(np.multiply, sine, rate[: k + 1])[k])
            sine.append(leibniz(np.multiply, cosine[: k + 1], rate[: k + 1])[k])
        if value.du is None:
            return Value(cosine), Value(sine)
        falling = [-x for x in leibniz(np.multiply, sine, value.du)]
        return Value(cosine, falling), Value(sine, leibniz(np.multiply, cosine, value.du))

    def _circle_now(self, angle: Term) -> tuple[Any, Any]:
        """Returns cos and sin without displacement.

        A term whose value is a multiple of another's shares its circle: ‖R a‖ has that of ‖a‖, and ‖a + a‖ is
        twice that angle.
        """
        now = self._engine.origin.value(angle, 0).re[0][()]
        others = () if isinstance(angle, Symbol) else self._source.circles()
        for count, other in product(reversed(_MULTIPLES), others):
            if other != angle and self._engine.origin.value(other, 0).re[0][()] * count == now:
                c, s = self._source.circle(other, self._engine.origin.value(other, 0).re[0][()])
                cosine, sine = c, s
                for _ in range(count - 1):
                    cosine, sine = cosine * c - sine * s, sine * c + cosine * s
                return cosine, sine
            if (other, count) == (angle, 1):
                break
        return self._source.circle(angle, now)

    def exp(self, argument: Term, depth: int) -> Value:
        """Returns the exponential.

        For a purely dual x it is 1 + x. For α ũ with a unit vector u it is I cos α + ũ sin α + (1 − cos α) u
        ⊗ u. For [α ũ v; 0 0] the last column is (u · v) u + sin α/α (v − (u · v) u) + (1 − cos α)/α u × v.
        """
        if (parts := twist_parts(argument, self._definitions)) is not None:
            return self._moved(*parts, depth)
        turn = angle_and_axis(argument, self._definitions)
        vector = None if turn is not None else rotation_vector(argument, self._definitions)
        if turn is not None:
            cosine, sine = self.circle(turn[0], depth)
            return self._turned(argument, cosine, sine, self._engine.value(turn[1], depth))
        if vector is not None:
            length = apply("norm", vector)
            cosine, sine = self.circle(length, depth)
            axis = self._algebra.divide(self._engine.value(vector, depth), self._engine.value(length, depth))
            return self._turned(argument, cosine, sine, axis)
        value = self._engine.value(argument, depth)
        if value.du is None or any(bool(x != 0) for jet in value.re for x in jet.ravel()):
            raise NotExact(EngineCode.EXPONENT())
        return Value(self._engine.one(argument.type, depth).re, value.du)

    def _moved(self, turning: Term, moving: Term, depth: int) -> Value:
        turn = angle_and_axis(turning, self._definitions)
        vector = None if turn is not None else rotation_vector(turning, self._definitions)
        if turn is not None:
            angle, axis_term = turn
            alpha, axis = self._engine.value(angle, depth), self._engine.value(axis_term, depth)
        elif vector is not None:
            angle = apply("norm", vector)
            alpha = self._engine.value(angle, depth)
            axis = self._algebra.divide(self._engine.value(vector, depth), alpha)
        else:
            raise NotExact(EngineCode.EXPONENT())
        v = self._engine.value(moving, depth)
        cosine, sine = self.circle(angle, depth)
        one = self._algebra.constant(1, 1, depth)
        along = product_of(np.multiply, product_of(dot, axis, v), axis)
        slope = self._algebra.divide(add(one, cosine.map(lambda x: -x)), alpha)
        moved = add(along, product_of(np.multiply, slope, product_of(cross, axis, v)))
        beside = add(v, along.map(lambda x: -x))
        moved = add(moved, product_of(np.multiply, self._algebra.divide(sine, alpha), beside))
        rotation = self._turned(turning, cosine, sine, axis)
        joined = [np.column_stack([r, p]) for r, p in zip(rotation.re, moved.re, strict=True)]
        last = self._algebra.diagonal(4, 1, depth).re
        return Value([np.vstack([rows, unit[3:]]) for rows, unit in zip(joined, last, strict=True)])

    def _turned(self, argument: Term, cosine: Value, sine: Value, axis: Value) -> Value:
        """Returns the rotation about a unit axis; for a quaternion cos + u sin."""
        if argument.type.kind == "quaternion":
            scaled = product_of(np.multiply, sine, axis)
            return stack([cosine, *(entry(scaled, i) for i in range(3))])
        versine = add(self._algebra.constant(1, 1, cosine.depth), cosine.map(lambda x: -x))
        turned = product_of(np.multiply, cosine, self._algebra.diagonal(3, 1, cosine.depth))
        turned = add(turned, product_of(np.multiply, sine, axis.map(skew)))
        return add(turned, product_of(np.multiply, versine, product_of(outer, axis, axis)))
