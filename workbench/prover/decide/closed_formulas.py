"""Equations of numbers: without symbols other than π, and equations that fail wherever numbers are put in."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, number, relation
from workbench.core.terms import (
    Apply,
    Derivative,
    IllFormed,
    Integral,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    sides_of,
)
from workbench.core.types import SCALAR, Declaration
from workbench.core.verdict import Counterexample, EngineDisagreement, Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.polynomial.closed_numbers import exactly_equal, surely_apart
from workbench.language.definitions import Definitions, expand, replaced
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.inference import agreement
from workbench.prover.decide.inverse_trigonometry import ARCS

#: The method in the evidence of verdicts on numbers.
NUMBERS = "numbers in balls (Arb)"
_LARGEST = 2000
#: Points at which an equation is tried, and the fewest at which it is defined and fails.
_TRIES, _FEWEST = 24, 4
_NUMERATORS, _DENOMINATORS = (2, 3, 5, 7, 4), (11, 13, 17, 19, 23, 29, 31)


def judge_closed(
    said: Statement, assume: Sequence[Statement], definitions: Lookup, second_engine: bool = True
) -> Verdict | None:
    """Returns the verdict on an equation of numbers under true premises; None if it contains symbols or is
    undecided.

    Without the second engine nothing is proved.
    """
    if not isinstance(definitions, Definitions) or not all(_holds(each, definitions) for each in assume):
        return None
    verdict = _of_relation(said, definitions) if isinstance(said, Relation) and said.operator == "=" else None
    if verdict is not None and verdict.outcome is Outcome.PROVED and not second_engine:
        return Verdict(
            Outcome.PROBABLE, reason=VerdictCode.SECOND_ENGINE_LEFT_OUT(), evidence=verdict.evidence[:1]
        )
    return verdict


def _holds(premise: Statement, definitions: Definitions) -> bool:
    if not isinstance(premise, Relation) or premise.operator == "≈":
        return False
    verdict = _of_relation(premise, definitions)
    wanted = Outcome.PROVED if premise.operator == "=" else Outcome.REFUTED
    return verdict is not None and verdict.outcome is wanted


def _of_relation(said: Relation, definitions: Definitions) -> Verdict | None:
    """Returns the verdict on the equation of its sides."""
    sides = (said.left, said.right)
    if not all(_is_number(part, definitions) for part in definitions.reached(*sides)):
        return None
    with suppress(NotExact, IllFormed, ZeroDivisionError):
        numbers = relation("=", *(expand(side, definitions) for side in sides))
        walk = chain(numbers.left.walk(), numbers.right.walk())
        return None if any(True for _ in islice(walk, _LARGEST, None)) else _judged(numbers)
    return None


def refuted_at_numbers(said: Statement, assume: Sequence[Statement], definitions: Lookup) -> Verdict | None:
    """Returns the refutation of an equation of inverse functions that fails at each of several points where
    it is defined; else None.

    One point is not enough: at it another branch of an inverse function may be meant.
    """
    if not isinstance(definitions, Definitions) or not isinstance(said, Relation) or said.operator != "=":
        return None
    premises = [each for each in assume if isinstance(each, Relation) and each.operator in "≠="]
    if len(premises) < len(assume):
        return None
    apart = [relation(each.operator, *(expand(s, definitions) for s in sides_of(each))) for each in premises]
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    is_given = any(each.operator == "=" for each in apart)
    (claim, *apart), is_solved = _without_assigned([relation("=", *sides), *apart])
    if not is_solved:
        return None
    sides = [claim.left, claim.right]
    parts = {
        part for side in (*sides, *(s for each in apart for s in sides_of(each))) for part in side.walk()
    }
    symbols = {part for part in parts if isinstance(part, Symbol)}
    free = sorted((each for each in symbols if not definitions.is_pi(each.declaration)), key=to_latex)
    has_arc = any(isinstance(part, Apply) and part.head in ARCS for part in parts)
    if not (free and has_arc and all(map(_takes_numbers, {*free, *(parts - symbols)}))):
        return None
    found: list[Verdict] = []
    for count in range(_TRIES):
        point = {each: _coordinate(each, place, count) for place, each in enumerate(free)}
        with suppress(NotExact, IllFormed, ZeroDivisionError):
            if not all(surely_apart(_at(each, point)) for each in apart):
                continue
            numbers = _at(relation("=", *sides), point)
            if (shown := surely_apart(numbers)) is None or (is_given and not _on_no_branch(numbers)):
                return None
            found.append(_with_point(_refuted(numbers, shown), point))
    return found[0] if len(found) >= _FEWEST else None


def _on_no_branch(numbers: Relation) -> bool:
    """True if the sides differ as angles, too, whichever branches of inverse functions are meant.

    Premises may lead away from the principal branch."""
    if numbers.left.type != SCALAR:
        return False
    turned = (apply("neg", numbers.right), numbers.right)
    sums = (apply("sin", apply("add", numbers.left, each)) for each in turned)
    return all(surely_apart(relation("≠", each, number(0))) is not None for each in sums)


def _without_assigned(said: Sequence[Relation]) -> tuple[list[Relation], bool]:
    """Returns the first relation and the disequations with the values of symbols that equations assign, and
    whether no other equation is left. v ≠ v + 1 is one of them for each value v, so that it is defined.
    """
    claim, *premises = said
    while True:
        assigned = (
            (premise, own, value)
            for premise in premises
            if premise.operator == "="
            for own, value in ((premise.left, premise.right), (premise.right, premise.left))
            if isinstance(own, Symbol) and _takes_numbers(own) and not own.declaration.positive
            if own not in value.walk()
        )
        if (found := next(assigned, None)) is None:
            return [claim, *premises], all(each.operator == "≠" for each in premises)
        premise, own, value = found
        defined = relation("≠", value, apply("add", value, number(1)))

        def put(each: Relation, own: Term = own, value: Term = value) -> Relation:
            sides = (replaced(s, lambda part: value if part == own else None) for s in sides_of(each))
            return relation(each.operator, *sides)

        claim, premises = put(claim), [*(put(each) for each in premises if each is not premise), defined]


def _refuted(numbers: Relation, sides: tuple[tuple[str, ...], tuple[str, ...]]) -> Verdict:
    from workbench.engines.jet.closed_values import nearly_equal

    if nearly_equal(numbers):
        raise EngineDisagreement(f"a value of one engine only: {to_latex(numbers)}")
    evidence = (
        Evidence(NUMBERS, "the two sides differ"),
        Evidence("SymPy, 60 digits", "the two sides differ"),
    )
    return Verdict(Outcome.REFUTED, counterexample=Counterexample({}, *sides), evidence=evidence)


def _takes_numbers(part: Term) -> bool:
    """True for a free scalar without properties that numbers may lack, and for operations on numbers."""
    if isinstance(part, Symbol):
        plain = Declaration(part.declaration.name, SCALAR)
        said = part.declaration.with_flags(positive=False, constant=False, free=False, independent=False)
        return replace(said, weight=None, of=()) == plain and not part.index
    return not isinstance(part, Derivative | TimeOperator | Integral)


def _coordinate(symbol: Symbol, place: int, count: int) -> Fraction:
    """Returns a number below 3; the first points are near 0, and positive."""
    value = Fraction(_NUMERATORS[(place + count) % 5], _DENOMINATORS[(3 * place + count) % 7])
    is_negative = count % 3 == 2 and (place + count) % 2 and not symbol.declaration.positive
    return (-value if is_negative else value) * (3 if count > 5 else 1)


def _at(premise: Relation, point: Mapping[Symbol, Fraction]) -> Relation:
    """Returns the relation with the coordinates of the point."""

    def value(symbol: Symbol) -> Term | None:
        return number(point[symbol]) if symbol in point else None

    return relation(premise.operator, *(replaced(side, value) for side in (premise.left, premise.right)))


def _with_point(verdict: Verdict, point: Mapping[Symbol, Fraction]) -> Verdict:
    assert verdict.counterexample is not None, "a refutation"
    values = {to_latex(each): (str(value),) for each, value in point.items()}
    kinds = {to_latex(each): str(each.type) for each in point}
    return replace(verdict, counterexample=replace(verdict.counterexample, values=values, kinds=kinds))


def _is_number(part: Term, definitions: Definitions) -> bool:
    if not isinstance(part, Symbol) or definitions.about(part):
        return True
    return definitions.is_pi(part.declaration)


def _judged(numbers: Relation) -> Verdict | None:
    from workbench.engines.jet.closed_values import nearly_equal

    sides = surely_apart(numbers)
    if sides is None and not exactly_equal(numbers):
        return None
    if sides is not None:
        return _refuted(numbers, sides)
    if not nearly_equal(numbers):
        raise EngineDisagreement(f"a value of one engine only: {to_latex(numbers)}")
    evidence = (
        Evidence("cyclotomic field (FLINT)", "residual is 0"),
        Evidence("SymPy", "60 digits agree"),
    )
    return agreement(*evidence, evidence)


def is_of_numbers(verdict: Verdict) -> bool:
    """True for a verdict on an equation of numbers."""
    return any(evidence.method == NUMBERS for evidence in verdict.evidence)
