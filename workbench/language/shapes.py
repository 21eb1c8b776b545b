"""Zeros and unit tensors, alone or with a sign or factor: what stands beside them decides their shape."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

from workbench.language.terms import Apply, Identity, IllFormed, Term, Zero
from workbench.language.types import COVECTOR, SCALAR, TENSOR, VECTOR, Type

Size = tuple[int, int]

_SIZES: dict[str, Size] = {"tensor": (3, 3), "vector": (3, 1), "covector": (1, 3), "scalar": (1, 1)}
_OF_SIZE = {_SIZES[type_.kind]: type_ for type_ in (TENSOR, VECTOR, COVECTOR, SCALAR)}


def multiple(term: Term) -> Literal["zero", "identity"] | None:
    """Whether the term is written as a multiple of zero or of the unit tensor."""
    match term:
        case Zero():
            return "zero"
        case Identity():
            return "identity"
        case Apply(head="neg" | "div"):
            return multiple(term.arguments[0])
        case Apply(head="mul", arguments=(left, right)):
            if left.type.kind == "scalar":
                return multiple(right)
            return multiple(left) if right.type.kind == "scalar" else None
        case Apply(head="add"):
            found = {multiple(argument) for argument in term.arguments}
            return None if None in found else "identity" if "identity" in found else "zero"
    return None


def filling(term: Term) -> Literal["zero", "identity"] | None:
    """What a term without a shape of its own is a multiple of; None for a term that has a shape, such as
    the zero 𝟎_{3×3}."""
    found = multiple(term)
    return None if found == "zero" and term.type.kind not in ("scalar", "vector") else found


def shaped(term: Term, type_: Type) -> Term:
    """A multiple of zero or of the unit tensor, as one of this type; it stays dual if it is."""
    if term.type.with_dual(False) == type_.with_dual(False):
        return term
    match term:
        case Zero() | Identity():
            return replace(term, type=type_.with_dual(False))
        case Apply(head="mul", arguments=(left, right)) if left.type.kind == "scalar":
            arguments = (left, shaped(right, type_))
        case Apply(head="add"):
            arguments = tuple(shaped(argument, type_) for argument in term.arguments)
        case Apply():
            arguments = (shaped(term.arguments[0], type_), *term.arguments[1:])
    return replace(term, type=type_.with_dual(term.type.dual), arguments=arguments)


def size_of(type_: Type) -> Size | None:
    """The rows and columns of a type; None for an operator."""
    return (sum(type_.rows), sum(type_.columns)) if type_.kind == "block" else _SIZES.get(type_.kind)


def layout(entries: Sequence[Sequence[Term]]) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The heights of the rows and the widths of the columns of a block matrix.

    A unit tensor is as wide as it is high, 3 by 3 where nothing else says so; a row or column of zeros has
    the size 1. Raises IllFormed where entries do not fit.
    """
    height: dict[int, int] = {}
    width: dict[int, int] = {}

    def fix(known: dict[int, int], place: int, size: int, what: str) -> None:
        if known.setdefault(place, size) != size:
            message = f"{what} {place + 1} of the matrix holds blocks of size {known[place]} and {size}"
            raise IllFormed(message)

    squares = []
    for i, row in enumerate(entries):
        for j, entry in enumerate(row):
            size = size_of(entry.type)
            if size is None:
                raise IllFormed(f"expected matrices as entries of a matrix, got an {entry.type}")
            fills = filling(entry)
            if fills is None:
                fix(height, i, size[0], "row")
                fix(width, j, size[1], "column")
            elif fills == "identity":
                squares.append((i, j))
    while squares:
        place = next((p for p in squares if p[0] in height or p[1] in width), squares[0])
        squares.remove(place)
        i, j = place
        size = height.get(i) or width.get(j) or 3
        fix(height, i, size, "row")
        fix(width, j, size, "column")
    return (
        tuple(height.get(i, 1) for i in range(len(entries))),
        tuple(width.get(j, 1) for j in range(len(entries[0]))),
    )


def fitted(entry: Term, rows: int, columns: int) -> Term:
    """An entry of a block matrix in a place of this size."""
    fills = filling(entry)
    if fills is None:
        return entry
    if fills == "identity" and rows == 1:
        raise IllFormed("the unit tensor in a place of one row and one column")
    type_ = _OF_SIZE.get((rows, columns)) or Type("block", rows=(rows,), columns=(columns,))
    return shaped(entry, type_)
