"""Scalars of formulas as SymPy's expressions, for tests that no verdict rests on."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Any

from workbench.core.terms import IllFormed, Symbol, Term
from workbench.core.types import PI
from workbench.engines.inventory import NotExact
from workbench.engines.jet import sympy_gate as sympy
from workbench.engines.jet.closed_values import expression
from workbench.language.printing.printer import to_latex

#: What a term without such a value may raise.
NO_VALUE = (NotExact, IllFormed, ValueError, TypeError, IndexError, ZeroDivisionError)


def symbolic(term: Term, values: Mapping[str, Any] = {}) -> Any:
    """Returns a term as a matrix, in which symbols are SymPy's by their LaTeX. Raises one of NO_VALUE.

    values: symbols → the scalars that stand for them.
    """
    return expression(term, partial(_value, values))


def _value(values: Mapping[str, Any], symbol: Symbol) -> Any:
    name = to_latex(symbol)
    return sympy.pi if symbol.declaration == PI else values.get(name, sympy.Symbol(name))
