"""What the second engine evaluates terms on."""

from __future__ import annotations

from typing import Any, Protocol

from workbench.core.terms import Symbol, Term
from workbench.engines.inventory.partial_derivatives import Seed
from workbench.engines.jet.components import Value
from workbench.engines.jet.jet_algebra import Ring


class Source(Protocol):
    """Where free symbols get their derivatives from."""

    ring: Ring

    def jet(self, symbol: Symbol, depth: int) -> Value: ...

    def circle(self, angle: Term, value: Any = None) -> tuple[Any, Any]:
        """(cos, sin) of the angle at the instant; value: that of a term that is no symbol."""

    def circles(self) -> list[Term]:
        """The terms other than symbols that have a circle, such as ω t."""

    def moved(self, seed: Seed) -> Source:
        """The same source with one component of a derivative moved by ε, over dual numbers."""

    def slopes(self, function: Symbol, degree: int, count: int) -> list[Any]:
        """The partial derivatives of a function `of` something, all those of a degree."""

    def along(self, component: int) -> Source:
        """The same source with the coordinate moved by ε along one axis, for div and curl."""
