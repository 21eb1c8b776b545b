"""The title of a text is what the text calls itself."""

from pathlib import Path

import pytest

from workbench.source.documents.titles import title_of


@pytest.mark.parametrize(
    ("name", "text", "title"),
    [
        ("a.tex", "\\title{Motion of a\n  tool}", "Motion of a tool"),
        (
            "a.tex",
            r"\title[Short]{A \emph{long} one\\ with $\omega^2$\thanks{Me {x}}}",
            r"A long one with $\omega^2$",
        ),
        ("a.tex", "% \\title{Not this}\n\\title{This}", "This"),
        ("a.tex", r"\section{No title}", None),
        ("a.md", '---\ntitle: "Screws"\n---\n# Chapter', "Screws"),
        ("a.md", "Text.\n\n# Screws\n", "Screws"),
        ("a.rst", "Screws\n======\n", "Screws"),
        ("a.html", "<html><title>Screws &amp; twists</title>", "Screws & twists"),
    ],
)
def test_title_is_read_without_markup(name, text, title):
    assert title_of(text, Path(name)) == title
