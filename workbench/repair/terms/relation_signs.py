"""Other signs between the sides of a false relation: = for ≠, and ≈ for = of small quantities."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from workbench.core.terms import Conjunction, Relation, Sign, Statement, Symbol, sides_of
from workbench.language.printing.printer import to_latex
from workbench.repair.terms.changes import Candidate, Change


def other_signs(statement: Statement) -> Iterator[Candidate]:
    """Yields the statement with another sign in one relation."""
    parts = statement.parts if isinstance(statement, Conjunction) else (statement,)
    for place, part in enumerate(parts):
        if not isinstance(part, Relation) or (sign := _other(part)) is None:
            continue
        changed = replace(part, operator=sign)
        whole = (*parts[:place], changed, *parts[place + 1 :])
        said = f"write {'=' if sign == '=' else '≈'} in ${to_latex(changed)}$"
        yield Candidate(Conjunction(whole) if len(whole) > 1 else changed, (Change("relation", said),))


def _other(said: Relation) -> Sign | None:
    if said.operator == "≠":
        return "="
    parts = (part for side in sides_of(said) for part in side.walk())
    is_of_small = any(isinstance(part, Symbol) and part.declaration.small for part in parts)
    return "≈" if said.operator == "=" and is_of_small else None
