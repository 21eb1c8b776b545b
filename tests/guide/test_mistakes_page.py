"""The page on mistakes is that which the recorded results give."""

from __future__ import annotations

from tests.guide.mistakes_page import PAGE, page


def test_page_is_made_from_the_recorded_results() -> None:
    assert PAGE.read_text(encoding="utf-8") == page(), "write it by: python -m tests.guide.mistakes_page"
