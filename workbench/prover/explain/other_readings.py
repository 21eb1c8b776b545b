"""Other readings of a false formula. They change relations, so that no fact can express them."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from typing import TypeGuard

from workbench.context.claims import Claim
from workbench.context.free_symbols import terms_of
from workbench.context.read_formulas import read_statement
from workbench.context.repeated_laws import definitions_in
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, relation, with_children
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_expressions import Linear
from workbench.core.operations import CIRCULAR
from workbench.core.reasons import Reason
from workbench.core.terms import Apply, Power, Relation, Symbol, Term, sides_of
from workbench.core.verdict import Counterexample, Outcome, Verdict
from workbench.engines.inventory.angle_combinations import sum_of_products
from workbench.language.definitions import Definitions, expand, only_turns
from workbench.language.naming.reading_conventions import Relaxation
from workbench.prover.counterexamples.real_angles import AT_REAL_POINT
from workbench.prover.decide.closed_formulas import is_of_numbers
from workbench.prover.decide.mapped_statements import mapped
from workbench.prover.explain.decide_under_facts import Decider
from workbench.prover.explain.judged_parts import differentiates_product

_DECIMAL = re.compile(r"\d*\.(\d+)")


def other_reading(claim: Claim, refuted: Verdict, decider: Decider) -> Reason | None:
    """Returns why the formula may hold as its author reads it, else None."""
    if refuted.counterexample is not None and is_rounded(claim.printed.latex, refuted.counterexample):
        return ContextCode.ROUNDED()
    statement = claim.printed.statement
    if claim.context.span is not None and isinstance(statement, Relation) and statement.operator == "≠":
        return VerdictCode.EQUAL_IN_PLACES()
    if (name := _of_two_indices(claim)) is not None:
        return ContextCode.TWO_INDICES(symbol=name)
    if _holds_nearby(claim, decider):
        return ContextCode.REACH()
    return ContextCode.OF_QUATERNIONS() if _holds_for_quaternions(claim, decider) else None


def without_free_pi(claim: Claim, verdict: Verdict) -> Verdict:
    """Returns the verdict without a counterexample that gives π a value; `unchecked` if it rests on one."""
    has_number = is_of_numbers(verdict) or any(each.method == AT_REAL_POINT for each in verdict.evidence)
    if verdict.counterexample is None or has_number or not _is_of_pi(claim):
        return verdict
    if verdict.outcome is not Outcome.REFUTED:
        return replace(verdict, counterexample=None)
    return Verdict(Outcome.UNCHECKED, reason=ContextCode.OF_PI(), read_back=verdict.read_back)


def is_rounded(latex: str, against: Counterexample) -> bool:
    """True if the sides differ by at most the combined rounding of all decimals, relative to the largest
    entry.

    Half a unit of the last digit is allowed for each decimal. For roots this is a heuristic.
    """
    parts = []
    for found in _DECIMAL.finditer(latex):
        value, half = Fraction(found[0]), Fraction(1, 2 * 10 ** len(found[1]))
        parts.append(half / value if value else half)
    if not parts:
        return False
    try:
        left, right = ([Fraction(entry) for entry in side] for side in (against.left, against.right))
    except ValueError:
        return True
    largest = max(map(abs, (*left, *right)))
    return all(abs(a - b) <= sum(parts) * largest for a, b in zip(left, right, strict=True))


def _of_two_indices(claim: Claim) -> str | None:
    """Returns R_{12} of a family R_n without a definition: it may be the twelfth member, or that of 1 and
    2."""
    assert claim.printed.statement is not None
    for symbol in terms_of(claim.printed.statement):
        if not isinstance(symbol, Symbol):
            continue
        own, (number, *others) = symbol.declaration.name, symbol.index or (Linear(0),)
        is_said = others or not number.is_number or claim.notation.symbols.defined.covers(own, symbol.index)
        if not is_said and int(number) > 9:
            return own.shown(symbol.index)
    return None


def _is_of_pi(claim: Claim) -> bool:
    """True if π occurs where only the cosine and sine of its half are known."""
    definitions = claim.notation.definitions
    assert claim.printed.statement is not None
    facts = definitions_in(claim.context.facts, definitions)
    said = [side for each in (claim.printed.statement, *claim.supposed) for side in sides_of(each)]
    reached = definitions.symbols_in(*said, *(fact.body for fact in facts))
    if not any(definitions.is_pi(each.declaration) for each in reached):
        return False
    own = {each.declaration.name for each in definitions}
    facts = [each for each in facts if each.declaration.name not in own]
    known = Definitions([*definitions, *facts])
    return not all(_has_known_turns(expand(term, known), known) for term in said)


def _has_known_turns(term: Term, definitions: Definitions) -> bool:
    """True if π occurs only in sines and the like of multiples of its half, and multiplies no other angle."""

    def is_pi(part: Term) -> TypeGuard[Symbol]:
        return isinstance(part, Symbol) and definitions.is_pi(part.declaration)

    if not all(only_turns(term, part) for part in term.walk() if is_pi(part)):
        return False
    if isinstance(term, Apply) and term.head in CIRCULAR:
        addends = sum_of_products(term.arguments[0], definitions).items()
        sizes = [
            (factors, size) for factors, size in addends if any(is_pi(p) for f in factors for p in f.walk())
        ]
        return all(len(f) == 1 and is_pi(f[0]) and (2 * size).denominator == 1 for f, size in sizes)
    return not is_pi(term) and all(_has_known_turns(child, definitions) for child in term.children)


def _holds_nearby(claim: Claim, decider: Decider) -> bool:
    """True if the claim holds when d/dt applies to the next factor only."""
    if not differentiates_product(claim.printed):
        return False
    symbols = claim.notation.symbols
    conventions = symbols.conventions.relaxed(Relaxation.RATE_OF_NEXT_FACTOR)
    near = replace(claim.notation, symbols=replace(symbols, conventions=conventions))
    with suppress(ReadError, IllFormedAt, ValueError):
        statement, _ = read_statement(claim.printed.latex, near, claim.orders)
        return statement != claim.printed.statement and decider.holds((), statement)
    return False


def _holds_for_quaternions(claim: Claim, decider: Decider) -> bool:
    """True if the claim holds when vectors are quaternions without a scalar part, with u² = −1."""
    said = claim.printed.statement
    if said is None or not claim.notation.symbols.has_quaternions:
        return False
    squared = mapped(said, lambda r: relation(r.operator, _of_quaternions(r.left), _of_quaternions(r.right)))
    return squared != said and decider.holds((), squared)


def _of_quaternions(term: Term) -> Term:
    """Returns the term with x² = −x·x for each square of a vector."""
    made = with_children(term, _of_quaternions)
    if isinstance(term, Power) and term.base.type.kind == "vector" and term.exponent.is_number:
        return apply("neg", made) if term.exponent.constant % 4 == 2 else made
    return made
