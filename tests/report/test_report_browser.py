"""The page in a real browser: nothing overflows, filters and links work, all formulas have a size."""

import pytest
from headless_browser import EXECUTABLE, Browser
from sample_report import CLAIMS, sample

from workbench.report.render import write_report

pytestmark = pytest.mark.skipif(EXECUTABLE is None, reason="no Chromium is installed")

UNFOLD = "document.querySelectorAll('details').forEach(d => d.open = true)"
VISIBLE = "[...document.querySelectorAll('{}')].filter(e => e.checkVisibility()).map(e => e.id)"
OVERFLOWING = """[...document.querySelectorAll('body *')]
  .filter(e => !e.parentElement.closest('.scroll, .wrong, p') && !e.closest('.skip, .visually-hidden'))
  .filter(e => e.getBoundingClientRect().right > innerWidth + 1).map(e => e.outerHTML.slice(0, 80))"""
MATCHES_FILTER = """[...document.querySelectorAll('.claim')]
  .every(e => e.checkVisibility() == e.matches('.%s'))"""
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
  return [...document.querySelectorAll('.chip, .badge, .tile dd, .tile dt, p, a, caption, .id, .changed')]
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
    assert (background == "rgb(253, 253, 251)") is not dark


def test_page_asks_for_nothing(browser, page):
    browser.requests.clear()
    browser.open(page, 1280)
    assert {url.split(":")[0] for url in browser.requests} <= {"file", "data"}
    assert [url for url in browser.requests if url.startswith("file")] == [page.as_uri()]


def test_filters_show_exactly_their_kind(browser, page):
    browser.open(page, 1280)
    browser.evaluate(UNFOLD)
    total = len(CLAIMS)
    assert len(browser.evaluate(VISIBLE.format(".claim"))) == total
    filters = browser.evaluate("[...document.querySelectorAll('.filters input')].map(e => e.id.slice(7))")
    assert filters[:2] == ["all", "erratum"] and len(filters) > 5
    shown = 0
    for kind in filters[2:]:
        browser.evaluate(f"document.getElementById('filter-{kind}').click()")
        shown += len(browser.evaluate(VISIBLE.format(".claim")))
        assert browser.evaluate(MATCHES_FILTER % kind)
        # No heading without a claim under it.
        assert browser.evaluate(
            "[...document.querySelectorAll('.equation, .in-section')].filter(e => e.checkVisibility())"
            ".every(e => [...e.querySelectorAll('.claim')].some(c => c.checkVisibility()))"
        )
    assert shown == total
    browser.evaluate("document.getElementById('filter-erratum').click()")
    assert browser.evaluate(MATCHES_FILTER % "erratum") and browser.evaluate(VISIBLE.format(".claim"))


def test_a_link_of_the_map_leads_to_its_entry_even_when_filtered_away(browser, page):
    browser.open(page, 1280)
    browser.evaluate(
        "[...document.querySelectorAll('.filters input')].find(e => e.id != 'filter-all'"
        " && !document.querySelector('#eq-59 .' + e.id.slice(7))).click()"
    )
    assert not browser.evaluate("document.getElementById('eq-59').checkVisibility()")
    browser.evaluate("document.querySelector('.map a[href=\"#eq-59\"]').click()")
    browser.evaluate("document.body.offsetHeight")
    box = "document.getElementById('eq-59').getBoundingClientRect()"
    assert browser.evaluate("document.querySelector('#eq-59 .claim').checkVisibility()")
    assert 0 <= browser.evaluate(f"{box}.top") < 900


def test_keyboard_reaches_the_equations_in_two_keys(browser, page):
    browser.open(page, 1280)
    browser.press("Tab")
    assert browser.evaluate("document.activeElement.className") == "skip"
    assert browser.evaluate("document.activeElement.getBoundingClientRect().left") >= 0
    browser.press("Enter")
    assert browser.evaluate("location.hash") == "#equations"
    browser.press("Tab")
    assert browser.evaluate("document.activeElement.id") == "filter-all"
    browser.press("ArrowRight")
    assert browser.evaluate("document.activeElement.id") == "filter-erratum"
    assert browser.evaluate("document.activeElement.checked")
    assert browser.evaluate("getComputedStyle(document.activeElement).outlineStyle") != "none"


def test_every_control_and_box_has_a_name(browser, page):
    browser.open(page, 1280)
    tree = browser.call("Accessibility.getFullAXTree")["nodes"]
    named = {"link", "radio", "region", "navigation", "article"}
    nameless = [
        node["role"]["value"]
        for node in tree
        if not node.get("ignored")
        and node.get("role", {}).get("value") in named
        and not node.get("name", {}).get("value", "").strip()
    ]
    assert nameless == []
    boxes = "[...document.querySelectorAll('.scroll')]"
    assert browser.evaluate(
        f"{boxes}.every(e => e.tabIndex == 0 && (e.ariaLabel || e.getAttribute('aria-labelledby')))"
    )
    roles = {node.get("role", {}).get("value") for node in tree}
    assert {"main", "banner", "contentinfo", "navigation", "columnheader", "rowheader"} <= roles


def test_wide_tilde_spans_its_base(browser, page):
    browser.open(page, 1280)
    browser.evaluate(UNFOLD)
    widths = browser.evaluate(
        "[...document.querySelectorAll('mover.wide-tilde')].filter(e => e.checkVisibility())"
        ".map(e => [e.getBoundingClientRect().width, e.children[0].getBoundingClientRect().width])"
    )
    assert len(widths) >= 3
    assert all(abs(mark - base) < 2 for mark, base in widths)


def test_print_is_clean(browser, page, tmp_path):
    browser.open(page, 700, dark=True, media="print")
    assert browser.evaluate("document.querySelector('.filters').checkVisibility()") is False
    assert browser.evaluate("document.querySelector('.skip').checkVisibility()") is False
    ink = browser.evaluate("getComputedStyle(document.body).color")
    assert ink == "rgb(28, 30, 33)"
    browser.pdf(tmp_path / "report.pdf")
    assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF")
