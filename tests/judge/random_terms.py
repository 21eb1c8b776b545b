"""Random well-typed terms over a table of free symbols of every kind, for laws that must hold for all terms."""

from __future__ import annotations

from random import Random

from workbench.core.construct import (
    apply,
    derivative,
    dual_unit,
    identity,
    number,
    power,
    symbol,
    time_operator,
)
from workbench.core.names import Name
from workbench.core.terms import IllFormed, Term
from workbench.core.types import SCALAR, TENSOR, VECTOR, Declaration

SYMBOLS = {
    "scalar": [Declaration(Name("f"), SCALAR), Declaration(Name("c"), SCALAR).with_flags(constant=True)],
    "angle": [Declaration(Name(r"\alpha"), SCALAR), Declaration(Name(r"\beta"), SCALAR)],
    "dual angle": [Declaration(Name(r"\alpha", (r"\underline",)), SCALAR.with_dual(True))],
    "vector": [
        Declaration(Name("a"), VECTOR),
        Declaration(Name("b"), VECTOR),
        Declaration(Name("u"), VECTOR).with_flags(unit=True),
        Declaration(Name("e"), VECTOR).with_flags(unit=True, constant=True),
    ],
    "dual vector": [
        Declaration(Name("a", (r"\underline",)), VECTOR.with_dual(True)),
        Declaration(Name("u", (r"\underline",)), VECTOR.with_dual(True)).with_flags(unit=True),
    ],
    "tensor": [
        Declaration(Name("T"), TENSOR),
        Declaration(Name("R"), TENSOR).with_flags(rotation=True),
        Declaration(Name("R", (r"\underline",)), TENSOR.with_dual(True)).with_flags(rotation=True),
    ],
}


def random_term(random: Random, kind: str, depth: int, dual: bool = False) -> Term:
    """A term of the kind ("scalar", "vector", "tensor", "operator"), at most `depth` operations deep."""
    while True:
        try:
            return _term(random, kind, depth, dual)
        except IllFormed:  # an odd combination, such as the derivative of an operator
            continue


def _term(random: Random, kind: str, depth: int, dual: bool) -> Term:
    if depth <= 0:
        return _leaf(random, kind, dual)

    def sub(wanted: str) -> Term:
        return random_term(random, wanted, depth - 1, dual)

    choices = {
        "scalar": [
            lambda: apply("add", sub("scalar"), sub("scalar")),
            lambda: apply("mul", sub("scalar"), sub("scalar")),
            lambda: apply("dot", sub("vector"), sub("vector")),
            lambda: apply("triple", sub("vector"), sub("vector"), sub("vector")),
            lambda: apply("det", sub("tensor")),
            lambda: apply("trace", sub("tensor")),
            lambda: derivative(sub("scalar"), 1),
            lambda: power(sub("vector"), 2),
            lambda: apply(random.choice(("sin", "cos")), _angle(random, dual)),
            lambda: apply("div", sub("scalar"), sub("scalar")),
        ],
        "vector": [
            lambda: apply("add", sub("vector"), sub("vector")),
            lambda: apply("neg", sub("vector")),
            lambda: apply("cross", sub("vector"), sub("vector")),
            lambda: apply("mul", sub("tensor"), sub("vector")),
            lambda: apply("mul", sub("scalar"), sub("vector")),
            lambda: apply("vect", sub("tensor")),
            lambda: derivative(sub("vector"), random.choice((1, 1, 2))),
            lambda: apply("mul", sub("operator"), sub("vector")),
        ],
        "tensor": [
            lambda: apply("add", sub("tensor"), sub("tensor")),
            lambda: apply("mul", sub("tensor"), sub("tensor")),
            lambda: apply("skew", sub("vector")),
            lambda: apply("outer", sub("vector"), sub("vector")),
            lambda: apply(random.choice(("transpose", "symmetric", "antisymmetric")), sub("tensor")),
            lambda: apply("adjugate", sub("tensor")),
            lambda: apply("inverse", sub("tensor")),
            lambda: derivative(sub("tensor"), 1),
        ],
        "operator": [
            lambda: apply("add", sub("operator"), sub("tensor")),
            lambda: apply("compose", sub("operator"), sub("operator")),
            lambda: apply("compose", sub("operator"), sub("tensor")),
            lambda: apply("mul", sub("tensor"), sub("operator")),
        ],
    }
    return random.choice(choices[kind])()


def _leaf(random: Random, kind: str, dual: bool) -> Term:
    if kind == "operator":
        return time_operator()
    pool = list(SYMBOLS[kind])
    if dual and kind == "vector":
        pool += SYMBOLS["dual vector"]
    leaves = [symbol(d) for d in pool if dual or not d.type.dual]
    if kind == "scalar":
        leaves += [number(random.choice((-2, -1, 1, 3))), *([dual_unit()] if dual else [])]
    if kind == "tensor":
        leaves.append(identity())
    return random.choice(leaves)


def _angle(random: Random, dual: bool) -> Term:
    pool = SYMBOLS["angle"] + (SYMBOLS["dual angle"] if dual else [])
    angle = symbol(random.choice(pool))
    turned = apply("mul", number(random.choice((-1, 2, 3))), symbol(random.choice(pool)))
    return random.choice((angle, apply("neg", angle), apply("add", angle, turned)))
