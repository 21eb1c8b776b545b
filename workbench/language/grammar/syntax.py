"""Syntax nodes: the bracket structure of a formula, before types are known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeGuard, overload

from workbench.core.operations import FUNCTIONS


@dataclass(frozen=True, slots=True)
class Node:
    """A node of a formula; `at` is its offset in the text."""

    at: int


@dataclass(frozen=True, slots=True)
class Leaf(Node):
    """A letter, a number, a function (its head), or a mark (T, *, ∞).

    name: the name of a function.   bare: True if it has no command, so that it may also be a product of
    letters.
    """

    kind: str
    text: str
    name: str = ""
    bare: bool = False


@dataclass(frozen=True, slots=True)
class Group(Node):
    """{…}: grouping that TeX needs and that does not print."""

    parts: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Bracket(Node):
    """(…), […], {…}, ⟨…⟩, |…| or ‖…‖ with its comma-separated parts; `kind` is the opening bracket."""

    kind: str
    parts: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Styled(Node):
    """\\mathbf, \\underline and the like, which are part of the name."""

    style: str
    body: Node


@dataclass(frozen=True, slots=True)
class Accented(Node):
    """\\dot … \\ddddot (accent "1" … "4") and \\tilde ("~"), which are operations."""

    accent: str
    body: Node


@overload
def core(node: Node) -> Node: ...
@overload
def core(node: Node | None) -> Node | None: ...
def core(node: Node | None) -> Node | None:
    """Returns the node without braces around it."""
    while isinstance(node, Group) and len(node.parts) == 1:
        (node,) = node.parts
    return node


def both_below(inner: Node | None, outer: Node | None) -> Node | None:
    """Returns the subscript of {x_a}_b, which is that of x_{a,b}."""
    if inner is None or outer is None:
        return outer if inner is None else inner
    parts = (part for sub in (inner, outer) for part in (sub.parts if isinstance(sub, Group) else (sub,)))
    return Group(inner.at, tuple(parts))


def is_left_script(node: Node | None) -> bool:
    """True if the node is {}_a^b, the left scripts of the letter after it."""
    return isinstance(node, Scripted) and isinstance(node.nucleus, Group) and not node.nucleus.parts


def unstyled(node: Node) -> tuple[tuple[str, ...], Node]:
    """Returns the fonts and marks of a node, the outermost first, and the node inside them."""
    styles: tuple[str, ...] = ()
    while isinstance(node := core(node), Styled):
        styles, node = (*styles, node.style), node.body
    return styles, node


@dataclass(frozen=True, slots=True)
class Scripted(Node):
    """A nucleus with at most one subscript and one superscript, primes, and perhaps a factorial sign."""

    nucleus: Node
    sub: Node | None = None
    sup: Node | None = None
    primes: int = 0
    factorial: bool = False


@dataclass(frozen=True, slots=True)
class Fraction(Node):
    numerator: Node
    denominator: Node


@dataclass(frozen=True, slots=True)
class Binomial(Node):
    top: Node
    bottom: Node


@dataclass(frozen=True, slots=True)
class Matrix(Node):
    """A matrix. `bare`: it has no brackets."""

    rows: tuple[tuple[Node, ...], ...]
    bare: bool = field(default=False, compare=False)


@dataclass(frozen=True, slots=True)
class Infix(Node):
    """An infix sign between two factors: ·, ×, ⊗ or ∘."""

    operator: str


@dataclass(frozen=True, slots=True)
class Summation(Node):
    """\\sum with its bounds; it applies to the rest of its product."""

    lower: Node | None
    upper: Node | None


@dataclass(frozen=True, slots=True)
class Integration(Summation):
    """\\int with its bounds, which applies up to its differential, or \\lim with its place."""

    sign: str


@dataclass(frozen=True, slots=True)
class Extremal(Node):
    """\\min or \\max with the node under it; it applies to the rest of its product."""

    least: bool
    over: Node | None


@dataclass(frozen=True, slots=True)
class Product(Node):
    """Two or more factors and infix signs in a row."""

    items: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """Signed addends: (sign, offset of the sign, addend); the first may have the sign ""."""

    addends: tuple[tuple[str, int, Node], ...]


@dataclass(frozen=True, slots=True)
class Chain(Node):
    """A chain a = b ≠ c …: sides, and between them (relation, offset). `universal`: a ∀ precedes it."""

    sides: tuple[Node, ...]
    relations: tuple[tuple[str, int], ...]
    universal: bool = False


@dataclass(frozen=True, slots=True)
class Conditional(Node):
    """Statements joined by ⇔ or ⇒."""

    statements: tuple[Node, ...]
    signs: tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class Joined(Node):
    """Statements joined by "and"."""

    statements: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Given(Node):
    """The conditions after "for", "where", "with", "if" and the like."""

    conditions: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Lines(Node):
    """One tuple of comma-separated clauses for each line; the last of them may be `Given`."""

    lines: tuple[tuple[Node, ...], ...]


def in_a_row(at: int, items: Sequence[Node]) -> Node:
    """Returns the product of the items, or the item if there is only one."""
    return items[0] if len(items) == 1 else Product(at, tuple(items))


def is_function(node: Node) -> bool:
    """True for the name of a function, perhaps with scripts."""
    leaf = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(leaf, Leaf) and leaf.kind == "FUNCTION"


def is_own_word(node: Node) -> TypeGuard[Leaf]:
    """True for a function that only a paper can define."""
    return isinstance(node, Leaf) and node.kind == "FUNCTION" and node.name not in FUNCTIONS


def as_letter(node: Node) -> Node:
    """Returns a word such as Ad as a letter, for papers with a symbol of this name; other nodes unchanged."""
    return Leaf(node.at, "LETTER", f"\\operatorname{{{node.name}}}") if is_own_word(node) else node


def is_numeral(node: Node) -> bool:
    """True for a number, perhaps with scripts."""
    leaf = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(leaf, Leaf) and leaf.kind == "NUMBER"
