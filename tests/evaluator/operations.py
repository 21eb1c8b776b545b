"""What an operation is worth, given what its arguments are worth: nothing of a world, nothing symbolic."""

from __future__ import annotations

from math import comb, factorial

from evaluator.series import (
    Matrix,
    NotRead,
    Operator,
    Series,
    added,
    added_up,
    adjugate,
    axial,
    combined,
    constant,
    determinant,
    dot,
    each,
    exponential,
    hamilton,
    inverse,
    product,
    scaled,
    skew,
    turned,
)
from mpmath import mpf

from workbench.core.terms import Apply


def applied(term: Apply, values: list[Matrix | Operator]) -> Matrix:
    """The operation of the term on these values of its arguments."""
    match term.head, values:
        case "add", _:
            total = values[0]
            for value in values[1:]:
                total = added(total, value)
            return total
        case "mul", [p, q] if term.arguments[0].type.kind == "quaternion" and len(q) == 4:
            return hamilton(p, q)
        case "mul", [first, second] if _combines(term):
            return combined(first, second)
        case "quaternion", [s, v]:
            return [*s, *v]
        case "scalar part", [q]:
            return [q[0]]
        case "vector part", [q]:
            return q[1:]
        case "conjugate", [q]:
            return [q[0], *([-x] for (x,) in q[1:])]
        case "inverse", [q] if term.type.kind == "quaternion":
            return product([[dot(q, q)[0][0].inverse()]], [q[0], *([-x] for (x,) in q[1:])])
        case "mul", [first, second]:
            return first(second) if callable(first) else product(first, second)
        case "neg", [x]:
            return each(x, lambda entry: -entry)
        case "div", [x, y]:
            return product(inverse(y), x)
        case "dot", [x, y]:
            return dot(x, y)
        case "cross", [x, y]:
            return product(skew(x), y)
        case "outer", [x, y]:
            return product(x, turned(y))
        case "triple", [x, y, z]:
            return [[determinant(turned([[r[0] for r in v] for v in (x, y, z)]))]]
        case "skew", [x]:
            return skew(x)
        case "vect", [x]:
            return axial(x)
        case "symmetric", [x]:
            return scaled(added(x, turned(x)), mpf(1) / 2)
        case "antisymmetric", [x]:
            return scaled(added(x, scaled(turned(x), -1)), mpf(1) / 2)
        case "transpose", [x]:
            return turned(x)
        case "inverse", [x]:
            return inverse(x)
        case "adjugate", [x]:
            return adjugate(x)
        case "det", [x]:
            return [[determinant(x)]]
        case "trace", [x]:
            return [[added_up(x[i][i] for i in range(len(x)))]]
        case "re", [x]:
            return each(x, lambda entry: Series(entry.re))
        case "du", [x]:
            return each(x, lambda entry: Series(entry.du or (mpf(0),) * len(entry.re)))
        case "norm", [x]:
            return [[dot(x, x)[0][0].root()]]
        case "root", [[[x]]]:
            return [[x.root()]]
        case "cos", [[[x]]]:
            return [[x.circle()[0]]]
        case "sin", [[[x]]]:
            return [[x.circle()[1]]]
        case "exp", [q] if term.type.kind == "quaternion":
            return exponential(_from_the_left(q), [[constant(int(i == 0))] for i in range(4)])
        case "exp", [x]:
            return exponential(x)
    raise NotRead(f"the operation {term.head}")


def _from_the_left(q: Matrix) -> Matrix:
    """The matrix of p ↦ q p, column by column."""
    columns = [hamilton(q, [[constant(int(i == j))] for i in range(4)]) for j in range(4)]
    return [[column[i][0] for column in columns] for i in range(4)]


def counted(name: str, arguments: list[int]) -> int:
    """A factorial, a binomial or a multinomial coefficient."""
    top, *parts = arguments
    if top < 0:
        raise NotRead("a factorial of a negative number")
    if name == "factorial":
        return factorial(top)
    if name == "binomial":
        return comb(top, parts[0]) if parts[0] >= 0 else 0
    value = factorial(top)
    for part in parts:
        value //= factorial(part)
    return value


def _combines(term: Apply) -> bool:
    """Whether the matrix acts on the entries of a column of vectors or matrices."""
    left, right = term.arguments
    kinds = {left.type.kind, right.type.kind}
    return not kinds & {"scalar", "operator", "quaternion"} and left.type.columns != right.type.rows
