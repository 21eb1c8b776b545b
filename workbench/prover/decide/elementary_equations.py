"""Decides equations of functions of scalars: by what is known of their values, and at real points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, derivative, power, relation, zero
from workbench.core.operations import PARTIALS
from workbench.core.terms import Apply, Derivative, Number, Power, Relation, Statement, Symbol, Term
from workbench.core.types import SCALAR
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.angle_combinations import sum_of_products
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.engines.inventory.elementary_functions import Replaced, holds_roots, without_functions
from workbench.engines.inventory.functions_of_scalars import FUNCTIONS
from workbench.engines.inventory.inventory import Inventory, take_inventory
from workbench.engines.inventory.signs import is_seen_nonnegative
from workbench.language.definitions import expand, is_definition, number_behind
from workbench.language.printing.printer import to_latex
from workbench.prover.counterexamples.rational_points import Trial, counterexample
from workbench.prover.counterexamples.real_angles import (
    AT_REAL_POINT,
    is_pi,
    real_trials,
    surely_differ,
    surely_no_right_angle,
    surely_positive,
)
from workbench.prover.decide.law_statements import law_for
from workbench.prover.decide.premise_consequences import with_premise_as_definition

#: The method of the evidence that says where the functions are defined.
_DOMAIN = "domain"
#: Real points at which a proved equation is evaluated.
_POINTS = 3


Judge = Callable[[Statement, tuple[Statement, ...]], Verdict]


def judge_functions(
    said: Relation,
    assume: tuple[Statement, ...],
    setting: tuple[Lookup, bool],
    judge: Judge,
    roots: bool = False,
) -> Verdict:
    """Returns the verdict on an equation of functions of scalars, at last also of roots.

    setting: the definitions, and whether an equation that can be solved for a rate states a law.
    """
    definitions, _ = setting
    found = without_functions(said, definitions, roots)
    is_idle = said.left != said.right and found.relation.left == found.relation.right
    if is_definition(said, definitions) or is_idle:
        found = replace(found, relation=difference(found.relation))
    is_last = roots or not holds_roots(said, definitions)
    try:
        verdict = _judged(found, assume, setting, judge)
    except NotExact:
        if is_last:
            raise
        return judge_functions(said, assume, setting, judge, True)
    if verdict.code is VerdictCode.NOT_FROM_FUNCTIONS and not is_last:
        return judge_functions(said, assume, setting, judge, True)
    return verdict


def judge_roots(
    said: Relation, assume: tuple[Statement, ...], setting: tuple[Lookup, bool], judge: Judge
) -> Verdict:
    """Returns the verdict on an equation of roots: by its squares, if both sides are roots or lengths."""
    if (squares := _squares_of_roots(said, setting[0])) is not None:
        with suppress(NotExact):
            verdict = judge(squares, assume)
            if verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL):
                return _with_evidence(
                    verdict, "roots", "neither side is negative, and their squares are equal"
                )
    return judge_functions(said, assume, setting, judge, True)


def difference(same: Relation) -> Relation:
    """Returns left − right = 0."""
    nothing = apply("add", same.left, apply("neg", same.right))
    return relation("=", nothing, zero(same.left.type))


def _judged(
    found: Replaced, assume: tuple[Statement, ...], setting: tuple[Lookup, bool], judge: Judge
) -> Verdict:
    definitions, laws = setting
    try:
        verdict = judge(found.relation, (*assume, *found.supposed))
    except NotExact:
        refuted = refuted_at_real_point(found, assume, definitions, laws)
        if refuted is None:
            raise
        return refuted
    except Unsatisfiable:
        if assume:
            raise
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_FUNCTIONS())
    if verdict.outcome is Outcome.REFUTED or verdict.code is VerdictCode.NO_COUNTEREXAMPLE:
        refuted = refuted_at_real_point(found, assume, definitions, laws)
        return refuted or Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_FUNCTIONS())
    if found.only_exponentials:
        return _with_evidence(
            verdict, "exponentials", "any functions E that are nowhere 0, with the rates of e^x"
        )
    if verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL) and not _holds_somewhere(
        found, assume, definitions
    ):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_FUNCTIONS())
    where = ", ".join(f"{to_latex(term)} > 0" for term in found.domain if not _is_surely_positive(term))
    method = "any values with the rates of these functions" + (", and their equations" if where else "")
    verdict = _with_evidence(verdict, "elementary functions", method)
    return _with_evidence(verdict, _DOMAIN, f"where {where}") if where else verdict


def domain_of(verdict: Verdict) -> str | None:
    """Returns where the functions of a proved equation are defined; None if they are everywhere."""
    return next((each.outcome for each in verdict.evidence if each.method == _DOMAIN), None)


def _is_surely_positive(term: Term) -> bool:
    """True if the form of the term shows that it is > 0."""
    match term:
        case Number(value=value):
            return value > 0
        case Symbol():
            return term.declaration.positive or number_behind(term) != term
        case Power(base=base):
            return _is_surely_positive(base)
        case Apply(head="mul", arguments=factors):
            return all(map(_is_surely_positive, factors))
        case Apply(head="add", arguments=addends):
            return is_seen_nonnegative(term) and any(map(_is_surely_positive, addends))
    return False


def _squares_of_roots(said: Relation, definitions: Lookup) -> Relation | None:
    """Returns the equation of the squares if both sides are roots or lengths; else None."""
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    squares = [_square(side) for side in sides if isinstance(side, Apply) and side.head in ("root", "norm")]
    return relation("=", *squares) if len(squares) == 2 else None


def _square(side: Apply) -> Term:
    (inside,) = side.arguments
    return inside if side.head == "root" else power(inside, 2)


def _with_evidence(verdict: Verdict, kind: str, method: str) -> Verdict:
    return replace(verdict, evidence=(*verdict.evidence, Evidence(kind, method)))


def _apart(assume: Sequence[Statement]) -> list[Relation] | None:
    """Returns the assumptions a ≠ b and a ≥ b; None if there are others."""
    apart = [each for each in assume if isinstance(each, Relation) and each.operator in "≠≥"]
    return apart if len(apart) == len(assume) else None


def _inventory(found: Replaced, apart: Sequence[Relation], definitions: Lookup) -> Inventory:
    """Returns the inventory of the relation, of its domain, and of the arguments of its functions."""
    relations = (found.relation, *apart)
    sides = [side for each in relations for side in (each.left, each.right)]
    orders = take_inventory(sides, definitions).orders
    behind = [
        derivative(argument, orders[own]) if orders.get(own) else argument
        for own, value in found.values.items()
        for argument in value.arguments
    ]
    return take_inventory((*sides, *behind, *found.domain), definitions)


def _real_points(
    found: Replaced, apart: Sequence[Relation], definitions: Lookup, inventory: Inventory
) -> Iterator[Trial]:
    """Yields real points at which all functions are defined."""
    for trial in real_trials(inventory, definitions, found.values):
        with suppress(NotExact):
            is_defined = all(surely_positive(trial, term) for term in found.domain)
            if is_defined and all(_meets(trial, each) for each in apart):
                yield trial


def _meets(trial: Trial, supposed: Relation) -> bool:
    """True if a ≠ b or a ≥ b is certain at a point."""
    return trial.meets(supposed) if supposed.operator == "≥" else surely_differ(trial, supposed)


def _holds_somewhere(found: Replaced, assume: Sequence[Statement], definitions: Lookup) -> bool:
    """True if the functions are defined at some real point, and the sides differ surely at none."""
    apart = _apart(assume)
    if apart is None:
        return not found.domain
    inventory, count = _inventory(found, apart, definitions), 0
    for trial in _real_points(found, apart, definitions, inventory):
        with suppress(NotExact):
            if surely_differ(trial, found.relation):
                return False
            count += 1
        if count == _POINTS:
            break
    return count > 0


def refuted_at_real_point(
    found: Replaced, assume: Sequence[Statement], definitions: Lookup, laws: bool
) -> Verdict | None:
    """Returns the verdict at a real point where the sides differ; None if none is found."""
    defining = with_premise_as_definition(found.relation, assume, definitions, ()) if assume else None
    if defining is not None:
        _, others, definitions = defining
        return refuted_at_real_point(found, others, definitions, laws)
    apart = _apart(assume)
    if apart is None:
        return None
    said = found.relation
    inventory = _inventory(found, apart, definitions)
    try:
        law = law_for(said, inventory, definitions) if laws else None
    except NotExact:
        return None
    if law is not None and not _is_rate_of_function(law, found, inventory):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.STATES_A_LAW(name=to_latex(law)))
    differ = _difference_test(found, definitions)
    if differ is None:
        return None
    for trial in _real_points(found, apart, definitions, inventory):
        with suppress(NotExact):
            if differ(trial, said):
                hidden = {s for s in inventory.orders if s in found.values or is_pi(s)}
                known = {s: order for s, order in inventory.orders.items() if s not in hidden}
                example = counterexample(trial, said, replace(inventory, orders=known), ())
                evidence = Evidence(AT_REAL_POINT, "the two sides differ")
                shown = replace(example, defined={}, behind=())
                return Verdict(Outcome.REFUTED, counterexample=shown, evidence=(evidence,))
    return None


def _is_rate_of_function(law: Term, found: Replaced, inventory: Inventory) -> bool:
    """True if the equation differentiates a function of the symbol as often as the symbol itself."""
    own, order = (law.body, int(law.order)) if isinstance(law, Derivative) else (law, 0)
    return own in found.values or any(
        inventory.orders.get(function, 0) >= order > 0
        and any(number_behind(part) == own for u in value.arguments for part in u.symbols())
        for function, value in found.values.items()
    )


def _difference_test(found: Replaced, definitions: Lookup) -> Callable[[Trial, Relation], bool] | None:
    """Returns the test that refutes: angles that are sums of arctangents differ by no multiple of π/2, since
    their branches are the author's; None for arcs of which only one branch is known."""
    arcs = {own for own, value in found.values.items() if FUNCTIONS[value.head].circle is not None}
    bare = arcs & {part for side in (found.relation.left, found.relation.right) for part in _outside(side)}
    if not bare:
        return surely_differ
    difference = apply("add", found.relation.left, apply("neg", found.relation.right))
    products = sum_of_products(difference, definitions) if difference.type == SCALAR else {}
    alone = {factors[0] for factors in products if len(factors) == 1}
    others = {part for factors in products if len(factors) > 1 for each in factors for part in each.walk()}
    is_plain = bare <= alone and not bare & others
    is_of_tangent = all(found.values[own].head in ("arctan", "atan2") for own in bare)
    return surely_no_right_angle if is_plain and is_of_tangent else None


def _outside(term: Term) -> Iterator[Term]:
    """Yields the parts that stand under no derivative, sine or cosine."""
    if isinstance(term, Derivative) or (isinstance(term, Apply) and term.head in (*PARTIALS, "sin", "cos")):
        return
    yield term
    for child in term.children:
        yield from _outside(child)
