"""Formulas as trees, and how they are written: as printed in a text and with every macro expanded."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

#: Binding strength of what is written: a sum, a product with a sign between, a product without, an atom.
SUM, SIGNED, PRODUCT, ATOM = 1, 2, 3, 5

UNARY = {
    "transpose": "{}^T",
    "inverse": "{}^{{-1}}",
    "skew": r"\tilde{{{}}}",
    "norm2": r"\|{}\|^2",
    "trace": r"\operatorname{{tr}}({})",
    "det": r"\det({})",
    "ddt": r"\frac{{d}}{{dt}}({})",
}


@dataclass(frozen=True)
class Node:
    """One operation on smaller trees, or a leaf. kind: scalar, vector, matrix, angle. order: derivatives of
    a leaf. number: of a number or a power. size: what a zero or a unit matrix is printed with. frames: the
    letters of a frame derivative or an angular velocity."""

    op: str
    args: tuple[Node, ...] = ()
    kind: str = "scalar"
    name: str = ""
    order: int = 0
    number: int = 0
    size: tuple[int, int] | None = None
    frames: str = ""

    def __add__(self, other: Node) -> Node:
        return _sum(self, other)

    def __sub__(self, other: Node) -> Node:
        return _sum(self, -other)

    def __neg__(self) -> Node:
        if self.op == "sum":
            return replace(self, args=tuple(-each for each in self.args))
        return self.args[0] if self.op == "minus" else Node("minus", (self,), self.kind)

    def __mul__(self, other: Node) -> Node:
        return Node("product", (self, other), _kind_of_product(self, other))

    def __rmul__(self, factor: int) -> Node:
        return number(factor) * self if factor >= 0 else -(number(-factor) * self)

    def __pow__(self, exponent: int) -> Node:
        return Node("power", (self,), self.kind, number=exponent)

    def nodes(self, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Node]]:
        """All subtrees, each with the indices that lead to it."""
        yield path, self
        for place, each in enumerate(self.args):
            yield from each.nodes((*path, place))

    def with_node(self, path: tuple[int, ...], node: Node) -> Node:
        """The same tree with another node at a place."""
        if not path:
            return node
        args = list(self.args)
        args[path[0]] = args[path[0]].with_node(path[1:], node)
        return replace(self, args=tuple(args))


def _sum(left: Node, right: Node) -> Node:
    args = (*(left.args if left.op == "sum" else (left,)), *(right.args if right.op == "sum" else (right,)))
    return Node("sum", args, left.kind)


def _kind_of_product(left: Node, right: Node) -> str:
    if right.op == "transpose" and right.args[0].kind == "vector":
        return "matrix"
    return left.kind if right.kind in ("scalar", "angle") else right.kind


def leaf(name: str, kind: str, order: int = 0) -> Node:
    return Node("leaf", kind=kind, name=name, order=order)


def number(value: int) -> Node:
    return Node("number", number=value)


def zero(kind: str, size: tuple[int, int] | None = None) -> Node:
    return Node("zero", kind=kind, size=size)


def unit(size: tuple[int, int] | None = None) -> Node:
    return Node("unit", kind="matrix", size=size)


def apply(op: str, *args: Node) -> Node:
    kinds = {"dot": "scalar", "cross": "vector", "norm2": "scalar", "trace": "scalar", "det": "scalar"}
    kinds |= {"cos": "scalar", "sin": "scalar", "skew": "matrix", "over": args[0].kind}
    return Node(op, args, kinds.get(op, args[0].kind))


def rate_in(frame: str, vector: Node) -> Node:
    return Node("frame rate", (vector,), "vector", frames=frame)


def turning(of: str, within: str) -> Node:
    return Node("angular velocity", kind="vector", frames=within + of)


@dataclass(frozen=True)
class Spelling:
    """LaTeX as it stands in the text, and with all macros expanded."""

    source: str
    plain: str

    def __add__(self, other: Spelling | str) -> Spelling:
        if isinstance(other, str):
            return Spelling(self.source + other, self.plain + other)
        return Spelling(self.source + other.source, self.plain + other.plain)

    def within(self, pattern: str) -> Spelling:
        return Spelling(pattern.format(self.source), pattern.format(self.plain))


def spelled(latex: str) -> Spelling:
    return Spelling(latex, latex)


#: What may write a node in a way of its own (by a macro), or leave it: None.
Custom = Callable[[Node, "Writer"], Spelling | None]


@dataclass
class Writer:
    """Writes trees; `custom` may write single nodes by macros."""

    custom: Custom = lambda node, writer: None

    def terms(self, node: Node) -> list[tuple[str, Spelling]]:
        """Sign and rest of each term of a sum."""
        parts = node.args if node.op == "sum" else (node,)
        return [self._term(each) for each in parts]

    def _term(self, node: Node) -> tuple[str, Spelling]:
        if node.op == "minus":
            return "-", self._at(node.args[0], SIGNED)
        return "+", self._at(node, SIGNED)

    def write(self, node: Node) -> Spelling:
        (sign, first), *rest = self.terms(node)
        found = spelled("- ") + first if sign == "-" else first
        for sign, each in rest:
            found = found + f" {sign} " + each
        return found

    def _at(self, node: Node, strength: int) -> Spelling:
        """In brackets where it binds less than its place asks."""
        by_macro = self.custom(node, self)
        if by_macro is not None:
            return by_macro.within("({})") if node.op == "transpose" and strength >= ATOM else by_macro
        text, own = self._bare(node)
        return text if own >= strength else text.within("({})")

    def within(self, node: Node, strength: int) -> Spelling:
        """In a place that asks for a strength."""
        return self._at(node, strength)

    def _bare(self, node: Node) -> tuple[Spelling, int]:
        if node.op in ("sum", "minus"):
            return self.write(node), SUM
        if node.op == "product":
            left, right = node.args
            if left.op == "number" and right.op in ("dot", "cross"):  # 2 a \cdot b
                text = self._bare(right)[0]
                if not text.plain[0].isdigit():
                    return spelled(f"{left.number} ") + text, SIGNED
            right_at = ATOM if right.op in ("number", "product") else PRODUCT
            return self._at(left, PRODUCT) + " " + self._at(right, right_at), PRODUCT
        if node.op in ("dot", "cross"):
            sign = r" \cdot " if node.op == "dot" else r" \times "
            left, right = (self._at(each, PRODUCT) for each in node.args)
            return left + sign + right, SIGNED
        if node.op == "over":
            above, below = map(self.write, node.args)
            return spelled(r"\frac{") + above + "}{" + below + "}", ATOM
        if node.op in ("cos", "sin"):
            return self._turn(node), PRODUCT
        if node.op in UNARY:
            return self._unary(node), PRODUCT if node.op in ("transpose", "inverse") else ATOM
        if node.op == "power":
            if node.args[0].op in ("cos", "sin"):
                return self._turn(node.args[0], f"^{node.number}"), PRODUCT
            return self._at(node.args[0], ATOM) + f"^{node.number}", PRODUCT
        return self._leaf(node), ATOM

    def _turn(self, node: Node, power: str = "") -> Spelling:
        argument = self.write(node.args[0])
        return spelled(f"\\{node.op}{power}") + argument.within(
            " {}" if node.args[0].op == "leaf" else "({})"
        )

    def _unary(self, node: Node) -> Spelling:
        (arg,) = node.args
        tight = node.op in ("transpose", "inverse")
        return (self._at(arg, ATOM) if tight else self.write(arg)).within(UNARY[node.op])

    def _leaf(self, node: Node) -> Spelling:
        if node.op == "number":
            return spelled(str(node.number))
        if node.op == "frame rate":
            text, begin = self.write(node.args[0]), r"\frac{{}^" + node.frames + " d"
            is_leaf = not node.args[0].args
            return (
                spelled(begin + " ") + text + "}{dt}" if is_leaf else spelled(begin + "}{dt}(") + text + ")"
            )
        if node.op == "angular velocity":
            return spelled(rf"{{}}^{node.frames[0]}\omega^{node.frames[1]}")
        if node.op in ("zero", "unit"):
            letter = "0" if node.op == "zero" else r"\mathbf{I}"
            return spelled(
                letter if node.size is None else rf"{letter}_{{{node.size[0]} \times {node.size[1]}}}"
            )
        dots = "" if not node.order else "\\" + "d" * node.order + "ot"
        return spelled(dots + "{") + self.letter(node.name) + "}" if dots else self.letter(node.name)

    def letter(self, name: str) -> Spelling:
        found = self.custom(leaf(name, "letter"), self)
        return found if found is not None else spelled(name)
