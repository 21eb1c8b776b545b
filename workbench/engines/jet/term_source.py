"""Sources: the interface from which the jet engine takes the derivatives of symbols."""

from __future__ import annotations

from typing import Any, Protocol

from workbench.core.terms import Symbol, Term
from workbench.engines.inventory.partial_derivatives import Seed
from workbench.engines.jet.components import Value
from workbench.engines.jet.jet_algebra import Ring


class Source(Protocol):
    """The derivatives of free symbols."""

    ring: Ring

    def jet(self, symbol: Symbol, depth: int) -> Value: ...

    def circle(self, angle: Term, value: Any = None) -> tuple[Any, Any]:
        """Returns (cos, sin) of the angle at the instant; value: the value of an angle that is not a
        symbol."""

    def circles(self) -> list[Term]:
        """Returns the terms other than symbols that have a circle, such as ω t."""

    def moved(self, seed: Seed) -> Source:
        """Returns the same source with one component of a derivative moved by ε, over dual numbers."""

    def slopes(self, function: Symbol, degree: int, count: int) -> list[Any]:
        """Returns all partial derivatives of one degree of a function `of` coordinates."""

    def along(self, component: int) -> Source:
        """Returns the same source with the coordinate moved by ε along one axis, for div and curl."""
