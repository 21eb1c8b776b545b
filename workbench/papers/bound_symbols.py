"""Relations between the bound symbols of [motion]: ω bound to w_WB is the angular velocity of R, R_WB.

A bound symbol that follows from others is defined by them, so that the exact engines know what Drake's
motions satisfy. The motions cover bound symbols that stay free: a claim that holds on them is not refuted.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping

from workbench.core.terms import Definition, Symbol
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
            behind = Definitions([*definitions, *found]).symbols_in(body)
            if all(part.declaration.name != symbol.declaration.name for part in behind):
                found.append(Definition(symbol.declaration, symbol.index, (), body))
                break
    return found


def _known(name: str, bound: Container[str]) -> Iterator[Data]:
    """Yields the expressions for the named quantity by bound quantities."""
    for made, data in (*DEFINED, *ALSO):
        if made == name and all(part in bound for part in names_in(data)):
            yield data
