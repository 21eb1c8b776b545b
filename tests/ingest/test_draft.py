"""A text without a model is judged under a draft; what rests on drafted kinds is a warning at most."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.drafts import draft_of
from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting.draft_model import ingest
from workbench.papers.drafting.drafted_texts import undeclared_text
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.papers.drafting.model_file import loaded_model
from workbench.papers.drafting.typefaces import Guess
from workbench.prover.results.claim_results import ClaimResult

WRONG = r"""The vectors $\mathbf{a}$, $\mathbf{b}$ and $\mathbf{c}$:
$$ \mathbf{a} \times (\mathbf{b} \times \mathbf{c}) = (\mathbf{a} \cdot \mathbf{c}) \mathbf{b} + (\mathbf{a} \cdot \mathbf{b}) \mathbf{c} $$
$$ \mathbf{a} \times \mathbf{b} = -\mathbf{b} \times \mathbf{a} $$
"""


def judged(path: Path) -> list[ClaimResult]:
    draft = draft_of(path)
    return on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))


def test_a_falsehood_on_drafted_kinds_is_a_warning(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(WRONG)
    wrong, right = judged(path)
    assert (wrong.verdict.outcome, wrong.shown) == (Outcome.REFUTED, Grade.WARNING)
    assert (right.verdict.outcome, right.shown) == (Outcome.PROVED, Grade.OK)


def test_check_says_in_one_line_that_it_drafted(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(WRONG)
    result = CliRunner().invoke(main, ["check", str(path), "--no-proposals", "--no-motions", "--no-cache"])
    first, *rest = result.output.splitlines()
    assert first.startswith("drafted a model of p.md (3 symbols") and result.exit_code == 0
    assert not (tmp_path / "p.toml").exists() and any("warning" in line for line in rest)


def test_a_kind_that_only_one_formula_needs_does_not_judge_it(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("$$ 2 a + a = 3 a $$\n\n$$ \\mathbf{f} \\times a = 2 \\mathbf{f} \\times a $$\n")
    *_, last = judged(path)
    assert last.verdict.outcome is Outcome.UNCHECKED
    assert "which only this formula needs" in str(last.verdict.reason)


def test_texts_with_a_model_or_comments_need_no_draft(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    path.write_text("\\[ a = b \\]\n")
    assert undeclared_text(path)
    path.write_text("%! workbench: symbols.a = 'scalar'\n\\[ a = b \\]\n")
    assert undeclared_text(path) is None
    (tmp_path / "p.toml").write_text('source = "p.tex"\n')
    assert undeclared_text(path) is None


def test_a_guess_that_no_model_can_hold_is_left_out(tmp_path: Path) -> None:
    """Two members of one family were declared, so that the model of the text did not load."""
    path = tmp_path / "chain.md"
    path.write_text("$$m = 2 k$$\n")
    drafted = ingest(path)
    members = {name: Guess(name, "scalar") for name in (r"\eta_{n+1}", r"\eta_{n-1}")}
    text, model, _ = loaded_model(
        replace(drafted, guesses=drafted.guesses | members), path.with_suffix(".toml"), False
    )
    assert not model.faults and text.count("refused: ") == 1 and text.count("\n'm' = ") == 1


def test_a_size_below_a_unit_tensor_is_at_least_2(tmp_path: Path) -> None:
    path = tmp_path / "energy.md"
    path.write_text("$$ \\frac{1}{2} m v^2 + m g z = E_0 $$\n\n$$ v_1 = \\sqrt{2 E_1 / m} $$\n")
    assert all(result.verdict.outcome is not Outcome.ILL_FORMED for result in judged(path))


OTHER_KINDS = {
    "another size": r"""$$ \mathbf{R} \mathbf{a} = \mathbf{b} \times \mathbf{c} $$

$$ \mathbf{b} = \mathbf{R} \mathbf{c} + \mathbf{a} $$

$$ \mathbf{R} = \begin{bmatrix} \cos s & -\sin s \\ \sin s & \cos s \end{bmatrix} $$
""",
    "one notation that is misread twice": r"""$$ \mathbf{c} = s \mathbf{a} + \mathbf{b} $$

$$ s = \mathbf{a} \cdot \mathbf{b} $$

$$ \mathbf{c} = \mathbf{a} \times s + \mathbf{b} $$

$$ \mathbf{b} = \mathbf{a} \times s $$
""",
    "a law": r"""$$ E = v^2 + v $$

$$ \frac{d E}{d t} = 0 $$
""",
}


@pytest.mark.parametrize("text", OTHER_KINDS.values(), ids=OTHER_KINDS)
def test_what_may_be_meant_with_other_kinds_is_no_warning(tmp_path: Path, text: str) -> None:
    path = tmp_path / "p.md"
    path.write_text(text)
    assert {result.shown for result in judged(path)}.isdisjoint({Grade.WARNING, Grade.ERROR})


FALSE_OF_ALL_KINDS = {
    "a kind that another formula supports": "$$ \\mathbf{a} \\cdot \\mathbf{b} = s + 1 $$\n\n"
    "$$ \\mathbf{c} = s \\mathbf{a} + \\mathbf{b} $$\n\n$$ \\mathbf{c} = s + \\mathbf{b} $$\n",
    "an impossible condition": "$$ \\mathbf{c} = \\mathbf{a} \\times \\mathbf{b} $$\n\n"
    "$$ \\mathbf{a} \\cdot (\\mathbf{a} \\times \\mathbf{b}) = 1 $$\n",
}


@pytest.mark.parametrize("text", FALSE_OF_ALL_KINDS.values(), ids=FALSE_OF_ALL_KINDS)
def test_what_no_likely_kinds_make_true_is_a_warning(tmp_path: Path, text: str) -> None:
    path = tmp_path / "p.md"
    path.write_text(text)
    assert [result.shown for result in judged(path)].count(Grade.WARNING) == 1


def test_entries_of_another_case_do_not_warn(tmp_path: Path) -> None:
    """A letter that two displays give matrices of different extents is two letters."""
    path = tmp_path / "p.md"
    entries = (
        r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \end{bmatrix}",
        r"\begin{bmatrix} 1 \\ 0 \end{bmatrix}",
    )
    path.write_text("".join(f"Here\n$$ H = {each} $$\n" for each in entries))
    assert not any(result.shown in (Grade.WARNING, Grade.ERROR) for result in judged(path))


def test_definitions_in_a_circle_end(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    formulas = (
        r"\dot{\omega} = G V - G^2 \omega",
        r"V = IR + \frac{\omega}{K}",
        r"I = -\frac{1}{K R} \omega + \frac{1}{R} V",
        r"V = K (g - \omega)",
        r"I = 3 V + g",
        r"\dot{\omega} = G V - G^2 \omega",
    )
    path.write_text("\n".join(f"$$ {each} $$\n" for each in formulas))
    assert len(judged(path)) == 6


def test_draft_prints_the_model_to_standard_output(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(WRONG)
    result = CliRunner().invoke(main, ["draft", str(path), "--out", "-"])
    assert result.exit_code == 0 and "[symbols]" in result.output and "symbols guessed" not in result.output
    assert not (tmp_path / "p.toml").exists() and not Path("-").exists()


def test_argument_inside_an_argument_is_read(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(
        "The rotation about the axis $n$ is $R_n$.\n"
        r"$$ \mathbf{x}(t) = R_n(\alpha(t)) \mathbf{x}_0 $$"
        "\n"
        r"$$ R_n(\alpha(t)) R_n(\alpha(t))^T = I $$"
        "\n"
        r"$$ R_n(\alpha(t)) R_n(\beta(t)) = R_n(\alpha(t) + \beta(t)) $$"
        "\n"
    )
    _, orthogonal, other = judged(path)
    assert orthogonal.verdict.outcome is Outcome.PROVED
    assert other.verdict.outcome is Outcome.UNCHECKED
