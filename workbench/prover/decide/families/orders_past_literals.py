"""Orders past the literals of a formula: what holds for n = 0, …, 4 may fail past the 4 of Σ_{k=0}^{4}.

Endless ranges are also tested there, to find refutations.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Protocol

from workbench.core.integer_expressions import Linear
from workbench.core.terms import BigSum, Counting, Derivative, Integer, Power, Symbol, Term
from workbench.language.definitions import Definitions

#: Larger literals are not tested.
_LARGEST = 12

#: Number of members of a family that are tested one by one when a proof covers all of them.
FIRST = 3


class OrderRanges(Protocol):
    """The values of a family's integer variables, such as `context.index_values.Orders`.

    generic: variables without a stated range; their values are only examples.
    endless: variables without a last value, whose first few values nobody chose.
    """

    @property
    def generic(self) -> tuple[str, ...]: ...

    @property
    def endless(self) -> frozenset[str]: ...

    def assignments(self) -> Iterator[dict[str, int]]: ...


@dataclass(frozen=True)
class FirstMembers:
    """The first few values of each integer, used as the orders of a family.   endless: the integers for which
    these are examples only."""

    least: Mapping[str, int]
    generic: tuple[str, ...] = ()  # a range is stated for each
    endless: frozenset[str] = frozenset()

    def assignments(self) -> Iterator[dict[str, int]]:
        values: list[dict[str, int]] = [{}]
        for name, least in self.least.items():
            values = [{**v, name: least + k} for v in values for k in range(FIRST)]
        return iter(values)

    def __str__(self) -> str:
        return ", ".join(f"{name} = {least}..{least + FIRST - 1}" for name, least in self.least.items())


def values_past_literals(
    terms: Iterable[Term], definitions: Definitions, orders: OrderRanges
) -> Iterator[Mapping[str, int]]:
    """Yields values at and past the largest number in the terms and in the definitions of their symbols."""
    first, *others = orders.assignments()
    last = others[-1] if others else first
    largest = max((n for n in _numbers(terms, definitions) if n <= _LARGEST), default=0)
    further = {name: [n for n in (largest, largest + 1) if n > last[name]] for name in orders.endless}
    choices = [(value, *further.get(name, ())) for name, value in first.items()]
    for chosen in product(*choices):
        values = dict(zip(first, chosen, strict=True))
        if values != first:
            yield values


def integer_past_literals(terms: Iterable[Term], definitions: Definitions) -> int | None:
    """Returns an integer past all literals of the terms; None if it would be large."""
    largest = max(_numbers(terms, definitions), default=0)
    return largest + 1 if largest <= _LARGEST else None


def _numbers(terms: Iterable[Term], definitions: Definitions) -> Iterator[int]:
    for part in dict.fromkeys(definitions.reached(*terms)):
        yield from (abs(linear.constant) for linear in _linear(part))
        if isinstance(part, Symbol):
            own = definitions.about(part)
            yield from (abs(place.constant) for definition in own for place in definition.index)


def _linear(term: Term) -> tuple[Linear, ...]:
    match term:
        case Symbol(index=index):
            return index
        case Derivative(order=value) | Power(exponent=value) | Integer(value=value):
            return (value,)
        case Counting(arguments=arguments):
            return arguments
        case BigSum(lower=lower, upper=upper):
            return (upper,) if lower is None else (lower, upper)
    return ()
