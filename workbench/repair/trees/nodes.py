"""Untyped formulas as trees: subtrees by identity, one put for another, and back to LaTeX.

An ill-typed formula has no term, so its edits are made on what the parser saw.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, replace
from functools import cache, partial
from typing import Any

from workbench.language.operators import command_of
from workbench.language.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Extremal,
    Fraction,
    Given,
    Group,
    Infix,
    Joined,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
    core,
)
from workbench.language.vocabulary import CLOSING, written


def below(node: Node) -> Iterator[Node]:
    """The node and all that is in it, outer ones first."""
    yield node
    for child in children(node):
        yield from below(child)


def children(node: Node) -> Iterator[Node]:
    for name in _fields(type(node)):
        yield from _nodes_in(getattr(node, name))


@cache
def _fields(kind: type[Node]) -> tuple[str, ...]:
    """Where a node of this kind may hold others."""
    return tuple(field.name for field in fields(kind) if field.type not in ("int", "str", "bool"))


def _nodes_in(value: Any) -> Iterator[Node]:
    if isinstance(value, Node):
        yield value
    elif isinstance(value, tuple):
        for part in value:
            yield from _nodes_in(part)


def exchanged(node: Node, new: Mapping[int, Node]) -> Node:
    """The tree with the nodes of these ids exchanged; what holds none of them stays the same object."""
    if id(node) in new:
        return new[id(node)]
    changed = {}
    for name in _fields(type(node)):
        value = getattr(node, name)
        other = _exchanged_in(value, new)
        if other is not value:
            changed[name] = other
    return replace(node, **changed) if changed else node


def _exchanged_in(value: Any, new: Mapping[int, Node]) -> Any:
    if isinstance(value, Node):
        return exchanged(value, new)
    if isinstance(value, tuple):
        parts = tuple(_exchanged_in(part, new) for part in value)
        return value if all(a is b for a, b in zip(parts, value, strict=True)) else parts
    return value


def hole(root: Node, inner: Node) -> Callable[[Node], Node]:
    """What puts another node where `inner` stands in the tree."""
    filled = _hole(root, inner)
    if filled is None:
        raise ValueError("expected a node of the tree")
    return filled


def _hole(value: Any, inner: Node) -> Callable[[Node], Any] | None:
    if value is inner:
        return lambda new: new
    if isinstance(value, Node):
        for name in _fields(type(value)):
            if (filled := _hole(getattr(value, name), inner)) is not None:
                return partial(_with_field, value, name, filled)
    if isinstance(value, tuple):
        for place, part in enumerate(value):
            if (filled := _hole(part, inner)) is not None:
                return partial(_with_part, value, place, filled)
    return None


def _with_field(node: Node, name: str, filled: Callable[[Node], Any], new: Node) -> Node:
    return replace(node, **{name: filled(new)})


def _with_part(parts: tuple, place: int, filled: Callable[[Node], Any], new: Node) -> tuple:
    return (*parts[:place], filled(new), *parts[place + 1 :])


def latex_of(node: Node) -> str:
    """The tree as LaTeX, spelled as it was."""
    match node:
        case Leaf(kind="FUNCTION", text=head):
            return command_of(head)
        case Leaf(kind="MARK", text=text):
            return text if text == "T" else written("MARK", text)
        case Leaf(text=text):
            return text
        case Group(parts=(Styled() | Leaf() | Group() as inner,)):
            return latex_of(inner)
        case Group(parts=parts):
            return _braced(", ".join(map(latex_of, parts)))
        case Bracket(kind="[", parts=(Matrix() as matrix,)):
            return latex_of(matrix)
        case Bracket(kind=kind, parts=parts):
            inside = ", ".join(map(latex_of, parts))
            if any(isinstance(part, Fraction | Matrix | Summation) for part in below(node)):
                return f"\\left{kind} {inside} \\right{CLOSING[kind]}"
            return f"{kind} {inside} {CLOSING[kind]}" if kind[1:] else f"{kind}{inside}{CLOSING[kind]}"
        case Styled(style=style, body=body):
            return f"{style}{_argument(body)}"
        case Accented(accent="~", body=body):
            letter = core(body)
            accent = "\\widetilde" if isinstance(letter, Product | Sum | Bracket) else "\\tilde"
            return accent + _argument(body)
        case Accented(accent=accent, body=body):
            return written("ACCENT", accent) + _argument(body)
        case Scripted():
            return _scripted(node)
        case Fraction(numerator=top, denominator=bottom):
            return f"\\frac{_argument(top)}{_argument(bottom)}"
        case Binomial(top=top, bottom=bottom):
            return f"\\binom{_argument(top)}{_argument(bottom)}"
        case Infix(operator=operator):
            return written("INFIX", operator)
        case Product(items=items):
            return " ".join(map(latex_of, items))
        case Sum(addends=addends):
            signed = (f" {sign} {latex_of(a)}" if sign else latex_of(a) for sign, _, a in addends)
            return "".join(signed).strip()
        case Summation(lower=lower, upper=upper):
            bounds = "".join(f"{s}{_argument(b)}" for s, b in (("_", lower), ("^", upper)) if b is not None)
            return f"\\sum{bounds}"
        case Extremal(least=least, over=over):
            return f"\\{'min' if least else 'max'}" + ("" if over is None else f"_{_argument(over)}")
        case Matrix(rows=rows):
            inside = " \\\\ ".join(" & ".join(map(latex_of, row)) for row in rows)
            return f"\\begin{{bmatrix}} {inside} \\end{{bmatrix}}"
        case Chain():
            return _chain(node)
        case Conditional(statements=statements, signs=signs):
            text = latex_of(statements[0])
            for (sign, _), statement in zip(signs, statements[1:], strict=True):
                joint = "\\text{ if }" if sign == "⇐" else written("IMPLICATION", sign)
                text += f" {joint} {latex_of(statement)}"
            return text
        case Joined(statements=statements):
            return " \\text{ and } ".join(map(latex_of, statements))
        case Given(conditions=conditions):
            return "\\text{ for } " + ", \\quad ".join(map(latex_of, conditions))
        case Lines(lines=lines):
            rows = [
                ", \\quad ".join(map(latex_of, line)).replace(", \\quad \\text{ for } ", " \\text{ for } ")
                for line in lines
            ]
            inside = " \\\\ ".join(rows)
            return rows[0] if len(rows) == 1 else f"\\begin{{aligned}} {inside} \\end{{aligned}}"
    raise TypeError(f"no LaTeX for {type(node).__name__}")


def _braced(text: str) -> str:
    return f"{{{text}}}"


def _argument(node: Node) -> str:
    node = core(node)
    return _braced(", ".join(map(latex_of, node.parts)) if isinstance(node, Group) else latex_of(node))


def _scripted(node: Scripted) -> str:
    text = latex_of(node.nucleus)
    if node.sub is not None:
        text += f"_{_argument(node.sub)}"
    text += "'" * node.primes
    if node.sup is not None:
        text += f"^{_argument(node.sup)}"
    return text + "!" * node.factorial


def _chain(node: Chain) -> str:
    text = "\\forall " * node.universal + latex_of(node.sides[0])
    for (sign, _), side in zip(node.relations, node.sides[1:], strict=True):
        text += f" {written('RELATION', sign)} {latex_of(side)}"
    return text
