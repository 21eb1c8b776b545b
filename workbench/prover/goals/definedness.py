"""Whether what a proof speaks of is defined: where x divides by 0, neither x = x nor x ≠ 0 says anything."""

from __future__ import annotations

from collections.abc import Iterator

from workbench.core.construct import apply, relation, zero
from workbench.core.terms import Relation, Symbol, Term
from workbench.engines.inventory.divisions import never_divides
from workbench.language.definitions import Definitions


def is_defined_everywhere(term: Term, definitions: Definitions) -> bool:
    """Whether nothing in the term divides, or is not seen to do without."""
    return all(map(never_divides, definitions.reached(term)))


def taken_by_maps(said: Relation, definitions: Definitions) -> Iterator[Term]:
    """What maps are taken of, of which nothing more is known, where that divides."""
    for part in (*said.left.walk(), *said.right.walk()):
        if isinstance(part, Symbol) and part.arguments and definitions.lookup(part) is None:
            yield from (a for a in part.arguments if not is_defined_everywhere(a, definitions))


def that_is_defined(*terms: Term) -> Relation:
    """What holds where they all are defined, and nowhere else; they are of one kind."""
    total = apply("add", *terms) if len(terms) > 1 else terms[0]
    return relation("=", apply("add", total, apply("neg", total)), zero(total.type))
