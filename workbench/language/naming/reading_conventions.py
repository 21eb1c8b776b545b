"""Conventions in which papers differ: the readings that a paper uses, and those that it excludes."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum


class Gradient(StrEnum):
    """The shape of ∂f/∂x of a scalar by a column."""

    ROW = "row"
    COLUMN = "column"


class Points(StrEnum):
    """The value of T p for a transform and a point: a column of four, or the moved point R p + t."""

    HOMOGENEOUS = "homogeneous"
    VECTORS = "vectors"


class Relaxation(StrEnum):
    """A reading that the reader takes only where the paper states it, or tries where no other fits."""

    #: x y of vectors is x ⊗ y, and x · T is Tᵀ x
    DYADS = "dyads"
    #: 1 may be the unit tensor
    UNIT_TENSOR = "unit"
    #: \\sin(x)^2 is (\\sin x)^2
    POWERS_OF_VALUES = "values"
    #: a × b × c is a × (b × c)
    CROSS_FROM_RIGHT = "right"
    #: k (x) is the product k x
    FACTORS_IN_BRACKETS = "factors"
    #: \\frac{d}{dt} x y is \\dot{x} y
    RATE_OF_NEXT_FACTOR = "near"
    #: a bracket is not a notation of the paper
    MERE_BRACKETS = "brackets"
    #: × after a row and a column applies to the column only
    CROSS_OF_LAST_FACTOR = "reach"
    #: an explicit row is a column
    ROW_FOR_COLUMN = "rows"
    #: ⊗ of vectors is a sign of the paper
    OWN_SIGN = "signs"
    #: \\log R is the vector of its skew tensor
    LOGARITHM_AS_COLUMN = "columns"


#: Readings that a value of [conventions] excludes.
_EXCLUDED = {"matrices": Relaxation.DYADS, "scalar": Relaxation.UNIT_TENSOR}


@dataclass
class Queries:
    """A log of the relaxations that a reader asked for, and of the symbols (LaTeX) before a bracket."""

    relaxations: set[Relaxation] = field(default_factory=set)
    symbols: set[str] = field(default_factory=set)


@dataclass(frozen=True)
class Conventions:
    """How a paper writes.

    loose, excluded: the readings that it takes, and that it states not to take.   suggestive: whether a
    letter or an accent suggests what a symbol is.   functions: those that it writes without a backslash,
    though it has their letters as symbols.   applied, asked: symbols (LaTeX) that the reader tries as
    functions of the bracket after them, and those that it asks about.   queries: the log of a reader."""

    gradient: Gradient | None = None
    points: Points | None = None
    loose: frozenset[Relaxation] = frozenset()
    excluded: frozenset[Relaxation] = frozenset()
    suggestive: bool = True
    functions: frozenset[str] = frozenset()
    applied: frozenset[str] = frozenset()
    asked: frozenset[str] = frozenset()
    queries: Queries | None = field(default=None, compare=False, repr=False)

    @staticmethod
    def build(chosen: Mapping[str, str], functions: Collection[str] = ()) -> Conventions:
        """Returns the conventions that the keys of [conventions] choose; an unknown value changes nothing."""
        values = set(chosen.values())
        return Conventions(
            gradient=Gradient(chosen["gradient"]) if "gradient" in chosen else None,
            points=Points(chosen["points"]) if "points" in chosen else None,
            loose=frozenset(each for each in Relaxation if each in values),
            excluded=frozenset(each for value, each in _EXCLUDED.items() if value in values),
            suggestive=chosen.get("letters") != "none",
            functions=frozenset(functions),
        )

    def allow(self, relaxation: Relaxation) -> bool:
        """Returns whether the reading is taken, and logs the query."""
        if self.queries is not None:
            self.queries.relaxations.add(relaxation)
        return relaxation in self.loose

    def apply(self, symbol: str) -> bool:
        """Returns whether the symbol is tried as a function of the bracket after it, and logs the query."""
        if self.queries is not None:
            self.queries.symbols.add(symbol)
        return symbol in self.applied

    def relaxed(self, *relaxations: Relaxation) -> Conventions:
        """Returns the same conventions with these readings added."""
        return replace(self, loose=self.loose.union(relaxations), queries=None)

    def with_functions(self, symbols: Collection[str]) -> Conventions:
        """Returns the same conventions with these symbols tried as functions."""
        return replace(self, applied=self.applied.union(symbols), queries=None)

    def asking_about(self, symbols: Collection[str]) -> Conventions:
        """Returns the same conventions with a question on these symbols before a bracket."""
        return replace(self, asked=self.asked.union(symbols), queries=None)

    def logged(self, queries: Queries) -> Conventions:
        """Returns the same conventions with this log of queries."""
        return replace(self, queries=queries)
