"""What stands in Markdown and LaTeX: escaped, balanced, and set by pdflatex where there is one."""

import re
import shutil
import subprocess

import pytest

from workbench.report import ReportError, tex


def test_nothing_from_the_input_becomes_markup(nasty):
    assert nasty["report.html"].count("<script>") == 1
    assert "<script>" not in nasty["report.md"].replace(r"\<script\>", "").replace("`", "")[:400]
    outside_math = nasty["erratum.tex"].split(r"\begin{document}")[1]
    assert r"\input" not in outside_math
    assert outside_math.count(r"\end{document}") == 1


def test_markdown_escapes_headings_and_text(nasty):
    heading = nasty["report.md"].splitlines()[0]
    assert heading.startswith(r"# \<script\>alert\(1\)\</script\> \& ")
    assert r"\$x\_1\$" in heading


def test_markdown_shows_what_it_cannot_typeset_as_source(nasty):
    assert "\n$$\n" not in nasty["report.md"]
    assert r"`a\\&b`" in nasty["report.md"]


def test_markdown_mathematics_is_one_line_between_dollars(texts):
    blocks = re.findall(r"^\$\$\n(.*?)\n\$\$$", texts["report.md"], re.DOTALL | re.MULTILINE)
    assert len(blocks) > 20
    assert not [block for block in blocks if "\n" in block or "$" in block]


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
    assert tex.escaped(plain) == latex


@pytest.mark.parametrize("character", ["漢", "ſ", "\ue001"])
def test_what_latex_cannot_set_is_an_error(character):
    with pytest.raises(ReportError, match=f"U\\+{ord(character):04X}"):
        tex.escaped(f"a {character}")


@pytest.mark.parametrize("name", ["texts", "nasty"])
def test_erratum_note_is_balanced(name, request):
    tex = request.getfixturevalue(name)["erratum.tex"]
    bare = re.sub(r"\\[\\{}%$&#_]", "", tex)
    depth = 0
    for character in bare:
        depth += (character == "{") - (character == "}")
        assert depth >= 0
    assert depth == 0
    assert "$" not in bare
    assert bare.count(r"\(") == bare.count(r"\)")
    environments = re.findall(r"\\(begin|end)\{(\w+\*?)\}", tex)
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
