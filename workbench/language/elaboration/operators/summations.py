"""Sums over integers: Σ with its bounds, and the variables that they bind in its body."""

from __future__ import annotations

from collections.abc import Callable

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, Unranged
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers
from workbench.core.terms import Term
from workbench.language.grammar.syntax import Chain, Group, Leaf, Node, Scripted, Sum, Summation, core
from workbench.language.naming.linear_indices import variable_name
from workbench.language.naming.scope import Scope

#: Letters for the number of all members, if a text does not name it.
_COUNTS = "NMLKnmlk"


def summation(scope: Scope, node: Summation, body: Callable[[], Term]) -> Term:
    """Returns Σ_{k=a}^{b}, Σ_{k₁+k₂=k}, Σ_k or Σ_k^b of the body, which is read with the variables in
    scope."""
    lower = node.lower.parts[0] if isinstance(node.lower, Group) and node.lower.parts else node.lower
    no_bounds = "a sum without bounds is not read; " if node.upper is None else ""
    expected = f"{no_bounds}expected the bounds of the sum, as in \\sum_{{k=0}}^{{n}}"
    over_all = variable_name(lower) if lower is not None else None
    if over_all:
        last = node.upper and _upper_bound(scope, node.upper)
        start: Linear | None = Linear(1)
        names, end = [over_all], last or _last_of_all(scope, expected, node.at)
    elif not isinstance(lower, Chain) or [sign for sign, _ in lower.relations] != ["="]:
        raise Fault(expected, node.at)
    else:
        names, start, end = _bounds(scope, node, *lower.sides)
    with scope.bound(names, node.at):
        term = body()
    if over_all and node.upper is None and over_all not in free_integers(term):
        raise Fault(expected, node.at)
    return scope.build(node.at, construct.big_sum, names, start, end, term)


def _bounds(
    scope: Scope, node: Summation, left: Node, right: Node
) -> tuple[list[str], Linear | None, Linear]:
    single = variable_name(left)
    if single is None:
        names = _parts_of(left)
        if node.upper is not None:
            raise Fault(SyntaxCode.SUM_OVER_K_K(), node.upper.at)
        return names, None, scope.integer(right)
    if node.upper is None:
        raise Fault(SyntaxCode.SUM_HAS_NO_UPPER(), node.at)
    return [single], scope.integer(right), _upper_bound(scope, node.upper)


def _last_of_all(scope: Scope, expected: str, at: int) -> Linear:
    """Returns the number of members of the families of a formula, the upper bound of Σ_i from 1."""
    name = next(letter for letter in _COUNTS if letter not in scope.table)
    if name not in scope.variables:
        raise Unranged(name, expected, at)
    return Linear.variable(name)


def _upper_bound(scope: Scope, node: Node) -> Linear:
    inner = core(node)
    if isinstance(inner, Leaf) and inner.text == "∞":
        raise Fault(SyntaxCode.INFINITE_SUM_SUMS_HAVE(), node.at)
    name = variable_name(inner) or _labelled(inner)
    if name is not None and not scope.knows(name):
        raise Unranged(name, f"the last of the sum, {name}, has no range here", node.at)
    return Linear.variable(name) if name in scope.variables else scope.integer(node)


def _labelled(node: Node) -> str | None:
    """Returns the name of N_P, a number that counts something; else None."""
    match node:
        case Scripted(nucleus=Leaf(kind="LETTER", text=text), sub=sub, sup=None, primes=0, factorial=False):
            label = core(sub)
            if (
                text in _COUNTS
                and isinstance(label, Leaf)
                and label.kind == "LETTER"
                and label.text.isupper()
            ):
                return f"{text}_{label.text}"
    return None


def _parts_of(node: Node) -> list[str]:
    addends = node.addends if isinstance(node, Sum) else ()
    letters = [variable_name(addend) for _, _, addend in addends]
    names = [name for name in letters if name is not None]
    if not addends or len(names) < len(addends) or any(sign == "-" for sign, _, _ in addends):
        raise Fault(SyntaxCode.EXPECTED_SUMMATION_VARIABLES_K(), node.at)
    return names
