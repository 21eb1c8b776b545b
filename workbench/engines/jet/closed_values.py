"""Values of terms without symbols other than π, by SymPy to many digits."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from workbench.core.terms import (
    Apply,
    Block,
    Counting,
    Head,
    Identity,
    Integer,
    Number,
    Power,
    Relation,
    Symbol,
    Term,
    Zero,
)
from workbench.engines.inventory import NotExact
from workbench.engines.jet import sympy_gate as sympy

_DIGITS, _NEAR = 60, sympy.Float("1e-40")
_FUNCTIONS = {
    "sin": sympy.sin, "cos": sympy.cos, "exp": sympy.exp, "root": sympy.sqrt, "arccos": sympy.acos,
    "arcsin": sympy.asin, "arctan": sympy.atan, "atan2": sympy.atan2,
}  # fmt: skip


def _number(symbol: Symbol) -> Any:
    return sympy.pi


def nearly_equal(relation: Relation) -> bool:
    """True if each entry of left − right is 0 to forty decimals."""
    difference = expression(relation.left) - expression(relation.right)
    return all(abs(sympy.N(each, _DIGITS)) < _NEAR for each in difference)


def expression(term: Term, value_of: Callable[[Symbol], Any] = _number) -> Any:
    """Returns the term as a matrix. Raises NotExact.

    value_of: the scalar that a symbol stands for; π without it.
    """
    valued = partial(expression, value_of=value_of)
    match term:
        case Number(value=value):
            return sympy.Matrix([[sympy.Rational(value.numerator, value.denominator)]])
        case Integer(value=value):
            return sympy.Matrix([[int(value)]])
        case Counting(name="factorial", arguments=(n,)):
            return sympy.Matrix([[sympy.factorial(int(n))]])
        case Counting(name="binomial", arguments=(n, k)):
            return sympy.Matrix([[sympy.binomial(int(n), int(k))]])
        case Symbol():
            return sympy.Matrix([[value_of(term)]])
        case Zero():
            return sympy.zeros(term.type.rows, term.type.columns)
        case Identity():
            return sympy.eye(term.type.rows)
        case Power(base=base, exponent=exponent):
            value = valued(base)
            is_square = value.rows == value.cols
            return value ** int(exponent) if is_square else (value.T * value) ** (int(exponent) // 2)
        case Block(entries=rows):
            return sympy.Matrix.vstack(*(sympy.Matrix.hstack(*map(valued, row)) for row in rows))
        case Apply(head=head, arguments=arguments) if head in _FUNCTIONS and term.type.kind == "scalar":
            return sympy.Matrix([[_FUNCTIONS[head](*(valued(each)[0] for each in arguments))]])
        case Apply():
            return _applied(term.head, [valued(each) for each in term.arguments])
    raise NotExact("a term that is no number")


def _applied(head: Head, values: list[Any]) -> Any:
    first, last = values[0], values[-1]
    match head:
        case "add":
            return sum(values[1:], first)
        case "neg":
            return -first
        case "mul":
            is_scaled = (1, 1) in (first.shape, last.shape)
            scalar, other = (first, last) if first.shape == (1, 1) else (last, first)
            return scalar[0] * other if is_scaled else first * last
        case "div":
            return first / last[0]
        case "inverse":
            return first.inv()
        case "dot":
            return sympy.Matrix([[first.dot(last)]])
        case "cross":
            return first.cross(last)
        case "outer":
            return first * last.T
        case "triple":
            return sympy.Matrix([[sympy.Matrix.hstack(*values).det()]])
        case "skew":
            return _skew(first)
        case "norm":
            return sympy.Matrix([[sympy.sqrt((first.T * first)[0])]])
        case "transpose":
            return first.T
        case "trace":
            return sympy.Matrix([[first.trace()]])
        case "det":
            return sympy.Matrix([[first.det()]])
    raise NotExact(f"{head} of numbers")


def _skew(x: Any) -> Any:
    return sympy.Matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])
