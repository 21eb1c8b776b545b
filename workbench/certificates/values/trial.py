"""Trial of a theorem's equations on random motions, before Coq is asked."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import Protocol

from workbench.certificates.emission.collector import Collector
from workbench.certificates.emission.emitted_nodes import flag
from workbench.certificates.values.motion_instances import place
from workbench.certificates.values.trigonometric import (
    Pair,
    Values,
    Wave,
    flat,
    order,
    parsed,
    product,
    skew,
    value,
    wave,
)


class Theorem(Protocol):
    """A theorem.

    Attributes:
        emitter: The terms of its statement.
        goals: Pairs of sides, as deep copies.
    """

    @property
    def emitter(self) -> Collector: ...

    @property
    def goals(self) -> list[list[tuple[str, str]]]: ...


def can_be_certified(made: Theorem) -> bool:
    """True if Coq should be asked: sums and derivatives of order n are tried first."""
    return not made.emitter.composed or holds_whatever_they_are(made)


def holds_whatever_they_are(made: Theorem) -> bool:
    """True if the theorem's equations hold on a random motion that satisfies the premises."""
    chance, values, emitter = Random(0), {}, made.emitter
    if emitter.steps or emitter.circles or emitter.helpers:  # symbols that only a premise determines
        return False
    pairs = [pair for goals in made.goals for pair in goals]
    known = {place(origin.node): origin.meaning.deep for origin in emitter.origins if origin.how == "is"}
    said = {place(origin.node): origin.how for origin in emitter.origins if origin.how != "is"}
    sides = [side for pair in pairs for side in pair] + list(known.values())
    degree = 1 + len(known) + max(order(parsed(side), {}) for side in sides)
    known |= {_places(middle)[0]: deep for middle, deep in emitter.rates.items()}
    for number, (dual, kind, _) in enumerate(emitter.slots):
        if (where := (flag(dual), kind, str(number))) not in known:
            values[where] = _member(dual, kind, said.get(where, "free"), degree, chance)
    for where in known:
        _evaluate(where, known, values)
    return all(_agree(left, right, values) for left, right in pairs)


def _member(dual: bool, kind: str, said: str, degree: int, chance: Random) -> object:
    """Returns a random value with this property; constant rotations and unit vectors are sufficient."""
    degree = 0 if "constant" in said else degree
    if "rotation" not in said and "unit" not in said:
        return _any(dual, kind, degree, chance)
    rows = [[wave(Fraction(x, 25)) for x in row] for row in ((15, -16, 12), (20, 12, -9), (0, 15, 20))]
    member: Sequence[Sequence[Wave | Pair]] = rows
    if dual:
        moved = product(skew(_vector(False, 0, chance)), rows)
        member = [[Pair(x, y) for x, y in zip(*both, strict=True)] for both in zip(rows, moved, strict=True)]
    return member if "rotation" in said else [row[0] for row in member]


def _places(deep: str) -> list[tuple[str, str, str]]:
    return re.findall(r"\(Var (\w+) (\w+) (\d+)\)", deep)


def _evaluate(where: tuple[str, str, str], known: Mapping[tuple[str, str, str], str], values: Values) -> None:
    if where not in values:
        for other in _places(known[where]):
            _evaluate(other, known, values)
        values[where] = value(known[where], values)


def _agree(left: str, right: str, values: Values) -> bool:
    return flat(value(left, values)) == flat(value(right, values))


def _any(dual: bool, kind: str, degree: int, chance: Random) -> object:
    match kind:
        case "Scalar":
            return _scalar(dual, degree, chance)
        case "Vector":
            return _vector(dual, degree, chance)
    return [_vector(dual, degree, chance) for _ in range(3)]


def _vector(dual: bool, degree: int, chance: Random) -> list[Wave | Pair]:
    return [_scalar(dual, degree, chance) for _ in range(3)]


def _scalar(dual: bool, degree: int, chance: Random) -> Wave | Pair:
    def part() -> Wave:
        return Wave({(0, 0, power): Fraction(chance.randint(1, 10**9)) for power in range(degree + 1)})

    return Pair(part(), part()) if dual else part()
