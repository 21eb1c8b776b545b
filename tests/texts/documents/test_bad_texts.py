"""Bad input gets clear words: no exception but PaperError, no hang, nothing lost that stands elsewhere."""

from __future__ import annotations

import json
import os
import random
import re
import time
from pathlib import Path

import pytest

from workbench.papers import PaperError, load_paper
from workbench.source.documents import SUFFIXES, read_text

WARNED = [
    ("unclosed bracket", r"\[ a = b", "never closed", ["a = b"]),
    ("unclosed environment", "\\begin{equation} a = b\n\\section{Next}\n\\[ c = d \\]", "never closed", ["a = b", "c = d"]),
    ("one in the other", r"\begin{equation} a = b \begin{equation} c = d \end{equation}", "never closed", ["a = b", "c = d"]),
    ("a brace too few", r"\[ \frac{a}{b = c \] then \[ d = e \]", "do not close", [r"\frac{a}{b = c", "d = e"]),
    ("a brace too many", r"\[ a} = c \] then \[ d = e \]", "do not close", ["a} = c", "d = e"]),
    ("wrong end", r"\[ \begin{matrix} a \end{pmatrix} = \end{x} b \] \[ c \]", "closes nothing", None),
    ("a macro in itself", r"\def\x{\x a}\[ \x = b \] \[ c = d \]", "calls itself", None),
    ("two macros in each other", r"\def\x{\y}\def\y{\x}\[ \x = b \] \[ c = d \]", "calls itself", None),
    ("a macro that doubles", r"\def\x{\x\x}\[ \x = b \] \[ c = d \]", "calls itself", None),
    ("a missing file", r"\input{nowhere}\[ a = b \]", "no file 'nowhere'", ["a = b"]),
    ("expl3", r"\ExplSyntaxOn \cs_new:Npn \x {} \ExplSyntaxOff \[ a \]", "expl3", ["a"]),
    ("a blank line", "\\[ a\n\n = b \\]", "blank line", [r"a\\ = b"]),
]  # fmt: skip


def _read(tmp_path: Path, content: str | bytes, name: str = "p.tex"):
    path = tmp_path / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_text(path)


@pytest.mark.parametrize(("name", "content", "words", "latex"), WARNED, ids=[case[0] for case in WARNED])
def test_one_clear_warning_and_nothing_lost(
    tmp_path: Path, name: str, content: str, words: str, latex
) -> None:
    text = _read(tmp_path, content)
    assert any(words in warning.message for warning in text.warnings)
    assert all(warning.line for warning in text.warnings)
    if latex is None:
        assert len(text.displays) == 2
    else:
        assert ["".join(display.latex.split()) for display in text.displays] == [
            "".join(each.split()) for each in latex
        ]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"a\0b", "NUL"),
        (b"\xff\xfea\0", None),
        (b"\xef\xbb\xbf\\[ a \\]", None),
        (b"\xe9 \\[ a \\]", "Latin-1"),
    ],
)
def test_encodings(tmp_path: Path, content: bytes, words: str | None) -> None:
    if words == "NUL":
        with pytest.raises(PaperError, match="NUL"):
            _read(tmp_path, content)
        return
    text = _read(tmp_path, content)
    assert [words in warning.message for warning in text.warnings] == ([True] if words else [])


@pytest.mark.parametrize("name", ["nowhere.tex", "p.docx", "."])
def test_no_text(tmp_path: Path, name: str) -> None:
    with pytest.raises(PaperError):
        read_text(tmp_path / name)


HUGE = {
    "prose": "word $x$ " * 30_000,
    "a display": "\\[" + "x + " * 60_000 + "y \\] \\[ a = b \\]",
    "open dollars": "$$ a " * 20_001,
    "open brackets": "\\[ a " * 20_000,
    "backslashes": "\\" * 200_000,
    "backticks": "`a ``b " * 30_000,
    "braces": "{" * 100_000,
    "tags": "<a " * 50_000 + "<!-- " * 20_000,
    "begin": "\\begin{align} a &= b \\\\ " * 8_000,
    "comment": "%" * 200_000,
    "percents": "%\n" * 100_000,
    "hashes": "#" * 200_000,
    "doubling": "\\def\\d#1{#1#1}\\[" + "\\d{" * 40 + "x" + "}" * 40 + "\\] \\[ a \\]",
    "long line of rows": "\\begin{align}" + "a &= b \\\\ " * 20_000 + "\\end{align}",
}


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".tex", ".md", ".html", ".rst", ".ipynb"])
@pytest.mark.parametrize("name", HUGE)
def test_long_files_take_no_longer_than_their_length(tmp_path: Path, name: str, suffix: str) -> None:
    content = HUGE[name]
    start = time.process_time()
    _read(tmp_path, content, f"p{suffix}")
    assert time.process_time() - start < 5 * max(1, len(content) / 100_000)


@pytest.mark.parametrize("addends", [4_900, 25_000, 1_000_000])
def test_a_formula_of_any_length_is_judged_or_refused_at_once(tmp_path: Path, addends: int) -> None:
    """Up to 20,000 characters of one formula are read; the next formula is, in any case."""
    paper = tmp_path / "p.tex"
    paper.write_text("\\[ a " + "+ b " * addends + "= c \\] \\[ a + b = b + a \\]")
    (tmp_path / "p.toml").write_text(
        'source = "p.tex"\n[symbols]\na = "scalar"\nb = "scalar"\nc = "scalar"\n'
    )
    claims = load_paper(tmp_path / "p.toml").claims
    assert (claims[0].printed.statement is None) == (addends > 4_900)
    assert claims[1].printed.statement is not None


SNIPPETS = [
    "\\begin{align}", "\\end{align}", "\\[", "\\]", "$$", "$", "{", "}", "\\\\", "&", "\\def\\x#1{#1\\x}", "\\x", "\\newcommand",
    "\\let\\a=", "\\if", "\\else", "\\fi", "\\ifx", "\\begin{verbatim}", "\\verb|", "\\label{a}", "\\tag", "\\input{p}", "#1", "%", "\n\n",
    "\\begin", "\\end", "[", "]", "\\NewDocumentCommand\\y{s o m}{#1}", "\\y", "```", "`", "<!--", "<script>", ".. math::\n", "   :label:",
    "\\newenvironment{e}[1]", "\\begin{e}", "\\end{e}", "\\numberwithin{equation}{section}", "\\section", "\\setcounter{equation}{\\value{x}}",
    "\x1b[31m", "é", "a = b", "\\DeclarePairedDelimiterX\\n[2]", "\\expandafter", "\\csname", "\\IfBooleanTF", "\\text{", "\\intertext", "\\eqno",
]  # fmt: skip


@pytest.mark.parametrize("suffix", [".tex", ".md", ".html", ".rst"])
def test_no_heap_of_fragments_ends_in_an_exception(tmp_path: Path, suffix: str) -> None:
    draw = random.Random(7)
    for _ in range(60):
        content = "".join(draw.choice(SNIPPETS) for _ in range(draw.randrange(60)))
        text = _read(tmp_path, content, f"p{suffix}")
        for display in text.displays:
            assert 0 <= display.start <= display.end <= len(content.encode())
            assert all(token.start <= token.end <= len(token.source.text) for token in display.tokens)


def test_a_cut_text_loses_only_what_is_cut(tmp_path: Path) -> None:
    whole = "\\section{A}\n\\begin{align} a &= b \\\\ c &= d \\end{align}\n\\[ \\frac{a}{b} \\]\n" * 3
    for end in range(0, len(whole), 7):
        displays = _read(tmp_path, whole[:end]).displays
        closed = whole[:end].count("\\end{align}") + whole[:end].count("\\]")
        assert len(displays) >= closed


PAGE = r"""
# Spin
\newcommand{\v}[1]{\boldsymbol{#1}}
The spin is $\v{\omega}$, where $L = J \v{\omega}$ é.

$$ \dot{L} = \v{\tau} \tag{1} $$
\begin{align} a &= b + c \label{eq:a} \\ &= \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix} d \end{align}

.. math:: x = y
"""


def _truncated(draw: random.Random, content: bytes) -> bytes:
    return content[: draw.randrange(len(content))]


def _flipped(draw: random.Random, content: bytes) -> bytes:
    damaged = bytearray(content)
    for _ in range(draw.randrange(1, 12)):
        damaged[draw.randrange(len(damaged))] = draw.randrange(256)
    return bytes(damaged)


def _unbalanced(draw: random.Random, content: bytes) -> bytes:
    marks = [match.span() for match in re.finditer(rb"\\(?:begin|end)\{\w+\}|[{}$&]|\\\\", content)]
    start, end = draw.choice(marks)
    return content[:start] + content[end:] + draw.choice([b"", content[start:end] * 2])


def _controlled(draw: random.Random, content: bytes) -> bytes:
    place = draw.randrange(len(content))
    return content[:place] + bytes(draw.choices([1, 7, 8, 11, 12, 27, 127, 155], k=5)) + content[place:]


def _encoded(draw: random.Random, content: bytes) -> bytes:
    return content.decode().encode(draw.choice(["utf-16", "utf-32", "latin-1", "cp037"]))


@pytest.mark.parametrize("suffix", [".tex", ".md", ".rst", ".ipynb"])
@pytest.mark.parametrize("damage", [_truncated, _flipped, _unbalanced, _controlled, _encoded])
def test_a_damaged_text_is_read_or_refused_in_words(
    tmp_path: Path, damage, suffix: str, request: pytest.FixtureRequest
) -> None:
    draw = random.Random(11)
    content = (
        PAGE if suffix != ".ipynb" else json.dumps({"cells": [{"cell_type": "markdown", "source": PAGE}]})
    )
    for _ in range(300 if request.config.getoption("--slow") else 3):
        try:
            _read(tmp_path, damage(draw, content.encode()), f"p{suffix}")
            load_paper(tmp_path / f"p{suffix}")
        except PaperError as error:
            assert len(error.message) < 300 and error.message.isprintable()


@pytest.mark.slow
@pytest.mark.skipif("WORKBENCH_TEXTS" not in os.environ, reason="WORKBENCH_TEXTS names no folder of texts")
def test_a_folder_of_public_texts() -> None:
    """No exception, no hang, every token in its place, over all texts in the folder."""
    from workbench.source.rows.chains import steps_of

    count = 0
    for path in sorted(Path(os.environ["WORKBENCH_TEXTS"]).rglob("*")):
        if path.suffix.lower() not in SUFFIXES or not path.is_file():
            continue
        start = time.process_time()
        text = read_text(path)
        size = sum(len(source.text) for source in text.sources)
        assert time.process_time() - start < 5 * max(1, size / 100_000), path
        count += 1
        for display in text.displays:
            steps_of(display)
            for token in display.tokens:
                shown = token.source.text[token.start : token.end]
                assert token.call is None or shown.startswith("\\") or len(shown) == 1, (path, token)
    assert count >= 500
