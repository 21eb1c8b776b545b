"""What the second engine evaluates terms on."""

from __future__ import annotations

from typing import Any, Protocol

from workbench.judge.second.components import Value
from workbench.judge.second.jet_algebra import Ring
from workbench.judge.subject.slopes import Seed
from workbench.language.typed.terms import Symbol, Term


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
