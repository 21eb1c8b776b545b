"""The relations between bindings as terms of the language, over symbols that stand for bindings."""

from __future__ import annotations

from collections.abc import Callable

from workbench.core.construct import apply, derivative, dual_unit
from workbench.core.terms import Term
from workbench.drake.relations import Term as Data


def term_of(data: Data, symbol: Callable[[str], Term]) -> Term:
    """Returns the term for an entry of `relations.DEFINED`; `symbol` gives the term of a binding."""
    if isinstance(data, str):
        return symbol(data)
    operation, *parts = data
    terms = [term_of(part, symbol) for part in parts]
    match operation:
        case "rate":
            return derivative(terms[0], 1)
        case "sub":
            return apply("add", terms[0], apply("neg", terms[1]))
        case "dual":
            return apply("add", terms[0], apply("mul", dual_unit(), terms[1]))
    return apply(operation, *terms)
