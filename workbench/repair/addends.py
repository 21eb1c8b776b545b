"""Addends that may be missing: all short products of what a statement speaks of, by type and weight."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from workbench.language.construct import apply, derivative, identity, power
from workbench.language.integers import Linear
from workbench.language.terms import Apply, Derivative, IllFormed, Statement, Symbol, Term
from workbench.language.types import Weight
from workbench.repair.places import places
from workbench.repair.variants import atoms_of

#: Products of more factors than this, and more products than this, are not tried.
MOST_FACTORS = 4
MOST_PRODUCTS = 4000

_PAIRS = ("mul", "dot", "cross", "outer")


def missing_addends(
    statement: Statement, kind: str, weight: Weight, others: Sequence[Term] = ()
) -> list[Term]:
    """Products of up to MOST_FACTORS symbols, derivatives, tildes, of one kind and weight; short ones first.
    Without weights only products of two factors are tried. others: terms that may be factors of two."""
    most = MOST_FACTORS if weight is not None else 2
    levels: list[list[Term]] = [list(dict.fromkeys(_basis(statement)))]
    found = {t for t in levels[0] if (t.type.kind, t.weight) == (kind, weight)}
    ordered = [t for t in levels[0] if t in found]
    for factors in range(2, most + 1):
        level: dict[Term, None] = {}
        products = _products(levels, factors)
        for product in chain(_with_others(levels[0], others), products) if factors == 2 else products:
            if not _may_grow_to(product, weight):
                continue
            level[product] = None
            if (product.type.kind, product.weight) == (kind, weight) and product not in found:
                found.add(product)
                ordered.append(product)
            if len(level) + sum(map(len, levels)) > MOST_PRODUCTS:
                break
        levels.append(list(level))
    return ordered


def _with_others(basis: Sequence[Term], others: Sequence[Term]) -> Iterator[Term]:
    yield from others
    for other in others:
        for term in basis:
            yield from _pairs(other, term)
            yield from _pairs(term, other)


def _basis(statement: Statement) -> Iterator[Term]:
    """The symbols with up to one derivative more than occurs, vectors as tensors too."""
    highest: dict[Symbol, int] = {}
    for atom in atoms_of(statement):
        body, order = (atom.body, atom.order) if isinstance(atom, Derivative) else (atom, Linear(0))
        if order.is_number:
            highest[body] = max(highest.get(body, 0), int(order))
    for body, order in highest.items():
        is_still = body.declaration.constant or body.type.kind == "operator"
        moving = 0 if is_still else order + 1
        for k in range(moving + 1):
            x = derivative(body, k) if k else body
            yield x
            if x.type.kind == "vector":
                yield apply("skew", x)
    for _, term in places(statement):
        if isinstance(term, Apply) and term.head in ("det", "trace", "skew", "vect", "transpose", "adjugate"):
            yield term
    if any(term.type.kind == "tensor" for _, term in places(statement)):
        yield identity()


def _products(levels: list[list[Term]], factors: int) -> Iterator[Term]:
    for size in range(1, factors):
        for left in levels[size - 1]:
            for right in levels[factors - size - 1]:
                yield from _pairs(left, right)


def _pairs(left: Term, right: Term) -> Iterator[Term]:
    if left.type.kind == right.type.kind == "vector" and left == right:
        yield power(left, 2)
    for head in _PAIRS:
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
    """Weights of factors only add up."""
    if weight is None or term.weight is None:
        return True
    rest = weight - term.weight
    return all(c >= 0 for _, c in rest.coefficients) and (rest.constant >= 0 or not rest.is_number)

