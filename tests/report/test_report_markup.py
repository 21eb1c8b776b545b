"""What stands in Markdown and LaTeX: escaped, balanced, and set by pdflatex where there is one."""

import re
import shutil
import subprocess
import zlib

import pytest
from sample_report import sample

from workbench.report import ReportError, markdown_text
from workbench.report.erratum import erratum_note
from workbench.report.mixed_prose import formula, text
from workbench.report.render import write_report


def test_nothing_from_the_input_becomes_markup(nasty):
    assert nasty["report.html"].count("<script>") == 1
    outside_code = re.sub(r"(`+).*?\1", "", nasty["report.md"])
    assert "<script>" not in outside_code.replace(r"\<script>", "")
    outside_math = nasty["erratum.tex"].split(r"\begin{document}")[1]
    assert r"\input" not in outside_math
    assert outside_math.count(r"\end{document}") == 1


def test_markdown_escapes_headings_and_text(nasty):
    heading = nasty["report.md"].splitlines()[0]
    assert heading.startswith(r"# \<script>alert(1)\</script> & ")
    assert "$x_1$" in heading and r"\*b\*" in heading


@pytest.mark.parametrize(
    "plain",
    [
        "(70), third line: for n - 1, 24 % of a_b.",
        "2 * 3 < 4 & 5 > 1!",
        "e.g. 10⁻¹⁴ (two cylindrical joints)",
        "x ~ y",
    ],
)
def test_markdown_escapes_nothing_without_need(plain):
    assert markdown_text.escaped(plain) == plain


@pytest.mark.parametrize("plain", ["# a", "- a", "1. a", "+ a", "> a"])
def test_markdown_escapes_what_begins_a_block(plain):
    assert markdown_text.escaped(plain).replace("\\", "") == plain != markdown_text.escaped(plain)


def test_bar_in_a_cell_of_a_table_ends_no_cell():
    assert "|" not in markdown_text.cell([formula("|a|"), text(" ")])


def test_markdown_shows_what_it_cannot_typeset_as_source(nasty):
    assert r"`a\\&b`" in nasty["report.md"]


def test_markdown_mathematics_is_one_line_between_dollars(texts):
    outside = re.sub(r"\\\$", "", texts["report.md"])
    assert all(line.count("$") % 2 == 0 for line in outside.splitlines())
    assert outside.count("$") > 40


@pytest.mark.parametrize(
    ("plain", "latex"),
    [
        ("Φ₄ = ω²", r"\ensuremath{\Phi}\textsubscript{4} = \ensuremath{\omega}\textsuperscript{2}"),
        ("ω̃̇x", r"\ensuremath{\dot{\tilde{\omega}}}x"),
        ("A_ρ", r"A\textsubscript{\ensuremath{\rho}}"),
        ("ω̈ v̇", r"\ensuremath{\ddot{\omega}} \ensuremath{\dot{v}}"),
        ("a_bc & 5%", r"a\_bc \& 5\%"),
        ("\\input{x}", r"\textbackslash{}input\{x\}"),
        ("éçł –", "éçł --"),
        ("ℝ ⊗", r"{R} \ensuremath{\otimes}"),
    ],
)
def test_text_of_the_erratum_note(plain, latex):
    assert erratum_note.escaped(plain) == latex


@pytest.mark.parametrize("character", ["漢", "ſ", "\ue001"])
def test_characters_that_latex_cannot_typeset_are_errors(character):
    with pytest.raises(ReportError, match=f"U\\+{ord(character):04X}"):
        erratum_note.escaped(f"a {character}")


@pytest.mark.parametrize("name", ["texts", "nasty"])
def test_erratum_note_is_balanced(name, request):
    erratum_note = request.getfixturevalue(name)["erratum.tex"]
    bare = re.sub(r"\\[\\{}%$&#_]", "", erratum_note)
    depth = 0
    for character in bare:
        depth += (character == "{") - (character == "}")
        assert depth >= 0
    assert depth == 0
    assert "$" not in bare
    assert bare.count(r"\(") == bare.count(r"\)")
    environments = re.findall(r"\\(begin|end)\{(\w+\*?)\}", erratum_note)
    stack = []
    for kind, environment in environments:
        if kind == "begin":
            stack.append(environment)
        else:
            assert stack.pop() == environment
    assert stack == []


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
@pytest.mark.parametrize("name", ["texts", "nasty"])
def test_erratum_note_compiles(name, request, tmp_path):
    (tmp_path / "erratum.tex").write_text(request.getfixturevalue(name)["erratum.tex"], "utf-8")
    run = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "erratum.tex"],
        cwd=tmp_path, capture_output=True, timeout=60,
    )  # fmt: skip
    log = run.stdout.decode("utf-8", "replace")
    assert run.returncode == 0, log[-2000:]
    assert name == "nasty" or "Overfull" not in log
    assert (tmp_path / "erratum.pdf").stat().st_size > 10_000


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_pdf_has_title_author_and_links(tmp_path):
    paper, results = sample(authors="A. Author")
    written = write_report(paper, results, tmp_path, has_pdf=True)
    assert tmp_path / "erratum.pdf" in written
    streams = re.findall(rb"stream\r?\n(.*?)endstream", (tmp_path / "erratum.pdf").read_bytes(), re.DOTALL)
    inflated = [zlib.decompressobj().decompress(each) for each in streams if each[:1] == b"x"]
    pdf = b"".join([*inflated, (tmp_path / "erratum.pdf").read_bytes()])
    assert all(key in pdf for key in (b"/Title", b"/Author", b"/URI(https://doi.org/", b"/Outlines"))
    assert '<a href="erratum.pdf">' in (tmp_path / "report.html").read_text("utf-8")
    note = (tmp_path / "erratum.tex").read_text("utf-8")
    asked, given = (set(re.findall(rf"\\{name}{{([^}}]+)}}", note)) for name in ("hyperlink", "hypertarget"))
    assert asked and asked <= given
    assert tmp_path / "erratum.pdf" not in write_report(paper, results, tmp_path)
    assert not (tmp_path / "erratum.pdf").exists()  # it would be the list of other results


def test_pdf_without_latex_is_one_error(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(ReportError, match="the PDF needs pdflatex, which is not installed"):
        write_report(*sample(), tmp_path / "out", has_pdf=True)
    assert not (tmp_path / "out").exists()
