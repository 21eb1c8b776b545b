"""Fractions of angles: where θ/2 stands under a sine or cosine, θ is 2 h with a free angle h."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from math import lcm, prod

from workbench.judge.subject.inventory import Lookup
from workbench.language.construct import apply, number, symbol
from workbench.language.printer import to_latex
from workbench.language.terms import Apply, Number, Symbol, Term


class _Parts:
    """The definitions, and beside them angles as multiples of parts of them."""

    def __init__(self, definitions: Lookup, multiples: Mapping[Symbol, Term]) -> None:
        self._definitions = definitions
        self._multiples = multiples

    def lookup(self, symbol: Symbol) -> Term | None:
        return self._multiples.get(symbol) or self._definitions.lookup(symbol)


def with_parts_of_angles(terms: Iterable[Term], definitions: Lookup) -> Lookup:
    """The definitions under which every angle in the terms is a whole multiple of a free one."""
    denominators: dict[Symbol, int] = {}
    for argument in _arguments(terms, definitions, set()):
        size = _denominator(argument, definitions)
        for angle in _free_angles(argument, definitions) if size > 1 else ():
            denominators[angle] = lcm(denominators.get(angle, 1), size)
    multiples = {a: _multiple(a, size) for a, size in denominators.items()}
    return _Parts(definitions, multiples) if multiples else definitions


def _arguments(terms: Iterable[Term], definitions: Lookup, seen: set[Symbol]) -> Iterator[Term]:
    """What sines, cosines and exponentials are taken of, in definitions too."""
    for term in terms:
        for part in term.walk():
            if isinstance(part, Apply) and part.head in ("sin", "cos", "exp"):
                yield part.arguments[0]
            elif isinstance(part, Symbol) and part not in seen:
                seen.add(part)
                body = definitions.lookup(part)
                if body is not None:
                    yield from _arguments([body], definitions, seen)


def _denominator(term: Term, definitions: Lookup) -> int:
    match term:
        case Number(value=value):
            return value.denominator
        case Symbol():
            body = definitions.lookup(term)
            return 1 if body is None else _denominator(body, definitions)
        case Apply(head="div", arguments=(top, Number(value=value))):
            return _denominator(top, definitions) * abs(value.numerator)
        case Apply(head="mul"):
            return prod(_denominator(a, definitions) for a in term.arguments)
    return lcm(*(_denominator(child, definitions) for child in term.children))


def _free_angles(term: Term, definitions: Lookup) -> Iterator[Symbol]:
    for part in term.walk():
        if isinstance(part, Symbol) and part.type.kind == "scalar":
            body = definitions.lookup(part)
            if body is None:
                yield part
            else:
                yield from _free_angles(body, definitions)


def _multiple(angle: Symbol, size: int) -> Term:
    name = rf"\frac{{{to_latex(angle)}}}{{{size}}}"
    part = symbol(replace(angle.declaration, name=name, indices=0, weight=angle.weight, parameters=0))
    return apply("mul", number(size), part)
