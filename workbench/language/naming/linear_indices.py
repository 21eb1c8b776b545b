"""Linear integer expressions in scripts, such as n + 1 and 2 k - 1."""

from __future__ import annotations

from collections.abc import Collection

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.integer_expressions import Linear
from workbench.language.grammar.syntax import (
    Bracket,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Sum,
    core,
)

#: Limit on indices, orders and exponents.
LARGEST_INTEGER = 1000


def variable_name(node: Node) -> str | None:
    """Returns k or k_1 as the name of an integer variable; None for other nodes."""
    match node:
        case Leaf(kind="LETTER", text=text) if len(text) == 1:
            return text
        case Scripted(nucleus=Leaf(kind="LETTER", text=text), sub=sub, sup=None, primes=0, factorial=False):
            sub = core(sub)
            if len(text) == 1 and isinstance(sub, Leaf) and sub.kind == "NUMBER" and sub.text.isdigit():
                return f"{text}_{sub.text}" if len(sub.text) == 1 else f"{text}_{{{sub.text}}}"
    return None


def linear(node: Node, variables: Collection[str]) -> Linear | None:
    """Returns the node as an integer expression in the variables; None for other nodes. Raises Fault if a
    number is too large."""
    match node:
        case Leaf(kind="NUMBER", text=text) if text.isdigit() and (text == "0" or text[0] != "0"):
            if len(text) > 9 or int(text) > LARGEST_INTEGER:
                raise Fault(
                    SyntaxCode.INTEGER_TOO_LARGE_HERE(text=text[:20], LARGEST_INTEGER=LARGEST_INTEGER),
                    node.at,
                )
            return Linear(int(text))
        case Group(parts=(part,)) | Bracket(kind="(", parts=(part,)):
            return linear(part, variables)
        case Sum():
            total = Linear(0)
            for sign, _, addend in node.addends:
                value = linear(addend, variables)
                if value is None:
                    return None
                total = total - value if sign == "-" else total + value
            return total
        case Product(items=(Leaf(kind="NUMBER") as factor, other)):
            size, value = linear(factor, ()), linear(other, variables)
            if size is None or size == Linear(1) or value is None or value.is_number:
                return None  # 1j are two indices
            return value * int(size)
    name = variable_name(node)
    return Linear.variable(name) if name is not None and name in variables else None


def linear_or_none(node: Node, variables: Collection[str]) -> Linear | None:
    """Like `linear`, but returns None if an integer is too large."""
    try:
        return linear(node, variables)
    except Fault:
        return None
