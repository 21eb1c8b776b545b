"""The page of `workbench serve` in a real browser: paste, marks, apply, assume, keys, a stopped server."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from headless_browser import EXECUTABLE, Browser

pytest.importorskip("uvicorn")
from page_server import Served, served

pytestmark = pytest.mark.skipif(EXECUTABLE is None, reason="no Chromium is installed")

TEXT = r"""\begin{equation}\label{eq:swap} \mathbf{a} \times \mathbf{b} = \mathbf{b} \times \mathbf{a} \end{equation}
\begin{equation} \mathbf{a} \times \mathbf{b} = -\mathbf{b} \times \mathbf{a} \end{equation}
"""
MODEL = """source = "paper.tex"
[symbols]
'\\mathbf{a}' = "vector"
'\\mathbf{b}' = "vector"
"""
TITLE = "document.title"
BUSY = "document.querySelector('[aria-busy=true]') !== null"
STATUS = "document.getElementById('status').textContent"
OVERFLOWING = """[...document.querySelectorAll('body *')].filter(e => e.checkVisibility() && !e.closest('.cm-editor, .f, dd, math'))
  .filter(e => e.getBoundingClientRect().right > innerWidth + 1).map(e => e.outerHTML.slice(0, 90))"""
UNNAMED = """[...document.querySelectorAll('button, select, [role=textbox]')].filter(e => e.checkVisibility())
  .filter(e => !(e.textContent.trim() || e.getAttribute('aria-label'))).map(e => e.outerHTML.slice(0, 90))"""
SMALL = """[...document.querySelectorAll('button, select')].filter(e => e.checkVisibility())
  .filter(e => e.getBoundingClientRect().height < 24).map(e => e.outerHTML.slice(0, 90))"""
FAINT = """(() => {
  const parts = c => c.match(/[\\d.]+/g).map(Number);
  const light = c => parts(c).slice(0, 3).map(v => v / 255)
    .map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = e => { for (; e; e = e.parentElement) {
    const c = getComputedStyle(e).backgroundColor; if (parts(c)[3] !== 0) return c; } return 'rgb(255, 255, 255)'; };
  return [...document.querySelectorAll('h1, h2, p, span, small, dt, dd, button, li, code')]
    .filter(e => e.checkVisibility() && !e.closest('.cm-editor') && [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()))
    .filter(e => { const [a, b] = [light(getComputedStyle(e).color), light(behind(e))];
      return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < 4.5; }).map(e => e.outerHTML.slice(0, 90)); })()"""


class Tab:
    """The page in a browser."""

    def __init__(self, browser: Browser) -> None:
        self.browser, self.see = browser, browser.evaluate

    def until(self, script: str, seconds: float = 60) -> None:
        end = time.monotonic() + seconds
        while not self.see(script):
            assert time.monotonic() < end, (script, self.see("document.body.innerText")[-2000:])
            time.sleep(0.05)

    def judged(self, title: str) -> None:
        """Waits until the title says so and nothing is being found."""
        self.until(f"{TITLE}.includes({title!r}) && !({BUSY}) && !{STATUS}.includes('looking')")

    def type(self, text: str) -> None:
        """Writes into the editor as a keyboard does, over what stands there."""
        self.see("document.querySelector('.cm-content').focus()")
        self.see("document.execCommand('selectAll')")
        self.browser.call("Input.insertText", text=text)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    made = Browser(tmp_path_factory.mktemp("profile"))
    yield made
    made.close()


@pytest.fixture(scope="module")
def page() -> Iterator[Served]:
    with served() as found:
        yield found


@pytest.fixture
def tab(browser: Browser, page: Served) -> Tab:
    browser.open("about:blank", 1280)
    browser.open(page.address, 1280)
    made = Tab(browser)
    made.until("document.querySelector('.ex, .d') !== null")
    return made


def test_a_pasted_text_is_judged_corrected_and_right(tab: Tab) -> None:
    assert "token" not in tab.see("location.href")
    tab.type(TEXT)
    tab.judged("1 warning, 1 holds")
    assert (
        tab.see(
            "[...document.querySelectorAll('.cm-marks .k')].map(e => e.textContent).filter(Boolean).join()"
        )
        == "!,✓"
    )
    assert tab.see("document.querySelectorAll('.cm-lintRange-warning').length") > 0
    assert (
        tab.see("[...document.querySelectorAll('#displays .head .num')].map(e => e.textContent).join()")
        == "(1) eq:swap,(2)"
    )
    tab.see("document.querySelector('#displays .head').focus()")
    tab.browser.press("Enter")
    assert "Counterexample" in tab.see("document.querySelector('#displays .d').innerText")
    tab.browser.press("ArrowDown")
    assert tab.see("document.activeElement.dataset.name") == "(2)"
    tab.see("document.querySelector('#displays .act .first').click()")
    tab.judged("2 hold")
    assert "= -\\mathbf{b}" in tab.see("document.querySelector('.cm-content').innerText").split("\n")[0]


def test_an_assumption_that_is_changed_judges_anew(tab: Tab) -> None:
    tab.type(TEXT)
    tab.judged("1 warning, 1 holds")
    change = "(s => { s.value = 'scalar'; s.dispatchEvent(new Event('change')); })"
    tab.see(f"document.querySelectorAll('[data-symbol]').forEach({change})")
    tab.until(f"!{TITLE}.includes('1 warning, 1 holds')")
    assert tab.see("document.querySelector('.b').textContent") == "asked"


@pytest.mark.parametrize("width,dark", [(1280, False), (900, True), (400, False), (400, True)])
def test_the_page_fits_and_can_be_read(browser: Browser, page: Served, width: int, dark: bool) -> None:
    browser.open("about:blank", width, dark)
    browser.open(page.address, width, dark)
    tab = Tab(browser)
    tab.until("document.querySelector('.ex, .d') !== null")
    for name in ("source", "displays"):
        if width == 400:
            tab.see(f"document.getElementById('t-{name}').click()")
        if name == "source":
            tab.type(TEXT)
            tab.judged("1 warning, 1 holds")
        assert tab.see(OVERFLOWING) == [] and tab.see(UNNAMED) == [] and tab.see(SMALL) == []
        assert tab.see(FAINT) == []
        assert tab.see("document.documentElement.scrollWidth") <= width


def test_nothing_is_asked_of_another_host(browser: Browser, page: Served) -> None:
    others = [
        url
        for url in browser.requests
        if not url.startswith((f"http://127.0.0.1:{page.port}/", "data:", "about:"))
    ]
    assert others == []


def test_a_stopped_server_is_reported_and_the_text_kept(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "paper.tex"
    path.write_text(TEXT)
    tab = Tab(browser)
    with served(path) as page:
        browser.open(page.address, 1280)
        tab.judged("1 warning, 1 holds")
        path.write_text(TEXT.replace("= \\mathbf{b}", "= -\\mathbf{b}"))
        tab.judged("2 hold")
        tab.type(TEXT)
        tab.judged("1 warning, 1 holds")
        tab.see("document.getElementById('save').click()")
        tab.until("document.getElementById('save').disabled")
        assert path.read_text() == TEXT
        path.with_suffix(".toml").write_text(MODEL)
        tab.judged("1 error, 1 holds")
        assert "paper.toml" in tab.see("document.getElementById('assumptions').textContent")
    tab.type(TEXT + "% more")
    tab.until("!document.getElementById('alert').hidden")
    assert "The server has stopped" in tab.see("document.getElementById('alert').textContent")
    assert "% more" in tab.see("document.querySelector('.cm-content').innerText")
