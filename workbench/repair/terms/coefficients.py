"""Search for rational coefficients of the printed addends that make an equation hold.

The contribution of each addend is the vector of its components at random points modulo the prime. The
equation requires that a linear combination of them is equal to the other side. Few changed coefficients are
tried before many.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from flint import nmod_mat

from workbench.core.terms import IllFormed, Relation, Term, Zero
from workbench.engines.jet.rings import PRIME
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.linear_places import addend_places, alone
from workbench.repair.terms.subterm_positions import Place, find, replaced, subterm
from workbench.repair.terms.term_arithmetic import times
from workbench.repair.terms.term_edits import without

#: The greatest numerator and denominator of a plausible misprint.
LARGEST = 720

#: The most coefficients that are changed at once, except all of them.
MOST_CHANGED = 4
_MOST_ADDENDS = 14

Vector = tuple[int, ...]


@dataclass(frozen=True)
class Scaling:
    """Addends of a relation by their positions, with the factors of their coefficients (0: dropped)."""

    factors: tuple[tuple[Place, Fraction], ...]


def scalings(relation: Relation, screen: Screen) -> Iterator[Scaling]:
    """Yields the fewest changes of coefficients that make left = right hold at the screen's points.

    First the left side is kept as printed, then the right side.
    """
    for free, fixed in ((1, 0), (0, 1)):
        side, other = (subterm(relation, (number,)) for number in (free, fixed))
        if isinstance(side, Zero):
            continue
        target = () if isinstance(other, Zero) else screen.components(other, side)
        found = False
        for chosen in addend_places(side):
            if isinstance(other, Zero) and len(chosen) < 2:
                continue
            columns = contributions(side, chosen, screen)
            if columns is None or target is None:
                continue
            goal = target or (0,) * len(columns[0])
            anchored = isinstance(other, Zero)
            for factors in fewest_changes(columns, goal, anchored):
                found = True
                yield Scaling(_together(dict(zip(chosen, factors, strict=True)), (), free))
        if found:
            return


def _together(
    factors: Mapping[Place, Fraction], under: Place, side: int
) -> tuple[tuple[Place, Fraction], ...]:
    """Returns the changed factors below a position; a single factor if all addends there share it."""
    below = {place: f for place, f in factors.items() if place[: len(under)] == under}
    values = set(below.values())
    if values == {Fraction(1)}:
        return ()
    if len(values) == 1 and (len(below) == 1 or 0 not in values):
        (value,) = values
        return (((side, *(under if len(below) > 1 else next(iter(below)))), value),)
    children = dict.fromkeys(place[len(under)] for place in below)
    return tuple(change for child in children for change in _together(below, (*under, child), side))


def contributions(side: Term, chosen: Sequence[Place], screen: Screen) -> list[Vector] | None:
    """Returns the contribution of each addend to the side."""
    columns = []
    for place in chosen:
        try:
            column = screen.components(alone(side, place), side)
        except IllFormed:
            return None
        if column is None:
            return None
        columns.append(column)
    return columns


def fewest_changes(
    columns: Sequence[Vector], target: Vector, anchored: bool = False
) -> Iterator[tuple[Fraction, ...]]:
    """Yields all ways to scale as few columns as possible so that they add up to the target.

    anchored: keep the first column (if the target is 0, any multiple of a solution is one).
    """
    if not columns or len(columns[0]) != len(target):
        return
    free = range(int(anchored), len(columns))
    if _with_changed(columns, [], target) is not None:
        return
    sizes = [k for k in range(1, len(free) + 1) if k <= MOST_CHANGED or k == len(free)]
    for size in sizes:
        if len(free) > _MOST_ADDENDS and size > 2:
            return
        found = False
        for changed in combinations(free, size):
            solution = _with_changed(columns, changed, target)
            if solution is not None and all(f != 1 for f in solution):
                found = True
                factors = dict(zip(changed, solution, strict=True))
                yield tuple(factors.get(i, Fraction(1)) for i in range(len(columns)))
        if found:
            return


def _with_changed(columns: Sequence[Vector], changed: Sequence[int], target: Vector) -> list[Fraction] | None:
    """Returns the factors of the changed columns, the others having factor 1.

    Returns None unless there is exactly one solution, in small numbers.
    """
    kept = [columns[i] for i in range(len(columns)) if i not in changed]
    rest = tuple((t - sum(column[row] for column in kept)) % PRIME for row, t in enumerate(target))
    if not changed:
        return [] if not any(rest) else None
    return combination([columns[i] for i in changed], rest)


def combination(columns: Sequence[Vector], target: Vector) -> list[Fraction] | None:
    """Returns the factors with which the columns add up to the target.

    Returns None unless there is exactly one solution, in small numbers.
    """
    size = len(columns)
    rows = [entry for row, b in enumerate(target) for entry in (*(column[row] for column in columns), b)]
    reduced, rank = nmod_mat(len(target), size + 1, rows, PRIME).rref()
    if rank != size or any(int(reduced[i, i]) != 1 for i in range(size)):
        return None
    factors = []
    for i in range(size):
        factor = rational(int(reduced[i, size]))
        if factor is None:
            return None
        factors.append(factor)
    return factors


def rational(residue: int, largest: int = LARGEST) -> Fraction | None:
    """Returns the fraction with numerator and denominator up to `largest` that has this residue; None if none
    has.

    There is at most one, as 2·largest² is below the prime.
    """
    above, below = (PRIME, residue % PRIME), (0, 1)
    while above[1] > largest:
        quotient = above[0] // above[1]
        above = (above[1], above[0] - quotient * above[1])
        below = (below[1], below[0] - quotient * below[1])
    if below[1] == 0 or abs(below[1]) > largest:
        return None
    return Fraction(above[1], below[1])


def factor_between(one: Vector, other: Vector) -> Fraction | None:
    """Returns the small number c ≠ 0 with other = c·one, if there is one; 1 if both vanish."""
    if len(one) != len(other):
        return None
    place = next((i for i, x in enumerate(one) if x), None)
    if place is None:
        return None if any(other) else Fraction(1)
    c = other[place] * pow(one[place], -1, PRIME) % PRIME
    if any((y - c * x) % PRIME for x, y in zip(one, other, strict=True)):
        return None
    return rational(c) or None


def scaled(relation: Relation, scaling: Scaling) -> Relation | None:
    """Returns the relation with the new coefficients; addends with factor 0 are removed.

    Returns None if a side would be empty, or if a new addend merges with the enclosing sum, which would shift
    earlier positions.
    """
    changed: Relation | None = relation
    for place, factor in sorted(scaling.factors, reverse=True):
        part = subterm(relation, place)
        if changed is None or find(changed, place) != part:
            return None
        changed = without(changed, place) if factor == 0 else replaced(changed, place, times(factor, part))
    return changed
