"""Right claims damaged on purpose: in the typed term where the result still has a type, else in the LaTeX."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from random import Random

from workbench.context.claims import Correction
from workbench.context.read_formulas import read_statement
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.terms import Statement
from workbench.engines.inventory import NotExact
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Accented, Group, Infix, Product
from workbench.language.printing.printer import to_latex
from workbench.papers import Claim, Formula
from workbench.prover.decide.decide import Judge
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import STANDARD, Limits
from workbench.repair.screening.sameness import Sameness
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.term_edits import Edit, edits
from workbench.repair.trees.lost_marks import Mark, all_marks, marked
from workbench.repair.trees.tree_nodes import below


@dataclass(frozen=True)
class Damaged:
    """A claim whose printed form was damaged: the kind of damage, and what it said before."""

    kind: str
    claim: Claim
    original: Statement


def right_claims(paper) -> list[tuple[Claim, Formula]]:
    """The claims without a hypothesis, each with the form that the paper holds to be right."""
    found = []
    for claim in paper.claims:
        formula = claim.corrected or claim.reading or claim.printed
        if (
            claim.proof.theorem is None
            and claim.correction.hypothesis is None
            and formula.statement is not None
        ):
            found.append((claim, formula))
    return found


def damages(claim: Claim, formula: Formula, random: Random, each: int) -> Iterator[Damaged]:
    """Up to `each` damages of each kind, each of which makes the claim false or ill-formed."""
    pool: dict[str, list[Formula]] = {}
    for edit in edits(formula.statement):
        if isinstance(edit, Edit):
            pool.setdefault(edit.kind, []).append(Formula(to_latex(edit.statement), edit.statement))
    for kind, latex in _in_latex(formula.latex, claim):
        damaged = read_or_fault(latex, claim)
        if damaged is not None and damaged.ill_formed:
            pool.setdefault(f"{kind}, ill-formed", []).append(damaged)
    for kind, formulas in sorted(pool.items()):
        random.shuffle(formulas)
        kept = 0
        for damaged in formulas:
            if kept < each and (damaged.ill_formed or is_false(claim, damaged.statement)):
                kept += 1
                yield Damaged(kind, intact(claim, damaged), formula.statement)


def twice(damaged: Damaged, random: Random) -> Damaged | None:
    """One more damage of the term; None where the claim has no term."""
    if damaged.claim.printed.statement is None:
        return None
    more = [e for e in edits(damaged.claim.printed.statement) if isinstance(e, Edit)]
    random.shuffle(more)
    for edit in more:
        if is_false(damaged.claim, edit.statement):
            formula = Formula(to_latex(edit.statement), edit.statement)
            return Damaged("two", intact(damaged.claim, formula), damaged.original)
    return None


def intact(claim: Claim, printed: Formula) -> Claim:
    """The claim printed so, with nothing that tells the right form."""
    correction = Correction(hypothesis=claim.correction.hypothesis)
    return replace(claim, printed=printed, correction=correction, source=replace(claim.source, note=""))


def read_or_fault(latex: str, claim: Claim) -> Formula | None:
    try:
        return Formula(latex, read_statement(latex, claim.notation, claim.orders)[0])
    except IllFormedAt as error:
        return Formula(latex, ill_formed=str(error))
    except ReadError:
        return None


def _in_latex(latex: str, claim: Claim) -> Iterator[tuple[str, str]]:
    root = parse(latex)
    lost = [*all_marks(root, claim.notation.symbols), *_lost_signs(root), *_moved_tildes(root)]
    for mark in lost:
        if mark.cost == 1:
            yield mark.kind, latex_of(marked([mark], root))


def _lost_signs(root) -> Iterator[Mark]:
    for part in below(root):
        if isinstance(part, Product):
            for place, item in enumerate(part.items):
                if isinstance(item, Infix):
                    rest = (*part.items[:place], *part.items[place + 1 :])
                    yield Mark(part, Product(part.at, rest), 1, "product", "a sign is lost")


def _moved_tildes(root) -> Iterator[Mark]:
    for part in below(root):
        match part:
            case Accented(accent="~", body=Group(parts=(Product(items=(first, *rest)),))):
                moved = Accented(part.at, "~", first)
                yield Mark(part, Group(part.at, (Product(part.at, (moved, *rest)),)), 1, "tilde", "moved")


def screens(claim: Claim) -> list[Screen]:
    return [Screen(claim.notation.definitions, claim.supposed, [v], seed=5) for v in claim.instances]


def is_false(claim: Claim, statement: Statement) -> bool:
    """Whether the screen shows that the statement fails for some of the claim's integers."""
    try:
        residuals = [screen.residual(statement) for screen in screens(claim)]
    except NotExact:
        return False
    return None not in residuals and any(any(residual) for residual in residuals)


def same(claim: Claim, one: Statement, other: Statement) -> bool:
    """Whether two proved statements say the same, at the last two choices of the claim's integers."""
    return Sameness.under(claim).same(one, other)


@dataclass(frozen=True)
class Result:
    """What the repair of a damaged claim came to. same: whether a proposal says what the claim said before."""

    kind: str
    id: str
    latex: str
    verdicts: tuple[str, ...]
    same: bool
    seconds: float


def repaired(damaged: Damaged, limits: Limits = STANDARD) -> Result:
    claim = damaged.claim
    found = repair(claim, limits, judge=Judge(claim.notation.definitions))
    forms = [read_or_fault(proposal.latex, claim) for proposal in found.proposals]
    return Result(
        damaged.kind,
        claim.id,
        claim.printed.latex,
        tuple(str(proposal.verdict.outcome) for proposal in found.proposals),
        any(same(claim, form.statement, damaged.original) for form in forms),
        found.seconds,
    )
