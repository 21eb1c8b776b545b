"""Corrections of transcription errors on the parse tree.

Such errors are lost or confused tildes and dots, lost underlines and fonts, a tilde over a factor instead of
the product, and a lost sign of a product.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Group,
    Infix,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Styled,
    Summation,
    core,
    in_a_row,
    unstyled,
)
from workbench.language.grammar.vocabulary import written
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.trees.tree_nodes import bare, below, children, exchanged

_INFIXES = {sign: written("INFIX", sign) for sign in "·×⊗"}
_MOST_DOTS = 4
FONTS = ("\\boldsymbol", "\\mathbf", "\\mathrm", "\\mathcal", "\\mathbb")


@dataclass(frozen=True)
class Mark:
    """A replacement of one node by another.

    Attributes:
        cost: The number of misprints that it corrects.
        dots: The change of the weight, in dots; None if unknown.
    """

    old: Node
    new: Node
    cost: int
    kind: str
    description: str
    dots: int | None = None


def marked(marks: Sequence[Mark], root: Node) -> Node:
    """Returns the tree with the marks applied, small ones first, because one may lie inside another."""
    new: dict[int, Node] = {}
    for mark in sorted(marks, key=lambda mark: sum(1 for _ in below(mark.old))) if len(marks) > 1 else marks:
        new[id(mark.old)] = exchanged(mark.new, new) if new else mark.new
    return exchanged(root, new) if new else root


def marked_lines(marks: Sequence[Mark], lines: Lines) -> Lines:
    """Returns the lines with the marks of their parts applied."""
    made = marked(marks, lines)
    assert isinstance(made, Lines)
    return made


def letter_marks(node: Node, table: SymbolTable, times: int = 1) -> Iterator[list[Mark]]:
    """Yields, for each letter in the node with its accents, its alternatives.

    times: how often the node counts as a factor.
    """
    core = core_of(node)
    if core is not None:
        yield [*_other_accents(node, core, times), *_other_letters(node, core, table)]
    elif isinstance(node, Scripted):
        yield from letter_marks(node.nucleus, table, times * _power(node))
        if isinstance(node.nucleus, Leaf) and node.nucleus.text == "e" and node.sup is not None:
            yield from letter_marks(node.sup, table)
    else:
        for part in children(node):
            yield from letter_marks(part, table, times)


def _power(node: Scripted) -> int:
    sup = core(node.sup)
    return int(sup.text) if isinstance(sup, Leaf) and sup.text.isdigit() else 1


@dataclass(frozen=True)
class _Core:
    """A letter in its fonts, with its dots and tilde."""

    letter: Node
    dots: int
    tilde: bool


def core_of(node: Node) -> _Core | None:
    """Returns the letter of a node that is one letter under accents; None for other nodes."""
    dots, tilde = 0, False
    while True:
        match node:
            case Accented(accent="~", body=body) if not tilde:
                node, tilde = body, True
            case Accented(accent=accent, body=body) if accent != "~" and not dots:
                node, dots = body, int(accent)
            case Group(parts=(part,)):
                node = part
            case Styled() if letter_of(node) is not None:
                return _Core(node, dots, tilde)
            case Leaf(kind="LETTER"):
                return _Core(node, dots, tilde)
            case _:
                return None


def letter_of(node: Node) -> Leaf | None:
    _, node = unstyled(node)
    return node if isinstance(node, Leaf) and node.kind == "LETTER" else None


def leaf_of(letter: Node) -> Leaf:
    """Returns the leaf inside the fonts of a node that is one letter."""
    leaf = letter_of(letter)
    assert leaf is not None, f"{latex_of(letter)} is no letter"
    return leaf


def _accented(core: _Core) -> Node:
    node = core.letter
    if core.tilde:
        node = Accented(node.at, "~", node)
    if core.dots:
        node = Accented(node.at, str(core.dots), node)
    return node


def _other_accents(node: Node, core: _Core, times: int) -> Iterator[Mark]:
    for tilde in (False, True):
        for dots in range(_MOST_DOTS + 1):
            more = dots - core.dots
            if (tilde, more) == (core.tilde, 0) or abs(more) > 2:
                continue
            new = _accented(_Core(core.letter, dots, tilde))
            said = f"replace ${latex_of(_accented(core))}$ by ${latex_of(new)}$"
            kind = "dots" if core.tilde == tilde else "tilde"
            yield Mark(node, new, _price(core.tilde, tilde, more), kind, said, more * times)


def _price(had: bool, has: bool, more: int) -> int:
    if had == has:
        return abs(more)
    if has:  # a lost tilde, or one that became a dot
        return {0: 1, -1: 1, 1: 2, -2: 2, 2: 3}[more]
    return 1 + abs(more)


def _other_letters(node: Node, core: _Core, table: SymbolTable) -> Iterator[Mark]:
    """Yields the same letter in another font or case, underlined or not, if the paper has such a symbol."""
    letter = leaf_of(core.letter)
    printed = latex_of(core.letter)
    known = {name.base for name in table.symbols}
    for text in (letter.text, other_case(letter.text)):
        plain = Leaf(letter.at, "LETTER", text)
        for other in (plain, *(Styled(letter.at, font, plain) for font in FONTS)):
            for new in (other, Styled(letter.at, "\\underline", other)):
                if latex_of(new) != printed and latex_of(new) in known:
                    accented = _accented(_Core(new, core.dots, core.tilde))
                    said = f"replace ${printed}$ by ${latex_of(new)}$"
                    yield Mark(node, accented, 1, "mark", said)


def other_case(letter: str) -> str:
    r"""Returns \Phi for \phi, a for A."""
    if letter.startswith("\\"):
        return "\\" + letter[1].swapcase() + letter[2:]
    return letter.swapcase()


def product_marks(node: Node) -> Iterator[Mark]:
    """Yields inserted and changed signs between factors, and moved or widened tildes."""
    for part in below(node):
        if isinstance(part, Product):
            yield from _signs(part)
            yield from _nested(part)
            yield from _tildes(part)
            yield from _sums_uncovered(part)
        elif isinstance(part, Accented) and part.accent == "~" and core_of(part) is None:
            yield from _wide_tilde(part)


def _wide_tilde(over: Accented) -> Iterator[Mark]:
    """Yields the removal of a tilde over several letters, or its move to one of the factors."""
    body = bare(over.body)
    shown = f"$\\widetilde{{{latex_of(body)}}}$"
    yield Mark(over, body, 1, "tilde", f"remove the tilde of {shown}", 0)
    if not isinstance(body, Product):
        return
    for index, item in enumerate(body.items):
        if not isinstance(item, Infix):
            under = Accented(item.at, "~", item)
            moved = Product(body.at, (*body.items[:index], under, *body.items[index + 1 :]))
            said = f"put the tilde of {shown} over ${latex_of(item)}$ alone"
            yield Mark(over, Group(over.at, (moved,)), 1, "tilde", said, 0)


def _sums_uncovered(product: Product) -> Iterator[Mark]:
    """Yields the removal of a tilde over a summation sign, so that the sum extends over all that follows."""
    for index, item in enumerate(product.items):
        match item:
            case Accented(accent="~", body=Group(parts=(Product(items=(Summation(), *_) as inner),))):
                new = Product(product.at, (*product.items[:index], *inner, *product.items[index + 1 :]))
                said = f"remove the tilde of ${latex_of(item)}$"
                yield Mark(product, new, 1, "tilde", said, 0)


def _signs(product: Product) -> Iterator[Mark]:
    items = product.items
    for index, (left, right) in enumerate(pairwise(items)):
        if isinstance(left, Infix) or isinstance(right, Infix) or _is_number(left):
            continue
        for operator, sign in _INFIXES.items():
            new = Product(product.at, (*items[: index + 1], Infix(right.at, operator), *items[index + 1 :]))
            said = f"insert ${sign}$ between ${latex_of(left)}$ and ${latex_of(right)}$"
            yield Mark(product, new, 1, "product", said, 0)
    for index, item in enumerate(items):
        for operator, sign in _INFIXES.items():
            if isinstance(item, Infix) and item.operator != operator and 0 < index < len(items) - 1:
                new = Product(product.at, (*items[:index], Infix(item.at, operator), *items[index + 1 :]))
                said = f"replace ${latex_of(item)}$ before ${latex_of(items[index + 1])}$ by ${sign}$"
                yield Mark(product, new, 1, "product", said, 0)


def _nested(product: Product) -> Iterator[Mark]:
    """Yields a b c as a × (b × c)."""
    items = product.items
    for start in range(len(items) - 2):
        run = items[start : start + 3]
        if any(isinstance(item, Infix) or _is_number(item) for item in run):
            continue
        a, b, c = run
        inner = Bracket(b.at, "(", (Product(b.at, (b, Infix(c.at, "×"), c)),))
        twice = (a, Infix(b.at, "×"), inner)
        said = f"replace ${latex_of(Product(a.at, run))}$ by ${latex_of(Product(a.at, twice))}$"
        new = Product(product.at, (*items[:start], *twice, *items[start + 3 :]))
        yield Mark(product, new, 2, "product", said, 0)


def _is_number(node: Node) -> bool:
    return isinstance(node, Leaf) and node.kind == "NUMBER"


def _tildes(product: Product) -> Iterator[Mark]:
    items = product.items
    for start in range(len(items)):
        for end in range(start + 2, len(items) + 1):
            run = items[start:end]
            if isinstance(run[0], Infix) or isinstance(run[-1], Infix):
                continue
            ways = [(run, "put a tilde over")]
            if (first := _without_tilde(run[0])) is not None:
                ways.append(((first, *run[1:]), "put the tilde over the whole of"))
            for inner, words in ways:
                body = Group(run[0].at, (Product(run[0].at, inner),))
                over = Accented(run[0].at, "~", body)
                rest = (*items[:start], over, *items[end:])
                new = in_a_row(product.at, rest)
                said = f"{words} ${latex_of(Product(run[0].at, inner))}$"
                yield Mark(product, new, 1, "tilde", said, 0)


def _without_tilde(node: Node) -> Node | None:
    match node:
        case Accented(accent="~", body=body):
            return body
        case Scripted(nucleus=Accented(accent="~", body=body)):
            return Scripted(node.at, body, node.sub, node.sup, node.primes, node.factorial)
    return None


def all_marks(node: Node, table: SymbolTable) -> list[Mark]:
    return [mark for marks in letter_marks(node, table) for mark in marks] + list(product_marks(node))
