"""Side conditions of definedness: where x divides by 0, neither x = x nor x ≠ 0 is meaningful."""

from __future__ import annotations

from collections.abc import Iterator

from workbench.core.construct import apply, relation, zero
from workbench.core.terms import Relation, Symbol, Term
from workbench.engines.inventory.divisions import never_divides
from workbench.language.definitions import Definitions


def is_defined_everywhere(term: Term, definitions: Definitions) -> bool:
    """True if nothing in the term divides, or might divide."""
    return all(map(never_divides, definitions.reached(term)))


def taken_by_maps(said: Relation, definitions: Definitions) -> Iterator[Term]:
    """Yields the arguments of unknown maps that contain divisions."""
    for part in (*said.left.walk(), *said.right.walk()):
        if isinstance(part, Symbol) and part.arguments and definitions.lookup(part) is None:
            yield from (a for a in part.arguments if not is_defined_everywhere(a, definitions))


def that_is_defined(*terms: Term) -> Relation:
    """Returns an equation that holds exactly where all terms are defined; they have one kind."""
    total = apply("add", *terms) if len(terms) > 1 else terms[0]
    return relation("=", apply("add", total, apply("neg", total)), zero(total.type))
