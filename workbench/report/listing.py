"""The listing of `workbench check` on a text: each display once with its grade, the faults, the
corrections."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbench.core.code_labels import suffix
from workbench.core.codes.context_codes import ContextCode
from workbench.core.spans import Span
from workbench.core.verdict import Grade, Outcome
from workbench.papers.texts.text_paper import TextPaper
from workbench.prover.results.claim_results import HOLDS, ClaimResult
from workbench.prover.results.proposed_form import Proposed
from workbench.report.anchors import display_name
from workbench.report.counterexamples import Against, told
from workbench.report.erratum.equation_groups import states_of
from workbench.report.findings import place_of
from workbench.report.shown_kinds import Kind
from workbench.source.documents.source_edits import SourceEdit
from workbench.source.typeset.plain_text import in_plain_text

#: The grades from the most serious on.
_RANKS = (Grade.ERROR, Grade.WARNING, Grade.NOT_JUDGED, Grade.OK, Grade.NOTE)

#: Outcomes that leave nothing open.
_DECIDED = HOLDS | {Outcome.CONDITIONAL}


@dataclass(frozen=True)
class Item:
    """One fault.

    Attributes:
        name: The display, as in "(8) eq:coriolis".
        what: What is wrong, or what to do; formulas between dollar signs.
        edits: Edits of the author's characters.
        proposal: The right form, if no such edit was found.
        proved: Whether the corrected formula is proved.
    """

    grade: Grade
    name: str
    span: Span
    what: str
    edits: tuple[SourceEdit, ...] = ()
    proposal: str = ""
    proved: bool = False
    example: Against | None = None
    unless: tuple[str, ...] = ()


@dataclass(frozen=True)
class Open:
    """Displays that are not judged for one reason, which includes what to do.

    Attributes:
        places: The positions of unread parts.
    """

    names: tuple[str, ...]
    reason: str
    places: tuple[Span, ...] = ()


@dataclass(frozen=True)
class Row:
    """One display. grade: the most serious of its formulas.   results: on each of them."""

    name: str
    grade: Grade
    word: str
    remark: str
    results: tuple[ClaimResult, ...] = field(default=(), repr=False, compare=False)

    @property
    def items(self) -> list[Item]:
        """What is wrong in it."""
        return list(_items(self.results))


@dataclass(frozen=True)
class Listing:
    """The listing of a text.

    Attributes:
        file: As named by the user.
        notes: On unjudged formulas of a wrong display, and on `unread` that a model can do without.
    """

    file: Path
    rows: tuple[Row, ...]
    items: tuple[Item, ...]
    open: tuple[Open, ...]
    notes: tuple[str, ...] = ()

    @property
    def counts(self) -> dict[str, int]:
        """The number of displays in each nonempty class, the most serious first."""
        counted = Counter(row.word for row in self.rows)
        return {word: counted[word] for word in _WORDS if counted[word]}

    @property
    def summary(self) -> str:
        """One line such as: "2 errors, 1 warning, 3 not judged, 8 hold, 5 definitions"."""
        counted = self.counts
        told = ", ".join(_counted(word, count) for word, count in counted.items())
        if counted.keys() & {"error", "warning"}:
            return told
        found = "no new error found" if "known" in counted else "no error found"
        return f"{found}; {told}" if told else "no display"


#: The word of each class and its plural, in the order of a summary. All but two are states of an equation.
_WORDS = {
    "error": "errors",
    "warning": "warnings",
    "misprint": "misprints",
    "wording": "wording",
    "condition missing": "conditions missing",
    "known": "known",
    "not judged": "not judged",
    "not settled": "not settled",
    "holds after a correction": "hold after a correction",
    "holds": "hold",
    "definition": "definitions",
    "lost in our copy": "lost in our copy",
    "left out": "left out",
}


def _counted(word: str, count: int) -> str:
    return f"{count} {word if count == 1 else _WORDS[word]}"


def listing(paper: TextPaper, results: Sequence[ClaimResult]) -> Listing:
    """Returns the results on a text by display."""
    rows: list[Row] = []
    items: list[Item] = []
    open_parts: dict[str, list[ClaimResult]] = {}
    notes: list[str] = []
    for group, states, state in states_of(paper, results):
        own = group.results
        name = display_name(own[0].claim)
        rows.append(replace(_row(name, own, state), results=tuple(own)))
        items += rows[-1].items
        left = [r for r, each in zip(own, states, strict=True) if each.name in ("unjudged", "open")]
        if rows[-1].grade is Grade.NOT_JUDGED:
            open_parts.setdefault(name, []).extend(left)
        elif rows[-1].grade in (Grade.ERROR, Grade.WARNING):
            notes += [
                f"{name}: another formula is not judged: {in_plain_text(str(r.verdict.reason))}" for r in left
            ]
    items.sort(key=lambda item: _RANKS.index(item.grade))
    file = paper.text.path if paper.text else paper.paths[0]
    notes += (
        f"{result.claim.id}: is judged now ({result.verdict.outcome}); its model can do without `unread`"
        for result in results
        if result.passed and result.claim.unread is not None and result.verdict.outcome in HOLDS
    )
    return Listing(file, tuple(rows), tuple(items), tuple(_open(open_parts)), tuple(notes))


def _row(name: str, results: Sequence[ClaimResult], state: Kind) -> Row:
    """Returns the row of a display. A verdict that its model does not expect is an error of the model."""
    shown = [result.shown for result in results]
    wrong = next((grade for grade in (Grade.ERROR, Grade.WARNING) if grade in shown), None)
    if state.name == "unjudged" and all(result.claim.skip is not None for result in results):
        return Row(name, Grade.NOTE, "left out", results[0].claim.skip or "")
    if wrong is not None:
        what = next(_what(result) for result in results if result.shown is wrong)
        return Row(name, wrong, str(wrong), in_plain_text(what))
    if state.name in ("error", "warning") or any(result.known for result in results):
        return Row(name, Grade.NOTE, "known", "")
    if state.name in ("unjudged", "open"):
        reason = next(_why_open(r) for r in results if r.verdict.outcome not in _DECIDED)
        return Row(name, Grade.NOT_JUDGED, state.label, reason)
    if state.name == "holds":
        return Row(name, Grade.OK, "holds", _condition(results))
    grade = Grade.OK if state.name == "inherits" else Grade.NOTE
    return Row(name, grade, state.label, _condition(results))


def _condition(results: Sequence[ClaimResult]) -> str:
    """Returns the first condition under which a formula holds, or else the first range; else ""."""
    for result in results:
        if result.verdict.outcome is Outcome.CONDITIONAL:
            needed = result.verdict.hypothesis
            told = f"if {needed.prose}" if needed else str(result.verdict.reason or "")
            return in_plain_text(told)
    return next((f"for {result.verdict.scope}" for result in results if result.verdict.scope), "")


def _items(results: Sequence[ClaimResult]) -> Iterator[Item]:
    """Yields the faults of a display; formulas that one edit corrects make one item."""
    found: list[Item] = []
    for result in results:
        if not result.is_wrong:
            continue
        own = result.edits
        if own and any(item.edits == own for item in found):
            continue
        proposed = result.proposed[0] if result.proposed else None
        item = Item(
            grade=result.shown,
            name=display_name(result.claim),
            span=place_of(result),
            what=_what_to_do(result, proposed),
            edits=own,
            proposal=proposed.latex if proposed and not own else "",
            proved=proposed is not None and proposed.verdict is Outcome.PROVED,
            example=told(result.counterexample, result.claim.printed.latex)
            if result.counterexample
            else None,
            unless=result.verdict.unless,
        )
        if own:
            item = replace(item, span=replace(item.span, line=own[0].span.line))
        found.append(item)
        yield item


def _what_to_do(result: ClaimResult, proposed: Proposed | None) -> str:
    """Returns the correction, after a reason that it does not show: a lost property."""
    if proposed is None:
        return _what(result)
    is_lost = result.verdict.code is ContextCode.LACKS_PROPERTY
    return f"{_what(result)}; perhaps {proposed.edit}" if is_lost else proposed.edit


def _what(result: ClaimResult) -> str:
    """Returns what is wrong, if no correction is known."""
    verdict = result.verdict
    if verdict.outcome is Outcome.CONDITIONAL and verdict.hypothesis:
        return f"holds only where {verdict.hypothesis.prose}; the text does not say so"
    if verdict.outcome is Outcome.ILL_FORMED:
        return f"the parts do not fit: {verdict.reason}"
    if verdict.outcome is Outcome.REFUTED:
        follows = "does not follow from the step before" if result.claim.chain else "does not hold"
        return f"{follows}: {verdict.reason}" if verdict.reason else follows
    return result.why_not or str(verdict.reason or verdict.outcome)


def _why_open(result: ClaimResult) -> str:
    """Returns why a formula is not judged; of a falsehood, the doubts about it."""
    verdict = result.verdict
    if verdict.outcome in (Outcome.REFUTED, Outcome.ILL_FORMED) and verdict.unless:
        return f"{_what(result)}, unless {' or '.join(verdict.unless)}"
    return str(verdict.reason or "no reason is known")


def _open(equations: Mapping[str, Sequence[ClaimResult]]) -> Iterator[Open]:
    """Yields the unjudged displays by reason, the most frequent reason first."""
    found: dict[str, dict[str, Span | None]] = {}
    for name, results in equations.items():
        for result in results:
            reason = in_plain_text(_why_open(result)) + suffix(result.verdict.reason)
            found.setdefault(reason, {})[name] = result.claim.printed.at
    for reason, names in sorted(found.items(), key=lambda each: -len(each[1])):
        yield Open(tuple(names), reason, tuple(place for place in names.values() if place is not None))
