"""Expansion of equations into addends: linear operations and derivatives move into sums to n."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Set

from workbench.core.construct import apply, big_sum, derivative, relation, with_children, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.operations import COMPONENTWISE, PRODUCTS
from workbench.core.terms import Apply, BigSum, Derivative, Relation, Term, Zero


def has_sums(term: Term) -> bool:
    return any(isinstance(part, BigSum) for part in term.walk())


def addend_by_addend(equation: Relation) -> list[Relation] | None:
    """Returns equations of single addends that imply the equation for every n, or None if a sum is not an
    addend.

    Sums over one range are combined, and so are the addends outside sums.
    """
    parts: dict[tuple[Linear, Linear] | None, Term] = {}
    variables: dict[tuple[Linear, Linear], str] = {}
    for negative, addend in addends(spread(apply("add", equation.left, apply("neg", equation.right)))):
        bounds = None
        if isinstance(addend, BigSum):
            if addend.lower is None:
                return None
            bounds, (own,) = (addend.lower, addend.upper), addend.variables
            addend = instantiate(addend.body, {own: Linear.variable(variables.setdefault(bounds, own))})
        elif has_sums(addend):
            return None
        addend = apply("neg", addend) if negative else addend
        parts[bounds] = apply("add", parts[bounds], addend) if bounds in parts else addend
    found: list[Relation] = []
    for total in parts.values():
        said = relation("=", total, zero(total.type))
        inner = addend_by_addend(said) if has_sums(total) else [said]
        if inner is None:
            return None
        found += inner
    return found


def addends(term: Term, negative: bool = False) -> Iterator[tuple[bool, Term]]:
    if isinstance(term, Apply) and term.head == "add":
        for argument in term.arguments:
            yield from addends(argument, negative)
    elif isinstance(term, Apply) and term.head == "neg":
        yield from addends(term.arguments[0], not negative)
    else:
        yield negative, term


def spread(term: Term) -> Term:
    """Returns the term with its sums outermost: linear operations move to the addends of the sums."""
    if not has_sums(term):
        return term
    term = with_children(term, spread)
    if isinstance(term, BigSum):
        return term
    if isinstance(term, Derivative):
        return _over(term.body, lambda part: _derived(part, term.order), frozenset(term.order.variables))
    if isinstance(term, Apply) and len(term.arguments) == 1 and term.head in COMPONENTWISE - {"neg"}:
        return _over(term.arguments[0], lambda part: apply(term.head, part))
    if isinstance(term, Apply) and term.head in PRODUCTS:
        left, right = term.arguments
        if has_sums(left) and not has_sums(right):
            return _over(left, lambda part: apply(term.head, part, right), free_integers(right))
        if has_sums(right) and not has_sums(left):
            return _over(right, lambda part: apply(term.head, left, part), free_integers(left))
    return term


def _over(term: Term, linear: Callable[[Term], Term], speaks_of: Set[str] = frozenset()) -> Term:
    """Returns linear(term) applied to each addend and within sums, unless a sum binds a variable of
    `speaks_of`."""
    total: Term | None = None
    for negative, addend in addends(term):
        if isinstance(addend, BigSum) and speaks_of.isdisjoint(addend.variables):
            body = addend.body
            body = _over(body, linear, speaks_of) if has_sums(body) else linear(body)
            new: Term = big_sum(addend.variables, addend.lower, addend.upper, body)
        else:
            new = linear(addend)
        new = apply("neg", new) if negative else new
        total = new if total is None else apply("add", total, new)
    assert total is not None
    return total


def _derived(term: Term, order: Linear) -> Term:
    if isinstance(term, Zero):
        return term
    if isinstance(term, Derivative):
        return derivative(term.body, term.order + order)
    return derivative(term, order)
