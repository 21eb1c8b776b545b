"""Data types of the context: facts about symbols, and the context of a claim."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from fractions import Fraction
from math import cos, sin
from typing import NamedTuple

from workbench.context.index_values import Orders
from workbench.core.hypotheses import Phrase
from workbench.core.names import Name
from workbench.core.terms import Definition, Relation, Statement, Symbol, Term
from workbench.core.verdict import Strength


class Duration(StrEnum):
    """The time at which a fact holds."""

    INSTANT = "at the instant"
    ALWAYS = "always"


class Act(StrEnum):
    """The act of the author in writing a formula."""

    ASSERT = "asserts"
    DEFINE = "defines"
    POSTULATE = "postulates"
    CONSTRAIN = "constrains"  # an equation for an undefined symbol that occurs once in it
    ASSIGN = "assigns"


class Provider(StrEnum):
    """The source of a fact."""

    FORMULA = "formula"
    LAW = "law"  # a formula that contains the rate of a symbol
    CONDITION = "condition"
    SENTENCE = "sentence"
    UNREAD = "unread"
    CONVENTION = "convention"


@dataclass(frozen=True)
class Origin:
    """The provider, the text, and the position in the text.

    text: LaTeX, or the words of a sentence or convention, with formulas between dollar signs."""

    provider: Provider
    text: str
    place: str = ""

    @property
    def phrase(self) -> Phrase:
        return Phrase(self.text, self.provider in (Provider.SENTENCE, Provider.CONVENTION))

    def __str__(self) -> str:
        prose = self.phrase.prose
        return f"{prose} ({self.place})" if self.place else prose


@dataclass(frozen=True)
class Supposition:
    """The meaning of a property for its symbols: the terms that replace them, and equations."""

    terms: tuple[tuple[Name | Symbol, Term], ...] = ()
    equations: tuple[Relation, ...] = ()


_TURNS: dict[str, Callable[[Fraction], float]] = {"\\sin": sin, "\\cos": cos}
#: A rounded sine this close to a bound counts as one that does not satisfy it.
_CLOSE = Fraction(1, 10**9)


class Bound(NamedTuple):
    """A bound for the values of a symbol, as in x > 0."""

    symbol: str
    sign: str
    number: Fraction

    def allows(self, values: Mapping[str, tuple[str, ...]]) -> bool:
        """True if the value of the symbol satisfies the bound, or if the symbol has no value.

        The symbol may be the sine or cosine of an angle that has a value; it is exact for the angle 0 only.
        """
        head, _, angle = self.symbol.partition(" ")
        turned = _TURNS.get(head) if self.symbol not in values else None
        name = self.symbol if turned is None else angle
        if name not in values:
            return True
        try:
            value = Fraction(values[name][0])
        except ValueError:
            return False
        if turned is not None:
            angle_value, value = value, Fraction(turned(value))
            if angle_value and abs(value - self.number) < _CLOSE:
                return False
        return {
            "<": value < self.number,
            ">": value > self.number,
            "≤": value <= self.number,
            "≥": value >= self.number,
            "≠": value != self.number,
        }[self.sign]


@dataclass(frozen=True)
class Fact:
    """One fact about symbols.

    Attributes:
        content: None if the fact is not formalized ("opaque"): it lowers a grade and decides nothing.
        bound: A bound for the values of a symbol.
        act: The act of the formula that the fact comes from.
        earlier: Whether it stands before the claim.
        orders: The values of the integers of which it is said; None for any.
    """

    content: Definition | Statement | Supposition | None
    about: frozenset[Name]
    origin: Origin
    strength: Strength
    duration: Duration = Duration.ALWAYS
    bound: Bound | None = None
    act: Act = Act.ASSERT
    earlier: bool = True
    orders: Orders | None = field(default=None, hash=False)

    def __post_init__(self) -> None:
        if not self.about:
            raise ValueError(f"a fact about no symbol: {self.origin}")

    @property
    def is_opaque(self) -> bool:
        return self.content is None and self.bound is None

    def __str__(self) -> str:
        return str(self.origin)


@dataclass(frozen=True)
class Context:
    """The facts of a claim, which hold together, and groups of guessed facts, which exclude each other."""

    facts: tuple[Fact, ...] = ()
    alternatives: tuple[tuple[Fact, ...], ...] = ()

    @property
    def formal(self) -> tuple[Fact, ...]:
        return tuple(fact for fact in self.facts if fact.content is not None)

    @property
    def opaque(self) -> tuple[Fact, ...]:
        return tuple(fact for fact in self.facts if fact.is_opaque)
