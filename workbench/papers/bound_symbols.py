"""Relations between the bound symbols of [motion]: ω bound to w_WB is the angular velocity of R, R_WB.

A bound symbol that follows from others is defined by them, so that the exact engines know what Drake's
motions satisfy. The motions cover bound symbols that stay free: a claim that holds on them is not refuted.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping

from workbench.core.names import Name
from workbench.core.terms import Definition, Symbol, Term
from workbench.drake.relations import ALSO, DEFINED, names_in
from workbench.drake.relations import Term as Data
from workbench.language.definitions import Definitions
from workbench.prover.motions.relation_terms import term_of


def ties(motion: Mapping[Symbol, str], definitions: Definitions) -> list[Definition]:
    """Returns definitions of otherwise undefined bound symbols by other bound symbols."""
    bound: dict[str, Symbol] = {}
    for symbol, name in motion.items():
        bound.setdefault(name, symbol)
    found: list[Definition] = []
    for symbol, name in motion.items():
        if definitions.lookup(symbol) is not None:
            continue
        bodies = [term_of(data, bound.__getitem__) for data in _known(name, bound)]
        for body in bodies if bound[name] == symbol else [bound[name]]:
            if symbol.declaration.name not in names_behind([body], [*definitions, *found]):
                found.append(Definition(symbol.declaration, symbol.index, (), body))
                break
    return found


def names_behind(terms: Iterable[Term], definitions: Iterable[Definition]) -> set[Name]:
    """Returns the names of all symbols in the terms and in the definitions that they use."""
    bodies: dict[Name, list[Term]] = {}
    for definition in definitions:
        bodies.setdefault(definition.declaration.name, []).append(definition.body)
    waiting = list(terms)
    names: set[Name] = set()
    while waiting:
        new = {t.declaration.name for t in waiting.pop().symbols()} - names
        names |= new
        waiting += [body for name in new for body in bodies.get(name, ())]
    return names


def _known(name: str, bound: Container[str]) -> Iterator[Data]:
    """Yields the expressions for the named quantity by bound quantities."""
    for made, data in (*DEFINED, *ALSO):
        if made == name and all(part in bound for part in names_in(data)):
            yield data
