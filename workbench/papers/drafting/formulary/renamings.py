"""Renamings of symbols that turn one formula into another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from workbench.core.names import Name
from workbench.core.terms import Symbol, Term
from workbench.core.types import PI
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.formulary.normal_sums import Leaf, Monomial, Node, Part, Sum

#: The usual letters of angles.
_ANGLES = frozenset(
    rf"\{letter}" for letter in ("theta", "vartheta", "phi", "varphi", "psi", "alpha", "beta", "gamma", "nu")
)
#: Operations whose two parts may change places, and the sign that this gives.
_TURNED = {"dot": 1, "cross": -1}


#: So many letters are exchanged by mistake rather than by convention.
_FEWEST_EXCHANGED = 4


@dataclass(frozen=True)
class Renaming:
    """New names of symbols.

    of: symbol → the new one, and the order of its derivative that it stands for.
    by_letter: a symbol keeps its letter, in any typeface and with any label.
    may_lower: a symbol with another letter may stand for a rate.
    """

    of: Mapping[Term, tuple[Term, int]] = field(default_factory=dict)
    by_letter: bool = False
    may_lower: bool = False

    @property
    def alike(self) -> Fraction:
        """The share of the symbols that keep their letters."""
        pairs = [letter_of(own) == letter_of(new) for own, (new, _) in self.of.items()]
        return Fraction(sum(pairs), len(pairs)) if pairs else Fraction(0)

    def without_exchange(self) -> Renaming | None:
        """Returns the renaming with symbols by their own names, if it exchanges these; None if it does not.

        l_f and l_r are, if C_f keeps its name, and four letters or more of several; not θ and φ, which many
        name the other way, nor all members with the indices 1, 2 and 3.
        """
        names = self._names
        moved = {own for own, new in names.items() if own != new and new in names}
        is_closed = {names[own] for own in moved} == moved
        kept = {own for own, new in names.items() if own == new}
        labels = {own.scripts for own in moved}
        is_labelled = len({own.letter for own in moved}) == 1 and any(
            any(own.scripts) and own.scripts in labels for own in kept
        )
        is_of_letters = not any(map(any, labels)) and _FEWEST_EXCHANGED <= len(moved) <= len(kept)
        if not (is_closed and (is_labelled or is_of_letters)):
            return None
        news = [each for each in self.of.values() if isinstance(each[0], Symbol)]
        printed = {to_latex(new): (new, more) for new, more in news}
        return replace(self, of={own: printed.get(to_latex(own), as_is) for own, as_is in self.of.items()})

    @property
    def kept(self) -> int:
        """The number of symbols that keep their names."""
        return sum(own == new for own, new in self._names.items())

    @property
    def common(self) -> int:
        """The number of names on both sides."""
        return len({*self._names} & {*self._names.values()})

    @property
    def _names(self) -> dict[Name, Name]:
        return {
            own.declaration.name: new.declaration.name
            for own, (new, _) in self.of.items()
            if isinstance(own, Symbol) and isinstance(new, Symbol)
        }

    @property
    def letters(self) -> frozenset[str]:
        return frozenset(map(letter_of, self.of))

    def with_leaf(self, one: Leaf, other: Leaf) -> Renaming | None:
        """Returns the renaming that also turns one leaf into another; None if there is none."""
        known = self.of.get(one.base)
        if known is not None:
            base, more = known
            return self if base == other.base and one.order + more == other.order else None
        more = other.order - one.order
        if not _are_alike(one.base, other.base) or (one.order and more > 0):
            return None
        if more < 0 and (not self.may_lower or letter_of(one.base) == letter_of(other.base)):
            return None
        if (other.base, more) in self.of.values():
            return None
        if self.by_letter and letter_of(one.base) != letter_of(other.base):
            return None
        return replace(self, of={**self.of, one.base: (other.base, more)})


def letter_of(own: Term) -> str:
    """Returns the letter of a symbol without typeface, accents and labels; the same one for all angles."""
    return as_letter(own.declaration.name.letter) if isinstance(own, Symbol) else ""


def as_letter(letter: str) -> str:
    return "angle" if letter in _ANGLES else letter.lower()


def _are_alike(one: Term, other: Term) -> bool:
    """True if a symbol may stand for another one: both are numbers, columns, or square matrices."""
    if PI in (getattr(own, "declaration", None) for own in (one, other)):
        return one == other
    shapes = [
        (own.type.kind == "scalar", own.type.is_column, own.type.is_square, own.type.kind == "quaternion")
        for own in (one, other)
    ]
    return shapes[0] == shapes[1]


class Search:
    """A search of renamings, which ends after so many steps."""

    def __init__(self, steps: int) -> None:
        self.steps = steps

    def parts(self, one: Part, other: Part, known: Renaming) -> Iterator[tuple[Renaming, int]]:
        """Yields the renamings that turn one part into another up to a sign, with the sign."""
        self.steps -= 1
        if self.steps < 0:
            return
        match one, other:
            case Leaf(), Leaf():
                found = known.with_leaf(one, other)
                if found is not None:
                    yield found, 1
            case Sum(), Sum():
                for renaming, ratio in self.sums(one, other, known):
                    if abs(ratio) == 1:
                        yield renaming, int(ratio)
            case Node(), Node() if one.head == other.head and one.said == other.said:
                if len(one.parts) != len(other.parts):
                    return
                yield from self._in_order(one.parts, other.parts, known, one.head)
                if one.head in _TURNED and one.parts[0] != one.parts[1]:
                    for renaming, sign in self._in_order(one.parts[::-1], other.parts, known, one.head):
                        yield renaming, sign * _TURNED[one.head]

    def _in_order(
        self, ones: Sequence[Part], others: Sequence[Part], known: Renaming, head: str
    ) -> Iterator[tuple[Renaming, int]]:
        if not ones:
            yield known, 1
            return
        for renaming, sign in self.parts(ones[0], others[0], known):
            if sign < 0 and isinstance(ones[0], Sum):  # f(−x) is not −f(x)
                continue
            for last, rest in self._in_order(ones[1:], others[1:], renaming, head):
                yield last, sign * rest

    def sums(self, one: Sum, other: Sum, known: Renaming) -> Iterator[tuple[Renaming, Fraction]]:
        """Yields the renamings that turn one sum into another up to a factor, with the factor."""
        if len(one.monomials) == len(other.monomials):
            for renaming, ratios in self._pairs(one.monomials, other.monomials, known):
                if len(set(ratios)) <= 1:
                    yield renaming, next(iter(ratios), Fraction(1))

    def _pairs(
        self, ones: Sequence[Monomial], others: Sequence[Monomial], known: Renaming
    ) -> Iterator[tuple[Renaming, list[Fraction]]]:
        if not ones:
            yield known, []
            return
        for at, other in enumerate(others):
            for renaming, ratio in self.monomials(ones[0], other, known):
                for last, rest in self._pairs(ones[1:], (*others[:at], *others[at + 1 :]), renaming):
                    yield last, [ratio, *rest]

    def monomials(
        self, one: Monomial, other: Monomial, known: Renaming
    ) -> Iterator[tuple[Renaming, Fraction]]:
        """Yields the renamings that turn one monomial into another up to a factor, with the factor."""
        self.steps -= 1
        if self.steps < 0 or one.cell != other.cell or (one.word is None) != (other.word is None):
            return
        if sorted(n for _, n in one.powers) != sorted(n for _, n in other.powers):
            return
        ratio = other.factor / one.factor
        words: Iterator[tuple[Renaming, int]] = iter([(known, 1)])
        if one.word is not None and other.word is not None:
            words = self.parts(one.word, other.word, known)
        for renaming, sign in words:
            for last, own in self._powers(one.powers, other.powers, renaming):
                yield last, ratio * sign * own

    def _powers(
        self, ones: Sequence[tuple[Part, int]], others: Sequence[tuple[Part, int]], known: Renaming
    ) -> Iterator[tuple[Renaming, int]]:
        if not ones:
            yield known, 1
            return
        (part, exponent), *rest = ones
        for at, (other, own) in enumerate(others):
            if own == exponent:
                for renaming, sign in self.parts(part, other, known):
                    for last, more in self._powers(rest, (*others[:at], *others[at + 1 :]), renaming):
                        yield last, (sign if exponent % 2 else 1) * more
