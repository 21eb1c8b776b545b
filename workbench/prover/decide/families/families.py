"""Decides statements about integers n: for every n at once if the recurrences allow it, else for a range.

With Φₙ, aₙ, … left as free functions and Φₙ₊₁, aₙ₊₁, … replaced by their recurrences, an identity between
them holds for any n-th members. It therefore holds for every n from which the recurrences apply.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Protocol

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import relation
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.reasons import Reason, reason_of
from workbench.core.terms import (
    Apply,
    BigSum,
    Derivative,
    IllFormed,
    Relation,
    Statement,
    Symbol,
    Term,
)
from workbench.core.types import Declaration
from workbench.core.verdict import EngineDisagreement, Evidence, Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.addend_expansion import has_sums
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.language.definitions import Definitions, expand
from workbench.prover.decide.families.orders_past_literals import OrderRanges, values_past_literals
from workbench.prover.decide.families.recurrence_range import exceptions, rewritten, symbolic_members
from workbench.prover.decide.families.symbolic_orders import symbolic_orders, with_free_orders
from workbench.prover.decide.families.unbounded_indices import judge_addends, ranges_apart
from workbench.prover.decide.inference import generalization
from workbench.prover.decide.mapped_statements import all_terms, mapped, terms


class InstanceJudge(Protocol):
    """A judge of statements without integer variables; a frozen dataclass, so that options can be
    replaced."""

    definitions: Definitions
    second_engine: bool

    def judge_instance(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict: ...

    def by_one_engine(self) -> InstanceJudge:
        """Returns the judge without its second engine."""


#: The verdict on a family is that on its worst member.
WORST_FIRST = (
    Outcome.REFUTED,
    Outcome.ILL_FORMED,
    Outcome.UNCHECKED,
    Outcome.PROBABLE,
    Outcome.CONDITIONAL,
    Outcome.PROVED,
    Outcome.DEFINITION,
)


def judge_family(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges | None,
) -> Verdict:
    """Returns the verdict on a statement whose integer variables are those of `orders`: that on its worst
    member. A statement without an integer variable is its only member.

    For unbounded indices, examples prove nothing, and equal indices refute nothing.
    """
    if orders is None or not any(map(free_integers, all_terms(_given(statement, assume, hypothesis)))):
        return _instance_for(judge, statement, assume, hypothesis, {})
    verdict = _family(judge, statement, assume, hypothesis, orders)
    if verdict.outcome is Outcome.REFUTED and orders.generic:
        apart = ranges_apart(orders, statement, list(terms(statement)), judge.definitions)
        with suppress(Unsatisfiable):
            found = [_instances(judge, statement, assume, hypothesis, values) for values in apart]
            if found and all(each.outcome is Outcome.REFUTED for each in found):
                return found[0]
        return _open(orders, VerdictCode.FAILS_FOR_SOME_SUMS())
    may_go_on = not verdict.is_for_all and bool(orders.generic or orders.endless)
    return _open(orders, VerdictCode.HOLDS_FOR(orders=orders)) if may_go_on else verdict


def _given(
    statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
) -> tuple[Statement, ...]:
    return (statement, *assume) if hypothesis is None else (statement, *assume, hypothesis)


def _open(orders: OrderRanges, seen: Reason) -> Verdict:
    """Returns the `unchecked` verdict on examples of a family without a stated range."""
    if orders.generic:
        why = VerdictCode.NO_RANGE(variables=", ".join(orders.generic))
    else:
        why = VerdictCode.ENDLESS_RANGE(variables=", ".join(sorted(orders.endless)))
    return Verdict(Outcome.UNCHECKED, reason=VerdictCode.SEEN_OF_SOME(seen=seen, why=why))


def _family(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges,
) -> Verdict:
    if exceptions(judge).tangled:
        return _instances(judge, statement, assume, hypothesis, orders)
    if _defines(judge, statement):
        verdict = _instances(judge, statement, assume, hypothesis, orders)
        if verdict.outcome != Outcome.DEFINITION:
            return verdict
        scope = _scope(judge, [statement], {}, statement, orders)
        return verdict if scope is None else replace(verdict, scope=scope or None)
    general = _for_all(judge, statement, assume, hypothesis, orders)
    proves_nothing = bool(orders.endless or orders.generic)
    if general is not None:
        proves_nothing = general.outcome == Outcome.PROVED
    light = judge.by_one_engine() if proves_nothing else judge
    instances = _instances(light, statement, assume, hypothesis, orders)
    if general is None:
        return instances
    if general.outcome != Outcome.PROVED:
        same = instances.outcome == general.outcome
        return replace(general, evidence=_checked(general, orders)) if same else instances
    if instances.outcome == Outcome.REFUTED:
        raise EngineDisagreement(f"proved for all n, but refuted {instances.reason}")
    if instances.outcome not in (Outcome.PROVED, Outcome.PROBABLE, Outcome.DEFINITION):
        return instances  # such as a member below the first, or a denominator that vanishes
    return replace(general, evidence=_checked(general, orders))


def _checked(general: Verdict, orders: OrderRanges) -> tuple[Evidence, ...]:
    checked = Evidence("each instance, exact ring", "residual is 0", {"orders": str(orders)})
    return (*general.evidence, checked)


def _defines(judge: InstanceJudge, statement: Statement) -> bool:
    """True if the statement is the applicable definition of its left side, for every n."""
    match statement:
        case Relation(operator="=", left=Symbol() as symbol):
            return judge.definitions.lookup(symbol) == statement.right
    return False


def _for_all(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges,
) -> Verdict | None:
    """Returns the verdict with the lowest member of each family left free.

    Returns None if the statement is not of that form or does not hold so, or if some definition does not
    apply for all of `orders`.
    """
    statements = _given(statement, assume, hypothesis)
    if any(map(has_sums, all_terms(statements))):
        return judge_addends(judge, statement)  # holds without the assumptions
    try:
        shift = _shift(_indices(statements))
        statements = _shifted(statements, shift)
        method = "the n-th members are free functions, the next ones by recurrence"
        scope = _scope(judge, statements, shift, statement, orders)
        if scope is None:
            return None
        expanded = tuple(mapped(s, partial(_expanded, judge)) for s in statements)
        _refuse_hidden_coordinate(judge, expanded)
        if derivatives := symbolic_orders(all_terms(expanded)):
            expanded = _shifted(expanded, _shift(_indices(expanded, derivatives)))
            statements = tuple(mapped(s, with_free_orders) for s in expanded)
            method = "the n-th derivatives and the n-th members are free functions"
        shifted, *others = statements
        supposed = tuple(others[: len(assume)])
        given = None if hypothesis is None else others[-1]
        verdict = judge.judge_instance(shifted, supposed, given)
    except (NotExact, IllFormed):
        return None
    if verdict.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION):
        return None
    evidence = (*verdict.evidence, Evidence("all n at once", method))
    return generalization(verdict, scope or None, evidence)


def _scope(
    judge: InstanceJudge,
    statements: Sequence[Statement],
    shift: Mapping[str, Linear],
    original: Statement,
    orders: OrderRanges,
) -> str | None:
    """Returns the scope "all n ≥ 1", from the least n for which the definitions of the statements apply.

    Returns "all n" if that is 0, and "" without any n. Returns None unless the statement covers each n for
    which all its members belong to their families, and all of `orders`. The statements are shifted: their n
    counts from `shift`.
    """
    known = exceptions(judge)
    terms = list(all_terms(statements))
    start = known.start(rewritten(terms, judge.definitions))
    begin = known.begin(symbolic_members(part for term in terms for part in term.walk()))
    variables = sorted(_variables(original))
    least = {name: shift[name].constant if name in shift else 0 for name in variables}
    needed = {name: start.get(name, 0) + least[name] for name in variables}
    if any(start.get(name, 0) > begin.get(name, 0) for name in variables):
        return None
    if any(values[name] < needed[name] for values in orders.assignments() for name in variables):
        return None
    said = [f"{name} ≥ {needed[name]}" if needed[name] > 0 else name for name in variables]
    return f"all {', '.join(said)}" if said else ""


def _refuse_hidden_coordinate(judge: InstanceJudge, statements: Sequence[Statement]) -> None:
    """Raises NotExact if div or curl would be taken of a free function that stands for a field."""
    for term in all_terms(statements):
        for slope in (t for t in term.walk() if isinstance(t, Apply) and t.head in PARTIALS):
            if not _is_apart(slope, judge.definitions):
                raise NotExact("a partial derivative with an integer variable in it")
        for gradient in (t for t in term.walk() if isinstance(t, Apply) and t.head in GRADIENTS):
            for part in gradient.walk():
                hidden: list[Term] = []
                if isinstance(part, Symbol) and not all(i.is_number for i in part.index):
                    own = judge.definitions.about(part)
                    hidden = [expand(definition.body, judge.definitions) for definition in own]
                elif isinstance(part, Derivative) and not part.order.is_number:
                    hidden = [part.body]
                if any(t.declaration.coordinate for h in hidden for t in h.symbols()):
                    raise NotExact(f"the {gradient.head} of a field of every order")


def _is_apart(slope: Term, definitions: Definitions) -> bool:
    """True if two members in the partial derivative are distinct or equal for every n alike, and none hides a
    function."""
    parts = list(slope.walk())
    symbols = [part for part in parts if isinstance(part, Symbol)]
    for own in symbols:  # the list grows during the loop
        symbols += own.declaration.of
    indices: dict[Declaration, list[Linear]] = {}
    for own in symbols:
        if len(own.index) > 1 and not all(place.is_number for place in own.index):
            return False
        indices.setdefault(own.declaration, []).extend(own.index)
        if any(not place.is_number for place in own.index) and definitions.about(own):
            return False
    steps = [one - other for several in indices.values() for one, other in pairwise(several)]
    orders = [part.order for part in parts if isinstance(part, Derivative)]
    return not any(isinstance(part, BigSum) for part in parts) and all(n.is_number for n in (*steps, *orders))


def _indices(statements: Sequence[Statement], orders: Sequence[Linear] = ()) -> list[Linear]:
    """Returns the indices with integer variables, and the orders with exactly one."""
    indices = [
        index
        for term in all_terms(statements)
        for part in term.symbols()
        for index in part.index
        if not index.is_number
    ]
    return [*indices, *(order for order in orders if len(order.coefficients) == 1)]


def _shift(indices: Sequence[Linear]) -> dict[str, Linear]:
    """Returns the shift of n after which no index n + c has a negative c. Raises NotExact for other
    indices."""
    shift: dict[str, Linear] = {}
    for index in indices:
        ((name, coefficient), *others) = index.coefficients
        if others or coefficient != 1:
            raise NotExact(f"the index {index}")
        least = shift.get(name, Linear.variable(name))
        shift[name] = max(least, Linear.variable(name) - index.constant, key=lambda s: s.constant)
    return shift


def _shifted(statements: Sequence[Statement], shift: Mapping[str, Linear]) -> tuple[Statement, ...]:
    return tuple(instantiate(s, shift) for s in statements)


def _instances(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges,
) -> Verdict:
    """Returns the worst verdict over the range, and the first of equal ones; a refuted member ends the
    search.

    Members whose condition, such as i ≠ j, is unsatisfiable are skipped. Raises Unsatisfiable if all are
    skipped.
    """
    worst, place, count, is_idle, impossible = None, "", 0, False, None
    for values in orders.assignments():
        try:
            current = _instance_for(judge, statement, assume, hypothesis, values)
        except Unsatisfiable as found:
            impossible = found
            continue
        if current.code is VerdictCode.SAME_TERM:
            is_idle = True
            continue
        count += 1
        if worst is None or WORST_FIRST.index(current.outcome) < WORST_FIRST.index(worst.outcome):
            worst, place = current, _shown(values)
        if current.outcome == Outcome.REFUTED:
            break
    if worst is None and impossible is not None and not is_idle:
        raise impossible
    if worst is None:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.SAME_TERM())
    if worst.outcome in (Outcome.REFUTED, Outcome.UNCHECKED):
        reason = VerdictCode.FOR(values=place)
        if worst.reason:
            reason = VerdictCode.FOR_BECAUSE(values=place, reason=worst.reason)
        figures = {"held before": count - 1} if worst.outcome == Outcome.REFUTED else {}
        fails = Evidence("each instance", f"fails for {place}", figures)
        return replace(worst, reason=reason, evidence=(*worst.evidence, fails))
    for far in values_past_literals(terms(statement), judge.definitions, orders):
        with suppress(Unsatisfiable):  # nothing is claimed of such a member
            further = _instance_for(judge, statement, assume, hypothesis, far)
            if further.outcome == Outcome.REFUTED:
                return replace(
                    further, reason=VerdictCode.FOR_THOUGH_HOLDS(values=_shown(far), orders=orders)
                )
    evidence = (*worst.evidence, Evidence("each instance", "residual is 0", {"instances": count}))
    return generalization(worst, str(orders), evidence)


def _shown(values: Mapping[str, int]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in values.items())


def _instance_for(
    judge: InstanceJudge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    values: Mapping[str, int],
) -> Verdict:
    """Returns the verdict with the integer variables set to these values and the sums expanded."""
    try:
        supposed = tuple(instantiate(a, values) for a in assume)
        given = None if hypothesis is None else instantiate(hypothesis, values)
        return judge.judge_instance(instantiate(statement, values), supposed, given)
    except (NotExact, IllFormed) as outside:
        return Verdict(Outcome.UNCHECKED, reason=reason_of(outside))


def _variables(statement: Statement) -> set[str]:
    """Returns the integer variables of indices and orders, without those that a sum binds."""
    names: set[str] = set()
    bound: set[str] = set()
    for term in terms(statement):
        for part in term.walk():
            if isinstance(part, Symbol):
                names |= {name for index in part.index for name in index.variables}
            elif isinstance(part, Derivative):
                names |= part.order.variables
            elif isinstance(part, BigSum):
                bound |= set(part.variables)
    return names - bound


def _expanded(judge: InstanceJudge, statement: Relation) -> Relation:
    left, right = (expand(side, judge.definitions) for side in (statement.left, statement.right))
    return relation(statement.operator, left, right)
