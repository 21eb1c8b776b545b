"""Well-typed forms of an ill-typed formula after one change of its printing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from workbench.context.claims import Claim
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.terms import Derivative, IllFormed, Relation, Statement, Symbol, sides_of
from workbench.core.verdict import Outcome, Verdict
from workbench.engines.inventory import Lookup
from workbench.language.elaboration.statements import reading_of
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Chain, Lines
from workbench.repair.propose.chain_neighbours import Neighbours
from workbench.repair.terms.changes import Candidate, Change
from workbench.repair.trees.lost_marks import Mark, letter_marks, marked_lines
from workbench.repair.trees.typed_marks import lost_words, stray_relations, type_marks

#: The verdict on a well-typed form that gives the value of a free symbol, and so cannot be tested further.
FITS = Verdict(Outcome.UNCHECKED, reason=VerdictCode.FITS())


def fitting(claim: Claim, beside: Neighbours) -> Iterator[Candidate]:
    """Yields the formula with one change that makes it well-typed; for a step of a chain, also without the
    sign = next to it."""
    try:
        lines = parse(claim.printed.latex)
    except Fault:
        return
    for joined, first in _chains(lines, beside):
        for mark in stray_relations(first):
            yield from _read(claim, mark, joined)
    for mark in type_marks(lines):
        yield from _read(claim, mark, lines)
    for alternatives in letter_marks(lines, claim.notation.symbols):
        for mark in alternatives:
            if mark.kind == "mark":  # the letter in another font, or without an arrow
                yield from _read(claim, mark, lines)


def with_lost_words(claim: Claim) -> Iterator[Candidate]:
    """Yields the formula with a sine or cosine before one of its factors."""
    with suppress(Fault):
        lines = parse(claim.printed.latex)
        for mark in lost_words(lines):
            yield from _read(claim, mark, lines)


def _chains(lines: Lines, beside: Neighbours) -> Iterator[tuple[Lines, Chain]]:
    """Yields the step joined with the previous step, and with the next step."""
    own = _chain(lines)
    for latex, is_before in ((beside.before_latex, True), (beside.behind_latex, False)):
        try:
            other = _chain(parse(latex)) if latex else None
        except Fault:
            continue
        if own is None or other is None:
            continue
        first, second = (other, own) if is_before else (own, other)
        made = Chain(own.at, (*first.sides, *second.sides[1:]), (*first.relations, *second.relations))
        yield Lines(own.at, ((made,),)), made


def _chain(lines: Lines) -> Chain | None:
    match lines.lines:
        case ((Chain() as chain, *_),):
            return chain
    return None


def _read(claim: Claim, mark: Mark, lines: Lines) -> Iterator[Candidate]:
    integers = frozenset(claim.orders.variables if claim.orders else ())
    made = marked_lines([mark], lines)
    try:
        statements = reading_of(made, claim.notation.symbols, integers).statements
    except (Fault, TypeMismatch, IllFormed):
        return
    if len(statements) == 1:
        yield Candidate(statements[0], (Change(mark.kind, mark.description),), latex_of(made), (mark.cost,))


def says_what(statement: Statement, definitions: Lookup, supposed: Sequence[Statement]) -> bool:
    """True if the equation gives the value of a symbol of which nothing else is known."""
    if not (isinstance(statement, Relation) and statement.operator == "="):
        return False
    left = statement.left.body if isinstance(statement.left, Derivative) else statement.left
    if not isinstance(left, Symbol) or definitions.lookup(left) is not None:
        return False
    others = [statement.right, *(side for each in supposed for side in sides_of(each))]
    return left.declaration.name not in {part.declaration.name for term in others for part in term.symbols()}
