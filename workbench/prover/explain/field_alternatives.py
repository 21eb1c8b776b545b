"""Conventions on which the field is divided, as other readings of a false formula.

Each is tried alone, on a refutation only, and only where the model does not choose one of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from workbench.context.claims import Claim, Formula
from workbench.context.facts import Fact
from workbench.context.read_formulas import read_statement
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.construct import apply, block, relation, with_children
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.reasons import Reason
from workbench.core.terms import (
    Apply,
    Block,
    Definition,
    IllFormed,
    Relation,
    Statement,
    Symbol,
    Term,
    sides_of,
)
from workbench.core.types import Declaration, Type
from workbench.core.verdict import Outcome, Verdict
from workbench.language.definitions import Definitions, expand
from workbench.language.naming.reading_conventions import Gradient
from workbench.prover.decide.mapped_statements import mapped
from workbench.prover.explain.decide_under_facts import Decider, JudgeOf, judged_alone

#: What a draft lists among its guesses where it has guessed a convention.
_GUESSED, _GUESSED_FRAMES = "[conventions]", "[frames]"

#: The doubts about conventions that are tried where a draft has guessed them.
OF_GUESSES = frozenset(
    (DoubtCode.QUATERNIONS_OF_JPL, DoubtCode.OTHER_GRADIENT, DoubtCode.OTHER_DOTS),
)


@dataclass(frozen=True)
class Known:
    """The definitions under which a claim is refuted, and the symbols of which a definition or the text
    speaks."""

    definitions: Definitions
    spoken: frozenset[Declaration]


@dataclass(frozen=True)
class Alternative:
    """doubt: what is true then.   others: the formula as it is read then, for each choice that there is."""

    doubt: DoubtCode
    others: Callable[[Claim, Known], Iterator[Statement]]


def other_convention(claim: Claim, decider: Decider, facts: Sequence[Fact]) -> Reason | None:
    """Returns the convention of the field by which the claim is true under the facts; None without one."""
    known = _known(claim, facts)
    for alternative in ALTERNATIVES:
        with suppress(IllFormed, IllFormedAt, ReadError, ValueError):
            for other in alternative.others(claim, known):
                if other != claim.printed.statement and decider.holds(facts, other):
                    return alternative.doubt()
    return None


def _known(claim: Claim, facts: Sequence[Fact]) -> Known:
    said = [fact.content for fact in facts if isinstance(fact.content, Definition)]
    bodies = [each.body for each in (*claim.notation.definitions, *said)]
    equations = [fact.content for fact in facts if isinstance(fact.content, Relation)]
    terms = [*bodies, *(side for equation in equations for side in sides_of(equation))]
    symbols = (part for term in terms for part in term.symbols())
    return Known(
        Definitions([*claim.notation.definitions, *said]), frozenset(part.declaration for part in symbols)
    )


def _jpl(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula with each product of two quaternions in the other order, definitions unfolded."""
    if claim.notation.symbols.has_quaternions and _GUESSED in claim.context.guessed:
        yield _with_terms(claim, _product_of_jpl, known.definitions)


def _product_of_jpl(term: Term) -> Term:
    if isinstance(term, Apply) and term.head == "mul":
        one, other = (*term.arguments[:1], *term.arguments[-1:])
        if len(term.arguments) == 2 and one.type.kind == other.type.kind == "quaternion":
            return apply("mul", other, one)
    return term


def _turned(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula with the transpose of each rotation that is spoken of and no frame."""

    def turn(term: Term) -> Term:
        if not isinstance(term, Symbol) or not term.declaration.rotation:
            return term
        is_meant = term.declaration in known.spoken and term.declaration.name not in claim.notation.framed
        return apply("transpose", term) if is_meant else term

    yield _with_terms(claim, turn)


def _perturbed(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula with each exponential on the other side of the rotation that it multiplies."""
    yield _with_terms(claim, lambda term: _on_the_other_side(term, _is_exponential))


def _rated(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula with the skew tensor of an angular velocity that the text defines on the other side
    of the rotation that it multiplies."""

    def is_spin(term: Term) -> bool:
        if not isinstance(term, Apply) or term.head != "skew":
            return False
        own = list(term.symbols())
        return any(known.definitions.about(s) != claim.notation.definitions.about(s) for s in own)

    yield _with_terms(claim, lambda term: _on_the_other_side(term, is_spin))


def _on_the_other_side(term: Term, is_factor: Callable[[Term], bool]) -> Term:
    if isinstance(term, Apply) and term.head == "mul" and len(term.arguments) == 2:
        one, other = term.arguments
        is_alike = one.type == other.type and one.type.kind in ("tensor", "matrix")
        if is_alike and is_factor(one) != is_factor(other):
            return apply("mul", other, one)
    return term


def _is_exponential(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "exp"


def _twists(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula with the halves of each column of six, and of each matrix on one, exchanged."""
    yield _with_terms(claim, _halves_exchanged)


def _halves_exchanged(term: Term) -> Term:
    if not isinstance(term, Block) or term.type.rows != 6 or term.type not in (Type(6, 1), Type(6, 6)):
        return term
    rows = [list(row) for row in term.entries]
    if len(rows) != 2 or any(len(row) > 2 for row in rows):
        return term
    return block([row[::-1] for row in rows[::-1]])


def _other_gradient(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula read with gradients as columns instead of rows, or as rows instead of columns."""
    conventions = claim.notation.symbols.conventions
    if conventions.gradient is not None and _GUESSED in claim.context.guessed:
        other = next(each for each in Gradient if each is not conventions.gradient)
        yield _read_again(claim, conventions=replace(conventions, gradient=other))


def with_other_gradient(claim: Claim, ill_formed: Verdict, judge_of: JudgeOf) -> Verdict:
    """Returns the verdict, which names the other gradient if the formula is well-formed and true with it."""
    with suppress(IllFormed, IllFormedAt, ReadError, ValueError):
        for other in _other_gradient(claim, Known(claim.notation.definitions, frozenset())):
            meant = replace(claim, printed=Formula(claim.printed.latex, other))
            if judged_alone(meant, judge_of).outcome is Outcome.PROVED:
                return replace(ill_formed, unless=(*ill_formed.unless, DoubtCode.OTHER_GRADIENT()))
    return ill_formed


def _other_dots(claim: Claim, known: Known) -> Iterator[Statement]:
    """Yields the formula as it is read with dots that differentiate in another frame."""
    frames = claim.notation.symbols.frames
    if frames.dot is not None and _GUESSED_FRAMES in claim.context.guessed:
        for frame in frames.velocities:
            if frame != frames.dot:
                yield _read_again(claim, frames=replace(frames, dot=frame))


def _read_again(claim: Claim, **settings: Any) -> Statement:
    symbols = replace(claim.notation.symbols, **settings)
    return read_statement(claim.printed.latex, replace(claim.notation, symbols=symbols), claim.orders)[0]


def _with_terms(
    claim: Claim, change: Callable[[Term], Term], definitions: Definitions | None = None
) -> Statement:
    assert claim.printed.statement is not None

    def changed(term: Term) -> Term:
        return change(with_children(term, changed))

    def of(term: Term) -> Term:
        return changed(expand(term, definitions) if definitions is not None else term)

    return mapped(claim.printed.statement, lambda r: relation(r.operator, of(r.left), of(r.right)))


ALTERNATIVES = (
    Alternative(DoubtCode.QUATERNIONS_OF_JPL, _jpl),
    Alternative(DoubtCode.TRANSPOSED_ROTATIONS, _turned),
    Alternative(DoubtCode.OTHER_PERTURBATION, _perturbed),
    Alternative(DoubtCode.OTHER_JACOBIAN, _rated),
    Alternative(DoubtCode.OTHER_TWISTS, _twists),
    Alternative(DoubtCode.OTHER_GRADIENT, _other_gradient),
    Alternative(DoubtCode.OTHER_DOTS, _other_dots),
)
