"""Whether what a proof speaks of is defined: where x divides by 0, neither x = x nor x ≠ 0 says anything."""

from __future__ import annotations

from collections.abc import Iterator

from workbench.language.construct import apply, relation, zero
from workbench.language.definitions import Definitions
from workbench.language.operators import LINEAR, PRODUCTS
from workbench.language.terms import Apply, Power, Relation, Symbol, Term

_EVERYWHERE = LINEAR | {*PRODUCTS, "add", "det", "sin", "cos", "exp"}


def is_defined_everywhere(term: Term, definitions: Definitions) -> bool:
    """Whether nothing in the term divides, or is not seen to do without."""
    return all(map(_never_divides, definitions.reached(term)))


def taken_by_maps(said: Relation, definitions: Definitions) -> Iterator[Term]:
    """What maps are taken of, of which nothing more is known, where that divides."""
    for part in (*said.left.walk(), *said.right.walk()):
        if isinstance(part, Symbol) and part.arguments and definitions.lookup(part) is None:
            yield from (a for a in part.arguments if not is_defined_everywhere(a, definitions))


def that_is_defined(*terms: Term) -> Relation:
    """What holds where they all are defined, and nowhere else; they are of one kind."""
    total = apply("add", *terms) if len(terms) > 1 else terms[0]
    return relation("=", apply("add", total, apply("neg", total)), zero(total.type))


def _never_divides(part: Term) -> bool:
    if isinstance(part, Power):
        lowest = part.exponent.substitute(dict.fromkeys(part.exponent.variables, 0))
        grows = all(coefficient > 0 for _, coefficient in part.exponent.coefficients)
        return part.base.type.kind == "operator" or (grows and int(lowest) >= 0)
    return not isinstance(part, Apply) or part.head in _EVERYWHERE
