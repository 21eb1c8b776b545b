"""What a text says of its own symbols: a formula that has one alone on a side may be its definition.

A formula that contradicts what the text says of its symbols elsewhere is no falsehood as long as the model
does not say which of them are defined so.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from workbench.language.definitions import Definitions, expand
from workbench.language.grammar.vocabulary import COMMANDS
from workbench.language.typed.names import Name
from workbench.language.typed.operators import CIRCULAR, PARTIALS
from workbench.language.typed.terms import (
    Apply,
    Block,
    Conjunction,
    Definition,
    Derivative,
    IllFormed,
    Implication,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
    sides_of,
)
from workbench.language.typed.types import Declaration, Type
from workbench.papers.model import Claim, Formula, Notation, Said

_EQUALS = (name for name, token in COMMANDS.items() if token == ("RELATION", "="))
_DEFINES = re.compile(rf":=|\\(?:{'|'.join(_EQUALS)}|stackrel|overset)(?![A-Za-z])")
_ASSIGNS = re.compile(r":=|\\coloneqq?(?![A-Za-z])")


def terms_of(statement: Statement) -> Iterator[Term]:
    for side in sides_of(statement):
        yield from _written(side)


def _written(term: Term) -> Iterator[Term]:
    """The term and all below it, as often as they are written: the x of tan x once."""
    yield term
    children = term.children
    match term:
        case Apply(head="div", arguments=(Apply(head=one, arguments=x), Apply(head=other, arguments=y))):
            if {one, other} == {"sin", "cos"} and x == y:
                children = children[:1]
    for child in children:
        yield from _written(child)


def stated(statement: Statement, notation: Notation | None = None) -> str | None:
    """The symbol that the formula may say something of: one that stands alone on a side, or its highest
    derivative, occurs nowhere else, and has no definition; one that frames give, where the other side holds
    something that they do not; an angle that occurs once."""
    found = _stated(statement, notation)
    return None if found is None else str(found[0].declaration.name)


def introduced(formula: Formula, notation: Notation) -> Definition | None:
    """The definition that x := … is of a free x of which nothing but its kind is declared."""
    match formula.statement:
        case Relation(operator="=", left=Symbol() as symbol, right=body) if introduces(formula, notation):
            with_others = expand(body, notation.definitions)
            return None if symbol in with_others.walk() else _definition(symbol, body)
    return None


def introduces(formula: Formula, notation: Notation) -> set[Name]:
    """The symbols to the left of a sign of definition, such as :=, of which nothing else says what they are:
    then the formula does."""
    if formula.statement is None or not _DEFINES.search(formula.latex):
        return set()
    bound = {symbol.declaration.name for symbol in notation.motion}
    lefts = (equation.left for equation in _equations(formula.statement))
    parts = (part for left in lefts for part in left.walk() if isinstance(part, Symbol))
    free = (part for part in parts if _body(part, notation.definitions) is None)
    return {part.declaration.name for part in free} - bound


def is_by_definition(said: Statement, definitions: Definitions) -> bool:
    """Returns whether it is an equation that says no more than the definitions."""
    try:
        sides = [expand(side, definitions) for side in sides_of(said)]
    except IllFormed:
        return False
    return isinstance(said, Relation) and said.operator == "=" and sides[0] == sides[1]


def says_of_defined(statement: Statement, definitions: Definitions) -> bool:
    """Whether a side is a symbol that is defined, or a slope or rate of one, and the other holds symbols."""
    for each in _equations(statement):
        for one, other in ((each.left, each.right), (each.right, each.left)):
            while isinstance(one, Derivative) or (isinstance(one, Apply) and one.head in PARTIALS):
                one = one.children[0]
            is_defined = isinstance(one, Symbol) and _body(one, definitions) is not None
            if is_defined and any(isinstance(part, Symbol) for part in other.walk()):
                return True
    return False


def assigns(formula: Formula) -> bool:
    """Whether it gives a symbol its next value, as x := x + 1 does."""
    if formula.statement is None or not _ASSIGNS.search(formula.latex):
        return False
    said = _equations(formula.statement)
    return any(isinstance(each.left, Symbol) and each.left in each.right.walk() for each in said)


def constrains(statement: Statement, definitions: Definitions) -> bool:
    """Returns whether it is an equation that says something of its symbols, as x · x = 1 or m x = m y does,
    where x y = y x says that something holds of all: its sides have no free symbol in common, or one occurs
    once."""
    return any(
        free_in([each.left], definitions).isdisjoint(free_in([each.right], definitions))
        or _has_single(each, definitions)
        for each in _equations(statement)
    )


def _has_single(equation: Relation, definitions: Definitions) -> bool:
    """Whether a free symbol is written once in it and stands behind no other symbol there."""
    written = [part for part in terms_of(equation) if isinstance(part, Symbol)]
    behind = free_in((body for each in written for body in _bodies(each, definitions)), definitions)
    free = free_in(written, definitions) - behind
    return any([part.declaration for part in written].count(each) == 1 for each in free)


def _equations(statement: Statement) -> Iterator[Relation]:
    match statement:
        case Relation(operator="="):
            yield statement
        case Conjunction(parts=parts):
            for part in parts:
                yield from _equations(part)
        case Implication(right=right):
            yield from _equations(right)


def with_said(claims: Sequence[Claim]) -> list[Claim]:
    """The claims, each with what earlier ones say of the symbols that it uses: also those that hold one once
    (`says`), of which no identity speaks."""
    said: dict[Declaration, list[tuple[Said, Notation]]] = {}
    made = []
    for claim in claims:
        statement, notation = claim.printed.statement, claim.notation
        if statement is None:
            made.append(claim)
            continue
        made.append(replace(claim, rests=_rests(statement, notation, said)))
        free = free_in(terms_of(statement), notation.definitions)
        about, definition = {each for each in free if each.name == claim.says_of}, None
        if (found := _stated(statement, notation)) is not None:
            symbol, definition = found
            is_framed = symbol.declaration.name in notation.framed
            about = free_in([symbol], notation.definitions) if is_framed else {symbol.declaration}
        about |= conditioned(statement, notation.definitions)
        for declaration in about:
            name = str(symbol.declaration.name if found else declaration.name)
            saying = Said(name, claim.id, definition, statement, claim.supposed, claim.orders)
            said.setdefault(declaration, []).append((saying, notation))
    return made


def with_laws(claims: Sequence[Claim]) -> list[Claim]:
    """The claims, each with the equations that hold rates of the same free symbols, or before it of what such
    equations speak of, the last before it first: any of them may be a law of its motion."""
    moving = [_moving(claim) for claim in claims]
    spoken = [_spoken(claim) if own else set() for claim, own in zip(claims, moving, strict=True)]
    made = []
    for at, claim in enumerate(claims):
        alike = {place for place, own in enumerate(moving) if place != at and not own.isdisjoint(moving[at])}
        waiting = [place for place in alike if place < at]
        while waiting:
            of_it = spoken[waiting.pop()]
            more = [p for p in range(at) if p not in alike and not moving[p].isdisjoint(of_it)]
            alike, waiting = alike.union(more), [*waiting, *more]
        near = [(p, claims[p]) for p in sorted(alike, key=lambda p: (p > at, -p))]
        laws = tuple(
            _law(each, p < at)
            for p, each in near
            if not _are_of_one_chain(each, claim)
            and _is_carried(each.printed.statement, each.notation, claim.notation)
        )
        made.append(replace(claim, laws=laws))
    return made


def _are_of_one_chain(one: Claim, other: Claim) -> bool:
    """Whether the claims are steps of one chain: a false step must not prove the next one."""
    return one.id in other.chain or other.id in one.chain


def _is_carried(said: Statement, there: Notation, here: Notation) -> bool:
    """Whether what is said in one scope means as much in another."""
    if there is here:
        return True
    parts = (part for side in sides_of(said) for part in there.definitions.reached(side))
    symbols = {part for part in parts if isinstance(part, Symbol)}
    declared = here.symbols.symbols
    names = {each.declaration.name for each in symbols}
    return declared_anew(names, there, here) is None and all(
        declared.get(each.declaration.name, each.declaration) == each.declaration
        and there.definitions.about(each) == here.definitions.about(each)
        for each in symbols
    )


def names_in(statement: Statement) -> set[Name]:
    """Returns the names of the symbols that are written in the statement."""
    return {part.declaration.name for part in terms_of(statement) if isinstance(part, Symbol)}


def declared_anew(names: Iterable[Name], there: Notation, here: Notation) -> Name | None:
    """Returns one of the names that a scope declares between the places of the two notations."""
    return next((name for name in names if there.since.get(name) != here.since.get(name)), None)


def is_before_scope(names: Iterable[Name], file: Path | None, line: int, notation: Notation) -> bool:
    """Returns whether a scope declares one of the names anew behind the line."""
    places = map(notation.since.get, names)
    return any(place is not None and place[0] == file and line < place[1] for place in places)


def _law(claim: Claim, earlier: bool) -> Said:
    said = claim.printed.statement
    return Said(claim.printed.latex, claim.id, None, said, claim.supposed, claim.orders, earlier)


def _spoken(claim: Claim) -> set[Declaration]:
    return free_in(terms_of(claim.printed.statement), claim.notation.definitions)


def _moving(claim: Claim) -> set[Declaration]:
    """The free symbols of which an equation takes rates, in what defines its symbols, too."""
    definitions = claim.notation.definitions
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or statement.operator != "=":
        return set()
    parts = (part for side in sides_of(statement) for part in definitions.reached(side))
    free = free_in((part.body for part in parts if isinstance(part, Derivative)), definitions)
    return {each for each in free if not (each.constant or each.free or each.clock)}


def conditioned(statement: Statement, definitions: Definitions) -> set[Declaration]:
    """The functions, of which no more is said, whose slopes are said to make a number: those of coordinates
    that are orthogonal by e_n · e_m = 0."""
    known = {definition.declaration.name for definition in definitions}
    found: set[Declaration] = set()
    for said in _equations(statement):
        sides = (said.left, said.right)
        if all(any(isinstance(part, Symbol) for part in side.walk()) for side in sides):
            continue
        parts = [part for side in sides for part in definitions.reached(side)]
        if any(isinstance(part, Apply) and part.head in PARTIALS for part in parts):
            symbols = (part.declaration for part in parts if isinstance(part, Symbol))
            found |= {each for each in symbols if each.of and not each.free and each.name not in known}
    return found


def _rests(
    statement: Statement, notation: Notation, said: dict[Declaration, list[tuple[Said, Notation]]]
) -> tuple[Said, ...]:
    """What is said of the symbols in the statement, and of those in these definitions; of what is said by
    symbols that mean something else no more than that it is, and nothing of a symbol that a scope declares
    anew."""
    definitions = notation.definitions
    found: dict[tuple[str, str], Said] = {}
    seen: set[Declaration] = set()
    waiting = free_in(terms_of(statement), definitions)
    while waiting:
        declaration = waiting.pop()
        if declaration in seen:
            continue
        seen.add(declaration)
        for saying, there in said.get(declaration, ()):
            if there.since.get(declaration.name) != notation.since.get(declaration.name):
                continue
            if not _is_carried(saying.statement, there, notation):
                saying = replace(saying, definition=None, statement=None)
            found[saying.place, saying.name] = saying
            if saying.definition is not None:
                waiting |= free_in([saying.definition.body], definitions)
    return tuple(found[key] for key in sorted(found))


def _stated(statement: Statement, notation: Notation | None) -> tuple[Symbol, Definition | None] | None:
    if not isinstance(statement, Relation) or statement.operator not in ("=", "≈"):
        return None
    definitions = Definitions() if notation is None else notation.definitions
    known = {definition.declaration.name for definition in definitions}
    framed = frozenset() if notation is None else notation.framed
    for one, other in ((statement.left, statement.right), (statement.right, statement.left)):
        symbol, order = _derived(one)
        if symbol is None or any(_derived(term) == (symbol, order) for term in definitions.reached(other)):
            continue
        if symbol.declaration.name in framed:
            bodies = (each.body for each in definitions if each.declaration.name in framed)
            if free_in([other], definitions) - free_in(bodies, definitions):
                return symbol, None
            continue
        is_defined = symbol.declaration.name in known and _is_reached(symbol, definitions)
        if not (is_defined or symbol.declaration.free):
            is_exact = statement.operator == "=" and not order
            return symbol, _definition(symbol, other) if is_exact else None
    angle = _only_angle(statement, known, definitions)
    return None if angle is None else (angle, None)


def _is_reached(symbol: Symbol, definitions: Definitions) -> bool:
    """Whether definitions of its family say what it is: of α_{n+1} one leaves a declared α_0 free."""
    return not symbol.index or _body(symbol, definitions) is not None


def _definition(symbol: Symbol, body: Term) -> Definition | None:
    """The symbol as the body; None for one of which more is declared than its kind."""
    declaration = symbol.declaration
    plain = Declaration(declaration.name, declaration.type, declaration.weight)
    uses_itself = any(isinstance(part, Symbol) and part.declaration == declaration for part in body.walk())
    if declaration != plain or symbol.index or uses_itself or body.type != declaration.type:
        return None
    return Definition(declaration, (), (), body)


def _only_angle(statement: Statement, known: set[Name], definitions: Definitions) -> Symbol | None:
    """An angle that occurs once, and in no definition of what else does, and of which the sine or the like
    says what it is."""
    terms = list(terms_of(statement))
    symbols = [term for term in terms if isinstance(term, Symbol)]
    defining = [body for each in dict.fromkeys(symbols) for body in _bodies(each, definitions)]
    symbols += [part for body in defining for part in definitions.reached(body) if isinstance(part, Symbol)]
    for term in terms:
        if isinstance(term, Apply) and term.head in CIRCULAR and isinstance(term.arguments[0], Symbol):
            (angle,) = term.arguments
            is_given = angle.declaration.name in known or angle.declaration.free
            if symbols.count(angle) == 1 and not is_given:
                return angle
    return None


def _bodies(symbol: Symbol, definitions: Definitions) -> list[Term]:
    return [each.body for each in definitions.about(symbol)]


def _derived(term: Term) -> tuple[Symbol | None, object]:
    if isinstance(term, Symbol):
        return term, 0
    if isinstance(term, Derivative) and isinstance(term.body, Symbol):
        return term.body, term.order
    if isinstance(term, Block) and term.type == Type(4, 1):  # (p, 1), the column of a point
        places = [each for each in term.children if not isinstance(each, Number | Zero)]
        return _derived(places[0]) if len(places) == 1 else (None, 0)
    return None, 0


def free_in(terms: Iterable[Term], definitions: Definitions) -> set[Declaration]:
    """The declarations of the symbols that nothing defines, in the terms and in what defines others."""
    found: set[Declaration] = set()
    seen: set[Symbol] = set()
    waiting = list(terms)
    while waiting:
        for part in waiting.pop().walk():
            if isinstance(part, Symbol) and part not in seen:
                seen.add(part)
                body = _body(part, definitions)
                if body is None:
                    found.add(part.declaration)
                else:
                    waiting.append(body)
    return found


def _body(symbol: Symbol, definitions: Definitions) -> Term | None:
    if symbol.declaration.positive and not definitions.about(symbol):
        return None
    try:
        return definitions.lookup(symbol)
    except IllFormed:
        return None
