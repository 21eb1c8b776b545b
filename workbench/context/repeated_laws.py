"""A formula for a symbol that earlier formulas of the text give already: it asserts, and is no fact."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from workbench.context.claims import Claim
from workbench.context.facts import Act, Fact, Provider, Strength
from workbench.context.formula_acts import constrains, subject_of
from workbench.context.formula_subject import derived
from workbench.context.free_symbols import body_of, free_in
from workbench.core.terms import Definition, Relation, Symbol, Term
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions

#: What a formula does that gives its symbol.
GIVES = frozenset({Act.DEFINE, Act.POSTULATE})


def rate_in(said: object, own: Symbol) -> tuple[int, Term] | None:
    """Returns the order of the symbol's rate that stands alone on one side of an equation, and the other."""
    if isinstance(said, Definition):
        body = body_of(own, Definitions([said])) if said.declaration == own.declaration else None
        return (0, body) if body is not None else None
    if not isinstance(said, Relation) or said.operator != "=":
        return None
    for one, other in ((said.left, said.right), (said.right, said.left)):
        found, order = derived(one)
        if found == own:
            return order, other
    return None


def order_in(said: object, own: Symbol) -> int | None:
    """Returns the order of the symbol's rate that an equation gives; None if it gives none."""
    rate = rate_in(said, own)
    return None if rate is None else rate[0]


def is_given_by(law: Relation, own: Symbol, fact: Fact, definitions: Definitions) -> bool:
    """True if a fact gives a rate of the symbol from which the law follows, or gives the same rate otherwise.

    It does not if the two together say what another symbol is."""
    here, there = rate_in(law, own), rate_in(fact.content, own)
    if here is None or there is None or there[0] > here[0]:
        return False
    if there[0] < here[0]:
        return there[0] > 0 or fact.act is Act.DEFINE
    both = Relation("=", there[1], here[1])
    return not free_in([there[1], here[1]], definitions) or not constrains(both, definitions)


def given_by(law: Relation, own: Symbol, facts: Sequence[Fact], definitions: Definitions) -> list[Fact]:
    """Returns the facts that give the symbol, or lower rates of all symbols in its definition, as of the
    components of a quaternion."""
    given = [fact for fact in facts if is_given_by(law, own, fact, definitions)]
    body, here = body_of(own, definitions), order_in(law, own)
    if given or body is None or here is None:
        return given
    parts = [part for part in body.symbols() if body_of(part, definitions) is None]
    rates = [[f for f in facts if 0 < (order_in(f.content, part) or 0) < here] for part in parts]
    return [fact for own_facts in rates for fact in own_facts] if all(rates) else []


def is_repeated(claim: Claim, facts: Iterable[Fact]) -> bool:
    """True if the earlier formulas of a text give the symbol that the claim says something of."""
    act, own = claim.context.act
    statement = claim.printed.statement
    if act not in GIVES or own is None or not isinstance(statement, Relation):
        return False
    said = [
        fact
        for fact in facts
        if fact.origin.provider is Provider.FORMULA and fact.strength is Strength.STATED and fact.act in GIVES
    ]
    if any(is_given_by(statement, own, fact, claim.notation.definitions) for fact in said):
        definitions = definitions_in(said, claim.notation.definitions)
        return not definitions or subject_of(claim, definitions).act[0] is Act.ASSERT
    return False


def laws_in(facts: Iterable[Fact]) -> tuple[Relation, ...]:
    """Returns the equations of earlier formulas among the facts."""
    said = (
        fact.content
        for fact in facts
        if fact.origin.provider is Provider.FORMULA or (fact.origin.provider is Provider.LAW and fact.earlier)
    )
    return tuple(each for each in said if isinstance(each, Relation))


def definitions_in(facts: Sequence[Fact], known: Iterable[Definition] = ()) -> list[Definition]:
    """Returns the first definition of each symbol among the facts, without those that close a circle.

    known: the definitions of the model.
    """
    found: dict[object, Definition] = {}
    for content in (fact.content for fact in facts):
        if isinstance(content, Definition):
            key = (content.declaration, content.index)
            if key not in found and not closes_circle(content, [*known, *found.values()]):
                found[key] = content
    return list(found.values())


def closes_circle(definition: Definition, others: Collection[Definition]) -> bool:
    """True if the body of a definition contains its own symbol, with these definitions unfolded."""
    waiting, reached = [definition], set[Declaration]()
    while waiting:
        used = {part.declaration for part in waiting.pop().body.symbols()} - reached
        reached |= used
        waiting += [each for each in others if each.declaration in used]
    return definition.declaration in reached
