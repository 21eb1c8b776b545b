"""The bracket structure of a formula, before any type is known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeGuard, overload

from workbench.core.operations import FUNCTIONS


@dataclass(frozen=True, slots=True)
class Node:
    """A piece of a formula; `at` is its offset in the text."""

    at: int


@dataclass(frozen=True, slots=True)
class Leaf(Node):
    """A letter, a number, a function (its head), or a mark (T, *, ∞). `name`: what a function is called;
    `bare`: whether it stands there without a command, so that it may also be a product of letters."""

    kind: str
    text: str
    name: str = ""
    bare: bool = False


@dataclass(frozen=True, slots=True)
class Group(Node):
    """{…}: grouping that TeX needs and print does not show."""

    parts: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Bracket(Node):
    """(…), […], {…}, ⟨…⟩, |…| or ‖…‖ with its comma-separated parts; `kind` is the opening bracket."""

    kind: str
    parts: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Styled(Node):
    """\\mathbf, \\underline and the like: a part of the name."""

    style: str
    body: Node


@dataclass(frozen=True, slots=True)
class Accented(Node):
    """\\dot … \\ddddot (accent "1" … "4") and \\tilde ("~"): an operation."""

    accent: str
    body: Node


@overload
def core(node: Node) -> Node: ...
@overload
def core(node: Node | None) -> Node | None: ...
def core(node: Node | None) -> Node | None:
    """The node without braces around it."""
    while isinstance(node, Group) and len(node.parts) == 1:
        (node,) = node.parts
    return node


def both_below(inner: Node | None, outer: Node | None) -> Node | None:
    """The subscript of {x_a}_b, as of x_{a,b}."""
    if inner is None or outer is None:
        return outer if inner is None else inner
    parts = (part for sub in (inner, outer) for part in (sub.parts if isinstance(sub, Group) else (sub,)))
    return Group(inner.at, tuple(parts))


def is_left_script(node: Node | None) -> bool:
    """Whether the node is {}_a^b, which the letter behind it carries on its left."""
    return isinstance(node, Scripted) and isinstance(node.nucleus, Group) and not node.nucleus.parts


def unstyled(node: Node) -> tuple[tuple[str, ...], Node]:
    """The fonts and marks of a node, the outermost first, and what is inside them."""
    styles: tuple[str, ...] = ()
    while isinstance(node := core(node), Styled):
        styles, node = (*styles, node.style), node.body
    return styles, node


@dataclass(frozen=True, slots=True)
class Scripted(Node):
    """nucleus with at most one subscript and one superscript, primes, and perhaps a factorial sign."""

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
    """`bare`: it is written without brackets of its own."""

    rows: tuple[tuple[Node, ...], ...]
    bare: bool = field(default=False, compare=False)


@dataclass(frozen=True, slots=True)
class Infix(Node):
    """· × ⊗ or ∘ between two factors."""

    operator: str


@dataclass(frozen=True, slots=True)
class Summation(Node):
    """\\sum with its bounds; it acts on the rest of its product."""

    lower: Node | None
    upper: Node | None


@dataclass(frozen=True, slots=True)
class Extremal(Node):
    """\\min or \\max, with what stands under it; it acts on the rest of its product."""

    least: bool
    over: Node | None


@dataclass(frozen=True, slots=True)
class Product(Node):
    """Two or more factors and infix signs in a row."""

    items: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """Signed addends: (sign, where the sign is, addend); the first may have the sign ""."""

    addends: tuple[tuple[str, int, Node], ...]


@dataclass(frozen=True, slots=True)
class Chain(Node):
    """a = b ≠ c …: sides, and between them (relation, where it is). `universal`: a ∀ stands before it."""

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
    """The conditions behind "for", "where", "with", "if" and the like."""

    conditions: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Lines(Node):
    """One tuple of comma-separated clauses for each line; the last of them may be `Given`."""

    lines: tuple[tuple[Node, ...], ...]


def in_a_row(at: int, items: Sequence[Node]) -> Node:
    """The product of the items; the item, where there is but one."""
    return items[0] if len(items) == 1 else Product(at, tuple(items))


def is_function(node: Node) -> bool:
    """A function's name, perhaps with scripts."""
    leaf = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(leaf, Leaf) and leaf.kind == "FUNCTION"


def is_own_word(node: Node) -> TypeGuard[Leaf]:
    """Whether only a paper can say what the function is."""
    return isinstance(node, Leaf) and node.kind == "FUNCTION" and node.name not in FUNCTIONS


def as_letter(node: Node) -> Node:
    """A word such as Ad, where a paper has a symbol of this name."""
    return Leaf(node.at, "LETTER", f"\\operatorname{{{node.name}}}") if is_own_word(node) else node


def is_numeral(node: Node) -> bool:
    """A number, perhaps with scripts."""
    leaf = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(leaf, Leaf) and leaf.kind == "NUMBER"
