"""The certificates of the chapter's forms, for all tests beside."""

from contextlib import suppress
from functools import cache

from workbench.certificates.certified_forms import certificate, forms_of
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.goals.goal_theorem import whole
from workbench.core.verdict import Outcome
from workbench.language.goals.goals import Scope
from workbench.language.goals.proofs import Proven
from workbench.papers import find_paper

#: The theorem claims of the chapter that are joined to one theorem, those with families first.
OF_FAMILIES = ("21.every_n", "Remark_3", "22.every_n", "117", "119", "122", "122.observed", "Remark7.sum")
JOINED = (
    *OF_FAMILIES,
    *("Theorem_1", "23.group", "71", "73.module", "74", "76.definition", "77.definition", "78", "Theorem5"),
    *("79.displacements", "Theorem8", "92.origin", "92.field", "102.A.minimum", "102.J.minimum", "3C"),
    *(f"Remark7.{name}" for name in ("parallel", "coincident", "relative_translation", "one_translation")),
    *("Remark7.translations", "3C.expanded"),
)


@cache
def all_certificates():
    """(form, certificate or obstacle) of each form whose own claim does not expect it to be refuted."""
    found = []
    for claim in find_paper("chapter").claims:
        for form in forms_of(claim):
            if claim.corrected is not None and form.name != "corrected":
                continue
            try:
                found.append((form, certificate(form, every=claim.orders is not None)))
            except NotCertified as obstacle:
                found.append((form, str(obstacle)))
    return found


def one(claim_id, name="printed"):
    (form,) = [
        f for c in find_paper("chapter").claims if c.id == claim_id for f in forms_of(c) if f.name == name
    ]
    return certificate(form, every=form.claim.orders is not None)


@cache
def joined():
    """The theorem of each claim that is joined to one, by the claim's id."""
    paper = find_paper("chapter")
    found = {}
    for claim in paper.claims:
        proven = paper.theorems.get(claim.proof.theorem or "")
        if claim.proof.goal is None or not isinstance(proven, Proven) or proven.proof is None:
            continue
        if claim.expected == Outcome.PROVED:
            with suppress(NotCertified):
                scope = Scope(claim.notation.symbols, claim.notation.definitions, {})
                (found[claim.id],) = whole(claim, scope, proven.proof).theorems
    return found
