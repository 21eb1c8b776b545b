"""Proposals for results, and their cache."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from workbench.app.pipeline.verdict_keys import Keys, Memory
from workbench.context.claims import Claim
from workbench.core.codes.context_codes import ContextCode
from workbench.core.verdict import Outcome
from workbench.prover.results.claim_results import HOLDS, ClaimResult
from workbench.prover.results.proposed_form import Proposed
from workbench.repair.author_edits import with_author_edits
from workbench.repair.propose.chain_neighbours import ALONE, neighbours_of
from workbench.repair.propose.lost_property import property_stated_of
from workbench.repair.propose.parallel_repairs import repair_claims
from workbench.repair.propose.proposal import Repair
from workbench.repair.propose.search_limits import STANDARD, Limits
from workbench.source.documents import Text

#: Verdicts on a printed form for which another form is searched.
_TO_REPAIR = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})


def with_proposals(
    results: Sequence[ClaimResult],
    limits: Limits | None = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
    memory: Memory | None = None,
    beside_right: bool = True,
    text: Text | None = None,
) -> list[ClaimResult]:
    """Returns the results, each with proposals if its printed form is refuted or ill-formed, few changes
    first.

    limits: of the search; None for no search.
    memory: the cache of earlier proposals, including those of searches that ran out of time.
    beside_right: whether also to search if a proved right form is given.
    text: its own characters are edited.
    """
    if limits is None:
        return [replace(result, proposed=()) for result in results]
    claims = [result.claim for result in results if asks_for_proposals(result, beside_right)]
    keys = Keys({}, {"proposals": limits})
    beside = neighbours_of([result.claim for result in results])
    kept = {c.id: keys.of_proposals(c, beside.get(c.id, ALONE).key) for c in claims} if memory else {}
    proposed: dict[str, tuple[Proposed, ...]] = {}
    if memory:
        proposed |= {
            name: found for name, key in kept.items() if (found := memory.proposals(key)) is not None
        }

    new = {claim.id: claim for claim in claims if claim.id not in proposed}

    def keep(found: Repair) -> None:
        name = found.claim.id
        proposed[name] = found.proposed()
        if memory and not found.interrupted:
            memory.keep_proposals(kept[name], proposed[name])
        progress(replace(found, claim=new[name]))

    asked = [replace(keys.parts.for_proposals(claim), id=name) for name, claim in new.items()]
    repair_claims(asked, limits, keep, beside=beside)
    made = [replace(result, proposed=proposed.get(result.claim.id, ())) for result in results]

    def once(claim: Claim, latex: str, asked: Callable[[], bool]) -> bool:
        """Asks whether an edited formula is proved, unless an earlier run has proved it."""
        key = keys.of_proposals(claim, f"edited\n{latex}") if memory else ""
        known = memory is not None and memory.knows(key)
        if not known and (known := asked()) and memory is not None:
            memory.know(key)
        return known

    return with_author_edits(made, text, once)


def asks_for_proposals(result: ClaimResult, beside_right: bool = True) -> bool:
    """True if another form of the printed one is searched. beside_right: also beside a proved right form."""
    is_right = any(form and form.outcome in HOLDS for form in (result.corrected, result.reading))
    is_false = result.verdict.outcome in _TO_REPAIR and result.claim.proof.theorem is None
    if result.verdict.code is ContextCode.LACKS_PROPERTY:  # the equation defines
        is_false = is_false and property_stated_of(result.claim) is not None
    return is_false and not result.known and (beside_right or not is_right)
