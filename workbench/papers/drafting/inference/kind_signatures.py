"""Signatures of operations: the kinds that each takes and returns, as rows of patterns with costs.

A kind is a size (rows, columns), or QUATERNION; None means any kind. The size 0 is a dimension that no
formula determines.
Patterns: s a scalar; q a quaternion; 3x1 that size; nxm any size, where equal letters in a row are equal; NxM
likewise, but not a scalar; A any kind, the same in the row; B likewise, but no column; _ anything. The cost
follows ~, in tenths. A row without a cost is what the typed language does; one with a cost uses a convention
of the text.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import product

Size = tuple[int, int]
#: A size, or "q": a quaternion.
Kind = Size | str
QUATERNION = "q"
SCALAR, VECTOR, TENSOR = (1, 1), (3, 1), (3, 3)

#: The cost of an operation that fits no row.
MISFIT = 60

_TIMES_SCALAR = "s A -> A; A s -> A;"
_PRODUCTS = (
    " nxk Kxm -> nxm; q q -> q; 4x4 3x1 -> 3x1 ~25; q 3x1 -> q ~6; 3x1 q -> q ~6;"
    " 4x4 q -> q ~2; nx4 q -> nx1 ~8; 3x1 3x1 -> 3x3 ~40; 4x1 q -> q ~12; q 4x1 -> q ~12;"
    " q 1xn -> 4xn ~25"
)
_MUL = _TIMES_SCALAR + _PRODUCTS
#: The cost of a scalar before or behind a dot and a column, which is usually a scalar product.
_DOTTED = "s B -> B ~1; B s -> B ~1; s nx1 -> nx1 ~9; nx1 s -> nx1 ~9"


def _dearer(rows: str, more: int) -> str:
    """Returns the rows with a higher cost each."""
    pieces = (piece.partition("~") for piece in rows.split(";"))
    return "; ".join(f"{row.strip()} ~{int(cost or 0) + more}" for row, _, cost in pieces)


SIGNATURES = {
    "mul": _MUL,
    "dot": f"nx1 nx1 -> s; 1xn 1xn -> s ~3; {_DOTTED}; {_dearer(_PRODUCTS, 1)}; q q -> s ~9",
    "cross": "3x1 3x1 -> 3x1; s s -> s ~50; 2x1 2x1 -> s ~25; 3x1 3x3 -> 3x3 ~20",
    "wedge": "3x1 3x1 -> 3x1 ~1; 3x1 3x1 -> 3x3 ~4; s s -> s ~30",
    "outer": "3x1 3x1 -> 3x3; 3x3 3x3 -> 3x3 ~15; nxm kxl -> _ ~20; q q -> q ~1; q 3x1 -> q ~6;"
    " 3x1 q -> q ~6",
    "compose": _dearer(_MUL, 1),
    "equal": "A A -> A; q s -> q ~15; s q -> q ~15; q 3x1 -> q ~18; 3x1 q -> q ~18; q 4x1 -> q ~8;"
    " 4x1 q -> q ~8",
    "add": "A A -> A; q s -> q ~4; s q -> q ~4; q 3x1 -> q ~12; 3x1 q -> q ~12; s 3x1 -> q ~30;"
    " q 4x1 -> q ~8; 4x1 q -> q ~8",
    "compare": "s s -> s",
    "directions": "3x1 3x1 -> s",
    "div": "A s -> A; A q -> A ~20",
    "partial": "A s -> A; s nx1 -> nx1; s nx1 -> 1xn; nx1 mx1 -> nxm; nxm _ -> _ ~15",
    "inverse": "NxN -> NxN; q -> q; s -> s ~9",
    "det": "NxN -> s; s -> s ~25",
    "trace": "NxN -> s; s -> s ~30",
    "symmetric": "NxN -> NxN",
    "adjugate": "3x3 -> 3x3; NxN -> NxN ~5; q -> q ~6",
    "transpose": "NxM -> MxN; s -> s ~30; q -> 1x4 ~15",
    "star": "A -> A ~6; nxm -> mxn ~10; q -> q",
    "conjugate": "q -> q",
    "power": "nxn -> nxn; q -> q ~3; nx1 -> s ~12",
    "skew": "3x1 -> 3x3; 6x1 -> 4x4 ~7; 6x1 -> 6x6 ~14; s -> 2x2 ~20; NxN -> NxN ~2",
    "vect": "3x3 -> 3x1; 4x4 -> 6x1 ~7",
    "bracketed": "A -> A; 3x1 -> 3x3 ~10; 6x1 -> 4x4 ~17",
    "marked": "_ A -> A; 3x1 3x3 -> 3x3",
    "exp": "nxn -> nxn; q -> q ~3; 3x1 -> 3x3 ~12; 6x1 -> 4x4 ~12; 3x1 -> q ~10",
    "log": "nxn -> nxn ~1; 3x3 -> 3x1 ~5; 4x4 -> 6x1 ~5; q -> q ~3; q -> 3x1 ~5",
    "sandwich": "q q -> q; q 3x1 -> q ~4; nxn nxn -> nxn; s A -> A ~25",
    "function": "s -> s",
    "root": "s -> s",
    "norm": "nx1 -> s; q -> s; _ -> s ~1",
    "inner": "A A -> s ~1",
    "scalar part": "q -> s; _ -> s ~20",
    "vector part": "q -> 3x1; _ -> 3x1 ~20",
    "quaternion": "s 3x1 -> q; _ _ -> q ~30",
    "component": "_ -> s ~1; _ -> _ ~5",
    "diag": "nx1 -> nxn ~1; nxn -> nx1 ~5",
    "divergence": "3x1 -> s",
    "curl": "3x1 -> 3x1",
    "operator": "s -> s ~1; _ -> s ~3",
    "value": "A _ -> A",
    "re": "A -> A",
    "du": "A -> A",
    "atan2": "_ -> s ~1",
}

Row = tuple[tuple[str, ...], str, int]


@cache
def rows(op: str) -> tuple[Row, ...]:
    """Returns each row of an operation: the patterns of its parts and of its value, and its cost."""
    found = []
    for piece in SIGNATURES[op].split(";"):
        patterns, _, cost = piece.partition("~")
        *parts, value = patterns.replace("->", " ").split()
        found.append((tuple(parts), value, int(cost or 0)))
    return tuple(found)


@cache
def values(op: str, parts: tuple[Kind | None, ...]) -> tuple[tuple[Kind | None, int], ...]:
    """Returns the kinds of the value for parts of these kinds, with costs; any kind if no row fits."""
    found: dict[Kind | None, int] = {}
    for patterns, value, cost in rows(op):
        known: dict[str, Kind | int | None] = {}
        fits = len(patterns) == len(parts) and all(
            _matches(pattern, kind, known) for pattern, kind in zip(patterns, parts, strict=True)
        )
        if fits:
            made = _made(value, known)
            found[made] = min(cost, found.get(made, cost))
    return tuple(found.items()) or ((None, MISFIT),)


def _matches(pattern: str, kind: Kind | None, known: dict[str, Kind | int | None]) -> bool:
    if pattern == "_" or kind is None:
        return True
    if pattern in "AB":
        is_column = isinstance(kind, tuple) and kind[0] != 1 == kind[1]
        return known.setdefault(pattern, kind) == kind and not (is_column and pattern == "B")
    if pattern in "sq":
        return kind == (SCALAR if pattern == "s" else QUATERNION)
    if isinstance(kind, str) or (pattern[0].isupper() and kind == SCALAR):
        return False
    return all(
        letter == str(size) if letter.isdigit() else known.setdefault(letter.lower(), size) == size
        for letter, size in zip(pattern.split("x"), kind, strict=True)
    )


def _made(pattern: str, known: dict[str, Kind | int | None]) -> Kind | None:
    if pattern in ("_", "A", "B"):
        return known.get(pattern)  # type: ignore[return-value]
    if pattern in "sq":
        return SCALAR if pattern == "s" else QUATERNION
    sizes = [int(letter) if letter.isdigit() else known.get(letter.lower()) for letter in pattern.split("x")]
    return None if None in sizes else (sizes[0], sizes[1])  # type: ignore[return-value]


Table = dict[Kind | None, int]


def combined(op: str, tables: Sequence[Table]) -> Table:
    """Returns the cost of each kind of the value, for the given costs of the parts."""
    found: Table = {}
    for parts in product(*(table.items() for table in tables)):
        cost = sum(own for _, own in parts)
        for kind, more in values(op, tuple(kind for kind, _ in parts)):
            if cost + more < found.get(kind, 10**6):
                found[kind] = cost + more
    return cheapest(found)


def cheapest(table: Table) -> Table:
    """Returns the table without entries that cost at least a misfit more than the cheapest."""
    least = min(table.values())
    return {kind: cost for kind, cost in table.items() if cost <= least + MISFIT}
