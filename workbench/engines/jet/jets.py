"""The jet engine: the value of a term as the list of its time derivatives at one instant, over any ring.

It shares no arithmetic with the polynomial engine: components are arrays contracted with the Levi-Civita
symbol, and derivatives follow from Leibniz' rule on the lists. The ring can be SymPy's polynomials, the
integers modulo a prime, the rationals, floats or Drake's polynomials. A `Source` supplies the derivatives of
the symbols.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial, reduce
from itertools import product
from math import comb
from typing import Any

import numpy as np

from workbench.core.construct import apply
from workbench.core.terms import (
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
from workbench.core.types import Type
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.inverses import inverse_of_exponential, inverted
from workbench.engines.inventory.partial_derivatives import Seed, indices, seeds
from workbench.engines.jet.components import (
    BILINEAR,
    DOUBLED,
    LINEAR,
    Jet,
    OperatorValue,
    Value,
    add,
    add_operators,
    array_shape,
    beside,
    cross,
    dot,
    entry,
    flat_components,
    matrix_shape,
    outer,
    product_of,
    stack,
)
from workbench.engines.jet.jet_algebra import JetAlgebra
from workbench.engines.jet.jet_quaternions import conjugated, quaternion_product
from workbench.engines.jet.jet_trigonometry import Trigonometry
from workbench.engines.jet.tangents import changes, commuted, composed
from workbench.engines.jet.term_source import Source


def _in_shape_of(type_: Type, entries: np.ndarray) -> np.ndarray:
    return entries.reshape(array_shape(type_))


def _scaled(factor: Any, x: np.ndarray) -> np.ndarray:
    scaled: np.ndarray = x * factor
    return scaled


class JetEngine:
    """Evaluates terms on a source."""

    def __init__(self, source: Source, definitions: Lookup) -> None:
        self._source = source
        self._algebra = JetAlgebra(source.ring)
        self._definitions = definitions
        self._turns = Trigonometry(self, source, self._algebra, definitions)
        self._known: dict[Term, Value] = {}
        self._moved: dict[Seed, JetEngine] = {}
        self.origin = self  # the engine without displacements

    def components(self, term: Term) -> list[Any]:
        """Returns all components at the instant: an operator's coefficients by rising power of D, each in
        reading order, real parts before dual parts."""
        return flat_components(self.operator(term, 0))

    def differences(self, left: Term, right: Term) -> list[Any]:
        """Returns left − right by components; a missing dual part or operator coefficient counts as zero."""
        minus = tuple(v.map(lambda x: -x) for v in self.operator(right, 0))
        return flat_components(add_operators(self.operator(left, 0), minus))

    def circle(self, angle: Term) -> tuple[Any, Any]:
        """Returns (cos, sin) of a free angle at the instant."""
        return self._source.circle(angle)

    def value(self, term: Term, depth: int) -> Value:
        """Returns the term's derivatives of order 0 … depth."""
        known = self._known.get(term)
        if known is None or known.depth < depth:
            known = self._known[term] = self._evaluate(term, depth)
        return known.cut(0, depth)

    def operator(self, term: Term, depth: int) -> OperatorValue:
        """Returns the coefficients of an operator by rising power of D; a tensor is an operator of degree
        0."""
        if term.type.kind != "operator":
            return (self.value(term, depth),)
        match term:
            case TimeOperator():
                return (self._algebra.diagonal(3, 0, depth), self._algebra.diagonal(3, 1, depth))
            case Zero() | Identity():
                return (self._algebra.diagonal(3, int(isinstance(term, Identity)), depth),)
            case Symbol():
                return self.operator(self._body(term), depth)
            case Power():
                total: OperatorValue = (self._algebra.diagonal(3, 1, depth),)
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
                return tuple(self._algebra.divide(v, divisor) for v in self.operator(numerator, depth))
            case Apply(head="mul" | "compose", arguments=(left, right)):
                if left.type.kind == "scalar":
                    factor = self.value(left, depth)
                    return tuple(product_of(np.multiply, factor, v) for v in self.operator(right, depth))
                return self._compose(self.operator(left, depth), self._operator_for(right), depth)
        raise NotExact(f"no operator value for {type(term).__name__}")

    def _operator_for(self, term: Term) -> Callable[[int], OperatorValue]:
        return lambda depth: self.operator(term, depth)

    def _compose(
        self, left: OperatorValue, right: Callable[[int], OperatorValue], depth: int
    ) -> OperatorValue:
        """Returns the product by Aᵢ Dⁱ ∘ Bⱼ Dʲ = Σₗ C(i, l) Aᵢ Bⱼ⁽ˡ⁾ Dⁱ⁻ˡ⁺ʲ."""
        factors = right(depth + len(left) - 1)
        total = [self._algebra.diagonal(3, 0, depth) for _ in range(len(left) + len(factors) - 1)]
        for (i, a), (j, b) in product(enumerate(left), enumerate(factors)):
            for order in range(i + 1):
                count = self._algebra.ring.constant(comb(i, order), 1)
                addend = product_of(np.matmul, a, b.cut(order, order + depth)).map(partial(_scaled, count))
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
                return self._algebra.constant(term.value.numerator, term.value.denominator, depth)
            case Zero():
                return Value([self._algebra.filled(array_shape(term.type)) for _ in range(depth + 1)])
            case Identity():
                return self.one(term.type, depth)
            case DualUnit():
                return Value(self._algebra.constant(0, 1, depth).re, self._algebra.constant(1, 1, depth).re)
            case Symbol():
                body = self._definitions.lookup(term)
                if body is None and term.declaration.of:
                    return self._function(term, depth)
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
        if term.base.type.is_column:
            base, exponent = product_of(dot, base, base), exponent // 2
        total = self.one(term.type, depth)
        products: dict[str, Callable[..., Any]] = {"scalar": np.multiply, "quaternion": quaternion_product}
        times = products.get(term.type.kind, np.matmul)
        for _ in range(exponent):
            total = product_of(times, total, base)
        return total

    def one(self, type_: Type, depth: int) -> Value:
        """Returns 1, the unit matrix, or the quaternion 1."""
        if type_.kind == "scalar":
            return self._algebra.constant(1, 1, depth)
        unit = self._algebra.diagonal(type_.rows, 1, depth)
        return unit.map(lambda x: x[:, 0]) if type_.kind == "quaternion" else unit

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
                        cells.append(self._algebra.filled(size) if jets is None else jets[k].reshape(size))
                    rows.append(cells)
                jet.append(np.block(rows).reshape(array_shape(term.type)))
            return jet

        return Value(assembled(lambda v: v.re), assembled(lambda v: v.du) if term.type.dual else None)

    def _apply(self, term: Apply, depth: int) -> Value:
        head, arguments = term.head, term.arguments
        if head == "mul":
            return self._juxtaposition(arguments[0], arguments[1], depth)
        if head in BILINEAR:
            return product_of(BILINEAR[head], *(self.value(a, depth) for a in arguments))
        if head in LINEAR:
            return self.value(arguments[0], depth).map(LINEAR[head])
        if head in ("quaternion", "scalar part", "vector part"):
            return self._parts(term, depth)
        if head in ("vect", "symmetric", "antisymmetric"):
            half = self._algebra.constant(1, 2, depth)
            return product_of(np.multiply, half, self.value(arguments[0], depth).map(DOUBLED[head]))
        match head:
            case "add":
                return reduce(add, (self.value(argument, depth) for argument in arguments))
            case "triple":
                a, b, c = (self.value(x, depth) for x in arguments)
                return product_of(dot, a, product_of(cross, b, c))
            case "adjugate" | "det" | "inverse" | "conjugate" | "kronecker":
                return self._of_matrix(term, depth)
            case "div":
                return self._algebra.divide(*(self.value(a, depth) for a in arguments))
            case "re":
                return Value(self.value(arguments[0], depth).re)
            case "du":
                value = self.value(arguments[0], depth)
                return Value([0 * x for x in value.re] if value.du is None else value.du)
            case "root" | "norm" | "cos" | "sin" | "exp":
                return self._of_function(head, arguments[0], depth)
            case "partial" | "total":
                return self._partial(arguments[0], arguments[1], depth)
            case "divergence" | "curl":
                return self._of_field(head, arguments[0], depth)
        raise NotExact(f"no value for the operation {head}")

    def _kronecker(self, term: Apply, depth: int) -> Value:
        """Returns A ⊗ B: the products of all entries, by the rows of A, then those of B, then the columns."""
        shapes = [matrix_shape(a.type) for a in term.arguments]

        def blocks(a: np.ndarray, b: np.ndarray) -> np.ndarray:
            entries = np.multiply.outer(a.reshape(shapes[0]), b.reshape(shapes[1]))
            product: np.ndarray = entries.transpose(0, 2, 1, 3).reshape(array_shape(term.type))
            return product

        return product_of(blocks, *(self.value(a, depth) for a in term.arguments))

    def _of_field(self, head: str, field: Term, depth: int) -> Value:
        """The divergence or the curl."""
        gradient = self._gradient(field, depth)
        if head == "curl":
            return stack([self._curl_component(gradient, i) for i in range(3)])
        return add(add(entry(gradient[0], 0), entry(gradient[1], 1)), entry(gradient[2], 2))

    def _of_matrix(self, term: Apply, depth: int) -> Value:
        """The adjugate, determinant or inverse of a matrix, the Kronecker product of two; the inverse or
        conjugate of a quaternion."""
        if term.head == "kronecker":
            return self._kronecker(term, depth)
        argument = term.arguments[0]
        if term.head == "inverse":
            known = inverted(argument, self._definitions, inverse_of_exponential(self._definitions))
            if known is not None:
                return self.value(known, depth)
        value = self.value(argument, depth)
        if term.head == "conjugate":
            return value.map(conjugated)
        if term.head == "inverse":
            is_quaternion = term.type.kind == "quaternion"
            return self._algebra.quaternion_inverse(value) if is_quaternion else self._algebra.inverse(value)
        return self._algebra.det(value) if term.head == "det" else self._algebra.adjugate(value)

    def _of_function(self, head: str, argument: Term, depth: int) -> Value:
        """A root, a norm, a cosine, a sine or an exponential."""
        match head:
            case "root":
                return self._algebra.root(self.value(argument, depth))
            case "norm":
                return self._algebra.norm(self.value(argument, depth))
            case "exp":
                return self._turns.exp(argument, depth)
        cosine, sine = self._turns.circle(argument, depth)
        return cosine if head == "cos" else sine

    def _juxtaposition(self, left: Term, right: Term, depth: int) -> Value:
        if left.type.kind == "operator":
            if right.type.rows != 3:
                raise NotExact("an operator with 3×3 coefficients on a block matrix of other rows")
            coefficients = self.operator(left, depth)
            operands = self.value(right, depth + len(coefficients) - 1)
            addends = (
                product_of(np.matmul, coefficient, operands.cut(power, power + depth))
                for power, coefficient in enumerate(coefficients)
            )
            return reduce(add, addends)
        a, b = self.value(left, depth), self.value(right, depth)
        if "scalar" in (left.type.kind, right.type.kind):
            return product_of(np.multiply, a, b)
        if left.type.kind == "quaternion":
            return product_of(quaternion_product, a, b)
        width = left.type.columns
        if width != right.type.rows:
            type_ = apply("mul", left, right).type
            beside = right.type.rows * right.type.columns // width
            b = b.map(lambda x: x.reshape((width, beside)))
            if left.type.rows == 1:
                a = a.map(lambda x: x.reshape((1, width)))
            return product_of(np.matmul, a, b).map(lambda x: x.reshape(array_shape(type_)))
        if width == 1:
            return product_of(outer, a, b)
        return product_of(np.matmul, a, b)

    def _parts(self, term: Apply, depth: int) -> Value:
        values = [self.value(a, depth) for a in term.arguments]
        if term.head == "scalar part":
            return entry(values[0], 0)
        if term.head == "vector part":
            return values[0].map(lambda q: q[1:])
        scalar, vector = values
        return stack([scalar, *(entry(vector, i) for i in range(3))])

    def _function(self, function: Symbol, depth: int) -> Value:
        """Returns f(q) by its Taylor series at q, with the changes of q in time and along coordinates."""
        ring, arguments = self._algebra.ring, function.declaration.of
        values = [self.value(argument, depth) for argument in arguments]
        coordinates = [list(jet) for v in values for jet in zip(*(x.ravel() for x in v.re), strict=True)]
        start = [x for a in arguments for x in self.origin.value(a, 0).re[0].ravel()]
        shape, among = array_shape(function.type), len(coordinates)
        size = function.type.rows * function.type.columns
        degrees = range(depth + getattr(ring, "depth", 0) + 1)
        slopes = [self._source.slopes(function, k, size * len(indices(among, k))) for k in degrees]
        return Value(composed(slopes, coordinates, start, ring, shape))

    def _partial(self, body: Term, by: Term, depth: int) -> Value:
        """Returns ∂f/∂x component by component.

        With ∂ₖ for the derivative by x⁽ᵏ⁾, ∂ₖ D = D ∂ₖ + ∂ₖ₋₁, so that Dʲ ∂ₖ f = Σᵢ (−1)ⁱ C(j, i) ∂ₖ₋ᵢ Dʲ⁻ⁱ
        f. Here ∂ₖ Dʲ f is the change of Dʲ f if x⁽ᵏ⁾ moves by ε.
        """
        found = []
        for seed in seeds(by, self._definitions):
            lower = [seed._replace(order=seed.order - i) for i in range(min(seed.order, depth) + 1)]
            moved = [changes(self._moved_by(each).value(body, depth)) for each in lower]
            duals = [value.du for value in moved if value.du is not None]
            found.append(Value(commuted([v.re for v in moved]), commuted(duals) if duals else None))
        if by.type.kind == "scalar":
            return found[0]
        return beside(found) if by.type.is_column else stack(found).map(partial(_in_shape_of, by.type))

    def _moved_by(self, seed: Seed) -> JetEngine:
        if seed not in self._moved:
            engine = self._moved[seed] = JetEngine(self._source.moved(seed), self._definitions)
            engine.origin = self.origin
        return self._moved[seed]

    @cached_property
    def _displaced(self) -> list[JetEngine]:
        return [JetEngine(self._source.along(component), self._definitions) for component in range(3)]

    def _gradient(self, field: Term, depth: int) -> list[Value]:
        """Returns ∂f/∂ρⱼ for j = 1, 2, 3: the dual part of f at ρ + ε eⱼ."""
        if field.type.dual:
            raise NotExact("div and curl of a dual field")
        values = [engine.value(field, depth) for engine in self._displaced]
        return [Value([0 * x for x in v.re] if v.du is None else v.du) for v in values]

    def _curl_component(self, gradient: list[Value], i: int) -> Value:
        j, k = (i + 1) % 3, (i + 2) % 3
        return add(entry(gradient[j], k), entry(gradient[k], j).map(lambda x: -x))
