"""What texts that nobody here had seen write in ways of their own: how it is read, and what is not held against
them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.marked_texts import MarkedText, marked_texts
from tests.texts.written import doubts, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Outcome
from workbench.papers.load import load_paper
from workbench.source.documents import read_text
from workbench.source.rows.chains import steps_of


def test_an_empty_line_parts_the_equations_of_a_directive(tmp_path: Path) -> None:
    path = tmp_path / "p.rst"
    path.write_text(
        "Text\n\n.. math::\n   :label: x\n\n   a = b\n\n   c = d\n\n   \\begin{aligned}\n\n   e = f\n   \\end{aligned}\n"
    )
    (display,) = read_text(path).displays
    latex = [" ".join(step.spelled()[0].split()) for line in steps_of(display) for step in line]
    assert latex[:2] == ["a = b", "c = d"] and len(latex) == 3


@pytest.mark.parametrize("fences", [("$$", "$$"), (":::{math}\n:label: x", ":::"), ("```math", "```")])
def test_an_empty_line_parts_them_in_markdown_too(tmp_path: Path, fences: tuple[str, str]) -> None:
    """They were one chain, a = b c = d."""
    path = tmp_path / "p.md"
    path.write_text(
        f"{fences[0]}\n\na = b\n\nc = d\n\n+ e\n\n\\begin{{cases}} f\n\n= g \\end{{cases}}\n\n{fences[1]}\n"
    )
    (display,) = read_text(path).displays
    latex = ["".join(step.spelled()[0].split()) for line in steps_of(display) for step in line]
    assert latex[:2] == ["a=b", "c=d+e"] and len(latex) == 3


def test_sphinx_takes_a_label_from_below_the_formula(tmp_path: Path) -> None:
    path = tmp_path / "p.rst"
    path.write_text("Text\n\n.. math::\n   a = b\n   :label: eq:x\n\nMore.\n")
    (display,) = read_text(path).displays
    assert display.latex.strip() == "a = b" and list(display.labels) == ["eq:x"]


def test_doxygen_has_delimiters_of_its_own(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(
        "\\f$ \\newcommand{\\R}[1]{R_{#1}} \\f$\n\nText with \\f$a = 1\\f$ in it.\n\n"
        "\\f[ \\R{a} = b \\f]\n\n@f[ c = d @f]\n\n\\f$ e = f \\f$\n"
    )
    latex = ["".join(display.latex.split()) for display in read_text(path).displays]
    assert latex == ["R_{a}=b", "c=d", "e=f"]


def test_an_eqnarray_row_without_a_sign_is_a_continuation(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    rows = r"x &=& a + b\\ && + c + d\\ &=& e\\ && - f"
    path.write_text(f"\\begin{{document}}\\begin{{eqnarray*}}{rows}\\end{{eqnarray*}}\\end{{document}}")
    ((one, other),) = steps_of(read_text(path).displays[0])
    said = [each.spelled()[0].replace(" ", "") for each in (one, other)]
    assert said == ["x=a+b+c+d", "a+b+c+d=e-f"]


def test_trivial_steps_break_no_chain(
    tmp_path: Path,
) -> None:
    (tmp_path / "p.md").write_text(
        "$$ n n^T = n n^T $$\n\n"
        r"$$ \tilde{n}\tilde{n}\tilde{n} = -\tilde{n} $$"
        "\n\n"
        r"$$ \tilde{n}\tilde{n}\tilde{n} = \tilde{n} $$"
    )
    (tmp_path / "p.toml").write_text('source = "p.md"\n[symbols]\n\'n\' = { kind = "vector" }\n')
    trivial, of_a_unit, false = judge_paper(load_paper(tmp_path / "p.toml"))
    assert trivial.passed and trivial.verdict.outcome is Outcome.UNCHECKED
    assert told(of_a_unit.verdict) == "doubtful" and "n: unit" in doubts(of_a_unit.verdict)
    assert false.verdict.outcome is Outcome.REFUTED and not false.passed


MODEL = 'source = "p.md"\n[symbols]\n' + "".join(
    f"'{name}' = {{ kind = \"{kind}\" }}\n"
    for name, kind in {
        r"\mathbf{r}": "vector", r"\mathbf{s}": "vector", "r_1": "scalar", "r_2": "scalar", "r_3": "scalar",
        r"\mathbf{p}_i": "vector", r"\alpha": "scalar", "x": "scalar", "y": "scalar", "z": "scalar",
    }.items()
)  # fmt: skip


@pytest.mark.parametrize("text", list(marked_texts("other_statements")), ids=lambda text: text.name)
def test_declared_free_symbols_ignore_the_text(tmp_path: Path, text: MarkedText) -> None:
    model = text.model.replace('" }', '", free = true }')
    assert told(verdicts(tmp_path, text.text, model)[-1]) == "refuted"


SPINNING = {r"\mathbf{r}": "vector", r"\mathbf{s}": "vector", "x": "scalar"}
SAID = [r"where $\mathbf{s} = \int \mathbf{r}$.", r"$$\mathbf{s} = \int \mathbf{r}$$"]


@pytest.mark.parametrize("said", SAID)
@pytest.mark.parametrize("skip", [False, True])
@pytest.mark.parametrize(
    ("latex", "free"),
    [
        (r"x \mathbf{s} \cdot \mathbf{s} = x \mathbf{s} \cdot \mathbf{r}", Outcome.REFUTED),
        (r"\mathbf{s} = \mathbf{r} \times \mathbf{s}", Outcome.REFUTED),
        (r"\dot{\mathbf{s}} = \mathbf{r}", Outcome.REFUTED),  # no law for what may be anything
        (r"\tilde{\mathbf{s}}^3 = -\tilde{\mathbf{s}}", Outcome.REFUTED),  # nor a unit vector
        (r"\mathbf{s} \times \mathbf{r} = -\mathbf{r} \times \mathbf{s}", Outcome.PROVED),
    ],
)
def test_statements_of_sentences_stay_open_until_declared_free(
    tmp_path: Path, said: str, skip: bool, latex: str, free: Outcome
) -> None:
    (tmp_path / "p.md").write_text(f"{said}\n\n$$ {latex} $$\n")
    left_out = "[[claim]]\nat = 'line 1'\nskip = 'a definition'\n" * (skip and said.startswith("$$"))
    for flag, open_ in (("", True), (", free = true", False)):
        symbols = "".join(f"'{name}' = {{ kind = '{kind}'{flag} }}\n" for name, kind in SPINNING.items())
        (tmp_path / "p.toml").write_text(f"source = 'p.md'\n[symbols]\n{symbols}{left_out}")
        verdict = judge_paper(load_paper(tmp_path / "p.toml"))[-1].verdict
        if free is Outcome.PROVED or not open_:
            assert verdict.outcome is free and verdict.grade in ("ok", "error")
        else:
            assert told(verdict) in ("said", "doubtful"), doubts(verdict)


def test_a_symbol_that_is_defined_is_not_free(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$x = y$$")
    head = "source = 'p.md'\n[symbols]\n'y' = 'scalar'\n"
    (tmp_path / "p.toml").write_text(
        head + "'x' = { kind = 'scalar', free = true }\n[definitions]\n'x' = '2 y'\n"
    )
    with pytest.raises(PaperError, match="declared as free, which a definition need not keep"):
        load_paper(tmp_path / "p.toml")


@pytest.mark.parametrize(("said", "passes"), [("", True), ("corrected = 'x = y'\n", False)])
def test_a_trivial_step_passes_only_without_an_expectation(tmp_path: Path, said: str, passes: bool) -> None:
    (tmp_path / "p.md").write_text("$$x = x$$ (one)\n")
    (tmp_path / "p.toml").write_text(
        MODEL.replace("\n", "\ntitle = 'p'\n", 1) + f"[[claim]]\nat = 'one'\n{said}"
    )
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert (not result.why_not) is passes


COLUMNS = 'source = "p.md"\n[symbols]\n' + "".join(
    f"'{name}' = \"{kind}\"\n"
    for name, kind in {
        "a": "vector", "b": "vector", "x": "matrix 6×1", "y": "matrix 5×1", "V": "matrix 6×1", "T": "transform",
        "R": "rotation", "f": "scalar",
    }.items()
)  # fmt: skip


def test_the_column_of_a_point_says_what_the_point_is(tmp_path: Path) -> None:
    """p is a place in one formula and in another one that of another origin."""
    formulas = (r"a = R b", r"\begin{bmatrix} a \\ 1 \end{bmatrix} = T \begin{bmatrix} b \\ 1 \end{bmatrix}")
    (tmp_path / "p.md").write_text("\n\n".join(f"$$ {each} $$" for each in formulas))
    (tmp_path / "p.toml").write_text(COLUMNS)
    said = judge_paper(load_paper(tmp_path / "p.toml"))
    assert [told(each.verdict) for each in said] == ["said", "said"]


def test_formulas_that_another_one_is_to_follow_from(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text(
        "$$ \\dot{a} = f b $$\n\n$$ \\dot{a} + b = f b + b $$\n\n"
        "$$ f f b \\cdot b = 2 \\dot{a} \\cdot \\dot{a} $$\n\n$$ \\dot{b} = f a $$"
    )
    model = COLUMNS + "[[claim]]\nat = {}\ngiven = {}\n"
    (tmp_path / "p.toml").write_text(model.format('["L3", "L5"]', '["L1"]'))
    law, follows, false, other = judge_paper(load_paper(tmp_path / "p.toml"))
    assert told(law.verdict) == told(other.verdict) == "said"
    assert follows.verdict.outcome is Outcome.PROVED
    assert false.verdict.outcome is Outcome.REFUTED
    for at, given in (('"L1"', '["L3"]'), ('"L3"', '["L3"]'), ('"L3"', '["L9"]')):
        (tmp_path / "p.toml").write_text(model.format(at, given))
        (fault,) = load_paper(tmp_path / "p.toml").faults
        assert "given: no formula" in str(fault)
