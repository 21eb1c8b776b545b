"""Comparison of a printed formula with a standard one, up to the names of symbols."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import chain

from workbench.papers.drafting.formulary.misprints import misprints_of
from workbench.papers.drafting.formulary.normal_sums import NO_CELL, Monomial, Node, Sum, leaves_of
from workbench.papers.drafting.formulary.renamings import Renaming, Search, letter_of

#: The steps of a comparison.
_STEPS = 20_000
#: The factors that a misprint loses or inserts.
_FACTORS = frozenset(map(Fraction, ("-1", "2", "-2", "1/2", "-1/2")))


def renamings(standard: Sum, printed: Sum, by_letter: bool = False) -> Iterator[Renaming]:
    """Yields the renamings by which a standard formula is a printed one. by_letter: symbols keep their
    letters."""
    if _shapes(standard) == _shapes(printed):
        comparison = _Comparison(standard, frozenset(), Renaming(by_letter=by_letter, may_lower=True))
        yield from comparison.equal(printed)


def misprint_of(
    standard: Sum, printed: Sum, left: Collection[Monomial] = (), by_letter: bool = False
) -> Renaming | None:
    """Returns the renaming by which a printed formula is one usual misprint of a standard formula.

    left: the monomials of the left side, which is printed right.   by_letter: symbols keep their letters.
    """
    count = len(standard.monomials)
    if count != len(printed.monomials) or count < 2 or (_shapes(standard) - _shapes(printed)).total() > 1:
        return None
    comparison = _Comparison(standard, frozenset(left), Renaming(by_letter=by_letter))
    found = next(comparison.near(printed), None)
    if found is None and _shapes(standard) == _shapes(printed):
        found = next(chain.from_iterable(map(comparison.equal, _with_other_cells(printed))), None)
    return found


@lru_cache(maxsize=1 << 12)
def _shapes(own: Sum) -> Counter[object]:
    """Returns what of each monomial no renaming changes. A misprint changes that of one."""
    return Counter(
        (tuple(sorted(n for _, n in each.powers)), each.word is None, getattr(each.word, "head", ""))
        for each in own.monomials
    )


#: A renaming, the factor for each monomial, and the two monomials that are left.
_Match = tuple[Renaming, list[Fraction], tuple[Monomial, Monomial] | None]


class _Comparison:
    """The comparison of a standard formula with others."""

    def __init__(self, standard: Sum, left: frozenset[Monomial], known: Renaming) -> None:
        self.order = sorted(standard.monomials, key=lambda each: -sum(1 for _ in leaves_of(each)))
        self.leaves = list(dict.fromkeys(leaves_of(standard)))
        self.left, self.known, self.search = left, known, Search(_STEPS)

    def equal(self, printed: Sum) -> Iterator[Renaming]:
        """Yields the renamings that give a printed formula, or a multiple of it."""
        for renaming, ratios, _ in self._matched(self.order, printed.monomials, self.known, may_leave=False):
            if len(set(ratios)) == 1:
                yield renaming

    def near(self, printed: Sum) -> Iterator[Renaming]:
        """Yields the renamings that give a printed formula after one misprint."""
        for renaming, ratios, left in self._matched(self.order, printed.monomials, self.known):
            if left is not None:
                if len({*ratios}) == 1 and left[0] not in self.left:
                    yield from self._misprinted(*left, ratios[0], renaming)
                continue
            common, _ = Counter(ratios).most_common(1)[0]
            if len(self.order) == 2 and self.left:
                common = ratios[next(at for at, each in enumerate(self.order) if each in self.left)]
            others = [own for own, each in zip(self.order, ratios, strict=True) if each != common]
            factors = {each / common for each in ratios} - {1}
            if not factors or not factors <= _FACTORS or self._is_of_others(others, renaming):
                continue
            if self._is_one_change(others) and not self._has_lone_symbol(others):
                yield renaming

    def _is_one_change(self, changed: Sequence[Monomial]) -> bool:
        """True if one factor is changed: of one monomial, of the right side, or of a bracket."""
        if self.left.intersection(changed):
            return False
        rest = [each for each in self.order if each not in changed and each not in self.left]
        of_bracket = frozenset.intersection(*map(_factors, changed)).difference(*map(_factors, rest))
        return len(changed) == 1 or not rest or bool(of_bracket)

    def _is_of_others(self, changed: Sequence[Monomial], renaming: Renaming) -> bool:
        """True if the changed monomials have a number of their own, with another letter.

        A constant may have a factor in it: k = 2 c.
        """
        rest = {leaf.base for each in self.order if each not in changed for leaf in leaves_of(each)}
        own = {leaf.base for each in changed for leaf in leaves_of(each) if not leaf.order} - rest
        numbers = (each for each in own if each.type.kind == "scalar")
        return any(letter_of(each) != letter_of(renaming.of[each][0]) for each in numbers)

    def _has_lone_symbol(self, changed: Sequence[Monomial]) -> bool:
        """True if one of the changed monomials is a symbol that stands nowhere else."""
        rest = {leaf.base for each in self.order if each not in changed for leaf in leaves_of(each)}
        leaves = [list(leaves_of(each)) for each in changed]
        return any(len(each) == 1 and each[0].base not in rest for each in leaves)

    def _misprinted(
        self, own: Monomial, printed: Monomial, ratio: Fraction, renaming: Renaming
    ) -> Iterator[Renaming]:
        """Yields the renamings that turn a misprint of a monomial into the printed one."""
        bases = {leaf.base for leaf in self.leaves}
        for changed in misprints_of(own, self.leaves):
            for found, factor in self.search.monomials(changed, printed, renaming):
                if factor == ratio and bases <= found.of.keys() and not self._is_of_others([own], found):
                    yield found

    def _matched(
        self, ones: Sequence[Monomial], others: Sequence[Monomial], known: Renaming, may_leave: bool = True
    ) -> Iterator[_Match]:
        """Yields renamings that turn each monomial into a printed one up to a factor, but for one if they
        may."""
        if not ones:
            yield known, [], None
            return
        if len(ones) == 1 and may_leave:
            matched = list(self.search.monomials(ones[0], others[0], known))
            yield from ((renaming, [ratio], None) for renaming, ratio in matched)
            if not matched:
                yield known, [], (ones[0], others[0])
            return
        for at, other in enumerate(others):
            rest = (*others[:at], *others[at + 1 :])
            for renaming, ratio in self.search.monomials(ones[0], other, known):
                for last, ratios, left in self._matched(ones[1:], rest, renaming, may_leave):
                    yield last, [ratio, *ratios], left
        for at, other in enumerate(others if may_leave else ()):
            rest = (*others[:at], *others[at + 1 :])
            for last, ratios, _ in self._matched(ones[1:], rest, known, may_leave=False):
                yield last, ratios, (ones[0], other)


def _factors(own: Monomial) -> frozenset[object]:
    parts = own.word.parts if isinstance(own.word, Node) and own.word.head == "mul" else (own.word,)
    return frozenset((*own.powers, *parts)) - {None}


def _with_other_cells(printed: Sum) -> Iterator[Sum]:
    """Yields a column or row with two entries exchanged, and the transpose of another matrix.

    Exchanged columns may say that its variables stand in another order.
    """
    cells = [each.cell for each in printed.monomials if each.cell != NO_CELL]
    if not cells:
        return
    rows, columns = (1 + max(cell[axis] for cell in cells) for axis in (0, 1))
    if rows > 1 and columns > 1:
        turned = [replace(each, cell=each.cell[::-1]) for each in printed.monomials]
        yield Sum(tuple(turned))
        return
    for one in range(max(rows, columns)):
        for other in range(one):
            yield _moved(printed, int(columns > 1), {one: other, other: one})


def _moved(printed: Sum, axis: int, to: dict[int, int]) -> Sum:
    def new(cell: tuple[int, int]) -> tuple[int, int]:
        row, column = (to.get(own, own) if k == axis else own for k, own in enumerate(cell))
        return row, column

    return Sum(tuple(replace(each, cell=new(each.cell)) for each in printed.monomials))
