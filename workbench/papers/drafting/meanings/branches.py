"""Equations of roots and inverse functions that are false on other branches only."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from random import Random
from typing import Any

from workbench.core.terms import Apply, Relation
from workbench.language.definitions import Definitions, expand
from workbench.papers.drafting.meanings.symbolic_values import NO_VALUE, symbolic

_BRANCHED = frozenset(("root", "norm", "arccos", "arcsin", "arctan", "atan2"))
#: The number of points, the largest value of a symbol there, and the largest difference of equal sides.
_POINTS, _MOST, _NEAR = 12, 1.5, 1e-9


def holds_on_a_branch(said: object, definitions: Definitions) -> bool:
    """True if a false equation of scalars with a root or an inverse function holds at some random points.

    A misprint holds at no point that is chosen at random. The sign of a root, or a multiple of π, matters at
    some points only.
    """
    match said:
        case Relation(operator="=", left=left, right=right) if left.type.kind == "scalar":
            with suppress(*NO_VALUE):
                sides = [expand(side, definitions) for side in (left, right)]
                heads = {part.head for side in sides for part in side.walk() if isinstance(part, Apply)}
                if heads & _BRANCHED:
                    one, other = (symbolic(side)[0] for side in sides)
                    return any(abs(each) < _NEAR for each in _values(one - other))
    return False


def _values(difference: Any) -> Iterator[complex]:
    random = Random(7)
    names = sorted(difference.free_symbols, key=str)
    for _ in range(_POINTS):
        point = {name: random.uniform(-_MOST, _MOST) for name in names}
        with suppress(*NO_VALUE):
            yield complex(difference.subs(point).evalf())
