"""The identities of Remark 7 again, by the velocities of points, over SymPy's polynomials.

A point is on the axis of a motion iff its velocity v + ω × x is along ω, and a line meets an axis at
right angles iff it is normal to ω and holds such a point. No dual number is used. Two screws are
looked at in the frame of their common normal: the first axis is through the origin; if they are
oblique, along x, the second being in the plane z = l; if they are parallel, both are along z and the
second is through (l, 0, 0). Each function yields residuals; with sign −1, of something false.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

Vector = Sequence[Any]


def orthogonal(sign: int) -> Iterator[Any]:
    g = _ring("a1 a2 a3 v1 v2 v3 b1 b2 b3 w1 w2 w3")
    a, v, b, w = g[0:3], g[3:6], g[6:9], g[9:12]
    real = _cross(a, b)
    dual = _sum(_cross(a, w), _times(sign, _cross(v, b)))
    for omega, velocity in ((a, v), (b, w), (_sum(a, b), _sum(v, w))):
        yield _dot(real, omega)
        yield _dot(real, velocity) + _dot(dual, omega)


def axis(sign: int) -> Iterator[Any]:
    *g, s = _ring("a1 a2 a3 v1 v2 v3 s")
    omega, v = g[:3], g[3:]
    square, along = _dot(omega, omega), _dot(omega, v)
    point = _sum(_times(sign, _cross(omega, v)), _times(s, omega))  # times ω²
    velocity = _sum(_times(square, v), _cross(omega, point))
    yield from _sum(velocity, _times(-along, omega))
    moment = _sum(_times(square, v), _times(-along, omega))
    yield from _sum(moment, _times(-1, _cross(point, omega)))


def meeting(sign: int) -> Iterator[Any]:
    d1, e1, e2, length = _ring("d1 e1 e2 l")
    d, e, point = (d1, 0, 0), (e1, e2, 0), (0, 0, length)
    yield _dot(d, e) - d1 * e1
    yield _dot(d, _cross(point, e)) + sign * d1 * e2 * length


def only_one(sign: int) -> Iterator[Any]:
    """The line along z through (x, y, 0) meets the axes iff y = 0 and b₁ y − b₂ x = 0."""
    a1, b1, b2, length, x, y = _ring("a1 b1 b2 l x y")
    a, b = (a1, 0, 0), (b1, b2, 0)
    yield from _sum(_cross(a, b), (0, 0, -sign * a1 * b2))
    yield from _sum(_cross(a, _sum(a, b)), (0, 0, -a1 * b2))
    moment, direction = _cross((x, y, 0), (0, 0, 1)), (0, 0, 1)
    yield _dot(moment, a) - a1 * y
    yield _dot(moment, b) + _dot(direction, _cross((0, 0, length), b)) - b1 * y + b2 * x


def feet(sign: int) -> Iterator[Any]:
    """At (0, 0, z): the velocity's part across ω₁ + ω₂ is 0 where ‖ω₁ + ω₂‖² z is as stated."""
    a1, b1, b2, y, w, h, k, z = _ring("a1 b1 b2 y w h k z")
    a, b, point = (a1, 0, 0), (b1, b2, 0), (0, 0, z)
    c = _sum(a, b)
    velocity = _sum(
        _sum(_times(h, a), _cross(a, _sum(point, (0, 0, -y)))),
        _sum(_times(k, b), _cross(b, _sum(point, (0, 0, -w)))),
    )
    across = _cross(c, velocity)
    stated = (k - sign * h) * a1 * b2 + y * _dot(a, c) + w * _dot(b, c)
    yield from (across[0], across[1], across[2] - stated + _dot(c, c) * z)
    yield velocity[2]


def _parallel_pair() -> tuple[Any, ...]:
    """α, μ, l, pitches, s, and the two twists (ω, velocity of the origin)."""
    alpha, mu, length, h, k, s = _ring("a m l h k s")
    first = (0, 0, alpha), (0, 0, h * alpha)
    omega = (0, 0, mu * alpha)
    second = omega, _sum(_times(k, omega), _cross((length, 0, 0), omega))
    return alpha, mu, length, h, k, s, first, second


def _velocity(twists: Sequence[tuple[Vector, Vector]], point: Vector) -> Vector:
    total: Vector = (0, 0, 0)
    for omega, v in twists:
        total = _sum(total, _sum(v, _cross(omega, point)))
    return total


def between(sign: int) -> Iterator[Any]:
    alpha, mu, length, *_, (a, v), (b, w) = _parallel_pair()
    yield from _cross(a, b)
    moment = _sum(_cross(a, w), _cross(v, b))
    yield from _sum(moment, (-sign * mu * alpha**2 * length, 0, 0))


def third(sign: int) -> Iterator[Any]:
    alpha, mu, length, h, k, _s, first, second = _parallel_pair()
    (c, v) = _sum(first[0], second[0]), _sum(first[1], second[1])
    velocity = _sum(_times(1 + mu, v), _cross(c, (sign * mu * length, 0, 0)))
    yield from _sum(velocity, (0, 0, -(1 + mu) * alpha * (h + mu * k)))


def across(sign: int) -> Iterator[Any]:
    """The line along x through (0, 0, s) holds a point of each axis."""
    _alpha, mu, length, _h, _k, s, first, second = _parallel_pair()
    yield from _velocity([first], (0, 0, s))[:2]
    yield from _velocity([second], (sign * length, 0, s))[:2]
    c, v = _sum(first[0], second[0]), _sum(first[1], second[1])
    at_third = _sum(_times(1 + mu, v), _cross(c, (mu * length, 0, (1 + mu) * s)))
    yield from at_third[:2]


def no_others(sign: int) -> Iterator[Any]:
    alpha, t, length, _h, _k, s, *_ = _parallel_pair()
    a, between_points = (0, 0, alpha), (length, 0, t - s)
    along = _times(_dot(a, between_points), a)
    across_axes = _sum(_times(alpha**2, between_points), _times(-sign, along))
    yield from _sum(across_axes, (-(alpha**2) * length, 0, 0))


def one_line(sign: int) -> Iterator[Any]:
    alpha, mu, h, k, s = _ring("a m h k s")
    a, v = (0, 0, alpha), (0, 0, h * alpha)
    b, w = (0, 0, mu * alpha), (0, 0, k * mu * alpha)
    yield from _cross(a, b)
    yield from _sum(_cross(a, w), _cross(v, b))
    velocity = _velocity([(a, v), (b, w)], (0, 0, s))
    yield from _sum(velocity, (0, 0, -alpha * (h + sign * mu * k)))


def pencil(sign: int) -> Iterator[Any]:
    alpha, h, s, x, y = _ring("a h s x y")
    a, direction = (0, 0, alpha), (x, y, 0)
    yield _dot(a, direction)
    yield from _velocity([(a, (0, 0, h * alpha))], (0, (1 - sign) * x, s))[:2]


def opposite(sign: int) -> Iterator[Any]:
    alpha, length, h, k, s, x, y, z = _ring("a l h k s x y z")
    a, v = (0, 0, alpha), (0, 0, h * alpha)
    b = (0, 0, -alpha)
    w = _sum(_times(k, b), _cross((length, 0, 0), b))
    translation = (0, alpha * length, alpha * (h - sign * k))
    yield from _sum(_velocity([(a, v), (b, w)], (x, y, z)), _times(-1, translation))
    yield from _sum(_sum(_cross(a, w), _cross(v, b)), (alpha**2 * length, 0, 0))
    yield from _velocity([(a, v)], (0, 0, s))[:2]
    yield from _velocity([(b, w)], (length, 0, s))[:2]
    yield _dot((1, 0, 0), translation)


def opposite_on_one_line(sign: int) -> Iterator[Any]:
    alpha, h, k, x, y, z = _ring("a h k x y z")
    a, v = (0, 0, alpha), (0, 0, h * alpha)
    b, w = (0, 0, -alpha), (0, 0, -k * alpha)
    yield from _sum(_cross(a, w), _cross(v, b))
    velocity = _velocity([(a, v), (b, w)], (x, y, z))
    yield from _sum(velocity, (0, 0, -alpha * (h - sign * k)))


def translated(sign: int) -> Iterator[Any]:
    """The second axis is the z axis; the third is through (−v₂, v₁, 0) / β."""
    v1, v2, v3, beta, k, s = _ring("v1 v2 v3 b k s")
    v, b, w = (v1, v2, v3), (0, 0, beta), (0, 0, k * beta)
    yield from _sum(_cross(v, b), (-beta * v2, beta * v1, 0))
    velocity = _sum(_times(beta, _sum(v, w)), _cross(b, (-sign * v2, v1, beta * s)))
    yield from _sum(velocity, (0, 0, -beta * (v3 + k * beta)))
    yield _dot((-v2, v1, 0), v)


def translations(sign: int) -> Iterator[Any]:
    g = _ring("v1 v2 v3 w1 w2 w3")
    (v1, v2, v3), (w1, w2, w3) = g[:3], g[3:]
    normal = (v2 * w3 - sign * v3 * w2, v3 * w1 - v1 * w3, v1 * w2 - v2 * w1)
    for translation in (g[:3], g[3:], _sum(g[:3], g[3:])):
        yield _dot(normal, translation)


def _ring(names: str) -> list[Any]:
    from workbench.judge.second.sympy_gate import QQ, lex, polynomial_ring

    return list(polynomial_ring(names.split(), QQ, lex)[1:])


def _sum(a: Vector, b: Vector) -> Vector:
    return tuple(x + y for x, y in zip(a, b, strict=True))


def _times(c: Any, a: Vector) -> Vector:
    return tuple(c * x for x in a)


def _dot(a: Vector, b: Vector) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )
