"""Sums over integers: Σ with its bounds, and the variables that they bind in its body."""

from __future__ import annotations

from collections.abc import Callable

from workbench.language import construct
from workbench.language.errors import Fault
from workbench.language.integers import Linear
from workbench.language.scope import Scope
from workbench.language.spelling import variable_name
from workbench.language.syntax import Chain, Group, Leaf, Node, Sum, Summation, core
from workbench.language.terms import Term


def summation(scope: Scope, node: Summation, body: Callable[[], Term]) -> Term:
    """Σ_{k=a}^{b} or Σ_{k₁+k₂=k} of the body, which is read with the variables in scope."""
    lower = node.lower.parts[0] if isinstance(node.lower, Group) and node.lower.parts else node.lower
    if not isinstance(lower, Chain) or [sign for sign, _ in lower.relations] != ["="]:
        what = "a sum without bounds is not read; " if node.upper is None else ""
        raise Fault(f"{what}expected the bounds of the sum, as in \\sum_{{k=0}}^{{n}}", node.at)
    left, right = lower.sides
    single = variable_name(left)
    if single is not None:
        if node.upper is None:
            raise Fault("the sum has no upper bound", node.at)
        names, start, end = [single], scope.integer(right), _upper_bound(scope, node.upper)
    else:
        names, start = _parts_of(left), None
        if node.upper is not None:
            raise Fault("a sum over k_1 + k_2 + … = k has no upper bound", node.upper.at)
        end = scope.integer(right)
    with scope.bound(names, node.at):
        term = body()
    return scope.build(node.at, construct.big_sum, names, start, end, term)


def _upper_bound(scope: Scope, node: Node) -> Linear:
    inner = core(node)
    if isinstance(inner, Leaf) and inner.text == "∞":
        raise Fault("an infinite sum; sums have integer bounds", node.at)
    return scope.integer(node)


def _parts_of(node: Node) -> list[str]:
    names = [variable_name(addend) for _, _, addend in node.addends] if isinstance(node, Sum) else [None]
    if None in names or any(sign == "-" for sign, _, _ in node.addends):
        raise Fault("expected summation variables, as in k_1 + k_2 = k", node.at)
    return names
