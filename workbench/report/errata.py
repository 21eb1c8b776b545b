"""What an editor does: the faults of a paper as edits, errors by what rests on them, the rest by cause."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from workbench.report.kinds import FAULTS
from workbench.report.prose import Run, Values, formula, runs_of, subtract, text, values_of
from workbench.report.residuals import residuals_svg
from workbench.typeset.differences import difference

Claim = Mapping[str, Any]
_CLAIM_ID = re.compile(r"\b[\w+*'-]+(?:\.[\w+*'-]+)+|\b\w+_\w+(?:\.\w+)+")
_PLACE_IN_SOURCE = re.compile(r"(?:cannot be read: )?line \d+, column \d+: ")
_LETTER = re.compile(
    r"\\(?!dot|ddot|dddot|ddddot|tilde|underline|mathbf|boldsymbol|mathrm|left|right|cos|sin)[A-Za-z]+"
)
_OTHERS = "Others."
#: Components of the largest value that is told of a defined symbol: a dual vector.
_SMALL = 6


@dataclass(frozen=True)
class Change:
    """For `old` read `new`; None: what is printed is struck out. marked: what differs in each."""

    old: tuple[Run, ...]
    new: tuple[Run, ...] | None
    marked_old: frozenset[int] = frozenset()
    marked_new: frozenset[int] = frozenset()


@dataclass(frozen=True)
class Counterexample:
    """values: symbol and value, those that are not 0.   rest: whether others are 0.   of: what is false.
    formula: ours, where what is printed is no formula.   defined: what definitions make of the values."""

    of: str
    formula: Run | None
    values: tuple[tuple[Run, Run], ...]
    rest: bool
    defined: tuple[tuple[Run, Run], ...]
    left: Run
    right: Run
    gap: Run | None


@dataclass(frozen=True)
class Correction:
    """One claim with a fault. condition: a missing hypothesis; add: the same in the author's words.
    example: a counterexample in words."""

    id: str
    anchor: str
    heading: str
    place: str | None
    fault: str
    cause: str | None
    changes: tuple[Change, ...]
    said: tuple[Run, ...]
    condition: str | None
    add: tuple[Run, ...]
    why: tuple[Run, ...]
    example: tuple[Run, ...]
    counterexample: Counterexample | None
    picture: str | None
    cost: str | None
    proved: str | None


@dataclass(frozen=True)
class Erratum:
    """The errors of one equation, or of several by one cause, with all that rests on them."""

    heading: str
    cause: str | None
    anchor: str
    corrections: tuple[Correction, ...]
    heirs: tuple[tuple[str, str], ...]

    @property
    def weight(self) -> int:
        """How many equations it changes or bears on."""
        return len({each.heading for each in self.corrections}) + len(self.heirs)


@dataclass(frozen=True)
class Row:
    """The same edit in one equation or in several; shown: the first of these corrections."""

    heading: str
    shown: Correction
    corrections: tuple[Correction, ...]


@dataclass(frozen=True)
class Cause:
    """What several faults have in common, and their edits."""

    name: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class Errata:
    errors: tuple[Erratum, ...]
    by_cause: Mapping[str, tuple[Cause, ...]]
    hypotheses: tuple[Correction, ...]

    @property
    def corrections(self) -> list[Correction]:
        """All of them, in the order of the note."""
        errors = [each for erratum in self.errors for each in erratum.corrections]
        rows = [row for causes in self.by_cause.values() for cause in causes for row in cause.rows]
        tables = [each for row in rows for each in row.corrections]
        return [*errors, *tables, *self.hypotheses]

    @property
    def counts(self) -> dict[str, int]:
        return {fault: sum(each.fault == fault for each in self.corrections) for fault in FAULTS}


def errata_of(claims: Sequence[Claim], places: Mapping[str, tuple[str, str]]) -> Errata:
    """places: claim id → heading and anchor. What the edits of another claim mend is none of its own."""
    faulty = [c for c in claims if c.get("fault") and not (c.get("mend") or {}).get("mended_by")]
    corrections = [_correction(claim, places) for claim in faulty]
    heirs = Heirs(claims, places)
    groups: dict[str, list[Correction]] = {}
    for each in corrections:
        if each.fault == "error":
            groups.setdefault(each.cause or each.heading, []).append(each)
    errors = [_erratum(group, heirs) for group in groups.values()]
    errors.sort(key=lambda erratum: -erratum.weight)
    tables = {
        fault: _grouped([c for c in corrections if c.fault == fault])
        for fault in ("misprint", "transcription", "wording")
    }
    return Errata(tuple(errors), tables, tuple(c for c in corrections if c.fault == "hypothesis"))


def _erratum(group: Sequence[Correction], heirs: Heirs) -> Erratum:
    headings = list(dict.fromkeys(each.heading for each in group))
    group = sorted(group, key=lambda each: -len(heirs.of([each.id], [each.heading])))
    first = group[0]
    return Erratum(
        heading=_joined(headings),
        cause=first.cause,
        anchor=first.anchor,
        corrections=tuple(group),
        heirs=heirs.of([each.id for each in group], headings),
    )


def _joined(headings: Sequence[str]) -> str:
    """Eqs. (37), (107), (108) for Eq. (37), Eq. (107), Eq. (108)."""
    numbers = sorted((heading.removeprefix("Eq. ") for heading in headings), key=lambda n: (len(n), n))
    is_plain = len(headings) == 1 or not all(heading.startswith("Eq. ") for heading in headings)
    return ", ".join(headings) if is_plain else f"Eqs. {', '.join(numbers)}"


class Heirs:
    """What rests on what, in both directions and through any number of steps."""

    def __init__(self, claims: Sequence[Claim], places: Mapping[str, tuple[str, str]]) -> None:
        self.places = places
        self.later: dict[str, set[str]] = {}
        for claim in claims:
            self.later.setdefault(claim["id"], set()).update(claim["inherits"])
            if by := (claim.get("mend") or {}).get("mended_by"):
                self.later.setdefault(by, set()).add(claim["id"])
        self.order = {claim["id"]: place for place, claim in enumerate(claims)}

    def of(self, ids: Iterable[str], own: Collection[str]) -> tuple[tuple[str, str], ...]:
        """Headings and anchors of the equations that rest on these claims, but for their own."""
        waiting, reached = list(ids), set()
        while waiting:
            for heir in self.later.get(waiting.pop(), ()):
                if heir not in reached:
                    reached.add(heir)
                    waiting.append(heir)
        found: dict[str, str] = {}
        for heir in sorted(reached & self.places.keys(), key=lambda name: self.order.get(name, -1)):
            found.setdefault(*self.places[heir])
        return tuple((name, anchor) for name, anchor in found.items() if name not in own)

    def rests_on(self) -> dict[str, list[str]]:
        """Claim → the claims that it inherits a fault from, directly."""
        found: dict[str, list[str]] = {}
        for claim, heirs in self.later.items():
            for heir in sorted(heirs):
                found.setdefault(heir, []).append(claim)
        return found


def _grouped(corrections: Sequence[Correction]) -> tuple[Cause, ...]:
    groups: dict[str, dict[Any, list[Correction]]] = {}
    for each in corrections:
        rows = groups.setdefault(each.cause or _OTHERS, {})
        rows.setdefault(each.changes or each.id, []).append(each)
    return tuple(Cause(cause, tuple(_row(same) for same in rows.values())) for cause, rows in groups.items())


def _row(same: Sequence[Correction]) -> Row:
    headings = list(dict.fromkeys(each.heading for each in same))
    return Row(_joined(headings), same[0], tuple(same))


def with_headings(prose: str, places: Mapping[str, tuple[str, str]]) -> str:
    """A sentence with the names of claims, such as 61.det, as a reader knows them: Eq. (61)."""
    return _CLAIM_ID.sub(lambda name: places[name[0]][0] if name[0] in places else name[0], prose)


def _correction(claim: Claim, places: Mapping[str, tuple[str, str]]) -> Correction:
    heading, anchor = places[claim["id"]]
    mend = claim.get("mend") or {}
    right = claim["corrected"] or claim["reading"]
    sentence = "" if mend.get("edits") else claim.get("statement") or ""
    quoted = claim["printed"] if (claim["printed"] or "").startswith("“") else mend.get("beside")
    shown = _sentence(quoted) if quoted and "$$" not in quoted else ""
    return Correction(
        id=claim["id"],
        anchor=anchor,
        heading=heading,
        place=mend.get("place"),
        fault=claim["fault"],
        cause=mend.get("cause"),
        changes=tuple(_changes(claim, mend)),
        said=tuple(runs_of(shown or sentence)) or _without_correction(claim, mend),
        condition=claim["hypothesis"],
        add=tuple(runs_of(mend.get("add") or "")),
        why=tuple(runs_of(with_headings(claim.get("note") or reason_for_readers(claim), places))),
        example=tuple(runs_of(mend.get("example") or "")),
        counterexample=_counterexample(claim),
        picture=residuals_svg(claim) if claim["fault"] == "error" else None,
        cost=_cost(claim),
        proved=right["latex"] if right else None,
    )


def _cost(claim: Claim) -> str | None:
    """What the error costs on a motion, as a sentence."""
    motion = claim.get("motion") or {}
    return motion["line"][0].upper() + motion["line"][1:] if motion.get("error") else None


def _without_correction(claim: Claim, mend: Mapping[str, Any]) -> tuple[Run, ...]:
    """What is false and nobody has mended yet: the printed formula itself."""
    if mend.get("edits") or claim["corrected"] or claim["reading"] or claim["hypothesis"]:
        return ()
    if not claim["printed"] or claim.get("proposed"):
        return ()
    return (formula(claim["printed"]), text(" is not right, and no correction is known."))


def reason_for_readers(claim: Claim) -> str:
    """Why there is no better verdict, without the place in the source. Where the reading of an ill-formed
    formula is known, what the machine would have guessed of it is not told."""
    if claim["verdict"] == "ill-formed" and (claim["reading"] or claim["corrected"]):
        return ""
    return without_place(claim.get("reason") or "")


def without_place(reason: str) -> str:
    """A reason without the line and column at which the reader of formulas stood."""
    return _PLACE_IN_SOURCE.sub("", reason)


def _sentence(quoted: str) -> str:
    return quoted if len(quoted) < 400 else ""


def _changes(claim: Claim, mend: Mapping[str, Any]) -> Iterable[Change]:
    for edit in mend.get("edits", ()):
        old, new = edit["for"], edit["read"]
        if not edit["is_math"]:
            yield Change(tuple(runs_of(old)), tuple(runs_of(new)) if new.strip() else None)
        else:
            yield _in_formula(_trimmed(old), _trimmed(new))
    proposed = [form for form in claim.get("proposed", ()) if form["verdict"] == "proved"]
    right = claim["corrected"] or claim["reading"] or next(iter(proposed), None)
    printed = claim["printed"] or ""
    if not mend.get("edits") and right and printed and not printed.startswith("“"):
        yield _in_formula(printed, right["latex"])


def _in_formula(old: str, new: str) -> Change:
    found = difference(old, new) if new else None
    marks = (found.marked_before, found.marked_after) if found else (frozenset(), frozenset())
    return Change((formula(old),), (formula(new),) if new else None, *marks)


def _trimmed(latex: str) -> str:
    return latex.replace("&", "").strip()


def _counterexample(claim: Claim) -> Counterexample | None:
    example = claim["counterexample"]
    if example is None or claim["verdict"] == "conditional":
        return None
    sides = (example["lhs"], example["rhs"])
    defined = {
        symbol: values_of(entries)
        for symbol, entries in example.get("defined", {}).items()
        if len(entries) <= _SMALL and entries not in sides
    }
    behind = example.get("behind", ()) if defined else ()
    values = {name: values_of(entries) for name, entries in example["values"].items() if name not in behind}
    shown = {symbol: value for symbol, value in values.items() if not value.is_zero}
    gap = subtract(example["lhs"], example["rhs"])
    ours = claim.get("formula") or claim.get("goal")
    said = ours or claim["printed"] or ""
    return Counterexample(
        of="as it was meant" if claim["verdict"] == "ill-formed" else "as printed",
        formula=formula(ours) if ours else None,
        values=tuple((formula(as_printed(name, said)), _run(value)) for name, value in shown.items()),
        rest=len(shown) < len(values) or (not shown and any(value.is_zero for value in defined.values())),
        defined=tuple(
            (formula(as_printed(name, said)), _run(value))
            for name, value in defined.items()
            if not value.is_zero
        ),
        left=_run(values_of(example["lhs"])),
        right=_run(values_of(example["rhs"])),
        gap=_run(values_of(gap)) if gap is not None else None,
    )


def as_printed(name: str, said: str) -> str:
    """The name of a symbol in the type in which a formula sets its letter: bold, where it stands there in
    bold only."""
    for letter in _LETTER.findall(name):
        for style in (r"\boldsymbol", r"\mathbf"):
            bold = f"{style}{{{letter}}}"
            is_bare = re.search(re.escape(letter) + r"(?![A-Za-z])", said.replace(bold, ""))
            if bold in said and not is_bare and bold not in name:
                return re.sub(re.escape(letter) + r"(?![A-Za-z])", lambda _, b=bold: b, name, count=1)
    return name


def _run(value: Values) -> Run:
    return formula(value.latex) if value.latex is not None else text(value.plain)
