"""Hypotheses of a claim at the instant at which it is judged: disequations and equations.

An equation is assumed at the instant only, not at all times: a proof under the weaker hypothesis is also one
under the stronger hypothesis. If a quantity vanishes at all times, each of its derivatives that occurs is
assumed to vanish, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
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
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.engines.inventory.inventory import take_inventory


class Unsatisfiable(ValueError):
    """No values of the symbols satisfy the assumptions."""


class Assumptions:
    """The hypotheses of one claim, sorted by kind. Bounds, a ≥ b, only restrict counterexamples."""

    def __init__(self, statements: Sequence[Statement]) -> None:
        self.relations = [relation for s in statements for relation in relations_of(s)]
        self.bounds = [each for s in statements for each in _parts(s) if each.operator == "≥"]
        self.nonzero = [r for r in self.relations if r.operator == "≠"]
        self.equations = [r for r in self.relations if r.operator == "="]


def _derivatives_of(premise: Statement, claim: Statement, definitions: Lookup) -> tuple[Relation, ...]:
    """Returns the derivatives of the premise's equations, up to the orders that the claim needs.

    f = 1 at one instant does not constrain ḟ; if it lasts, ḟ = 0. The premise holds at the positions of one
    motion, as f = 0 does there, so that only a definition of a function gives ∂f/∂q.
    """
    sides = list(sides_of(claim))
    has_rates = any(takes_rate(part) for part in reached(definitions, *sides))
    orders = take_inventory(sides, definitions).orders if has_rates else {}  # they count slopes, too
    found = []
    for relation in relations_of(premise):
        if relation.operator == "≠" or relation.left.type.kind == "operator":
            continue
        own = take_inventory((relation.left, relation.right), definitions).orders
        more = max((orders.get(symbol, 0) - order for symbol, order in own.items()), default=0)
        has_functions = any(each.declaration.of for each in own) and _says_what_a_function_is(relation)
        slopes = slopes_of(relation, sides, definitions) if has_functions else []
        found += slopes
        for k in range(1, more + 1):
            found += [each_side(each, partial(derivative, order=k)) for each in (relation, *slopes)]
    return tuple(found)


def lasting(premises: Sequence[Statement], claim: Statement, definitions: Lookup) -> list[Statement]:
    """Returns the premises and those of their derivatives that the claim and the premises need."""
    found: list[Statement] = []
    with suppress(NotExact, IllFormed):
        for _ in premises:
            together = Conjunction((claim, *premises, *found))
            found = [each for premise in premises for each in _derivatives_of(premise, together, definitions)]
    return [*premises, *found]


def _says_what_a_function_is(relation: Relation) -> bool:
    """True for f = t, where f is a function of exactly the coordinates that move in t.

    At isolated values of the coordinates, such an equation would state that they do not move.
    """
    for own, value in ((relation.left, relation.right), (relation.right, relation.left)):
        if isinstance(own, Symbol) and own.declaration.of:
            parts = list(value.walk())
            moving = {p for p in parts if isinstance(p, Symbol) and not p.declaration.constant}
            if moving and moving <= set(own.declaration.of) and not any(map(takes_rate, parts)):
                return True
    return False


def takes_rate(part: Term) -> bool:
    return isinstance(part, Derivative | TimeOperator)


def slopes_of(relation: Relation, sides: Sequence[Term], definitions: Lookup) -> list[Relation]:
    """Returns the partial derivatives of the equation that occur in the sides, with their variables and
    orders."""
    parts = list(reached(definitions, *sides))
    by = {part.arguments[1] for part in parts if isinstance(part, Apply) and part.head in PARTIALS}
    if any(isinstance(part, Apply) and part.head in GRADIENTS for part in parts):
        symbols = (part for part in parts if isinstance(part, Symbol))
        by |= {
            each for part in symbols for each in (part, *part.declaration.of) if each.declaration.coordinate
        }
    by |= {part.body for part in by if isinstance(part, Derivative)}  # ∂ḟ/∂q̇ = ∂f/∂q
    found, relations = [], [relation]
    depths = _depths(sides, definitions)
    own = _depths((relation.left, relation.right), definitions)
    for _ in range(max((depths.get(symbol, 0) - depth for symbol, depth in own.items()), default=0)):
        relations = [each_side(r, partial(_slope, x)) for r in relations for x in by]
        found += relations
    return found


def _depths(terms: Iterable[Term], definitions: Lookup) -> dict[Symbol, int]:
    """Returns the nesting depth of partial derivatives around each free symbol of the terms."""
    found: dict[Symbol, int] = {}
    for term in terms:
        body = definitions.lookup(term) if isinstance(term, Symbol) else None
        if isinstance(term, Symbol) and body is None:
            found.setdefault(term, 0)
            continue
        is_slope = isinstance(term, Apply) and term.head in GRADIENTS | PARTIALS
        for each, depth in _depths(term.children if body is None else (body,), definitions).items():
            found[each] = max(found.get(each, 0), depth + is_slope)
    return found


def _slope(by: Term, side: Term) -> Term:
    return apply("partial", side, by)


def each_side(relation: Relation, of: Callable[[Term], Term]) -> Relation:
    return equated("=", of(relation.left), of(relation.right))


def relations_of(statement: Statement) -> list[Relation]:
    """Returns the equations and inequations of an assumption, without its bounds."""
    return [each for each in _parts(statement) if each.operator != "≥"]


def _parts(statement: Statement) -> list[Relation]:
    match statement:
        case Relation(operator="=" | "≠" | "≥"):
            return [statement]
        case Conjunction():
            return [relation for part in statement.parts for relation in _parts(part)]
    raise NotExact("an assumption is an equation or an inequation (= or ≠)")
