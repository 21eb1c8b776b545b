"""Refutations by the residuals of a screen."""

from __future__ import annotations

from workbench.core.terms import Statement
from workbench.repair.screening.screen import Screen


def is_refuted_by(screen: Screen, statement: Statement) -> bool:
    """True if a non-zero residual shows that the statement is false: no root, which has two values, was taken."""
    residual = screen.residual(statement)
    return residual is not None and any(residual) and not screen._ring.took_roots
