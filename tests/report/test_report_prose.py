"""What a reader sees outside mathematics: no LaTeX, no dollar sign, no value without a word."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from sample_report import claim, report_of, sample

from workbench.app.pipeline.judged_files import judged_file
from workbench.report import render
from workbench.report.document import document_of
from workbench.report.mixed_prose import runs_of

EXAMPLE = Path(__file__).parents[2] / "workbench" / "guide" / "examples" / "platform.tex"


@pytest.fixture(scope="module")
def platform() -> dict[str, str]:
    judged = judged_file(EXAMPLE, motions=False)
    return render.render(judged.paper, judged.results)


def _prose(page: str) -> str:
    body = page.split("<body>")[1].split("<script>")[0]
    return re.sub(r"<[^>]*>", " ", re.sub(r"<(math|svg|code)\b.*?</\1>", " ", body, flags=re.DOTALL))


def test_reason_in_a_report_shows_symbols_as_mathematics(platform: dict[str, str]) -> None:
    assert "can vanish" in _prose(platform["report.html"])
    assert re.search(r"\\[a-z]+|\$|\bNone\b", _prose(platform["report.html"])) is None
    assert r"\\omega" not in platform["report.md"]


def test_text_without_sections_has_no_headings_of_them(platform: dict[str, str]) -> None:
    assert "Without a section" not in platform["report.html"] + platform["report.md"]


def test_report_in_markdown_leaves_out_empty_columns(platform: dict[str, str]) -> None:
    assert "Off by" not in platform["report.md"]
    assert "lost in our copy" not in platform["report.md"]


def test_quoted_display_keeps_no_dollar_sign() -> None:
    found = [(run.content, run.is_math) for run in runs_of("“$$a = b$$” and $c$$d$")]
    assert found == [("“", False), ("a = b", True), ("” and ", False), ("c", True), ("d", True)]


def test_row_of_a_sentence_names_what_its_edit_replaces() -> None:
    goal = claim(
        "base", "37", "4", "refuted", printed=r"P_0 = I", corrected={"latex": "P_1 = I", "verdict": "proved"}
    )
    assert document_of(*report_of([goal])).rows[0].of == ("P _{ 0 }",)


def test_row_of_quoted_words_names_their_formula() -> None:
    words = claim("unique", "Theorem 2", "4", "refuted", quote="a unique $P_n \\in A$ exists")
    assert document_of(*report_of([words])).rows[0].of == ("P _{ n }",)


def test_notice_has_the_names_of_crossref_and_jats() -> None:
    """Names as in Crossref's REST interface (works) and in the JATS tag library 1.1 (related-article)."""
    paper, results = sample()
    notice = json.loads(render.render(paper, results)["errata.json"])
    assert "type" not in notice and notice["article-type"] == "correction"
    assert set(notice["update-to"][0]) == {"DOI", "type", "label"}
    related = {"related-article-type", "ext-link-type", "xlink:href"}
    assert [set(each) for each in notice["related-article"]] == [related]
