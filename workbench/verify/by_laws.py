"""What is proved of the motions of which a text states the laws."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.core.verdict_codes import VerdictCode
from workbench.judge.verdict import Outcome, Verdict
from workbench.language.printing.printer import to_latex
from workbench.language.typed.terms import Definition
from workbench.papers.model import Claim, Said
from workbench.verify.laws import defined_beside, laws_of
from workbench.verify.under import Under, conditional


def by_laws(under: Under, claim: Claim, bare: Verdict) -> Verdict | None:
    """What is proved of the motions of which earlier formulas are laws."""
    if claim.corrected is not None:
        return None
    own, laws = (
        [law for law in laws_of(claim, followed) if not under.is_known(law, claim.notation)]
        for followed in (False, True)
    )
    by_itself = tuple(each for each in claim.rests if each.definition is not None)
    beside = defined_beside(laws, claim)
    tries = [(by_itself, []), ((), own[:1]), ((), own), ((), laws), (beside, laws)]
    tries = [each for place, each in enumerate(tries) if laws and each not in tries[:place]]
    for defined, said in tries:
        definitions = [each.definition for each in defined]
        said = _needed(under, claim, said, definitions)
        if not (defined or said):
            continue
        found = under.given(claim, said, definitions)
        if found.outcome in (Outcome.PROVED, Outcome.CONDITIONAL):
            used = (*defined, *said)
            places = ", ".join(dict.fromkeys(each.place for each in used))
            why = VerdictCode.SAID_ELSEWHERE(places=places)
            if found.reason:
                why = VerdictCode.SAID_ELSEWHERE_BECAUSE(places=places, reason=found.reason)
            return conditional(found, [to_latex(each.statement) for each in used], why, bare)
    return None


def _needed(
    under: Under, claim: Claim, laws: Sequence[Said], definitions: Sequence[Definition]
) -> Sequence[Said]:
    """Those of the laws without which the first engine does not see that it holds; all, where it does not
    see it with all."""
    needed = list(laws)
    if len(needed) < 2 - bool(definitions) or not _seems_to_hold(under, claim, needed, definitions):
        return laws
    for law in laws:
        fewer = [each for each in needed if each is not law]
        if _seems_to_hold(under, claim, fewer, definitions):
            needed = fewer
    return needed


def _seems_to_hold(
    under: Under, claim: Claim, laws: Sequence[Said], definitions: Sequence[Definition]
) -> bool:
    return under.given(claim, laws, definitions, by_both=False).outcome is Outcome.PROBABLE
