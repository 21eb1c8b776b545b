"""Why a formula that is false for free symbols may be true: its text says more of them than was read."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from workbench.language.terms import (
    Apply,
    Conjunction,
    Implication,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
)
from workbench.language.types import Declaration
from workbench.papers.model import Claim
from workbench.papers.said import terms_of
from workbench.papers.texts import Source

_INLINE = re.compile(r"(?:(?<![$\\])\$(?!\$)|\\\(|:math:`)\s*([^$`=]{1,60}?)\s*:?=")
_ARGUMENTS = re.compile(r"(?:\\left)?\((?:[^()]|\([^()]*\))*\)$")
_LONE = re.compile(r"(?:\\[a-z]+)*(?:\\?[A-Za-z]+)'*(?:[_^](?:\\?[A-Za-z0-9]+|[A-Za-z0-9,]+))*")
_SAYS = "says what {0} is, which nothing defines; a definition of {0} makes it a claim"
_COMPONENT = re.compile(r"[0-3]|[1-3][1-3]|[xyzw]|[xyz][xyz]|[ijk]|")


def with_unsettled(claims: Sequence[Claim], sources: Sequence[Source]) -> list[Claim]:
    """Each claim with what of the text leaves its falsehood open."""
    unread = _said_unread(claims, sources)
    made = []
    for claim in claims:
        statement = claim.printed.statement
        if statement is not None:
            known = {definition.declaration.name for definition in claim.notation.definitions}
            symbols = (term.declaration for term in terms_of(statement) if isinstance(term, Symbol))
            free = [each for each in symbols if each.name not in known]
            why = _of_unread(free, unread) or _of_components(free, claim) or _solved_for(statement, free)
            claim = replace(claim, unsettled=why)
        made.append(claim)
    return made


def _said_unread(claims: Sequence[Claim], sources: Sequence[Source]) -> Mapping[str, str]:
    """What stands alone before an = in a formula that is not read, or in a sentence, and the line."""
    found: dict[str, str] = {}
    for claim in claims:
        is_unread = claim.printed.statement is None and not claim.chain
        if is_unread and (match := re.match(r"([^=]{1,80}?):?=", claim.printed.latex)):
            for name in _lone(match[1]):
                found.setdefault(name, f"line {claim.line}")
    for source in sources:
        for match in _INLINE.finditer(source.text):
            for name in _lone(match[1]):
                found.setdefault(name, f"line {source.place(match.start(1))[0]}")
    return found


def _lone(left: str) -> Iterator[str]:
    name = _ARGUMENTS.sub("", _flat(left.replace("&", "")))
    if _LONE.fullmatch(name):
        yield name


def _flat(name: str) -> str:
    """The name, without the dots of its derivatives: what says what \\dot{x} is says something of x."""
    return re.sub(r"[\s{}]|\\(?:left|right|,|;|!)|\\d+ot(?![A-Za-z])", "", name)


def _of_unread(free: Sequence[Declaration], unread: Mapping[str, str]) -> str | None:
    for declaration in free:
        if place := unread.get(_flat(str(declaration.name))):
            return (
                f"the text says what {declaration.name} is ({place}), which is not read; a definition says it"
            )
    return None


def _of_components(free: Sequence[Declaration], claim: Claim) -> str | None:
    """Scalars that are written as the components of a vector, a matrix or a quaternion."""
    arrays = {
        declaration.name.letter: declaration
        for declaration in claim.notation.symbols.symbols.values()
        if declaration.type.kind != "scalar" and not declaration.introduced
    }
    for declaration in free:
        whole = arrays.get(declaration.name.letter)
        indices = "".join(re.sub(r"[\s{},]", "", part) for part in declaration.name.sub)
        is_part = whole is not None and declaration.type.kind == "scalar" and _COMPONENT.fullmatch(indices)
        if is_part and declaration.name.sub:
            part, array = declaration.name, whole.name
            return f"{part} reads as a component of {array}; a definition of {array} says so"
    return None


def _solved_for(statement: Statement, free: Sequence[Declaration]) -> str | None:
    """A symbol that nothing defines, that occurs in the statement once, and that one of its equations, or of
    the conclusions that it draws, may be solved for: alone under an operation, an addend or a multiple of
    one, or any where all are scalars; of scalars with a side 0, any."""
    names = Counter(str(each.name) for each in free)
    equations = [each for each in _concluded(statement) if each.operator in ("=", "≈")]
    for equation in equations:
        for side in (equation.left, equation.right):
            for name in (_under_one_sign(side), *_addends(side)):
                if name is not None and names[name] == 1:
                    return _SAYS.format(name)
    if not isinstance(statement, Relation) or any(each.type.kind != "scalar" for each in free):
        return None
    is_condition = any(_is_zero(each.left) or _is_zero(each.right) for each in equations)
    name = next((name for name, count in names.items() if equations and (count == 1 or is_condition)), None)
    return name and _SAYS.format(name)


def _concluded(statement: Statement) -> Iterator[Relation]:
    if isinstance(statement, Relation):
        yield statement
    elif isinstance(statement, Implication):
        yield from _concluded(statement.right)
    elif isinstance(statement, Conjunction):
        for part in statement.parts:
            yield from _concluded(part)


def _addends(side: Term) -> Iterator[str]:
    """The symbols that are addends of a sum, as the F of F + mg = m a, with or without a scalar factor."""
    if isinstance(side, Symbol):
        yield str(side.declaration.name)
    elif isinstance(side, Apply) and side.head in ("add", "neg"):
        for term in side.arguments:
            yield from _addends(term)
    elif isinstance(side, Apply) and side.head in ("mul", "div"):
        others = [term for term in side.arguments if term.type.kind != "scalar"]
        if len(others) == 1:
            yield from _addends(others[0])


def _under_one_sign(side: Term) -> str | None:
    """A^{-1}, R^T, \\tilde{\\omega}: the symbol, with an operation of its own on it."""
    is_one = isinstance(side, Apply) and len(side.arguments) == 1 and side.type.kind != "scalar"
    return (
        str(side.arguments[0].declaration.name) if is_one and isinstance(side.arguments[0], Symbol) else None
    )


def _is_zero(term: Term) -> bool:
    return isinstance(term, Zero) or (isinstance(term, Number) and term.value == 0)
