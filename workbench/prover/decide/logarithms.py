"""Decides equations with logarithms, without the logarithm.

log is the inverse of exp on angles below π. A logarithm is replaced by its value, a term X for which both
engines show exp X = Y. If no value is known, log Y = X is decided as exp X = Y.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, relation, with_children, zero
from workbench.core.hypotheses import Hypothesis
from workbench.core.terms import Apply, Number, Relation, Statement, Symbol, Term
from workbench.core.verdict import Counterexample, Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact, WithDefinitions, reached
from workbench.engines.inventory.logarithm_values import LogarithmValues, is_logarithm, is_rotation
from workbench.language.definitions import expand
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.inverse_trigonometry import ELSEWHERE, on_principal_branch

Judge = Callable[[Statement, Lookup], Verdict]


def holds_logarithm(said: Relation, definitions: Lookup) -> bool:
    """True if a logarithm stands in the equation or in a definition that it uses."""
    parts = reached(definitions, said.left, said.right)
    return any(map(is_logarithm, parts))


def law_of_logarithm(said: Relation, definitions: Lookup) -> Symbol | None:
    """Returns a symbol that log Y = X says something of: a free one of X that does not stand in Y."""
    for side, other in ((said.left, said.right), (said.right, said.left)):
        logarithm = _alone(side)
        if logarithm is not None:
            own = set(reached(definitions, logarithm))
            free = (part for part in reached(definitions, other) if isinstance(part, Symbol))
            return next((each for each in free if each not in own and definitions.lookup(each) is None), None)
    return None


def _alone(side: Term) -> Term | None:
    """Returns the logarithm of a side that is a multiple of it, or the vector of one; else None."""
    match side:
        case Apply(head="log") if is_logarithm(side):
            return side
        case Apply(head="neg" | "vect" | "vector part", arguments=(inner,)):
            return _alone(inner)
        case Apply(head="mul", arguments=(Number(), inner)) | Apply(head="div", arguments=(inner, Number())):
            return _alone(inner)
    return None


def judge_logarithm(said: Relation, is_supposed: bool, definitions: Lookup, judge: Judge) -> Verdict:
    """Returns the verdict. is_supposed: the equation has assumptions, which may lead to another branch.

    Raises NotExact if a logarithm has no known value and does not stand alone on its side.
    """
    values = LogarithmValues(definitions)
    left, right = (values.without(expand(side, definitions)) for side in (said.left, said.right))
    plain = left, right
    left, right = (_with_half_angles(side, values) for side in plain)
    if values.unknown:
        return _as_exponential(said, values, judge)
    known = WithDefinitions(definitions, values.free)
    for exponential in values.shown:
        if judge(exponential, known).outcome is not Outcome.PROVED:
            raise NotExact("a logarithm whose value the engines do not confirm")
    if left == right:
        verdict = judge(relation("=", apply("add", left, apply("neg", right)), zero(left.type)), known)
    else:
        verdict = judge(relation("=", left, right), known)
    is_beyond = plain != (left, right) and not _is_short(verdict)
    if verdict.outcome is Outcome.REFUTED and (is_beyond or (is_supposed and values.angles)):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.UP_TO_BRANCH(branch=values.branch()))
    evidence = Evidence("logarithms", "replaced by what they are the exponents of")
    verdict = replace(verdict, evidence=(*verdict.evidence, evidence))
    return _on_branch(verdict, values)


def _with_half_angles(term: Term, values: LogarithmValues) -> Term:
    """Returns the term with the length of log q for arccos of the scalar part of a free unit quaternion q.

    The length of the vector part is the sine of that: the angle of a logarithm is at most π."""
    match term:
        case Apply(head="arccos", arguments=(Apply(head="scalar part", arguments=(Symbol() as turn,)),)):
            return _half_angle(turn, values) or term
        case Apply(head="norm", arguments=(Apply(head="vector part", arguments=(Symbol() as turn,)),)):
            angle = _half_angle(turn, values)
            return term if angle is None else apply("sin", angle)
    return with_children(term, lambda each: _with_half_angles(each, values))


def _half_angle(turn: Symbol, values: LogarithmValues) -> Term | None:
    exponential = values.free.get(turn) if turn.type.kind == "quaternion" else None
    if not isinstance(exponential, Apply):
        return None
    (_, vector) = exponential.arguments[0].children
    return apply("norm", vector)


def _is_short(verdict: Verdict) -> bool:
    """True if the logarithms of the counterexample are shorter than π."""
    example = verdict.counterexample
    logs = [] if example is None else [v for name, v in example.values.items() if name.startswith("\\log ")]
    return all(sum(Fraction(entry) ** 2 for entry in each) < 9 for each in logs)


def _as_exponential(said: Relation, values: LogarithmValues, judge: Judge) -> Verdict:
    """Returns the verdict on exp X = Y for log Y = X, where X has the form of a logarithm."""
    sides = [expand(side, values.definitions) for side in (said.left, said.right)]
    for logarithm, exponent in (sides, sides[::-1]):
        if not (isinstance(logarithm, Apply) and is_logarithm(logarithm)) or any(
            is_logarithm(part) for part in exponent.walk()
        ):
            continue
        (turn,) = logarithm.arguments
        values.angles.clear()
        if is_rotation(turn) and values.vector_of(exponent) is not None:
            verdict = judge(relation("=", apply("exp", exponent), turn), values.definitions)
            evidence = Evidence("logarithms", "the exponentials of both sides")
            return _on_branch(replace(verdict, evidence=(*verdict.evidence, evidence)), values)
    raise NotExact("a logarithm of what is not seen to be a rotation whose exponent is known")


def _on_branch(verdict: Verdict, values: LogarithmValues) -> Verdict:
    """Returns the verdict under the condition that the angles are below π."""
    if verdict.outcome is Outcome.CONDITIONAL and values.angles and not verdict.hypothesis:
        return replace(verdict, hypothesis=Hypothesis.of(values.branch()))
    if verdict.outcome is not Outcome.PROVED or not values.angles:
        return verdict
    branch, free = values.branch(), [angle for angle in values.angles if isinstance(angle, Symbol)]
    if not free or values.definitions.lookup(free[0]) is not None:
        return replace(
            Verdict(Outcome.UNCHECKED, reason=VerdictCode.UP_TO_BRANCH(branch=branch)),
            evidence=verdict.evidence,
        )
    angle = free[0]
    entries = (str(ELSEWHERE), *["0"] * (angle.type.rows - 1))
    name, kind = to_latex(angle), str(angle.type)
    witness = Counterexample({name: entries}, (f"where {branch}",), entries, kinds={name: kind}, kind=kind)
    return on_principal_branch(verdict, branch, witness, f"{name} = {ELSEWHERE}")
