"""Formulas of a text that contradict others: another formula for the same symbol, or Lagrange's equations."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from time import process_time
from typing import TypeVar

from workbench.context.claims import Claim
from workbench.context.facts import Act
from workbench.context.introducing_words import is_denied, is_supposed
from workbench.context.read_formulas import read_statement
from workbench.core.codes.context_codes import ContextCode
from workbench.core.construct import relation
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_expressions import Linear
from workbench.core.reasons import Reason
from workbench.core.terms import Derivative, IllFormed, Power, Relation, Statement, Symbol, Term, sides_of
from workbench.language.definitions import Definitions, replaced
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.texts.text_paper import TextPaper
from workbench.repair.propose.usual_changes import Nearness, Points, nearness, usual_changes
from workbench.source.documents import Display
from workbench.source.documents.condition_words import (
    APPROXIMATES,
    OF_CASE,
    OF_VALUES,
    REPLACES,
    in_last_sentence,
)

_SECONDS, _SECONDS_OF_ONE = 2.0, 0.5
#: Words before a display for a case of its own.
_CASE = in_last_sentence(OF_CASE, OF_VALUES, REPLACES, APPROXIMATES)
#: (a, b, c)^T.
_COLUMN = re.compile(
    r"\((?P<cells>[^(),]+(?:,[^(),]+)+)\)\s*\^\s*\{?\s*(?:T|\\top|\\(?:mathsf|mathrm)\s*\{?\s*T\s*\}?)\s*\}?"
)
#: How far behind a display its sentence may go on.
_LINES_OF_SENTENCE = 5
#: Names of Lagrangians.
_KINETIC, _POTENTIAL = frozenset("TK"), frozenset("VUP")
_LAGRANGIANS = re.compile(r"L|\\mathcal\{L\}|\\mathscr\{L\}|\\ell|\\Lambda")


@dataclass(frozen=True)
class Contradiction:
    """A formula of a text that another one contradicts.

    Attributes:
        claim: The id of the formula.
        statement, assume: What would hold if the formula did.
        known: The definitions of its symbols.
        reason: The other formula.
    """

    claim: str
    statement: Statement
    assume: tuple[Statement, ...]
    known: Definitions
    reason: Reason


@dataclass(frozen=True)
class _Equation:
    """A formula for a symbol or a rate that stands alone on its left. claim: None in a sentence."""

    statement: Relation
    claim: Claim | None
    line: int


def contradictions_in(ingested: Ingested, paper: TextPaper) -> tuple[Contradiction, ...]:
    """Returns the formulas that contradict another one, if one usual change corrects them."""
    return (*_other_formulas(ingested, paper), *_against_lagrangians(ingested, paper))


def _other_formulas(ingested: Ingested, paper: TextPaper) -> Iterator[Contradiction]:
    end = process_time() + _SECONDS
    groups: dict[Term, list[_Equation]] = {}
    for equation in _equations(ingested, paper):
        groups.setdefault(equation.statement.left, []).append(equation)
    known = paper.notation.definitions
    for left, group in groups.items():
        while len(group) > 1 and process_time() < end:
            first, *rest = group
            same = [first] + [each for each in rest if _both(each, first, known) is Nearness.HOLDS]
            others = [each for each in group if each not in same]
            near = [each for each in others if _both(each, first, known) is Nearness.NEAR]
            if near:
                votes = [_votes(each, paper, known) for each in (first, near[0])]
                is_first = (1, votes[1], near[0].claim is None) > (len(same), votes[0], False)
                wrong, right = (first, near[0]) if is_first else (near[0], first)
                is_told = votes[0] != votes[1] or len(same) > 1 or _stands_before(right, wrong)
                if is_told and wrong.claim is not None:
                    yield _between(wrong, right, left, known)
            group = others


def _stands_before(right: _Equation, wrong: _Equation) -> bool:
    """True if the right formula is a display before the other, or a sentence goes on with it."""
    if right.claim is None:
        return wrong.line < right.line <= wrong.line + _LINES_OF_SENTENCE
    return right.line < wrong.line


def _between(wrong: _Equation, right: _Equation, left: Term, known: Definitions) -> Contradiction:
    assert wrong.claim is not None
    both = relation("=", right.statement.right, wrong.statement.right)
    said = f"${to_latex(right.statement)}$ (line {right.line})"
    reason = ContextCode.GIVEN_OTHERWISE(symbol=f"${to_latex(left)}$", facts=said)
    return Contradiction(wrong.claim.id, both, wrong.claim.supposed, known, reason)


def _both(later: _Equation, earlier: _Equation, known: Definitions) -> Nearness:
    """Returns whether two formulas give the same, or do after a change of the later one."""
    try:
        both = relation("=", earlier.statement.right, later.statement.right)
    except IllFormed:
        return Nearness.OPEN
    return nearness(both, known, seconds=_SECONDS_OF_ONE)


def _votes(equation: _Equation, paper: TextPaper, known: Definitions) -> int:
    """Returns the number of other formulas that hold if this one does."""
    left, right = equation.statement.left, equation.statement.right
    count = 0
    for claim in paper.claims:
        said = claim.printed.statement
        if not isinstance(said, Relation) or said.left == left or claim is equation.claim:
            continue
        sides = [replaced(side, {left: right}.get) for side in sides_of(said)]
        if sides != [said.left, said.right]:
            facts = claim.context.facts
            own = [fact.content for fact in facts if fact.act is Act.CONSTRAIN]
            given = (each for each in own if isinstance(each, Relation) and each.left != left)
            points = Points(Relation(said.operator, sides[0], sides[1]), known, (*claim.supposed, *given))
            count += points.has_value() and points.vanishes()
    return count


def _equations(ingested: Ingested, paper: TextPaper) -> Iterator[_Equation]:
    for claim in paper.claims:
        said, display = claim.printed.statement, display_of(claim, ingested)
        if not isinstance(said, Relation) or claim.assume or display is None:
            continue
        if _CASE.search(display.before):
            continue
        if not claim.chain and _is_alone(said, claim.notation.definitions):
            yield _Equation(said, claim, claim.line)
    for formula, read in equations_of_sentences(ingested, paper):
        if _is_alone(read, paper.notation.definitions):
            yield _Equation(read, None, formula.line)


def equations_of_sentences(ingested: Ingested, paper: TextPaper) -> Iterator[tuple[Display, Relation]]:
    """Yields the equations that sentences state, with a column for (a, b, c)^T behind a matrix."""
    for formula in ingested.text.inline:
        if formula.latex.count("=") == 1 and not (is_denied(formula) or is_supposed(formula)):
            latex = _COLUMN.sub(lambda match: _column(match["cells"]), formula.latex)
            with suppress(ReadError, IllFormedAt, IllFormed):
                read, _ = read_statement(latex, paper.notation, None)
                if isinstance(read, Relation):
                    yield formula, read


def _column(cells: str) -> str:
    return rf"\begin{{bmatrix}} {cells.replace(',', chr(92) * 2)} \end{{bmatrix}}"


def _is_alone(said: Relation, known: Definitions) -> bool:
    """True for an equation for a symbol that nothing defines, for its square, or for a rate."""
    own = said.left
    while isinstance(own, Derivative | Power):
        own = own.children[0]
    is_free = isinstance(own, Symbol) and (isinstance(said.left, Derivative) or known.lookup(own) is None)
    return said.operator == "=" and is_free and any(isinstance(part, Symbol) for part in said.right.walk())


def display_of(claim: Claim, ingested: Ingested) -> Display | None:
    """Returns the display of a claim."""
    span = claim.context.span
    behind = (
        each
        for each in reversed(ingested.text.displays)
        if span is not None and each.source.path == span.file and each.line <= span.line
    )
    return next(behind, None)


def _against_lagrangians(ingested: Ingested, paper: TextPaper) -> Iterator[Contradiction]:
    """Yields the equations of motion that do not follow from the Lagrangian of the text, but do after one
    change."""
    end = process_time() + _SECONDS
    defined = [each.name for each in ingested.definitions if each.sure]
    names = {name for name in defined if _LAGRANGIANS.fullmatch(name)}
    if not names:
        pairs = ((one, other) for one in defined for other in defined)
        names = {f"({one} - {other})" for one, other in pairs if one in _KINETIC and other in _POTENTIAL}
    for claim in paper.claims if names else ():
        said = claim.printed.statement
        if not isinstance(said, Relation) or claim.chain or claim.assume:
            continue
        second = {
            part.body
            for side in sides_of(said)
            for part in side.walk()
            if isinstance(part, Derivative) and part.order == Linear(2) and isinstance(part.body, Symbol)
        }
        for name in names:
            made = [each for own in second for each in _lagrange(name, own, claim)]
            made = [each for each in made if each.statement != said]
            if made and process_time() < end and (found := _missed(made, end)) is not None:
                yield found


def _lagrange(name: str, own: Symbol, claim: Claim) -> Iterator[Contradiction]:
    """Yields Lagrange's equation for a coordinate.

    Each symbol that the Lagrangian lacks is tried as the force.
    """
    notation, q = claim.notation, str(own.declaration.name)
    given = notation.definitions
    energies = re.sub(r"[()]", "", name).split(" - ")
    of_lagrangian = [each for each in given if str(each.declaration.name) in energies]
    parts = [part for each in of_lagrangian for part in given.reached(each.body)]
    moving = {
        str(p.declaration.name) for part in parts if isinstance(part, Derivative) for p in part.body.symbols()
    }
    inside = {str(part.declaration.name) for part in parts if isinstance(part, Symbol)}
    if q not in moving:
        return
    said = claim.printed.parsed
    outside = {
        str(part.declaration.name)
        for side in sides_of(said)
        for part in side.symbols()
        if part.type.kind == "scalar" and str(part.declaration.name) not in inside
    }
    slopes = (rf"\frac{{\partial {name}}}{{\partial {by}}}" for by in (rf"\dot{{{q}}}", q))
    left = r"\frac{d}{dt}" + " - ".join(slopes)

    def flag_of(each: str) -> str:
        return "independent" if each in moving else "constant" if each in inside else ""

    for force in sorted(outside) or ["0"]:
        with suppress(ReadError, IllFormedAt, IllFormed):
            read, _ = read_statement(f"{left} = {force}", notation, None)
            statement, known = flagged(read, given, flag_of)
            law, _ = flagged(said, Definitions(), flag_of)
            reason = ContextCode.GIVEN_OTHERWISE(symbol=f"the motion of ${q}$", facts="Lagrange's equation")
            yield Contradiction(claim.id, statement, (law,), known, reason)


def _missed(made: Sequence[Contradiction], end: float) -> Contradiction | None:
    """Returns the equation that a law misses by one change; None if the law follows from one."""
    tests = [each for each in made if Points(each.statement, each.known, each.assume).has_value()]
    if any(Points(each.statement, each.known, each.assume).vanishes() for each in tests):
        return None
    for each in tests:
        (law,) = each.assume
        for changed in usual_changes(law, left_too=True) if isinstance(law, Relation) else ():
            if process_time() > end:
                return None
            points = Points(each.statement, each.known, (changed,))
            if points.has_value() and points.vanishes():
                return each
    return None


S = TypeVar("S", bound="Statement | None")


def flagged(statement: S, known: Definitions, flag_of: Callable[[str], str]) -> tuple[S, Definitions]:
    """Returns a statement and definitions with a flag on some of their symbols.

    flag_of: the name of the flag of a symbol; "" for none.
    """

    def change(term: Term) -> Term | None:
        if isinstance(term, Symbol) and (flag := flag_of(str(term.declaration.name))):
            return replace(term, declaration=term.declaration.with_flags(**{flag: True}))
        return None

    new = Definitions([replace(each, body=replaced(each.body, change)) for each in known])
    if isinstance(statement, Relation):
        left, right = (replaced(side, change) for side in (statement.left, statement.right))
        return replace(statement, left=left, right=right), new
    return statement, new
