"""The content of a report: equations by section, counts, errata. Every format is made from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from workbench.context.claims import Paper
from workbench.prover.results.claim_results import ClaimResult
from workbench.report.anchors import Heirs, Place, Places
from workbench.report.counts import summary, versions
from workbench.report.erratum.equation_entries import Entry, Equation, entry_of, equation_of
from workbench.report.erratum.equation_groups import groups_of
from workbench.report.erratum.errata import Errata, errata_of
from workbench.report.erratum.error_rows import ErrorRow, error_rows
from workbench.report.mixed_prose import Run, runs_of
from workbench.report.motion_coverage import Motions, motions_of
from workbench.report.shown_kinds import SHOWN, Kind


@dataclass(frozen=True)
class Section:
    """A section. number: the beginning of its name."""

    number: str
    name: str
    anchor: str
    equations: tuple[Equation, ...]

    def count(self, state: str) -> int:
        """Returns the number of its equations in a state."""
        return sum(each.counted and each.state.name == state for each in self.equations)

    @property
    def counted(self) -> int:
        return sum(each.counted for each in self.equations)


@dataclass(frozen=True)
class Class:
    """The equations in one state, and the theorems and remarks in it."""

    kind: Kind
    equations: tuple[Equation, ...]
    statements: tuple[Equation, ...]

    @property
    def count(self) -> int:
        return len(self.equations)


@dataclass(frozen=True)
class Document:
    """A report. classes: the nonempty ones, in the order of the page."""

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
        """(author, book or journal, and year in one line,), or () if they are unknown."""
        found = [self.citation[key] for key in ("authors", "source", "year") if key in self.citation]
        found = [each.split(" (")[0] for each in found]
        return (", ".join(found),) if found else ()

    @property
    def transcribed(self) -> bool:
        """True if a transcription was read, not the print itself."""
        return "transcription" in self.citation.get("read", "")

    @property
    def title_runs(self) -> tuple[Run, ...]:
        return tuple(runs_of(self.title))

    @property
    def unjudged(self) -> tuple[tuple[tuple[Run, ...], tuple[Place, ...]], ...]:
        """The reasons why equations were not judged, each with its equations, the most frequent one first."""
        groups: dict[tuple[Run, ...], dict[Place, None]] = {}
        for equation in self.equations:
            for entry in equation.entries if equation.state.name == "unjudged" else ():
                if entry.state.name == "unjudged":
                    place = (equation.label, equation.anchor)
                    groups.setdefault(entry.reason, {})[place] = None
        found = sorted(groups.items(), key=lambda each: -len(each[1]))
        return tuple((reason, tuple(places)) for reason, places in found)

    @property
    def has_sections(self) -> bool:
        return any(section.name for section in self.sections)

    def in_state(self, name: str) -> int:
        """Returns the number of equations in a state."""
        return next((each.count for each in self.classes if each.kind.name == name), 0)


def document_of(paper: Paper, results: Sequence[ClaimResult]) -> Document:
    groups = [group.results for group in groups_of(paper, results)]
    places = Places([[result.claim for result in group] for group in groups])
    heirs = Heirs(results, places.claims)
    errata = errata_of(results, places.claims, heirs)
    entry = partial(entry_of, places, heirs, {each.id: each for each in errata.corrections})
    equations = [equation_of(places, list(map(entry, group))) for group in groups]
    return Document(
        title=paper.title,
        citation={**paper.citation, **({"doi": paper.doi} if paper.doi else {})},
        versions=tuple(versions().items()),
        sections=tuple(_sections(equations, paper.sections)),
        classes=tuple(each for kind in SHOWN if (each := _class(kind, equations)) is not None),
        rows=error_rows(equations),
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
    """Returns the sections in reading order. names: titles of sections that claims name by number."""
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
