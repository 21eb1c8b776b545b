"""Macros are expanded as TeX expands them; every token stands at the author's own characters."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from workbench.source.documents import Display, Text, read_text

EXPANDED = [
    (r"\newcommand{\w}{\omega}", r"\w \times r", r"\omega\times r"),
    (r"\newcommand\scal[2]{#1 \cdot #2}", r"\scal{a}{b} = \scal bc", r"a \cdot b = b \cdot c"),
    (r"\newcommand{\d}[2][]{\frac{d^{#1} #2}{dt^{#1}}}", r"\d[2]{x} + \d y", r"\frac{d^{2} x}{dt^{2}} + \frac{d^{} y}{dt^{}}"),
    (r"\def\pair(#1,#2){[#1|#2]}", r"\pair(a,b)", r"[a|b]"),
    (r"\def\upto#1\end{<#1>}", r"\upto x+y\end z", r"<x+y>z"),
    (r"\def\upto#1\end{<#1>}", r"\upto{x}\end \upto{x}{y}\end", r"<x> <{x}{y}>"),
    (r"\DeclareMathOperator{\tr}{tr}\DeclareMathOperator*{\argmin}{arg\,min}", r"\tr A", r"\operatorname{tr}A"),
    (r"\DeclarePairedDelimiter\norm{\lVert}{\rVert}", r"\norm*{x} = \norm[\big]{y}", r"\left\lVert x\right\rVert= \left\lVert y\right\rVert"),
    (r"\NewDocumentCommand\v{s m O{B}}{\IfBooleanTF{#1}{\dot #2}{#2}_{#3}}", r"\v{r} + \v*{r}[A]", r"r_{B} + \dot r_{A}"),
    (r"\NewDocumentCommand\p{m o}{#1\IfNoValueF{#2}{^{#2}}}", r"\p{a} \p{b}[2]", r"a b^{2}"),
    (r"\let\ga\alpha\let\old\vec\renewcommand{\vec}[1]{\mathbf{#1}}", r"\ga \vec{a} \old{b}", r"\alpha\mathbf{a} \vec{b}"),
    (r"\newif\iflong\longtrue\newcommand\x{\iflong a\else b\fi}", r"\x", r"a"),
    (r"\newcommand\x{\ifnum 1<2 a\else b\fi}", r"\x + \ifnum-3>12 a\else b\fi", "a + b"),
    ("", r"\ifnum 12=012 a\else b\fi + \ifnum 1>0 2 a\else b\fi", "a + 2 a"),
    (r"\newif\ifbar\bartrue\let\ifz\bar", r"\ifz{x}", r"\bar{x}"),
    (r"\makeatletter\newif\ifmy@\newcommand\x{\my@false\ifmy@ a\else b\fi}\makeatother", r"\x", "b"),
    (r"\NewDocumentCommand\v{t+ m}{\IfBooleanTF{#1}{\dot #2}{#2}}", r"\v+{r} = \v{r}", r"\dot r = r"),
    (r"\newcommand\x{\ifmmode a\else b\fi}", r"\x", "a"),
    (r"\newcommand\opt[1]{a\ifx\\#1\\ \else_{#1}\fi}", r"\opt{} \opt{k}", r"a a_{k}"),
    (r"\newcommand\e[1]{\ensuremath{e_{#1}}}", r"\e1", r"e_{1}"),
    (r"\newcommand\make[1]{\newcommand#1[1]{<##1>}}\make\angle", r"\angle{x}", r"<x>"),
    (r"\newcommand\twice[1]{\once{#1}\once{#1}}\newcommand\once[1]{(#1)}", r"\twice{\twice x}", r"((x)(x))((x)(x))"),
    (r"\newcommand\x{a}\renewcommand\x{b}\providecommand\x{c}", r"\x", r"b"),
]  # fmt: skip


def _read(tmp_path: Path, name: str, content: str) -> Text:
    path = tmp_path / name
    path.write_text(content, encoding="utf-8")
    return read_text(path)


def _bare(latex: str) -> str:
    return "".join(latex.split())


@pytest.mark.parametrize(("declared", "written", "expanded"), EXPANDED)
def test_macros_are_expanded_as_tex_does(tmp_path: Path, declared: str, written: str, expanded: str) -> None:
    text = _read(
        tmp_path,
        "p.tex",
        f"\\documentclass{{article}}{declared}\\begin{{document}}\\[{written}\\]\\end{{document}}",
    )
    assert [_bare(display.latex) for display in text.displays] == [_bare(expanded)]
    assert text.warnings == []


def tokens_of(display: Display) -> Iterator[tuple[str, str, bool]]:
    """Each token, what stands in the author's file there, and whether it came through a macro."""
    for token in display.tokens:
        yield token.text, token.source.text[token.start : token.end], token.call is not None


FORMATS = {
    "p.tex": "é\r\n\\newcommand{{\\w}}[1]{{\\omega_{{#1}}}}\r\n% \\[ no \\]\r\nText $x$ \\[\r\n {body} \\]\r\n",
    "p.md": "---\ntitle: é $$ no $$\n---\n# A\n\n`$$ no $$` <!-- $$ no $$ -->\n\n```tex\n$$ no $$\n```\n\n$$ \\newcommand{{\\w}}[1]{{\\omega_{{#1}}}} $$\n\n> quoted\n>\n> $$\n> {body}\n> $$\n",
    "p.rst": "A\n=\n\nno::\n\n   .. math:: no\n\n.. math:: \\newcommand{{\\w}}[1]{{\\omega_{{#1}}}}\n\n.. math::\n   :label: one\n\n   {body}\n\nEnd.\n",
    "p.html": "<pre>$$ no $$</pre><!-- $$ no $$ --><h2>A é</h2><p>$$ \\newcommand{{\\w}}[1]{{\\omega_{{#1}}}} $$</p>\n<p>\\[ {body} \\]</p><script>$$ no $$</script>",
    "p.ipynb": '{{"cells": [{{"cell_type": "code", "source": ["$$ no $$"]}}, {{"cell_type": "markdown", "metadata": {{}}, "source": ["\\u00e9 $$ {json} $$\\n"]}}]}}',
}
BODY = r"\w{1} + \w k = \frac{a}{b} \cdot (c \times d)^T"


@pytest.mark.parametrize("name", FORMATS)
def test_every_token_shows_the_authors_own_characters(tmp_path: Path, name: str) -> None:
    json_body = BODY.replace("\\w{1} + \\w k", "a").replace("\\", "\\\\")
    text = _read(tmp_path, name, FORMATS[name].format(body=BODY, json=json_body))
    (display,) = text.displays
    assert text.warnings == []
    tokens = [each for each in tokens_of(display) if not each[0].isspace()]
    assert len(tokens) > 15
    for token, shown, through in tokens:
        if name == "p.ipynb":  # a backslash is written as two
            assert shown.replace("\\\\", "\\") == token
        elif through:
            assert shown == "\\w"
        else:
            assert shown == token


def test_a_token_knows_the_macros_it_came_through(tmp_path: Path) -> None:
    text = _read(tmp_path, "p.tex", "\\def\\a{\\b x}\\def\\b{y}\n\\[ \\a \\]")
    chains = {
        token.text: [call.name for call in token.call.chain()]
        for token in text.displays[0].tokens
        if token.call
    }
    assert chains == {"y": ["b", "a"], "x": ["a"]}


def test_overrides_win_over_the_text(tmp_path: Path) -> None:
    (tmp_path / "m.tex").write_text(r"\newcommand{\par@}[1]{}\newcommand{\paren}[1]{\left(#1\right)}")
    path = tmp_path / "p.tex"
    path.write_text(r"\newcommand{\paren}[1]{\expandafter(#1)}\[ \paren{a} \]")
    assert read_text(path).displays[0].opaque == {"paren"}
    assert "only TeX can follow" in read_text(path).warnings[0].message
    read = read_text(path, macros=tmp_path / "m.tex").displays[0]
    assert _bare(read.latex) == r"\left(a\right)" and not read.opaque


@pytest.mark.parametrize("test", [r"\z>1", r"1<\z", r"-1=\z"])
def test_an_undecided_comparison_is_reported_and_kept(tmp_path: Path, test: str) -> None:
    text = _read(tmp_path, "p.tex", rf"\[ \ifnum{test} a\else b\fi \]")
    (display,) = text.displays
    assert "first branch" in text.warnings[0].message and display.opaque == {"ifnum"}
    assert _bare(display.latex) == f"{test}a"


MARKDOWN = [
    ("GitHub", "```math\na = b\n```\n", ["a = b"]),
    ("GitHub", "a\n\n$`a = b\n+ c`$\n\nwith $`b = 1`$\n\n$`b`$\n\n`$`x = y`$`\n", ["a = b\n+ c"]),
    ("GitHub", "so\n\n$a = b$.\n\n$b = c$ is\n\n$c$\n\n> $d = e$\n", ["a = b", "d = e"]),
    ("MyST", "```{math}\n:label: one\na = b\n```\n\n$$ c = d $$ (two)\n", ["a = b", "c = d"]),
    (
        "MyST's directives",
        "````{dropdown} More\n$$ a = b $$\n```{math}\nc = d\n```\n````\n```{code-block} tex\n$$ x = y $$\n```\n"
        "```{admonition} So\n$$ e = f $$\n```\n$$ g = h $$\n```python\n'$$ x = y $$'\n```\n",
        ["a = b", "c = d", "e = f", "g = h"],
    ),
    (
        "no mdBook",
        "$$ a = b \\\\[4pt] c = d $$\n\n$$ a = b \\\\ \\{c\\} = d $$\n",
        [r"a = b \\[4pt] c = d", r"a = b \\ \{c\} = d"],
    ),
    ("mdBook", "\\\\[ a\\_1 = b \\\\]\n\nText \\\\( x \\\\)\n", ["a_1 = b"]),
    (
        "a row gap",
        "$$a = \\begin{bmatrix} b \\\\[4pt] c \\end{bmatrix}$$\n\n$$b \\\\ c$$\n",
        ["a = \\begin{bmatrix} b \\\\[4pt] c \\end{bmatrix}", "b \\\\ c"],
    ),
    (
        "a row in a bracket",
        "$$a = \\begin{bmatrix} b \\\\(c + d) \\end{bmatrix}$$\n\nText $x \\\\) y$.\n",
        ["a = \\begin{bmatrix} b \\\\(c + d) \\end{bmatrix}"],
    ),
    (
        "a row gap outside",
        "\\begin{align} a &= b \\\\[1ex] c &= d \\end{align}\n\nText \\\\] here.\n",
        ["a &= b \\\\ c &= d"],
    ),
    (
        "GitHub's escapes",
        "$$\n\\mathbf{q}\\_0 = a\\_{\\text{b\\_c}} + b\\\\_1\n$$\n\n$$\n\\{\\{f_f}*c({d}) } = \\{m * ({r}*\\{v_x})}\n$$\n",
        [r"\mathbf{q}_0 = a_{\text{b\_c}} + b_1", "{{f_f}*c({d}) } = {m * ({r}*{v_x})}"],
    ),
    (
        "braces that are meant",
        r"$$ A = \{ a_{1}, \frac{1}{2} \} $$"
        + "\n\n"
        + r"$$ {\left\{ a \right.} = \{b\} $$"
        + "\n\n"
        + r"$$ a = \{ b $$",
        [r"A = \{ a_{1}, \frac{1}{2} \}", r"{\left\{ a \right.} = \{b\}", r"a = \{ b"],
    ),
    ("kramdown", "---\nt: 1\n---\n\nin $$x$$ a line\n\n$$ a = b $$\n", ["a = b"]),
    ("an environment", "\\begin{align}\na &= b \\\\\nc &= d\n\\end{align}\n", ["a &= b \\\\ c &= d"]),
    ("around one", "$$\n\\begin{align*}\na &= b\n\\end{align*}\n$$\n", ["a &= b"]),
]


@pytest.mark.parametrize(("name", "content", "latex"), MARKDOWN, ids=[name for name, _, _ in MARKDOWN])
def test_markdown_of_all_sorts(tmp_path: Path, name: str, content: str, latex: list[str]) -> None:
    text = _read(tmp_path, "p.md", content)
    assert [_bare(display.latex) for display in text.displays] == [_bare(each) for each in latex]


def test_labels_and_sections_outside_of_tex(tmp_path: Path) -> None:
    text = _read(tmp_path, "p.md", "# One\n\n$$ a $$ (first)\n\nTwo\n---\n\nWe see. So it is:\n$$ b $$\n")
    first, second = text.displays
    assert (first.labels, first.heading) == (("first",), "One")
    assert (second.labels, second.heading, second.before) == ((), "Two", "So it is:")


def test_formulas_in_sentences(tmp_path: Path) -> None:
    for name, content in (
        ("p.tex", "a $x$ b \\(y\\)"),
        ("p.md", "a $x$ b, 5$ and $y$"),
        ("p.rst", "a :math:`x` b :math:`y`"),
    ):
        path = tmp_path / name
        path.write_text(content)
        text = read_text(path)
        assert text.displays == []
        assert [formula.latex for formula in text.inline] == ["x", "y"]
