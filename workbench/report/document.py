"""The report as its readers see it: equations by section, counts, errata. Every format is made from this."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from workbench.report.prose import (
    Run,
    difference_runs,
    formula,
    plain_value,
    runs_of,
    subtract,
    text,
    value_latex,
)
from workbench.typeset.differences import difference


@dataclass(frozen=True)
class Kind:
    """How a verdict is shown. sign: for readers who do not see the colour."""

    verdict: str
    sign: str
    label: str
    meaning: str


KINDS = {
    kind.verdict: kind
    for kind in (
        Kind("proved", "✓", "holds as printed", "proved exactly, and again by a second engine"),
        Kind(
            "definition",
            "≔",
            "definition",
            "nothing to prove; it agrees with what stands before it",
        ),
        Kind("refuted", "✗", "false", "as printed, or garbled and false as meant: a counterexample shows it"),
        Kind("ill-formed", "G", "garbled", "types or time weights do not fit as printed"),
        Kind("conditional", "H", "needs a hypothesis", "proved under a condition the text leaves out"),
        Kind("probable", "≈", "probable, not proved", "random points only"),
        Kind("unchecked", "?", "not checked", "never counted as passed"),
    )
}
ERRATUM_TYPES = {"refuted": "Technical", "ill-formed": "Editorial", "conditional": "Hypothesis"}
_WORST_FIRST = (
    ("refuted", "ill-formed", "conditional", "unchecked", "probable", "proved", "definition")
)  # fmt: skip
_TILES = (
    ("hold as printed", "proved", ("proved", "definition")),
    ("are false", "refuted", ("refuted",)),
    ("are only garbled", "ill-formed", ("ill-formed",)),
    ("need a hypothesis", "conditional", ("conditional",)),
    ("not settled", "unchecked", ("probable", "unchecked")),
)


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
class Counterexample:
    """rows: (what, value) as runs; the last rows are the two sides and their difference."""

    caption: str
    rows: tuple[tuple[Run, Run], ...]


@dataclass(frozen=True)
class Evidence:
    """of: which form it is about: "printed", "reading" or "corrected"."""

    of: str
    method: str
    outcome: str
    figures: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Entry:
    """One claim. anchor: its place in the page; wrong: what exactly is wrong, a sentence each."""

    id: str
    anchor: str
    place: str
    kind: Kind
    gravest: Kind
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
    counterexample: Counterexample | None
    evidence: tuple[Evidence, ...]
    inherits: tuple[tuple[str, str | None], ...]


@dataclass(frozen=True)
class Equation:
    """All claims under one number or name. kind: the worst of its lines."""

    name: str
    heading: str
    anchor: str
    numbered: bool
    kind: Kind
    entries: tuple[Entry, ...]


@dataclass(frozen=True)
class Section:
    name: str
    anchor: str
    equations: tuple[Equation, ...]


@dataclass(frozen=True)
class Tile:
    label: str
    verdict: str
    equations: int
    statements: int


@dataclass(frozen=True)
class Document:
    title: str
    doi: str | None
    versions: tuple[tuple[str, str], ...]
    sections: tuple[Section, ...]
    tiles: tuple[Tile, ...]
    summary: Mapping[str, int] = field(default_factory=dict)

    @property
    def equations(self) -> list[Equation]:
        return [equation for section in self.sections for equation in section.equations]

    @property
    def entries(self) -> list[Entry]:
        return [entry for equation in self.equations for entry in equation.entries]

    @property
    def errata(self) -> list[Entry]:
        return [entry for entry in self.entries if entry.erratum_type]

    @property
    def numbered(self) -> int:
        return sum(equation.numbered for equation in self.equations)

    @property
    def statements(self) -> int:
        return len(self.equations) - self.numbered


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
    sections = []
    for number, (name, in_section) in enumerate(_grouped(claims, lambda c: c["section"] or "")):
        equations = tuple(
            _equation(group, places, anchors) for _, group in _grouped(in_section, _equation_key)
        )
        sections.append(Section(name, f"section-{number + 1}", equations))
    everything = [equation for section in sections for equation in section.equations]
    return Document(
        title=report["paper"]["title"],
        doi=report["paper"]["doi"],
        versions=tuple(report["versions"].items()),
        sections=tuple(sections),
        tiles=tuple(_tile(*tile, everything) for tile in _TILES),
        summary=report["summary"],
    )


def _tile(label: str, verdict: str, verdicts: tuple[str, ...], equations: list[Equation]) -> Tile:
    ours = [equation for equation in equations if equation.kind.verdict in verdicts]
    numbered = sum(equation.numbered for equation in ours)
    return Tile(label, verdict, numbered, len(ours) - numbered)


def _grouped(claims: Iterable[Mapping[str, Any]], key) -> list[tuple[str, list[Mapping[str, Any]]]]:
    groups: dict[str, list[Mapping[str, Any]]] = {}
    for claim in claims:
        groups.setdefault(key(claim), []).append(claim)
    return list(groups.items())


def _equation_key(claim: Mapping[str, Any]) -> str:
    return claim["equation"] or f"id {claim['id']}"


def _is_number(equation: str | None) -> bool:
    return bool(equation and re.fullmatch(r"\d+[a-z]?", equation))


def _heading(claim: Mapping[str, Any]) -> str:
    equation = claim["equation"]
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


def _equation(claims: Sequence[Mapping[str, Any]], places, anchors: _Anchors) -> Equation:
    entries = tuple(_entry(claim, places, anchors) for claim in claims)
    worst = min((entry.gravest for entry in entries), key=lambda kind: _WORST_FIRST.index(kind.verdict))
    first = claims[0]
    return Equation(
        name=first["equation"] or first["id"],
        heading=_heading(first),
        anchor=anchors.equation(first),
        numbered=_is_number(first["equation"]),
        kind=worst,
        entries=entries,
    )


def _entry(claim: Mapping[str, Any], places, anchors: _Anchors) -> Entry:
    forms, wrong = _forms(claim)
    return Entry(
        id=claim["id"],
        anchor=anchors.claim(claim),
        place=_heading(claim),
        kind=KINDS[claim["verdict"]],
        gravest=_gravest(claim),
        erratum_type=ERRATUM_TYPES.get(_gravest(claim).verdict),
        scope=claim["scope"],
        statement=tuple(runs_of(claim.get("statement") or "")),
        reason=tuple(runs_of(claim.get("reason") or "")),
        note=tuple(runs_of(claim["note"] or "")),
        forms=forms,
        read_back=claim["read_back"],
        hypothesis=claim["hypothesis"],
        assume=tuple(claim.get("assume", ())),
        orders=claim.get("orders"),
        unexpected=None if claim.get("passed", True) else claim.get("why_not") or "not as expected",
        wrong=wrong,
        counterexample=_counterexample(claim),
        evidence=_evidence(claim),
        inherits=tuple(places.get(heir, (heir, None)) for heir in claim["inherits"]),
    )


def _gravest(claim: Mapping[str, Any]) -> Kind:
    """A garbled formula that is false even as it was meant counts as false."""
    if claim["verdict"] == "ill-formed" and (claim["reading"] or {}).get("verdict") == "refuted":
        return KINDS["refuted"]
    return KINDS[claim["verdict"]]


def _forms(claim: Mapping[str, Any]) -> tuple[tuple[Form, ...], tuple[tuple[Run, ...], ...]]:
    """The printed form, the reading and the corrected form, each compared with the one before it."""
    steps: list[tuple[Form, str]] = []
    if claim["printed"] is not None and claim["printed"] != claim.get("statement"):
        steps.append((Form("Printed", claim["printed"]), ""))
    for key, caption, is_what in (
        ("reading", "Intended reading", "meant"),
        ("corrected", "Corrected", "right"),
    ):
        if claim[key]:
            found, reason = claim[key], tuple(runs_of(claim[key].get("reason") or ""))
            form = Form(caption, found["latex"], kind=KINDS[found["verdict"]], reason=reason)
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
        kind=KINDS[proposal["verdict"]],
        reason=tuple(runs_of(proposal["edit"])),
    )


def _counterexample(claim: Mapping[str, Any]) -> Counterexample | None:
    example = claim["counterexample"]
    if example is None:
        return None
    caption = "Where the hypothesis fails" if claim["verdict"] == "conditional" else "Counterexample"
    if claim["verdict"] == "ill-formed":
        caption = "Counterexample to the reading"
    rows = [(formula(symbol), _value(entries)) for symbol, entries in example["values"].items()]
    rows.append((text("left side"), _value(example["lhs"])))
    rows.append((text("right side"), _value(example["rhs"])))
    gap = subtract(example["lhs"], example["rhs"])
    if gap is not None:
        rows.append((text("left − right"), _value(gap)))
    return Counterexample(caption, tuple(rows))


def _value(entries: Sequence[str] | str) -> Run:
    latex = value_latex(entries)
    if latex is not None:
        return formula(latex)
    return text(entries if isinstance(entries, str) else ", ".join(entries))


def _evidence(claim: Mapping[str, Any]) -> tuple[Evidence, ...]:
    about = [("printed", claim["evidence"])]
    about += [(key, (claim[key] or {}).get("evidence", ())) for key in ("reading", "corrected")]
    return tuple(
        Evidence(of, item["method"], item["outcome"], _figures(item)) for of, items in about for item in items
    )


def _figures(item: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    return tuple(
        (key.replace("_", " "), plain_value(value))
        for key, value in item.items()
        if key not in ("method", "outcome")
    )
