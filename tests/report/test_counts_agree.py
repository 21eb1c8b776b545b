"""The counts of a paper's equations are the same on the terminal, in report.json, errata.json and report.html."""

from __future__ import annotations

import json
import re
import warnings
from collections import Counter
from importlib.resources import files
from pathlib import Path
from types import SimpleNamespace

import pytest
from sample_report import claim

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.app.pytest_plugin import ClaimItem, NotAsExpected
from workbench.core.verdict import Grade
from workbench.papers import find_paper, load_paper
from workbench.papers.installed_papers import installed_names
from workbench.papers.texts.text_paper import TextPaper
from workbench.report import render
from workbench.report.claim_states import state_of_equation
from workbench.report.document import document_of
from workbench.report.erratum.equation_groups import states_of
from workbench.report.listing import listing
from workbench.report.shown_kinds import STATES
from workbench.report.to_json import report_json

FOLDERS = Path(__file__).parents[1]
PAPERS = [FOLDERS / "papers" / "vector_identities.toml", FOLDERS / "papers" / "every_verdict.toml"]
TEXT = r"""
Let $a$, $b$, $c$ be vectors, and $s$, $p$ scalars.
\begin{equation} a \times b = -b \times a \end{equation}
\begin{equation} a \times b = b \times a = -a \times b \end{equation}
\begin{gather} s + p = p + s \\ \frac{s p}{p} = s \\ s + a = p \end{gather}
\[ a \cdot b = b \cdot a, \qquad a \cdot a = -a \cdot a \]
\begin{align*} s + s &= s + s \\ &= 2 s \end{align*}
"""
MODEL = "source = 'x.tex'\n[symbols]\na = 'vector'\nb = 'vector'\nc = 'vector'\ns = 'scalar'\np = 'scalar'\n"
#: Rows with and without numbers and labels.
ROWS = r"""
Let $a$, $b$, $c$ be vectors, and $s$, $p$ scalars.
\begin{align}
 a \times b &= b \times a \label{eq:first} \\
 a \times c &= c \times a \\
 b \times c &= c \times b \label{eq:third} \\
 b \cdot c &= - c \cdot b \notag
\end{align}
\begin{align*}
 a \times b &= b \times a \label{eq:star} \\
 a \times c &= c \times a
\end{align*}
\begin{equation}\label{eq:one}\begin{aligned} s p &= p s + s \\
 s - p &= p - s \end{aligned}\end{equation}
\begin{equation} a \cdot b = -b \cdot a \tag{*} \end{equation}
\[ a \times b = b \times a \]
"""
NAMES = [
    "(1) eq:first", "(2)", "(3) eq:third", "line 7", "eq:star", "eq:star", "(4) eq:one", "(4) eq:one", "(*)",
    "line 16",
]  # fmt: skip
#: The first sentence of a report: what it says of a number of equations, and the state.
SAID = {
    "error": r"(\d+) of \d+ equations? (?:is|are) wrong",
    "misprint": r"(\d+) (?:is|are) misprinted",
    "warning": r"(\d+) (?:is|are) doubtful",
    "unjudged": r"(\d+) (?:is|are) not judged",
    "hypothesis": r"(\d+) (?:needs|need) a condition",
    "holds": r"(\d+) (?:holds|hold) as printed",
}
_FIRST = re.compile(r'role="status">(.*?)</p>')
WORDS = {"condition missing": "hypothesis", "not judged": "unjudged", "definition": "defines"}
#: The terminal tells apart what the model of a text leaves out, and the errors that it records already.
FINER = {"left out": {"unjudged"}, "known": {"error", "warning"}, "not settled": {"open"}}


#: The chapter takes two minutes, the other texts two seconds each.
INSTALLED = [pytest.param(name, marks=[pytest.mark.slow] * (name == "chapter")) for name in installed_names()]


@pytest.fixture(params=["platform", "text", *(path.stem for path in PAPERS), *INSTALLED])
def judged(request, tmp_path):
    if request.param in installed_names():
        paper = find_paper(request.param)
        return paper, judge_paper(paper, motions=False, jobs=1)
    if request.param == "platform":
        path = Path(str(files("workbench.guide").joinpath("examples/platform.toml")))
    elif request.param == "text":
        (tmp_path / "x.tex").write_text(TEXT, encoding="utf-8")
        path = tmp_path / "x.toml"
        path.write_text(MODEL, encoding="utf-8")
    else:
        path = next(path for path in PAPERS if path.stem == request.param)
    paper = load_paper(path)
    return paper, judge_paper(paper, motions=False, jobs=1)


def test_counts_of_terminal_json_and_page_are_equal(judged):
    paper, results = judged
    texts = render.render(paper, results)
    counts = json.loads(texts["report.json"])["equations"]
    assert counts and json.loads(texts["errata.json"])["counts"] == counts
    first = re.sub("<[^>]*>", "", _FIRST.search(texts["report.html"])[1])
    said = {state: int(found[1]) for state, words in SAID.items() if (found := re.search(words, first))}
    assert said == {state: counts[state] for state in SAID if state in counts}
    if isinstance(paper, TextPaper):
        states = [state.name for *_, state in states_of(paper, results)]
        assert Counter(states) == counts
        for state, row in zip(states, listing(paper, results).rows, strict=True):
            assert state in FINER.get(row.word, {WORDS.get(row.word, row.word)})


def outcome_of_item(result):
    """How the pytest item of a claim ends."""
    item = SimpleNamespace(claim=result.claim, judge=SimpleNamespace(result=lambda claim: result))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        try:
            ClaimItem.runtest(item)
        except NotAsExpected:
            return "failed"
        except pytest.skip.Exception:
            return "skipped"
    return "warned" if told else "passed"


def test_pytest_items_end_as_the_equations_are_counted(judged):
    """The equations with a failed item are the errors of the listing, those with a warning its warnings."""
    paper, results = judged
    ends = {result.claim.id: outcome_of_item(result) for result in results}
    assert len(ends) == len(report_json(paper, results)["claims"])
    if not isinstance(paper, TextPaper):
        assert {name for name, end in ends.items() if end != "passed"} == {
            result.claim.id for result in results if not result.passed
        }
        return
    rows = listing(paper, results).rows
    assert sorted(ends) == sorted(result.claim.id for row in rows for result in row.results)
    for row in rows:
        own = {ends[result.claim.id] for result in row.results}
        assert ("failed" in own) is (row.grade is Grade.ERROR)
        assert ("warned" in own - {"failed"}) is (row.grade is Grade.WARNING) or "failed" in own


def test_each_equation_is_in_one_class(judged):
    paper, results = judged
    document = document_of(paper, results)
    named = [each.anchor for kind in document.classes for each in (*kind.equations, *kind.statements)]
    assert sorted(named) == sorted({each.anchor for each in document.equations})
    unjudged = {anchor for _, places in document.unjudged for _, anchor in places}
    states = {each.anchor: each.state.name for each in document.equations}
    assert {states[anchor] for anchor in unjudged} <= {"unjudged"}
    if isinstance(paper, TextPaper):
        found = listing(paper, results)
        rows = {row.name: row.word for row in found.rows}
        assert {rows[name] for group in found.open for name in group.names} <= {"not judged", "not settled"}


def test_terminal_and_report_name_rows_alike(tmp_path):
    """By number and label, by label, or by line; rows of one equation are told apart by their lines."""
    (tmp_path / "x.tex").write_text(ROWS, encoding="utf-8")
    (tmp_path / "x.toml").write_text(MODEL, encoding="utf-8")
    paper = load_paper(tmp_path / "x.toml")
    results = judge_paper(paper, motions=False, jobs=1)
    items = listing(paper, results).items
    assert [item.name for item in items] == NAMES
    assert len({(item.name, item.span.line) for item in items}) == len(items)
    corrections = document_of(paper, results).errata.corrections
    told = [(each.heading.removeprefix("Eq. "), each.place) for each in corrections]
    assert len(set(told)) == len(told) == len(items)
    by_line = sorted(zip(items, corrections, strict=True), key=lambda pair: pair[0].span.line)
    for item, each in by_line:
        name = each.heading.removeprefix("Eq. ")
        assert item.name.lower().startswith(name.lower())
        assert each.place in (None, f"line {item.span.line}")


def test_a_step_that_says_nothing_decides_no_state():
    proved = claim("1", "1", "1", "proved", printed="a = b")
    assert state_of_equation([proved, proved], [STATES["holds"], STATES["unjudged"]]) is STATES["unjudged"]
