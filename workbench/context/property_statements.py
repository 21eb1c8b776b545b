"""The meaning of properties, as facts that the engines can use."""

from __future__ import annotations

from collections.abc import Iterable

from workbench.context.facts import Supposition
from workbench.core.construct import apply, number, relation, symbol
from workbench.core.names import Name
from workbench.core.properties import PROPERTIES, Property
from workbench.core.terms import Relation, Symbol, Term


def is_stated(row: Property, own: Symbol) -> bool:
    """True if the symbol can have the property, and a fact can state it."""
    has_flag = bool(row.flag) and own.type.kind != "matrix"
    return row.fits(own) and (has_flag or bool(row.term or row.equations))


def having(name: str, symbols: Iterable[Symbol]) -> Supposition:
    """Returns the meaning of a property of the symbols, of each or of all together.

    The engines ignore flags of matrices that are no tensors, so equations state the property there.
    """
    row, symbols = PROPERTIES[name], list(symbols)
    if row.count > 1:
        assert row.equations is not None
        return Supposition((), tuple(row.equations(*symbols)))
    return joined(_alone(row, each) for each in symbols)


def _alone(row: Property, own: Symbol) -> Supposition:
    if row.flag and own.type.kind != "matrix":
        flagged = symbol(own.declaration.with_flags(**{row.flag: True}), own.index)
        return Supposition(((_key(own), flagged),))
    if row.term:
        return Supposition(((_key(own), row.term(own)),))
    assert row.equations is not None
    return Supposition((), tuple(row.equations(own)))


def meaning(own: Symbol, term: Term) -> Supposition:
    """Returns the supposition that the symbol is equal to the term."""
    return Supposition(((_key(own), term),))


def of_length_one(symbols: Iterable[Symbol]) -> Supposition:
    """Returns the supposition that the squares of the symbols add up to 1."""
    squares = [apply("dot" if each.type.kind == "vector" else "mul", each, each) for each in symbols]
    return Supposition((), (relation("=", apply("add", *squares), number(1)),))


def joined(several: Iterable[Supposition]) -> Supposition:
    terms: list[tuple[Name | Symbol, Term]] = []
    equations: list[Relation] = []
    for each in several:
        terms += each.terms
        equations += each.equations
    return Supposition(tuple(terms), tuple(equations))


def _key(own: Symbol) -> Name | Symbol:
    return own if own.index else own.declaration.name
