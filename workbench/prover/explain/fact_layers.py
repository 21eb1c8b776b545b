"""Layers of the stated facts of a claim, in the order in which they are tried.

Each layer is tried separately, since large sets of hypotheses are expensive for the engines: definitions,
conditions, two more equations, the laws of the quantities that the claim moves, nearest first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from workbench.context.claims import Claim
from workbench.context.facts import Fact, Provider, Supposition
from workbench.context.formula_subject import Subject
from workbench.context.free_symbols import terms_of
from workbench.context.repeated_laws import closes_circle
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Apply, Definition, IllFormed, Relation, Symbol, sides_of
from workbench.core.types import SCALAR, Declaration
from workbench.core.verdict import Strength
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.prover.explain.laws_of_motion import is_all_given, laws_of

#: Number of further equations that are assumed together.
_MOST = 2
#: Number of equations that are tried one by one.
_MOST_FURTHER = 6
_BESIDE = (Provider.CONDITION, Provider.UNREAD)


def layers_of(claim: Claim, subject: Subject) -> Iterator[list[Fact]]:
    """Yields the sets of facts to be tried, each once."""
    facts = [
        fact for fact in claim.context.facts if fact.content is not None and fact.strength > Strength.GUESSED
    ]
    beside = [fact for fact in facts if fact.origin.provider in _BESIDE and _is_reached(fact, subject)]
    if is_all_given(claim):
        yield from filter(None, [beside])
        return
    formulas = [fact for fact in facts if fact.origin.provider is Provider.FORMULA]
    definitions, others = _first(formulas), _equations(formulas, subject)[-_MOST:]
    own, more = (laws_of(claim, followed) for followed in (False, True))
    tried: list[list[Fact]] = [[]]
    for layer in (
        definitions,
        [*definitions, *beside],
        [*definitions, *beside, *others],
        own[:1],
        own,
        more,
        [*definitions, *own],
        [*definitions, *more],
    ):
        if (layer := list(dict.fromkeys(layer))) not in tried:
            tried.append(layer)
            yield layer


def further_equations(claim: Claim, subject: Subject, known: Sequence[Fact]) -> list[Fact]:
    """Returns the equations that are in no layer and not known, the nearest one first; no more than
    `_MOST_FURTHER`."""
    if is_all_given(claim):
        return []
    said = {fact.content for fact in known}
    facts = (fact for fact in claim.context.facts if fact.strength > Strength.GUESSED)
    formulas = [fact for fact in facts if fact.origin.provider is Provider.FORMULA]
    further = [fact for fact in _equations(formulas, subject)[:-_MOST] if fact.content not in said]
    return further[: -_MOST_FURTHER - 1 : -1]


def _equations(formulas: Sequence[Fact], subject: Subject) -> list[Fact]:
    others = (fact for fact in formulas if fact.content and not isinstance(fact.content, Definition))
    return [fact for fact in others if _is_reached(fact, subject)]


def restricts(fact: Fact, subject: Subject, facts: Sequence[Fact]) -> bool:
    """False if the fact gives a symbol of any value that neither the claim nor another of the facts contains.

    φ = θ n with θ = ‖φ‖ then only names the direction n.
    """
    if not isinstance(fact.content, Relation) or fact.content.operator != "=":
        return True
    written = [part.declaration for part in terms_of(fact.content) if isinstance(part, Symbol)]
    beside = (each.about for each in facts if each != fact)
    known = {*(each.name for each in subject.declarations), *(name for names in beside for name in names)}
    for own in (fact.content.left, fact.content.right):
        while isinstance(own, Apply) and own.head == "mul" and own.arguments[0].type == SCALAR:
            own = own.arguments[1]
        if isinstance(own, Symbol) and not (own.index or own.arguments):
            about = own.declaration
            if not about.flags and about.name not in known and written.count(about) == 1:
                return False
    return True


def _first(formulas: Sequence[Fact]) -> list[Fact]:
    """Returns the definitions, only the first one per symbol: later ones are claims about it.

    A definition of a family is one of all its members. One that closes a circle is left out."""
    found: dict[object, Fact] = {}
    known: list[Definition] = []
    families: set[Declaration] = set()
    for fact in formulas:
        if isinstance(said := fact.content, Definition) and said.declaration not in families:
            if (said.declaration, said.index) not in found:
                if closes_circle(said, known):
                    continue
                known.append(said)
                found[said.declaration, said.index] = fact
            if said.index and all(
                [Linear.variable(name) for name in each.variables] == [each] for each in said.index
            ):
                families.add(said.declaration)
    return list(found.values())


def _is_reached(fact: Fact, subject: Subject) -> bool:
    """True if the claim contains some rate of a symbol of the fact of at least the fact's order."""
    if fact.content is None or isinstance(fact.content, Definition | Supposition):
        return True
    with suppress(NotExact, IllFormed):
        own = take_inventory(sides_of(fact.content), subject.definitions).orders
        reached = any(order and order <= subject.orders.get(each, -1) for each, order in own.items())
        return reached or not any(own.values())
    return True
