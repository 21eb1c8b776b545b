"""Cost of the readings of a formula for given kinds of its symbols."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from workbench.papers.drafting.inference.kind_operations import Operation
from workbench.papers.drafting.inference.kind_signatures import (
    MISFIT,
    QUATERNION,
    SCALAR,
    SIGNATURES,
    TENSOR,
    VECTOR,
    Kind,
    Size,
    Table,
    cheapest,
    combined,
)
from workbench.papers.drafting.inference.walker import IDENTITY, ZERO
from workbench.papers.drafting.typefaces import flat

#: The cost of reading a bracket after a letter as a product and as arguments, by the bracket's shape.
BRACKETS = {"time": (60, 0), "lone": (8, 0), "tuple": (0, 4), "skewed": (0, 5), "unclear": (0, 6)}
#: The cost of 1 as a unit tensor.
_ONE = 15
#: The cost of a bold 1 as a quaternion, so that it is one only beside others.
_ONE_QUATERNION = 20
#: The costs of a unit tensor as a number, and of a column of four numbers as a quaternion.
_UNIT_NUMBER, _COLUMN_AS_QUATERNION = 30, 16
#: The cost of a unit tensor as the number 1, as in 1 + vᵀ A u; one in blackboard bold is no number.
_UNIT_ONE = 25
#: The sizes of a unit tensor.
_UNITS: Table = {TENSOR: 0, (0, 0): 2, (2, 2): 5, (4, 4): 5, (6, 6): 5}
#: The weight of a misfit of a matrix whose entries are printed.
_OF_PRINTED_SIZE = 4
_SETS = re.compile(r"\\(?:math(?:bb|bf|cal|rm|sf|frak)|operatorname)")


class Costs:
    """The cheapest readings of operations, cached by the kinds of the symbols in them."""

    def __init__(self) -> None:
        self._known: dict[tuple[Operation, tuple[Kind, ...]], Table] = {}

    def table(self, tree: Operation, kinds: Mapping[str, Kind]) -> Table:
        """Returns the cost of each kind of the value."""
        key = (tree, tuple([kinds[name] for name in tree.names]))
        known = self._known.get(key)
        if known is None:
            known = self._known[key] = self._fresh(tree, kinds)
        return known

    @property
    def count(self) -> int:
        """The number of readings of operations evaluated so far."""
        return len(self._known)

    def least(self, tree: Operation, kinds: Mapping[str, Kind]) -> int:
        return min(self.table(tree, kinds).values())

    def misfits(self, tree: Operation, kinds: Mapping[str, Kind]) -> list[Operation]:
        """Returns the innermost operations that do not fit: several that are only unusual do not add up."""
        least = self.least(tree, kinds)
        if least < MISFIT // 2:
            return []
        if found := [each for part in tree.parts for each in self.misfits(part, kinds)]:
            return found
        own = least - sum(self.least(part, kinds) for part in tree.parts)
        return [tree] if own >= MISFIT // 2 else []

    def _fresh(self, tree: Operation, kinds: Mapping[str, Kind]) -> Table:
        op = tree.op
        if not tree.parts:
            return self._leaf(tree, kinds)
        if op == "matrix":
            return self._matrix(tree, kinds)
        parts = [self.table(each, kinds) for each in tree.parts]
        match op:
            case "rate" | "said":
                return parts[0]
            case "marked":
                return combined(op, [*parts, {kinds[tree.text]: 0}])
            case "member":
                return _member(tree, parts[0])
            case "add" | "equal":
                table = parts[0]
                for other in parts[1:]:
                    table = combined(op, (table, other))
                is_printed = op == "equal" and any(map(_is_of_numbers, tree.parts, parts))
                return {kind: _weighed(cost) for kind, cost in table.items()} if is_printed else table
            case "tuple":
                return _stacked(parts)
            case "apply":
                return _applied(tree, parts)
            case "either":
                return {
                    kind: min(each.get(kind, 10**6) for each in parts) for kind in {**parts[0], **parts[1]}
                }
        if op in SIGNATURES:
            return combined(op, parts)
        return {None: sum(min(part.values()) for part in parts)}

    def _leaf(self, tree: Operation, kinds: Mapping[str, Kind]) -> Table:
        text = flat(tree.text)
        match tree.op:
            case "symbol":
                return {kinds[tree.text]: 0}
            case "number":
                if re.fullmatch(r"0+\.?0*", tree.text):
                    return {None: 0}
                return {SCALAR: 0, **{(n, n): _ONE for n in (2, 3, 4, 6)}} if text == "1" else {SCALAR: 0}
            case "zero" if found := ZERO.fullmatch(text):
                return {(int(found[1]), int(found[2] or 1)) if found[1] else None: 0}
            case "identity" if found := IDENTITY.fullmatch(text):
                size = found[1] or found[2]
                one: Table = {QUATERNION: _ONE_QUATERNION} if "1" in text else {}
                if not size and "mathbb" not in tree.text and "mathds" not in tree.text:
                    one = one | {SCALAR: _UNIT_ONE}
                return {(int(size), int(size)): 0} if size else _UNITS | one
            case "unit":
                kind = kinds[tree.text]
                is_square = isinstance(kind, tuple) and kind[0] == kind[1] != 1
                return (
                    {own: cost + 1 for own, cost in _UNITS.items() if own != kind} | {kind: 0}
                    if is_square
                    else {kind: 0}
                )
        return {None: 0}

    def _matrix(self, tree: Operation, kinds: Mapping[str, Kind]) -> Table:
        """Returns the costs of a block matrix; blocks of a row have one height, blocks of a column one
        width."""
        height, width = map(int, tree.text.split())
        blocks = _Blocks(height, width)
        for index, cell in enumerate(tree.parts):
            blocks.put(*divmod(index, width), cell, self.table(cell, kinds))
        return blocks.table()


def _is_of_numbers(tree: Operation, table: Table) -> bool:
    """True for a matrix of numbers, perhaps transposed, whose size is printed."""
    if tree.op == "transpose":
        return _is_of_numbers(tree.parts[0], table)
    return tree.op == "matrix" and None not in table and min(table.values()) == 0 and len(tree.parts) > 3


def _weighed(cost: int) -> int:
    """Returns the cost of an equation with a printed matrix, in which a misfit counts for several."""
    return cost + (_OF_PRINTED_SIZE - 1) * (cost // MISFIT) * MISFIT


#: The cost of several blocks of an open size n beside each other: their sum, 2 n, is taken for an open size.
_OPEN_BLOCKS = 30


class _Blocks:
    """The cells of a matrix, with the known numbers of rows and columns of each."""

    def __init__(self, height: int, width: int) -> None:
        self.heights: list[int | None] = [None] * height
        self.widths: list[int | None] = [None] * width
        self.cost = 0
        self.firm: list[tuple[int, int, Size]] = []
        self.units: list[tuple[int, int]] = []

    def put(self, i: int, j: int, cell: Operation, table: Table) -> None:
        kind = min(table, key=lambda each: (table[each], each == QUATERNION))
        self.cost += table[kind]
        is_unit = cell.op in ("identity", "unit")
        is_free = kind is None or is_unit or cell.op == "zero" or (cell.op, cell.text) == ("number", "1")
        size: Size | None = (4, 1) if isinstance(kind, str) else kind
        if not is_free and size is not None:
            self.firm.append((i, j, size))
        elif is_unit:
            self.units.append((i, j))
        if size is not None and (not is_free or len(table) == 1):
            self.heights[i] = _larger(self.heights[i], size[0])
            self.widths[j] = _larger(self.widths[j], size[1])

    def table(self) -> Table:
        heights, widths = self.heights, self.widths
        is_blocks = any(extent not in (None, 1) for extent in (*heights, *widths))
        for i, j in self.units:  # a unit tensor in a block whose size nothing else determines
            if heights[i] is None or widths[j] is None:
                size = 3 if is_blocks or not self.firm else 1
                size = max(heights[i] or 0, widths[j] or 0) or size
                heights[i], widths[j] = heights[i] or size, widths[j] or size
                self.cost += _UNIT_NUMBER if size == 1 else 0
        is_triad = len(widths) == 1 and len(heights) > 1 and len(self.firm) == len(heights)
        if is_triad and all(size == VECTOR for _, _, size in self.firm):
            blocks: Table = {(3 * len(heights), 1): self.cost + 6}
            return blocks | ({VECTOR: self.cost + 3} if len(heights) == 3 else {})
        wrong = sum(size != (heights[i], widths[j]) for i, j, size in self.firm)
        total = (_summed(heights), _summed(widths))
        cost = self.cost + MISFIT // 2 * min(wrong, 3) + (6 if is_blocks else 0)
        cost += _OPEN_BLOCKS * sum(extents.count(0) > 1 for extents in (heights, widths))
        return {total: cost} | ({QUATERNION: cost + _COLUMN_AS_QUATERNION} if total == (4, 1) else {})


def _larger(known: int | None, extent: int) -> int:
    return extent if known is None else max(known, extent)


def _summed(extents: Sequence[int | None]) -> int:
    """Returns the sum of extents, with 1 for unknown ones; 0 (an open dimension) if one of them is open."""
    return 0 if 0 in extents else sum(extent or 1 for extent in extents)


def _applied(tree: Operation, parts: Sequence[Table]) -> Table:
    """Returns the costs of f(x): a value of f's own kind, or the product of f and x."""
    value = combined("value", parts)
    if tree.text == "sure":
        return value
    as_product, as_value = BRACKETS[tree.text]
    found = {kind: cost + as_value for kind, cost in value.items()}
    for kind, cost in combined("mul", parts).items():
        found[kind] = min(cost + as_product, found.get(kind, 10**6))
    return cheapest(found)


def _stacked(parts: Sequence[Table]) -> Table:
    """Returns the costs of (a, b, c): a column, a row, or a quaternion of stacked scalars and columns."""
    rows, cost, free, is_open = 0, 0, 0, False
    for part in parts:
        if part == {None: 0}:  # a zero of any size
            free += 1
            continue
        columns = {kind: own for kind, own in part.items() if isinstance(kind, tuple) and kind[1] == 1}
        if not columns:
            return {None: 20 + sum(min(each.values()) for each in parts)}
        kind = min(columns, key=lambda each: columns[each])
        rows, cost, is_open = rows + kind[0], cost + columns[kind], is_open or not kind[0]
    if is_open:
        return {(0, 1): cost + 1, (1, 0): cost + 1}
    rows = 4 if free == 1 and rows in (1, 3) and len(parts) == 2 else rows + free
    found: Table = {(rows, 1): cost + 1, (1, rows): cost + 1}
    return found | ({QUATERNION: cost} if rows == 4 else {})


def sizes_of_set(text: str) -> set[Kind]:
    """Returns the kinds of the members of a set by its name: SO(3), R^3; empty if unknown."""
    name = _SETS.sub("", text)
    if re.match(r"S?O\(?3|so\(?3", name):
        return {TENSOR}
    if re.match(r"SE\(?3|se\(?3", name):
        return {(4, 4)}
    if re.match(r"H(?![a-z])|S\^\(?3", name):
        return {QUATERNION}
    if re.match(r"S\^\(?2", name):
        return {VECTOR}
    if found := re.fullmatch(r"\(?R\)?(?:\^\(?([\dn])(?:\\times([\dnm]))?\)?)?", name):
        rows, columns = (0 if each in ("n", "m") else int(each or 1) for each in found.groups())
        return {(rows, columns), QUATERNION} if (rows, columns) == (4, 1) else {(rows, columns)}
    return set()


def _member(tree: Operation, table: Table) -> Table:
    """Returns the costs of x ∈ SO(3), which is a misfit if x is something else."""
    sizes = sizes_of_set(tree.text)
    wrong = {kind for kind in table if sizes and kind is not None and kind not in sizes}
    return {kind: cost + (MISFIT if kind in wrong else 0) for kind, cost in table.items()}
