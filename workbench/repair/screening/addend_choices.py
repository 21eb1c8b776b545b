"""Choices of one alternative for each addend of an equation: by their sum, or by the fewest marks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from heapq import heappop, heappush

from workbench.core.terms import Term
from workbench.engines.jet.rings import PRIME
from workbench.repair.screening.addend_sums import zero_sums
from workbench.repair.trees.lost_marks import Mark

#: The number of alternatives of each addend in successive rounds of the search for a zero sum.
_ROUNDS = (4, 12, 40, 100)
_FEW = 6

Marks = tuple[Mark, ...]


@dataclass(frozen=True)
class Alternative:
    """An alternative of an addend: its marks, the resulting term, and a number that represents its value."""

    marks: Marks
    term: Term
    value: int | None

    @property
    def cost(self) -> int:
        return sum(mark.cost for mark in self.marks)


@dataclass(frozen=True)
class AddendChoices:
    """The addends of an equation with their signs and alternatives, those with few marks first.

    Attributes:
        context: The marks outside of the addends.
    """

    context: Marks
    slots: list[tuple[int, list[Alternative]]]

    def that_add_up(self) -> Iterator[Marks]:
        """Yields choices whose values add up to 0, with more and more alternatives of each addend.

        The last rounds use all alternatives of one addend and a few of the others.
        """
        valued = [
            [(a, a.value) for a in alternatives if a.value is not None] for _, alternatives in self.slots
        ]
        if not all(valued):
            return
        rounds: list[list[int | None]] = [[width] * len(valued) for width in _ROUNDS]
        for deep in range(len(valued)):
            rounds.append([_FEW if place != deep else None for place in range(len(valued))])
        fitting: list[list[Alternative]] = []
        for number, widths in enumerate(rounds):
            if fitting and number <= len(_ROUNDS):
                break
            cut = [alternatives[:width] for alternatives, width in zip(valued, widths, strict=True)]
            values = [
                [sign * value % PRIME for _, value in alternatives]
                for (sign, _), alternatives in zip(self.slots, cut, strict=True)
            ]
            for places in zero_sums(values) or ():
                fitting.append([a[place][0] for a, place in zip(cut, places, strict=True)])
        fitting.sort(key=lambda chosen: sum(a.cost for a in chosen))
        yield from ((*self.context, *(m for a in chosen for m in a.marks)) for chosen in fitting)

    def cheapest(self, most: int) -> Iterator[Marks]:
        """Yields choices with the fewest marks."""
        ordered = [alternatives for _, alternatives in self.slots]
        start = (0,) * len(ordered)
        queue = [(sum(a[0].cost for a in ordered), start)]
        seen = {start}
        for _ in range(most):
            if not queue:
                return
            cost, places = heappop(queue)
            chosen = (a[place] for a, place in zip(ordered, places, strict=True))
            yield (*self.context, *(m for a in chosen for m in a.marks))
            for number, place in enumerate(places):
                if place + 1 < len(ordered[number]):
                    following = (*places[:number], place + 1, *places[number + 1 :])
                    if following not in seen:
                        seen.add(following)
                        more = ordered[number][place + 1].cost - ordered[number][place].cost
                        heappush(queue, (cost + more, following))
