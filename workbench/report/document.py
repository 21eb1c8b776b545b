"""The report as its readers see it: equations by section, counts, errata. Every format is made from this."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from workbench.judge.verdict import Evidence, Outcome
from workbench.papers.model import Paper
from workbench.repair.propose.proposed import Proposed
from workbench.report.counts import summary, versions
from workbench.report.errata import (
    Correction,
    Errata,
    cost_in_words,
    errata_of,
    reason_for_readers,
    without_place,
)
from workbench.report.error_rows import ErrorRow, error_rows
from workbench.report.kinds import SHOWN, STATES, VERDICTS, Kind
from workbench.report.motions import Motions, motions_of
from workbench.report.pictures import spark_line
from workbench.report.places import Heirs, Place, Places, equation_key, is_counted, label, with_headings
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
    spark: str | None
    cost: str | None

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
    """All claims under one number or name. state: that of its worst line.   counted: not a theorem or a
    remark."""

    label: str
    anchor: str
    counted: bool
    state: Kind
    entries: tuple[Entry, ...]


@dataclass(frozen=True)
class Section:
    """number: what its name begins with."""

    number: str
    name: str
    anchor: str
    equations: tuple[Equation, ...]

    def count(self, state: str) -> int:
        """How many of its equations are in a state."""
        return sum(each.counted and each.state.name == state for each in self.equations)

    @property
    def counted(self) -> int:
        return sum(each.counted for each in self.equations)


@dataclass(frozen=True)
class Class:
    """The equations in one state, and the theorems and remarks."""

    kind: Kind
    equations: tuple[Equation, ...]
    statements: tuple[Equation, ...]

    @property
    def count(self) -> int:
        return len(self.equations)


@dataclass(frozen=True)
class Document:
    """classes: those that are not empty, in the order of the page."""

    title: str
    citation: Mapping[str, str]
    versions: tuple[tuple[str, str], ...]
    sections: tuple[Section, ...]
    classes: tuple[Class, ...]
    rows: tuple[ErrorRow, ...]
    errata: Errata
    summary: Mapping[str, int]
    motions: Motions | None
    motion_count: int
    motion_name: str
    certified: int
    certified_by: str
    file: str

    @property
    def equations(self) -> list[Equation]:
        return [equation for section in self.sections for equation in section.equations]

    @property
    def entries(self) -> list[Entry]:
        return [entry for equation in self.equations for entry in equation.entries]

    @property
    def counted(self) -> int:
        return sum(equation.counted for equation in self.equations)

    @property
    def cite(self) -> tuple[str, ...]:
        """Author, book or journal, and year, in one line."""
        found = [self.citation[key] for key in ("authors", "source", "year") if key in self.citation]
        found = [each.split(" (")[0] for each in found]
        return (", ".join(found),) if found else ()

    @property
    def transcribed(self) -> bool:
        """Whether what was read is not the print itself."""
        return "transcription" in self.citation.get("read", "")

    def in_state(self, name: str) -> int:
        """How many equations are in a state."""
        return next((each.count for each in self.classes if each.kind.name == name), 0)


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
_OPEN = (Outcome.ARGUED, Outcome.PROBABLE)


def document_of(paper: Paper, results: Sequence[ClaimResult]) -> Document:
    places = Places([result.claim for result in results])
    heirs = Heirs(results, places.claims)
    errata = errata_of(results, places.claims, heirs)
    entry = partial(_entry, places, heirs, {each.id: each for each in errata.corrections})
    groups: dict[str, list[ClaimResult]] = {}
    for result in results:
        groups.setdefault(equation_key(result.claim), []).append(result)
    equations = [_equation(places, list(map(entry, group))) for group in groups.values()]
    return Document(
        title=paper.title,
        citation={**paper.citation, **({"doi": paper.doi} if paper.doi else {})},
        versions=tuple(versions().items()),
        sections=tuple(_sections(equations, paper.sections)),
        classes=tuple(each for kind in SHOWN if (each := _class(kind, equations)) is not None),
        rows=error_rows(equations, places.anywhere),
        errata=errata,
        summary=summary(results),
        motions=motions_of(results, places.anywhere),
        motion_count=len(_motion_names(results)),
        motion_name=next(
            (r.on_motions.error.motion.split(",")[0] for r in results if r.on_motions.error), ""
        ),
        file="" if paper.citation.get("read") else paper.paths[-1].name if paper.paths else "",
        certified_by=next(
            (each.checked_by for r in results for each in r.certificates or () if each.checked_by), ""
        ),
        certified=sum(bool(each.checked_by) for result in results for each in result.certificates or ()),
    )


def _motion_names(results: Sequence[ClaimResult]) -> set[str]:
    found = (e for result in results for v in result.verdicts.values() for e in v.evidence)
    return {name for each in found for name in each.figures.get("motions", ())}


def _sections(equations: Sequence[Equation], names: Mapping[str, str]) -> list[Section]:
    """In reading order. names: of the sections that the claims number only."""
    groups: dict[str, list[Equation]] = {}
    for equation in equations:
        groups.setdefault(equation.entries[0].result.claim.section or "", []).append(equation)
    return [
        Section(
            name.split()[0] if name[:1].isdigit() else name,
            f"{name} {names[name]}" if name in names else name,
            f"section-{number}",
            tuple(group),
        )
        for number, (name, group) in enumerate(groups.items(), start=1)
    ]


def _class(kind: Kind, equations: Sequence[Equation]) -> Class | None:
    ours = [each for each in equations if each.state is kind]
    counted = tuple(each for each in ours if each.counted)
    return Class(kind, counted, tuple(each for each in ours if not each.counted)) if ours else None


def _equation(places: Places, entries: Sequence[Entry]) -> Equation:
    first = entries[0].result.claim
    return Equation(
        label=label(first),
        anchor=places.of_equation(first),
        counted=is_counted(first),
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
        spark=spark_line(result) if result.fault == "error" else None,
        cost=cost_in_words(result),
    )


def _state(result: ClaimResult, rests_on_others: bool) -> Kind:
    if result.fault:
        return STATES[result.fault]
    outcome = result.verdict.outcome
    if outcome not in HOLDS:
        name = "unjudged" if outcome is Outcome.UNCHECKED else "open" if outcome in _OPEN else "error"
        return STATES[name]
    if rests_on_others:
        return STATES["inherits"]
    is_own = outcome is Outcome.DEFINITION and result.claim.span is not None
    return STATES["defines" if is_own else "holds"]


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
