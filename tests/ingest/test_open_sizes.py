"""What a draft decides does not depend on a size that the text does not give, or on what it gives anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judged_files import judged_file
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.verdict import Grade, Outcome
from workbench.prover.results.claim_results import ClaimResult

JOINTS = r"""The joint coordinates $q$ of the manipulator have the skew-symmetric matrices $A$ and $B$.

$$ M(q) \ddot{q} + A \dot{q} + B \dot{q} = \tau $$

"""


def results(folder: Path, text: str) -> list[ClaimResult]:
    path = folder / "p.md"
    path.write_text(text)
    return judged_file(path).results


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"A B = B A", Outcome.UNCHECKED),
        (r"(A B)^T = B^T A^T", Outcome.PROVED),
    ],
)
def test_a_claim_on_n_rows_is_decided_if_all_sizes_agree(
    tmp_path: Path, latex: str, outcome: Outcome
) -> None:
    verdict = results(tmp_path, f"{JOINTS}$$ {latex} $$\n")[-1].verdict
    assert verdict.outcome is outcome
    assert (verdict.code is VerdictCode.OF_ONE_SIZE) == (outcome is Outcome.UNCHECKED)


RECURRENCE = r"""The position vectors $\mathbf{r}_n$ at the time steps:

$$ \dot{\mathbf{r}}_n = \dot{\mathbf{r}}_{n-1} + \frac{\ddot{\mathbf{r}}_{n-1} + \ddot{\mathbf{r}}_n}{2} \Delta t $$
"""
EXAMPLES = r"""# One
The transformation matrix:

$$ T = \begin{bmatrix} 1 & 0 & 0 & x \\ 0 & 1 & 0 & y \\ 0 & 0 & 1 & z \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

# Two
The transformation matrix:

$$ T = \begin{bmatrix} 0 & -1 & 0 & 2 \\ 1 & 0 & 0 & 3 \\ 0 & 0 & 1 & 4 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ T^{-1} = \begin{bmatrix} 0 & 1 & 0 & -3 \\ -1 & 0 & 0 & 2 \\ 0 & 0 & 1 & -4 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""
CASES = r"""The vector $\mathbf{z}$. For a revolute joint:

$$ \mathbf{J} = \begin{bmatrix} \mathbf{z} \\ 2 \mathbf{z} \end{bmatrix} $$

For a prismatic joint:

$$ \mathbf{J} = \begin{bmatrix} \mathbf{z} \\ \mathbf{0} \end{bmatrix} $$
"""


@pytest.mark.parametrize("text", [RECURRENCE, EXAMPLES, CASES], ids=["recurrence", "examples", "cases"])
def test_what_a_text_gives_anew_is_no_warning(tmp_path: Path, text: str) -> None:
    assert not {each.shown for each in results(tmp_path, text)} & {Grade.ERROR, Grade.WARNING}
    falsehood = (
        text + "\nFor all vectors $\\mathbf{a}$:\n\n$$ \\mathbf{a} \\times \\mathbf{a} = \\mathbf{a} $$\n"
    )
    assert results(tmp_path, falsehood)[-1].shown is Grade.WARNING


TURNS = r"""The rotation matrix $R$ turns the vector $\mathbf{a}$ into the vector $\mathbf{b}$.

$$ \mathbf{b} = R \mathbf{a} $$

$$ R^T R = I $$

"""


@pytest.mark.parametrize(
    ("latex", "shown"),
    [
        (r"\operatorname{Ad}_{T} \mathbf{a} + R = R \mathbf{a}", Grade.WARNING),
        (r"\operatorname{vech}(R) + \mathbf{a} = R", Grade.NOT_JUDGED),
    ],
)
def test_misfit_of_an_unknown_word_is_no_warning(tmp_path: Path, latex: str, shown: Grade) -> None:
    """The word Ad is known: it is a map of twists."""
    assert results(tmp_path, f"{TURNS}$$ {latex} $$\n")[-1].shown is shown
