"""Conventions on which the field is divided, as other readings of a false formula.

Each is tried alone, on a refutation only, and only where the model does not choose one of them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from workbench.context.claims import Claim
from workbench.context.facts import Fact
from workbench.context.read_formulas import read_statement
from workbench.core.construct import apply, block, rebuild, relation
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.terms import Apply, Block, Definition, IllFormed, Statement, Symbol, Term
from workbench.core.types import Type
from workbench.language.definitions import Definitions, expand
from workbench.language.naming.reading_conventions import Gradient
from workbench.prover.decide.mapped_statements import mapped
from workbench.prover.explain.decide_under_facts import Decider

#: What a draft lists among its guesses where it has guessed a convention.
_GUESSED = "[conventions]"


@dataclass(frozen=True)
class Alternative:
    """words: what is true then.   other: the formula as it is read then; None where that changes nothing."""

    words: str
    other: Callable[[Claim, Definitions], Statement | None]


def other_convention(claim: Claim, decider: Decider, facts: Sequence[Fact]) -> str | None:
    """Returns the convention of the field by which the claim is true under the facts; None without one."""
    said = [fact.content for fact in facts if isinstance(fact.content, Definition)]
    definitions = Definitions([*claim.notation.definitions, *said])
    for alternative in ALTERNATIVES:
        with suppress(IllFormed, IllFormedAt, ReadError, ValueError):
            other = alternative.other(claim, definitions)
            if other not in (None, claim.printed.statement) and decider.holds(facts, other):
                return alternative.words
    return None


def _jpl(claim: Claim, definitions: Definitions) -> Statement | None:
    """Returns the formula with each product of two quaternions in the other order, definitions unfolded."""
    if not claim.notation.symbols.has_quaternions or _GUESSED not in claim.context.guessed:
        return None
    return _with_terms(claim, _product_of_jpl, definitions)


def _product_of_jpl(term: Term) -> Term:
    if isinstance(term, Apply) and term.head == "mul":
        one, other = (*term.arguments[:1], *term.arguments[-1:])
        if len(term.arguments) == 2 and one.type.kind == other.type.kind == "quaternion":
            return apply("mul", other, one)
    return term


def _turned(claim: Claim, definitions: Definitions) -> Statement | None:
    """Returns the formula with the transpose of each rotation of which a definition speaks, and no frame."""
    parts = (part for each in definitions for part in each.body.walk())
    spoken = {part.declaration for part in parts if isinstance(part, Symbol)}

    def turn(term: Term) -> Term:
        if not isinstance(term, Symbol) or not term.declaration.rotation:
            return term
        is_meant = term.declaration in spoken and term.declaration.name not in claim.notation.framed
        return apply("transpose", term) if is_meant else term

    return _with_terms(claim, turn)


def _perturbed(claim: Claim, definitions: Definitions) -> Statement | None:
    """Returns the formula with each exponential on the other side of the rotation that it multiplies."""
    return _with_terms(claim, _on_the_other_side)


def _on_the_other_side(term: Term) -> Term:
    if isinstance(term, Apply) and term.head == "mul" and len(term.arguments) == 2:
        one, other = term.arguments
        is_alike = one.type == other.type and one.type.kind in ("tensor", "matrix")
        if is_alike and _is_exponential(one) != _is_exponential(other):
            return apply("mul", other, one)
    return term


def _is_exponential(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "exp"


def _twists(claim: Claim, definitions: Definitions) -> Statement | None:
    """Returns the formula with the halves of each column of six, and of each matrix on one, exchanged."""
    return _with_terms(claim, _halves_exchanged)


def _halves_exchanged(term: Term) -> Term:
    if not isinstance(term, Block) or term.type.rows != 6 or term.type not in (Type(6, 1), Type(6, 6)):
        return term
    rows = [list(row) for row in term.entries]
    if len(rows) != 2 or any(len(row) > 2 for row in rows):
        return term
    return block([row[::-1] for row in rows[::-1]])


def _other_gradient(claim: Claim, definitions: Definitions) -> Statement | None:
    """Returns the formula as it is read with gradients that are columns instead of rows, or rows."""
    table = claim.notation.symbols
    given = table.conventions.gradient
    if given is None or _GUESSED not in claim.context.guessed:
        return None
    other = next(each for each in Gradient if each is not given)
    symbols = replace(table, conventions=replace(table.conventions, gradient=other))
    return read_statement(claim.printed.latex, replace(claim.notation, symbols=symbols), claim.orders)[0]


def _with_terms(
    claim: Claim, change: Callable[[Term], Term], definitions: Definitions | None = None
) -> Statement:
    assert claim.printed.statement is not None

    def changed(term: Term) -> Term:
        made = rebuild(term, [changed(child) for child in term.children]) if term.children else term
        return change(made)

    def of(term: Term) -> Term:
        return changed(expand(term, definitions) if definitions is not None else term)

    return mapped(claim.printed.statement, lambda r: relation(r.operator, of(r.left), of(r.right)))


ALTERNATIVES = (
    Alternative("quaternions are multiplied as JPL does (i j = -k)", _jpl),
    Alternative("rotations take columns the other way (the transpose)", _turned),
    Alternative("small rotations act from the other side (left or right perturbation)", _perturbed),
    Alternative("twists have their linear and angular parts in the other order", _twists),
    Alternative("the gradient is the other one of row and column", _other_gradient),
)
