"""Formulas that are true under a condition by construction, each with points that meet the condition."""

from __future__ import annotations

from random import Random

from exact_values import Point, Value, added, constant, times, unit_vector
from exact_values import value as value_of
from formula_trees import Node, number, zero
from identity_pool import Condition, Identity, Pool, cross, ddt, dot, dotted, norm2, t


def under_a_condition(pool: Pool) -> Identity:
    """Sides of which the last is equal under the condition."""
    sides, condition = pool.random.choice(CONDITIONAL)(pool)
    return Identity("condition", tuple(sides), condition)


def _right_angle(a: Node, b: Node, sign: str) -> Condition:
    def meet(point: Point, random: Random) -> None:
        point[b.name] = value_of(cross(a, b), point)

    if sign == r"\perp":
        return Condition(a, sign, b, meet)
    return Condition(dot(a, b), "=", zero("scalar"), meet)


def _set_to(target: Node, tree: Node) -> Condition:
    def meet(point: Point, random: Random) -> None:
        point[target.name] = value_of(tree, point)

    return Condition(target, "=", tree, meet)


def _one_is_zero(f: Node, g: Node) -> Condition:
    def meet(point: Point, random: Random) -> None:
        point[random.choice((f, g)).name] = value_of(zero("scalar"), point)

    return Condition(f * g, "=", zero("scalar"), meet)


def _of_length_one(a: Node) -> Condition:
    def meet(point: Point, random: Random) -> None:
        point[a.name] = unit_vector(random)

    return Condition(norm2(a), "=", number(1), meet)


def _symmetric(m: Node) -> Condition:
    def meet(point: Point, random: Random) -> None:
        point[m.name] = [each + each.T for each in point[m.name]]

    return Condition(t(m), "=", m, meet)


def _commuting(m: Node, n: Node) -> Condition:
    def meet(point: Point, random: Random) -> None:
        value: Value = point[m.name]
        point[n.name] = added([2 * each for each in value], times(value, value))

    return Condition(m * n, "=", n * m, meet)


def _at_rest(f: Node) -> Condition:
    def meet(point: Point, random: Random) -> None:
        point[f.name] = constant(point[f.name][0])

    return Condition(dotted(f), "=", zero(f.kind), meet)


def _right_angles(p: Pool) -> tuple[list[Node], Condition]:
    a, b, c = p.letters("vector", 3)
    whole = p.random.choice((
        [norm2(a + b), norm2(a) + 2 * dot(a, b) + norm2(b), norm2(a) + norm2(b)],
        [norm2(a + b), norm2(a) + norm2(b)],
        [norm2(a - b), norm2(a) + norm2(b)],
        [cross(a, cross(b, c)), dot(a, c) * b],
        [norm2(cross(a, b)), norm2(a) * norm2(b)],
        [norm2(a + b), norm2(a - b)],
    ))  # fmt: skip
    return whole, _right_angle(a, b, p.random.choice(("=", "=", r"\perp")))


def _along(p: Pool) -> tuple[list[Node], Condition]:
    a, b, c = p.letters("vector", 3)
    whole = p.random.choice(([cross(a, b), zero("vector")], [dot(a, cross(b, c)), zero("scalar")]))
    return whole, _set_to(b, p.random.randint(2, 4) * a)


def _scalar_conditions(p: Pool) -> tuple[list[Node], Condition]:
    f, g, h = p.letters("scalar", 3)
    return p.random.choice((
        ([f * g + h, h], _set_to(f, zero("scalar"))),
        ([(f + g) ** 2, f**2 + g**2], _one_is_zero(f, g)),
        ([f * h, g * h], _set_to(f, g)),
        ([f**2 - g**2, (f - g) * (f + g), zero("scalar")], _set_to(f, g)),
    ))  # fmt: skip


def _other_conditions(p: Pool) -> tuple[list[Node], Condition]:
    a, b = p.letters("vector", 2)
    m, n = p.letters("matrix", 2)
    (f,) = p.letters("scalar", 1)
    df, da = dotted(f), dotted(a)
    return p.random.choice((
        ([norm2(a) * b, b], _of_length_one(a)),
        ([dot(m * a, b), dot(a, m * b)], _symmetric(m)),
        ([(m + n) * (m - n), m**2 - n**2], _commuting(m, n)),
        ([ddt(f * a), df * a + f * da, f * da], _at_rest(f)),
        ([ddt(cross(a, b)), cross(a, dotted(b))], _at_rest(a)),
    ))  # fmt: skip


CONDITIONAL = (_right_angles, _right_angles, _along, _scalar_conditions, _other_conditions)
