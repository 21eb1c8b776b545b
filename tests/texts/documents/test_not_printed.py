"""What a text does not print, or prints as it is typed, is not judged."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers.load import load_paper
from workbench.source.documents import read_text

SHOWN, HIDDEN = r"\[ a = b \]", r"\[ a = c \]"


def _displays(tmp_path: Path, content: str, name: str) -> list[str]:
    path = tmp_path / name
    path.write_text(content, encoding="utf-8")
    return ["".join(display.latex.split()) for display in read_text(path).displays]


#: Written in front of the text, and around what is not printed.
IN_TEX = [
    ("", r"\iffalse", r"\fi"),
    ("", r"\iftrue\else", r"\fi"),
    ("", r"\iffalse \iftrue x\else y\fi", r"\else z\fi"),
    (r"\newif\ifdraft", r"\ifdraft", r"\fi"),
    ("", r"\verb|", r"|"),
    ("", r"\verb*+", r"+"),
    ("", r"\lstinline|", r"|"),
    ("", r"\lstinline[language=TeX]!", r"!"),
    ("", r"\lstinline{", r"}"),
    ("", r"\mintinline{latex}|", r"|"),
    ("", r"\mintinline[frame=lines]{latex}{", r"}"),
    ("", r"\Verb[fontsize=\small]|", r"|"),
    ("", r"\url{", r"}"),
    *(
        ("", rf"\begin{{{name}}}", rf"\end{{{name}}}")
        for name in ("comment", "verbatim", "verbatim*", "Verbatim", "lstlisting", "filecontents*", "filecontents")
    ),
    ("", r"\begin{minted}{latex}", r"\end{minted}"),
    ("", r"\begin{lstlisting}[language=TeX]", r"\end{lstlisting}"),
    (r"\excludecomment{note}", r"\begin{note}", r"\end{note}"),
    (r"\newenvironment{note}{}{}\excludecomment{note}", r"\begin{note}", r"\end{note}"),
    (r"\includecomment{note}\excludecomment{note}", r"\begin{note}", r"\end{note}"),
    (r"\excludeversion{note}", r"\begin{note}", r"\end{note}"),
    (r"\newenvironment{note}{\comment}{\endcomment}", r"\begin{note}", r"\end{note}"),
    (r"\newenvironment{note}{\small\verbatim}{\endverbatim}", r"\begin{note}", r"\end{note}"),
    (r"\DefineVerbatimEnvironment{note}{Verbatim}{}", r"\begin{note}", r"\end{note}"),
    (r"\lstnewenvironment{note}[1][]{\lstset{#1}}{}", r"\begin{note}", r"\end{note}"),
    (r"\newminted{latex}{linenos}", r"\begin{latexcode}", r"\end{latexcode}"),
    (r"\newcommand{\hide}[1]{}", r"\hide{", r"}"),
]  # fmt: skip


@pytest.mark.parametrize("place", ["between", "in a group", "in a list"])
@pytest.mark.parametrize(("before", "opening", "closing"), IN_TEX)
def test_unprinted_tex_is_not_judged(
    tmp_path: Path, before: str, opening: str, closing: str, place: str
) -> None:
    around = {
        "between": ("", ""),
        "in a group": ("{", "}"),
        "in a list": (r"\begin{itemize}\item ", r"\end{itemize}"),
    }
    left, right = around[place]
    body = f"{SHOWN}{left}\n{opening}{HIDDEN}{closing}\n{right}{SHOWN}"
    content = f"\\documentclass{{article}}{before}\\begin{{document}}{body}\\end{{document}}"
    assert _displays(tmp_path, content, "p.tex") == ["a=b", "a=b"]


PRINTED = [
    (r"\includecomment{comment}", r"\begin{comment}", r"\end{comment}"),
    (r"\excludecomment{note}\includecomment{note}", r"\begin{note}", r"\end{note}"),
    (r"\specialcomment{note}{\par}{\par}", r"\begin{note}", r"\end{note}"),
    (r"\renewenvironment{comment}{}{}", r"\begin{comment}", r"\end{comment}"),
    (r"{\excludecomment{note}}", r"\begin{note}", r"\end{note}"),
    (r"\newcommand{\comment}[1]{#1}\newenvironment{note}{\comment{x}}{}", r"\begin{note}", r"\end{note}"),
    (r"\newcommand{\hide}[1]{#1}", r"\hide{", r"}"),
    ("", r"\iftrue", r"\else x\fi"),
    (r"\newif\ifdraft\drafttrue", r"\ifdraft", r"\fi"),
    (r"", r"\lstinline|x| ", r" |"),
    (r"", r"\lstinline{x}", r""),
]


@pytest.mark.parametrize(("before", "opening", "closing"), PRINTED)
def test_printed_tex_is_judged(tmp_path: Path, before: str, opening: str, closing: str) -> None:
    body = f"{SHOWN}{opening}{HIDDEN}{closing}{SHOWN}"
    content = f"\\documentclass{{article}}{before}\\begin{{document}}{body}\\end{{document}}"
    assert _displays(tmp_path, content, "p.tex") == ["a=b", "a=c", "a=b"]


def test_an_excluded_environment_in_a_display_is_not_judged(tmp_path: Path) -> None:
    content = r"\excludecomment{note}\[ a = \begin{note} c + \end{note} b \]"
    assert _displays(tmp_path, content, "p.tex") == ["a=b"]


CODE = [
    "Text.\n\n    $$a = c$$\n\nText.\n",
    "Text.\n\n\t$$a = c$$\n\nText.\n",
    "Text.\n\n  \t$$a = c$$\n\nText.\n",
    "    $$a = c$$\n",
    "Text.\n\n    $$\n    a = c\n    $$\n",
    "Text.\n\n    x\n\n    $$a = c$$\n\n\n    y\n",
    "Text.\n\n    \\begin{align}\n    a &= c\n    \\end{align}\n",
    "# Heading\n    $$a = c$$\n",
    "- item\n\nText.\n\n    $$a = c$$\n",
    "- item\n\n      $$a = c$$\n",
    "1. item\n\n       $$a = c$$\n",
    "> Text.\n>\n>     $$a = c$$\n",
    "Text.\n\n    ```\n    $$a = c$$\n    ```\n",
    "Text.\n\n        $$a = c$$\n",
    "```\n$$a = c$$\n```\n",
    "~~~\n$$a = c$$\n~~~\n",
    "~~~ tex\n```\n$$a = c$$\n```\n~~~\n",
    "````\n```\n$$a = c$$\n````\n",
    "- item\n\n  ```\n  $$a = c$$\n  ```\n",
    "<!-- $$a = c$$ -->\n",
    "<!--\n\n$$a = c$$\n\n-->\n",
    "<!-- never closed\n\n$$a = c$$\n",
    "<pre>\n$$a = c$$\n</pre>\n",
    "<code>$$a = c$$</code>\n",
    "`$$a = c$$`\n",
    "`` ` $$a = c$$ ``\n",
]
NO_CODE = [
    "Text.\n    $$a = c$$\n",
    "Text.\n\n   $$a = c$$\n",
    "- item\n\n    $$a = c$$\n",
    "- item\n    $$a = c$$\n",
    "1. item\n\n    $$a = c$$\n",
    "10. item\n\n    $$a = c$$\n",
    "* item\n\n    - inner\n\n        $$a = c$$\n",
    "- item\n\n  text\n\n    $$a = c$$\n",
    "- item\n\n\n    $$a = c$$\n",
    "> - item\n>\n>     $$a = c$$\n",
    "[^1]: Note.\n\n    $$a = c$$\n",
    "Term\n: what it means\n\n    $$a = c$$\n",
    '!!! note "Title"\n\n    $$a = c$$\n',
    '=== "Tab"\n\n    $$a = c$$\n',
    "$$\n\n    a = c\n\n$$\n",
    "\\begin{align}\n\n    a &= c\n\\end{align}\n",
    "Use `<!--` here.\n\n$$a = c$$\n\nand `-->` there.\n",
    "Text `` ` `` and\n\n$$a = c$$\n",
]


@pytest.mark.parametrize("content", CODE)
def test_code_and_comments_of_markdown_are_not_judged(tmp_path: Path, content: str) -> None:
    assert _displays(tmp_path, f"$$a = b$$\n\n{content}\n", "p.md") == ["a=b"]


@pytest.mark.parametrize("content", CODE)
def test_displays_after_code_in_markdown_are_judged(tmp_path: Path, content: str) -> None:
    after = [] if "never closed" in content else ["a=b"]
    assert _displays(tmp_path, f"{content}\n\nText.\n\n$$a = b$$\n", "p.md") == after


@pytest.mark.parametrize("content", NO_CODE)
def test_indented_text_of_markdown_is_judged(tmp_path: Path, content: str) -> None:
    displays = _displays(tmp_path, f"$$a = b$$\n\n{content}\n", "p.md")
    assert [each.strip("\\").replace("&", "") for each in displays] == ["a=b", "a=c"]


RST = [
    "..\n   .. math:: a = c\n",
    ".. a comment\n\n   .. math:: a = c\n",
    "Code::\n\n   .. math:: a = c\n",
    ".. code-block:: rst\n\n   .. math:: a = c\n",
    ">>> '.. math:: a = c'\n",
]
RST_PRINTED = [
    ".. note::\n\n   .. math:: a = c\n",
    ".. _target:\n\n.. math:: a = c\n",
    "..\n\n.. math:: a = c\n",
    ".. [1] Footnote\n\n   .. math:: a = c\n",
    ".. |name| replace:: x\n\n.. math:: a = c\n",
]


@pytest.mark.parametrize(
    ("content", "latex"), [(each, ()) for each in RST] + [(each, ("a=c",)) for each in RST_PRINTED]
)
def test_comments_of_restructuredtext_are_not_judged(
    tmp_path: Path, content: str, latex: Sequence[str]
) -> None:
    page = f".. math:: a = b\n\n{content}\n.. math:: a = b\n"
    assert _displays(tmp_path, page, "p.rst") == ["a=b", *latex, "a=b"]


@pytest.mark.parametrize(
    "html",
    [f"<{name}>$$a = c$$</{name}>" for name in ("pre", "code", "script", "textarea")]
    + ["<!-- $$a = c$$ -->"],
)
def test_code_and_comments_of_html_are_not_judged(tmp_path: Path, html: str) -> None:
    assert _displays(tmp_path, f"<p>$$a = b$$</p>{html}<p>$$a = b$$</p>", "p.html") == ["a=b", "a=b"]


JUDGED = {
    "p.tex": r"\documentclass{article}\usepackage{comment}\excludecomment{solution}\begin{document}"
    r"\begin{solution}\begin{equation} f = f + 1 \end{equation}" + "\n"
    r"\end{solution}\begin{equation} f g = g f \end{equation}\end{document}",
    "p.md": "Text.\n\n    $$f = f + 3$$\n\nMore $$f g = g f$$\n",
    "p.rst": "..\n   .. math:: f = f + 3\n\n.. math:: f g = g f\n",
}


@pytest.mark.parametrize("name", JUDGED)
def test_only_what_is_printed_has_a_verdict(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text(JUDGED[name])
    (tmp_path / "p.toml").write_text(f'source = "{name}"\n[symbols]\nf = "scalar"\ng = "scalar"\n')
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert "g f" in result.claim.printed.latex


def test_verb_ends_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "p.tex").write_text("Text \\verb|a\n\\[ |c| = d \\]\n\\[ e = f \\]\n")
    assert [display.latex.strip() for display in read_text(tmp_path / "p.tex").displays] == [
        "|c| = d",
        "e = f",
    ]
