"""Everything that differs from a statement in one place: what a misprint may have done to it, and so also
what may undo a misprint.

What construction refuses is yielded too, with the reason: that types exclude a mutant is an answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from workbench.language.printer import to_latex
from workbench.language.terms import Conjunction, Equivalence, IllFormed, Implication, Statement, Term
from workbench.repair.places import Place, places, replaced
from workbench.repair.variants import Said, atoms_of, variants

#: The kinds of edit, likeliest misprint first.
KINDS = (
    "sign",
    "coefficient",
    "tilde",
    "dots",
    "product",
    "swap",
    "transpose",
    "exponent",
    "index",
    "symbol",
    "mark",
    "bound",
    "addend dropped",
    "addend added",
)


@dataclass(frozen=True)
class Edit:
    """One change. `statement` is the changed statement, None if construction refused it; then `ill_formed`
    says why. `old`, `new`: the subterms at `place` (`new` is None where it could not even be built)."""

    kind: str
    place: Place
    said: Said
    old: Term
    new: Term | None
    statement: Statement | None
    ill_formed: str | None = None

    @property
    def description(self) -> str:
        """The change in words, formulas between dollar signs."""
        template, *parts = self.said
        return template.format(*(f"${to_latex(p)}$" if isinstance(p, Term) else str(p) for p in parts))


def edits(
    statement: Statement, replacements: Sequence[Term] = (), addends: Sequence[Term] = ()
) -> Iterator[Edit]:
    """All one-place edits of a statement, place by place, none twice.

    replacements: terms that may stand for a symbol beside those of the statement itself; only those of its
    type and weight are tried. addends: terms that may be missing from a sum of their type and weight.
    """
    seen = {statement}
    atoms = tuple(dict.fromkeys((*atoms_of(statement), *replacements)))
    for place, term in places(statement):
        is_side = len(place) == _depth_of_sides(statement, place)
        for kind, said, make in variants(term, is_side, atoms, addends):
            new = None
            try:
                new = make()
                changed = replaced(statement, place, new)
            except IllFormed as fault:
                yield Edit(kind, place, said, term, new, None, str(fault))
                continue
            if changed not in seen:
                seen.add(changed)
                yield Edit(kind, place, said, term, new, changed)


def _depth_of_sides(statement: Statement, place: Place) -> int:
    """How long the place of a whole side is that begins as this place does."""
    depth, node = 0, statement
    while isinstance(node, Conjunction | Equivalence | Implication):
        parts = node.parts if isinstance(node, Conjunction) else (node.left, node.right)
        node = parts[place[depth]]
        depth += 1
    return depth + 1
