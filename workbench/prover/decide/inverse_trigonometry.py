"""Decides θ = arccos x and similar equations, which hold on one branch only, without the inverse function.

θ = c arccos x     cos (θ/c) = x              on 0 ≤ θ/c ≤ π
θ = c arcsin x     sin (θ/c) = x              on −π/2 ≤ θ/c ≤ π/2
θ = c arctan x     sin (θ/c) = x cos (θ/c)    on −π/2 < θ/c < π/2
θ = c atan2(y, x)  sin (θ/c) r = y, cos (θ/c) r = x, r = ‖(x, y)‖     on −π < θ/c ≤ π

Several of them are added up first, with arccos x = π/2 − arcsin x and arcsin (−x) = −arcsin x.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from workbench.core.codes.engine_codes import EngineCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, block, number, relation, symbol, zero
from workbench.core.hypotheses import Hypothesis
from workbench.core.numeric_multiples import numeric_multiple
from workbench.core.reasons import Reason
from workbench.core.terms import Apply, Conjunction, Head, Number, Relation, Statement, Symbol, Term, heads_in
from workbench.core.types import PI
from workbench.core.verdict import Counterexample, Evidence, Outcome, Strength, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.language.definitions import replaced
from workbench.language.printing.printer import to_latex

Judge = Callable[[Statement], Verdict]

ARCS = frozenset({"arccos", "arcsin", "arctan", "atan2"})
_BRANCHES = {
    "arccos": r"0 \leq {} \leq \pi",
    "arcsin": r"-\frac{{\pi}}{{2}} \leq {} \leq \frac{{\pi}}{{2}}",
    "arctan": r"-\frac{{\pi}}{{2}} < {} < \frac{{\pi}}{{2}}",
    "atan2": r"-\pi < {} \leq \pi",
}
#: 24π + 0.60…: this angle, its half, third and quarter have the sines and cosines of an angle on every
#: branch.
ELSEWHERE = 76


class _Arc(NamedTuple):
    factor: Fraction
    head: Head
    arguments: tuple[Term, ...]


def holds_arc(statement: Relation) -> bool:
    return _has_arc(statement.left) or _has_arc(statement.right)


def judge_branch(statement: Relation, definitions: Lookup, judge: Judge) -> Verdict:
    """Returns the verdict. Raises NotExact if the inverse function is not alone on its side."""
    if statement.operator == "=":
        sides = [_unfolded(side, definitions) for side in (statement.left, statement.right)]
        if sum(part.head in ARCS for side in sides for part in side.walk() if isinstance(part, Apply)) > 1:
            return _of_several(sides[0], sides[1], definitions, judge)
    left, right = _arc(statement.left), _arc(statement.right)
    others = [s for s, arc in ((statement.left, left), (statement.right, right)) if arc is None]
    inside = [argument for arc in (left, right) if arc is not None for argument in arc.arguments]
    if statement.operator != "=" or any(_has_arc(t) for t in (*others, *inside)):
        raise NotExact(EngineCode.INVERSE_ANGLE())
    if left is not None and right is not None:
        return _of_two(left, right, judge)
    arc, angle = (left, statement.right) if left is not None else (right, statement.left)
    assert arc is not None, "one side holds an arc"
    verdict = judge(_without(arc, angle))
    if verdict.outcome == Outcome.REFUTED and arc.head in ("arccos", "arcsin"):
        return verdict if _in_domain(verdict) else _unchecked(VerdictCode.OUTSIDE_OF_ARC())
    if verdict.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL):
        return verdict
    branch = _BRANCHES[arc.head].format(to_latex(_divided(angle, arc.factor)))
    if not isinstance(angle, Symbol) or definitions.lookup(angle) is not None:
        return _unchecked(VerdictCode.UP_TO_BRANCH(branch=branch))
    value = ELSEWHERE * arc.factor
    name = to_latex(angle)
    kind = str(angle.type)
    witness = Counterexample(
        {name: (str(value),)}, (str(value),), (f"an angle with {branch}",), kinds={name: kind}, kind=kind
    )
    return on_principal_branch(verdict, branch, witness, f"{name} = {value}")


def on_principal_branch(verdict: Verdict, branch: str, witness: Counterexample, elsewhere: str) -> Verdict:
    """Returns the verdict under the condition on the angle. elsewhere: an angle on another branch."""
    return replace(
        verdict,
        outcome=Outcome.CONDITIONAL,
        reason=VerdictCode.ON_PRINCIPAL_BRANCH(),
        hypothesis=Hypothesis.of(branch),
        counterexample=witness,
        evidence=(*verdict.evidence, Evidence("branch", f"{elsewhere} lies on another one")),
        basis=Strength.HINTED,
    )


def _unfolded(side: Term, definitions: Lookup) -> Term:
    """Returns the side with the inverse functions by which its symbols are defined, as far as they are
    addends."""

    def body_of(own: Symbol) -> Term | None:
        body = definitions.lookup(own)
        return (
            body if body is not None and any(_arc(each) for _, each in _addends(body, Fraction(1))) else None
        )

    return side if _arc(side) is not None else replaced(side, body_of)


def _of_several(left: Term, right: Term, definitions: Lookup, judge: Judge) -> Verdict:
    """Returns the verdict on an equation that is linear in its arcs. Raises NotExact for any other."""
    arcs: dict[Term, Fraction] = {}
    rest: list[Term] = []
    signed = (*_addends(left, Fraction(1)), *_addends(right, Fraction(-1)))
    several = len({part.head for _, part in signed if isinstance(part, Apply) and part.head in ARCS}) > 1
    for factor, addend in signed:
        if not (isinstance(addend, Apply) and addend.head in ARCS):
            rest.append(_times(factor, addend))
            continue
        own, turns, arc = _normal(addend, several)
        arcs[arc] = arcs.get(arc, Fraction(0)) + factor * own
        if turns:
            rest.append(_times(factor * turns, symbol(PI)))
    left_over = {arc: factor for arc, factor in arcs.items() if factor}
    if any(map(_has_arc, (*rest, *(part for arc in arcs for part in arc.children)))):
        raise NotExact(EngineCode.INVERSE_ANGLE())
    none = judge(relation("=", apply("add", *rest, zero()), zero())) if rest else None
    is_zero = none is None or none.outcome is Outcome.PROVED
    if not left_over and none is not None:
        is_somewhere = none.outcome is not Outcome.REFUTED or _are_free(arcs, rest, definitions)
        return none if is_somewhere else _unchecked(VerdictCode.OUTSIDE_OF_ARC())
    if not left_over:
        (whole, *_) = arcs
        return judge(
            relation("=", apply("add", whole.children[-1], apply("neg", whole.children[-1])), zero())
        )
    if len(left_over) == 1:
        ((arc, factor),) = left_over.items()
        if is_zero and isinstance(arc, Apply) and arc.head in ("arcsin", "arctan"):
            return judge(relation("=", arc.arguments[0], zero()))
        return judge_branch(
            relation("=", _times(-factor, arc), apply("add", *rest, zero())), definitions, judge
        )
    if len(left_over) == 2 and is_zero:
        (first, factor), (second, minus) = left_over.items()
        one, other = _arc(first), _arc(second)
        assert one is not None and other is not None, "arcs"
        return _of_two(one, other._replace(factor=-minus / factor), judge)
    raise NotExact(EngineCode.TWO_INVERSE_ANGLES())


def _addends(term: Term, factor: Fraction) -> Iterator[tuple[Fraction, Term]]:
    value, inner = numeric_multiple(term)
    if isinstance(inner, Apply) and inner.head == "add":
        for each in inner.arguments:
            yield from _addends(each, factor * value)
    else:
        yield factor * value, inner


def _normal(arc: Apply, several: bool) -> tuple[Fraction, Fraction, Term]:
    """Returns c, n and a simpler arc with arc = c · simpler + n π. several: whether there are arcs of
    other kinds, so that an arc cosine is turned into an arc sine."""
    argument = arc.arguments[-1]
    match argument:
        case Apply(head="neg", arguments=(inner,)) if arc.head in ("arcsin", "arctan", "arccos"):
            plain = apply(arc.head, inner)
            assert isinstance(plain, Apply), "a function of a scalar"
            factor, turns, simpler = _normal(plain, several)
            return -factor, int(arc.head == "arccos") - turns, simpler
        case Apply(head="div", arguments=(Number(value=one), Symbol() as inner)) if arc.head == "arctan":
            if one == 1 and inner.declaration.positive:
                return Fraction(-1), Fraction(1, 2), apply("arctan", inner)
    if arc.head == "arccos" and several:
        return Fraction(-1), Fraction(1, 2), apply("arcsin", argument)
    return Fraction(1), Fraction(0), arc


def _are_free(arcs: dict[Term, Fraction], rest: list[Term], definitions: Lookup) -> bool:
    """True if the arcs have values whatever the values of the other addends are."""
    inside = [arc.children[0] for arc in arcs if isinstance(arc, Apply) and arc.head in ("arccos", "arcsin")]
    outside = {part for term in rest for part in term.walk()}
    return all(
        isinstance(each, Symbol) and each not in outside and definitions.lookup(each) is None
        for each in inside
    )


def _times(factor: Fraction, term: Term) -> Term:
    return term if factor == 1 else apply("mul", number(factor), term)


def _of_two(left: _Arc, right: _Arc, judge: Judge) -> Verdict:
    """Returns the verdict on arccos a = arccos b, which means a = b where both are defined."""
    if left.factor != right.factor or left.head != right.head or left.head == "atan2":
        raise NotExact(EngineCode.TWO_INVERSE_ANGLES())
    verdict = judge(relation("=", left.arguments[0], right.arguments[0]))
    if verdict.outcome == Outcome.REFUTED and left.head != "arctan" and not _in_domain(verdict):
        return _unchecked(VerdictCode.OUTSIDE_OF_ARC())
    return verdict


def _without(arc: _Arc, angle: Term) -> Statement:
    part = _divided(angle, arc.factor)
    cosine, sine = apply("cos", part), apply("sin", part)
    if arc.head == "arccos":
        return relation("=", cosine, arc.arguments[0])
    if arc.head == "arcsin":
        return relation("=", sine, arc.arguments[0])
    if arc.head == "arctan":
        return relation("=", sine, apply("mul", arc.arguments[0], cosine))
    y, x = arc.arguments
    length = apply("norm", block([[x], [y]]))
    parts = ((sine, y), (cosine, x))
    return Conjunction(tuple(relation("=", apply("mul", f, length), value) for f, value in parts))


def _divided(angle: Term, factor: Fraction) -> Term:
    return angle if factor == 1 else apply("mul", number(1 / factor), angle)


def _arc(side: Term) -> _Arc | None:
    factor, arc = numeric_multiple(side)
    return _Arc(factor, arc.head, arc.arguments) if isinstance(arc, Apply) and arc.head in ARCS else None


def _has_arc(term: Term) -> bool:
    return not heads_in(term).isdisjoint(ARCS)


def _in_domain(verdict: Verdict) -> bool:
    """True if the arguments of both sides lie between −1 and 1 at the counterexample."""
    example = verdict.counterexample
    with suppress(ValueError, ZeroDivisionError):
        sides = (*example.left, *example.right) if example is not None else ("2",)
        return all(abs(Fraction(text)) <= 1 for text in sides)
    return False


def _unchecked(reason: Reason) -> Verdict:
    return Verdict(Outcome.UNCHECKED, reason=reason)
