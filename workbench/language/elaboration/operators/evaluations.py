"""Values at a place: \\left. f \\right|_{x = 0} is f under the condition x = 0.

The condition holds after all derivatives are taken. An exponential whose argument vanishes there is its
series up to the order of the derivatives, since Rodrigues' formula divides by the angle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction as Rational
from math import factorial
from typing import TypeGuard

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.reasons import Reason
from workbench.core.terms import (
    Apply,
    Block,
    Conjunction,
    Derivative,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
    heads_in,
)
from workbench.language.definitions import Definitions
from workbench.language.elaboration.operators.quotients import rate
from workbench.language.grammar.syntax import (
    Bracket,
    Chain,
    Fraction,
    Group,
    Leaf,
    Node,
    Scripted,
    core,
    in_a_row,
)
from workbench.language.grammar.vocabulary import BAR
from workbench.language.naming.scope import Scope
from workbench.language.printing.printer import to_latex


@dataclass(frozen=True)
class Evaluation:
    """A term at a place: the values of its variables there."""

    body: Term
    places: tuple[tuple[Symbol, Term], ...]
    at: int

    def conditions(self) -> list[Relation]:
        """Returns x = c, with cos x = cos c and sin x = sin c of an angle: numbers of their own for the
        engines."""
        angular = not {"sin", "cos", "exp"}.isdisjoint(heads_in(self.body))
        found = []
        for variable, value in self.places:
            found.append(construct.relation("=", variable, value))
            if angular and variable.type.kind == "scalar":
                for head in ("cos", "sin"):
                    sides = [_circular(head, each) for each in (variable, value)]
                    found.append(construct.relation("=", *sides))
        return found


@dataclass(frozen=True)
class Apart:
    """The symbols outside of a bar. They must not depend on its variables, by their definitions either."""

    places: tuple[tuple[Symbol, Term], ...]
    symbols: tuple[Symbol, ...]
    at: int

    def require(self, definitions: Definitions) -> None:
        """Raises Fault if the definition of a term depends on a variable of the bar."""
        for term in self.symbols:
            reached = set(definitions.reached(term))
            for variable, _ in self.places:
                if variable in reached:
                    raise Fault(_outside_too(term, variable), self.at)


def _outside_too(term: Term, variable: Symbol) -> Reason:
    return SyntaxCode.EVALUATED_OUTSIDE_TOO(name=to_latex(term), variable=to_latex(variable))


def _circular(head: str, angle: Term) -> Term:
    """Returns cos or sin of an angle; of 0 the number."""
    if isinstance(angle, Zero):
        return construct.number(1) if head == "cos" else construct.zero()
    return construct.apply("cos" if head == "cos" else "sin", angle)


def is_evaluated(node: Node) -> TypeGuard[Scripted]:
    """True for \\left. f \\right|_{x = 0}."""
    return isinstance(node, Scripted) and isinstance(node.nucleus, Bracket) and node.nucleus.kind == BAR


def with_brackets(scope: Scope, items: Sequence[Node]) -> list[Node]:
    """Returns the factors with the bracket that opens before a bar: f |_{x = 0} is f there for a fraction, a
    bracket, and a derivative of one. Raises Fault for other factors, whose number before the bar is open."""
    found: list[Node] = []
    for item in items:
        if not (isinstance(item, Scripted) and isinstance(item.nucleus, Leaf) and item.nucleus.text == "|"):
            found.append(item)
            continue
        if not (found and isinstance(found[-1], Bracket | Fraction)):
            raise Fault(SyntaxCode.EVALUATED_WHERE(), item.at)
        inside = [found.pop()]
        if found and isinstance(found[-1], Fraction) and _differentiates_what_follows(scope, found[-1]):
            inside.insert(0, found.pop())
        bracket = Bracket(inside[0].at, BAR, (in_a_row(inside[0].at, inside),))
        found.append(replace(item, nucleus=bracket))
    return found


def _differentiates_what_follows(scope: Scope, fraction: Fraction) -> bool:
    found = rate(scope, fraction)
    return found is not None and not found.behind


def value_at(scope: Scope, item: Scripted) -> Term:
    """Returns the term before a bar. Its places become conditions of the statement, by `under_places`. Raises
    Fault outside of equations."""
    bracket = item.nucleus
    assert isinstance(bracket, Bracket), "is_evaluated"
    if not scope.takes_bars:
        raise Fault(SyntaxCode.EVALUATED_ELSEWHERE(), item.at)
    if item.sup is not None or item.sub is None or item.primes or len(bracket.parts) != 1:
        raise Fault(SyntaxCode.EVALUATED_WHERE(), item.at)
    body, places = scope.term(bracket.parts[0]), tuple(_places(scope, item.sub))
    for variable, value in places:
        if isinstance(value, Zero):
            body = _with_series(body, variable, _orders(body, variable))
    scope.evaluations.append(Evaluation(body, places, item.at))
    return body


def _places(scope: Scope, below: Node) -> Iterator[tuple[Symbol, Term]]:
    """Yields x and c of x = c, of x = y = c, and of several places. Raises Fault for others."""
    plain = core(below)
    for part in plain.parts if isinstance(plain, Group) else (plain,):
        if not (isinstance(part, Chain) and all(sign == "=" for sign, _ in part.relations)):
            raise Fault(SyntaxCode.EVALUATED_WHERE(), below.at)
        *variables, last = (scope.term(side) for side in part.sides)
        for variable in variables:
            if not isinstance(variable, Symbol) or variable in last.walk():
                raise Fault(SyntaxCode.EVALUATED_WHERE(), part.at)
            equation = scope.build(part.at, construct.relation, "=", variable, last)
            yield variable, equation.right


def _orders(term: Term, variable: Symbol) -> int:
    """Returns how often the term is differentiated by the variable or by the time, at most."""
    own = isinstance(term, Apply) and term.head in PARTIALS and _stands_in(term.arguments[1], variable)
    rates = int(term.order) if isinstance(term, Derivative) and term.order.is_number else 0
    return own + rates + max((_orders(child, variable) for child in term.children), default=0)


def _stands_in(term: Term, variable: Symbol) -> bool:
    return any(part == variable for part in term.walk())


def _with_series(term: Term, variable: Symbol, order: int) -> Term:
    """Returns the term with Σ Aᵏ/k! for each exp A whose A vanishes with the variable."""
    if not _stands_in(term, variable):
        return term
    if isinstance(term, Apply) and term.head == "exp" and _vanishes(term.arguments[0], variable):
        return _series(term, order)
    return construct.with_children(term, lambda child: _with_series(child, variable, order))


def _series(exponential: Apply, order: int) -> Term:
    (argument,) = exponential.arguments
    one = construct.number(1) if argument.type.kind == "scalar" else construct.identity(exponential.type)
    addends: list[Term] = [one]
    for k in range(1, order + 1):
        share = construct.number(Rational(1, factorial(k)))
        addends.append(construct.apply("mul", share, construct.power(argument, k)) if k > 1 else argument)
    return construct.apply("add", *addends) if order else one


def _vanishes(term: Term, variable: Symbol) -> bool:
    """True if the term is 0 where the variable is, by the form of the term."""
    match term:
        case Symbol():
            return term == variable
        case Zero():
            return True
        case Apply(head="add" | "neg" | "skew" | "transpose" | "quaternion") | Block():
            return all(_vanishes(child, variable) for child in term.children)
        case Apply(head="mul" | "dot" | "cross" | "outer"):
            return any(_vanishes(child, variable) for child in term.children)
        case Apply(head="div"):
            return _vanishes(term.arguments[0], variable)
    return False


def under_places(scope: Scope, sides: Sequence[Term], said: Statement) -> Statement:
    """Returns the statement under the conditions of its bars. Raises Fault if a variable of a bar stands
    outside of it, or if the value is differentiated."""
    if not scope.evaluations:
        return said
    evaluations, scope.evaluations = scope.evaluations, []
    for one in evaluations:
        times = sum((each.body, each.places) == (one.body, one.places) for each in evaluations)
        apart = tuple(outside(one, sides, times))
        _require_alone(one, apart)
        scope.apart.append(Apart(one.places, apart, one.at))
    parts = dict.fromkeys(part for one in evaluations for part in one.conditions())
    return Implication(next(iter(parts)) if len(parts) == 1 else Conjunction(tuple(parts)), said)


def _require_alone(one: Evaluation, apart: Sequence[Symbol]) -> None:
    for variable, _ in one.places:
        for term in apart:
            moves = variable.declaration.clock and not term.declaration.constant
            if moves or variable in (term, *term.declaration.of):
                raise Fault(_outside_too(term, variable), one.at)


def outside(one: Evaluation, sides: Sequence[Term], times: int) -> Iterator[Symbol]:
    """Yields the symbols outside of bars. Raises Fault if a value is under a derivative.

    times: how often the term of this bar is written with a bar."""
    waiting = list(sides)
    while waiting:
        term = waiting.pop()
        if times and term == one.body:
            times -= 1
            continue
        is_rate = isinstance(term, Derivative | TimeOperator) or term.type.kind == "operator"
        is_rate = is_rate or (isinstance(term, Apply) and term.head in PARTIALS | GRADIENTS)
        if is_rate and any(part == one.body for part in term.walk()):
            raise Fault(SyntaxCode.EVALUATED_UNDER_RATE(), one.at)
        if isinstance(term, Symbol):
            yield term
        waiting += term.children
