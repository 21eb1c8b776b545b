"""Canonical text of a part of a claim or of a notation; it is the same in each process."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import fields
from fractions import Fraction
from functools import cache
from pathlib import Path, PosixPath, WindowsPath
from typing import Any, NamedTuple

from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Definition, Symbol, Term
from workbench.core.types import Declaration, Type

#: Types that occur in many places, whose texts are cached.
_OFTEN = (Term, Declaration, Definition, Type, Linear, Name)
#: Types whose `repr` is canonical.
_PLAIN = (type(None), str, int, float, Fraction, range, Path, PosixPath, WindowsPath)


class CanonicalText(NamedTuple):
    """text: the canonical text.   names: the names of the symbols in it."""

    text: str
    names: frozenset[Name]


_NONE: frozenset[Name] = frozenset()


def canonical_text(part: Any) -> CanonicalText:
    """Returns the canonical text of the part. Raises TypeError for an unknown type."""
    kind: type = type(part)
    return _teller(kind)(part)


@cache
def _teller(kind: type) -> Callable[[Any], CanonicalText]:
    if issubclass(kind, _PLAIN):
        return lambda part: CanonicalText(repr(part), _NONE)
    if issubclass(kind, _OFTEN):
        return _remembered(kind)
    if issubclass(kind, tuple | list):
        return lambda part: _together("(", map(canonical_text, part), ")")
    if issubclass(kind, dict):
        return lambda part: _together("{", map(canonical_text, part.items()), "}")
    if issubclass(kind, set | frozenset):
        return lambda part: _together("{", sorted(map(canonical_text, part), key=lambda each: each.text), "}")
    if hasattr(kind, "__dataclass_fields__"):
        return by_fields(kind)
    raise TypeError(f"no key can be made of a {kind.__name__}")


def _remembered(kind: type) -> Callable[[Any], CanonicalText]:
    tell_fields, is_symbol = by_fields(kind), issubclass(kind, Symbol)

    @cache
    def tell(part: Any) -> CanonicalText:
        text, names = tell_fields(part)
        return CanonicalText(text, names | {part.declaration.name} if is_symbol else names)

    return tell


def by_fields(kind: type) -> Callable[[Any], CanonicalText]:
    """Returns the function for a dataclass: its type and all fields that are compared."""
    names, head = [each.name for each in fields(kind) if each.compare], f"{kind.__name__}("
    return lambda part: _together(head, (canonical_text(getattr(part, name)) for name in names), ")")


def _together(head: str, parts: Iterable[CanonicalText], tail: str) -> CanonicalText:
    parts = list(parts)
    names = [each.names for each in parts if each.names]
    return CanonicalText(f"{head}{', '.join([each.text for each in parts])}{tail}", _NONE.union(*names))
