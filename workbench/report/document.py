"""The report as its readers see it: equations by section, counts, errata. Every format is made from this."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from workbench.report.errata import (
    Correction,
    Errata,
    Heirs,
    errata_of,
    reason_for_readers,
    with_headings,
    without_place,
)
from workbench.report.kinds import ERRATUM_TYPES, STATES, VERDICTS, Kind
from workbench.report.motions import Motions, motions_of
from workbench.report.prose import Run, difference_runs, plain_value, runs_of
from workbench.typeset.differences import difference


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
class Evidence:
    """of: which form it is about: "printed", "reading" or "corrected"."""

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
    """One claim. verdict: on what is printed; state: what a reader is told of it; correction: where it is an
    erratum of its own; mended_by: else the claim whose edits mend it.   heirs, rests_on: heading, anchor."""

    id: str
    anchor: str
    place: str
    verdict: Kind
    state: Kind
    erratum_type: str | None
    scope: str | None
    statement: tuple[Run, ...]
    reason: tuple[Run, ...]
    note: tuple[Run, ...]
    forms: tuple[Form, ...]
    read_back: str | None
    hypothesis: str | None
    assume: tuple[str, ...]
    orders: str | None
    unexpected: str | None
    wrong: tuple[tuple[Run, ...], ...]
    correction: Correction | None
    mended_by: tuple[str, str] | None
    evidence: tuple[Evidence, ...]
    certificates: tuple[Mapping[str, Any], ...]
    motion: str | None
    signs: tuple[str, ...]
    heirs: tuple[tuple[str, str], ...]
    rests_on: tuple[tuple[str, str], ...]


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
    summary: Mapping[str, int] = field(default_factory=dict)
    motions: Motions | None = None

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
_CITED = ("authors", "source", "year", "pages", "doi", "commit", "licence", "read", "recheck")
_OPEN = ("argued", "probable", "unchecked")


def document_of(report: Mapping[str, Any]) -> Document:
    """The document of a canonical report."""
    claims = report["claims"]
    anchors = _Anchors(claims)
    places = {claim["id"]: (_heading(claim), anchors.claim(claim)) for claim in claims}
    places |= {
        claim["equation"]: (_heading(claim), anchors.equation(claim))
        for claim in claims
        if claim["equation"] and claim["equation"] not in places
    }
    heirs = Heirs(claims, {claim["id"]: places[claim["id"]] for claim in claims})
    errata = errata_of(claims, {claim["id"]: places[claim["id"]] for claim in claims})
    context = _Context(
        places, anchors, heirs, heirs.rests_on(), {each.id: each for each in errata.corrections}
    )
    sections = []
    for number, (name, in_section) in enumerate(_grouped(claims, lambda c: c["section"] or "")):
        equations = tuple(_equation(group, context) for _, group in _grouped(in_section, _equation_key))
        sections.append(Section(name, f"section-{number + 1}", equations))
    everything = [equation for section in sections for equation in section.equations]
    paper = report["paper"]
    return Document(
        title=paper["title"],
        citation=tuple((key, paper[key]) for key in _CITED if paper.get(key)),
        versions=tuple(report["versions"].items()),
        sections=tuple(sections),
        tiles=tuple(_tile(kind, everything) for kind in STATES.values()),
        errata=errata,
        summary=report["summary"],
        motions=motions_of(claims, places),
    )


@dataclass(frozen=True)
class _Context:
    """What an entry is told of the others."""

    places: Mapping[str, tuple[str, str]]
    anchors: _Anchors
    heirs: Heirs
    rests_on: Mapping[str, Sequence[str]]
    corrections: Mapping[str, Correction]


def _tile(kind: Kind, equations: list[Equation]) -> Tile:
    ours = [equation for equation in equations if equation.state is kind]
    numbered = sum(equation.numbered for equation in ours)
    return Tile(kind, numbered, len(ours) - numbered)


def _grouped(claims: Iterable[Mapping[str, Any]], key) -> list[tuple[str, list[Mapping[str, Any]]]]:
    groups: dict[str, list[Mapping[str, Any]]] = {}
    for claim in claims:
        groups.setdefault(key(claim), []).append(claim)
    return list(groups.items())


def _equation_key(claim: Mapping[str, Any]) -> str:
    return claim["equation"] or f"id {claim['id']}"


def _is_number(equation: str | None) -> bool:
    return bool(equation and re.fullmatch(r"(?:[A-Z]\.?)?\d+(?:\.\d+)*[a-z]?", equation))


def _heading(claim: Mapping[str, Any]) -> str:
    equation, place = claim["equation"], claim.get("place")
    if not equation and place:
        return f"Line {place['line']}"
    return f"Eq. ({equation})" if _is_number(equation) else equation or claim["id"]


class _Anchors:
    """Anchors of equations and claims: readable, and never the same twice."""

    def __init__(self, claims: Sequence[Mapping[str, Any]]):
        self.taken: set[str] = set()
        self.equations: dict[str, str] = {}
        self.claims: dict[str, str] = {}
        # Numbers first: #eq-61 must be equation (61), whatever else is called "eq 61".
        for claim in sorted(claims, key=lambda claim: not _is_number(claim["equation"])):
            key = _equation_key(claim)
            if key not in self.equations:
                prefix = "eq-" if _is_number(claim["equation"]) else "at-"
                self.equations[key] = self.fresh(prefix + _slug(claim["equation"] or claim["id"]))
        for claim in claims:
            self.claims[claim["id"]] = self.fresh("claim-" + _slug(claim["id"]))

    def fresh(self, wanted: str) -> str:
        anchor, copy = wanted, 2
        while anchor in self.taken:
            anchor, copy = f"{wanted}--{copy}", copy + 1
        self.taken.add(anchor)
        return anchor

    def equation(self, claim: Mapping[str, Any]) -> str:
        return self.equations[_equation_key(claim)]

    def claim(self, claim: Mapping[str, Any]) -> str:
        return self.claims[claim["id"]]


def _slug(name: str) -> str:
    return re.sub(r"[^a-z0-9.]+", "-", name.lower()).strip("-") or "x"


def _equation(claims: Sequence[Mapping[str, Any]], context: _Context) -> Equation:
    entries = tuple(_entry(claim, context) for claim in claims)
    worst = min((entry.state for entry in entries), key=list(STATES.values()).index)
    first = claims[0]
    return Equation(
        name=first["equation"] or first["id"],
        heading=_heading(first),
        anchor=context.anchors.equation(first),
        numbered=_is_number(first["equation"]),
        state=worst,
        entries=entries,
    )


def _entry(claim: Mapping[str, Any], context: _Context) -> Entry:
    forms, wrong = _forms(claim)
    by = (claim.get("mend") or {}).get("mended_by")
    heading = _heading(claim)
    above = [context.places[name] for name in context.rests_on.get(claim["id"], ()) if name in context.places]
    return Entry(
        id=claim["id"],
        anchor=context.anchors.claim(claim),
        place=heading,
        verdict=VERDICTS[claim["verdict"]],
        state=_state(claim, context.rests_on.get(claim["id"], ())),
        erratum_type=ERRATUM_TYPES.get(claim.get("fault") or ""),
        scope=claim["scope"],
        statement=tuple(runs_of(_in_words(claim))),
        reason=tuple(runs_of(reason_for_readers(claim))),
        note=tuple(runs_of(with_headings(claim["note"] or "", context.places))),
        forms=forms,
        read_back=claim["read_back"],
        hypothesis=claim["hypothesis"],
        assume=tuple(claim.get("assume", ())),
        orders=claim.get("orders"),
        unexpected=None if claim.get("passed", True) else claim.get("why_not") or "not as expected",
        wrong=wrong,
        correction=context.corrections.get(claim["id"]),
        mended_by=context.places.get(by) if by else None,
        evidence=_evidence(claim),
        signs=_signs(claim),
        certificates=tuple(claim.get("certificates") or ()),
        motion=(claim.get("motion") or {}).get("line"),
        heirs=context.heirs.of([claim["id"]], [heading]) if claim.get("fault") else (),
        rests_on=tuple(dict.fromkeys(each for each in above if each[0] != heading)),
    )


def _state(claim: Mapping[str, Any], rests_on: Sequence[str]) -> Kind:
    if claim.get("fault"):
        return STATES[claim["fault"]]
    if claim["verdict"] not in ("proved", "definition"):
        return STATES["open" if claim["verdict"] in _OPEN else "error"]
    return STATES["inherits" if rests_on else "holds"]


def _is_sentence(printed: str) -> bool:
    return printed.startswith("“")


def _in_words(claim: Mapping[str, Any]) -> str:
    """The printed sentence, where one is quoted, and what it says."""
    quoted = [claim["printed"]] if claim["printed"] and _is_sentence(claim["printed"]) else []
    return " ".join([*quoted, *filter(None, [claim.get("statement")])])


def _forms(claim: Mapping[str, Any]) -> tuple[tuple[Form, ...], tuple[tuple[Run, ...], ...]]:
    """The printed form, the reading and the corrected form, each compared with the one before it."""
    steps: list[tuple[Form, str]] = []
    if claim["printed"] is not None and not _is_sentence(claim["printed"]):
        steps.append((Form("Printed", claim["printed"]), ""))
    if claim.get("formula"):
        steps.append((Form("Our formula for it", claim["formula"]), ""))
    for key, caption, is_what in (
        ("reading", "Intended reading", "meant"),
        ("corrected", "Corrected", "right"),
    ):
        if claim[key]:
            found, reason = claim[key], tuple(runs_of(without_place(claim[key].get("reason") or "")))
            form = Form(caption, found["latex"], kind=VERDICTS[found["verdict"]], reason=reason)
            steps.append((replace(form, scope=found.get("scope")), is_what))
    forms = [form for form, _ in steps]
    wrong: list[tuple[Run, ...]] = []
    for index, (_, is_what) in list(enumerate(steps))[1:]:
        before, after = forms[index - 1 : index + 1]
        found = difference(before.latex, after.latex)
        wrong.extend(
            tuple(runs) for runs in difference_runs(found, "read" if index > 1 else "printed", is_what)
        )
        if found:
            forms[index - 1] = replace(before, marked=before.marked | found.marked_before)
            forms[index] = replace(after, marked=found.marked_after)
    if claim.get("goal"):
        forms.append(Form("What is shown of it", claim["goal"]))
    forms += [
        _proposed(claim["read_back"] or claim["printed"], proposal) for proposal in claim.get("proposed", ())
    ]
    return tuple(forms), tuple(wrong)


def _proposed(printed: str | None, proposal: Mapping[str, Any]) -> Form:
    """A form that the machine proposes, with what differs from the printed one marked. printed: in the
    machine's spelling, where it could be read."""
    found = difference(printed, proposal["latex"]) if printed is not None else None
    return Form(
        "Proposed by the machine",
        proposal["latex"],
        marked=found.marked_after if found else frozenset(),
        kind=VERDICTS[proposal["verdict"]],
        reason=tuple(runs_of(proposal["edit"])),
    )


def _evidence(claim: Mapping[str, Any]) -> tuple[Evidence, ...]:
    about = [("printed", claim["evidence"])]
    about += [(key, (claim[key] or {}).get("evidence", ())) for key in ("reading", "corrected")]
    return tuple(
        Evidence(of, item["method"], item["outcome"], _figures(item)) for of, items in about for item in items
    )


def _signs(claim: Mapping[str, Any]) -> tuple[str, ...]:
    """The letters of the evidence on the form that is right, or else on what is printed."""
    evidence = _evidence(claim)
    right = next((of for of in ("corrected", "reading") if claim[of]), "printed")
    about = [item for item in evidence if item.of == right] or list(evidence)
    return tuple(sorted({item.sign for item in about} - {None}))


def _figures(item: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    return tuple(
        (key.replace("_", " "), plain_value(value))
        for key, value in item.items()
        if key not in ("method", "outcome", "course")
    )
