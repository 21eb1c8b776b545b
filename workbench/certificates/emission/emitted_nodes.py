"""Values of Coq statements in two forms: the readable text, and the deep copy for computation."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

KINDS = {"scalar": "Scalar", "vector": "Vector", "tensor": "Tensor"}

#: Names of kinds that the library does not have, in obstacles.
_BEYOND = {
    "quaternion": "quaternions",
    "covector": "covectors",
    "matrix": "a matrix that is not 3×3",
    "operator": "an operator among values",
}

#: Levels of Coq's grammar: a smaller number binds more tightly.
ATOM, APPLICATION, NEGATION, PRODUCT, SUM = 0, 10, 35, 40, 50


class NotCertified(Exception):
    """No theorem can be written for a claim; the message is the first obstacle."""


class OneInstant(NotCertified):
    """The premises hold at one instant only."""


def named(kind: str) -> str:
    return _BEYOND.get(kind, kind)


@dataclass(frozen=True)
class Node:
    """A scalar, vector or tensor, real or dual: its text with its precedence level, and its deep copy."""

    dual: bool
    kind: str
    text: str
    level: int
    deep: str
    number: Fraction | None = None

    def at(self, level: int) -> str:
        return self.text if self.level <= level else f"({self.text})"

    @property
    def type(self) -> str:
        return type_name(self.dual, self.kind)


def type_name(dual: bool, kind: str) -> str:
    return f"{'dual_' if dual else ''}{kind.lower()} K"


def flag(dual: bool) -> str:
    return "true" if dual else "false"


def rational(value: Fraction) -> str:
    return (
        str(value.numerator)
        if value.denominator == 1 and value >= 0
        else f"({value.numerator} # {value.denominator})"
    )


def number(value: Fraction | int, dual: bool = False) -> Node:
    value = Fraction(value)
    deep = f"(Num {flag(dual)} ({value.numerator} # {value.denominator}))"
    return Node(dual, "Scalar", f"number {rational(value)}", APPLICATION, deep, value)


def zero(dual: bool, kind: str) -> Node:
    return Node(dual, kind, f"(zero : {type_name(dual, kind)})", ATOM, f"(Zer {flag(dual)} {kind})")


def identity(dual: bool) -> Node:
    return Node(dual, "Tensor", f"(ident : {type_name(dual, 'Tensor')})", ATOM, f"(Idt {flag(dual)})")


def embedded(node: Node, dual: bool = True) -> Node:
    """Returns the node as a dual quantity."""
    if node.dual == dual:
        return node
    if node.number is not None:
        return number(node.number, True)
    if node == zero(node.dual, node.kind):
        return zero(True, node.kind)
    if node == identity(node.dual):
        return identity(True)
    return Node(True, node.kind, f"embed {node.at(ATOM)}", APPLICATION, f"(Emb {node.deep})")


def together(nodes: tuple[Node, ...]) -> tuple[Node, ...]:
    dual = any(node.dual for node in nodes)
    return tuple(embedded(node, dual) for node in nodes)


def call(name: str, deep: str, kind: str, *arguments: Node) -> Node:
    """Returns the application `name a b …`; its deep copy is (deep a b …)."""
    arguments = together(arguments)
    text = " ".join([name, *(a.at(ATOM) for a in arguments)])
    return Node(
        arguments[0].dual, kind, text, APPLICATION, f"({' '.join([deep, *(a.deep for a in arguments)])})"
    )


def infix(sign: str, deep: str, kind: str, left: Node, right: Node, level: int = PRODUCT) -> Node:
    left, right = together((left, right))
    text = f"{left.at(level)} {sign} {right.at(level - 1)}"
    return Node(left.dual, kind, text, level, f"({deep} {left.deep} {right.deep})")


def plus(left: Node, right: Node) -> Node:
    return infix("+", "Plus", left.kind, left, right, SUM)


def minus(left: Node, right: Node) -> Node:
    return infix("-", "Minus", left.kind, left, right, SUM)


def neg(node: Node) -> Node:
    return Node(node.dual, node.kind, f"- {node.at(NEGATION)}", NEGATION, f"(Neg {node.deep})")


def times(left: Node, right: Node) -> Node:
    """Returns the product that the kinds allow, with a scalar on the left."""
    if right.kind == "Scalar" and left.kind != "Scalar":
        left, right = right, left
    match left.kind, right.kind:
        case "Scalar", _:
            return infix("•", "Scale", right.kind, left, right)
        case "Tensor", "Vector":
            return infix("@", "Act", "Vector", left, right)
        case "Tensor", "Tensor":
            return infix("∘", "Prod", "Tensor", left, right)
    raise NotCertified(f"a product of {left.kind} and {right.kind}")


def column(*entries: Node) -> Node:
    """Returns the vector of three scalars."""
    entries = together(entries)
    dual, text = entries[0].dual, " ".join(entry.at(ATOM) for entry in entries)
    deep = f"(Triad {' '.join(entry.deep for entry in entries)})"
    return Node(dual, "Vector", f"(V {text} : {type_name(dual, 'Vector')})", ATOM, deep)


def dot(left: Node, right: Node) -> Node:
    return infix("·", "Dot", "Scalar", left, right)


def derivative(node: Node, order: int = 1) -> Node:
    if order == 0:
        return node
    deep = node.deep
    for _ in range(order):
        deep = f"(DD {deep})"
    text = f"D {node.at(ATOM)}" if order == 1 else f"der {order} {node.at(ATOM)}"
    return Node(node.dual, node.kind, text, APPLICATION, deep)


def raised(node: Node, exponent: int) -> Node:
    """Returns a power. That of a vector is a power of its squared length, so the exponent must be even."""
    if node.kind == "Vector":
        if exponent % 2:
            raise NotCertified("an odd power of a vector")
        square = Node(
            node.dual, "Scalar", f"square {node.at(ATOM)}", APPLICATION, f"(Dot {node.deep} {node.deep})"
        )
        return square if exponent == 2 else raised(square, exponent // 2)
    name, deep = ("tpower", "Prod") if node.kind == "Tensor" else ("spower", "Scale")
    if exponent == 0:
        copy = f"(Idt {flag(node.dual)})" if node.kind == "Tensor" else number(1, node.dual).deep
    else:
        copy = node.deep
        for _ in range(exponent - 1):
            copy = f"({deep} {node.deep} {copy})"
    return Node(node.dual, node.kind, f"{name} {node.at(ATOM)} {exponent}", APPLICATION, copy)


def half(name: str, deep: str, node: Node) -> Node:
    """Returns the real or the dual part."""
    node = embedded(node)
    text = f"({name} {node.at(ATOM)} : {type_name(False, node.kind)})"
    return Node(False, node.kind, text, ATOM, f"({deep} {node.deep})")


DUAL_UNIT = Node(True, "Scalar", "(eps : dual_scalar K)", ATOM, "Eps")


def single(premise: str, proof: str) -> str:
    """Returns the proof of one premise, as a list of one."""
    return f"(single (e := here) (p := {premise}) {proof})"
