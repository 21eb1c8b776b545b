"""The report as its readers see it: equations by section, counts, errata. Every format is made from this."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from workbench.judge.verdict import Evidence, Outcome
from workbench.papers.model import Paper
from workbench.repair.propose.proposed import Proposed
from workbench.report.counts import summary, versions
from workbench.report.errata import Correction, Errata, errata_of, reason_for_readers, without_place
from workbench.report.kinds import STATES, VERDICTS, Kind
from workbench.report.motions import Motions, motions_of
from workbench.report.places import Heirs, Place, Places, equation_key, heading, is_number, with_headings
from workbench.report.prose import Run, plain_value, runs_of
from workbench.typeset.differences import difference
from workbench.verify.results import HOLDS, ClaimResult


@dataclass(frozen=True)
class Form:
    """A formula with its caption, its marked leaves, and what was found if it was judged by itself."""

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
        """Its letter where evidence is told in one line; None for what stands beside it in words."""
        return next((sign for beginning, sign in _SIGNS if self.method.startswith(beginning)), None)


@dataclass(frozen=True)
class Entry:
    """One claim. state: what a reader is told of it; correction: where it is an erratum of its own;
    mended_by: else the claim whose edits mend it."""

    result: ClaimResult
    place: str
    anchor: str
    state: Kind
    statement: tuple[Run, ...]
    reason: tuple[Run, ...]
    note: tuple[Run, ...]
    forms: tuple[Form, ...]
    correction: Correction | None
    mended_by: Place | None
    evidence: tuple[Found, ...]
    heirs: tuple[Place, ...]
    rests_on: tuple[Place, ...]

    @property
    def id(self) -> str:
        return self.result.claim.id

    @property
    def verdict(self) -> Kind:
        """On what is printed."""
        return VERDICTS[self.result.verdict.outcome]

    @property
    def unexpected(self) -> str:
        return without_place(self.result.why_not)

    @property
    def signs(self) -> tuple[str, ...]:
        """The letters of the evidence on the form that is right, or else on what is printed."""
        right = list(self.result.verdicts)[-1]
        about = [item for item in self.evidence if item.of == right] or self.evidence
        return tuple(sorted({item.sign for item in about if item.sign is not None}))


@dataclass(frozen=True)
class Equation:
    """All claims under one number or name. state: that of its worst line."""

    name: str
    heading: str
    anchor: str
    numbered: bool
    state: Kind
    entries: tuple[Entry, ...]


@dataclass(frozen=True)
class Section:
    name: str
    anchor: str
    equations: tuple[Equation, ...]


@dataclass(frozen=True)
class Tile:
    kind: Kind
    equations: int
    statements: int


@dataclass(frozen=True)
class Document:
    title: str
    citation: tuple[tuple[str, str], ...]
    versions: tuple[tuple[str, str], ...]
    sections: tuple[Section, ...]
    tiles: tuple[Tile, ...]
    errata: Errata
    summary: Mapping[str, int]
    motions: Motions | None

    @property
    def equations(self) -> list[Equation]:
        return [equation for section in self.sections for equation in section.equations]

    @property
    def entries(self) -> list[Entry]:
        return [entry for equation in self.equations for entry in equation.entries]

    @property
    def numbered(self) -> int:
        return sum(equation.numbered for equation in self.equations)

    @property
    def statements(self) -> int:
        return len(self.equations) - self.numbered


#: What the note tells of the paper and of what was read, in this order.
CITED_AS = {
    **{"authors": "Author", "source": "In", "year": "Year", "pages": "Pages", "doi": "DOI"},
    **{"commit": "Commit", "licence": "Licence", "read": "Read was", "recheck": "Recheck by"},
}
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
_OPEN = (Outcome.ARGUED, Outcome.PROBABLE, Outcome.UNCHECKED)


def document_of(paper: Paper, results: Sequence[ClaimResult]) -> Document:
    places = Places([result.claim for result in results])
    heirs = Heirs(results, places.claims)
    errata = errata_of(results, places.claims, heirs)
    entry = partial(_entry, places, heirs, {each.id: each for each in errata.corrections})
    sections = []
    for number, (name, inside) in enumerate(_grouped(results, lambda r: r.claim.section or "")):
        equations = _grouped(inside, lambda r: equation_key(r.claim))
        sections.append(
            Section(
                name,
                f"section-{number + 1}",
                tuple(_equation(places, list(map(entry, group))) for _, group in equations),
            )
        )
    everything = [equation for section in sections for equation in section.equations]
    cited = {**paper.citation, "doi": paper.doi}
    return Document(
        title=paper.title,
        citation=tuple((key, text) for key in CITED_AS if (text := cited.get(key))),
        versions=tuple(versions().items()),
        sections=tuple(sections),
        tiles=tuple(_tile(kind, everything) for kind in STATES.values()),
        errata=errata,
        summary=summary(results),
        motions=motions_of(results, places.anywhere),
    )


def _tile(kind: Kind, equations: list[Equation]) -> Tile:
    ours = [equation for equation in equations if equation.state is kind]
    numbered = sum(equation.numbered for equation in ours)
    return Tile(kind, numbered, len(ours) - numbered)


def _grouped(
    results: Iterable[ClaimResult], key: Callable[[ClaimResult], str]
) -> Iterable[tuple[str, list[ClaimResult]]]:
    groups: dict[str, list[ClaimResult]] = {}
    for result in results:
        groups.setdefault(key(result), []).append(result)
    return groups.items()


def _equation(places: Places, entries: Sequence[Entry]) -> Equation:
    first = entries[0].result.claim
    return Equation(
        name=first.equation or first.id,
        heading=heading(first),
        anchor=places.of_equation(first),
        numbered=is_number(first.equation),
        state=min((entry.state for entry in entries), key=list(STATES.values()).index),
        entries=tuple(entries),
    )


def _entry(places: Places, heirs: Heirs, corrections: Mapping[str, Correction], result: ClaimResult) -> Entry:
    claim = result.claim
    name, anchor = places.claims[claim.id]
    above = heirs.before(claim)
    quoted = claim.quote if claim.quote and not claim.ours else None
    return Entry(
        result=result,
        place=name,
        anchor=anchor,
        state=_state(result, bool(above)),
        statement=tuple(runs_of(" ".join(filter(None, [quoted, claim.statement])))),
        reason=tuple(runs_of(reason_for_readers(result))),
        note=tuple(runs_of(with_headings(claim.note, places.anywhere))),
        forms=tuple(_forms(result)),
        correction=corrections.get(claim.id),
        mended_by=places.anywhere.get(claim.mend.by) if claim.mend.by else None,
        evidence=tuple(_found(of, e) for of, verdict in result.verdicts.items() for e in verdict.evidence),
        heirs=heirs.of([claim.id], [name]) if result.fault else (),
        rests_on=tuple(dict.fromkeys(place for place in above if place[0] != name)),
    )


def _state(result: ClaimResult, rests_on_others: bool) -> Kind:
    if result.fault:
        return STATES[result.fault]
    if result.verdict.outcome not in HOLDS:
        return STATES["open" if result.verdict.outcome in _OPEN else "error"]
    return STATES["inherits" if rests_on_others else "holds"]


def _forms(result: ClaimResult) -> list[Form]:
    """The printed form, the reading and the corrected form, each compared with the one before it."""
    claim = result.claim
    forms = []
    if claim.shown and claim.shown != claim.quote:
        forms.append(Form("Printed", claim.shown))
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
    for index in range(1, len(forms)):
        before, after = forms[index - 1 : index + 1]
        if found := difference(before.latex, after.latex):
            forms[index - 1] = replace(before, marked=before.marked | found.marked_before)
            forms[index] = replace(after, marked=found.marked_after)
    if claim.goal:
        forms.append(Form("What is shown of it", claim.goal.latex))
    printed = result.verdict.read_back or claim.shown
    return forms + [_proposed(printed, proposal) for proposal in result.proposed or ()]


def _proposed(printed: str | None, proposal: Proposed) -> Form:
    """A form that the machine proposes, with what differs from the printed one marked. printed: in the
    machine's spelling, where it could be read."""
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
