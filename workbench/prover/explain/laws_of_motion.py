"""Laws of motion that a text states for the rates in a claim."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache

from workbench.context.claims import Claim, Formula
from workbench.context.facts import Fact, Provider
from workbench.context.formula_subject import derived
from workbench.context.free_symbols import body_of, equations_of, free_in, terms_of
from workbench.core.integer_expressions import as_linear
from workbench.core.terms import Apply, Derivative, IllFormed, Relation, Statement, Symbol, Term, sides_of
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory, take_inventory
from workbench.language.definitions import Definitions
from workbench.prover.decide.law_statements import is_constant, law_for


def laws_of(claim: Claim, followed: bool = True) -> list[Fact]:
    """Returns a law for each rate that the claim reaches: the last one before it, in a formula or in a
    sentence.

    followed: laws for the rates in these laws are included. A law that multiplies the rate by constants only
    is
    preferred: other equations for the rate, such as x ẋ + y ẏ = r v, follow from it. Laws from which almost
    nothing can be derived are left out: those with the inverse of a matrix, and those for less than the
    highest rate of a rotation.
    """
    definitions = claim.notation.definitions
    reached = dict(_inventory(claim.printed.parsed, definitions).orders)
    known = [(law, said, _rates(said, definitions)) for law, said in _before(claim)]
    known.sort(key=lambda each: not _stands_alone(each[1], each[2], definitions))
    found: list[Fact] = []
    lowest = _given(claim)
    for _ in known:
        for law, statement, rates in known:
            is_new = law not in found and _is_new(rates, lowest)
            if is_new and _reaches(reached, rates) and not _turns_on(reached, rates):
                found.append(law)
                lowest |= rates
                if not followed:
                    continue
                more = max(reached.get(symbol, 0) - order for symbol, order in rates.items())
                for symbol, order in _inventory(statement, definitions).orders.items():
                    reached[symbol] = max(order + max(more, 0), reached.get(symbol, 0))
    return found


def _before(claim: Claim) -> Iterator[tuple[Fact, Relation]]:
    """Yields the laws before the claim, in formulas and in its sentence, each with its equation."""
    for fact in claim.context.facts:
        is_law = fact.origin.provider is Provider.LAW and fact.earlier
        if is_law or fact.origin.provider is Provider.CONDITION:
            said = fact.content
            if isinstance(said, Relation) and said not in claim.supposed and not _inverts(said):
                yield fact, said


def _given(claim: Claim) -> dict[Symbol, int]:
    """Returns for each symbol the lowest order of its rates in the given laws."""
    rates = [
        _rates(law.statement, claim.notation.definitions) for law in claim.context.given if law.statement
    ]
    return {symbol: min(own[symbol] for own in rates if symbol in own) for own in rates for symbol in own}


def _is_new(rates: Mapping[Symbol, int], lowest: Mapping[Symbol, int]) -> bool:
    """True if a law for the rates adds information to laws for rates from the lowest orders on."""
    return all(order < lowest.get(each, order + 1) for each, order in rates.items())


def is_law(claim: Claim) -> bool:
    """True for an equation for a rate that nothing defines."""
    is_equation = isinstance(claim.printed.statement, Relation)
    return is_equation and bool(_rates(claim.printed.statement, claim.notation.definitions))


def is_all_given(claim: Claim) -> bool:
    """True if the given formulas contain every free symbol of the claim, so that they determine it."""
    return _is_spoken_of(claim, _given_terms(claim))


def is_all_assumed(claim: Claim) -> bool:
    """True if every free symbol of the claim stands in what is given or in what its model assumes."""
    beside = {formula.latex for formula in claim.context.beside}
    assumed = [f.statement for f in claim.assume if f.statement and f.latex not in beside]
    sides = [side for said in assumed for each in equations_of(said) for side in sides_of(each)]
    return _is_spoken_of(claim, [*sides, *_given_terms(claim)])


def _given_terms(claim: Claim) -> list[Term]:
    return [term for law in claim.context.given if law.statement for term in terms_of(law.statement)]


def _is_spoken_of(claim: Claim, said: Sequence[Term]) -> bool:
    definitions = claim.notation.definitions
    own = free_in(sides_of(claim.printed.parsed), definitions)
    return bool(said) and {each for each in own if not definitions.is_pi(each)} <= free_in(said, definitions)


def rates_a_definition(claim: Claim, known: Sequence[Fact]) -> list[Fact]:
    """Returns the laws from which a rate of a defined symbol follows, if the claim gives one; else [].

    With p = ẋ, ṗ = k x is no law beside ẍ = -k x. It may be one of a case if it lacks a moving symbol of the
    laws. One with a rate that they do not contain, as κ̇ = δ̇/L, is no law.
    """
    said, definitions = claim.printed.statement, claim.notation.definitions
    laws = [fact for fact in known if fact.origin.provider is Provider.LAW]
    if (
        not laws
        or not isinstance(said, Relation)
        or not any(_is_named_rate(s, definitions) for s in sides_of(said))
    ):
        return []
    own = free_in(sides_of(said), definitions)
    equations = [law.content for law in laws if isinstance(law.content, Relation)]
    spoken = free_in((side for each in equations for side in sides_of(each)), definitions)
    moved = free_in(
        (rate for each in equations for s in sides_of(each) for rate in _rates_in(s)), definitions
    )
    others = [side for side in sides_of(said) if not _is_named_rate(side, definitions)]
    if not free_in((rate for side in others for rate in _rates_in(side)), definitions) <= moved:
        return []
    return laws if own <= spoken and all(each.constant for each in spoken - own) else []


def _rates_in(side: Term) -> Iterator[Term]:
    """Yields what a side differentiates by time."""
    return (part.body for part in side.walk() if isinstance(part, Derivative))


def under_its_laws(claim: Claim) -> Claim:
    """Returns a claim on the rate of a defined symbol with the laws given from which the rate follows."""
    if not isinstance(claim.printed.statement, Relation):
        return claim
    laws = rates_a_definition(claim, laws_of(claim)[:1])
    given = tuple(Formula(law.origin.text, law.content) for law in laws if isinstance(law.content, Relation))
    return claim.with_context(given=(*claim.context.given, *given)) if given else claim


def _is_named_rate(side: Term, definitions: Definitions) -> bool:
    """True for a rate of a symbol that a definition gives, as ṗ for p = ẋ."""
    own, order = derived(side)
    return own is not None and order > 0 and body_of(own, definitions) is not None


def _stands_alone(law: Relation, rates: Mapping[Symbol, int], definitions: Definitions) -> bool:
    """True if the rates in it, as written, have no factors except constants.

    The rate of a defined symbol, such as q = w + x i + y j + z k, is one of the symbols in its definition.
    """
    orders = {symbol.declaration: as_linear(order) for symbol, order in rates.items()}
    written = [
        part
        for side in sides_of(law)
        for part in side.walk()
        if isinstance(part, Derivative)
        and any(part.order == orders.get(each) for each in free_in([part.body], definitions))
    ]
    return all(_is_alone(side, rate, definitions) for side in sides_of(law) for rate in written)


def _is_alone(term: Term, rate: Term, definitions: Definitions) -> bool:
    if term == rate or rate not in term.walk():
        return True
    if not isinstance(term, Apply) or term.head not in ("add", "neg", "mul", "div"):
        return False
    others = [each for each in term.arguments if rate not in each.walk()]
    if term.head in ("mul", "div") and not all(is_constant(each, definitions) for each in others):
        return False
    return all(_is_alone(each, rate, definitions) for each in term.arguments)


def _turns_on(reached: Mapping[Symbol, int], rates: Mapping[Symbol, int]) -> bool:
    turning = (each for each in rates if each.declaration.rotation or each.declaration.unit)
    return any(reached.get(each, 0) > rates[each] for each in turning)


def _inverts(statement: Statement) -> bool:
    parts = (part for side in sides_of(statement) for part in side.walk())
    return any(isinstance(p, Apply) and p.head == "inverse" and p.type.rows > 1 for p in parts)


def _reaches(reached: Mapping[Symbol, int], rates: Mapping[Symbol, int]) -> bool:
    return any(reached.get(symbol, 0) >= order for symbol, order in rates.items())


@lru_cache(maxsize=1024)
def _rates(said: Relation, definitions: Definitions) -> dict[Symbol, int]:
    """Returns the symbols for a rate of which the equation is a law, and its order; {} if it is not a law."""
    inventory, rate = _inventory(said, definitions), None
    with suppress(NotExact, IllFormed):
        rate = law_for(said, inventory, definitions)
    behind = {} if rate is None else _inventory_of([rate], definitions).orders
    return {symbol: order for symbol, order in behind.items() if order}


def _inventory(statement: Statement, definitions: Definitions) -> Inventory:
    return _inventory_of(sides_of(statement), definitions)


def _inventory_of(terms: Iterable[Term], definitions: Definitions) -> Inventory:
    with suppress(NotExact, IllFormed):
        return take_inventory(terms, definitions)
    return Inventory()
