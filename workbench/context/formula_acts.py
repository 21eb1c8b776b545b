"""Speech acts of formulas: a formula asserts, defines, postulates, constrains or assigns."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from workbench.context.claims import Claim, Formula, Notation
from workbench.context.facts import Act
from workbench.context.formula_subject import Subject, derived
from workbench.context.free_symbols import body_of, equations_of, free_in, terms_of
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers
from workbench.core.names import Name
from workbench.core.operations import PARTIALS
from workbench.core.terms import (
    Apply,
    Definition,
    Derivative,
    IllFormed,
    Relation,
    Statement,
    Symbol,
    Term,
    sides_of,
)
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions, expand
from workbench.language.grammar.vocabulary import COMMANDS
from workbench.language.naming.symbols import SymbolTable

_EQUALS = (name for name, token in COMMANDS.items() if token == ("RELATION", "="))
_DEFINES = re.compile(rf":=|\\(?:{'|'.join(_EQUALS)}|stackrel|overset)(?![A-Za-z])")
_MODULO = re.compile(r"\\[bp]?mod(?![A-Za-z])")
_ASSIGNS = re.compile(r":=|\\coloneqq?(?![A-Za-z])")


def subject_of(claim: Claim, definitions: Iterable[Definition] = ()) -> Subject:
    """Returns the subject of a claim.

    definitions: the text's definitions, in addition to those of the model.
    """
    assert claim.printed.statement is not None
    more = tuple(definitions)
    known = claim.notation.definitions
    known = Definitions([*known, *more]) if more else known
    subject = _subject(claim.printed.statement, claim.notation, known, claim.context.moving)
    return replace(subject, ruled=frozenset(_ruled(claim)), assumed=frozenset(_assumed(claim)))


def _assumed(claim: Claim) -> Iterator[Name]:
    """Yields the symbols of the equations that a model assumes for the claim, so that it says nothing new of
    them."""
    beside = {formula.latex for formula in claim.context.beside}
    for formula in claim.assume:
        if formula.latex not in beside and formula.statement is not None:
            sides = [side for each in equations_of(formula.statement) for side in sides_of(each)]
            yield from (symbol.declaration.name for side in sides for symbol in side.symbols())


def _ruled(claim: Claim) -> Iterator[Name]:
    """Yields the symbols whose rates a fact of the claim gives."""
    laws = (fact.content for fact in claim.context.facts if isinstance(fact.content, Relation))
    for own, order in (derived(side) for law in laws for side in (law.left, law.right)):
        if own is not None and order:
            yield own.declaration.name


def _subject(
    statement: Statement,
    notation: Notation,
    definitions: Definitions,
    moving: frozenset[Name] = frozenset(),
) -> Subject:
    return Subject(
        statement,
        definitions,
        notation.symbols,
        frozenset(symbol.declaration.name for symbol in notation.motion),
        notation.framed,
        moving,
        letters=notation.symbols.conventions.suggestive,
    )


def act_of(formula: Formula, notation: Notation) -> tuple[Act, Symbol | None]:
    """Returns the act of a formula, and the symbol that it is about."""
    if formula.statement is None:
        return Act.ASSERT, None
    if assigns(formula):
        return Act.ASSIGN, None
    if introduces(formula, notation):
        (left, *_) = (equation.left for equation in equations_of(formula.statement))
        return Act.DEFINE, left if isinstance(left, Symbol) else None
    return _subject(formula.statement, notation, notation.definitions).act


def stated(statement: Statement) -> str | None:
    """Returns the symbol that an equation may define, if nothing else is known of its symbols."""
    known = Subject(statement, Definitions(), SymbolTable())
    act, symbol = known.act
    is_said = act in (Act.DEFINE, Act.POSTULATE) and symbol is not None
    return str(symbol.declaration.name) if is_said and symbol is not None else None


def definition_by(statement: Statement, own: Symbol | None) -> Definition | None:
    """Returns the equation as a definition of the symbol alone on one side.

    Returns None if the symbol has declared properties beyond its kind. Returns None if the other side has an
    index of its own, as in V = R i_m: the index is that of the claim, and V has none to unfold it with.
    """
    match statement:
        case Relation(operator="=", left=left, right=right) if own is not None:
            for one, other in ((left, right), (right, left)):
                if one == own:
                    return _definition(own, other)
    return None


def _definition(symbol: Symbol, body: Term) -> Definition | None:
    declaration = symbol.declaration
    plain = Declaration(declaration.name, declaration.type, declaration.weight, indices=declaration.indices)
    uses_itself = any(part.declaration == declaration for part in body.symbols())
    is_member = all(each.is_number or each in map(Linear.variable, each.variables) for each in symbol.index)
    is_member = is_member and free_integers(body) <= free_integers(symbol)
    if declaration != plain or symbol.arguments or uses_itself or body.type != declaration.type:
        return None
    return Definition(declaration, symbol.index, (), body) if is_member else None


def introduced(formula: Formula, notation: Notation) -> Definition | None:
    """Returns the definition that x := … gives of a free x that has no declared property beyond its kind."""
    match formula.statement:
        case Relation(operator="=", left=Symbol() as symbol, right=body) if introduces(formula, notation):
            with_others = expand(body, notation.definitions)
            return None if symbol in with_others.walk() else _definition(symbol, body)
    return None


def introduces(formula: Formula, notation: Notation) -> set[Name]:
    """Returns the otherwise undefined symbols to the left of a definition sign such as :=."""
    is_signed = _DEFINES.search(formula.latex) and not _MODULO.search(formula.latex)
    if formula.statement is None or not is_signed:
        return set()
    bound = {symbol.declaration.name for symbol in notation.motion}
    lefts = (equation.left for equation in equations_of(formula.statement))
    parts = (part for left in lefts for part in left.symbols())
    free = (part for part in parts if body_of(part, notation.definitions) is None)
    return {part.declaration.name for part in free} - bound


def assigns(formula: Formula) -> bool:
    """True if the formula updates a symbol, as x := x + 1 does."""
    if formula.statement is None or not _ASSIGNS.search(formula.latex):
        return False
    said = equations_of(formula.statement)
    return any(isinstance(each.left, Symbol) and each.left in each.right.walk() for each in said)


def is_by_definition(said: Statement, definitions: Definitions) -> bool:
    """True if the equation follows from the definitions by substitution."""
    try:
        sides = [expand(side, definitions) for side in sides_of(said)]
    except IllFormed:
        return False
    return isinstance(said, Relation) and said.operator == "=" and sides[0] == sides[1]


def says_of_defined(statement: Statement, definitions: Definitions) -> bool:
    """True if a side is a defined symbol, or a slope or rate of one, and the other side holds symbols."""
    for each in equations_of(statement):
        for one, other in ((each.left, each.right), (each.right, each.left)):
            while isinstance(one, Derivative) or (isinstance(one, Apply) and one.head in PARTIALS):
                one = one.children[0]
            is_defined = isinstance(one, Symbol) and body_of(one, definitions) is not None
            if is_defined and any(isinstance(part, Symbol) for part in other.walk()):
                return True
    return False


def constrains(statement: Statement, definitions: Definitions) -> bool:
    """True if the equation restricts its symbols, as x · x = 1 and m x = m y do; x y = y x is an identity.

    The sides of such an equation have no free symbol in common, or a symbol occurs once.
    """
    return any(
        free_in([each.left], definitions).isdisjoint(free_in([each.right], definitions))
        or _has_single(each, definitions)
        for each in equations_of(statement)
    )


def _has_single(equation: Relation, definitions: Definitions) -> bool:
    """True if a free symbol is written once in the equation, and in no definition of another symbol there."""
    written = [part for part in terms_of(equation) if isinstance(part, Symbol)]
    bodies = (definition.body for each in written for definition in definitions.about(each))
    free = free_in(written, definitions) - free_in(bodies, definitions)
    return any([part.declaration for part in written].count(each) == 1 for each in free)


def declared_anew(names: Iterable[Name], there: Notation, here: Notation) -> Name | None:
    """Returns one of the names that a scope redeclares between the positions of the two notations."""
    return next((name for name in names if there.since.get(name) != here.since.get(name)), None)


def is_before_scope(names: Iterable[Name], file: Path | None, line: int, notation: Notation) -> bool:
    """True if a scope redeclares one of the names after the line."""
    places = map(notation.since.get, names)
    return any(place is not None and place[0] == file and line < place[1] for place in places)


def act_by_sign(printed: Formula, notation: Notation) -> tuple[Act, Symbol | None]:
    """Returns the act of a formula outside a text: an assertion, unless a sign indicates another act."""
    is_signed = assigns(printed) or introduces(printed, notation)
    return act_of(printed, notation) if is_signed else (Act.ASSERT, None)
