"""Statements about integers n: for every n at once where the recurrences allow it, else for a range.

With Φₙ, aₙ, … left as free functions and Φₙ₊₁, aₙ₊₁, … replaced by their recurrences, an identity between
them holds whatever the n-th members are; so it holds for every n from which the recurrences are in force.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Protocol

from workbench.judge.inventory import GRADIENTS, NotExact
from workbench.judge.regular import is_regular
from workbench.judge.symbolic_orders import freed, symbolic_orders
from workbench.judge.verdict import EngineDisagreement, Evidence, Outcome, Verdict
from workbench.language.construct import relation
from workbench.language.definitions import Definitions, expand
from workbench.language.instances import instantiate
from workbench.language.integers import Linear
from workbench.language.terms import (
    Apply,
    BigSum,
    Conjunction,
    Derivative,
    Equivalence,
    IllFormed,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
)


class OrderRanges(Protocol):
    """The values of a family's integer variables, such as `papers.Orders`."""

    def assignments(self) -> Iterator[dict[str, int]]: ...


class InstanceJudge(Protocol):
    """A judge of statements without integer variables; a frozen dataclass, so that it can be made lighter."""

    definitions: Definitions
    second_engine: bool

    def judge_instance(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict: ...


SAME_TERM = "both sides are the same term, so nothing is tested"


def judge_family(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges | None,
) -> Verdict:
    """The verdict on a statement whose integer variables are those of `orders`."""
    if orders is None:
        return _instance_for(judge, statement, assume, hypothesis, {})
    if not is_regular(judge):
        return _instances(judge, statement, assume, hypothesis, orders)
    variables = sorted(_variables(statement))
    scope = f"all {', '.join(variables)}" if variables else None
    if _defines(judge, statement):
        verdict = _instances(judge, statement, assume, hypothesis, orders)
        return replace(verdict, scope=scope) if verdict.outcome == Outcome.DEFINITION else verdict
    general = _for_all(judge, statement, assume, hypothesis)
    if general is None or general.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION):
        return _instances(judge, statement, assume, hypothesis, orders)
    if general.outcome == Outcome.DEFINITION:
        return replace(general, scope=scope)
    # the range is then a check of the argument for all n; for a proof one engine is enough there
    light = judge if general.outcome == Outcome.CONDITIONAL else replace(judge, second_engine=False)
    instances = _instances(light, statement, assume, hypothesis, orders)
    if general.outcome == Outcome.CONDITIONAL and instances.outcome != Outcome.CONDITIONAL:
        return instances
    if instances.outcome == Outcome.UNCHECKED:  # such as a member below the first
        return instances
    if instances.outcome == Outcome.REFUTED:
        raise EngineDisagreement(f"proved for all n, but refuted {instances.reason}")
    checked = Evidence("each instance, exact ring", "residual is 0", {"orders": str(orders)})
    return replace(general, scope=scope, evidence=(*general.evidence, checked))


def _defines(judge: InstanceJudge, statement: Statement) -> bool:
    """Whether the statement is the definition in force of its left side, for every n."""
    match statement:
        case Relation(operator="=", left=Symbol() as symbol):
            return judge.definitions.lookup(symbol) == statement.right
    return False


def _for_all(
    judge: InstanceJudge, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
) -> Verdict | None:
    """With the lowest member of each family free; None where the statement is not of that form."""
    statements = (statement, *assume, *([] if hypothesis is None else [hypothesis]))
    try:
        statements = _from_lowest(statements, _indices(statements))
        method = "the n-th members are free functions, the next ones by recurrence"
        expanded = tuple(_mapped(s, partial(_expanded, judge)) for s in statements)
        _refuse_hidden_coordinate(judge, expanded)
        if orders := symbolic_orders(_all_terms(expanded)):
            lowest = _indices(expanded, orders)
            expanded = _from_lowest(expanded, lowest)
            statements = tuple(_mapped(s, freed) for s in expanded)
            method = "the n-th derivatives and the n-th members are free functions"
        shifted, *others = statements
        supposed = tuple(others[: len(assume)])
        given = None if hypothesis is None else others[-1]
        verdict = judge.judge_instance(shifted, supposed, given)
    except (NotExact, IllFormed):
        return None
    return replace(verdict, evidence=(*verdict.evidence, Evidence("all n at once", method)))


def _refuse_hidden_coordinate(judge: InstanceJudge, statements: Sequence[Statement]) -> None:
    """Raises NotExact where div or curl would be taken of a free function that stands for a field."""
    for term in _all_terms(statements):
        for gradient in (t for t in term.walk() if isinstance(t, Apply) and t.head in GRADIENTS):
            for part in gradient.walk():
                hidden: list[Term] = []
                if isinstance(part, Symbol) and not all(i.is_number for i in part.index):
                    own = (d for d in judge.definitions if d.declaration == part.declaration)
                    hidden = [expand(definition.body, judge.definitions) for definition in own]
                elif isinstance(part, Derivative) and not part.order.is_number:
                    hidden = [part.body]
                if any(isinstance(t, Symbol) and t.declaration.coordinate for h in hidden for t in h.walk()):
                    raise NotExact(f"the {gradient.head} of a field of every order")


def _indices(statements: Sequence[Statement], orders: Sequence[Linear] = ()) -> list[Linear]:
    """The indices of all symbols that hold an integer variable, and the orders of derivatives that do."""
    indices = [
        index
        for term in _all_terms(statements)
        for part in term.walk()
        if isinstance(part, Symbol)
        for index in part.index
        if not index.is_number
    ]
    return [*indices, *orders]


def _from_lowest(statements: Sequence[Statement], indices: Sequence[Linear]) -> tuple[Statement, ...]:
    """The statements with n shifted so that no index n + c has a negative c. Raises NotExact for other
    indices."""
    shift: dict[str, Linear] = {}
    for index in indices:
        ((name, coefficient), *others) = index.coefficients
        if others or coefficient != 1:
            raise NotExact(f"the index {index}")
        least = shift.get(name, Linear.variable(name))
        shift[name] = max(least, Linear.variable(name) - index.constant, key=lambda s: s.constant)
    return tuple(instantiate(s, shift) for s in statements)


def _instances(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges,
) -> Verdict:
    """The worst verdict over the range: the first that fails, else one that is not a mere definition."""
    verdict, count = None, 0
    for values in orders.assignments():
        current = _instance_for(judge, statement, assume, hypothesis, values)
        if current.reason == SAME_TERM:
            continue
        if current.outcome in (Outcome.REFUTED, Outcome.UNCHECKED):
            place = ", ".join(f"{name} = {value}" for name, value in values.items())
            reason = f"for {place}" + (f": {current.reason}" if current.reason else "")
            before = Evidence("each instance", f"fails for {place}", {"held before": count})
            return replace(current, reason=reason, evidence=(*current.evidence, before))
        count += 1
        if verdict is None or verdict.outcome == Outcome.DEFINITION:
            verdict = current
    if verdict is None:
        return Verdict(Outcome.UNCHECKED, reason=SAME_TERM)
    evidence = (*verdict.evidence, Evidence("each instance", "residual is 0", {"instances": count}))
    return replace(verdict, scope=str(orders), evidence=evidence)


def _instance_for(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    values: Mapping[str, int],
) -> Verdict:
    """The verdict with the integer variables put to these values and the sums written out."""
    try:
        supposed = tuple(instantiate(a, values) for a in assume)
        given = None if hypothesis is None else instantiate(hypothesis, values)
        return judge.judge_instance(instantiate(statement, values), supposed, given)
    except (NotExact, IllFormed) as outside:
        return Verdict(Outcome.UNCHECKED, reason=str(outside))


def _variables(statement: Statement) -> set[str]:
    """The integer variables of indices and orders, but for those that a sum binds."""
    names: set[str] = set()
    bound: set[str] = set()
    for term in _terms(statement):
        for part in term.walk():
            if isinstance(part, Symbol):
                names |= {name for index in part.index for name in index.variables}
            elif isinstance(part, Derivative):
                names |= part.order.variables
            elif isinstance(part, BigSum):
                bound |= set(part.variables)
    return names - bound


def _all_terms(statements: Iterable[Statement]) -> Iterator[Term]:
    for statement in statements:
        yield from _terms(statement)


def _expanded(judge: InstanceJudge, statement: Relation) -> Relation:
    left, right = (expand(side, judge.definitions) for side in (statement.left, statement.right))
    return relation(statement.operator, left, right)


def _mapped(statement: Statement, of: Callable[[Relation], Relation]) -> Statement:
    match statement:
        case Relation():
            return of(statement)
        case Equivalence() | Implication():
            return type(statement)(_mapped(statement.left, of), _mapped(statement.right, of))
    return Conjunction(tuple(_mapped(part, of) for part in statement.parts))


def _terms(statement: Statement) -> Iterator[Term]:
    match statement:
        case Relation():
            yield from (statement.left, statement.right)
        case Equivalence() | Implication():
            yield from _terms(statement.left)
            yield from _terms(statement.right)
        case Conjunction():
            for part in statement.parts:
                yield from _terms(part)
