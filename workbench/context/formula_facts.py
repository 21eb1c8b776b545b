"""Facts from formulas: definitions, postulates and constraints of a claim's symbols in the same text.

A formula that asserts something is no fact. Neither is a formula of a scope that redeclares its symbols. An
earlier step of the claim's own chain counts as a definition only: a = b does not prove b = c.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from workbench.context.claims import Claim, Notation
from workbench.context.facts import Act, Fact, Origin, Provider, Strength
from workbench.context.formula_acts import constrains, declared_anew, definition_by
from workbench.context.formula_subject import conditioned, names_of
from workbench.context.free_symbols import free_in, names_in, terms_of
from workbench.context.repeated_laws import is_repeated
from workbench.core.names import Name
from workbench.core.terms import Definition, Derivative, Relation, Statement, Symbol, sides_of
from workbench.core.types import Declaration
from workbench.language.printing.printer import to_latex
from workbench.source.documents import Display


def with_acts(claims: Sequence[Claim]) -> list[Claim]:
    """Returns the claims with their acts; a constraint that another claim cites as given is a postulate."""
    given = {formula.statement for claim in claims for formula in claim.context.given}
    made = []
    for claim in claims:
        statement = claim.printed.statement
        if statement is not None:
            is_given = statement in given and constrains(statement, claim.notation.definitions)
            act = (Act.POSTULATE, claim.context.act[1]) if is_given else claim.context.act
            claim = claim.with_context(act=act)
        made.append(claim)
    return made


def with_moving(claims: Sequence[Claim]) -> list[Claim]:
    """Returns the claims with the symbols whose rates the text writes."""
    moving = _moving_by_scope(claims)
    return [
        claim.with_context(moving=moving[id(claim.notation)])
        if claim.printed.statement is not None
        else claim
        for claim in claims
    ]


def _moving_by_scope(claims: Sequence[Claim]) -> dict[int, frozenset[Name]]:
    """Returns for each notation the symbols of which formulas write rates that no other scope declares."""
    notations = {id(claim.notation): claim.notation for claim in claims}
    moved: dict[int, set[Name]] = {each: set() for each in notations}
    for claim in claims:
        if claim.printed.statement is not None:
            rates = (part for part in terms_of(claim.printed.statement) if isinstance(part, Derivative))
            parts = (part for rate in rates for part in rate.symbols())
            moved[id(claim.notation)].update(part.declaration.name for part in parts)
    return {
        here: frozenset(
            name
            for there, names in moved.items()
            for name in names
            if notations[there].since.get(name) == notation.since.get(name)
        )
        for here, notation in notations.items()
    }


def with_formula_facts(claims: Sequence[Claim], displays: Sequence[Display]) -> list[Claim]:
    """Returns the claims in the order of the text, each with the facts that earlier formulas state of its
    symbols.

    displays: the display of each claim. A formula with a condition, and a formula beside another one about a
    symbol of an earlier display, is only a guess outside of its own display."""
    said: dict[Declaration, list[_Saying]] = {}
    first: dict[Declaration, Display] = {}
    made = []
    for at, (claim, display) in enumerate(zip(claims, displays, strict=True)):
        statement = claim.printed.statement
        if statement is None:
            made.append(claim)
            continue
        about = _about(claim, said)
        repeats = is_repeated(claim, about)
        made.append(claim.with_context(facts=(*claim.context.facts, *about), repeats=repeats))
        if not repeats and (saying := _saying(claim, at)) is not None:
            if saying.cases or _is_local(claim, display, first):
                saying.fact = replace(saying.fact, strength=Strength.GUESSED)
            for declaration in saying.registered:
                earlier = said.get(declaration, [])
                said[declaration] = [*(each for each in earlier if not _replaces(saying, each)), saying]
        for declaration in free_in(sides_of(statement), claim.notation.definitions):
            first.setdefault(declaration, display)
    return made


def _replaces(later: _Saying, earlier: _Saying) -> bool:
    """True if a later formula defines a family, and an earlier one defines one of its members."""
    family, member = later.fact.content, earlier.fact.content
    return (
        isinstance(family, Definition)
        and isinstance(member, Definition)
        and family.declaration == member.declaration
        and any(not index.is_number for index in family.index)
        and all(index.is_number for index in member.index)
    )


def _is_local(claim: Claim, display: Display, first: Mapping[Declaration, Display]) -> bool:
    """Returns whether a formula says something for its display only.

    first: the displays in which the symbols stand first."""
    beside = (*claim.assume, *claim.ambiguity.perhaps, *claim.context.beside)
    conditions = (formula.statement for formula in beside)
    if any(isinstance(each, Relation) and each.operator == "=" for each in conditions):
        return True
    own = claim.context.act[1]
    is_earlier = own is not None and first.get(own.declaration, display) is not display
    return (claim.context.explains or bool(claim.ambiguity.serves)) and is_earlier


def _is_case_of(own: Symbol, fact: Fact) -> bool:
    """True if a sentence supposes an equation for the formula that says what the symbol is."""
    said = fact.content
    if (
        fact.origin.provider not in (Provider.CONDITION, Provider.UNREAD)
        or not isinstance(said, Relation)
        or said.operator != "="
    ):
        return False
    return fact.act is not Act.DEFINE or (isinstance(said.left, Symbol) and said.left == own)


class _Saying:
    """The fact that one formula states, its index among the claims, and the symbols that index it.

    cases: the equations that its sentence supposes; the fact is none for a claim without them."""

    def __init__(self, claim: Claim, at: int, fact: Fact, registered: set[Declaration]) -> None:
        self.claim, self.at, self.fact, self.registered = claim, at, fact, registered
        own = claim.context.act[1]
        self.cases = {each.origin for each in claim.context.facts if own and _is_case_of(own, each)}

    def is_of(self, claim: Claim) -> bool:
        """True if the claim stands in the case of the formula."""
        return not self.cases or not self.cases.isdisjoint(each.origin for each in claim.context.facts)


def _saying(claim: Claim, at: int) -> _Saying | None:
    """Returns the fact that a formula states; None if the formula asserts something."""
    act, own = claim.context.act
    statement, definitions = claim.printed.statement, claim.notation.definitions
    assert statement is not None
    if act in (Act.ASSERT, Act.ASSIGN) or own is None:
        return None
    is_framed = own.declaration.name in claim.notation.framed
    registered = free_in([own], definitions) if is_framed else {own.declaration}
    registered |= conditioned(statement, definitions)
    definition = definition_by(statement, own) if act is Act.DEFINE and not is_framed else None
    about = names_of(registered | {own.declaration})
    origin = Origin(Provider.FORMULA, to_latex(statement), claim.id)
    fact = Fact(definition or statement, about, origin, Strength.STATED, act=act, orders=claim.orders)
    return _Saying(claim, at, fact, registered)


def _about(claim: Claim, said: dict[Declaration, list[_Saying]]) -> list[Fact]:
    """Returns the facts about the symbols of the claim, and about the symbols of these facts."""
    statement, notation = claim.printed.statement, claim.notation
    assert statement is not None
    found: dict[int, Fact] = {}
    seen: set[Declaration] = set()
    waiting = free_in(sides_of(statement), notation.definitions)
    while waiting:
        declaration = waiting.pop()
        if declaration in seen:
            continue
        seen.add(declaration)
        for saying in said.get(declaration, ()):
            stated = saying.claim.printed.parsed
            if not saying.is_of(claim):
                continue
            if stated in claim.supposed or not _is_carried(stated, saying.claim.notation, notation):
                continue
            fact = saying.fact
            if saying.claim.id in claim.chain and fact.act is not Act.DEFINE:
                fact = replace(fact, content=None)
            found[saying.at] = fact
            if fact.act is Act.DEFINE:
                waiting |= free_in(sides_of(stated), notation.definitions)
    return [found[at] for at in sorted(found)]


def with_laws(claims: Sequence[Claim]) -> list[Claim]:
    """Returns the claims, each with the equations that may be laws of its motion.

    These contain rates of the same free symbols, or they precede the claim and share symbols with such an
    equation; the nearest comes first.
    """
    moving = [_moving(claim) for claim in claims]
    spoken = [_spoken(claim) if own else set() for claim, own in zip(claims, moving, strict=True)]
    made = []
    known: dict[tuple[str, bool], Fact] = {}
    for at, claim in enumerate(claims):
        alike = {place for place, own in enumerate(moving) if place != at and not own.isdisjoint(moving[at])}
        waiting = [place for place in alike if place < at]
        while waiting:
            of_it = spoken[waiting.pop()]
            more = [p for p in range(at) if p not in alike and not moving[p].isdisjoint(of_it)]
            alike, waiting = alike.union(more), [*waiting, *more]
        near = [(p, claims[p]) for p in sorted(alike, key=lambda p: (p > at, -p))]
        laws = tuple(
            known.get((each.id, p < at)) or known.setdefault((each.id, p < at), _law(each, p < at))
            for p, each in near
            if not (each.context.repeats or _are_of_one_chain(each, claim))
            and _is_carried(each.printed.statement, each.notation, claim.notation)
        )
        made.append(claim.with_context(facts=(*claim.context.facts, *laws)))
    return made


def _are_of_one_chain(one: Claim, other: Claim) -> bool:
    """True if the claims are steps of one chain: a false step must not prove the next one."""
    return one.id in other.chain or other.id in one.chain


def _is_carried(said: Statement | None, there: Notation, here: Notation) -> bool:
    """True if a statement of one scope has the same meaning in another."""
    if said is None:
        return False
    if there is here:
        return True
    symbols = set(there.definitions.symbols_in(*sides_of(said)))
    declared = here.symbols.symbols
    names = {each.declaration.name for each in symbols}
    return declared_anew(names, there, here) is None and all(
        declared.get(each.declaration.name, each.declaration) == each.declaration
        and there.definitions.about(each) == here.definitions.about(each)
        for each in symbols
    )


def _law(claim: Claim, earlier: bool) -> Fact:
    statement = claim.printed.statement
    assert statement is not None
    origin = Origin(Provider.LAW, claim.printed.latex, claim.id)
    about = names_of(_spoken(claim)) or frozenset(names_in(statement))
    act = claim.context.act[0]
    return Fact(statement, about, origin, Strength.STATED, act=act, earlier=earlier, orders=claim.orders)


def _spoken(claim: Claim) -> set[Declaration]:
    assert claim.printed.statement is not None
    return free_in(sides_of(claim.printed.statement), claim.notation.definitions)


def _moving(claim: Claim) -> set[Declaration]:
    """Returns the free symbols whose rates an equation contains, after unfolding definitions."""
    definitions = claim.notation.definitions
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or statement.operator != "=":
        return set()
    parts = definitions.reached(*sides_of(statement))
    free = free_in((part.body for part in parts if isinstance(part, Derivative)), definitions)
    return {each for each in free if not (each.constant or each.free or each.clock)}
