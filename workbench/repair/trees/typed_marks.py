"""Corrections of an ill-typed formula: a transpose, a row or column of a matrix, a relation or sum sign that
stands for a product."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise, permutations

from workbench.language.elaboration.superscripts import is_transpose
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Chain,
    Infix,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    core,
    in_a_row,
    is_left_script,
)
from workbench.repair.trees.lost_marks import Mark
from workbench.repair.trees.tree_nodes import below

#: The cost of removing something printed; losses are more frequent.
_SURPLUS = 9

_ZERO, _ONE = Leaf(0, "NUMBER", "0"), Leaf(0, "NUMBER", "1")


def type_marks(lines: Lines) -> Iterator[Mark]:
    """Yields single changes, likely misprints first."""
    parts = list(below(lines))
    for part in parts:
        if isinstance(part, Product):
            yield from _moved_transposes(part)
            yield from _exchanged_factors(part)
    for part in parts:
        if isinstance(part, Sum):
            yield from _products_for_sums(part)
        if isinstance(part, Chain):
            yield from stray_relations(part)
    for part in parts:
        yield from _transposes(part)
    letters = list({latex_of(part): part for part in parts if _is_symbol(part)}.values())
    for part in parts:
        if isinstance(part, Sum | Chain):
            yield from _missing_factors(part, letters)
    for part in parts:
        if isinstance(part, Matrix):
            yield from _rows_and_columns(part)


def _is_symbol(node: Node) -> bool:
    """True for a letter with accents, subscripts and a dot."""
    nucleus = core(node.nucleus if isinstance(node, Scripted) and node.sup is None else node)
    while isinstance(nucleus, Accented | Styled):
        nucleus = core(nucleus.body)
    return isinstance(nucleus, Leaf) and nucleus.kind == "LETTER" and nucleus.text != "T"


def _is_factor(node: Node) -> bool:
    return not isinstance(node, Infix) and not (
        isinstance(node, Leaf) and node.kind in ("NUMBER", "FUNCTION")
    )


def _with_transpose(node: Node) -> Node | None:
    """Returns the node with a T added or removed; None if it has another superscript."""
    if isinstance(node, Scripted):
        if is_transpose(node.sup):
            bare = replace(node, sup=None)
            return bare if bare.sub is not None or bare.primes else bare.nucleus
        return replace(node, sup=_transpose(node)) if node.sup is None and not node.factorial else None
    return Scripted(node.at, node, None, _transpose(node)) if _is_factor(node) else None


def _transpose(node: Node) -> Node:
    return Leaf(node.at, "LETTER", "T")


def _has_transpose(node: Node) -> bool:
    return isinstance(node, Scripted) and is_transpose(node.sup)


def _moved_transposes(product: Product) -> Iterator[Mark]:
    """Yields x^T y as x y^T."""
    items = product.items
    for one, other in permutations(range(len(items)), 2):
        if not _has_transpose(items[one]) or _has_transpose(items[other]):
            continue
        first, second = _with_transpose(items[one]), _with_transpose(items[other])
        if first is None or second is None or abs(one - other) > 2:
            continue
        changed = list(items)
        changed[one], changed[other] = first, second
        said = f"move the transpose of ${latex_of(items[one])}$ to ${latex_of(items[other])}$"
        yield Mark(product, Product(product.at, tuple(changed)), 1, "transpose", said)


def _exchanged_factors(product: Product) -> Iterator[Mark]:
    """Yields x A as A x, also with a sign between the factors."""
    items = product.items
    at = [index for index, item in enumerate(items) if not isinstance(item, Infix)]
    for one, other in pairwise(at):
        first, second = items[one], items[other]
        if not (_is_factor(first) and _is_factor(second)) or any(map(is_left_script, (first, second))):
            continue
        changed = list(items)
        changed[one], changed[other] = second, first
        said = f"${latex_of(first)}$ and ${latex_of(second)}$ change places"
        yield Mark(product, Product(product.at, tuple(changed)), 1, "swap", said)


def _transposes(part: Node) -> Iterator[Mark]:
    items = part.items if isinstance(part, Product) else ()
    for index, item in enumerate(items):
        new = _with_transpose(item) if _is_factor(item) else None
        if new is not None:
            verb = "remove" if _has_transpose(item) else "insert"
            nucleus = item.nucleus if _has_transpose(item) and isinstance(item, Scripted) else item
            said = f"{verb} the transpose of ${latex_of(nucleus)}$"
            row = Product(part.at, (*items[:index], new, *items[index + 1 :]))
            yield Mark(part, row, 1, "transpose", said)


def _products_for_sums(part: Sum) -> Iterator[Mark]:
    """Yields x^T + x as x^T x."""
    for index in range(len(part.addends) - 1):
        (sign, at, left), (between, _, right) = part.addends[index : index + 2]
        if between != "+":
            continue
        row = Product(at, (*_factors(left), *_factors(right)))
        addends = (*part.addends[:index], (sign, at, row), *part.addends[index + 2 :])
        new: Node = Sum(part.at, addends) if len(addends) > 1 or sign else row
        said = f"remove $+$ between ${latex_of(left)}$ and ${latex_of(right)}$"
        yield Mark(part, new, 1, "product", said)


def _factors(node: Node) -> tuple[Node, ...]:
    inner = core(node)
    return inner.items if isinstance(inner, Product) else (node,)


def stray_relations(chain: Chain) -> Iterator[Mark]:
    """Yields a = b = c as a = b c."""
    for index in range(1, len(chain.relations)):
        sides, relations = chain.sides, chain.relations
        left, right = sides[index], sides[index + 1]
        row = Product(left.at, (*_factors(_bracketed(left)), *_factors(_bracketed(right))))
        new = Chain(
            chain.at,
            (*sides[:index], row, *sides[index + 2 :]),
            (*relations[:index], *relations[index + 1 :]),
        )
        said = f"remove $=$ before ${latex_of(right)}$"
        yield Mark(chain, new, 1, "relation", said)


def _bracketed(side: Node) -> Node:
    return Bracket(side.at, "(", (side,)) if isinstance(core(side), Sum) else side


def _missing_factors(part: Sum | Chain, letters: list[Node]) -> Iterator[Mark]:
    """Yields insertions of a letter of the formula after or before an addend."""
    addends = [each for _, _, each in part.addends] if isinstance(part, Sum) else list(part.sides)
    for addend in addends:
        if isinstance(core(addend), Sum):
            continue
        for letter in letters:
            for row in ((*_factors(addend), letter), (letter, *_factors(addend))):
                said = f"insert the factor ${latex_of(letter)}$ of ${latex_of(addend)}$"
                yield Mark(addend, in_a_row(addend.at, row), 1, "factor", said)


def lost_words(lines: Lines) -> Iterator[Mark]:
    """Yields a sine or cosine before each letter or bracket of a product."""
    for part in below(lines):
        items = part.items if isinstance(part, Product) else ()
        for place, item in enumerate(items):
            if not isinstance(item, Bracket) and not _is_symbol(item):
                continue
            for word in ("sin", "cos"):
                made = (*items[:place], Leaf(item.at, "FUNCTION", word, word), *items[place:])
                yield Mark(
                    part, Product(part.at, made), 1, "operation", f"insert {word} before ${latex_of(item)}$"
                )


def _rows_and_columns(matrix: Matrix) -> Iterator[Mark]:
    rows, width = matrix.rows, len(matrix.rows[0])
    shown = f"${latex_of(matrix)}$"

    def made(new: Sequence[tuple[Node, ...]], cost: int, said: str) -> Mark:
        return Mark(matrix, replace(matrix, rows=tuple(new)), cost, "row", f"{said} of {shown}")

    for at in range(len(rows), -1, -1):
        if width == 1:
            yield made((*rows[:at], (_ONE,), *rows[at:]), 1, f"insert an entry 1 before row {at + 1}")
        yield made(
            (*rows[:at], (_ZERO,) * width, *rows[at:]), 1, f"insert a row of zeros before row {at + 1}"
        )
    for at in range(width + 1):
        wide = [(*row[:at], _ZERO, *row[at:]) for row in rows]
        yield made(wide, 1, f"insert a column of zeros before column {at + 1}")
    for at in range(len(rows)) if len(rows) > 1 else ():
        yield made((*rows[:at], *rows[at + 1 :]), _SURPLUS, f"remove row {at + 1}")
    for at in range(width) if width > 1 else ():
        narrow = [(*row[:at], *row[at + 1 :]) for row in rows]
        yield made(narrow, _SURPLUS, f"remove column {at + 1}")
