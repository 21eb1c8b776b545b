"""Laws of a report: one count everywhere, nothing wrong is left out, and colours that can be read."""

from __future__ import annotations

import json
import re
from collections import Counter
from html.parser import HTMLParser
from importlib.resources import files
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sample_report import claim, report_of, sample, with_fault

from workbench.context.claim_parts import Edit, Mend
from workbench.core.verdict import Outcome
from workbench.prover.results.claim_results import ClaimResult
from workbench.report import render
from workbench.report.anchors import is_number
from workbench.report.document import document_of
from workbench.report.shown_kinds import STATES

EDITS = Mend(edits=(Edit("a", "b", is_math=True),))
FAULTS = ("error", "misprint", "wording", "transcription", "hypothesis")


class Page(HTMLParser):
    """The marks, bar, legend, articles and rows of a page; raises if its tags do not nest."""

    VOID = frozenset(("meta", "input", "br"))

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attributes)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attributes)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def all(self, tag: str, look: str = "") -> list[dict[str, str | None]]:
        return [a for t, a in self.found if t == tag and (not look or look in (a.get("class") or "").split())]


def counts_of(page: Page) -> tuple[Counter[str], Counter[str], Counter[str]]:
    """Equations by state: in the bar, in the strip, and in the details."""
    bar = Counter({a["href"][1:]: int(re.match(r"\d+", a["aria-label"])[0]) for a in _bar(page)})
    labels = {kind.label: name for name, kind in STATES.items()}
    strip = Counter(labels[a["aria-label"].split(": ")[1]] for a in page.all("a", "m"))
    articles = [a for a in page.all("article") if not a["data-name"].startswith("Theorem")]
    return bar, strip, Counter((a["class"] or "").split()[0] for a in articles)


def _bar(page: Page) -> list[dict[str, str | None]]:
    return [
        a
        for a in page.all("a")
        if re.fullmatch(r"\d+ [a-z ]+", a.get("aria-label") or "") and "class" not in a
    ]


def drawn(number: int, verdict: str, fault: str | None) -> ClaimResult:
    right = {"latex": "b = c", "verdict": "proved"} if verdict == "refuted" else None
    mend = EDITS if fault else Mend()
    result = claim(f"{number}.x", str(number), "1", verdict, printed="a = c", corrected=right, mend=mend)
    return with_fault(result, fault)


claims = st.lists(
    st.one_of(
        st.tuples(
            st.integers(1, 9), st.sampled_from(["proved", "definition", "unchecked", "argued"]), st.none()
        ),
        st.tuples(st.integers(1, 9), st.just("refuted"), st.sampled_from(FAULTS)),
    ),
    max_size=8,
    unique_by=lambda each: each[0],
)


@given(claims)
@settings(max_examples=12)
def test_bar_strip_details_and_sentence_count_alike(rows):
    paper, results = report_of([drawn(*row) for row in rows])
    texts = render.render(paper, results)
    bar, strip, details = counts_of(Page(texts["report.html"]))
    assert bar == strip == details
    assert sum(bar.values()) == len(rows)
    document = document_of(paper, results)
    wrong = bar.get("error", 0)
    assert document.in_state("error") == wrong
    strong = re.search(r'role="status"><b>(.*?)</b>', texts["report.html"])[1]
    beginning = "No error found in"
    if rows and bar.get("unjudged") == len(rows):
        beginning = f"None of {len(rows)} equation"
    assert strong.startswith(f"{wrong} of {len(rows)} equation" if wrong else beginning)
    assert json.loads(texts["errata.json"])["counts"] == dict(bar)


def test_counts_are_those_of_the_claims_in_report_json(texts):
    told = json.loads(texts["report.json"])["claims"]
    wrong = {c["equation"] for c in told if c["fault"] == "error" and is_number(c["equation"])}
    bar, strip, _ = counts_of(Page(texts["report.html"]))
    assert bar["error"] == strip["error"] == len(wrong)
    assert sum(bar.values()) == len({c["equation"] for c in told if is_number(c["equation"])})


def test_each_error_has_a_row_a_detail_and_erratum_entries(texts):
    _, results = sample()
    wrong = [r for r in results if r.fault == "error"]
    page = texts["report.html"]
    table = page.split('<table class="errors">')[1].split("</table>")[0]
    notice = {each["label"] for each in json.loads(texts["errata.json"])["corrections"]}
    assert wrong
    for result in wrong:
        label = f"({result.claim.equation})"
        assert f">{label}</a></th>" in table and f'data-name="{label}"' in page and label in notice
        assert label in texts["report.md"].split("## Errors")[1].split("## ")[0]
        assert label in texts["erratum.tex"].split(r"\section*{Errors")[1].split(r"\section*")[0]


def test_classes_without_an_equation_are_left_out():
    page = render.render(*report_of([claim("1", "1", "1", "proved", printed="a")]))["report.html"]
    for word in ("rror", "isprint", "onditions missing", "ording", "copy", "Coq"):
        assert f">{word}" not in page and f"1 {word}" not in page
    assert '<section id="error"' not in page and 'id="misprint"' not in page


def test_report_asks_for_nothing_outside_of_itself(texts):
    for tag, attributes in Page(texts["report.html"]).found:
        assert tag not in ("link", "img", "iframe", "object", "embed")
        assert "src" not in attributes
    assert set(re.findall(r"url\((.{5})", texts["report.html"])) == {"data:"}
    assert len(texts["report.html"]) < 500_000 and len(texts["report.md"]) < 100_000


def test_an_equation_in_two_sections_counts_once():
    lines = [claim(f"1.{n}", "1", section, "proved", printed="a") for n, section in enumerate("12")]
    document = document_of(*report_of(lines))
    assert document.counted == 1 and len(document.equations[0].entries) == 2


def test_sections_have_their_names():
    paper, results = report_of([claim("1", "1", "4.1", "proved", printed="a")])
    object.__setattr__(paper, "sections", {"4.1": "Centres"})
    assert "4.1 Centres</h3>" in render.render(paper, results)["report.html"]


TOKENS = {  # of the style: name → where it is told, and the least contrast that is asked of it
    "ink": 4.5, "soft": 4.5, "link": 4.5, "err": 4.5, "warn": 4.5, "ok": 4.5, "ins": 4.5, "del": 4.5,
    "warn-fill": 1.0, "ok-fill": 1.0,
}  # fmt: skip
PAIRS = {("on-err", "err-fill"): 4.5, ("on-warn", "warn-fill"): 4.5, ("on-ok", "ok-fill"): 4.5}
PAIRS |= {("ins", "ins-bg"): 4.5, ("del", "del-bg"): 4.5, ("soft", "raise"): 4.5}


@pytest.mark.parametrize("scheme", [0, 1, 2], ids=["light", "dark", "print"])
def test_colours_can_be_read(scheme):
    css = files("workbench.report").joinpath("templates/report.css").read_text("utf-8")
    blocks = re.findall(r":root\{(.*?)\}", css, re.DOTALL)
    light, chosen = (dict(re.findall(r"--([\w-]+):(#\w+)", blocks[at])) for at in (0, scheme))
    colours = light | chosen
    for name, least in TOKENS.items():
        assert contrast(colours[name], colours["bg"]) >= least, name
    for (ink, ground), least in PAIRS.items():
        assert contrast(colours[ink], colours[ground]) >= least, (ink, ground)


def contrast(one: str, other: str) -> float:
    brighter, darker = sorted((luminance(one), luminance(other)), reverse=True)
    return (brighter + 0.05) / (darker + 0.05)


def luminance(colour: str) -> float:
    digits = colour[1:] if len(colour) == 7 else "".join(2 * digit for digit in colour[1:])
    parts = [int(digits[at : at + 2], 16) / 255 for at in (0, 2, 4)]
    red, green, blue = (v / 12.92 if v <= 0.03928 else ((v + 0.055) / 1.055) ** 2.4 for v in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_font_has_every_character_of_a_formula():
    fonttools = pytest.importorskip("fontTools.ttLib")
    pytest.importorskip("brotli")
    from subset_font import FONT, characters

    font = fonttools.TTFont(FONT)
    assert {c for c in characters() if ord(c) not in font.getBestCmap()} == set()
    assert "MATH" in font and "STIX" not in font["name"].getDebugName(1)
    assert "STI Pub" in font["name"].getDebugName(0) and Path(FONT).with_name("OFL.txt").is_file()


@pytest.mark.parametrize("outcome", list(Outcome))
def test_each_verdict_has_words_for_new_readers(outcome):
    right = {"latex": "b = a", "verdict": "proved"}
    forms = {"refuted": {"corrected": right}, "ill-formed": {"reading": right}}.get(outcome, {})
    forms |= {"argued": {"argued": "prose"}, "conditional": {"hypothesis": "a = 0"}}.get(outcome, {})
    page = render.render(*report_of([claim("1", "1", "1", outcome, printed="a = b", **forms)]))["report.html"]
    seen = re.sub(r"<details>.*?</details>|<[^>]*>", " ", page.split("<body>")[1], flags=re.DOTALL)
    for word in ("refuted", "ill-formed", "mend", "bears on", "seed"):
        assert not re.search(rf"\b{word}", seen), word


@pytest.mark.parametrize(
    ("unless", "state"),
    [((), "error"), (("a rests",), "warning"), (("a rests", "b is a vector"), "unjudged")],
)
@pytest.mark.parametrize("verdict", ["refuted", "ill-formed"])
def test_falsehood_is_graded_by_the_doubts_about_it(verdict, unless, state):
    false = claim("1", "1", "1", verdict, printed="a = b", unless=unless)
    false = with_fault(false, None)
    document = document_of(*report_of([false]))
    assert document.in_state(state) == 1 == document.counted
    assert len(document.rows) == (state == "error")
