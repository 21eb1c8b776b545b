"""Functions for the templates of the HTML page: formulas as MathML, one-line edits, rows of evidence."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import Any

from markupsafe import Markup, escape

from workbench.prover.results.motion_summary import METHOD
from workbench.report import wording
from workbench.report.document import Class
from workbench.report.erratum.equation_entries import Entry, Form
from workbench.report.erratum.errata import Change
from workbench.report.erratum.error_rows import ErrorRow
from workbench.report.mathml import mathml
from workbench.report.mixed_prose import Run, formula, minus, runs_of, text
from workbench.report.pictures import spark_line
from workbench.source.typeset.excerpts import excerpts, in_one_line

_MATH_FAILED = "This formula could not be typeset for certain; this is its LaTeX source."
#: The number of characters of a formula that fit into a cell of the error table, for each of two forms.
_CELL = 22
_SHOWN_FIGURES = ("residual", "residuals_below", "samples")


def math(latex: str, marked: frozenset[int] = frozenset(), mark: str = "changed") -> Markup:
    """Returns MathML, or the LaTeX source marked as source."""
    converted = mathml(latex, False, marked, mark)
    if converted is not None:
        return Markup(converted.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "", 1))
    return Markup('<code class="source" title="{}">{}</code><span class="source-sign">{}</span>').format(
        _MATH_FAILED, latex, " (LaTeX source)"
    )


def runs(sentence: Sequence[Run]) -> Markup:
    return Markup("").join(
        math(run.content) if run.is_math else escape(minus(run.content)) for run in sentence
    )


@dataclass(frozen=True)
class InOneLine:
    """An edit for a cell of a table. words: for an edit of words, the pieces kept, removed and inserted."""

    old: tuple[Run, ...]
    new: tuple[Run, ...] | None
    marked_old: frozenset[int]
    marked_new: frozenset[int]
    words: tuple[tuple[str, Run], ...]


def short_change(change: Change, width: int = _CELL) -> InOneLine:
    """Returns the edit, cut to the surroundings of its first mark if it is long."""
    old, new = change.old, change.new
    if new is None or not (len(old) == len(new) == 1 and old[0].is_math and new[0].is_math):
        words = tuple(_words(old, new or ())) if not old[0].is_math or len(old) > 1 else ()
        return InOneLine(old, new, change.marked_old, change.marked_new, words)
    cut = excerpts(old[0].content, new[0].content, change.marked_old, change.marked_new, width)
    whole = ((old[0].content, change.marked_old), (new[0].content, change.marked_new))
    (before, marked_old), (after, marked_new) = (in_one_line(*each) for each in cut or whole)
    return InOneLine((formula(before),), (formula(after),), marked_old, marked_new, ())


def _words(old: Sequence[Run], new: Sequence[Run]) -> Iterator[tuple[str, Run]]:
    before, after = (list(_pieces(sentence)) for sentence in (old, new))
    for kind, a, b, c, d in SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        for piece in before[a:b]:
            yield ("same" if kind == "equal" else "del"), piece
        for piece in () if kind == "equal" else after[c:d]:
            yield "ins", piece


def _pieces(sentence: Sequence[Run]) -> Iterator[Run]:
    for run in sentence:
        if run.is_math:
            yield run
        else:
            yield from map(text, re.findall(r"\s*\S+\s*|\s+", run.content))


def evidence(entry: Entry) -> Iterator[tuple[str, str, str, int, str]]:
    """Yields form, method, outcome, count and figures of each kind of evidence."""
    rows = [
        (item.of, wording.method(item.method), item.outcome, _figures(dict(item.figures), item.method))
        for item in entry.evidence
    ]
    for row, count in Counter(rows).items():
        yield *row[:3], count, row[3]


def _figures(figures: Mapping[str, str], name: str) -> str:
    if name != METHOD:
        return ""
    told = [f"{key} {figures[key]}" for key in _SHOWN_FIGURES if key in figures]
    return f"({'; '.join(told)})" if told else ""


def row_counts(rows: Sequence[ErrorRow]) -> str:
    """Returns a count such as: 19 equations and Theorem 2."""
    counted = sum(row.counted for row in rows)
    names = [row.label for row in rows if not row.counted]
    if len(names) > 2:
        names = [f"{len(names)} other statements"]
    return " and ".join(([wording.equations(counted)] if counted else []) + names)


def class_counts(each: Class) -> str:
    """Returns a count such as: 12 equations and 2 other statements."""
    others = len(each.statements)
    told = [wording.equations(each.count)] if each.count else []
    told += [f"{others} other statement" + "s" * (others != 1)] if others else []
    return " and ".join(told)


def _corrected(form: Form) -> str:
    return wording.corrected(form.kind.name, form.scope) if form.kind else ""


FILTERS: dict[str, Callable[..., Any]] = {
    "math": math,
    "runs": runs,
    "condition": lambda hypothesis: runs(runs_of(hypothesis.prose)),
    "minus": minus,
    "short_change": short_change,
    "evidence": evidence,
    "row_counts": row_counts,
    "class_counts": class_counts,
    "corrected": _corrected,
    "spark": lambda entry: spark_line(entry.result) if entry.fault == "error" else None,
    "counts_line": wording.counts_line,
    "counted": wording.counted,
    "told": wording.told,
    "strip_sign": lambda kind: "" if kind.name == "holds" else kind.sign,
}
