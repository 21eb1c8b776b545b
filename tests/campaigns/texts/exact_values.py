"""Values of formulas at random points, in exact fractions: what tells true formulas from false ones here.

It shares nothing with the product. A value is a list of arrays: the quantity and its derivatives with respect
to time, from which products follow by Leibniz' rule."""

from __future__ import annotations

from fractions import Fraction
from math import comb
from random import Random

import numpy as np
from formula_trees import Node

#: How many derivatives a point has.
DEPTH = 3

Value = list[np.ndarray]
Point = dict[str, Value]


class MisfitError(ValueError):
    """Two sizes that do not go together."""


def times(left: Value, right: Value, product: object = None) -> Value:
    """The derivatives of a product, by Leibniz' rule."""
    join = product or _joined
    length = min(len(left), len(right))
    return [
        sum((comb(n, k) * join(left[k], right[n - k]) for k in range(1, n + 1)), join(left[0], right[n]))
        for n in range(length)
    ]


def _joined(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    left, right = np.asarray(left), np.asarray(right)
    if left.ndim == 0 or right.ndim == 0:
        return left * right
    if left.shape[1] != right.shape[0]:
        raise MisfitError(f"{left.shape} times {right.shape}")
    found = left @ right
    return found.reshape(()) if found.shape == (1, 1) else found


def _crossed(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    (a, b, c), (x, y, z) = left[:, 0], right[:, 0]
    return column(b * z - c * y, c * x - a * z, a * y - b * x)


def _dotted(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    return np.asarray((left * right).sum(), dtype=object)


def column(*entries: Fraction) -> np.ndarray:
    return np.array([[each] for each in entries], dtype=object)


def added(left: Value, right: Value, sign: int = 1) -> Value:
    if np.shape(left[0]) != np.shape(right[0]):
        raise MisfitError(f"{np.shape(left[0])} and {np.shape(right[0])}")
    return [x + sign * y for x, y in zip(left, right, strict=False)]


def over(value: Value, below: Value) -> Value:
    """The quotient by a scalar, one derivative after the other."""
    found: Value = []
    for n in range(min(len(value), len(below))):
        rest = value[n] - sum((comb(n, k) * found[n - k] * below[k] for k in range(1, n + 1)), 0 * value[n])
        found.append(rest / below[0])
    return found


def _skew(vector: np.ndarray) -> np.ndarray:
    x, y, z = vector[:, 0]
    return np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]], dtype=object)


def _det(matrix: np.ndarray) -> np.ndarray:
    a, b, c = (column(*row) for row in matrix)
    return _dotted(a, _crossed(b, c))


def fraction(random: Random) -> Fraction:
    return Fraction(random.choice((-1, 1)) * random.randint(1, 9), random.randint(1, 4))


def random_value(random: Random, kind: str) -> Value:
    shape = {"scalar": (), "angle": (), "vector": (3, 1), "matrix": (3, 3)}[kind]
    entries = int(np.prod(shape, dtype=int))
    return [
        np.array([fraction(random) for _ in range(entries)], dtype=object).reshape(shape)
        for _ in range(DEPTH)
    ]


def constant(value: np.ndarray) -> Value:
    return [value] + [0 * value] * (DEPTH - 1)


def one() -> Value:
    return constant(np.asarray(Fraction(1), dtype=object))


def unit_vector(random: Random) -> Value:
    """On the unit sphere at all times: its stereographic coordinates are random."""
    p, q = random_value(random, "scalar"), random_value(random, "scalar")
    squares = added(times(p, p), times(q, q))
    entries = ([2 * x for x in p], [2 * x for x in q], added(squares, one(), -1))
    return over([column(*parts) for parts in zip(*entries, strict=True)], added(squares, one()))


def rotation(random: Random) -> Value:
    """A rotation at all times, of a random quaternion."""
    w, v = random_value(random, "scalar"), random_value(random, "vector")
    turned = [_skew(each) for each in v]
    length = added(times(w, w), times(v, v, _dotted))
    sides = added(times(w, turned), times(turned, turned))
    return added(constant(identity(3)), over([2 * each for each in sides], length))


def identity(size: int) -> np.ndarray:
    return np.array([[Fraction(int(i == j)) for j in range(size)] for i in range(size)], dtype=object)


def circle(random: Random, rates: Value) -> tuple[Value, Value]:
    """Cosine and sine of an angle whose rates are given."""
    half = fraction(random)
    while abs(half) == 1:  # the cosine would be 0
        half = fraction(random)
    below = 1 + half * half
    c = [np.asarray((1 - half * half) / below, dtype=object)]
    s = [np.asarray(2 * half / below, dtype=object)]
    for n in range(1, DEPTH):
        c.append(-sum(comb(n - 1, k) * s[k] * rates[n - k] for k in range(n)))
        s.append(sum(comb(n - 1, k) * c[k] * rates[n - k] for k in range(n)))
    return c, s


def angular(turn: Value) -> Value:
    """The angular velocity of a rotation."""
    rate = times(turn[1:], [each.T for each in turn])
    return [column(each[2, 1], each[0, 2], each[1, 0]) for each in rate]


def value(node: Node, point: Point) -> Value:
    """The value of a tree. Raises MisfitError."""
    special = _SPECIAL.get(node.op)
    if special is not None:
        return special(node, point)
    args = [value(each, point) for each in node.args]
    return _OPERATIONS[node.op](*args)


def _leaf(node: Node, point: Point) -> Value:
    return point[node.name][node.order :]


def _zero(node: Node, point: Point) -> Value:
    rows, columns = node.size or {"scalar": (1, 1), "vector": (3, 1)}.get(node.kind, (3, 3))
    shape = () if (rows, columns) == (1, 1) else (rows, columns)
    return constant(
        np.full(shape, Fraction(0), dtype=object) if shape else np.asarray(Fraction(0), dtype=object)
    )


def _power(node: Node, point: Point) -> Value:
    base = value(node.args[0], point)
    found = base
    for _ in range(node.number - 1):
        found = times(found, base)
    return found


def _angle(node: Node, point: Point) -> tuple[Value, Value]:
    """Cosine and sine of a sum of angles or of an integer times an angle."""
    if node.op == "leaf":
        return point[f"cos {node.name}"], point[f"sin {node.name}"]
    if node.op == "minus":
        c, s = _angle(node.args[0], point)
        return c, [-each for each in s]
    parts = node.args if node.op == "sum" else (node.args[1],) * node.args[0].number
    c, s = _angle(parts[0], point)
    for part in parts[1:]:
        x, y = _angle(part, point)
        c, s = added(times(c, x), times(s, y), -1), added(times(c, y), times(s, x))
    return c, s


def _frame_rate(node: Node, point: Point) -> Value:
    turn, vector = point[f"frame {node.frames}"], value(node.args[0], point)
    local = times([each.T for each in turn], vector)
    return times(turn, local[1:])


def _turning(node: Node, point: Point) -> Value:
    within, of = (angular(point[f"frame {each}"]) for each in node.frames)
    return added(of, within, -1)


_SPECIAL = {
    "leaf": _leaf,
    "zero": _zero,
    "unit": lambda node, point: constant(identity((node.size or (3, 3))[0])),
    "number": lambda node, point: constant(np.asarray(Fraction(node.number), dtype=object)),
    "power": _power,
    "cos": lambda node, point: _angle(node.args[0], point)[0],
    "sin": lambda node, point: _angle(node.args[0], point)[1],
    "frame rate": _frame_rate,
    "angular velocity": _turning,
}


def _total(*terms: Value) -> Value:
    found = terms[0]
    for each in terms[1:]:
        found = added(found, each)
    return found


_OPERATIONS = {
    "sum": _total,
    "minus": lambda x: [-each for each in x],
    "product": times,
    "dot": lambda x, y: times(x, y, _dotted),
    "cross": lambda x, y: times(x, y, _crossed),
    "norm2": lambda x: times(x, x, _dotted),
    "over": over,
    "transpose": lambda x: [each.T for each in x],
    "inverse": lambda x: [each.T for each in x],  # only of rotations
    "skew": lambda x: [_skew(each) for each in x],
    "trace": lambda x: [np.asarray(each.trace(), dtype=object) for each in x],
    "det": lambda x: [_det(x[0])],
    "ddt": lambda x: x[1:],
}


def holds(left: Node, right: Node, point: Point) -> bool:
    """Whether two sides are equal at a point; not, where their sizes differ."""
    try:
        one_side, other = value(left, point)[0], value(right, point)[0]
    except MisfitError:
        return False
    return np.shape(one_side) == np.shape(other) and bool(np.all(one_side == other))
