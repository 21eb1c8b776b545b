"""Shapes: zeros and unit tensors take the shape of their neighbours, blocks form one matrix, and scalars and
vectors next to a quaternion become quaternions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Literal

from workbench.core.codes.type_codes import TypeCode
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Apply, Block, Identity, IllFormed, Number, Term, Unsupported, Zero
from workbench.core.types import SCALAR, TENSOR, VECTOR, Type


def multiple(term: Term) -> Literal["zero", "identity"] | None:
    """Returns the kind of multiple that the term is: of zero, of the unit tensor, or None."""
    match term:
        case Zero():
            return "zero"
        case Identity():
            return "identity"
        case Apply(head="neg" | "div" | "transpose"):
            return multiple(term.arguments[0])
        case Apply(head="mul", arguments=(left, right)):
            if left.type.kind == "scalar":
                return multiple(right)
            return multiple(left) if right.type.kind == "scalar" else None
        case Apply(head="add"):
            found: Literal["zero", "identity"] = "zero"
            for argument in term.arguments:
                if (each := multiple(argument)) is None:
                    return None
                found = "identity" if each == "identity" else found
            return found
    return None


def filling(term: Term) -> Literal["zero", "identity"] | None:
    """Returns "zero" or "identity" for a term that takes its shape from its neighbours; None for a term with
    a fixed shape, such as the zero 𝟎_{3×3}."""
    found = multiple(term)
    if found is None or is_sized(term):
        return None
    if isinstance(term, Apply) and term.head == "transpose":
        term = term.arguments[0]
    is_shaped = found == "zero" and term.type.kind not in ("scalar", "vector")
    return None if is_shaped and not any(map(_is_of_one_number, term.walk())) else found


def is_sized(term: Term) -> bool:
    """True if the term is a multiple of a zero or of a unit matrix that is printed with its size. The n of
    𝟎_n does not fix whether it is a column."""
    return multiple(term) is not None and any(
        isinstance(part, Zero | Identity) and part.printed and not _is_of_one_number(part)
        for part in term.walk()
    )


def _is_of_one_number(term: Term) -> bool:
    return isinstance(term, Zero) and term.printed.isdecimal()


def sizes(types: Iterable[Type]) -> str:
    """Returns the distinct sizes of several types as text: 3×3 and 4×4."""
    return " and ".join(dict.fromkeys(f"{each.rows}×{each.columns}" for each in types))


def shaped(term: Term, type_: Type) -> Term:
    """Returns a multiple of zero or of the unit tensor with this type; a dual term stays dual. Raises
    IllFormed."""
    if term.type.with_dual(False) == type_.with_dual(False):
        return term
    arguments: tuple[Term, ...]
    match term:
        case Identity() if type_.rows == 1:
            raise IllFormed(TypeCode.UNIT_TENSOR_IN_ONE_ROW())
        case Zero(printed=printed) if _is_of_one_number(term):
            return _of_one_number(term, int(printed), type_)
        case Zero() | Identity():
            return replace(term, type=type_.with_dual(False))
        case Apply(head="transpose", arguments=(turned,)) if _is_of_one_number(turned):
            arguments = (shaped(turned, Type(type_.columns, type_.rows)),)
        case Apply(head="transpose", arguments=(turned,)):
            return shaped(turned, type_)
        case Apply(head="mul", arguments=(left, right)) if left.type.kind == "scalar":
            arguments = (left, shaped(right, type_))
        case Apply(head="add"):
            arguments = tuple(shaped(argument, type_) for argument in term.arguments)
        case Apply():
            arguments = (shaped(term.arguments[0], type_), *term.arguments[1:])
    assert isinstance(term, Apply)
    return replace(term, type=type_.with_dual(term.type.dual), arguments=arguments)


def _of_one_number(term: Zero, size: int, type_: Type) -> Zero:
    """Returns 𝟎_n as a column of n or as a square matrix of n rows. Raises IllFormed and Unread."""
    if type_.rows != size or type_.columns not in (1, size) or type_.kind == "quaternion":
        message = TypeCode.ZERO_OF_ANOTHER_SIZE(size=size, place=sizes([type_]))
        if (type_.rows, type_.columns) == (1, size):
            raise Unsupported(TypeCode.ROW_OF_ZEROS(message=message, size=size))
        raise IllFormed(message)
    return replace(term, type=type_.with_dual(False))


def with_units(entries: Sequence[Sequence[Term]]) -> Sequence[Sequence[Term]]:
    """Returns the entries with a 1 or −1 next to a square block converted to a unit tensor: [1 0; T -1]."""
    blocks = [[each.type.rows > 1 and each.type.is_square for each in row] for row in entries]
    high = [any(row) for row in blocks]
    wide = [any(column) for column in zip(*blocks, strict=True)]
    return [
        [_unit(each) if high[i] or wide[j] else each for j, each in enumerate(row)]
        for i, row in enumerate(entries)
    ]


def with_scaled_units(entries: Sequence[Sequence[Term]]) -> Sequence[Sequence[Term]]:
    """Returns the entries with a scalar m in a row and column of larger blocks converted to m times the unit
    tensor."""
    sizes = [[each.type if filling(each) is None else SCALAR for each in row] for row in entries]
    high = [max(size.rows for size in row) > 1 for row in sizes]
    wide = [max(size.columns for size in column) > 1 for column in zip(*sizes, strict=True)]
    unit = Identity(TENSOR, Linear(0))
    return [
        [
            Apply(TENSOR.with_dual(each.type.dual), each.weight, "mul", (each, unit))
            if filling(each) is None and each.type.kind == "scalar" and high[i] and wide[j]
            else each
            for j, each in enumerate(row)
        ]
        for i, row in enumerate(entries)
    ]


def _unit(entry: Term) -> Term:
    unit = Identity(TENSOR, entry.weight)
    match entry:
        case Number(value=1):
            return unit
        case Number(value=-1) | Apply(head="neg", arguments=(Number(value=1),)):
            return Apply(TENSOR, entry.weight, "neg", (unit,))
    return entry


def layout(entries: Sequence[Sequence[Term]]) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Returns the heights of the rows and the widths of the columns of a block matrix.

    A unit tensor is square, 3 by 3 if nothing else fixes its size. A row or column of zeros has the size 1;
    zero vectors in a column have the size 3. Raises IllFormed if entries do not match.
    """
    height: dict[int, int] = {}
    width: dict[int, int] = {}

    def fix(known: dict[int, int], place: int, size: int, what: str) -> None:
        if known.setdefault(place, size) != size:
            raise IllFormed(
                TypeCode.UNEQUAL_BLOCKS(what=what, number=place + 1, size=known[place], size_2=size)
            )

    squares = []
    for i, row in enumerate(entries):
        for j, entry in enumerate(row):
            if entry.type.algebra:
                raise IllFormed(TypeCode.ENTRY_OF_NO_MATRIX(type=_with_article(entry.type)))
            fills = filling(entry)
            if fills is None:
                fix(height, i, entry.type.rows, "row")
                fix(width, j, entry.type.columns, "column")
            elif fills == "identity":
                squares.append((i, j))
    while squares:
        place = next((p for p in squares if p[0] in height or p[1] in width), squares[0])
        squares.remove(place)
        i, j = place
        size = height.get(i) or width.get(j) or 3
        fix(height, i, size, "row")
        fix(width, j, size, "column")
    of_zeros = [entries[i][0].type.rows if len(entries[i]) == 1 else 1 for i in range(len(entries))]
    return (
        tuple(height.get(i, of_zeros[i]) for i in range(len(entries))),
        tuple(width.get(j, 1) for j in range(len(entries[0]))),
    )


def has_open_zeros(term: Term) -> bool:
    """True if a non-square matrix in the term has a row or column of zeros, whose height or width may exceed
    1."""
    blocks = [part for part in term.walk() if isinstance(part, Block) and not part.type.is_square]
    lines = ((line, heights) for part in blocks for line, heights in _lines_of(part))
    return any(all(isinstance(each, Zero) for each in line) and sizes == {1} for line, sizes in lines)


def _lines_of(matrix: Block) -> Iterator[tuple[Sequence[Term], set[int]]]:
    """Yields the rows with their heights and the columns with their widths, for a matrix with blocks."""
    if any(each.type.kind != "scalar" and multiple(each) != "zero" for row in matrix.entries for each in row):
        yield from ((row, {each.type.rows for each in row}) for row in matrix.entries)
        columns = zip(*matrix.entries, strict=True)
        yield from ((column, {each.type.columns for each in column}) for column in columns)


def stretched(terms: Sequence[Term]) -> tuple[Term, ...]:
    """Returns the terms with zeros stretched: the 0 of [0; x] next to a column of 6 gets the three remaining
    rows."""
    heights = {each.type.rows for each in terms if filling(each) is None}
    return tuple(_stretched(each, max(heights, default=0)) for each in terms)


def _stretched(term: Term, height: int) -> Term:
    missing = height - term.type.rows
    if not isinstance(term, Block) or missing < 1 or term.type.columns != 1 or term.type.algebra:
        return term
    column = [entry for (entry,) in term.entries]
    zeros = [i for i, each in enumerate(column) if filling(each) == "zero" and each.type.rows == 1]
    if len(zeros) != 1 or all(each.type.rows == 1 for each in column):
        return term
    (place,) = zeros
    zero = shaped(column[place], Type(missing + 1, 1))
    entries = (*term.entries[:place], (zero,), *term.entries[place + 1 :])
    return replace(term, type=replace(term.type, rows=height), entries=entries)


def fitted(entry: Term, rows: int, columns: int) -> Term:
    """Returns an entry of a block matrix with the size of its slot."""
    fills = filling(entry)
    if fills is None:
        return entry
    if rows == 1 and isinstance(entry, Zero) and entry.printed == str(columns):
        return replace(entry, type=Type(1, columns))  # [R p; 0_3 1]
    return shaped(entry, Type(rows, columns))


def scalar_and_vector(term: Term) -> tuple[Term, Term] | None:
    """Returns the scalar and vector part of a term that is a quaternion next to a quaternion: a scalar, a
    vector, or a column written as (s; x) or by its four components. Returns None for other terms."""
    if filling(term) == "zero":
        return None
    if term.type.kind == "scalar":
        return term, Zero(VECTOR, None)
    if term.type.kind == "vector":
        return Zero(SCALAR, None), term
    if not isinstance(term, Block) or (term.type.rows, term.type.columns) != (4, 1):
        return None
    (first,), *rest = term.entries
    if first.type.kind != "scalar" or len(term.entries[0]) > 1:
        return None
    if len(rest) == 1:
        return first, rest[0][0]
    is_dual = any(entry.type.dual for (entry,) in rest)
    return first, Block(VECTOR.with_dual(is_dual), term.weight, tuple(rest))


def _with_article(type_: Type) -> str:
    return f"{'an' if str(type_)[0] in 'aeiou' else 'a'} {type_}"
