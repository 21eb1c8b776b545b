"""The frames that a paper declares: their rotation, and the frame in which a dot differentiates."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field, replace

from workbench.core.names import Name
from workbench.core.terms import Term


@dataclass(frozen=True)
class KnownFrames:
    """The frames of a table.

    velocities: frame → its angular velocity seen from where \\dot differentiates.   orientations: frame → its
    axes, in a paper that has no components of a vector apart from it.   dot: the frame in which \\dot
    differentiates vectors; None with frames where it is not stated.   resolved: {}^F x, the components of a
    vector in another frame than that → what {}^F\\dot{x} is: the matrix and the vector whose rate it
    multiplies; None where it is not stated whether it is that or the rate of {}^F x.   constant: what is
    constant in that frame, and turns with it.   directions: the vectors that are no points.
    places: point → its position.   fixed: the points that a frame carries."""

    velocities: Mapping[str, Term] = field(default_factory=dict)
    orientations: Mapping[str, Term] = field(default_factory=dict)
    dot: str | None = None
    resolved: Mapping[Name, tuple[Term, Term] | None] = field(default_factory=dict)
    constant: frozenset[Name] = frozenset()
    directions: frozenset[Name] = frozenset()
    places: Mapping[str, Term] = field(default_factory=dict)
    fixed: frozenset[str] = frozenset()

    def part(self, names: Set[Name]) -> KnownFrames:
        """Returns the frames without the properties of other names."""
        return replace(
            self,
            resolved={name: own for name, own in self.resolved.items() if name in names},
            constant=self.constant & names,
            directions=self.directions & names,
            places={point: place for point, place in self.places.items() if _names_in(place) <= names},
        )


def _names_in(term: Term) -> set[Name]:
    return {part.declaration.name for part in term.symbols()}
