"""All one-position edits of a statement: possible misprints, and thus also corrections of misprints.

Edits that make the statement ill-typed are yielded too, with the reason: that types exclude a mutant is a
result.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import overload

from workbench.core.operations import OF_ANGLES
from workbench.core.terms import (
    Apply,
    Block,
    Conjunction,
    Equivalence,
    IllFormed,
    Implication,
    Number,
    Relation,
    Statement,
    Term,
)
from workbench.language.printing.printer import to_latex
from workbench.repair.terms.subterm_positions import Place, node_at, places, replaced
from workbench.repair.terms.term_arithmetic import sum_of
from workbench.repair.terms.variants import Said, atoms_of, variants

#: The kinds of edit, the likeliest misprint first.
KINDS = (
    "sign", "coefficient", "operation", "tilde", "dots", "product", "swap", "transpose", "exponent", "index",
    "symbol", "mark", "bound", "addend dropped", "addend added",
)  # fmt: skip


#: Operations whose arguments have a sign of their own.
_OWN_SIGNS = frozenset({"quaternion", "exp", "log", *OF_ANGLES})


@dataclass(frozen=True)
class Edit:
    """One change.

    Attributes:
        old: The subterm at `place`.
        new: The subterm that replaces it.
        statement: The changed statement.
    """

    kind: str
    place: Place
    said: Said
    old: Term
    new: Term
    statement: Statement

    @property
    def description(self) -> str:
        """The change in words, formulas between dollar signs."""
        template, *parts = self.said
        return template.format(*(f"${to_latex(p)}$" if isinstance(p, Term) else str(p) for p in parts))


@dataclass(frozen=True)
class Refused:
    """An ill-typed change of the subterm `old` at `place`, with the reason."""

    kind: str
    place: Place
    old: Term
    ill_formed: str


def edits(
    statement: Statement, replacements: Sequence[Term] = (), within: Place = ()
) -> Iterator[Edit | Refused]:
    """Yields all one-position edits of a statement, position by position, without duplicates.

    replacements: further terms that may replace a symbol, if type and weight agree.
    within: restricts the edits to this position and below.
    """
    seen = {statement}
    of_sums: set[int] = set()  # the addends met so far
    atoms = tuple(dict.fromkeys((*atoms_of(statement), *replacements)))
    for place, term in places(statement):
        is_addend = len(place) == _depth_of_sides(statement, place) or id(term) in of_sums
        if isinstance(term, Apply) and term.head == "add":
            of_sums.update(map(id, term.arguments))
        if isinstance(term, Block) or (isinstance(term, Apply) and term.head in _OWN_SIGNS):
            of_sums.update(map(id, term.children))  # an entry and an argument have their own sign
        if place[: len(within)] != within:
            continue
        for kind, said, make in variants(term, is_addend, atoms):
            try:
                new = make()
                if _is_no_divisor(new) and _is_denominator(statement, place):
                    continue
                changed = replaced(statement, place, new)
            except IllFormed as fault:
                yield Refused(kind, place, term, str(fault))
                continue
            if changed not in seen:
                seen.add(changed)
                yield Edit(kind, place, said, term, new, changed)


def _is_no_divisor(term: Term) -> bool:
    """True for a negative number or a fraction, which nobody prints in a denominator."""
    return isinstance(term, Number) and (term.value < 0 or term.value.denominator > 1)


def _is_denominator(statement: Statement, place: Place) -> bool:
    parent = node_at(statement, place[:-1]) if len(place) > 1 else None
    return isinstance(parent, Apply) and parent.head == "div" and place[-1] == 1


def _depth_of_sides(statement: Statement, place: Place) -> int:
    """Returns the length of the position of the whole side that contains this position."""
    depth, node = 0, statement
    while isinstance(node, Conjunction | Equivalence | Implication):
        parts = node.parts if isinstance(node, Conjunction) else (node.left, node.right)
        node = parts[place[depth]]
        depth += 1
    return depth + 1


@overload
def without(statement: Relation, place: Place) -> Relation | None: ...
@overload
def without(statement: Statement, place: Place) -> Statement | None: ...
def without(statement: Statement, place: Place) -> Statement | None:
    """Returns the statement without the addend at the position; None if that is a whole side."""
    for length in range(len(place) - 1, 0, -1):
        parent = node_at(statement, place[:length])
        if isinstance(parent, Apply) and parent.head == "add":
            rest = parent.arguments[: place[length]] + parent.arguments[place[length] + 1 :]
            return replaced(statement, place[:length], sum_of(rest))
        if not isinstance(parent, Apply) or parent.head not in ("neg", "mul"):
            return None
    return None
