"""Decides equations that are linear in integrals of one kind, or in limits, by what stands below the sign.

    Σ Aᵢ ∫ fᵢ dm = 0    follows from    Σ Aᵢ fᵢ = 0    at each place, for Aᵢ that the integral keeps

Where Σ Aᵢ fᵢ is not 0 at one place, the same values throughout are a counterexample, unless the variable of
the integral stands in fᵢ or the functions are not free.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, relation, with_children, zero
from workbench.core.hypotheses import Hypothesis
from workbench.core.operations import LINEAR
from workbench.core.terms import Apply, Block, Derivative, Integral, Relation, Statement, Symbol, Term, Zero
from workbench.core.types import PI
from workbench.core.verdict import Evidence, Outcome, Strength, Verdict
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.language.definitions import expand, only_turns
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.closed_formulas import is_of_numbers
from workbench.prover.decide.inference import conclusion
from workbench.prover.decide.values_of_integrals import changing_in, with_values


def holds_integral(said: Relation, definitions: Lookup) -> bool:
    """True if an integral or a limit stands in the equation or in a definition that it uses."""
    parts = reached(definitions, said.left, said.right)
    return any(isinstance(part, Integral) for part in parts)


def judge_integrals(
    said: Relation,
    definitions: Lookup,
    judge: Callable[[Statement], Verdict],
    at_once: Callable[[Statement], Verdict],
) -> Verdict:
    """Returns the verdict. Raises NotExact if the equation is not linear in integrals of one kind.

    judge: of what stands below the signs.   at_once: of an equation of values."""
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    valued = [with_values(side, lambda below: judge(below).outcome is Outcome.PROVED) for side in sides]
    if valued != sides and not any(map(_holds, valued)):
        changing = [each for side in sides for each in changing_in(side)]
        left, right = valued
        apart = (left, right) if left != right else (apply("add", left, apply("neg", right)), zero(left.type))
        verdict = at_once(relation("=", *apart))
        if verdict.outcome is Outcome.REFUTED and not is_of_numbers(verdict) and not _has_known_pi(valued):
            return Verdict(Outcome.UNCHECKED, reason=ContextCode.OF_PI())
        return _under_sameness(verdict, changing, sides)
    integrals = {part for side in sides for part in side.walk() if isinstance(part, Integral)}
    if frozenset().union(*map(_degrees, sides)) != {1}:
        raise NotExact("an equation that is not linear in its integrals")
    if len({(each.sign, each.measure) for each in integrals}) > 1:
        return _of_several_kinds(sides, integrals, judge, at_once)
    left, right = map(_bodies, sides)
    if left == right:
        verdict = judge(relation("=", apply("add", left, apply("neg", right)), zero(left.type)))
    else:
        verdict = judge(relation("=", left, right))
    evidence = Evidence(
        "linearity", "what stands below the signs of integration", {"formula": to_latex(said)}
    )
    verdict = replace(verdict, evidence=(*verdict.evidence, evidence))
    if verdict.outcome is Outcome.REFUTED and not _is_free(sides, integrals):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_LINEARITY(), evidence=verdict.evidence)
    return _under_sameness(verdict, _kept(sides), sides)


def _of_several_kinds(
    sides: Sequence[Term],
    integrals: set[Integral],
    judge: Callable[[Statement], Verdict],
    at_once: Callable[[Statement], Verdict],
) -> Verdict:
    """Returns the verdict on an equation between integrals of several kinds, or with several bounds.

    ∫ₐᵇ f is F(b) − F(a), and F is linear in f: the equation follows from those of what belongs to each bound.
    Values that are the same throughout may refute it: ∫ₐᵇ c is c (b − a)."""
    left, right = sides
    whole = apply("add", left, apply("neg", right))
    keys = list(dict.fromkeys(key for each in integrals for key, _ in _ends(each))) or [()]
    verdicts = [judge(relation("=", _belonging_to(whole, key), zero(whole.type))) for key in keys]
    evidence = Evidence(
        "linearity", "what belongs to each bound", {"formula": to_latex(relation("=", *sides))}
    )
    if all(each.outcome is Outcome.PROVED for each in verdicts):
        found = conclusion("linearity", verdicts, (*verdicts[0].evidence, evidence))
        return _under_sameness(found, _kept(list(sides)), sides)
    has_rates = any(isinstance(part, Derivative) for each in integrals for part in each.body.walk())
    if all(map(_has_length, integrals)) and not has_rates and _is_free(list(sides), integrals):
        verdict = at_once(relation("=", _of_constants(whole), zero(whole.type)))
        if verdict.outcome is Outcome.REFUTED:
            return replace(verdict, evidence=(*verdict.evidence, evidence))
    return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_LINEARITY())


def _ends(integral: Integral) -> list[tuple[tuple[object, ...], int]]:
    """Returns the keys of the bounds with their signs; of another sign that of the whole sign."""
    if not _has_length(integral):
        return [((integral.sign, integral.measure), 1)]
    _, lower, upper = integral.place
    return [((integral.measure, upper), 1), ((integral.measure, lower), -1)] if lower != upper else []


def _has_length(integral: Integral) -> bool:
    return integral.sign.startswith("\\int_") and len(integral.place) == 3


def _belonging_to(term: Term, key: tuple[object, ...]) -> Term:
    """Returns the term with the bodies of the integrals that have the bound, with its sign; 0 for others."""
    if isinstance(term, Integral):
        signs = [sign for own, sign in _ends(term) if own == key]
        return zero(term.type) if not signs else term.body if signs[0] > 0 else apply("neg", term.body)
    return with_children(term, lambda child: _belonging_to(child, key))


def _of_constants(term: Term) -> Term:
    """Returns the term with the values of the integrals of what does not change."""
    if isinstance(term, Integral):
        _, lower, upper = term.place
        return apply("mul", apply("add", upper, apply("neg", lower)), term.body)
    return with_children(term, _of_constants)


def _has_known_pi(sides: Sequence[Term]) -> bool:
    """False if π stands outside of sines and the like, where the engines know only that it is not 0."""
    pis = {part for side in sides for part in side.walk() if isinstance(part, Symbol)}
    return all(only_turns(side, pi) for side in sides for pi in pis if pi.declaration.name == PI.name)


def _under_sameness(verdict: Verdict, kept: Sequence[Symbol], sides: Sequence[Term]) -> Verdict:
    """Returns the verdict, if proved, under the condition that symbols are the same throughout."""
    if verdict.outcome is not Outcome.PROVED or not kept:
        return verdict
    variable = next(part.variable for side in sides for part in side.walk() if isinstance(part, Integral))
    said_of = r" \text{ and } ".join(map(to_latex, kept))
    return Verdict(
        Outcome.CONDITIONAL,
        reason=VerdictCode.KEPT_IN_INTEGRAL(),
        hypothesis=Hypothesis.of(rf"{said_of} \text{{ is the same for each }} {variable}"),
        evidence=verdict.evidence,
        basis=Strength.HINTED,
    )


def _degrees(term: Term) -> frozenset[int]:
    """Returns how many integrals the addends of a term multiply. Raises NotExact below another operation."""
    match term:
        case Zero():
            return frozenset()
        case Integral():
            if any(isinstance(part, Integral) for part in term.body.walk()):
                raise NotExact("an integral of an integral")
            return frozenset({1})
        case Apply(head="add") | Block():
            return frozenset().union(*map(_degrees, term.children))
        case Apply(head="div", arguments=(above, below)) if not _holds(below):
            return _degrees(above)
        case Apply(head=head, arguments=arguments) if head in LINEAR and head != "compose":
            found = frozenset({0})
            for each in map(_degrees, arguments):
                found = frozenset(i + j for i in found for j in each)
            return found
    if _holds(term):
        raise NotExact("an equation that is not linear in its integrals")
    return frozenset({0})


def _holds(term: Term) -> bool:
    return any(isinstance(part, Integral) for part in term.walk())


def _bodies(term: Term) -> Term:
    """Returns the term with its integrals replaced by their bodies."""
    if isinstance(term, Integral):
        return term.body
    return with_children(term, _bodies)


def _symbols(term: Term, inside: bool, is_within: bool = False) -> Iterator[Symbol]:
    """Yields the symbols inside of the integrals of a term, or those outside."""
    is_within = is_within or isinstance(term, Integral)
    if isinstance(term, Symbol) and is_within == inside:
        yield term
    for child in term.children:
        yield from _symbols(child, inside, is_within)


def _kept(sides: list[Term]) -> list[Symbol]:
    """Returns the symbols that stand outside of the integrals and inside, and are not constant."""
    within = {each for side in sides for each in _symbols(side, inside=True)}
    outside = dict.fromkeys(each for side in sides for each in _symbols(side, inside=False))
    return [each for each in outside if each in within and not each.declaration.constant]


def _is_free(sides: list[Term], integrals: set[Integral]) -> bool:
    """True if values that are the same throughout may refute the equation."""
    (first, *_) = integrals
    own = [set(side.walk()) for side in sides]
    symbols = [{part for part in parts if isinstance(part, Symbol)} for parts in own]
    names = {each.variable for each in integrals}
    runs = any(to_latex(each) in names or each.declaration.clock for each in symbols[0] | symbols[1])
    has_zero = any(isinstance(side, Zero) for side in sides)
    is_closed = first.sign.startswith("\\oint")
    return bool(symbols[0] & symbols[1]) and not (runs or has_zero or is_closed)
