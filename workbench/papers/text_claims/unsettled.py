"""Why a formula that is false for free symbols may be true: its text says more of them than was read."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

from workbench.core.verdict_codes import VerdictCode
from workbench.language.typed.names import Name
from workbench.language.typed.terms import (
    Apply,
    Conjunction,
    Derivative,
    Implication,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
    column_of_symbols,
)
from workbench.language.typed.types import SCALAR, Declaration
from workbench.papers.model import Claim
from workbench.papers.said import conditioned, constrains, terms_of
from workbench.papers.text_claims.unread import COMPONENT, left_open, said_unread
from workbench.papers.texts import Text

_EXAMPLE = "gives the numbers of an example, which nothing defines; a definition makes it a claim"
_GIVEN = "other formulas follow from it: it is given, and no claim"
_ADJUGATE = re.compile(r"adjugate|classical adjoint|cofactor|\\\\adj", re.IGNORECASE)
_NO_ADJUGATE = "^* is read as the adjugate, of which the text does not speak; [notation] can say what it is"


def with_unsettled(claims: Sequence[Claim], text: Text) -> list[Claim]:
    """Each claim with what of the text leaves its falsehood open."""
    unread = said_unread(claims, text.inline)
    moving = _moving(claims)
    given = {formula.statement for claim in claims for formula in claim.given}
    made = []
    for claim in claims:
        statement = claim.printed.statement
        if statement is not None:
            known = {definition.declaration.name for definition in claim.notation.definitions}
            symbols = [term.declaration for term in terms_of(statement) if isinstance(term, Symbol)]
            open_columns = {each.name for each in symbols if _is_open(claim, each, symbols)}
            loose = [each for each in symbols if each.name not in known - open_columns and not each.free]
            free = [each for each in loose if not claim.notation.definitions.is_pi(each)]
            why = _of_components(free, claim) or _of_a_star(statement, text)
            for function in conditioned(statement, claim.notation.definitions):
                why = f"a condition on {function.name}, of which nothing else is said?"
            is_postulate = statement in given and constrains(statement, claim.notation.definitions)
            why = _GIVEN if is_postulate else why
            within = _within(claim, symbols)
            says_of = _solved_for(statement, free, within)
            says = None if says_of is None else VerdictCode.SAYS_WHAT_IT_IS(symbol=says_of)
            if says is None and (free or within - known - _declared_free(claim)):
                says = of_an_example(statement)
            open_by, values = left_open(free, claim, unread, with_values=says is None)
            beside = (*claim.beside, *values)
            claim = replace(
                claim, unsettled=open_by or why, says=says, says_of=says_of, beside=beside, moving=moving
            )
        made.append(claim)
    return made


def _moving(claims: Sequence[Claim]) -> frozenset[Name]:
    """The symbols of which the formulas write rates."""
    statements = (claim.printed.statement for claim in claims if claim.printed.statement is not None)
    terms = (term for statement in statements for term in terms_of(statement))
    rates = (part for term in terms if isinstance(term, Derivative) for part in term.walk())
    return frozenset(part.declaration.name for part in rates if isinstance(part, Symbol))


def _of_components(free: Sequence[Declaration], claim: Claim) -> str | None:
    """Scalars that are written as the components of a vector, a matrix or a quaternion, where no definition
    makes this of them."""
    given = {
        (definition.declaration.name.letter, term.declaration.name)
        for definition in claim.notation.definitions
        for term in definition.body.walk()
        if isinstance(term, Symbol)
    }
    declared = claim.notation.symbols.symbols.values()
    others = (each for each in declared if each.type.kind != "scalar" and not each.introduced)
    by_scripts = sorted(others, key=lambda each: len((*each.name.sub, *each.name.sup)), reverse=True)
    arrays = {each.name.letter: each for each in by_scripts}
    for declaration in free:
        whole = arrays.get(declaration.name.letter)
        indices = "".join(re.sub(r"[\s{},]", "", part) for part in declaration.name.sub)
        is_part = whole is not None and declaration.type.kind == "scalar" and COMPONENT.fullmatch(indices)
        if is_part and declaration.name.sub and (whole.name.letter, declaration.name) not in given:
            part, array = declaration.name, whole.name
            return f"{part} reads as a component of {array}; a definition of {array} says so"
    return None


def _is_open(claim: Claim, column: Declaration, symbols: Sequence[Declaration]) -> bool:
    """Whether the symbol is made of components that nothing defines and that the claim has nowhere else."""
    bodies = [each.body for each in claim.notation.definitions if each.declaration == column]
    parts = _components_of(bodies[0]) if len(bodies) == 1 else ()
    entries = {part.declaration.name for part in parts if not part.declaration.free}
    if not entries:
        return False
    others = [each for each in symbols if each != column]
    known = {each.declaration.name for each in claim.notation.definitions}
    return entries.isdisjoint(known | {each.name for each in others} | _within(claim, others))


def _components_of(body: Term) -> tuple[Symbol, ...]:
    """The symbols of a column of such, or of x i + y j + z k."""
    addends = body.arguments if isinstance(body, Apply) and body.head == "add" else ()
    factors = [part for each in addends for part in each.children]
    along = tuple(part for part in factors if isinstance(part, Symbol) and part.type == SCALAR)
    is_sum = len(set(along)) == len(addends) > 1 and body.type.is_column
    return along if is_sum else column_of_symbols(body)


def _within(claim: Claim, symbols: Sequence[Declaration]) -> set[Name]:
    """The symbols that the definitions of these, and of those in them, speak of."""
    bodies: dict[Name, set[Name]] = {}
    for definition in claim.notation.definitions:
        inside = {term.declaration.name for term in definition.body.walk() if isinstance(term, Symbol)}
        bodies.setdefault(definition.declaration.name, set()).update(inside)
    found: set[Name] = set()
    waiting = {each.name for each in symbols}
    while waiting:
        found |= (new := bodies.get(waiting.pop(), set()) - found)
        waiting |= new
    return found


def _solved_for(statement: Statement, free: Sequence[Declaration], within: set[Name]) -> Name | None:
    """A symbol that nothing defines and that occurs in the statement once, and in no definition of it, in an
    equation or in one that is concluded: no identity has such a symbol, so that this says something of it. Of
    scalars with a side 0, any."""
    names = {each.name for each in free} - within
    written = Counter(
        (term.declaration.name, term.index) for term in terms_of(statement) if _is_of(term, names)
    )
    equations = [each for each in _concluded(statement) if each.operator in ("=", "≈")]
    said = (term for each in equations for term in terms_of(each) if _is_of(term, names))
    types = {each.left.type for each in equations}
    is_condition = all(each.type.kind == "scalar" for each in free) and any(
        _is_zero(each.left) or _is_zero(each.right) for each in equations
    )
    once = (term for term in said if is_condition or written[term.declaration.name, term.index] == 1)
    unknown = [term.declaration for term in once]
    first = min(unknown, key=lambda each: each.type not in types, default=None)
    return first and first.name


def of_an_example(statement: Statement) -> str | None:
    """What free symbols make in an example, a matrix of numbers."""
    equations = [each for each in _concluded(statement) if each.operator in ("=", "≈")]
    symbols = [term for term in terms_of(statement) if isinstance(term, Symbol)]
    is_example = any(
        _is_value(each.left) != _is_value(each.right)
        or ([each.left] == symbols and _is_number(each.right))
        or ([each.right] == symbols and _is_number(each.left))
        for each in equations
    )
    return _EXAMPLE if is_example else None


def _is_of(term: Term, names: set[Name]) -> bool:
    return isinstance(term, Symbol) and term.declaration.name in names


def _of_a_star(statement: Statement, text: Text) -> str | None:
    """T^*, where the text does not say that it is the adjugate."""
    stars = (term for term in terms_of(statement) if isinstance(term, Apply) and term.head == "adjugate")
    is_said = any(_ADJUGATE.search(source.text) for source in text.sources)
    return None if is_said or next(stars, None) is None else _NO_ADJUGATE


def _concluded(statement: Statement) -> Iterator[Relation]:
    if isinstance(statement, Relation):
        yield statement
    elif isinstance(statement, Implication):
        yield from _concluded(statement.right)
    elif isinstance(statement, Conjunction):
        for part in statement.parts:
            yield from _concluded(part)


def _declared_free(claim: Claim) -> set[Name]:
    return {name for name, each in claim.notation.symbols.symbols.items() if each.free}


def _is_value(term: Term) -> bool:
    """Whether it is made of numbers alone, and a matrix that is more than 0 and the unit."""
    parts = [] if term.type.rows == 1 == term.type.columns else list(term.walk())
    return any(isinstance(part, Number) for part in parts) and not any(
        isinstance(part, Symbol) for part in parts
    )


def _is_number(term: Term) -> bool:
    """Whether it is made of numbers, and is no 0."""
    parts = list(term.walk())
    has_number = any(isinstance(part, Number) and part.value != 0 for part in parts)
    return has_number and not any(isinstance(part, Symbol) for part in parts)


def _is_zero(term: Term) -> bool:
    return isinstance(term, Zero) or (isinstance(term, Number) and term.value == 0)
