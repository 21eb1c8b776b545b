"""One fault in a true formula, and what is true of the result, by its values at random points."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random

from conditional_pool import under_a_condition
from exact_values import Point, holds
from formula_trees import Node, leaf
from identity_pool import FRAMES, LETTERS, Condition, Pool, defined

#: At how many points a formula is looked at.
LOOKS = 4

TRUE, FALSE, UNDER = "true", "false", "under its condition"


@dataclass(frozen=True)
class Stated:
    """Sides of one statement in a text; truths: of each step from one side to the next."""

    family: str
    sides: tuple[Node, ...]
    truths: tuple[str, ...]
    condition: Condition | None = None


class Stating:
    """Makes statements whose truth is known. Points are drawn once and used again."""

    def __init__(self, random: Random) -> None:
        self.random = random
        self.pool = Pool(random)
        self.points = [self.pool.point() for _ in range(12)]

    def stated(self, family: str, share_of_false: float = 0.35) -> Stated:
        """A statement of one family; of a share of them one side has a fault."""
        while True:
            made = under_a_condition(self.pool) if family == "condition" else self.pool.identity(family)
            if any(left == right for left, right in zip(made.sides, made.sides[1:], strict=False)):
                continue
            sides = made.sides
            if self.random.random() < share_of_false:
                sides = self._with_a_fault(sides)
            elif self.random.random() < 0.15 and made.condition is None:
                sides = tuple(reversed(sides))
            truths = self._truths(sides, made.condition)
            if truths is not None:
                return Stated(made.family, sides, truths, made.condition)

    def negated(self, stated: Stated) -> Stated:
        """The same with the other sign on all sides, so that a row may begin with a sign."""
        if any(each.op in ("zero", "number") for each in stated.sides):
            return stated
        return replace(stated, sides=tuple(-each for each in stated.sides))

    def without_its_condition(self) -> Stated:
        """A statement that is false, since the condition that it needs is not printed."""
        made = self.stated("condition", 0)
        truths = tuple(FALSE if each == UNDER else each for each in made.truths)
        return replace(made, family="no condition", truths=truths, condition=None)

    def _with_a_fault(self, sides: tuple[Node, ...]) -> tuple[Node, ...]:
        place = self.random.randrange(1, len(sides))
        found = list(faults(sides[place], self.random))
        faulty = self.random.choice(found) if found else sides[place]
        return (*sides[:place], faulty, *sides[place + 1 :])

    def _truths(self, sides: tuple[Node, ...], condition: Condition | None) -> tuple[str, ...] | None:
        """None where a step is true at some points only."""
        found = []
        for left, right in itertools.pairwise(sides):
            if left == right:
                return None
            seen = self._seen(left, right, None)
            if seen is False and condition is not None:
                seen = self._seen(left, right, condition)
                found.append(UNDER if seen else FALSE)
            else:
                found.append(TRUE if seen else FALSE)
            if seen is None:
                return None
        return tuple(found)

    def _seen(self, left: Node, right: Node, condition: Condition | None) -> bool | None:
        count = LOOKS if condition is None else 2 * LOOKS
        results = {holds(left, right, point) for point in self._drawn(count, condition)}
        return results.pop() if len(results) == 1 else None

    def _drawn(self, count: int, condition: Condition | None) -> Iterator[Point]:
        for point in self.random.sample(self.points, count):
            changed = dict(point)
            if condition is not None:
                condition.meet(changed, self.random)
            defined(changed)
            yield changed


def faults(tree: Node, random: Random) -> Iterator[Node]:
    """The trees with one fault."""
    if tree.op != "zero":
        yield -tree
    for path, node in tree.nodes():
        for other in _others(node, random):
            yield tree.with_node(path, other)


def _others(node: Node, random: Random) -> Iterator[Node]:
    make = _FAULTS.get(node.op)
    if make is not None:
        yield from make(node, random)


def _of_a_leaf(node: Node, random: Random) -> Iterator[Node]:
    names = LETTERS.get(node.kind, ())
    if node.name in names:
        yield leaf(random.choice([each for each in names if each != node.name]), node.kind, node.order)
    if node.order:
        yield replace(node, order=3 - node.order)


def _of_a_sum(node: Node, random: Random) -> Iterator[Node]:
    place = random.randrange(len(node.args))
    yield replace(node, args=(*node.args[:place], -node.args[place], *node.args[place + 1 :]))
    rest = (*node.args[:place], *node.args[place + 1 :])
    yield replace(node, args=rest) if len(rest) > 1 else rest[0]


def _of_a_size(node: Node, random: Random) -> Iterator[Node]:
    if node.size is None:
        return
    sizes = (
        ((2, 2), (4, 4), (6, 6)) if node.op == "unit" else ((3, 3), (3, 1), (4, 1), (6, 1), (1, 3), (4, 4))
    )
    for size in sizes:
        if size != node.size:
            yield replace(node, size=size)


def _of_frames(node: Node, random: Random) -> Iterator[Node]:
    if node.op == "frame rate":
        others = [each for each in FRAMES if each != node.frames]
        yield replace(node, frames=random.choice(others))
    else:
        within, of = node.frames
        (other,) = [each for each in FRAMES if each not in node.frames]
        yield replace(node, frames=of + within)
        yield replace(node, frames=random.choice((within + other, other + of)))


def _of_a_transpose(node: Node, random: Random) -> Iterator[Node]:
    if node.args[0].kind == "matrix":
        yield node.args[0]


_FAULTS = {
    "leaf": _of_a_leaf,
    "sum": _of_a_sum,
    "number": lambda node, random: iter([replace(node, number=node.number + 1)]),
    "power": lambda node, random: iter([replace(node, number=node.number + 1)]),
    "cross": lambda node, random: iter([replace(node, args=node.args[::-1])]),
    "cos": lambda node, random: iter([replace(node, op="sin")]),
    "sin": lambda node, random: iter([replace(node, op="cos")]),
    "transpose": _of_a_transpose,
    "zero": _of_a_size,
    "unit": _of_a_size,
    "frame rate": _of_frames,
    "angular velocity": _of_frames,
}
