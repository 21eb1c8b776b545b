"""Misplaced and lost factors: short exponents, surplus signs, a lost factor, a lost index of a name."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Fraction,
    Group,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    Summation,
    in_a_row,
    is_left_script,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.trees.letter_candidates import occurrences
from workbench.repair.trees.lost_marks import Mark, core_of
from workbench.repair.trees.tree_nodes import below

_UNIT = Styled(0, "\\mathbf", Leaf(0, "LETTER", "I"))

#: A letter that may be missing, and its weight if that is a number.
Letter = tuple[Node, int | None]


def factor_marks(node: Node, letters: Sequence[Letter]) -> Iterator[Mark]:
    """Yields longer exponents, removed signs and, at a higher cost, inserted factors.

    letters: the letters that the formula contains.
    """
    for part in below(node):
        if isinstance(part, Product):
            yield from _longer_exponents(part)
            yield from _surplus_signs(part)
    yield _missing_unit(node)
    if not isinstance(node, Bracket | Fraction):
        yield from _missing_factors(node, letters)


def _longer_exponents(product: Product) -> Iterator[Mark]:
    items = product.items
    for index, item in enumerate(items[:-1]):
        match item:
            case Scripted(nucleus=Leaf(text="e"), sub=None, sup=Node() as sup):
                following = items[index + 1 :]
                inner = sup.parts if isinstance(sup, Group) else (sup,)
                row = inner[0].items if isinstance(inner[0], Product) else inner
                for taken in range(1, len(following) + 1):
                    if isinstance(following[taken - 1], Infix) or is_left_script(following[taken - 1]):
                        continue
                    power = Group(sup.at, (Product(sup.at, (*row, *following[:taken])),))
                    longer = Scripted(item.at, item.nucleus, None, power)
                    rest = (*items[:index], longer, *following[taken:])
                    new = in_a_row(product.at, rest)
                    shown = latex_of(Product(item.at, following[:taken]))
                    said = f"move ${shown}$ into the exponent of ${latex_of(item)}$"
                    yield Mark(product, new, 1, "exponent", said)


def _surplus_signs(product: Product) -> Iterator[Mark]:
    items = product.items
    for index, item in enumerate(items):
        if isinstance(item, Infix) and 0 < index < len(items) - 1:
            new = Product(product.at, (*items[:index], *items[index + 1 :]))
            said = f"remove ${latex_of(item)}$ before ${latex_of(items[index + 1])}$"
            yield Mark(product, new, 1, "product", said, 0)


def _missing_factors(node: Node, letters: Sequence[Letter]) -> Iterator[Mark]:
    items = node.items if isinstance(node, Product) else (node,)
    for index in range(len(items), -1, -1):
        before = items[index - 1] if index else None
        after = items[index] if index < len(items) else None
        if is_left_script(before) or isinstance(before, Summation) or isinstance(after, Summation):
            continue
        if index == 0 and isinstance(after, Leaf) and after.kind == "NUMBER":
            continue
        for letter, weight in letters:
            new = Product(node.at, (*items[:index], letter, *items[index:]))
            where = f"after ${latex_of(before)}$" if before is not None else f"before ${latex_of(items[0])}$"
            said = f"insert the factor ${latex_of(letter)}$ {where}"
            yield Mark(node, new, 2, "factor", said, weight)


def _missing_unit(node: Node) -> Mark:
    """Returns the insertion of the unit tensor after a number, as in T* T = det T."""
    items = node.items if isinstance(node, Product) else (node,)
    if any(isinstance(item, Infix) or _is_function(item) for item in items):
        items = (Bracket(node.at, "(", (node,)),)
    new = Product(node.at, (*items, _UNIT))
    return Mark(node, new, 1, "factor", f"insert the factor $\\mathbf{{I}}$ after ${latex_of(node)}$", 0)


def _is_function(node: Node) -> bool:
    return isinstance(node, Leaf) and node.kind == "FUNCTION"


def letters_of(node: Node) -> list[Node]:
    """Returns the letters of the formula with their marks and indices, each once."""
    found: dict[str, Node] = {}
    names = {id(one.node) for one in occurrences(node)}
    for part in below(node):
        nucleus = part.nucleus if isinstance(part, Scripted) else part
        core = core_of(nucleus) if isinstance(part, Scripted | Accented) or id(part) in names else None
        if core is None or id(core.letter) not in names:
            continue
        for bare in (core.letter, Accented(part.at, "~", core.letter)):
            letter = bare
            if isinstance(part, Scripted) and part.sub is not None:
                letter = Scripted(part.at, bare, part.sub)
            found.setdefault(latex_of(letter), letter)
    return list(found.values())


def index_marks(node: Node, table: SymbolTable) -> Iterator[list[Mark]]:
    """Yields, for each letter without index, the names of the paper that have an index as part of the
    name."""
    scripted = {id(part.nucleus) for part in below(node) if isinstance(part, Scripted)}
    for one in occurrences(node):
        if one.scripts.sub is not None or one.left is not None or id(one.node) in scripted:
            continue
        marks = []
        for name in table.symbols:
            is_more = name == replace(one.letter, sub=name.sub, sup=name.sup) and name.sub
            if one.styles or name.indices or not is_more:
                continue
            new = parse(str(name)).lines[0][0]
            said = f"replace ${latex_of(one.node)}$ by ${name}$"
            marks.append(Mark(one.node, new, 1, "symbol", said))
        if marks:
            yield marks
