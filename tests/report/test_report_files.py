"""The four files: reproducible, whole or not at all, escaped, and true to the results."""

import base64
import hashlib
import json
import re
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from itertools import pairwise

import pytest
from sample_report import CLAIMS, claim, report_of, sample

from workbench.context.claim_parts import Edit, Mend
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.verdict import Outcome
from workbench.prover.results.proposed_form import Proposed
from workbench.report import ReportError, html_page, render
from workbench.report.counterexamples import as_printed
from workbench.report.document import document_of
from workbench.report.render import write_report
from workbench.report.shown_kinds import VERDICTS
from workbench.report.to_json import report_json


class Page(HTMLParser):
    """What a test wants to know of a page; raises if the tags do not nest."""

    VOID = frozenset(("meta", "input", "br", "link"))

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.headings, self.tags, self.open = [], [], [], [], []
        self.attributes = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.append(tag)
        self.attributes.append((tag, attributes))
        self.ids += [attributes["id"]] if "id" in attributes else []
        self.links += [attributes["href"]] if "href" in attributes else []
        self.headings += [int(tag[1])] if re.fullmatch("h[1-6]", tag) else []
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in self.VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_same_input_same_bytes(tmp_path):
    first = [path.read_bytes() for path in write_report(*sample(), tmp_path / "a")]
    render._loader.cache_clear()
    second = [path.read_bytes() for path in write_report(*sample(), tmp_path / "b")]
    assert first == second
    names = sorted(path.name for path in (tmp_path / "a").iterdir())
    assert names == ["errata.json", "erratum.tex", "report.html", "report.json", "report.md"]


def test_json_is_what_the_results_say(texts):
    report = json.loads(texts["report.json"])
    assert report == report_json(*sample())
    assert texts["report.json"].endswith("}\n")
    assert list(report) == ["paper", "versions", "claims", "summary", "equations", "witnesses"]
    assert [claim["id"] for claim in report["claims"]] == [result.claim.id for result in CLAIMS]
    assert sum(report["summary"].values()) == len(CLAIMS)


def test_a_report_that_cannot_be_rendered_leaves_the_old_files(tmp_path, monkeypatch):
    write_report(*sample(), tmp_path)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    unset = report_of([claim("1", "1", "1", "refuted", printed="a", note="\u4e00")])
    with pytest.raises(ReportError, match=r"expected what pdfLaTeX sets, got U\+4E00"):
        write_report(*unset, tmp_path)
    monkeypatch.setattr(html_page, "mathml", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        write_report(*sample(), tmp_path)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_a_file_in_the_way_is_named(tmp_path):
    (tmp_path / "out").write_text("")
    for out in (tmp_path / "out", tmp_path / "out" / "deeper"):
        with pytest.raises(ReportError, match="expected a directory"):
            write_report(*sample(), out)


def test_page_is_self_contained_and_admits_its_own_script_alone(texts, nasty):
    for page in (texts["report.html"], nasty["report.html"]):
        parsed = Page(page)
        assert not {"link", "img", "iframe", "object"} & set(parsed.tags)
        (script,) = re.findall("<script>(.*?)</script>", page, re.DOTALL)
        digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
        assert f"script-src 'sha256-{digest}'" in page.split("<title>")[0].replace("&#39;", "'")
        assert "@import" not in page
        assert set(re.findall(r"url\(\"?(.{5})", page)) <= {"data:"}


def test_anchors_are_unique_and_links_lead_somewhere(texts, nasty):
    for page in (texts["report.html"], nasty["report.html"]):
        parsed = Page(page)
        assert len(parsed.ids) == len(set(parsed.ids))
        inner = [link[1:] for link in parsed.links if link.startswith("#")]
        assert set(inner) <= set(parsed.ids)
        referred = [v for _, a in parsed.attributes for k, v in a.items() if k == "aria-labelledby"]
        assert set(referred) <= set(parsed.ids)


def test_each_equation_has_its_anchor_and_heading(texts):
    parsed = Page(texts["report.html"])
    for equation in {r.claim.equation for r in CLAIMS if r.claim.equation.isdigit()}:
        assert f"eq-{equation}" in parsed.ids
        assert re.search(rf'<h4 id="h-eq-{equation}">.*\({equation}\)</h4>', texts["report.html"])


def test_headings_descend_one_step_at_a_time(texts):
    levels = Page(texts["report.html"]).headings
    assert levels[0] == 1
    assert all(after - before <= 1 for before, after in pairwise(levels))


def test_probable_and_unchecked_never_count_as_holding():
    for verdict in VERDICTS:
        document = document_of(*report_of([claim("1", "1", "1", verdict, printed="a"), CLAIMS[7]]))
        assert document.in_state("holds") == 1 + (verdict in ("proved", "definition"))
        assert sum(each.count for each in document.classes) == document.counted == 2


def test_an_equation_is_as_bad_as_its_worst_line():
    lines = [claim(f"1.{v}", "1", "1", v, printed="a") for v in VERDICTS]
    document = document_of(*report_of(lines))
    assert document.equations[0].state.name == "error"


def test_every_part_of_an_erratum_is_shown(texts):
    for name in ("report.html", "report.md", "erratum.tex"):
        for expected in ("Misprints", "Conditions missing", "Counterexample", "read", "hanges also"):
            assert expected in texts[name], (name, expected)


EDITED = Mend(
    edits=(Edit(r"\omega_1", r"\omega_2", is_math=True),), place="second line", cause="A wrong index."
)


def test_the_same_edit_of_several_equations_is_one_row():
    lines = [claim(n, n, "1", "ill-formed", printed=r"\omega_1", mend=EDITED) for n in ("3", "12", "4")]
    document = document_of(*report_of(lines))
    (cause,) = document.errata.by_cause["misprint"]
    assert cause.name == "A wrong index." and [row.heading for row in cause.rows] == ["Eqs. (3), (4), (12)"]


def test_errors_list_their_heirs_and_skip_shared_corrections():
    lines = [
        claim("1", "1", "1", "refuted", printed="a"),
        claim("2", "2", "1", "refuted", printed="a", inherits=["4"], mend=replace(EDITED, cause=None)),
        claim("3", "3", "1", "refuted", printed="a", mend=Mend(by="2")),
        claim("4", "4", "1", "proved", printed="a"),
    ]
    document = document_of(*report_of(lines))
    assert [erratum.heading for erratum in document.errata.errors] == ["Eq. (2)", "Eq. (1)"]
    assert [heading for heading, _ in document.errata.errors[0].heirs] == ["Eq. (3)", "Eq. (4)"]
    assert document.entries[3].state.name == "inherits"
    assert document.entries[3].rests_on == (("Eq. (2)", "claim-2"),)


def test_an_unexpected_verdict_is_shown(texts):
    for name in ("report.html", "report.md"):
        assert "Not the expected verdict" in texts[name]
        assert texts[name].count("expected argued, got proved") == 1


def test_evidence_says_which_form_it_is_about(texts):
    article = texts["report.html"].split('id="eq-61"')[1].split("</article>")[0]
    rows = re.findall(r'<tr><th scope="row">(.*?)</th><td>.*?</td><td>(\w+)</td></tr>', article)
    assert [of for _, of in rows] == ["printed"] * 3 + ["corrected"] * 2


def test_counterexample_is_exact(texts):
    entry = texts["report.html"].split('id="claim-61.det"')[1].split("</article>")[0]
    sentence = re.sub(r'<math[^>]*alttext="(.*?)".*?</math>', r"\1", entry.split("Counterexample</dt>")[1])
    omega = r"\boldsymbol{\omega}"
    assert sentence.startswith(
        rf"<dd>with {omega} = (1, 0, 0), \dot{{{omega}}} = (0, 1, 0), \ddot{{{omega}}} = (0, 0, 1): "
        "the left side is −13/4, the right side 1/4."
    )


@pytest.mark.parametrize(
    ("name", "said", "shown"),
    [
        (r"\dot{\omega}", r"\boldsymbol{\omega} \times \mathbf{w}", r"\dot{\boldsymbol{\omega}}"),
        (r"\dot{\omega}", r"\boldsymbol{\omega} \times \omega", r"\dot{\omega}"),
        (r"\omega", r"\tilde{\omega} + \omega^2", r"\omega"),
        (r"\dot{\boldsymbol{\omega}}", r"\boldsymbol{\omega}", r"\dot{\boldsymbol{\omega}}"),
    ],
)
def test_values_name_letters_in_the_typeface_of_the_formula(name, said, shown):
    assert as_printed(name, said) == shown


REASONED = Mend(add=r"where $a \neq 0$", example="For $a = 2$ it is false.")


def test_handwritten_reasons_replace_generated_ones():
    example = {"values": {"a": ["7"]}, "lhs": ["1"], "rhs": ["0"]}
    lines = [
        claim("1", "1", "1", "refuted", printed="a", mend=REASONED, counterexample=example),
        claim("2", "2", "1", "conditional", printed="b", mend=REASONED, hypothesis=r"\cos s \neq 1"),
    ]
    texts = render.render(*report_of(lines))
    for name in ("report.html", "report.md", "erratum.tex"):
        assert "it is false" in texts[name] and "add" in texts[name].lower()
    assert "7" not in texts["erratum.tex"].split(r"\section*{Errors")[1].split(r"\section*{App")[0]
    assert "cos" not in texts["erratum.tex"].split(r"\section*{Conditions")[1].split(r"\section*{App")[0]


def test_a_counterexample_shows_values_of_defined_symbols():
    example = {
        "values": {"R": 9 * ["1"], "b": ["3"]}, "lhs": ["1"], "rhs": ["0"],
        "defined": {"w": ["5", "6", "7"], "T": 9 * ["8"]}, "behind": ["R"],
    }  # fmt: skip
    lines = [claim("1", "1", "1", "refuted", printed="w b", counterexample=example)]
    note = render.render(*report_of(lines))["erratum.tex"].split(r"\section*{Errors")[1]
    assert "so that" in note and r"\(w\) = (5, 6, 7)" in note and r"\(b\) = 3" in note
    assert "8, 8" not in note and "1, 1" not in note


@pytest.mark.parametrize("verdict", ["unchecked", "ill-formed"])
def test_reasons_contain_no_source_positions(verdict):
    unknown = SyntaxCode.UNKNOWN_SYMBOL_CLOSE(text="x", close="y").at(1, 25)
    reason = SyntaxCode.CANNOT_BE_READ(why=unknown)
    texts = render.render(*report_of([claim("1", "1", "1", verdict, printed="a", reason=reason)]))
    for name in ("report.html", "report.md", "erratum.tex"):
        assert "column 25" not in texts[name].split("<body>")[-1]
    assert "unknown symbol x" in texts["report.html"]


def test_the_note_begins_with_errors_and_ends_with_the_source():
    cited = sample(
        authors="A. N. Author", source="A Book", read="a.md", recheck="workbench report --paper a_b"
    )
    note = render.render(*cited)["erratum.tex"].split(r"\begin{document}")[1]
    first, last = note.split(r"\section*{Errors")[0], note.split(r"\section*{About")[1]
    assert "A. N. Author" in first and "A Book" in first and r"\clearpage" not in first
    for expected in ("Source read: a.md", r"report {-}{-}paper a\_b}", r"\today"):
        assert expected in last


def test_a_claim_without_a_printed_form_shows_its_statement(texts):
    assert "Adjugate and determinant of a tensor" in texts["report.html"]


def test_empty_report_is_a_report():
    texts = render.render(*report_of([]))
    for name in ("report.html", "report.md", "erratum.tex"):
        assert "No error found in 0 equations" in texts[name]


def test_package_loads_without_the_rendering_libraries():
    script = "import sys, workbench.report; print(sorted({'jinja2', 'latex2mathml'} & set(sys.modules)))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert run.stdout.strip() == "[]"


def test_proposals_are_shown_with_marked_differences():
    difference = [{"same": "a = b"}, {"printed": "+", "proposed": "-"}, {"same": "c"}]
    proposal = Proposed("a = b - c", "a sign of $c$", difference, Outcome.PROVED)
    false = claim("1", "1", "1", "refuted", printed="a = b + c", proposed=(proposal,))
    texts = render.render(*report_of([false]))
    assert "proposed by the machine" in texts["report.html"] and "a sign of" in texts["report.html"]
    assert "$a = b - c$" in texts["report.md"]
    assert r"\ChangedBin{-}" in texts["erratum.tex"]
    assert '<mo class="ins">−</mo>' in texts["report.html"]
    told = json.loads(texts["report.json"])["claims"][0]["proposed"]
    assert told == [
        {"latex": "a = b - c", "edit": "a sign of $c$", "difference": difference, "verdict": "proved"}
    ]
