"""Occurrences of unknown letters in a formula, and the known letters that they may stand for."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from workbench.core.formula_errors import Fault
from workbench.core.names import Name
from workbench.language.elaboration.meanings import Meaning, meaning
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Chain,
    Fraction,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    unstyled,
)
from workbench.language.naming.linear_indices import linear
from workbench.language.naming.spelling import Scripts
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.trees.lost_marks import FONTS, Mark, leaf_of, letter_of, other_case
from workbench.repair.trees.tree_nodes import bare, children

#: Letters that are easily confused in print and in optical character recognition.
_ALIKE = (
    ("\\rho", "p", "P"),
    ("\\omega", "w"),
    ("\\nu", "v"),
    ("\\alpha", "a"),
    ("\\phi", "\\Phi", "\\varphi"),
    ("\\varepsilon", "\\epsilon", "e"),
    ("\\eta", "n"),
    ("\\kappa", "k"),
    ("\\chi", "x", "X"),
    ("\\tau", "t"),
    ("\\mu", "u"),
)
_OF_TIME = frozenset(("d", "t"))


@dataclass(frozen=True)
class Occurrence:
    """An occurrence of a letter.

    Attributes:
        node: The letter in its fonts.
        styles: The styles outside of `node`.
        holder: The node with its scripts.
        left: The node with its left scripts.
    """

    node: Node
    styles: tuple[str, ...]
    scripts: Scripts
    holder: Scripted | None = None
    left: Scripted | None = None
    bracket: Bracket | None = None

    @property
    def text(self) -> str:
        return leaf_of(self.node).text

    @property
    def letter(self) -> Name:
        return Name.styled((*self.styles, *unstyled(self.node)[0]), self.text)

    @property
    def base(self) -> str:
        return self.letter.base


def occurrences(node: Node) -> Iterator[Occurrence]:
    """Yields the letters of a formula that name something, except those inside indices."""
    match node:
        case Product(items=items):
            left = None
            for index, item in enumerate(items):
                if isinstance(item, Scripted) and item.nucleus == Group(item.nucleus.at, ()):
                    left = item
                    continue
                after = items[index + 1] if index + 1 < len(items) else None
                bracket = after if isinstance(after, Bracket) and after.kind == "(" else None
                for found in occurrences(item):
                    found = replace(found, bracket=bracket if found.bracket is None else found.bracket)
                    yield found if left is None or found.left is not None else _with_left(found, left)
                left = None
        case Fraction(numerator=above, denominator=below):
            within = (found for part in (above, below) for found in occurrences(part))
            yield from (f for f in within if not (is_rate(node) and f.text in _OF_TIME))
        case _:
            yield from _letters_in(node, (), Scripts(), None)


def _with_left(found: Occurrence, left: Scripted) -> Occurrence:
    scripts = replace(found.scripts, left_sub=left.sub, left_sup=left.sup)
    return replace(found, scripts=scripts, left=left)


def _letters_in(
    node: Node, styles: tuple[str, ...], scripts: Scripts, holder: Scripted | None
) -> Iterator[Occurrence]:
    node = bare(node)
    if letter_of(node) is not None:
        yield Occurrence(node, styles, scripts, holder)
        return
    match node:
        case Styled(body=body):
            yield from _letters_in(body, (*styles, node.style), scripts, holder)
        case Accented(body=body):
            yield from _letters_in(body, styles, scripts, holder)
        case Scripted(nucleus=nucleus, sub=sub, sup=sup):
            within = Scripts(None, None, sub or scripts.sub, sup or scripts.sup, node.primes)
            yield from _letters_in(nucleus, styles, within, node if holder is None else holder)
            letter = letter_of(nucleus)
            if letter is not None and letter.text == "e" and sup is not None:
                yield from occurrences(sup)
        case Product() | Fraction():
            yield from occurrences(node)
        case _:
            for child in children(node):
                yield from occurrences(child)


def is_rate(fraction: Fraction) -> bool:
    """True for d/dt and d^k x/dt^k."""
    items = []
    for part in (fraction.numerator, fraction.denominator):
        part = bare(part)
        items.append(part.items[0] if isinstance(part, Product) else part)
    heads = [item.nucleus if isinstance(item, Scripted) else item for item in items]
    return all(isinstance(head, Leaf) and head.text == "d" for head in heads)


def meaning_of(
    found: Occurrence, table: SymbolTable, integers: Collection[str], node: Node | None = None
) -> Meaning | None:
    """Returns the meaning of the letter in the paper, or of `node` in its position."""
    node = node or found.node
    styles = (*found.styles, *unstyled(node)[0])
    return meaning(table, integers, leaf_of(node), styles, found.scripts, found.bracket is not None)


def other_letters(
    found: Sequence[Occurrence], table: SymbolTable, integers: Collection[str]
) -> Iterator[tuple[list[Mark], int]]:
    """Yields the known letters that an unknown letter may be: the marks, and the size of the change.

    The size is 1 for the font, the underline or the case, and 2 for another letter.
    """
    first = found[0]
    letter = leaf_of(first.node)
    names = [letter.text, other_case(letter.text)]
    names += [other for group in _ALIKE if letter.text in group for other in group if other not in names]
    seen: set[tuple[Name | str, ...]] = set()
    for text in names:
        plain = Leaf(letter.at, "LETTER", text)
        for font in (plain, *(Styled(letter.at, font, plain) for font in FONTS)):
            for new in (font, Styled(letter.at, "\\underline", font)):
                if latex_of(new) == latex_of(first.node):
                    continue
                meant = [meaning_of(one, table, integers, new) for one in found]
                known_as = tuple(one.name for one in meant if one is not None)
                if None not in meant and known_as not in seen:
                    seen.add(known_as)
                    said = f"replace ${latex_of(first.node)}$ by ${latex_of(new)}$ throughout"
                    if len(found) == 1:
                        said = said.removesuffix(" throughout")
                    marks = [Mark(one.node, new, 1, "mark", said) for one in found]
                    yield marks, 1 if text in names[:2] else 2


def has_readable_sup(found: Occurrence, table: SymbolTable, integers: Collection[str]) -> bool:
    """True if the superscript of the letter is a power, an order, a mark, or a part of its name."""
    sup = found.scripts.sup
    if sup is None or found.base == "e":
        return True
    inner = bare(sup)
    if isinstance(inner, Bracket) or (isinstance(inner, Leaf) and inner.text in ("T", "*")):
        return True
    try:
        if linear(inner, integers) is not None:
            return True
    except Fault:
        return True
    signed = latex_of(inner).lstrip("{").startswith("-")
    named = meaning_of(found, table, integers)
    return signed or isinstance(inner, Chain) or (named is not None and named.sup is None)
