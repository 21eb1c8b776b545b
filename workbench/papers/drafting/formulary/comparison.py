"""Comparison of a printed formula with a standard one, up to the names of symbols."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from workbench.papers.drafting.formulary.misprints import misprints_of
from workbench.papers.drafting.formulary.normal_sums import NO_CELL, Leaf, Monomial, Sum, leaves_of
from workbench.papers.drafting.formulary.renamings import Renaming, Search

#: The steps of a comparison.
_STEPS = 20_000
#: The factors that a misprint loses or inserts.
_FACTORS = frozenset(Fraction(text) for text in ["-1", "2", "-2", "1/2", "-1/2", "3", "1/3", "4", "1/4"])


@dataclass(frozen=True)
class Found:
    """How a standard formula becomes a printed one. is_equal: by names alone, else by a misprint, too."""

    renaming: Renaming
    is_equal: bool


def compared(standard: Sum, printed: Sum, by_letter: bool = False) -> Found | None:
    """Returns the renaming by which a standard formula is a printed one, or is but for one usual misprint.

    by_letter: symbols keep their letters.
    """
    if len(standard.monomials) != len(printed.monomials) or len(standard.monomials) < 2:
        return None
    search, known = Search(_STEPS), Renaming(by_letter=by_letter)
    near: Found | None = None
    for found in _found(standard, printed, known, search):
        if found.is_equal:
            return found
        near = near or found
    if near is None:
        for turned in _with_other_cells(printed):
            for found in _found(standard, turned, known, search):
                if found.is_equal:
                    return Found(found.renaming, is_equal=False)
    return near


def _found(standard: Sum, printed: Sum, known: Renaming, search: Search) -> Iterator[Found]:
    order = sorted(standard.monomials, key=lambda each: -sum(1 for _ in leaves_of(each)))
    leaves = list(dict.fromkeys(leaves_of(standard)))
    for renaming, ratios, left in _matched(order, printed.monomials, known, search, True):
        if left is None:
            common, count = Counter(ratios).most_common(1)[0]
            others = {each / common for each in ratios if each != common}
            if not others:
                yield Found(renaming, is_equal=True)
            elif len(others) == 1 and others <= _FACTORS and 2 * count >= len(ratios):
                yield Found(renaming, is_equal=False)
        elif len(set(ratios)) == 1:
            yield from _misprinted(*left, ratios[0], renaming, leaves, search)


def _misprinted(
    own: Monomial,
    printed: Monomial,
    ratio: Fraction,
    renaming: Renaming,
    leaves: Sequence[Leaf],
    search: Search,
) -> Iterator[Found]:
    """Yields the renamings that turn a misprint of a monomial into the printed one."""
    bases = {leaf.base for leaf in leaves}
    for changed in misprints_of(own, leaves):
        for found, factor in search.monomials(changed, printed, renaming):
            if factor == ratio and bases <= found.of.keys():
                yield Found(found, is_equal=False)


def _matched(
    ones: Sequence[Monomial],
    others: Sequence[Monomial],
    known: Renaming,
    search: Search,
    may_leave: bool,
) -> Iterator[tuple[Renaming, list[Fraction], tuple[Monomial, Monomial] | None]]:
    """Yields renamings that turn each monomial into a printed one up to a factor, but for one if they may."""
    if not ones:
        yield known, [], None
        return
    if len(ones) == 1 and may_leave:
        (own,), (other,) = ones, others
        exact = False
        for renaming, ratio in search.monomials(own, other, known):
            exact = True
            yield renaming, [ratio], None
        if not exact:
            yield known, [], (own, other)
        return
    for at, other in enumerate(others):
        rest = (*others[:at], *others[at + 1 :])
        for renaming, ratio in search.monomials(ones[0], other, known):
            for last, ratios, left in _matched(ones[1:], rest, renaming, search, may_leave):
                yield last, [ratio, *ratios], left
    if may_leave:
        for at, other in enumerate(others):
            rest = (*others[:at], *others[at + 1 :])
            for last, ratios, left in _matched(ones[1:], rest, known, search, False):
                assert left is None
                yield last, ratios, (ones[0], other)


def _with_other_cells(printed: Sum) -> Iterator[Sum]:
    """Yields a matrix with two rows or columns exchanged, and its transpose."""
    cells = [each.cell for each in printed.monomials if each.cell != NO_CELL]
    if not cells:
        return
    rows, columns = (1 + max(cell[axis] for cell in cells) for axis in (0, 1))
    for axis, count in ((0, rows), (1, columns)):
        for one in range(count):
            for other in range(one):
                swap = {one: other, other: one}
                yield _moved(printed, axis, swap)
    if rows > 1 and columns > 1:
        turned = [replace(each, cell=each.cell[::-1]) for each in printed.monomials]
        yield Sum(tuple(turned))


def _moved(printed: Sum, axis: int, to: dict[int, int]) -> Sum:
    def new(cell: tuple[int, int]) -> tuple[int, int]:
        row, column = (to.get(own, own) if k == axis else own for k, own in enumerate(cell))
        return row, column

    return Sum(tuple(replace(each, cell=new(each.cell)) for each in printed.monomials))
