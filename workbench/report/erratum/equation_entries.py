"""Equations of a report: their claims, the forms of each, the evidence, and their state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.core.verdict import Evidence
from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.proposed_form import Proposed
from workbench.report.anchors import Heirs, Place, Places, is_counted, label, with_headings
from workbench.report.claim_states import fault_of, state_of, state_of_equation
from workbench.report.counterexamples import Against, against
from workbench.report.erratum.errata import Correction, cost_in_words, reason_for_readers, without_place
from workbench.report.mixed_prose import Run, plain_value, runs_of, runs_with_symbols
from workbench.report.shown_kinds import VERDICTS, Kind
from workbench.source.typeset.differences import difference


@dataclass(frozen=True)
class Form:
    """A formula with its caption, its marked leaves, and its verdict if it was judged by itself."""

    caption: str
    latex: str
    marked: frozenset[int] = frozenset()
    kind: Kind | None = None
    scope: str | None = None
    reason: tuple[Run, ...] = ()


@dataclass(frozen=True)
class Found:
    """Evidence on one form: "printed", "reading" or "corrected"."""

    of: str
    method: str
    outcome: str
    figures: tuple[tuple[str, str], ...]

    @property
    def sign(self) -> str | None:
        """The letter of the evidence in one-line summaries; None for evidence that is described in words."""
        return next((sign for beginning, sign in _SIGNS if self.method.startswith(beginning)), None)


@dataclass(frozen=True)
class Entry:
    """One claim.

    Attributes:
        state: Its state for readers.
        correction: Its correction, if the claim is an erratum of its own.
        mended_by: Otherwise the claim whose edits correct it.
    """

    result: ClaimResult
    place: str
    anchor: str
    state: Kind
    fault: str | None
    statement: tuple[Run, ...]
    reason: tuple[Run, ...]
    note: tuple[Run, ...]
    forms: tuple[Form, ...]
    correction: Correction | None
    mended_by: Place | None
    evidence: tuple[Found, ...]
    heirs: tuple[Place, ...]
    rests_on: tuple[Place, ...]
    cost: str | None

    @property
    def counterexample(self) -> Against | None:
        return against(self.result)

    @property
    def id(self) -> str:
        return self.result.claim.id

    @property
    def verdict(self) -> Kind:
        """The verdict on the printed form."""
        return VERDICTS[self.result.verdict.outcome]

    @property
    def unexpected(self) -> str:
        """Why the verdict is not the one that the paper file expects; "" for a text, which expects none."""
        claim = self.result.claim
        is_silent = claim.context.span is not None and claim.corrected is None and claim.reading is None
        return "" if is_silent else without_place(self.result.why_not)

    @property
    def signs(self) -> tuple[str, ...]:
        """The letters of the evidence on the right form, or else on the printed form."""
        right = list(self.result.verdicts)[-1]
        about = [item for item in self.evidence if item.of == right] or self.evidence
        return tuple(sorted({item.sign for item in about if item.sign is not None}))


@dataclass(frozen=True)
class Equation:
    """All claims under one number or name.

    Attributes:
        state: The worst state of its claims.
        counted: Whether it is an equation, not a theorem or a remark.
    """

    label: str
    anchor: str
    counted: bool
    state: Kind
    entries: tuple[Entry, ...]


_SIGNS = (
    ("exact ring", "F"),
    ("SymPy", "S"),
    ("Drake symbolic", "S"),
    ("each instance", "N"),
    ("all ", "N"),
    ("goal", "G"),
    ("definitions", "D"),
    ("random point", "P"),
    ("rational point", "C"),
    ("Drake reference motions", "M"),
)


def equation_of(places: Places, entries: Sequence[Entry]) -> Equation:
    first = entries[0].result.claim
    return Equation(
        label=label(first),
        anchor=places.equations[first.id],
        counted=is_counted(first),
        state=state_of_equation([each.result for each in entries], [each.state for each in entries]),
        entries=tuple(entries),
    )


def entry_of(
    places: Places, heirs: Heirs, corrections: Mapping[str, Correction], result: ClaimResult
) -> Entry:
    claim = result.claim
    name, anchor = places.claims[claim.id]
    above = heirs.before(claim)
    quoted = claim.sentence.quote if claim.sentence.quote and not claim.sentence.ours else None
    return Entry(
        result=result,
        place=name,
        anchor=anchor,
        state=state_of(result, bool(above)),
        statement=tuple(runs_of(" ".join(filter(None, [quoted, claim.source.statement])))),
        reason=tuple(runs_with_symbols(reason_for_readers(result))),
        note=tuple(runs_of(with_headings(claim.source.note, places.anywhere))),
        forms=tuple(_forms(result)),
        correction=corrections.get(claim.id),
        mended_by=places.anywhere.get(claim.mend.by) if claim.mend.by else None,
        evidence=tuple(_found(of, e) for of, verdict in result.verdicts.items() for e in verdict.evidence),
        fault=fault_of(result),
        heirs=heirs.of([claim.id], [name]) if result.fault else (),
        rests_on=tuple(dict.fromkeys(place for place in above if place[0] != name)),
        cost=cost_in_words(result),
    )


def _forms(result: ClaimResult) -> list[Form]:
    """Returns the printed form, the reading and the corrected form, each compared with the previous one."""
    claim = result.claim
    forms = []
    if claim.displayed:
        forms.append(Form("Printed", claim.displayed))
    if claim.our_formula:
        forms.append(Form("Our formula for it", claim.our_formula))
    for caption, formula, verdict in (
        ("Intended reading", claim.reading, result.reading),
        ("Corrected", claim.corrected, result.corrected),
    ):
        if formula is not None and verdict is not None:
            reason = tuple(runs_of(without_place(verdict.reason or "")))
            kind = VERDICTS[verdict.outcome]
            forms.append(Form(caption, formula.latex, kind=kind, scope=verdict.scope, reason=reason))
    for index in range(1, len(forms) if claim.mend.by is None else 0):
        before, after = forms[index - 1 : index + 1]
        if found := difference(before.latex, after.latex):
            forms[index - 1] = replace(before, marked=before.marked | found.marked_before)
            forms[index] = replace(after, marked=found.marked_after)
    if claim.proof.goal:
        forms.append(Form("What is shown of it", claim.proof.goal.latex))
    printed = result.verdict.read_back or claim.shown
    return forms + [_proposed(printed, proposal) for proposal in result.proposed or ()]


def _proposed(printed: str | None, proposal: Proposed) -> Form:
    """Returns a proposed form, with its differences from the printed one marked.

    printed: the printed form in canonical spelling, if it could be read.
    """
    found = difference(printed, proposal.latex) if printed is not None else None
    return Form(
        "Proposed by the machine",
        proposal.latex,
        marked=found.marked_after if found else frozenset(),
        kind=VERDICTS[proposal.verdict],
        reason=tuple(runs_of(proposal.edit)),
    )


def _found(of: str, evidence: Evidence) -> Found:
    figures = {key: value for key, value in evidence.figures.items() if key != "course"}
    told = tuple((key.replace("_", " "), plain_value(value)) for key, value in figures.items())
    return Found(of, evidence.method, evidence.outcome, told)
