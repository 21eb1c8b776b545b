"""Values of the sides of an equation at random real points, in floating point: a first test of candidates.

It excludes candidates that differ there by far; the judge decides. It covers scalars, columns and matrices,
with elementary functions; without assumptions, and without the rates of defined symbols.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from random import Random
from typing import Any

import numpy as np

from workbench.core.integer_expressions import Linear
from workbench.core.terms import (
    Apply,
    Block,
    Derivative,
    Identity,
    IllFormed,
    Number,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
)
from workbench.core.types import PI
from workbench.engines.inventory import Lookup, WithDefinitions
from workbench.language.definitions import expand

_POINTS = 3
_DIFFERENT = 1e-6
#: Of the time, for the rates.
_STEP = 1e-4
#: Flags of symbols that may have any value between 0 and 1.
_PLAIN = frozenset({"constant", "positive", "independent", "free", "clock", "introduced"})
_SCALARS: Mapping[str, Callable[[Any], Any]] = {
    "sin": np.sin,
    "cos": np.cos,
    "exp": np.exp,
    "log": np.log,
    "arcsin": np.arcsin,
    "arccos": np.arccos,
    "arctan": np.arctan,
    "sqrt": np.sqrt,
    "abs": np.abs,
}


class _Unknown(Exception):
    """A term whose value is not computed here."""


@dataclass
class _Point:
    """One point, perhaps a little later or before, with the values of the terms that were computed there."""

    place: int
    shift: float = 0.0
    known: dict[Term, Any] = field(default_factory=dict)


class RealValues:
    """The values of terms at real points, which are the same for all candidates of a claim."""

    def __init__(self, definitions: Lookup, seed: int = 5) -> None:
        self._definitions = definitions
        self._seed = seed
        self._points = [_Point(place) for place in range(_POINTS)]

    @staticmethod
    def under(definitions: Lookup, assume: Sequence[Statement]) -> RealValues | None:
        """Returns the values where each assumption gives the value of a free symbol; None for others."""
        bodies: dict[Symbol, Term] = {}
        for each in assume:
            own = each.left if isinstance(each, Relation) and each.operator == "=" else None
            is_free = isinstance(own, Symbol) and definitions.lookup(own) is None and own not in bodies
            if not isinstance(each, Relation) or not isinstance(own, Symbol) or not is_free:
                return None
            bodies[own] = each.right
        return RealValues(WithDefinitions(definitions, bodies) if bodies else definitions)

    def differ(self, statement: Statement) -> bool | None:
        """Returns whether the sides differ by far where both have values; None if that is not known."""
        if not isinstance(statement, Relation) or statement.operator != "=":
            return None
        try:
            left, right = (expand(side, self._definitions) for side in (statement.left, statement.right))
            with np.errstate(all="ignore"):
                pairs = [(self._value(left, p), self._value(right, p)) for p in self._points]
        except (_Unknown, IllFormed, RecursionError, ValueError, OverflowError, ZeroDivisionError):
            return None
        apart = [_distance(one, other) for one, other in pairs]
        known = [each for each in apart if np.isfinite(each)]
        return any(each > _DIFFERENT for each in known) if known else None

    def _value(self, term: Term, point: _Point) -> Any:
        if term not in point.known:
            point.known[term] = self._computed(term, point)
        return point.known[term]

    def _computed(self, term: Term, point: _Point) -> Any:
        match term:
            case Symbol():
                return self._random(term, point)
            case Number(value=value):
                return np.full((1, 1), float(value))
            case Zero():
                return np.zeros((term.type.rows, term.type.columns))
            case Identity():
                return np.eye(term.type.rows)
            case Power(base=base, exponent=exponent) if exponent.is_number and base.type.kind == "scalar":
                return self._value(base, point) ** int(exponent)
            case Block(entries=entries):
                return np.block([[self._value(entry, point) for entry in row] for row in entries])
            case Derivative(body=body) if term.order == Linear(1):
                return self._rate(body, point)
            case Apply():
                return self._applied(term, [self._value(each, point) for each in term.arguments])
        raise _Unknown

    def _rate(self, body: Term, point: _Point) -> Any:
        """Returns the rate of what changes with the time only, as a difference quotient."""
        symbols = list(body.symbols())
        if not all(each.declaration.constant or each.declaration.clock for each in symbols):
            raise _Unknown
        later, before = (_Point(point.place, shift=shift) for shift in (_STEP, -_STEP))
        return (self._value(body, later) - self._value(body, before)) / (2 * _STEP)

    def _random(self, symbol: Symbol, point: _Point) -> Any:
        declared = symbol.declaration
        if declared.name == PI.name:
            return np.full((1, 1), np.pi)
        if symbol.type.dual or symbol.type.kind not in ("scalar", "vector", "tensor", "matrix", "covector"):
            raise _Unknown
        if declared.flags - _PLAIN or symbol.arguments:
            raise _Unknown
        draw = Random(f"{symbol!r} {point.place} {self._seed}")
        shift = point.shift if declared.clock else 0.0
        size = (symbol.type.rows, symbol.type.columns)
        return np.array([[shift + draw.uniform(0.2, 0.9) for _ in range(size[1])] for _ in range(size[0])])

    def _applied(self, term: Apply, values: list[Any]) -> Any:
        head = term.head
        match values:
            case [value] if head in _SCALARS and value.shape == (1, 1):
                return _SCALARS[head](value)
            case [value] if head == "neg":
                return -value
            case [value] if head == "transpose":
                return value.T
            case [value] if head == "norm" and 1 in value.shape:
                return np.full((1, 1), np.sqrt((value**2).sum()))
            case [one, other] if head in ("mul", "div", "pow") and other.shape == (1, 1):
                return one * other if head == "mul" else one / other if head == "div" else _raised(one, other)
            case [one, other] if head == "mul":
                return one * other if one.shape == (1, 1) else one @ other
            case [one, other] if head == "dot" and one.shape == other.shape:
                return np.full((1, 1), (one * other).sum())
            case [one, other] if head == "cross":
                return np.cross(one[:, 0], other[:, 0]).reshape(3, 1)
            case [first, *rest] if head == "add" and all(each.shape == first.shape for each in rest):
                return sum(rest, first)
        raise _Unknown


def _raised(base: Any, exponent: Any) -> Any:
    if base.shape != (1, 1):
        raise _Unknown
    return base**exponent


def _distance(one: Any, other: Any) -> float:
    if one.shape != other.shape:
        raise _Unknown
    size = float(np.abs(one).max() + np.abs(other).max())
    return float(np.abs(one - other).max()) / max(size, 1e-3)
