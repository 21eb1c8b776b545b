"""Values of the integer variables of a family of formulas."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.language.reader import Range

_MOST_INSTANCES = 1000
_FIRST_VALUES = 5
_ONE_ORDER = re.compile(r"\s*([A-Za-z](?:_(?:\d|\{\d+\}))?)\s*=\s*(\d{1,6})\s*\.\.\s*(\d{1,6})\s*")


@dataclass(frozen=True)
class Orders:
    """Ranges of integers such as `n = 1..8`, or `m = 1..3, n = 1..4`; ends included.

    Attributes:
        stated: The ranges that a formula states.
        endless: Variables without a last value; their ranges hold the first few.
    """

    ranges: Mapping[str, range]
    stated: tuple[Range, ...] = ()
    endless: frozenset[str] = frozenset()

    @staticmethod
    def parse(text: str) -> Orders:
        """Returns the orders that a text of the form `variable = first..last, …` states.

        Raises:
            ValueError: The text has another form.
        """
        ranges: dict[str, range] = {}
        for part in text.split(","):
            match = _ONE_ORDER.fullmatch(part)
            if match is None:
                raise ValueError(f"orders: expected `n = 1..8` or `m = 1..3, n = 1..4`, got {text!r}")
            name, first, last = match[1], int(match[2]), int(match[3])
            if first > last:
                raise ValueError(f"orders: {name} runs from {first} to {last}, which is empty")
            if name in ranges:
                raise ValueError(f"orders: {name} is given twice")
            ranges[name] = range(first, last + 1)
        count = 1
        for values in ranges.values():
            count *= len(values)
        if count > _MOST_INSTANCES:
            raise ValueError(f"orders: {count} instances, more than {_MOST_INSTANCES}")
        return Orders(ranges)

    @property
    def variables(self) -> tuple[str, ...]:
        return tuple(self.ranges)

    @property
    def generic(self) -> tuple[str, ...]:
        """The variables for which the formula states no range."""
        return tuple(each.variable for each in self.stated if each.generic)

    def holds(self, name: str, value: int) -> bool:
        """True if no stated range with numeric bounds excludes the value of the integer."""
        stated = [each for each in self.stated if each.variable == name and not each.generic]
        if not stated:
            return name not in self.ranges or name in self.generic or value in self.ranges[name]
        above = all(not each.lower.is_number or int(each.lower) <= value for each in stated)
        uppers = [each.upper for each in stated if each.upper is not None and each.upper.is_number]
        return above and all(value <= int(upper) for upper in uppers)

    def assignments(self) -> Iterator[dict[str, int]]:
        """Yields every combination of values within the stated ranges, the last variable fastest."""
        for chosen in product(*self.ranges.values()):
            values = dict(zip(self.ranges, chosen, strict=True))
            if all(_inside(stated, values) for stated in self.stated):
                yield values

    def __str__(self) -> str:
        parts = [f"{name} = {r.start}..{r.stop - 1}" for name, r in self.ranges.items()]
        for stated in self.stated:
            if not stated.lower.is_number:
                parts.append(f"{stated.variable} ≥ {stated.lower}")
            if stated.upper is not None and not stated.upper.is_number:
                parts.append(f"{stated.variable} ≤ {stated.upper}")
        return ", ".join(parts)


def _inside(stated: Range, values: Mapping[str, int]) -> bool:
    value = values[stated.variable]
    above = value >= int(stated.lower.substitute(values))
    return above and (stated.upper is None or value <= int(stated.upper.substitute(values)))


def orders_within(orders: Orders | None, stated: Sequence[Range]) -> Orders | None:
    """Returns the orders restricted to the ranges that a formula states; by default, the first few values.

    Raises:
        ValueError: The orders leave a range with numeric bounds, or lack one of its variables.
    """
    if not stated:
        return orders
    kept = replace(orders or _first_values(stated), stated=tuple(stated))
    bounds = [bound for each in stated for bound in (each.lower, each.upper) if bound is not None]
    for name in {each.variable for each in stated}.union(*(bound.variables for bound in bounds)):
        if name not in kept.ranges:
            raise ValueError(f"orders: expected values for {name} too")
    for each in stated:
        values = kept.ranges[each.variable]
        if not values:
            break
        below = each.lower.is_number and values[0] < int(each.lower)
        above = each.upper is not None and each.upper.is_number and values[-1] > int(each.upper)
        if below or above:
            raise ValueError(f"orders: {orders} leaves the range that the formula states")
    if next(kept.assignments(), None) is None:
        raise ValueError("orders: no values lie within the ranges that the formula states")
    return kept


def _first_values(stated: Sequence[Range]) -> Orders:
    lowest = {each.variable: int(each.lower) if each.lower.is_number else 0 for each in stated}
    last = max(lowest.values()) + _FIRST_VALUES - 1
    ranges = {}
    for each in stated:
        upper = int(each.upper) if each.upper is not None and each.upper.is_number else last
        ranges[each.variable] = range(lowest[each.variable], min(last, upper) + 1)
    return Orders(ranges, endless=frozenset(each.variable for each in stated if each.upper is None))
