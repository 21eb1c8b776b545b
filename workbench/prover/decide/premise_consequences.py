"""Consequences of premises beyond the ideal that they span.

    x = t ⇒ P(x)    is equivalent to    P(t)

for an x that does not occur in t and is not differentiated: x = t may be a definition of x. A matrix X with
A X B = c I is c A⁻¹ B⁻¹, where det A and det B are not 0. Equal angles have equal sines and
cosines. What lasts has derivatives.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import reduce
from itertools import product

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, identity, number, power, relation, symbol, with_children, zero
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    Derivative,
    Identity,
    IllFormed,
    Implication,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    sides_of,
)
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact, WithDefinitions, reached
from workbench.engines.inventory.assumptions import Assumptions, Unsatisfiable
from workbench.engines.inventory.divisions import never_divides
from workbench.engines.inventory.inventory import has_gradient, take_inventory
from workbench.engines.inventory.prolonged_premises import prolonged
from workbench.language.definitions import expand
from workbench.language.printing.printer import to_latex

#: Function that judges a statement under some assumptions and definitions.
Judge = Callable[[Statement, tuple[Statement, ...], Lookup], Verdict]

#: One of the two functions below.
ByPremise = Callable[[Relation, tuple[Statement, ...], Lookup, Collection[Name], Judge], Verdict | None]

#: A symbol, its value, the matrices that the value inverts, and the identities that show it.
_Solution = tuple[Symbol, Term, list[Term], tuple[Statement, ...]]

_SETTLED = (Outcome.PROVED, Outcome.REFUTED)
#: What is not decided, or not exactly.
_OPEN = (NotExact, IllFormed, Unsatisfiable, ZeroDivisionError)


def judge_by_premise(
    said: Relation,
    assume: tuple[Statement, ...],
    definitions: Lookup,
    bound: Collection[Name],
    judge: Judge,
) -> Verdict | None:
    """Returns the verdict if a premise defines a symbol, or equates angles; else None."""
    with suppress(NotExact, Unsatisfiable, ZeroDivisionError):
        if (found := with_premise_as_definition(said, assume, definitions, bound)) is not None:
            premise, others, known = found
            verdict = judge(said, tuple(others), known)
            if verdict.outcome in _SETTLED:
                return _resting_on(verdict, "put in as a definition", [premise])
    with suppress(*_OPEN):
        turns = equal_sines_and_cosines(said, assume, definitions)
        if turns and not set(turns) <= set(assume):
            verdict = judge(said, (*assume, *turns), definitions)
            if verdict.outcome in _SETTLED:
                return _resting_on(verdict, "equal angles", turns)
    with suppress(*_OPEN):
        return _by_roots(said, assume, definitions, judge)
    return None


def _by_roots(
    said: Relation, assume: tuple[Statement, ...], definitions: Lookup, judge: Judge
) -> Verdict | None:
    """Returns the verdict with x for √u, where the premises give u = x² of a positive symbol x; else None."""
    premises = Assumptions(assume).equations
    known = [part for each in premises for side in (each.left, each.right) for part in side.symbols()]
    sizes = [each for each in dict.fromkeys(known) if each.type == SCALAR and each.declaration.positive]
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    roots = dict.fromkeys(part for side in sides for part in side.walk() if _is_root(part))
    found: dict[Term, Symbol] = {}
    squares: list[Relation] = []
    for root, size in product(roots, sizes):
        square = relation("=", root.children[0], power(size, 2))
        if root not in found and judge(square, assume, definitions).outcome is Outcome.PROVED:
            found[root] = size
            squares.append(square)
    if not found:
        return None
    made = relation("=", *(_with_values(side, found) for side in sides))
    verdict = judge(made, assume, definitions)
    if verdict.outcome is Outcome.DEFINITION:  # x = x, so that the claim is √u = x
        verdict = judge(squares[0], assume, definitions)
    is_open = verdict.outcome not in (*_SETTLED, Outcome.CONDITIONAL)
    return None if is_open else _resting_on(verdict, "roots of squares", squares)


def _is_root(part: Term) -> bool:
    return isinstance(part, Apply) and part.head == "root" and part.children[0].type == SCALAR


def _with_values(term: Term, values: Mapping[Term, Symbol]) -> Term:
    """Returns the term with the values of its parts."""
    return values.get(term) or with_children(term, lambda child: _with_values(child, values))


def judge_by_inverse(
    said: Relation,
    assume: tuple[Statement, ...],
    definitions: Lookup,
    bound: Collection[Name],
    judge: Judge,
) -> Verdict | None:
    """Returns the verdict if a premise can be solved for a free matrix by inverses; else None."""
    for inverse in _inverses(said, assume, definitions, bound):
        with suppress(*_OPEN):
            steps = (judge(each, inverse.apart, definitions) for each in inverse.steps)
            if all(step.outcome is Outcome.PROVED for step in steps):
                known = WithDefinitions(definitions, {inverse.own: inverse.value})
                verdict = judge(said, (*inverse.others, *inverse.apart), known)
                if verdict.outcome in _SETTLED:
                    return _resting_on(verdict, "solved for a matrix", [inverse.premise])
    return None


def _resting_on(verdict: Verdict, how: str, premises: Sequence[Relation]) -> Verdict:
    evidence = Evidence("premise", how, {"formula": ", ".join(map(to_latex, premises))})
    return replace(verdict, evidence=(evidence, *verdict.evidence))


@dataclass(frozen=True)
class _Inverse:
    """A premise that is solved for a free square matrix.

    Attributes:
        own, value: The matrix and its value by the premise.
        others: The other premises.
        apart: What is not 0 by the premise, so that the value is defined.
        steps: Identities that make premise and value equivalent.
    """

    premise: Relation
    own: Symbol
    value: Term
    others: tuple[Relation, ...]
    apart: tuple[Relation, ...]
    steps: tuple[Statement, ...]


def _inverses(
    claim: Relation, assume: Sequence[Statement], definitions: Lookup, bound: Collection[Name]
) -> Iterator[_Inverse]:
    """Yields the premises that are solved for a free matrix: X = A⁻¹, and A X B = c I.

    A matrix that the claim inverts comes last, since its value may be an inverse.
    """
    premises = Assumptions(assume).relations
    parts = {*claim.left.walk(), *claim.right.walk()}
    for place, premise in enumerate(premises):
        others = [*premises[:place], *premises[place + 1 :]]
        for own, value, inverted, steps in sorted(
            _solved(premise), key=lambda solved: apply("inverse", solved[0]) in parts
        ):
            is_free = _is_any(own, bound) and not (
                own.declaration.constant and not is_constant(value, definitions)
            )
            if is_free and _is_undifferentiated(own, value, (claim, *others), definitions):
                apart = tuple(relation("≠", apply("det", each), zero()) for each in inverted)
                yield _Inverse(premise, own, value, tuple(others), apart, steps)


def _solved(premise: Relation) -> Iterator[_Solution]:
    for side, other in ((premise.left, premise.right), (premise.right, premise.left)):
        if premise.operator != "=" or not side.type.is_square or side.type == SCALAR:
            continue
        if isinstance(side, Symbol) and (inverted := _inverted_in(other)):
            yield side, other, inverted, ()
        if isinstance(other, Apply) and other.head == "inverse":
            yield from _solved_inverse(side, other)
        factors = _factors(side)
        if _is_multiple(other) and all(each.type == side.type for each in factors):
            yield from _solved_factors(factors, other)


def _solved_inverse(side: Term, inverse: Apply) -> Iterator[_Solution]:
    """Yields what A = B⁻¹ says by A B = I."""
    (inverted,) = inverse.arguments
    unit = identity(side.type)
    residual = apply("add", apply("mul", side, inverted), apply("neg", unit))
    undone = apply("mul", apply("add", side, apply("neg", inverse)), inverted)
    step = Implication(relation("≠", apply("det", inverted), zero()), relation("=", residual, undone))
    for own, value, around, steps in _solved_factors([*_factors(side), *_factors(inverted)], unit):
        yield own, value, around, (step, *steps)


def _solved_factors(factors: Sequence[Term], multiple: Term) -> Iterator[_Solution]:
    """Yields each symbol that stands once in the product, which is the multiple of I."""
    for place, own in enumerate(factors):
        if isinstance(own, Symbol) and len(factors) > 1 and factors.count(own) == 1:
            yield own, *_solved_product(factors, place, multiple)


def _solved_product(
    factors: Sequence[Term], place: int, multiple: Term
) -> tuple[Term, list[Term], tuple[Statement, ...]]:
    """Returns c A⁻¹ B⁻¹ for A X B = c I, A and B, and the identities that show it: of the residual, of the
    determinants, and of the premise with the value."""
    before, own, behind = factors[:place], factors[place], factors[place + 1 :]
    around = [_product(part) for part in (before, behind) if part]
    value = _product([multiple, *(apply("inverse", part) for part in around)])
    left, right = (_product(part) if part else None for part in (before, behind))
    residual = apply("add", _product(factors), apply("neg", multiple))
    undone = _product(
        [
            *([apply("inverse", left)] if left else []),
            residual,
            *([apply("inverse", right)] if right else []),
        ]
    )
    steps = (
        relation("=", apply("add", own, apply("neg", value)), undone),
        relation("=", apply("det", _product(factors)), _product([apply("det", each) for each in factors])),
        relation("=", _product([*before, value, *behind]), multiple),
    )
    return value, around, steps


def _inverted_in(value: Term) -> list[Term]:
    """Returns the matrices that the value inverts; none if it divides by anything else."""
    parts = list(value.walk())
    inverted = [part.arguments[0] for part in parts if isinstance(part, Apply) and part.head == "inverse"]
    others = [part for part in parts if not (isinstance(part, Apply) and part.head == "inverse")]
    is_known = all(map(never_divides, others)) and all(each.type.is_square for each in inverted)
    return inverted if is_known and all(each.type != SCALAR for each in inverted) else []


def _factors(term: Term) -> list[Term]:
    if isinstance(term, Apply) and term.head == "mul":
        return [factor for part in term.arguments for factor in _factors(part)]
    return [term]


def _is_multiple(term: Term) -> bool:
    """True for c I of a number c other than 0."""
    *numbers, last = _factors(term)
    return isinstance(last, Identity) and all(isinstance(each, Number) and each.value for each in numbers)


def _product(factors: Sequence[Term]) -> Term:
    return reduce(lambda left, right: apply("mul", left, right), factors)


def _is_undifferentiated(
    own: Symbol, value: Term, relations: Sequence[Relation], definitions: Lookup
) -> bool:
    """True if the symbol stands in the relations, without a rate of it, and not in its value."""
    sides = [side for r in relations for side in (r.left, r.right)]
    orders = take_inventory(sides, definitions).orders  # orders of the free symbols
    return orders.get(own) == 0 and own not in take_inventory([value], definitions).orders


def with_premise_as_definition(
    claim: Relation, assume: Sequence[Statement], definitions: Lookup, bound: Collection[Name]
) -> tuple[Relation, list[Relation], Lookup] | None:
    """Returns the claim with the first premise x = t that can define x, the other premises, and the
    definitions.

    bound: the names of symbols that are not free.
    """
    premises = Assumptions(assume).relations
    for place, premise in enumerate(premises):
        others = [*premises[:place], *premises[place + 1 :]]
        for own, value in _said(premise):
            if premise.operator != "=" or not isinstance(own, Symbol) or not _is_any(own, bound):
                continue
            if own.type != value.type or not _is_total(value, definitions):
                continue
            if own.declaration.constant and not is_constant(value, definitions):
                continue
            if _is_undifferentiated(own, value, (claim, *others), definitions):
                return premise, others, WithDefinitions(definitions, {own: value})
    return None


def equal_sines_and_cosines(
    claim: Relation, assume: Sequence[Statement], definitions: Lookup
) -> list[Relation]:
    """Returns the equal sines and cosines of both sides of premises that equate angles of the claim."""
    premises = [premise for premise in Assumptions(assume).equations if premise.left.type == SCALAR]
    angles = set(take_inventory((claim.left, claim.right), definitions).angles)
    found = []
    for premise in premises:
        own = take_inventory((premise.left, premise.right), definitions)
        if angles.intersection(own.orders) and not own.angles:
            found += [
                relation("=", *(apply(head, side) for side in (premise.left, premise.right)))
                for head in ("sin", "cos")
            ]
    return found


def _said(premise: Relation) -> Iterator[tuple[Term, Term]]:
    """Yields pairs of a possible symbol and its value; a vector of length 1 is given as a unit vector."""
    sides = premise.left, premise.right
    yield from (sides, sides[::-1])
    for part in dict.fromkeys((*premise.left.walk(), *premise.right.walk())):
        if isinstance(part, Symbol) and part.type == VECTOR and number(1) in sides:
            length, squared = apply("norm", part), apply("mul", apply("transpose", part), part)
            lengths = (length, power(length, 2), power(part, 2), apply("dot", part, part), squared)
            if any(each in sides for each in lengths):
                yield part, symbol(part.declaration.with_flags(unit=True), part.index)


def _is_any(term: Term, bound: Collection[Name]) -> bool:
    """True for a symbol without further properties, perhaps constant or free."""
    if not isinstance(term, Symbol):
        return False
    said = term.declaration.with_flags(free=False)
    plain = Declaration(said.name, said.type, said.weight)
    return said in (plain, plain.with_flags(constant=True)) and said.name not in bound


def is_constant(value: Term, definitions: Lookup) -> bool:
    """True if all undefined symbols of the value are constant."""
    free = (part for part in reached(definitions, value) if isinstance(part, Symbol))
    return all(part.declaration.constant or definitions.lookup(part) is not None for part in free)


def _is_total(value: Term, definitions: Lookup) -> bool:
    """True if the value is defined for all values of its symbols. Only the derivatives of a norm may be
    undefined."""
    parts = list(reached(definitions, value))
    is_still = not any(isinstance(part, Derivative | TimeOperator) for part in parts)
    return all(never_divides(p) or (is_still and isinstance(p, Apply) and p.head == "norm") for p in parts)


def unless_lasting(
    refuted: Verdict,
    claim: Statement,
    premises: Sequence[Statement],
    definitions: Lookup,
    judge: Callable[[Statement, tuple[Statement, ...]], Verdict],
) -> Verdict:
    """Returns the verdict on a claim that is refuted under premises at the instant.

    It stays refuted only if it is refuted under their derivatives, too: else its author has to state which is
    meant. judge: of the claim, under the premises with more of them.
    """
    moving = [p for p in premises if not all(is_constant(side, definitions) for side in sides_of(p))]
    try:
        if not (further := prolonged(moving, claim, definitions)):
            return refuted
        again = judge(claim, (*premises, *further))
        if again.outcome is Outcome.REFUTED:
            return again
    except Unsatisfiable:
        return refuted  # t = 0 holds at one instant
    except (NotExact, IllFormed):
        pass
    code = VerdictCode.AT_ONE_PLACE if has_gradient(sides_of(claim)) else VerdictCode.AT_ONE_INSTANT
    return Verdict(Outcome.UNCHECKED, reason=code())
