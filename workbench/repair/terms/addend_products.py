"""Candidates for missing addends: all short products of the symbols of a statement, by type and weight."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain

from workbench.core.construct import apply, derivative, dual_unit, identity, power
from workbench.core.integer_expressions import Linear
from workbench.core.operations import OF_TENSORS, PRODUCTS
from workbench.core.terms import Apply, Derivative, Head, Identity, IllFormed, Statement, Symbol, Term
from workbench.core.types import Weight
from workbench.engines.jet.rings import PRIME
from workbench.repair.terms.coefficients import Vector
from workbench.repair.terms.subterm_positions import places
from workbench.repair.terms.variants import atoms_of, differentiated_to

#: The most factors of a product.
MOST_FACTORS = 4
MOST_PRODUCTS = 4000


class Supply:
    """Products of up to MOST_FACTORS symbols, derivatives and skew tensors, short ones first.

    Of products with equal values only the first is kept.

    others: terms outside of the statement that may be factors of products of two.
    value: a function to the components of a term at a random point.
    """

    def __init__(
        self, statement: Statement, others: Sequence[Term], value: Callable[[Term], Vector | None]
    ) -> None:
        self._basis = list(dict.fromkeys(_basis(statement)))
        self._others = others
        self._value = value
        derivatives = [term for _, term in places(statement) if isinstance(term, Derivative)]
        orders = [term.order for term in derivatives if not term.order.is_number]
        if any(not isinstance(term.body, Symbol) for term in derivatives):
            orders.append(Linear(1))
        #: The orders by which products may be differentiated.
        self._orders = tuple(dict.fromkeys(o for order in orders for o in (order, order - order.constant)))
        self._of_weight: dict[Weight, dict[str, list[Term]]] = {}

    def of(self, kind: str, weight: Weight) -> list[Term]:
        """Returns the products of one kind and weight; without weights, all of two factors."""
        if weight not in self._of_weight:
            found: dict[str, list[Term]] = {}
            for term in self._all(weight):
                found.setdefault(term.type.kind, []).append(term)
            self._of_weight[weight] = found
        return self._of_weight[weight].get(kind, [])

    def _all(self, weight: Weight) -> Iterator[Term]:
        levels: list[list[Term]] = []
        seen: set[object] = set()
        most = MOST_FACTORS if weight is not None else 2
        for factors in range(1, most + 1):
            level: list[Term] = []
            for product in self._products(levels, factors, weight if factors == most else None):
                if not _may_grow_to(product, weight) or self._is_known(product, seen):
                    continue
                level.append(product)
                if weight in (None, product.weight):
                    yield product
                if len(level) > MOST_PRODUCTS:
                    break
            levels.append(level)
            if factors == 2:
                rare = chain(self._derivatives(level), self._with_others(levels[0], weight))
                yield from (t for t in rare if t.weight == weight and not self._is_known(t, seen))

    def _is_known(self, product: Term, seen: set[object]) -> bool:
        """True if its value, or the negative, was met before."""
        value = self._value(product)
        if value is None:
            key: object = product
        else:
            key = (product.type, product.weight, *min(value, tuple(-x % PRIME for x in value)))
        known = key in seen
        seen.add(key)
        return known

    def _products(self, levels: list[list[Term]], factors: int, weight: Weight) -> Iterator[Term]:
        """Yields products of this many factors. weight: the required weight, at the last level."""
        if factors == 1:
            yield from self._basis
        for size in sorted(range(1, factors), key=lambda size: abs(2 * size - factors)):
            for left in levels[size - 1]:
                for right in levels[factors - size - 1]:
                    if weight is None or _sum_is(left, right, weight):
                        yield from _pairs(left, right)

    def _derivatives(self, level: Sequence[Term]) -> Iterator[Term]:
        for order in self._orders:
            yield from (derivative(product, order) for product in level if product.type.kind != "operator")

    def _with_others(self, basis: Sequence[Term], weight: Weight) -> Iterator[Term]:
        """Yields symbols outside of the statement, alone and in products of two factors."""
        for other in self._others:
            derived = differentiated_to(weight, other)
            if derived is not None:
                yield derived
        for other in self._others:
            for term in basis:
                if weight is None or _sum_is(other, term, weight):
                    yield from _pairs(other, term)
                    yield from _pairs(term, other)
                elif term.type.kind == "scalar" and term.weight is not None:
                    derived = differentiated_to(weight - term.weight, other)
                    if derived is not None:
                        yield from _pairs(term, derived)
                for rest in () if weight is None else [weight - order for order in self._orders]:
                    if _sum_is(other, term, rest):
                        yield from self._derivatives([*_pairs(other, term), *_pairs(term, other)])
        for left in self._others:
            for right in self._others if left.type.kind == "tensor" and weight is not None else ():
                if _sum_is(left, right, weight):
                    yield from _pairs(left, right)


def _sum_is(left: Term, right: Term, weight: Weight) -> bool:
    if left.weight is None or right.weight is None:
        return False
    return left.weight + right.weight == weight


def _basis(statement: Statement) -> Iterator[Term]:
    """Yields the symbols with up to one derivative more than occurs, vectors also as tensors, and other
    possible factors."""
    atoms = [atom for atom in atoms_of(statement) if isinstance(_without_dots(atom), Symbol)]
    yield from (atom for atom in atoms if isinstance(atom, Derivative) and not atom.order.is_number)
    highest = _highest_orders(atoms, statement)
    for body, most in highest.items():
        is_still = body.declaration.constant or body.type.kind in ("operator", "matrix")
        moving = 0 if is_still else most + 1
        for k in range(moving + 1):
            x = derivative(body, k) if k else body
            yield x
            if x.type.kind == "vector":
                yield apply("skew", x)
    yield from _operations_beside([term for _, term in places(statement)], highest)


def _without_dots(atom: Term) -> Term:
    return atom.body if isinstance(atom, Derivative) else atom


def _highest_orders(atoms: Iterable[Term], statement: Statement) -> dict[Symbol, int]:
    """The highest order to which each symbol is differentiated, alone or in an expression."""
    highest: dict[Symbol, int] = {}
    for atom in atoms:
        symbol, order = (atom.body, atom.order) if isinstance(atom, Derivative) else (atom, Linear(0))
        if isinstance(symbol, Symbol):
            highest[symbol] = max(highest.get(symbol, 0), int(order) if order.is_number else 0)
    for _, term in places(statement):
        if isinstance(term, Derivative) and term.order.is_number:
            for part in term.body.walk():
                if isinstance(part, Symbol) and part in highest:
                    highest[part] = max(highest[part], int(term.order))
    return highest


def _operations_beside(terms: Sequence[Term], symbols: Iterable[Symbol]) -> Iterator[Term]:
    """Operations that occur, on other symbols, and what stands in the statement that is no symbol."""
    applied = [term for term in terms if isinstance(term, Apply)]
    heads = {term.head for term in applied}
    of_tensors: tuple[Head, ...] = ("det", "trace", "adjugate")
    for head in of_tensors:
        if head in heads:
            yield from (apply(head, body) for body in symbols if body.type.kind == "tensor")
    yield from (apply("cos", each.arguments[0]) for each in applied if each.head == "sin")
    yield from (apply("sin", each.arguments[0]) for each in applied if each.head == "cos")
    for term in terms:
        is_derivative = isinstance(term, Derivative) and not isinstance(term.body, Symbol)
        if is_derivative or (isinstance(term, Apply) and term.head in OF_TENSORS):
            yield term
    if any(term.type.kind in ("tensor", "operator") for term in terms):
        yield identity()
    if any(term.type.dual for term in terms):
        yield dual_unit()


def _pairs(left: Term, right: Term) -> Iterator[Term]:
    if left == right and left.type.kind in ("vector", "tensor") and not isinstance(left, Identity):
        yield power(left, 2)
        if left.type.kind == "tensor":
            return
    if isinstance(left, Identity) or (isinstance(right, Identity) and left.type.kind != "scalar"):
        return
    for head in PRODUCTS:
        if head == "mul" and right.type.kind == "scalar":
            continue
        if head != "mul" and not left.type.kind == right.type.kind == "vector":
            continue
        if head in ("dot", "cross") and repr(left) >= repr(right):
            continue
        try:
            yield apply(head, left, right)
        except IllFormed:
            continue


def _may_grow_to(term: Term, weight: Weight) -> bool:
    """True if the term may be a factor of a product of this weight: weights of factors add up."""
    if weight is None or term.weight is None:
        return True
    rest = weight - term.weight
    return all(c >= 0 for _, c in rest.coefficients) and (rest.constant >= 0 or not rest.is_number)
