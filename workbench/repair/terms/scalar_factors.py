"""Search for a scalar factor that is missing from an addend or must replace another one.

Random points determine the ratio by which one addend must change so that the equation holds. The factors are
looked up by their values there: scalars x of the statement, 1 ± x, 1/x, products and quotients of two.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import chain

from workbench.core.construct import apply, number, power
from workbench.core.terms import Apply, Head, IllFormed, Number, Relation, Symbol, Term, Zero
from workbench.engines.jet.rings import PRIME
from workbench.language.printing.printer import to_latex
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.changes import Candidate, Change
from workbench.repair.terms.coefficients import Vector, contributions
from workbench.repair.terms.linear_places import addend_places
from workbench.repair.terms.subterm_positions import Place, places, replaced, subterm

_MOST_TERMS = 60
_LARGEST = 7


@dataclass
class _Table:
    """Scalar terms by their values at the points; the smallest term of each value."""

    screen: Screen
    terms: dict[Vector, Term] = field(default_factory=dict)

    def add(self, term: Term) -> None:
        found = values_of(self.screen, term)
        if found is not None and 0 not in found:
            self.terms.setdefault(found, term)

    def with_pairs(self) -> None:
        singles = list(self.terms.items())
        inverses = [(tuple(pow(x, -1, PRIME) for x in values), term) for values, term in singles]
        for values, term in inverses:
            self.terms.setdefault(values, apply("div", number(1), term))
        ways: tuple[tuple[Head, list[tuple[Vector, Term]]], ...] = (("mul", singles), ("div", inverses))
        for head, factors in ways:
            for one, left in singles:
                for second, right in factors:
                    value = tuple(x * y % PRIME for x, y in zip(one, second, strict=True))
                    if value not in self.terms:
                        is_square = head == "mul" and left == right
                        self.terms[value] = power(left, 2) if is_square else apply(head, left, right)


def values_of(screen: Screen, scalar: Term) -> Vector | None:
    """Returns the values of a real scalar at the points."""
    found = screen.components(scalar, scalar)
    return None if found is None or any(found[1::2]) else found[::2]


def other_factors(relation: Relation, screen: Screen, replacements: Sequence[Term]) -> Iterator[Candidate]:
    """Yields the equation with one scalar factor inserted or changed so that it holds at the points."""
    table: _Table | None = None
    for free, fixed in ((1, 0), (0, 1)):
        side, other = subterm(relation, (free,)), subterm(relation, (fixed,))
        goal = None if isinstance(side, Zero) else screen.components(other, side)
        if goal is None:
            continue
        for chosen in dict.fromkeys(chain([((),)], _whole_addends(side), addend_places(side))):
            columns = contributions(side, chosen, screen)
            if columns is None or len(columns[0]) != len(goal):
                continue
            for at, column in zip(chosen, columns, strict=True):
                ratio = _needed(columns, column, goal, screen)
                if ratio is None:
                    continue
                table = table or _table(relation, screen, replacements)
                yield from _changed(relation, (free, *at), ratio, table)


def _whole_addends(side: Term) -> Iterator[tuple[Place, ...]]:
    """Yields the positions of the addends, brackets with sums in them as a whole."""
    if isinstance(side, Apply) and side.head == "add":
        yield tuple((number_,) for number_ in range(len(side.arguments)))


def _needed(columns: Sequence[Vector], column: Vector, goal: Vector, screen: Screen) -> Vector | None:
    """Returns the factor that the addend needs at each point; None if no factor makes the equation hold."""
    rest = [(g - sum(each[i] for each in columns) + column[i]) % PRIME for i, g in enumerate(goal)]
    size = len(goal) // len(screen.points)
    ratios = []
    for start in range(0, len(goal), size):
        own, wanted = column[start : start + size], rest[start : start + size]
        pivot = next((i for i, x in enumerate(own) if x), None)
        if pivot is None or not wanted[pivot]:
            return None
        ratio = wanted[pivot] * pow(own[pivot], -1, PRIME) % PRIME
        if any((w - ratio * x) % PRIME for w, x in zip(wanted, own, strict=True)):
            return None
        ratios.append(ratio)
    return tuple(ratios) if len(set(ratios)) > 1 else None  # constant ratios are handled as coefficients


def _table(relation: Relation, screen: Screen, replacements: Sequence[Term]) -> _Table:
    table = _Table(screen)
    scalars = [t for _, t in places(relation) if t.type.kind == "scalar" and not isinstance(t, Number)]
    scalars += [t for t in replacements if t.type.kind == "scalar" and isinstance(t, Symbol)]
    scalars += [
        apply("cos" if t.head == "sin" else "sin", t.arguments[0])
        for t in scalars
        if isinstance(t, Apply) and t.head in ("sin", "cos")
    ]
    whole = (relation.left, relation.right)  # a side that contains the other one states nothing
    small = sorted((term for term in dict.fromkeys(scalars) if term not in whole), key=_size)
    for term in [t for t in small if _size(t) <= _LARGEST][:_MOST_TERMS]:
        table.add(term)
    kept = [side for side in whole if side.type.kind == "scalar" and _size(side) <= _LARGEST]
    for term in [*table.terms.values(), *kept]:
        for sign in (apply("neg", term), term):
            with suppress(IllFormed):
                table.add(apply("add", number(1), sign))
    table.with_pairs()
    return table


def _size(term: Term) -> int:
    return sum(1 for _ in term.walk())


def _changed(relation: Relation, place: Place, ratio: Vector, table: _Table) -> Iterator[Candidate]:
    addend = subterm(relation, place)
    is_side = len(place) == 1 and not isinstance(addend, Number)
    for at, factor, is_below in [*_factors(addend, ()), ((), None, False)]:
        value = (1,) * len(ratio) if factor is None else values_of(table.screen, factor)
        if value is None:
            continue
        change = tuple(pow(x, -1, PRIME) for x in ratio) if is_below else ratio
        new = table.terms.get(tuple(x * y % PRIME for x, y in zip(value, change, strict=True)))
        several = new is not None and (_is_made_of_several(addend) or _is_made_of_several(new))
        if new is None or (is_side and factor is addend and several and not _adds_to(new, addend)):
            continue  # a whole side is not rewritten
        try:
            if factor is None:
                changed = replaced(relation, place, _multiplied(new, addend))
                said = f"insert the factor ${to_latex(new)}$ of ${to_latex(addend)}$"
            else:
                changed = replaced(relation, (*place, *at), new)
                said = f"change ${to_latex(factor)}$ to ${to_latex(new)}$"
        except IllFormed:
            continue
        kind = "coefficient" if factor is None else "symbol"
        likely = 1 if factor is None else 0 if is_below else 3
        yield Candidate(changed, (Change(kind, said),), None, (likely, _size(new)))


def _is_made_of_several(term: Term) -> bool:
    return isinstance(term, Apply) and term.head in ("add", "mul", "div", "neg")


def _adds_to(new: Term, addend: Term) -> bool:
    """True for 1 ± x, which keeps the x that is printed."""
    return (
        isinstance(new, Apply) and new.head == "add" and any(addend in part.walk() for part in new.arguments)
    )


def _multiplied(factor: Term, addend: Term) -> Term:
    match factor:
        case Apply(head="div", arguments=(Number(value=one), below)) if one == 1:
            return apply("div", addend, below)
    match addend:
        case Apply(head="neg", arguments=(inner,)):
            return apply("neg", _multiplied(factor, inner))
        case Apply(head="div", arguments=(Number(value=one), below)) if one == 1:
            return apply("div", factor, below)
        case Apply(head="div", arguments=(above, below)):
            return apply("div", apply("mul", factor, above), below)
        case Apply(head="mul", arguments=(Number() as first, rest)):
            return apply("mul", apply("mul", first, factor), rest)
        case Apply(head="mul", arguments=(first, rest)) if first.type.kind == "scalar":
            return apply("mul", _multiplied(factor, first), rest)
        case Number(value=one) if one == 1:
            return factor
    return power(factor, 2) if factor == addend else apply("mul", factor, addend)


def _factors(addend: Term, at: Place, is_below: bool = False) -> Iterator[tuple[Place, Term, bool]]:
    """Yields the scalar factors of an addend, with their positions in it, and whether they are in a
    denominator."""
    match addend:
        case Apply(head="neg", arguments=(inner,)):
            yield from _factors(inner, (*at, 0), is_below)
        case Apply(head="mul", arguments=arguments):
            for number_, argument in enumerate(arguments):
                yield from _factors(argument, (*at, number_), is_below)
        case Apply(head="div", arguments=(above, below)):
            yield from _factors(above, (*at, 0), is_below)
            yield from _factors(below, (*at, 1), not is_below)
        case _ if addend.type.kind == "scalar" and not isinstance(addend, Number):
            yield at, addend, is_below
