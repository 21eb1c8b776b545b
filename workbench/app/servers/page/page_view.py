"""JSON of a text for the page: its displays with marks, corrections, questions and assumptions."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import escape

from workbench.app.pipeline.judged_files import Judged
from workbench.app.servers.result_words import faults_in_words
from workbench.core.spans import Span
from workbench.core.verdict import Grade, Outcome
from workbench.papers.texts.text_paper import TextPaper
from workbench.report.counterexamples import Against
from workbench.report.findings import findings, place_of
from workbench.report.html_page import math, runs
from workbench.report.listing import Item, Row, listing
from workbench.report.mixed_prose import runs_with_symbols
from workbench.source.documents.source_edits import SourceEdit

if TYPE_CHECKING:
    from workbench.core.paper_errors import PaperError
    from workbench.papers.drafting.drafted_texts import Draft
    from workbench.papers.drafting.questions_to_author import Answer
    from workbench.prover.results.claim_results import ClaimResult

#: The kinds offered for a symbol of a drafted model, in addition to inferred ones.
KINDS = ("scalar", "vector", "tensor", "rotation", "quaternion")


class Places:
    """Converts positions of a text to the browser's units, UTF-16."""

    def __init__(self, text: str) -> None:
        self._starts, self._lines = [0], text.split("\n")
        for line in self._lines:
            self._starts.append(self._starts[-1] + _units(line) + 1)

    def at(self, line: int, column: int) -> int:
        """Returns the offset of a position that is counted from 1."""
        line = min(max(line, 1), len(self._lines))
        return self._starts[line - 1] + _units(self._lines[line - 1][: max(column - 1, 0)])

    def of(self, span: Span) -> list[int]:
        return [self.at(span.line, span.column), self.at(span.end_line, span.end_column)]


def _units(text: str) -> int:
    return len(text) + sum(sign > "\uffff" for sign in text)


def page_view(judged: Judged, file: Path, text: str, answers: Sequence[Answer] = ()) -> dict[str, Any]:
    """Returns the JSON of a judged text. text: the content of the editor."""
    paper, results = judged.paper, judged.results
    assert isinstance(paper, TextPaper)
    places, own = Places(text), file.resolve()
    found = listing(paper, results)
    return {
        "summary": found.summary,
        "counts": found.counts,
        "displays": [_display(row, places, own) for row in found.rows],
        "findings": [
            {"level": each.level, "message": each.message, "place": places.of(each.span)}
            for each in findings(paper, results)
            if each.span.file.resolve() == own and each.level != "note"
        ],
        "faults": faults_in_words((*paper.faults, *paper.warnings), file),
        "drafted": judged.draft is not None,
        "questions": list(_questions(judged.draft, results)) if judged.draft else [],
        "assumptions": list(_assumptions(judged.draft, answers)) if judged.draft else [],
    }


def fault_view(faults: Sequence[PaperError], file: Path) -> dict[str, Any]:
    """Returns the JSON of a text that cannot be judged. file: the text, which its faults need not name."""
    empty: dict[str, Any] = {"counts": {}, "displays": [], "findings": [], "questions": [], "assumptions": []}
    return {"summary": "", "faults": faults_in_words(faults, file), "drafted": False, **empty}


def _display(row: Row, places: Places, own: Path) -> dict[str, Any]:
    span = row.results[0].claim.context.span or place_of(row.results[0])
    last = row.results[-1].claim.context.span or place_of(row.results[-1])
    is_own = span.file.resolve() == own
    return {
        "name": row.name,
        "line": span.line,
        "file": None if is_own else span.file.name,
        "place": [places.of(span)[0], places.of(last)[1]] if is_own else None,
        "grade": str(row.grade),
        "word": row.word,
        "remark": _prose(row.remark),
        "formulas": [_formula(result) for result in row.results],
        "items": [_item(item, places, own) for item in row.items],
        "details": [_details(result) for result in row.results],
    }


def _formula(result: ClaimResult) -> dict[str, Any]:
    return {"html": _math(result.claim.printed.latex), "grade": str(result.shown)}


def _item(item: Item, places: Places, own: Path) -> dict[str, Any]:
    is_own = bool(item.edits) and all(edit.span.file.resolve() == own for edit in item.edits)
    return {
        "what": _prose(item.what),
        "proved": item.proved,
        "unless": [_prose(each) for each in item.unless],
        "example": _example(item.example) if item.example else None,
        "proposal": _math(item.proposal) if item.proposal else None,
        "diff": _changed_lines(item.edits),
        "edits": [{"place": places.of(edit.span), "new": edit.new} for edit in item.edits] if is_own else [],
    }


def _changed_lines(edits: Sequence[SourceEdit]) -> list[dict[str, Any]]:
    """Returns the edited lines of the author, each in pieces that are kept, removed or inserted."""
    made: list[dict[str, Any]] = []
    end = -1
    for edit in sorted(edits, key=lambda each: (str(each.span.file), each.start)):
        text = edit.source.text
        if made and text.find("\n", end, edit.start) < 0:
            made[-1]["parts"][-1:] = [["same", text[end : edit.start]]]
        else:
            first = text.rfind("\n", 0, edit.start) + 1
            same = ["same", text[first : edit.start].lstrip()]
            made.append({"line": edit.span.line, "parts": [same]})
        last = text.find("\n", edit.end)
        rest = text[edit.end : last if last >= 0 else len(text)].rstrip()
        made[-1]["parts"] += [["del", edit.old], ["ins", edit.new], ["same", rest]]
        end = edit.end
    return made


def _example(example: Against) -> dict[str, Any]:
    values = [f"{_math(name)} = {escape(value)}" for name, value in (*example.values, *example.defined)]
    rest = ("all else 0" if values else "all symbols 0") if example.rest else ""
    given = ", ".join([*values, *([rest] if rest else [])])
    return {"with": given, "left": str(escape(example.left)), "right": str(escape(example.right))}


def _details(result: ClaimResult) -> dict[str, Any]:
    verdict = result.verdict
    read = verdict.read_back
    return {
        "id": result.claim.id,
        "verdict": str(verdict.outcome) + (f" ({verdict.scope})" if verdict.scope else ""),
        "basis": str(verdict.basis),
        "read": _math(read) if read else None,
        "holds_if": _prose(verdict.hypothesis.prose) if verdict.hypothesis else None,
        "because": _prose(str(verdict.reason)) if verdict.reason else None,
        "code": verdict.code.slug if verdict.code and result.shown is not Grade.OK else None,
        "evidence": [f"{each.method}: {each.outcome}" for each in verdict.evidence]
        if verdict.outcome is Outcome.PROVED
        else [],
    }


def _questions(draft: Draft, results: Sequence[ClaimResult]) -> Iterator[dict[str, Any]]:
    from workbench.papers.drafting.questions_to_author import questions_about

    for question in questions_about(draft, results):
        yield {
            "text": question.text,
            "line": question.line,
            "settles": len(question.settles),
            "answers": [
                {"table": each.table, "key": each.key, "value": each.value, "lines": " ".join(each.lines)}
                for each in question.answers
            ],
        }


def _assumptions(draft: Draft, answers: Sequence[Answer]) -> Iterator[dict[str, Any]]:
    """Yields the kind of each symbol, guesses first, with its reason and alternatives."""
    from workbench.papers.drafting.model_file import string

    found = draft.ingested
    said = {answer.key for answer in answers}
    for name, guess in sorted(found.guesses.items(), key=lambda each: (each[1].is_said, _in_order(each[0]))):
        key = string(name)
        basis = "asked" if key in said else "stated" if guess.is_said else "guess"
        flags = [flag for flag, is_so in guess.spec.items() if is_so is True]
        yield {
            "key": key,
            "symbol": _math(name),
            "label": name,
            "kind": guess.kind,
            "flags": flags,
            "why": guess.why,
            "basis": basis,
            "choices": list(dict.fromkeys((guess.kind, *KINDS))),
        }


def _in_order(name: str) -> list[tuple[int, str]]:
    """Returns a key by which a_2 stands before a_10."""
    return [(int(each), "") if each.isdecimal() else (0, each) for each in re.split(r"(\d+)", name)]


@cache
def _math(latex: str) -> str:
    return str(math(latex))


def _prose(words: str) -> str:
    """Returns the words of a verdict with their formulas typeset."""
    return str(runs(runs_with_symbols(words)))
