"""The polynomial engine: the value of a term as a matrix of polynomials over ℚ; d/dt is the ring's
derivation.

A scalar is a 1×1 matrix, a vector 3×1, a covector 1×3, a tensor 3×3, so that juxtaposition is the matrix
product throughout. Dual entries are `Dual` numbers over the ring. An operator Σ Aₖ Dᵏ is (A₀, A₁, …).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import partial
from functools import reduce as fold
from typing import Any

from workbench.algebra.differential_ring import Polynomial
from workbench.algebra.dual import Dual
from workbench.algebra.matrices import (
    Entry,
    Matrix,
    add,
    adjugate,
    cross,
    det,
    dual_part,
    flat,
    kronecker,
    matrix,
    on_entries,
    product,
    real_part,
    skew,
    symmetric,
    trace,
    transpose,
    vect,
)
from workbench.core.terms import (
    Apply,
    Block,
    Counting,
    Derivative,
    DualUnit,
    Head,
    Identity,
    Integer,
    Number,
    Power,
    Relation,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.core.types import Type
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.inverses import inverted, negated
from workbench.engines.inventory.parameters import Parameter, parameters
from workbench.engines.inventory.partial_derivatives import seeds
from workbench.engines.inventory.signs import is_seen_nonnegative
from workbench.engines.polynomial.polynomial_matrices import ExactAlgebra
from workbench.engines.polynomial.polynomial_operators import (
    Operator,
    acted,
    add_operators,
    as_operator,
    composed,
    is_operator,
    mapped,
    scaled,
)
from workbench.engines.polynomial.polynomial_quaternions import conjugate, hamilton
from workbench.engines.polynomial.polynomial_symbols import FreeSymbols, rank
from workbench.engines.polynomial.polynomial_trigonometry import Trigonometry


class ExactEngine:
    """Evaluates terms whose free symbols are those of the inventory."""

    def __init__(self, inventory: Inventory, definitions: Lookup) -> None:
        self._definitions = definitions
        self._named = {p: f"x{i}" for i, p in enumerate(sorted(parameters(inventory), key=rank))}
        self._algebra = ExactAlgebra(inventory, self._named.values())
        self.ring = self._algebra.ring
        self._values: dict[Term, Matrix | Operator] = {}
        self._free = FreeSymbols(self.ring, self._named)
        for angle in inventory.angles:
            self._free.furnish_angle(angle)
        for symbol in inventory.orders:
            self._values[symbol] = self._furnished(symbol)
        circles = list(inventory.circles.values())
        self._turns = Trigonometry(self.value, self._algebra, self._free, circles, definitions)
        for circle in circles:
            self._free.furnish_circle(circle, partial(self._turns.part_of, circle))

    def _furnished(self, symbol: Symbol) -> Matrix:
        if symbol.declaration.of:
            return self._free.furnish_function(symbol, lambda: self._coordinates(symbol))
        return self._free.furnish(symbol)

    def _coordinates(self, function: Symbol) -> list[Polynomial]:
        return [p for argument in function.declaration.of for p in flat(self.value(argument))]

    def residuals(self, relation: Relation) -> list[Polynomial]:
        """Returns left − right, entry by entry, real parts before dual parts, cleared of denominators."""
        return [self.ring.clear(p) for p in self.parts(self.difference(relation))]

    def difference(self, relation: Relation) -> Matrix | Operator:
        left, right = self.value(relation.left), self.value(relation.right)
        if relation.left.type.kind == "operator" or relation.right.type.kind == "operator":
            return add_operators(as_operator(left), scaled(self.ring.constant(-1), as_operator(right)))
        return add(left, scaled(self.ring.constant(-1), right))

    def parts(self, value: Matrix | Operator) -> list[Polynomial]:
        """Returns all entries in reading order, real parts before dual parts."""
        matrices = value if is_operator(value) else (value,)
        entries = [entry for matrix in matrices for row in matrix for entry in row]
        real = map(real_part, entries)
        dual = [entry.du for entry in entries if isinstance(entry, Dual)]
        return [self.ring.reduce(self._algebra.polynomial(p)) for p in (*real, *dual)]

    def at(self, p: Polynomial, point: dict[Parameter, Fraction]) -> Fraction:
        """Returns the value of a polynomial without reciprocals at a point of the parameters. Raises NotExact
        if a norm in it is not a rational number there."""
        values = {self._named[q]: value for q, value in point.items() if q in self._named}
        return self._algebra.at(p, values)

    def name_of(self, parameter: Parameter) -> str:
        """Returns the generator of the ring that stands for a parameter."""
        return self._named[parameter]

    def parameter_of(self, generator: Polynomial) -> Parameter:
        """Returns the parameter that a generator of the ring stands for."""
        return next(p for p, name in self._named.items() if name == str(generator))

    @property
    def norms(self) -> frozenset[str]:
        """The generators that stand for norms."""
        return self._algebra.norms

    @property
    def norm_places(self) -> frozenset[int]:
        """The positions of the norms among the generators."""
        return frozenset(place for place, name in enumerate(self.ring.names) if name in self.norms)

    def depends(self, terms: Iterable[Term], parameter: Parameter) -> bool:
        """True if the parameter occurs in the terms' values, in their denominators or under their roots."""
        place = self.ring.names.index(self._named[parameter])
        values = [p for term in terms for p in self.parts(self.value(term))]
        values += [*self.ring.denominators, *self._algebra.radicands]
        return any(p.degrees()[place] > 0 for p in values)

    def value(self, term: Term) -> Matrix | Operator:
        """Returns the matrix (or operator) of the term. Raises NotExact outside exact arithmetic."""
        if term not in self._values:
            self._values[term] = self._map(self.ring.reduce, self._evaluate(term))
        return self._values[term]

    def _evaluate(self, term: Term) -> Matrix | Operator:
        match term:
            case Number():
                return ((self.ring.constant(term.value),),)
            case Zero():
                return self._diagonal(term.type, 0)
            case Identity():
                return self._diagonal(term.type, 1)
            case DualUnit():
                return ((Dual(self.ring.zero, self.ring.one),),)
            case TimeOperator():
                return (self._algebra.diagonal(0), self._algebra.diagonal(1))
            case Symbol():
                body = self._definitions.lookup(term)
                if body is None:
                    raise NotExact(f"{term.declaration.name} is not in the inventory")
                value = self.value(body)
                return as_operator(value) if term.type.kind == "operator" else value
            case Derivative():
                value = self.value(term.body)
                for _ in range(int(term.order)):
                    value = self._map(self.ring.derive, value)
                return value
            case Power():
                return self._power(term)
            case Block():
                return self._block(term)
            case Apply():
                if term.head not in _HEADS:
                    raise NotExact(f"no exact value for {term.head}")
                applied: Matrix | Operator = _HEADS[term.head](self, term)
                return applied
            case Integer() | Counting():
                raise NotExact(f"the integer expression {term} is not bound to a number")
        raise NotExact(f"no exact value for {type(term).__name__}")

    def _power(self, term: Power) -> Matrix | Operator:
        exponent = int(term.exponent)
        base: Any = self.value(term.base)
        if term.base.type.is_column:
            square = product(transpose(base), base)
            return fold(product, [square] * (exponent // 2), self._algebra.diagonal(1, 1))
        if term.type.kind == "operator":
            compose: Any = partial(composed, self._algebra)
            return fold(compose, [base] * exponent, (self._algebra.diagonal(1),))
        if term.type.kind == "quaternion":
            return fold(hamilton, [base] * exponent, self._algebra.diagonal(1, 4, 1))
        return fold(product, [base] * exponent, self._algebra.diagonal(1, len(base)))

    def _block(self, term: Block) -> Matrix:
        rows: list[tuple[Entry, ...]] = []
        for line in term.entries:
            blocks = [self.value(entry) for entry in line]
            rows.extend(sum(parts, ()) for parts in zip(*blocks, strict=True))
        return tuple(rows)

    def _diagonal(self, type_: Type, value: int) -> Matrix | Operator:
        matrix = self._algebra.diagonal(value, type_.rows, type_.columns)
        return (matrix,) if type_.kind == "operator" else matrix

    def _add(self, term: Apply) -> Matrix | Operator:
        values = [self.value(a) for a in term.arguments]
        if term.type.kind == "operator":
            return fold(add_operators, map(as_operator, values))
        return fold(add, values)

    def _neg(self, term: Apply) -> Matrix | Operator:
        return scaled(self.ring.constant(-1), self.value(term.arguments[0]))

    def _mul(self, term: Apply) -> Matrix | Operator:
        left, right = term.arguments
        a, b = self.value(left), self.value(right)
        if left.type.kind == "scalar":
            return scaled(a[0][0], b)
        if right.type.kind == "scalar":
            return scaled(b[0][0], a)
        if left.type.kind == "operator" and right.type.kind != "operator":
            return acted(self._algebra, a, b)
        if "operator" in (left.type.kind, right.type.kind):
            return composed(self._algebra, as_operator(a), as_operator(b))
        if left.type.kind == "quaternion":
            return hamilton(a, b)
        if left.type.columns != right.type.rows:
            return product(on_entries(a, len(b) // left.type.columns), b)
        return product(a, b)

    def _composition(self, term: Apply) -> Operator:
        return composed(self._algebra, *(as_operator(self.value(a)) for a in term.arguments))

    def _div(self, term: Apply) -> Matrix | Operator:
        numerator, denominator = (self.value(a) for a in term.arguments)
        return scaled(self._algebra.reciprocal(denominator[0][0]), numerator)

    def _inverse(self, term: Apply) -> Matrix:
        if (known := inverted(term.arguments[0], self._definitions, negated)) is not None:
            return self.value(known)
        value = self.value(term.arguments[0])
        if term.type.kind == "quaternion":
            square = product(transpose(value), value)
            return scaled(self._algebra.reciprocal(square[0][0]), conjugate(value))
        return self._algebra.inverse(value)

    def _det(self, term: Apply) -> Matrix:
        return ((self._algebra.determinant(self.value(term.arguments[0])),),)

    def _norm(self, term: Apply) -> Matrix:
        return ((self._algebra.norm(self.value(term.arguments[0])),),)

    def _root(self, term: Apply) -> Matrix:
        (square,) = term.arguments
        return self._algebra.root(self.value(square), is_seen_nonnegative(square))

    def _triple(self, term: Apply) -> Matrix:
        rows = tuple(transpose(self.value(a))[0] for a in term.arguments)
        return ((det(rows),),)

    def _divergence(self, term: Apply) -> Matrix:
        gradient = self._gradient(term.arguments[0])
        return ((trace(gradient),),)

    def _curl(self, term: Apply) -> Matrix:
        g = self._gradient(term.arguments[0])
        return ((g[2][1] - g[1][2],), (g[0][2] - g[2][0],), (g[1][0] - g[0][1],))

    def _partial(self, term: Apply) -> Matrix:
        """Returns ∂f/∂x entry by entry; for a column x, the derivatives of each entry side by side; for a
        matrix x, those of a scalar in its places."""
        body, by = term.arguments
        value, slopes = self.value(body), []
        for seed in seeds(by, self._definitions):
            name = self._free.place(seed.symbol, seed.order, seed.component)
            once = partial(self.ring.partial, name=name)
            slopes.append(scaled(self.ring.constant(1 / seed.factor), self._map(once, value)))
        if by.type.kind == "scalar":
            return slopes[0]
        if not by.type.is_column:
            return matrix([slope[0][0] for slope in slopes], by.type.columns)
        return tuple(tuple(slope[i][0] for slope in slopes) for i in range(len(value)))

    def _gradient(self, field: Term) -> Matrix:
        """Returns ∂fᵢ/∂ρⱼ at a fixed instant, where ρ is the declared coordinate."""
        coordinates = [s for s in self._values if isinstance(s, Symbol) and s.declaration.coordinate]
        if len(coordinates) != 1:
            raise NotExact(f"div and curl need one symbol declared `coordinate`, got {len(coordinates)}")
        place = [str(generator) for generator in self._free.column(coordinates[0], "value", 0, 3)]
        rows: Any = self.value(field)
        return tuple(tuple(self.ring.partial(row[0], x) for x in place) for row in rows)

    def _map(
        self, function: Callable[[Polynomial], Polynomial], value: Matrix | Operator
    ) -> Matrix | Operator:
        return mapped(self._algebra, function, value)


def _unary(function: Callable[[Any], Any]) -> Callable[[ExactEngine, Apply], Any]:
    return lambda engine, term: function(engine.value(term.arguments[0]))


def _binary(function: Callable[[Any, Any], Any]) -> Callable[[ExactEngine, Apply], Any]:
    return lambda engine, term: function(*(engine.value(a) for a in term.arguments))


_HEADS: Mapping[Head, Callable[[ExactEngine, Apply], Any]] = {
    "add": ExactEngine._add,
    "neg": ExactEngine._neg,
    "mul": ExactEngine._mul,
    "compose": ExactEngine._composition,
    "div": ExactEngine._div,
    "inverse": ExactEngine._inverse,
    "norm": ExactEngine._norm,
    "root": ExactEngine._root,
    "triple": ExactEngine._triple,
    "sin": lambda engine, term: ((engine._turns.circle(term.arguments[0])[1],),),
    "cos": lambda engine, term: ((engine._turns.circle(term.arguments[0])[0],),),
    "exp": lambda engine, term: engine._turns.exp(term),
    "partial": ExactEngine._partial,
    "total": ExactEngine._partial,
    "divergence": ExactEngine._divergence,
    "curl": ExactEngine._curl,
    "conjugate": _unary(conjugate),
    "quaternion": _binary(lambda s, v: (*s, *v)),
    "scalar part": _unary(lambda q: q[:1]),
    "vector part": _unary(lambda q: q[1:]),
    "dot": _binary(lambda a, b: product(transpose(a), b)),
    "cross": _binary(lambda a, b: matrix(cross(flat(a), flat(b)), 1)),
    "outer": _binary(lambda a, b: product(a, transpose(b))),
    "kronecker": _binary(kronecker),
    "vec": _unary(lambda a: matrix((x for column in transpose(a) for x in column), 1)),
    "skew": _unary(lambda a: skew(flat(a))),
    "vect": _unary(vect),
    "symmetric": _unary(lambda a: symmetric(a, 1)),
    "antisymmetric": _unary(lambda a: symmetric(a, -1)),
    "transpose": _unary(transpose),
    "adjugate": _unary(adjugate),
    "det": ExactEngine._det,
    "trace": _unary(lambda a: ((trace(a),),)),
    "re": _unary(lambda a: tuple(tuple(real_part(e) for e in row) for row in a)),
    "du": _unary(lambda a: tuple(tuple(dual_part(e) for e in row) for row in a)),
}
