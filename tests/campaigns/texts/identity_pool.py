"""True formulas by construction: identities in random letters, and random points to try them at."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from exact_values import Point, circle, random_value, rotation, unit_vector
from exact_values import value as value_of
from formula_trees import Node, apply, leaf, number, rate_in, turning, unit, zero

LETTERS = {"scalar": "fghk", "vector": "abcd", "matrix": "AST", "angle": (r"\theta", r"\phi")}
FRAMES = "NAB"


def dot(left: Node, right: Node) -> Node:
    return apply("dot", left, right)


def cross(left: Node, right: Node) -> Node:
    return apply("cross", left, right)


def norm2(vector: Node) -> Node:
    return apply("norm2", vector)


def tr(matrix: Node) -> Node:
    return apply("trace", matrix)


def t(tree: Node) -> Node:
    return apply("transpose", tree)


def skew(vector: Node) -> Node:
    return apply("skew", vector)


def ddt(tree: Node) -> Node:
    return apply("ddt", tree)


def dotted(tree: Node, order: int = 1) -> Node:
    return leaf(tree.name, tree.kind, order)


@dataclass(frozen=True)
class Condition:
    """What a formula holds under. left, sign, right: as it is written. meet: changes a point so that it is
    met; it may be met in several ways, by turns."""

    left: Node
    sign: str
    right: Node
    meet: Callable[[Point, Random], None]


@dataclass(frozen=True)
class Identity:
    """Sides that are equal, one after the other; the last one under the condition, if there is one."""

    family: str
    sides: tuple[Node, ...]
    condition: Condition | None = None


@dataclass
class Pool:
    """Random identities, and random points to try them at."""

    random: Random

    def letters(self, kind: str, count: int) -> list[Node]:
        return [leaf(name, kind) for name in self.random.sample(LETTERS[kind], count)]

    def mixed(self, kind: str, count: int) -> list[Node]:
        """Letters, or now and then a multiple or a sum of letters."""
        return [self._grown(each, kind) for each in self.letters(kind, count)]

    def _grown(self, node: Node, kind: str) -> Node:
        draw = self.random.random()
        if draw < 0.72:
            return node
        other = leaf(self.random.choice(LETTERS[kind]), kind)
        if draw < 0.82 or other == node:
            return self.random.randint(2, 5) * node
        multiple = other if draw < 0.92 else self.random.randint(2, 4) * other
        return node + multiple if self.random.random() < 0.6 else node - multiple

    def identity(self, family: str) -> Identity:
        make = self.random.choice(FAMILIES[family])
        made = make(self)
        return made if isinstance(made, Identity) else Identity(family, tuple(made))

    def point(self) -> Point:
        """Random values of all letters."""
        point: Point = {
            name: random_value(self.random, kind)
            for kind, names in LETTERS.items()
            for name in names
            if kind != "angle"
        }
        for name in LETTERS["angle"]:
            point[name] = random_value(self.random, "angle")
            point[f"cos {name}"], point[f"sin {name}"] = circle(self.random, point[name])
        point["x"], point["y"] = (random_value(self.random, "vector") for _ in "xy")
        point["u"], point["R"] = unit_vector(self.random), rotation(self.random)
        for frame in FRAMES:
            point[f"frame {frame}"] = rotation(self.random)
        return point


def defined(point: Point) -> None:
    """Sets what stands for other letters: n is a × b."""
    point["n"] = value_of(cross(leaf("a", "vector"), leaf("b", "vector")), point)


def _scalars(p: Pool) -> list[list[Node]]:
    f, g, h = p.mixed("scalar", 3)
    k, m = p.random.randint(2, 5), p.random.randint(2, 5)
    two = number(2)
    return [
        [f * (g + h), f * g + f * h],
        [(f + g) ** 2, f**2 + 2 * f * g + g**2],
        [(f - g) ** 2, f**2 - 2 * f * g + g**2],
        [(f + g) * (f - g), f**2 - g**2],
        [(f + g) ** 2 - (f - g) ** 2, 4 * f * g],
        [-((f - g) ** 2), -(f**2) + 2 * f * g - g**2],
        [(f + g) * (f + h), f**2 + f * h + g * f + g * h, f * (f + h) + g * (f + h)],
        [(f + g) ** 3, f**3 + 3 * f**2 * g + 3 * f * g**2 + g**3],
        [(f + g + h) ** 2, f**2 + g**2 + h**2 + 2 * f * g + 2 * g * h + 2 * f * h],
        [
            apply("over", f, number(k)) + apply("over", f, number(m)),
            apply("over", (k + m) * f, number(k * m)),
        ],
        [f * (g - h) + g * (h - f) + h * (f - g), zero("scalar")],
        [apply("over", f + g, two) - apply("over", f - g, two), g],
        [(f + k * g) ** 2, f**2 + 2 * k * f * g + k * k * g**2],
    ]


def _vectors(p: Pool) -> list[list[Node]]:
    a, b, c, d = p.mixed("vector", 4)
    (f,) = p.mixed("scalar", 1)
    return [
        [cross(a, b), -cross(b, a)],
        [dot(a, cross(b, c)), dot(b, cross(c, a)), dot(c, cross(a, b))],
        [cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c],
        [cross(a, b + c), cross(a, b) + cross(a, c)],
        [norm2(a + b), norm2(a) + 2 * dot(a, b) + norm2(b)],
        [norm2(a - b), norm2(a) - 2 * dot(a, b) + norm2(b)],
        [dot(a + b, a - b), norm2(a) - norm2(b)],
        [dot(cross(a, b), cross(c, d)), dot(a, c) * dot(b, d) - dot(a, d) * dot(b, c)],
        [norm2(cross(a, b)), norm2(a) * norm2(b) - dot(a, b) ** 2],
        [cross(a, cross(b, c)) + cross(b, cross(c, a)) + cross(c, cross(a, b)), zero("vector")],
        [dot(a, cross(a, b)), zero("scalar")],
        [cross(f * a, b), f * cross(a, b)],
        [-cross(a, b) + cross(b, a), 2 * cross(b, a)],
        [norm2(a + b) + norm2(a - b), 2 * norm2(a) + 2 * norm2(b)],
        [norm2(a + b) - norm2(a - b), 4 * dot(a, b)],
        [dot(a, f * b + c), f * dot(a, b) + dot(a, c)],
        [cross(a + b, a - b), -2 * cross(a, b)],
    ]


def _matrices(p: Pool) -> list[list[Node]]:
    m, n = p.letters("matrix", 2)
    a, b = p.letters("vector", 2)
    (f,) = p.letters("scalar", 1)
    return [
        [t(m * n), t(n) * t(m)],
        [t(m + n), t(m) + t(n)],
        [tr(m * n), tr(n * m)],
        [tr(t(m) * n), tr(t(n) * m)],
        [skew(a) * b, cross(a, b)],
        [t(skew(a)), -skew(a)],
        [skew(a) * skew(b), b * t(a) - dot(a, b) * unit()],
        [dot(a, m * b), dot(t(m) * a, b)],
        [(m + n) * (m - n), m**2 - m * n + n * m - n**2],
        [(m + n) ** 2, m**2 + m * n + n * m + n**2],
        [tr(a * t(b)), dot(a, b)],
        [m * (a + f * b), m * a + f * (m * b)],
        [apply("det", t(m)), apply("det", m)],
        [tr(m + f * unit()), tr(m) + 3 * f],
        [tr(skew(a) * skew(b)), -2 * dot(a, b)],
    ]


def _rates(p: Pool) -> list[list[Node]]:
    a, b = p.letters("vector", 2)
    f, g = p.letters("scalar", 2)
    (m,) = p.letters("matrix", 1)
    u = leaf("u", "vector")
    da, db, df, dg = (dotted(each) for each in (a, b, f, g))
    return [
        [ddt(f * g), df * g + f * dg],
        [ddt(f * a), df * a + f * da],
        [ddt(dot(a, b)), dot(da, b) + dot(a, db)],
        [ddt(cross(a, b)), cross(da, b) + cross(a, db)],
        [ddt(cross(a, da)), cross(a, dotted(a, 2))],
        [ddt(norm2(a)), 2 * dot(a, da)],
        [dot(u, dotted(u)), zero("scalar")],
        [-dot(u, dotted(u, 2)), norm2(dotted(u))],
        [ddt(f**2), 2 * f * df],
        [ddt(m * a), dotted(m) * a + m * da],
        [ddt(f**2 * g), 2 * f * df * g + f**2 * dg],
        [cross(u, cross(u, dotted(u))), -dotted(u)],
    ]


def _rotations(p: Pool) -> list[list[Node]]:
    a, b = p.letters("vector", 2)
    r, u = leaf("R", "matrix"), leaf("u", "vector")
    return [
        [r * t(r), unit()],
        [r * cross(a, b), cross(r * a, r * b)],
        [dot(r * a, r * b), dot(a, b)],
        [skew(r * a), r * skew(a) * t(r)],
        [dotted(r) * t(r) + r * t(dotted(r)), zero("matrix")],
        [apply("det", r), number(1)],
        [norm2(r * a), norm2(a)],
        [apply("inverse", r), t(r)],
        [cross(u, cross(u, a)), dot(u, a) * u - a],
        [norm2(cross(u, a)), norm2(a) - dot(u, a) ** 2],
        [skew(u) * skew(u), u * t(u) - unit()],
        [skew(u) * skew(u) * skew(u), -skew(u)],
    ]


def _angles(p: Pool) -> list[list[Node]]:
    x, y = p.letters("angle", 2)

    def c(tree: Node) -> Node:
        return apply("cos", tree)

    def s(tree: Node) -> Node:
        return apply("sin", tree)

    return [
        [c(x) ** 2 + s(x) ** 2, number(1)],
        [c(2 * x), c(x) ** 2 - s(x) ** 2, 2 * c(x) ** 2 - number(1)],
        [s(2 * x), 2 * s(x) * c(x)],
        [c(x + y), c(x) * c(y) - s(x) * s(y)],
        [s(x - y), s(x) * c(y) - c(x) * s(y)],
        [ddt(s(x)), dotted(x) * c(x)],
        [ddt(c(x)), -(dotted(x) * s(x))],
        [s(x) ** 2 - s(y) ** 2, s(x + y) * s(x - y)],
    ]


def _frames(p: Pool) -> list[list[Node]]:
    a, b, c = p.random.sample(FRAMES, 3)
    x, y = leaf("x", "vector"), leaf("y", "vector")
    w = turning(b, a)
    return [
        [rate_in(a, x), rate_in(b, x) + cross(w, x)],
        [turning(c, a), turning(b, a) + turning(c, b)],
        [turning(b, a), -turning(a, b)],
        [rate_in(a, w), rate_in(b, w)],
        [rate_in(b, x), rate_in(a, x) - cross(w, x)],
        [rate_in(a, x + y), rate_in(a, x) + rate_in(a, y)],
        [rate_in(a, cross(x, y)), cross(rate_in(a, x), y) + cross(x, rate_in(a, y))],
        [rate_in(a, x) - rate_in(b, x), cross(w, x)],
    ]


def _sizes(p: Pool) -> list[list[Node]]:
    a, b = p.letters("vector", 2)
    (m,) = p.letters("matrix", 1)
    r = leaf("R", "matrix")
    three, column = (3, 3), (3, 1)
    return [
        [r * t(r), unit(three)],
        [r - r, zero("matrix", three)],
        [cross(a, a), zero("vector", column)],
        [m * unit(three), m],
        [cross(a, b) + cross(b, a), zero("vector", column)],
        [t(r) * r - unit(three), zero("matrix", three)],
        [m * zero("vector", column), zero("vector", column)],
        [skew(a) + t(skew(a)), zero("matrix", three)],
    ]


def _definitions(p: Pool) -> list[list[Node]]:
    n, a, b, c = leaf("n", "vector"), *(leaf(each, "vector") for each in "abc")
    return [
        [dot(n, a), zero("scalar")],
        [dot(n, c), dot(c, cross(a, b)), dot(a, cross(b, c))],
        [cross(n, c), dot(a, c) * b - dot(b, c) * a],
        [norm2(n), norm2(a) * norm2(b) - dot(a, b) ** 2],
        [dotted(n), cross(dotted(a), b) + cross(a, dotted(b))],
        [dot(n, b), zero("scalar")],
    ]


def _choices(make: Callable[[Pool], list[list[Node]]]) -> tuple[Callable[[Pool], list[Node]], ...]:
    return (lambda pool: pool.random.choice(make(pool)),)


FAMILIES: dict[str, tuple[Callable[[Pool], list[Node]], ...]] = {
    "scalars": _choices(_scalars),
    "vectors": _choices(_vectors),
    "matrices": _choices(_matrices),
    "rates": _choices(_rates),
    "rotations": _choices(_rotations),
    "angles": _choices(_angles),
    "sizes": _choices(_sizes),
    "definitions": _choices(_definitions),
}
FRAME_FAMILY = {"frames": _choices(_frames)}
FAMILIES |= FRAME_FAMILY
