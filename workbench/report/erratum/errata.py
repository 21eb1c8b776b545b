"""Errata for an editor: edits of the paper, errors ordered by their consequences, other faults by cause."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from workbench.context.claim_parts import FAULTS
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.reasons import Reason
from workbench.core.verdict import Outcome
from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.motion_summary import percent
from workbench.report.anchors import Heirs, Place, joined, with_headings
from workbench.report.claim_states import fault_of
from workbench.report.counterexamples import Against, against
from workbench.report.mixed_prose import (
    Run,
    formula,
    power_of_ten,
    runs_of,
    runs_with_symbols,
    text,
)
from workbench.source.typeset.differences import difference

_OTHERS = "Others."
#: The length from which a corrected sentence is no longer quoted.
_LONG_QUOTE = 400


@dataclass(frozen=True)
class Change:
    """A replacement of `old` by `new`; None deletes it. marked: the differing leaves of each."""

    old: tuple[Run, ...]
    new: tuple[Run, ...] | None
    marked_old: frozenset[int] = frozenset()
    marked_new: frozenset[int] = frozenset()


@dataclass(frozen=True)
class Correction:
    """One claim with a fault.

    Attributes:
        add: The missing hypothesis, in the author's words if the text has them.
        example: A counterexample in words.
    """

    id: str
    anchor: str
    heading: str
    place: str | None
    fault: str
    cause: str | None
    changes: tuple[Change, ...]
    said: tuple[Run, ...]
    add: tuple[Run, ...]
    why: tuple[Run, ...]
    example: tuple[Run, ...]
    counterexample: Against | None
    cost: str | None


@dataclass(frozen=True)
class Erratum:
    """The errors of one equation, or of several with one cause, and the equations that depend on them."""

    heading: str
    cause: str | None
    anchor: str
    corrections: tuple[Correction, ...]
    heirs: tuple[Place, ...]

    @property
    def weight(self) -> int:
        """The number of equations that it changes or affects."""
        return len({each.heading for each in self.corrections}) + len(self.heirs)


@dataclass(frozen=True)
class Row:
    """The same edit in one or several equations. shown: the first of these corrections."""

    heading: str
    shown: Correction
    corrections: tuple[Correction, ...]


@dataclass(frozen=True)
class Cause:
    """A common cause of several faults, with their edits."""

    name: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class Errata:
    errors: tuple[Erratum, ...]
    by_cause: Mapping[str, tuple[Cause, ...]]
    hypotheses: tuple[Correction, ...]

    @property
    def corrections(self) -> list[Correction]:
        """All corrections, in the order of the note."""
        errors = [each for erratum in self.errors for each in erratum.corrections]
        rows = [row for causes in self.by_cause.values() for cause in causes for row in cause.rows]
        tables = [each for row in rows for each in row.corrections]
        return [*errors, *tables, *self.hypotheses]

    @property
    def counts(self) -> dict[str, int]:
        return {
            fault: sum(each.fault == fault for each in self.corrections) for fault in (*FAULTS, "warning")
        }


def errata_of(results: Sequence[ClaimResult], places: Mapping[str, Place], heirs: Heirs) -> Errata:
    """Returns the errata. places: of the claims. A claim that another claim's edits correct has no entry."""
    of_name = Counter(places[result.claim.id][0] for result in results)
    corrections = [
        _correction(result, fault, places, of_name[places[result.claim.id][0]] > 1)
        for result in results
        if (fault := fault_of(result)) and not result.claim.mend.by
    ]
    groups: dict[str, list[Correction]] = {}
    for each in corrections:
        if each.fault == "error":
            groups.setdefault(each.cause or each.heading, []).append(each)
    errors = [_erratum(group, heirs) for group in groups.values()]
    errors.sort(key=lambda erratum: -erratum.weight)
    tables = {
        fault: _grouped([c for c in corrections if c.fault == fault])
        for fault in ("warning", "misprint", "transcription", "wording")
    }
    return Errata(tuple(errors), tables, tuple(c for c in corrections if c.fault == "hypothesis"))


def _erratum(group: Sequence[Correction], heirs: Heirs) -> Erratum:
    headings = list(dict.fromkeys(each.heading for each in group))
    group = sorted(group, key=lambda each: -len(heirs.of([each.id], [each.heading])))
    first = group[0]
    return Erratum(
        heading=joined(headings),
        cause=first.cause,
        anchor=first.anchor,
        corrections=tuple(group),
        heirs=heirs.of([each.id for each in group], headings),
    )


def _grouped(corrections: Sequence[Correction]) -> tuple[Cause, ...]:
    groups: dict[str, dict[Hashable, list[Correction]]] = {}
    for each in corrections:
        rows = groups.setdefault(each.cause or _OTHERS, {})
        rows.setdefault(each.changes or each.id, []).append(each)
    return tuple(Cause(cause, tuple(_row(same) for same in rows.values())) for cause, rows in groups.items())


def _row(same: Sequence[Correction]) -> Row:
    headings = list(dict.fromkeys(each.heading for each in same))
    return Row(joined(headings), same[0], tuple(same))


def _correction(
    result: ClaimResult, fault: str, places: Mapping[str, Place], is_one_of_several: bool
) -> Correction:
    """is_one_of_several: whether other claims have its name, so that its line in the text tells it apart."""
    claim, mend = result.claim, result.claim.mend
    heading, anchor = places[claim.id]
    span = claim.context.span
    return Correction(
        id=claim.id,
        anchor=anchor,
        heading=heading,
        place=mend.place or (f"line {span.line}" if span and is_one_of_several else None),
        fault=fault,
        cause=mend.cause,
        changes=tuple(_changes(result)),
        said=tuple(_said(result)),
        add=tuple(runs_of(mend.add or (result.hypothesis.prose if result.hypothesis else ""))),
        why=tuple(_why(result, places)),
        example=tuple(runs_of(mend.example or "")),
        counterexample=against(result),
        cost=cost_in_words(result),
    )


def _why(result: ClaimResult, places: Mapping[str, Place]) -> list[Run]:
    """Returns the author's note on the claim, or the reason of its verdict."""
    if note := result.claim.source.note:
        return runs_of(with_headings(note, places))
    return runs_with_symbols(with_headings(reason_for_readers(result), places))


def cost_in_words(result: ClaimResult) -> str | None:
    """Returns the size of the error on a motion in words; None for a sentence, which is not what was
    evaluated."""
    error = result.on_motions.error
    if error is None or result.claim.sentence.quote:
        return None
    factor, exponent = f"{error.right:.0e}".split("e")
    motion = error.motion.split(", seed")[0]
    return (
        f"Simulated on {motion}, the sides differ by up to {percent(error.false)} as printed, "
        f"by less than {power_of_ten(int(exponent), int(factor))} as corrected"
    )


def _said(result: ClaimResult) -> list[Run]:
    """Returns the wrong sentence, or the wrong formula if no correction is known."""
    claim = result.claim
    quoted = claim.mend.beside if claim.sentence.ours or not claim.sentence.quote else claim.sentence.quote
    if quoted and "$$" not in quoted and len(quoted) < _LONG_QUOTE:
        return runs_of(quoted)
    if claim.mend.edits:
        return []
    if claim.source.statement:
        return runs_of(claim.source.statement)
    if result.right or result.hypothesis or result.proposed or not claim.shown:
        return []
    return [formula(claim.shown), text(" is not right, and no correction is known.")]


def reason_for_readers(result: ClaimResult) -> str:
    """Returns the reason of the verdict without the position in the source.

    The reason of an ill-formed formula is left out if its intended reading is known.
    """
    if result.verdict.outcome is Outcome.ILL_FORMED and result.right:
        return ""
    return without_place(result.verdict.reason or "")


def without_place(reason: str) -> str:
    """Returns the reason without the line and column of a syntax error."""
    if not isinstance(reason, Reason):
        return reason
    why = reason.arguments.get("why")
    if reason.code is SyntaxCode.CANNOT_BE_READ and isinstance(why, Reason) and why.position:
        return without_place(why)
    return Reason(reason.code, {name: without_place(value) for name, value in reason.arguments.items()})


def _changes(result: ClaimResult) -> Iterator[Change]:
    claim = result.claim
    for edit in claim.mend.edits:
        if edit.is_math:
            yield _in_formula(_trimmed(edit.old), _trimmed(edit.new))
        else:
            yield Change(tuple(runs_of(edit.old)), tuple(runs_of(edit.new)) if edit.new.strip() else None)
    proved = (form for form in result.proposed or () if form.verdict is Outcome.PROVED)
    right = result.right or next(proved, None)
    if right and claim.displayed and not claim.mend.edits:
        is_first = right is next(iter(result.proposed or ()), None)
        yield _in_formula(claim.displayed, (result.edited if is_first else None) or right.latex)


def _in_formula(old: str, new: str) -> Change:
    found = difference(old, new) if new else None
    marks = (found.marked_before, found.marked_after) if found else (frozenset(), frozenset())
    return Change((formula(old),), (formula(new),) if new else None, *marks)


def _trimmed(latex: str) -> str:
    return latex.replace("&", "").strip()
