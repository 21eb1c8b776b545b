"""A statement that may be what was meant, and in words how it differs from the printed one."""

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
    """A statement that may be what was meant, and how it differs from the printed one. latex: as it would
    have been printed; the canonical one if None. unlikely: orders candidates with as many changes."""

    statement: Statement
    changes: tuple[Change, ...]
    latex: str | None = None
    unlikely: tuple[int, ...] = ()


def rescaled(statement: Statement, place: Place, factor: Fraction) -> Change:
    """What a changed coefficient is called."""
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
