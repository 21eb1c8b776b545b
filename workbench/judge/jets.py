"""The second engine: a term's value as the list of its time derivatives at one instant, over any ring.

It shares no arithmetic with the first: components are arrays contracted with the Levi-Civita symbol and
derivatives come from Leibniz' rule on the lists. The ring can be SymPy's polynomials, the integers modulo a
prime, the rationals, floats or Drake's polynomials. A `Source` says what the symbols' derivatives are.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from math import comb
from typing import Any, Protocol

import numpy as np

from workbench.judge.components import (
    BILINEAR,
    DOUBLED,
    LINEAR,
    Jet,
    OperatorValue,
    Value,
    add,
    add_operators,
    array_shape,
    cross,
    dot,
    double_cofactors,
    entry,
    first_row_by_first_column,
    flat_components,
    is_zero,
    leibniz,
    matrix_shape,
    outer,
    product_of,
    scalar_array,
    skew,
    stack,
    turned,
    vanishes,
)
from workbench.judge.inventory import Lookup, NotExact
from workbench.judge.rodrigues import angle_and_axis
from workbench.language.terms import (
    Apply,
    Block,
    Derivative,
    DualUnit,
    Identity,
    Number,
    Power,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)


class Ring(Protocol):
    """The scalars of a computation."""

    def constant(self, numerator: int, denominator: int) -> Any: ...

    def divide(self, a: Any, b: Any) -> Any: ...

    def root(self, square: Any) -> Any:
        """The non-negative root; raises NotExact where the ring has none."""


class Source(Protocol):
    """Where free symbols get their derivatives from."""

    ring: Ring

    def jet(self, symbol: Symbol, depth: int) -> Value: ...

    def circle(self, angle: Symbol) -> tuple[Any, Any]:
        """(cos, sin) of the angle at the instant."""

    def along(self, component: int) -> Source:
        """The same source with the coordinate moved by ε along one axis, for div and curl."""


class JetEngine:
    """Evaluates terms on a source."""

    def __init__(self, source: Source, definitions: Lookup) -> None:
        self._source = source
        self._ring = source.ring
        self._definitions = definitions
        self._known: dict[Term, Value] = {}
        self._displaced: list[JetEngine] = []

    def components(self, term: Term) -> list[Any]:
        """All components at the instant: an operator's coefficients by rising power of D, each in reading
        order, real parts before dual parts."""
        is_operator = term.type.kind == "operator"
        return flat_components(self.operator(term, 0) if is_operator else (self.value(term, 0),))

    def differences(self, left: Term, right: Term) -> list[Any]:
        """left − right by components; a missing dual part or operator coefficient counts as zero."""
        if "operator" in (left.type.kind, right.type.kind):
            a, b = self.operator(left, 0), self.operator(right, 0)
            minus = tuple(v.map(lambda x: -x) for v in b)
            return flat_components(add_operators(a, minus))
        return flat_components((add(self.value(left, 0), self.value(right, 0).map(lambda x: -x)),))

    def circle(self, angle: Symbol) -> tuple[Any, Any]:
        """(cos, sin) of a free angle at the instant."""
        return self._source.circle(angle)

    def value(self, term: Term, depth: int) -> Value:
        """The term's derivatives of order 0 … depth."""
        known = self._known.get(term)
        if known is None or known.depth < depth:
            known = self._known[term] = self._evaluate(term, depth)
        return known.cut(0, depth)

    def operator(self, term: Term, depth: int) -> OperatorValue:
        """The coefficients of an operator by rising power of D; a tensor is an operator of degree 0."""
        if term.type.kind != "operator":
            return (self.value(term, depth),)
        match term:
            case TimeOperator():
                return (self._diagonal(3, 0, depth), self._diagonal(3, 1, depth))
            case Zero() | Identity():
                return (self._diagonal(3, int(isinstance(term, Identity)), depth),)
            case Symbol():
                return self.operator(self._body(term), depth)
            case Power():
                total: OperatorValue = (self._diagonal(3, 1, depth),)
                for _ in range(int(term.exponent)):
                    total = self._compose(total, self._operator_for(term.base), depth)
                return total
            case Apply(head="add"):
                values = [self.operator(a, depth) for a in term.arguments]
                total = values[0]
                for value in values[1:]:
                    total = add_operators(total, value)
                return total
            case Apply(head="neg"):
                return tuple(v.map(lambda x: -x) for v in self.operator(term.arguments[0], depth))
            case Apply(head="div"):
                numerator, denominator = term.arguments
                divisor = self.value(denominator, depth)
                return tuple(self._divide(v, divisor) for v in self.operator(numerator, depth))
            case Apply(head="mul" | "compose", arguments=(left, right)):
                if left.type.kind == "scalar":
                    factor = self.value(left, depth)
                    return tuple(product_of(np.multiply, factor, v) for v in self.operator(right, depth))
                if right.type.kind == "scalar":
                    factor = self.value(right, depth)
                    return tuple(product_of(np.multiply, factor, v) for v in self.operator(left, depth))
                return self._compose(self.operator(left, depth), self._operator_for(right), depth)
        raise NotExact(f"no operator value for {type(term).__name__}")

    def _operator_for(self, term: Term) -> Callable[[int], OperatorValue]:
        return lambda depth: self.operator(term, depth)

    def _compose(
        self, left: OperatorValue, right: Callable[[int], OperatorValue], depth: int
    ) -> OperatorValue:
        """Aᵢ Dⁱ ∘ Bⱼ Dʲ = Σₗ C(i, l) Aᵢ Bⱼ⁽ˡ⁾ Dⁱ⁻ˡ⁺ʲ."""
        factors = right(depth + len(left) - 1)
        total = [self._diagonal(3, 0, depth) for _ in range(len(left) + len(factors) - 1)]
        for (i, a), (j, b) in product(enumerate(left), enumerate(factors)):
            for order in range(i + 1):
                count = self._ring.constant(comb(i, order), 1)
                addend = product_of(np.matmul, a, b.cut(order, order + depth)).map(lambda x, c=count: x * c)
                total[i - order + j] = add(total[i - order + j], addend)
        return tuple(total)

    def _body(self, symbol: Symbol) -> Term:
        body = self._definitions.lookup(symbol)
        if body is None:
            raise NotExact(f"{symbol.declaration.name} is an undefined {symbol.type}")
        return body

    def _evaluate(self, term: Term, depth: int) -> Value:
        match term:
            case Number():
                return self._constant(term.value.numerator, term.value.denominator, depth)
            case Zero() | Identity():
                shape = array_shape(term.type)
                if isinstance(term, Identity):
                    return self._diagonal(shape[0], 1, depth)
                return Value([self._filled(shape) for _ in range(depth + 1)])
            case DualUnit():
                return Value(self._constant(0, 1, depth).re, self._constant(1, 1, depth).re)
            case Symbol():
                body = self._definitions.lookup(term)
                return self._source.jet(term, depth) if body is None else self.value(body, depth)
            case Derivative():
                order = int(term.order)
                return self.value(term.body, depth + order).cut(order, order + depth)
            case Power():
                return self._power(term, depth)
            case Block():
                return self._block(term, depth)
            case Apply():
                return self._apply(term, depth)
        raise NotExact(f"no value for {type(term).__name__}")

    def _power(self, term: Power, depth: int) -> Value:
        base, exponent = self.value(term.base, depth), int(term.exponent)
        if term.base.type.kind == "vector":
            base, exponent = product_of(dot, base, base), exponent // 2
        kind = term.type.kind
        total = (
            self._constant(1, 1, depth) if kind == "scalar" else self._diagonal(base.re[0].shape[0], 1, depth)
        )
        for _ in range(exponent):
            total = product_of(np.multiply if kind == "scalar" else np.matmul, total, base)
        return total

    def _block(self, term: Block, depth: int) -> Value:
        entries = [[self.value(e, depth) for e in row] for row in term.entries]
        sizes = [[matrix_shape(e.type) for e in row] for row in term.entries]

        def assembled(part: Callable[[Value], Jet | None]) -> Jet:
            jet = []
            for k in range(depth + 1):
                rows = []
                for row, row_sizes in zip(entries, sizes, strict=True):
                    cells = []
                    for value, size in zip(row, row_sizes, strict=True):
                        jets = part(value)
                        cells.append(self._filled(size) if jets is None else jets[k].reshape(size))
                    rows.append(cells)
                jet.append(np.block(rows))
            return jet

        return Value(assembled(lambda v: v.re), assembled(lambda v: v.du) if term.type.dual else None)

    def _apply(self, term: Apply, depth: int) -> Value:
        head, arguments = term.head, term.arguments
        if head == "mul":
            return self._juxtaposition(*arguments, depth)
        if head in BILINEAR:
            return product_of(BILINEAR[head], *(self.value(a, depth) for a in arguments))
        if head in LINEAR:
            return self.value(arguments[0], depth).map(LINEAR[head])
        if head in ("vect", "symmetric", "antisymmetric"):
            half = self._constant(1, 2, depth)
            return product_of(np.multiply, half, self.value(arguments[0], depth).map(DOUBLED[head]))
        match head:
            case "add":
                total = self.value(arguments[0], depth)
                for argument in arguments[1:]:
                    total = add(total, self.value(argument, depth))
                return total
            case "triple":
                a, b, c = (self.value(x, depth) for x in arguments)
                return product_of(dot, a, product_of(cross, b, c))
            case "adjugate":
                return self._adjugate(self.value(arguments[0], depth))
            case "det":
                return self._det(self.value(arguments[0], depth))
            case "inverse":
                return self._inverse(self.value(arguments[0], depth))
            case "div":
                return self._divide(*(self.value(a, depth) for a in arguments))
            case "re":
                return Value(self.value(arguments[0], depth).re)
            case "du":
                value = self.value(arguments[0], depth)
                return Value([0 * x for x in value.re] if value.du is None else value.du)
            case "norm":
                return self._norm(self.value(arguments[0], depth))
            case "cos":
                return self._circle(arguments[0], depth)[0]
            case "sin":
                return self._circle(arguments[0], depth)[1]
            case "exp":
                return self._exp(arguments[0], depth)
            case "divergence":
                gradient = self._gradient(arguments[0], depth)
                return add(add(entry(gradient[0], 0), entry(gradient[1], 1)), entry(gradient[2], 2))
            case "curl":
                gradient = self._gradient(arguments[0], depth)
                return stack([self._curl_component(gradient, i) for i in range(3)])
        raise NotExact(f"no value for the operation {head}")

    def _juxtaposition(self, left: Term, right: Term, depth: int) -> Value:
        if left.type.kind == "operator":
            if right.type.kind == "block" and sum(right.type.rows) != 3:
                raise NotExact("an operator with 3×3 coefficients on a block matrix of other rows")
            total = None
            for power, coefficient in enumerate(self.operator(left, depth)):
                operand = self.value(right, depth + power).cut(power, power + depth)
                addend = product_of(np.matmul, coefficient, operand)
                total = addend if total is None else add(total, addend)
            return total
        a, b = self.value(left, depth), self.value(right, depth)
        if "scalar" in (left.type.kind, right.type.kind):
            return product_of(np.multiply, a, b)
        if left.type.kind == "vector":
            return product_of(outer, a, b)
        if "block" in (left.type.kind, right.type.kind):
            shape_a, shape_b = matrix_shape(left.type), matrix_shape(right.type)
            a = a.map(lambda x: x.reshape(shape_a))
            b = b.map(lambda x: x.reshape(shape_b))
        return product_of(np.matmul, a, b)

    def _adjugate(self, a: Value) -> Value:
        """adj(A)ᵢⱼ = ½ εⱼₖₗ εᵢₘₙ Aₖₘ Aₗₙ."""
        return product_of(np.multiply, self._constant(1, 2, a.depth), product_of(double_cofactors, a, a))

    def _det(self, a: Value) -> Value:
        """det A = a₁ⱼ adj(A)ⱼ₁."""
        return product_of(first_row_by_first_column, a, self._adjugate(a))

    def _inverse(self, a: Value) -> Value:
        shape = a.re[0].shape
        if shape == ():
            return self._divide(self._constant(1, 1, a.depth), a)
        if shape == (3, 3):
            return self._divide(self._adjugate(a), self._det(a))
        return self._gauss_jordan(a)

    def _gauss_jordan(self, a: Value) -> Value:
        """The inverse of a square block matrix, pivot by pivot; a pivot must not vanish identically."""
        size = a.re[0].shape[0]
        rows = [[entry(a, (i, j)) for j in range(size)] for i in range(size)]
        unit = self._diagonal(size, 1, a.depth)
        for i in range(size):
            rows[i] += [entry(unit, (i, j)) for j in range(size)]
        for column in range(size):
            place = next((i for i in range(column, size) if not vanishes(rows[i][column])), None)
            if place is None:
                raise ZeroDivisionError("a singular matrix has no inverse")
            rows[column], rows[place] = rows[place], rows[column]
            pivot = rows[column][column]
            rows[column] = [self._divide(entry, pivot) for entry in rows[column]]
            for i in range(size):
                factor = rows[i][column]
                if i != column and not is_zero(factor):
                    minus = factor.map(lambda x: -x)
                    rows[i] = [
                        add(entry, product_of(np.multiply, minus, top))
                        for entry, top in zip(rows[i], rows[column], strict=True)
                    ]
        return stack([stack(row[size:]) for row in rows])

    def _divide(self, a: Value, b: Value) -> Value:
        """q with q b = a, order by order; dual by (a + ε a₀)/(b + ε b₀) = q + ε (a₀ − q b₀)/b."""
        re = self._divide_jets(a.re, b.re)
        if a.du is None and b.du is None:
            return Value(re)
        rest = [np.asarray(0 * x, dtype=object) for x in a.re] if a.du is None else a.du
        if b.du is not None:
            rest = [x - y for x, y in zip(rest, leibniz(np.multiply, re, b.du), strict=True)]
        return Value(re, self._divide_jets(rest, b.re))

    def _divide_jets(self, a: Jet, b: Jet) -> Jet:
        divide = np.frompyfunc(self._ring.divide, 2, 1)
        quotient: Jet = []
        for k, top in enumerate(a):
            for j, q in enumerate(quotient):
                top = top - q * (b[k - j] * self._ring.constant(comb(k, j), 1))
            quotient.append(np.asarray(divide(top, b[0]), dtype=object))
        return quotient

    def _norm(self, x: Value) -> Value:
        """N with N² = x·x, order by order; a dual norm is N + ε x·x₀/N, Eq. (74)."""
        squared = np.multiply if x.re[0].shape == () else dot
        square = leibniz(squared, x.re, x.re)
        norm: Jet = [np.asarray(self._ring.root(square[0][()]), dtype=object)]
        for k in range(1, len(square)):
            rest = square[k]
            for j in range(1, k):
                rest = rest - norm[j] * norm[k - j] * self._ring.constant(comb(k, j), 1)
            norm += self._divide_jets([rest], [norm[0] * self._ring.constant(2, 1)])
        if x.du is None:
            return Value(norm)
        return Value(norm, self._divide_jets(leibniz(squared, x.re, x.du), norm))

    def _circle(self, angle: Term, depth: int) -> tuple[Value, Value]:
        """cos and sin by the addition theorems on the term; of a free angle by ċ = −s α̇, ṡ = c α̇."""
        match angle:
            case Zero():
                return self._constant(1, 1, depth), self._constant(0, 1, depth)
            case Symbol():
                body = self._definitions.lookup(angle)
                return self._free_circle(angle, depth) if body is None else self._circle(body, depth)
            case Apply(head="re", arguments=(inner,)):
                cosine, sine = self._circle(inner, depth)
                return Value(cosine.re), Value(sine.re)
            case Apply(head="neg", arguments=(inner,)):
                cosine, sine = self._circle(inner, depth)
                return cosine, sine.map(lambda x: -x)
            case Apply(head="add"):
                cosine, sine = self._circle(angle.arguments[0], depth)
                for argument in angle.arguments[1:]:
                    cosine, sine = turned((cosine, sine), self._circle(argument, depth))
                return cosine, sine
            case Apply(head="mul", arguments=(Number() as n, inner)) if n.value.denominator == 1:
                once = self._circle(inner, depth)
                if n.value < 0:
                    once = (once[0], once[1].map(lambda x: -x))
                total = self._constant(1, 1, depth), self._constant(0, 1, depth)
                for _ in range(abs(n.value.numerator)):
                    total = turned(total, once)
                return total
        value = self.value(angle, depth)
        if value.du is not None and all(not x for x in np.ravel(value.re[0])):
            return Value(self._constant(1, 1, depth).re, [0 * x for x in value.du]), Value(value.re, value.du)
        raise NotExact("the sine or cosine of anything but an integer combination of angles")

    def _free_circle(self, angle: Symbol, depth: int) -> tuple[Value, Value]:
        value = self._source.jet(angle, depth)
        c, s = (np.asarray(x, dtype=object) for x in self._source.circle(angle))
        cosine, sine = [c], [s]
        rate = value.re[1:]
        for k in range(depth):
            cosine.append(-leibniz(np.multiply, sine, rate[: k + 1])[k])
            sine.append(leibniz(np.multiply, cosine[: k + 1], rate[: k + 1])[k])
        if value.du is None:
            return Value(cosine), Value(sine)
        falling = [-x for x in leibniz(np.multiply, sine, value.du)]
        return Value(cosine, falling), Value(sine, leibniz(np.multiply, cosine, value.du))

    def _exp(self, argument: Term, depth: int) -> Value:
        """Of a purely dual x: 1 + x. Of α ũ with a unit vector u: I cos α + ũ sin α + (1 − cos α) u ⊗ u."""
        turn = angle_and_axis(argument)
        if turn is not None:
            cosine, sine = self._circle(turn[0], depth)
            axis = self.value(turn[1], depth)
            versine = add(self._constant(1, 1, depth), cosine.map(lambda x: -x))
            turned = product_of(np.multiply, cosine, self._diagonal(3, 1, depth))
            turned = add(turned, product_of(np.multiply, sine, axis.map(skew)))
            return add(turned, product_of(np.multiply, versine, product_of(outer, axis, axis)))
        value = self.value(argument, depth)
        if value.du is None or any(bool(x != 0) for jet in value.re for x in jet.ravel()):
            raise NotExact(
                "exp of anything but a purely dual argument or an angle times a unit vector's skew tensor"
            )
        shape = value.re[0].shape
        unit = self._diagonal(shape[0], 1, depth) if shape else self._constant(1, 1, depth)
        return Value(unit.re, value.du)

    def _gradient(self, field: Term, depth: int) -> list[Value]:
        """∂f/∂ρⱼ for j = 1, 2, 3: the dual part of f at ρ + ε eⱼ."""
        if field.type.dual:
            raise NotExact("div and curl of a dual field")
        if not self._displaced:
            self._displaced = [
                JetEngine(self._source.along(component), self._definitions) for component in range(3)
            ]
        values = [engine.value(field, depth) for engine in self._displaced]
        return [Value([0 * x for x in v.re] if v.du is None else v.du) for v in values]

    def _curl_component(self, gradient: list[Value], i: int) -> Value:
        j, k = (i + 1) % 3, (i + 2) % 3
        return add(entry(gradient[j], k), entry(gradient[k], j).map(lambda x: -x))

    def _constant(self, numerator: int, denominator: int, depth: int) -> Value:
        zero = self._ring.constant(0, 1)
        value = self._ring.constant(numerator, denominator)
        return Value([scalar_array(value), *(scalar_array(zero) for _ in range(depth))])

    def _filled(self, shape: tuple[int, ...]) -> np.ndarray:
        array = np.empty(shape, dtype=object)
        array[...] = self._ring.constant(0, 1)
        return array

    def _diagonal(self, size: int, value: int, depth: int) -> Value:
        jets = [self._filled((size, size)) for _ in range(depth + 1)]
        for i in range(size):
            jets[0][i, i] = self._ring.constant(value, 1)
        return Value(jets)
