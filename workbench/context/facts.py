"""The data of the context calculus: facts about symbols, and the context of a claim."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from typing import NamedTuple

from workbench.core.names import Name
from workbench.core.terms import Definition, Relation, Statement, Symbol, Term
from workbench.core.verdict import Strength


class Duration(StrEnum):
    """When a fact holds."""

    INSTANT = "at the instant"
    ALWAYS = "always"


class Act(StrEnum):
    """What the author does with a formula."""

    ASSERT = "asserts"
    DEFINE = "defines"
    POSTULATE = "postulates"
    CONSTRAIN = "constrains"  # an equation for a symbol that stands once in it and has no definition
    ASSIGN = "assigns"


class Provider(StrEnum):
    """Where a fact comes from."""

    FORMULA = "formula"
    LAW = "law"  # a formula that holds the rate of a symbol
    CONDITION = "condition"
    SENTENCE = "sentence"
    UNREAD = "unread"
    CONVENTION = "convention"


@dataclass(frozen=True)
class Origin:
    """The provider, the author's words or the name of the convention, and the place in the text."""

    provider: Provider
    text: str
    place: str = ""

    def __str__(self) -> str:
        return f"{self.text} ({self.place})" if self.place else self.text


@dataclass(frozen=True)
class Supposition:
    """What a property means for its symbols: what each of them is, and the equations that hold."""

    terms: tuple[tuple[Name | Symbol, Term], ...] = ()
    equations: tuple[Relation, ...] = ()


class Bound(NamedTuple):
    """A number that the values of a symbol keep to, as in x > 0."""

    symbol: str
    sign: str
    number: Fraction

    def allows(self, values: Mapping[str, tuple[str, ...]]) -> bool:
        """Returns whether the value of the symbol is known to keep to the bound; True if it has no value."""
        if self.symbol not in values:
            return True
        try:
            value = Fraction(values[self.symbol][0])
        except ValueError:
            return False
        return {
            "<": value < self.number,
            ">": value > self.number,
            "≤": value <= self.number,
            "≥": value >= self.number,
        }[self.sign]


@dataclass(frozen=True)
class Fact:
    """One thing that is known of symbols.

    content: None if it is not formalised ("opaque"): such a fact lowers a grade and decides nothing.
    bound: what values of a symbol keep to.   act: what the formula does that the fact comes from.
    earlier: whether it stands before the claim.
    """

    content: Definition | Statement | Supposition | None
    about: frozenset[Name]
    origin: Origin
    strength: Strength
    duration: Duration = Duration.ALWAYS
    bound: Bound | None = None
    act: Act = Act.ASSERT
    earlier: bool = True

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
