"""Definitions of a text that make other formulas false: one usual change of them makes these true."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from time import process_time

from workbench.context.claims import Claim
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.terms import IllFormed, Relation, Statement, Symbol, Term
from workbench.core.verdict import Grade, Outcome
from workbench.engines.inventory import WithoutDefinitions
from workbench.language.definitions import Definitions, expand, is_definition, replaced
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.meanings.usual_misprints import definitions_of, is_misprint
from workbench.prover.results.claim_results import ClaimResult
from workbench.repair.propose.usual_changes import Points, usual_changes

#: The seconds for the changes of one definition, and for those of a text.
_SECONDS_OF_ONE, _SECONDS_OF_ALL = 1.0, 6.0


@dataclass(frozen=True)
class _Misprint:
    """A definition as it should be, by a formula that is false as the definition is printed."""

    definition: str
    right: Relation
    against: ClaimResult


def with_misprinted_definitions(
    results: Sequence[ClaimResult], is_standard: Callable[[Claim], bool]
) -> list[ClaimResult]:
    """Returns the results, where a definition is false in place of a formula that it alone makes false.

    One usual change of this definition makes the formula true, and none of another definition does. A usual
    change of the formula must not do that, unless the formula is a standard one, and the definition is none.
    """
    found = {each.definition: each for each in _misprints(results, is_standard)}
    against = {each.against.claim.id: each for each in found.values()}
    return [_judged(each, found, against) for each in results]


def _judged(
    result: ClaimResult, found: Mapping[str, _Misprint], against: Mapping[str, _Misprint]
) -> ClaimResult:
    own, verdict = result.claim.id, result.verdict
    if own in found:
        misprint = found[own]
        other = misprint.against
        reason = ContextCode.MAKES_FALSE(
            formula=f"${other.claim.printed.latex}$",
            line=other.claim.line,
            right=f"${to_latex(misprint.right)}$",
        )
        false = replace(other.verdict, reason=reason, read_back=verdict.read_back)
        return replace(result, verdict=false)
    if own in against:
        doubt = DoubtCode.MISPRINTED_DEFINITION(name=to_latex(against[own].right.left))
        return replace(result, verdict=replace(verdict, unless=(*verdict.unless, doubt)))
    return result


def _misprints(results: Sequence[ClaimResult], is_standard: Callable[[Claim], bool]) -> Iterator[_Misprint]:
    given = {
        said.left: each
        for each in results
        if isinstance(said := each.claim.printed.statement, Relation)
        and isinstance(said.left, Symbol)
        and each.verdict.outcome is Outcome.DEFINITION
        and is_definition(said, each.claim.notation.definitions)
    }
    end = process_time() + _SECONDS_OF_ALL
    for result in results:
        is_false = result.verdict.outcome is Outcome.REFUTED and result.verdict.grade is Grade.WARNING
        if not is_false or process_time() > end:
            continue
        mended = [(own, right) for own in given if (right := _mended(own, result.claim)) is not None]
        if len(mended) != 1:
            continue
        ((own, right),) = mended
        known = given[own].claim
        if not is_misprint(result.claim) or (is_standard(result.claim) and not is_standard(known)):
            yield _Misprint(known.id, right, result)


def _mended(own: Symbol, claim: Claim) -> Relation | None:
    """Returns a definition with a usual change that makes a false claim true; None if there is none."""
    said, known = claim.printed.statement, definitions_of(claim)
    body = known.lookup(own)
    if not isinstance(said, Relation) or body is None:
        return None
    with suppress(IllFormed):
        in_full = _around(said, known, own)
        if own not in {part for side in (in_full.left, in_full.right) for part in side.walk()}:
            return None
        end = process_time() + _SECONDS_OF_ONE
        points = Points(in_full, known, (), claim.instances, 2)
        if not points.has_value():
            return None
        for changed in usual_changes(Relation("=", own, body)):
            if process_time() > end:
                break
            if isinstance(changed, Relation) and points.vanishes(_with_body(in_full, own, changed.right)):
                return changed
    return None


def _around(said: Relation, known: Definitions, own: Symbol) -> Relation:
    """Returns an equation with all definitions in it but one. Raises IllFormed."""
    others = WithoutDefinitions(known, (own,))
    return Relation(said.operator, expand(said.left, others), expand(said.right, others))


def _with_body(said: Relation, own: Symbol, body: Term) -> Statement:
    def change(part: Symbol) -> Term | None:
        return body if part == own else None

    return Relation(said.operator, replaced(said.left, change), replaced(said.right, change))
