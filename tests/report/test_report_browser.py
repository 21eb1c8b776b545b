"""The page in a real browser: nothing overflows, all can be read, the field and the keys work."""

import pytest
from headless_browser import EXECUTABLE, Browser
from sample_report import sample

from workbench.report.render import write_report

pytestmark = pytest.mark.skipif(EXECUTABLE is None, reason="no Chromium is installed")

UNFOLD = "document.querySelectorAll('details').forEach(d => d.open = true)"
OVERFLOWING = """[...document.querySelectorAll('body *')]
  .filter(e => !e.closest('math, svg, .f, .edit, dd, .rows td, .skip, .vh, .statement'))
  .filter(e => e.getBoundingClientRect().right > innerWidth + 1).map(e => e.outerHTML.slice(0, 80))"""
EMPTY_FORMULAS = """[...document.querySelectorAll('math')]
  .filter(m => m.checkVisibility())
  .filter(m => m.getBoundingClientRect().width < 3 || m.getBoundingClientRect().height < 3)
  .map(m => m.getAttribute('alttext'))"""
CONTRASTS = """(() => {
  const luminance = rgb => { const [r, g, b] = rgb.match(/[\\d.]+/g).slice(0, 3).map(Number)
    .map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const backdrop = e => { for (; e; e = e.parentElement) {
    const c = getComputedStyle(e).backgroundColor; if (!/, 0\\)$/.test(c)) return c; } };
  return [...document.querySelectorAll('p, a, b, h1, h2, h3, h4, th, td, dt, dd, li, .k, .v, .quiet, .words *')]
    .filter(e => e.checkVisibility() && e.textContent.trim()).map(e => {
      const [a, b] = [luminance(getComputedStyle(e).color), luminance(backdrop(e))];
      return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.className + ' ' + e.textContent]; })
    .filter(([ratio]) => ratio < 4.5) })()"""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    out = tmp_path_factory.mktemp("report")
    return next(path for path in write_report(*sample(), out) if path.suffix == ".html")


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    running = Browser(tmp_path_factory.mktemp("profile"))
    yield running
    running.close()


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_nothing_overflows_and_everything_can_be_read(browser, page, width, dark):
    browser.open(page, width, dark)
    assert browser.evaluate("document.documentElement.scrollWidth") <= width
    assert browser.evaluate(OVERFLOWING) == []
    assert browser.evaluate(EMPTY_FORMULAS) == []
    assert browser.evaluate(CONTRASTS) == []
    background = browser.evaluate("getComputedStyle(document.body).backgroundColor")
    assert (background == "rgb(255, 255, 255)") is not dark


def test_page_asks_for_nothing(browser, page):
    browser.requests.clear()
    browser.open(page, 1280)
    assert {url.split(":")[0] for url in browser.requests} <= {"file", "data"}
    assert [url for url in browser.requests if url.startswith("file")] == [page.as_uri()]


def test_first_screen_ends_above_800_pixels_and_no_row_wraps(browser, page):
    browser.open(page, 1280)
    assert browser.evaluate("document.querySelector('.foot').getBoundingClientRect().bottom") < 800
    heights = browser.evaluate("[...document.querySelectorAll('.errors tbody tr')].map(e => e.offsetHeight)")
    assert heights and max(heights) <= 27


def test_field_leads_to_an_equation_or_says_that_there_is_none(browser, page):
    browser.open(page, 1280)
    ask = "document.getElementById('jump').value = '{}'; document.querySelector('.jump button').click()"
    browser.evaluate(ask.format("999"))
    assert browser.evaluate("document.querySelector('.jump output').value") == "no equation (999)"
    browser.evaluate(ask.format("(59)"))
    assert browser.evaluate("location.hash") == "#eq-59"
    assert browser.evaluate("document.querySelector('.jump output').value") == ""
    assert -1 <= browser.evaluate("document.getElementById('eq-59').getBoundingClientRect().top") < 900


def test_keyboard_reaches_the_errors_in_two_keys(browser, page):
    browser.open(page, 1280)
    browser.press("Tab")
    assert browser.evaluate("document.activeElement.className") == "skip"
    assert browser.evaluate("document.activeElement.getBoundingClientRect().left") >= 0
    browser.press("Enter")
    assert browser.evaluate("location.hash") == "#errors"
    browser.press("Tab")
    assert browser.evaluate("document.activeElement.closest('#error') !== null")
    assert browser.evaluate("getComputedStyle(document.activeElement).outlineStyle") != "none"


def test_every_control_and_box_has_a_name(browser, page):
    browser.open(page, 1280)
    tree = browser.call("Accessibility.getFullAXTree")["nodes"]
    named = {"link", "textbox", "button", "region", "navigation", "article"}
    nameless = [
        node["role"]["value"]
        for node in tree
        if not node.get("ignored")
        and node.get("role", {}).get("value") in named
        and not node.get("name", {}).get("value", "").strip()
    ]
    assert nameless == []
    roles = {node.get("role", {}).get("value") for node in tree}
    assert {"main", "banner", "contentinfo", "navigation", "columnheader", "rowheader"} <= roles


def test_mathematics_is_set_in_the_embedded_font_and_marks_grow(browser, page):
    browser.open(page, 1280)
    browser.evaluate(UNFOLD)
    assert browser.evaluate("document.fonts.check('16px \"Workbench Math\"')")
    assert browser.evaluate("[...document.fonts].map(f => f.family + ' ' + f.status)") == [
        '"Workbench Math" loaded'
    ] or browser.evaluate("[...document.fonts].map(f => f.family + ' ' + f.status)") == [
        "Workbench Math loaded"
    ]
    grown = (
        "[...document.querySelectorAll('mover > mo[stretchy=true]')].filter(e => e.checkVisibility()).length"
    )
    assert browser.evaluate(grown) >= 3


def test_print_is_clean(browser, page, tmp_path):
    browser.open(page, 700, dark=True, media="print")
    assert browser.evaluate("document.querySelector('.jump').checkVisibility()") is False
    assert browser.evaluate("document.querySelector('.skip').checkVisibility()") is False
    assert browser.evaluate("getComputedStyle(document.body).color") == "rgb(0, 0, 0)"
    browser.pdf(tmp_path / "report.pdf")
    assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF")
