"""Alternatives of possibly misprinted integers: indices, orders in brackets, bounds of sums, C_n^k."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import cache
from itertools import product

from workbench.core.integer_expressions import Linear
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Bracket,
    Chain,
    Group,
    Leaf,
    Node,
    Scripted,
    Sum,
    Summation,
    core,
)
from workbench.language.naming.linear_indices import linear_or_none, variable_name
from workbench.repair.trees.lost_marks import Mark
from workbench.repair.trees.tree_nodes import bare, below

_OTHER_BRACKET = {"(": "[", "[": "("}
_CONSTANTS = range(-2, 3)


def integer_marks(node: Node, variables: Collection[str]) -> Iterator[list[Mark]]:
    """Yields the alternatives of each integer in the node.

    These are one more or less, an order in the other kind of brackets and, at a higher cost, any sum and
    difference of the variables that occur.
    """
    known = frozenset(variables) | bound_variables(node)
    for holder in below(node):
        match holder:
            case Scripted(nucleus=Leaf(kind="FUNCTION")):
                continue
            case Scripted(sub=sub, sup=sup):
                scripts = [s for s in (sub, sup) if s is not None]
                is_counting = len(scripts) == 2 and all(linear_or_none(s, known) is not None for s in scripts)
                for script in scripts:
                    yield from _of_script(holder, script, known, script is sub or is_counting)
            case Summation(lower=lower, upper=upper):
                bounds = [upper] if upper is not None else []
                chain = lower.parts[0] if isinstance(lower, Group) and lower.parts else lower
                if isinstance(chain, Chain):
                    bounds.append(chain.sides[-1])
                for bound in bounds:
                    value = linear_or_none(bound, known)
                    if value is not None:
                        yield [_mark(holder, bound, value + step) for step in (1, -1)]


def bound_variables(node: Node) -> frozenset[str]:
    """Returns the summation variables in the node."""
    names: set[str] = set()
    for part in below(node):
        if isinstance(part, Summation) and part.lower is not None:
            for chain in below(part.lower):
                if isinstance(chain, Chain):
                    left = chain.sides[0]
                    addends = [a for _, _, a in left.addends] if isinstance(left, Sum) else [left]
                    names.update(name for a in addends if (name := variable_name(a)) is not None)
    return frozenset(names)


def _of_script(
    holder: Scripted, script: Node, known: frozenset[str], may_be_plain: bool
) -> Iterator[list[Mark]]:
    inner = core(script)
    if isinstance(inner, Bracket) and inner.kind in _OTHER_BRACKET and len(inner.parts) == 1:
        value = linear_or_none(inner.parts[0], known)
        if value is not None:
            other = Bracket(inner.at, _OTHER_BRACKET[inner.kind], inner.parts)
            yield [*_other_values(holder, inner.parts[0], value, known), _exchange(holder, inner, other, 1)]
    elif may_be_plain:
        value = linear_or_none(script, known)
        if value is not None:
            yield list(_other_values(holder, script, value, known))


def _other_values(holder: Node, old: Node, value: Linear, known: frozenset[str]) -> Iterator[Mark]:
    near = [value + step for step in (1, -1)]
    near = [other for other in near if not other.is_number or int(other) >= 0]
    for other in near:
        yield _mark(holder, old, other)
    if not value.is_number:
        for other in _forms(tuple(sorted(known))):
            if other not in (value, *near):
                yield _mark(holder, old, other, cost=2)


@cache
def _forms(variables: Sequence[str]) -> tuple[Linear, ...]:
    """Returns sums and differences of up to three variables and a small number, simple ones first."""
    forms = []
    for signs in product((1, -1, 0), repeat=len(variables)):
        if 1 in signs and len(variables) - signs.count(0) <= 3:
            start = sum((Linear.variable(v) * s for v, s in zip(variables, signs, strict=True)), Linear(0))
            forms += [start + constant for constant in _CONSTANTS]
    return tuple(sorted(forms, key=lambda form: (len(form.coefficients), abs(form.constant))))


def _mark(holder: Node, old: Node, value: Linear, cost: int = 1) -> Mark:
    parsed = parse(_shown(value)).lines[0][0]
    is_bare = isinstance(parsed, Leaf)
    return _exchange(holder, old, parsed if is_bare else Group(old.at, (parsed,)), cost)


def _shown(value: Linear) -> str:
    """Returns the expression with positive terms first: n - k - 1 instead of -k + n - 1."""
    added = [(name, c) for name, c in value.coefficients if c > 0]
    taken = [(name, c) for name, c in value.coefficients if c < 0]
    return (
        str(Linear(0, tuple(added))) + str(Linear(value.constant, tuple(taken)))
        if added and taken
        else str(value)
    )


def _exchange(holder: Node, old: Node, new: Node, cost: int) -> Mark:
    said = f"replace ${latex_of(bare(old))}$ in ${latex_of(holder)}$ by ${latex_of(bare(new))}$"
    return Mark(old, new, cost, "index", said)
