"""What a claim supposes, at the instant at which it is judged: inequations and equations.

An equation is supposed at the instant only, not for all times: what is proved under the weaker hypothesis
also holds under the stronger one. Of a quantity that vanishes for all times each derivative that occurs is
assumed to vanish, too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial

from workbench.core.construct import apply, derivative
from workbench.core.construct import relation as equated
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.terms import (
    Apply,
    Conjunction,
    Derivative,
    IllFormed,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    sides_of,
)
from workbench.engines.inventory import reached
from workbench.engines.inventory.inventory import Lookup, NotExact, take_inventory


class Unsatisfiable(ValueError):
    """No values of the symbols satisfy the assumptions."""


class Assumptions:
    """The assumptions of one claim, sorted."""

    def __init__(self, statements: Sequence[Statement]) -> None:
        self.relations = [relation for s in statements for relation in _relations(s)]
        self.nonzero = [r for r in self.relations if r.operator == "≠"]
        self.equations = [r for r in self.relations if r.operator == "="]


def derivatives_of(
    premise: Statement, claim: Statement, definitions: Lookup, along_motion: bool = False
) -> tuple[Relation, ...]:
    """The derivatives of the premise's equations, as far as the claim differentiates what they speak of.

    f = 1 says nothing of ḟ at one instant, and ḟ = 0 if it lasts; so with ∂f/∂q at one place and everywhere.
    along_motion: it holds at the places of one motion, as f = 0 does there, but for what says what f is.
    """
    sides = list(sides_of(claim))
    orders = take_inventory(sides, definitions).orders
    found = []
    for relation in _relations(premise):
        if relation.operator == "≠" or relation.left.type.kind == "operator":
            continue
        own = take_inventory((relation.left, relation.right), definitions).orders
        more = max((orders.get(symbol, 0) - order for symbol, order in own.items()), default=0)
        is_everywhere = not along_motion or _says_what_a_function_is(relation)
        has_functions = any(each.declaration.of for each in own)
        slopes = _slopes(relation, sides, definitions) if has_functions and is_everywhere else []
        found += slopes
        for k in range(1, more + 1):
            found += [_each_side(each, partial(derivative, order=k)) for each in (relation, *slopes)]
    return tuple(found)


def lasting(premises: Sequence[Statement], claim: Statement, definitions: Lookup) -> list[Statement]:
    """The premises, and the derivatives that the claim, and these, take of what they speak of."""
    found: list[Statement] = []
    with suppress(NotExact, IllFormed):
        for _ in premises:
            together = Conjunction((claim, *premises, *found))
            found = [
                each for premise in premises for each in derivatives_of(premise, together, definitions, True)
            ]
    return [*premises, *found]


def _says_what_a_function_is(relation: Relation) -> bool:
    """Whether it is f = t for a function f of coordinates that stand in t, and of nothing else that moves: at
    some values of these alone, it would say that they do not."""
    for own, value in ((relation.left, relation.right), (relation.right, relation.left)):
        if isinstance(own, Symbol) and own.declaration.of:
            parts = list(value.walk())
            moving = {p for p in parts if isinstance(p, Symbol) and not p.declaration.constant}
            if moving and moving <= set(own.declaration.of) and not any(map(_takes_rate, parts)):
                return True
    return False


def _takes_rate(part: Term) -> bool:
    return isinstance(part, Derivative | TimeOperator)


def _slopes(relation: Relation, sides: Sequence[Term], definitions: Lookup) -> list[Relation]:
    """Its partial derivatives by all that these sides are differentiated by, of the orders that occur."""
    parts = [part for side in sides for part in reached(side, definitions)]
    by = {part.arguments[1] for part in parts if isinstance(part, Apply) and part.head in PARTIALS}
    if any(isinstance(part, Apply) and part.head in GRADIENTS for part in parts):
        symbols = (part for part in parts if isinstance(part, Symbol))
        by |= {
            each for part in symbols for each in (part, *part.declaration.of) if each.declaration.coordinate
        }
    by |= {part.body for part in by if isinstance(part, Derivative)}  # ∂ḟ/∂q̇ = ∂f/∂q
    found, relations = [], [relation]
    for _ in range(max((_depth(side, definitions) for side in sides), default=0)):
        relations = [_each_side(r, partial(_slope, x)) for r in relations for x in by]
        found += relations
    return found


def _depth(term: Term, definitions: Lookup) -> int:
    """How many slopes are taken of each other in it."""
    body = definitions.lookup(term) if isinstance(term, Symbol) else None
    inside = term.children if body is None else (body,)
    is_slope = isinstance(term, Apply) and term.head in GRADIENTS | PARTIALS
    return is_slope + max((_depth(part, definitions) for part in inside), default=0)


def _slope(by: Term, side: Term) -> Term:
    return apply("partial", side, by)


def _each_side(relation: Relation, of: Callable[[Term], Term]) -> Relation:
    return equated("=", of(relation.left), of(relation.right))


def _relations(statement: Statement) -> list[Relation]:
    match statement:
        case Relation(operator="=" | "≠"):
            return [statement]
        case Conjunction():
            return [relation for part in statement.parts for relation in _relations(part)]
    raise NotExact("an assumption is an equation or an inequation (= or ≠)")
