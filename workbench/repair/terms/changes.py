"""Candidates for the right form, with their changes in words."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from workbench.core.terms import Apply, Statement
from workbench.language.printing.printer import to_latex
from workbench.repair.terms.subterm_positions import Place, subterm


@dataclass(frozen=True)
class Change:
    """One edit in words, formulas between dollar signs."""

    kind: str
    description: str


@dataclass(frozen=True)
class Candidate:
    """A candidate for the right form of a statement.

    Attributes:
        latex: The LaTeX as it would have been printed; the canonical LaTeX if None.
        unlikely: Orders candidates with equally many changes.
    """

    statement: Statement
    changes: tuple[Change, ...]
    latex: str | None = None
    unlikely: tuple[int, ...] = ()


def rescaled(statement: Statement, place: Place, factor: Fraction) -> Change:
    """Returns the description of a changed coefficient."""
    term = subterm(statement, place)
    bare = term.arguments[0] if isinstance(term, Apply) and term.head == "neg" else term
    shown = f"${to_latex(bare)}$"
    if factor == 0:
        return Change("addend dropped", f"remove the addend {shown}")
    if factor == -1:
        return Change("sign", f"change the sign of {shown}")
    sign = " and change its sign" if factor < 0 else ""
    size = abs(factor)
    if size.numerator == 1:
        return Change("coefficient", f"{shown} has the factor {size.denominator} too much{sign}")
    return Change("coefficient", f"insert the factor {size} before {shown}{sign}")
