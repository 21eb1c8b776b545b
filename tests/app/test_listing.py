"""What `workbench check` tells of a text, the author's lines it corrects, and one formula on the command line."""

from __future__ import annotations

from difflib import SequenceMatcher
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from hypothesis import given
from hypothesis import strategies as st

from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.app.pipeline.result_proposals import with_proposals
from workbench.papers import load_paper
from workbench.repair.author_edits import author_edits
from workbench.source.documents.source_edits import SourceEdit, applied
from workbench.source.rewriting.pasted_formulas import as_typed
from workbench.source.typeset.plain_text import in_plain_text, plain_text

PREAMBLE = r"""%! workbench: symbols.'a' = { kind = "vector" }
%! workbench: symbols.'b' = { kind = "vector" }
%! workbench: symbols.'c' = { kind = "vector" }
%! workbench: symbols.'s' = { kind = "scalar" }
%! workbench: symbols.'R' = { kind = "rotation" }
\newcommand{\va}{a}\newcommand{\cross}{\times}\newcommand{\tp}{^{\top}}
\begin{document}
"""
#: (what is printed and false, the author's own right form): sign, factor, order, transpose, symbol, dot.
WRONG = [
    (r"\va \cross b = b \cross \va", r"\va \cross b = -b \cross \va"),
    (r"(\va + b) \cross (\va - b) = - \va \cross b", r"(\va + b) \cross (\va - b) = - 2\va \cross b"),
    (r"\va \cross (b \cross c) = (\va \cdot c)\, b + (\va \cdot b)\, c", r"\va \cross (b \cross c) = (\va \cdot c)\, b - (\va \cdot b)\, c"),
    (r"R R\tp \va = R \va", r"R R\tp \va = \va"),
    (r"\va \cdot (\va \cross b) = s", None),
]  # fmt: skip


def text(tmp_path: Path, *displays: str) -> Path:
    path = tmp_path / "paper.tex"
    body = "\n".join(f"\\begin{{equation}}\n  {display}\n\\end{{equation}}" for display in displays)
    path.write_text(f"{PREAMBLE}{body}\n\\end{{document}}\n", encoding="utf-8")
    return path


def run(*arguments: str, stdin: str | None = None) -> Result:
    return CliRunner().invoke(main, [str(each) for each in arguments], input=stdin)


@pytest.mark.parametrize(("printed", "right"), WRONG[:4])
def test_edits_of_the_author_give_a_proved_text(tmp_path: Path, printed: str, right: str) -> None:
    path = text(tmp_path, printed)
    paper = load_paper(path, faults=[])
    (result,) = with_proposals(judge_paper(paper, (), motions=False))
    assert result.proposed
    edits, edited = author_edits(result.claim, paper.text, result.proposed[0])
    assert edits and edited, result.proposed[0]
    before, after = ("".join(latex.split()) for latex in (result.claim.printed.latex, edited))
    steps = SequenceMatcher(None, before, after, autojunk=False).get_opcodes()
    changed = sum(b - a + d - c for tag, a, b, c, d in steps if tag != "equal")
    assert changed == sum(len("".join((each.old + each.new).split())) for each in edits), edited
    path.write_text(applied(path.read_text(encoding="utf-8"), edits), encoding="utf-8")
    (again,) = judge_paper(load_paper(path, faults=[]), (), motions=False)
    assert again.verdict.outcome == "proved", path.read_text(encoding="utf-8")
    assert r"\va" in path.read_text(encoding="utf-8").split(r"\begin{document}")[1]


@given(st.text("abc", min_size=8, max_size=12), st.data())
def test_edits_apart_are_made_independently(source: str, data: st.DataObject) -> None:
    cut = data.draw(st.integers(2, 6))
    first = SourceEdit(None, None, 0, 1, source[0], "X")  # type: ignore[arg-type]
    second = SourceEdit(None, None, cut, cut + 1, source[cut], "")  # type: ignore[arg-type]
    expected = "X" + source[1:cut] + source[cut + 1 :]
    assert applied(source, [first, second]) == applied(source, [second, first]) == expected


def test_listing_tells_errors_with_lines_and_counts(tmp_path: Path) -> None:
    path = text(tmp_path, WRONG[0][0], r"\va \cross \va = 0")
    result = run("check", path, "--no-motions")
    assert result.exit_code == 1
    lines = result.output.splitlines()
    assert lines[0] == f"{path}: 1 error, 1 holds"
    assert lines[2] == "✗ (1), line 9: change the sign of b × a"
    assert lines[3:5] == [r"    - \va \cross b = b \cross \va", r"    + \va \cross b = -b \cross \va"]
    assert lines[-1] == "  The corrected formula is proved."
    assert run("check", path, "-q", "--no-motions").output.splitlines() == [lines[2]]
    assert "\nDisplays\n  ✗ (1)  error" in run("check", path, "-v", "--no-motions").output


def test_fix_asks_and_diff_prints(tmp_path: Path) -> None:
    path = text(tmp_path, WRONG[0][0])
    before = path.read_bytes()
    diff = run("check", path, "--diff", "--no-motions").output
    assert "-  \\va \\cross b = b \\cross \\va\n+  \\va \\cross b = -b \\cross \\va\n" in diff
    refused = run("check", path, "--fix", "--no-motions", stdin="n\n")
    assert path.read_bytes() == before and "Make 1 correction?" in refused.output
    some = before.replace(b"\n", b"\r\n", 5)  # a file with both ends of lines
    path.write_bytes(some)
    made = run("check", path, "--fix", "--no-motions", stdin="y\n")
    assert made.exit_code == 0 and "no error found; 1 holds" in made.output
    assert path.read_bytes() == some.replace(b"= b", b"= -b")


def test_fix_needs_utf8_and_text_output(tmp_path: Path) -> None:
    path = text(tmp_path, WRONG[0][0])
    path.write_bytes(path.read_bytes() + b"% \xe9\n")
    found = run("check", path, "--fix", "--no-motions", stdin="y\n")
    assert found.exit_code == 2 and "is not UTF-8" in found.output
    assert run("check", path, "--fix", "--format", "json").exit_code == 2


def test_standard_input_is_a_text(tmp_path: Path) -> None:
    body = text(tmp_path, WRONG[0][0]).read_text(encoding="utf-8")
    found = run("check", "-", "--no-motions", stdin=body)
    assert found.exit_code == 1 and "✗ (1), line 9" in found.output
    assert run("check", "-", "--fix", stdin=body).exit_code == 2


@pytest.mark.parametrize(
    ("latex", "shown"),
    [
        (r"\boldsymbol{\omega}_{B / A} \times \boldsymbol{v}_{r e l}", "ω_B/A × v_rel"),
        (r"-l_{2} \cos\left(\theta_{1} + \theta_{2}\right)", "−l_2 cos(θ_1 + θ_2)"),
        (r"\ddot{\boldsymbol{r}}^{T} \mathbf{R}^{-1}", "r̈ᵀ R⁻¹"),
        (r"\frac{\theta - \sin \theta}{\theta} \mathbf{a}", "(θ − sin θ)/θ a"),
        (r"\begin{bmatrix} a & b \\ c & d \end{bmatrix}", "[a, b; c, d]"),
        (r"\unknowncommand{x}", r"\unknowncommand{x}"),
    ],
)
def test_plain_text_of_a_formula(latex: str, shown: str) -> None:
    assert plain_text(latex) == shown
    assert in_plain_text(f"remove ${latex}$ here") == f"remove {shown} here"


@pytest.mark.parametrize(
    ("typed", "latex"),
    [
        ("$a = b$", "a = b"),
        ("$$ a = b, $$", "a = b"),
        (r"\begin{equation} a = b \label{eq:1} \end{equation}", "a = b"),
        ("a × b = −b × a", r"a \times  b = -b \times  a"),
        ("a \times b = \frac{1}{2} \beta", r"a \times b = \frac{1}{2} \beta"),
    ],
)
def test_formula_as_typed_is_understood(typed: str, latex: str) -> None:
    assert as_typed(typed)[0] == latex


def test_try_judges_one_formula() -> None:
    found = run("try", "a × b = b × a", "-s", "a=vector", "-s", "b=vector")
    assert found.exit_code == 1 and found.output.startswith("✗ does not hold; change the sign of b × a\n")
    assert run("try", r"\mathbf{a} \times \mathbf{a} = 0").exit_code == 0
    assert run("try", "a = ", "-s", "a=vector").exit_code == 2
    assert run("try", r"[k]_\times^2 = k k^T - \norm{k}^2 I").exit_code == 0
    assert run("try", "a = b", "-s", "a=vector", "-s", "b=vector").exit_code == 1
    dotted = run("try", r"a \cdot b = b \cdot a", "-s", "a=vector")
    assert "b vector" in dotted.output and dotted.exit_code == 0
    assert run("try", r"\sin(\pi - \theta) = \sin\theta").output.endswith(
        "Taken as: θ scalar. Another kind: -s NAME=KIND.\n"
    )
    bad = run("try", "a = a", "-s", "a=vctor")
    assert bad.exit_code == 2 and "kind is 'vctor'" in bad.output
    bad = run("try", "a = a", "-s", "vector")
    assert bad.exit_code == 2 and "expected NAME=KIND" in bad.output
