"""Corrections of a false x ∈ SO(3): one change in x, which occurs in several equations after expansion."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Notation
from workbench.context.index_values import Orders
from workbench.context.read_formulas import read_statement
from workbench.core.construct import identity, number, relation, zero
from workbench.core.formula_errors import Fault, IllFormedAt, ReadError
from workbench.core.terms import Term
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Chain
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.changes import Candidate
from workbench.repair.terms.edit_search import candidate_of, cost
from workbench.repair.terms.subterm_positions import subterm
from workbench.repair.terms.term_edits import Refused, edits

_IN = re.compile(r"\\in(?![A-Za-z])")


def membership(latex: str) -> tuple[str, str] | None:
    """Returns the member and the set of a formula that consists of a membership only."""
    with suppress(Fault):
        match parse(latex).lines:
            case ((Chain(relations=(("∈", _),)),),):
                parts = _IN.split(latex)
                return (parts[0], parts[1]) if len(parts) == 2 else None
    return None


def other_members(
    parts: tuple[str, str],
    notation: Notation,
    orders: Orders | None,
    screen: Screen | None,
    tick: Callable[[], None],
) -> Iterator[Candidate]:
    """Yields other members of the set, likely ones first.

    Members that are declared to be in the set, and 0 and I, are left out as trivial. Letters are not changed,
    because any member would do. tick: called for each candidate.
    """
    member, where = parts
    term = read_term(member, notation.symbols, frozenset(orders.variables if orders else ()))
    found = edits(relation("=", term, zero()), within=(0,))
    for edit in sorted(found, key=cost):
        tick()
        if isinstance(edit, Refused) or edit.kind == "symbol" or edit.new == number(1):
            continue
        new = subterm(edit.statement, (0,))
        latex = f"{to_latex(new)} \\in {where.strip()}"
        with suppress(ReadError, IllFormedAt, ValueError):
            statement = read_statement(latex, notation, orders)[0]
            if screen is None or (screen.vanishes(statement) and not _is_fixed(new, screen)):
                yield replace(candidate_of(edit), statement=statement, latex=latex)


def _is_fixed(member: Term, screen: Screen) -> bool:
    known = [zero(member.type), *([identity(member.type)] if member.type.is_square else [])]
    return any(screen.vanishes(relation("=", member, each)) for each in known)
