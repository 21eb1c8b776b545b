"""The table of errors: one row for each wrong equation, with its first edit and a short description."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from workbench.core.verdict import Outcome
from workbench.prover.results.motion_summary import Cost
from workbench.report.anchors import Place
from workbench.report.counterexamples import Against
from workbench.report.erratum.equation_entries import Entry, Equation
from workbench.report.erratum.errata import Change
from workbench.report.mixed_prose import is_one_formula, runs_of
from workbench.report.shown_kinds import STATES
from workbench.source.typeset.differences import Change as Difference
from workbench.source.typeset.differences import difference
from workbench.source.typeset.excerpts import left_side
from workbench.source.typeset.glyphs import SYMBOLS

#: (sign in the column "Verified", its meaning).
TWICE = ("✓✓", "proved by two engines")
AGREES = ("✓", "a definition; agrees with the equations that use it")
FALSE = ("✗", "false by a counterexample; no correction is known")

#: The length from which causes do not fit into a column.
_LONG_CAUSE = 42
_LONG_GIST = 48
_REWRITTEN = "wrong expression"
_WORDS = {
    "sign": ("wrong sign", "sign missing", "sign too many"),
    "number": ("wrong factor", "factor {} missing", "factor too many"),
    "exponent": ("wrong exponent", "exponent missing", "exponent too many"),
    "index": ("wrong index", "index missing", "index too many"),
    "operator": ("wrong operator", "{} missing", "operator too many"),
    "mark": ("mark missing", "mark missing", "mark too many"),
    "symbol": ("wrong letter", "letter missing", "letter too many"),
    "bracket": ("wrong bracket", "bracket missing", "bracket too many"),
    "part": ("wrong term", "a factor is missing", "a term too many"),
}


@dataclass(frozen=True)
class ErrorRow:
    """A row of the table.

    Attributes:
        of: The left side of the wrong equation.
        change: The first edit.
        more: The number of further edits.
        corrected_with: The equation whose edits correct this one.
        example: A counterexample, if no correction is known.
    """

    label: str
    anchor: str
    counted: bool
    of: tuple[str, ...]
    change: Change | None
    more: int
    corrected_with: Place | None
    example: Against | None
    gist: str
    verified: tuple[str, str] | None
    certified: bool
    cost: Cost | None


def error_rows(equations: Sequence[Equation]) -> tuple[ErrorRow, ...]:
    """Returns the rows in the order of the text."""
    return tuple(_row(each) for each in equations if each.state is STATES["error"])


def _row(equation: Equation) -> ErrorRow:
    wrong = [entry for entry in equation.entries if entry.state is STATES["error"]]
    corrections = [entry.correction for entry in wrong if entry.correction is not None]
    changes = [change for each in corrections for change in each.changes]
    main = next((e for e in wrong if e.correction and e.correction.changes), wrong[0])
    costs = [entry.result.on_motions.error for entry in wrong]
    return ErrorRow(
        label=equation.label,
        anchor=equation.anchor,
        counted=equation.counted,
        of=_left_sides(wrong, changes),
        change=changes[0] if changes else None,
        more=max(0, len(changes) - 1),
        corrected_with=None if changes else main.mended_by,
        example=main.correction.counterexample if main.correction and not changes else None,
        gist=gist_of(main),
        verified=_verified(main),
        certified=_is_certified(main),
        cost=max(filter(None, costs), key=lambda cost: cost.false, default=None),
    )


def _left_sides(wrong: Sequence[Entry], changes: Sequence[Change]) -> tuple[str, ...]:
    """Returns up to two left sides: of the wrong formulas, of the replaced ones, or of those in the wrong
    sentences."""
    claims = [entry.result.claim for entry in wrong if not entry.result.claim.proof.goal]
    shown = [claim.displayed or claim.our_formula for claim in claims]
    replaced = [run.content for change in changes for run in change.old if is_one_formula(change.old)]
    said = [run.content for c in claims for run in runs_of(c.sentence.quote or "") if run.is_math]
    for formulas in (shown, replaced, said):
        if sides := [side for latex in formulas if latex and (side := left_side(latex)) is not None]:
            return tuple(dict.fromkeys(sides))[:2]
    return ()


def _verified(entry: Entry) -> tuple[str, str] | None:
    outcomes = [verdict.outcome for verdict in entry.result.verdicts.values()]
    outcomes += [each.verdict for each in entry.result.proposed or ()]
    if Outcome.PROVED in outcomes:
        return TWICE
    if Outcome.DEFINITION in outcomes:
        return AGREES
    return FALSE if entry.result.counterexample is not None else None


def _is_certified(entry: Entry) -> bool:
    right = list(entry.result.verdicts)[-1]
    return any(each.form == right and each.checked_by for each in entry.result.certificates or ())


def gist_of(entry: Entry) -> str:
    """Returns the error in a few words: the common cause of several errors, or the subject of the edits."""
    if entry.mended_by is not None:
        return "follows from it"
    correction = entry.correction
    if correction is None or not (correction.changes or correction.cause):
        reason = entry.result.verdict.outcome is Outcome.ILL_FORMED
        return "the sizes of the two sides do not fit" if reason else "the two sides differ"
    cause = (correction.cause or "").split(";")[0].rstrip(".")
    if cause and ":" not in cause and len(cause) <= _LONG_CAUSE:
        return cause[0].lower() + cause[1:]
    said = ""
    counted = _counted(correction.changes)
    for words, count in counted:
        if words == _REWRITTEN and len(counted) > 1:
            continue
        more = f"{said}, {words}" if said else words
        more += f", in {count} places" * (count > 1)
        if said and len(more) > _LONG_GIST:
            break
        said = more
    return said


def _counted(changes: Sequence[Change]) -> list[tuple[str, int]]:
    found = [words for change in changes for words in dict.fromkeys(_words_of(change))]
    return [(words, found.count(words)) for words in dict.fromkeys(found)]


def _words_of(change: Change) -> Iterator[str]:
    if len(change.old) != 1 or not change.old[0].is_math:
        yield "wrong words"
        return
    if not change.new:
        yield "a term too many"
        return
    compared = difference(change.old[0].content, change.new[0].content)
    if compared is None or compared.rewritten:
        yield _REWRITTEN
        return
    for each in compared.changes:
        yield _words_for(each)


def _letter(part: str | None) -> str:
    """Returns the letter of one symbol with its scripts."""
    return (
        re.split(r" [_^]", part or "")[0] if part and not re.search(r"[+=]| - ", part.split("{")[0]) else ""
    )


def _words_for(found: Difference) -> str:
    both, missing, too_many = _WORDS[found.kind]
    if found.kind == "part" and _letter(found.before) and _letter(found.before) == _letter(found.after):
        return "wrong index"
    if found.kind == "part" and found.before is None and (found.after or "").startswith(("+", "-")):
        return "a term is missing"
    if found.before is not None:
        return both if found.after is not None else too_many
    return missing.format(SYMBOLS.get(found.after or "", found.after))
