"""Corrections of several entries of a matrix, of scalar factors, and of forms that do not fit by their types."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_claims
from workbench.core.verdict import Outcome
from workbench.papers.load import load_paper
from workbench.repair.propose.chain_neighbours import neighbours_of
from workbench.repair.propose.proposal import Repair
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits

LIMITS = Limits(seconds=60.0)
SCALARS = dict.fromkeys(("a", "b", "c", "d", r"\theta"), "scalar")
VECTORS = {"x": "vector", "y": "vector", "u": "vector", "R": "rotation", "S": "matrix 2×3", "T": "matrix 2×3"}


def repaired(latex: str, definitions: dict[str, str] | None = None, **more: str) -> Repair:
    (done,) = [check(latex, {**SCALARS, **VECTORS, **more}, definitions=definitions or {})]
    return done.repair(LIMITS)


QUADRATIC = {"M": r"\begin{bmatrix} a b + c & a b - c & d \\ a - b & a c + b d & a + d \end{bmatrix}"}


@pytest.mark.parametrize(
    ("printed", "definitions", "corrected", "kind"),
    [
        (
            r"M = \begin{bmatrix} a b - c & a b + c & d \\ a + b & a c - b d & a - d \end{bmatrix}",
            QUADRATIC,
            r"a b + c & a b - c & d \\ a - b & a c + b d & a + d",
            "sign",
        ),
        (
            r"M = \begin{bmatrix} a - b & a c + b d & a + d \\ a b + c & a b - c & d \end{bmatrix}",
            QUADRATIC,
            r"a b + c & a b - c & d \\ a - b & a c + b d & a + d",
            "swap",
        ),
    ],
)
def test_wrong_entries_are_mended_together(
    printed: str, definitions: dict[str, str], corrected: str, kind: str
) -> None:
    found = repaired(printed, definitions, M="matrix 2×3")
    assert corrected in found.proposals[0].latex, str(found)
    assert {change.kind for change in found.proposals[0].changes} == {kind}


@pytest.mark.parametrize(
    ("printed", "corrected"),
    [
        (r"(a + b)^2 - (a - b)^2 = 4 a", r"4 b a"),
        (
            r"\frac{b c}{a} - \frac{b}{a} + 1 + \frac{c}{a} = \frac{b c}{a} + (a + c - b)",
            r"\frac{a + c - b}{a}",
        ),
        (r"\|x \times y\| = \sqrt{(x \cdot x) (y \cdot y) - x \cdot y}", r"\left(x \cdot y\right)^{2}"),
        (r"\|x + y\| = \sqrt{x \cdot x + y \cdot y - 2 x \cdot y}", r"+ 2 x \cdot y"),
        (r"\cos 2\theta = 1 - 2 \sin\theta", r"\left(\sin \theta\right)^{2}"),
    ],
)
def test_scalar_factors_are_found_by_their_ratio(printed: str, corrected: str) -> None:
    found = repaired(printed)
    assert any(corrected in proposal.latex for proposal in found.proposals), str(found)


def test_a_whole_side_is_not_rewritten() -> None:
    places = {"p": r"a \cos\theta + b \cos\phi", "w": r"a \sin\theta + b \sin\phi"}
    found = repaired(
        r"\dot{w} = a \dot\theta \cos\theta + b \dot\theta \cos\phi", places, **{r"\phi": "scalar"}
    )
    assert all(r"\dot{w}" in proposal.latex for proposal in found.proposals), str(found)


@pytest.mark.parametrize(
    ("printed", "kinds", "corrected"),
    [
        (r"B = x^T y", {"B": "tensor"}, r"x y^{T}"),
        (r"B = x^T + y", {"B": "scalar"}, r"x^{T} y"),
        (r"B = S T", {"B": "matrix 3×3"}, r"S^{T} T"),
        (
            r"S = \begin{bmatrix} a & b & c \end{bmatrix}",
            {},
            r"\begin{bmatrix} a & b & c \\ 0 & 0 & 0 \end{bmatrix}",
        ),
    ],
)
def test_forms_that_fit_by_their_types_are_offered(
    printed: str, kinds: dict[str, str], corrected: str
) -> None:
    found = repaired(printed, **kinds)
    latex = [proposal.latex for proposal in found.proposals]
    assert any(corrected in each for each in latex), latex
    assert {proposal.verdict.outcome for proposal in found.proposals} == {Outcome.UNCHECKED}


def test_proposals_of_a_step_agree_with_its_neighbours(tmp_path: Path) -> None:
    steps = r"\left(x + y\right) \cdot (x + y) &= x^2 + x \cdot y + y^2 \\ &= x^2 + 2 x \cdot y + y^2"
    (tmp_path / "text.tex").write_text(rf"\begin{{align}} {steps} \end{{align}}")
    (tmp_path / "text.toml").write_text("source = 'text.tex'\n[symbols]\nx = 'vector'\ny = 'vector'\n")
    results = judge_claims(load_paper(tmp_path / "text.toml").claims)
    claims = [result.claim for result in results]
    beside = neighbours_of(claims)
    assert [str(result.verdict.outcome) for result in results] == ["refuted", "refuted"]
    found = [repair(claim, LIMITS, beside=beside[claim.id]) for claim in claims]
    assert all(r"x^{2} + 2 \left(x \cdot y\right) + y^{2}" in each.proposals[0].latex for each in found), (
        found
    )
    alone = repair(claims[1], LIMITS)
    assert len(alone.proposals) > len(found[1].proposals) == 1


#: Steps of chains with one misprint that makes a step false: what is proposed for each false step.
SQUARED = r"\left(a \times r\right)^{2} = a^{2} r^{2} - \left(a \cdot r\right)^{2}"
MIDDLE = r"a^{2} r^{2} - \left(a \cdot r\right)^{2} = a^{2} r^{2} - \left(a \cdot r\right)^{2}"
CHAINS = [
    (r"(a \times r)^2 &= a^2 r^2 - (a \cdot r)^2 \\ &= a^2 r^2 + (a \cdot r)^2", [MIDDLE]),
    (r"(a \times r)^2 &= a^2 r^2 + (a \cdot r)^2 \\ &= a^2 r^2 - (a \cdot r)^2", [SQUARED, MIDDLE]),
    (
        r"(a \times r)^2 &= a^2 r^2 - (a \cdot r)^2 \\ &= a^2 r^2 + (a \cdot r)^2 \\ &= (a\cdot r)^2 + r^2 a^2",
        [MIDDLE],
    ),
]


@pytest.mark.parametrize(("steps", "proposed"), CHAINS)
def test_sign_is_proposed_for_a_step_of_a_chain(tmp_path: Path, steps: str, proposed: list[str]) -> None:
    (tmp_path / "text.tex").write_text(rf"\begin{{align}} {steps} \end{{align}}")
    (tmp_path / "text.toml").write_text("source = 'text.tex'\n[symbols]\na = 'vector'\nr = 'vector'\n")
    results = judge_claims(load_paper(tmp_path / "text.toml").claims)
    beside = neighbours_of([result.claim for result in results])
    false = [r.claim for r in results if r.verdict.outcome is Outcome.REFUTED]
    found = [repair(claim, LIMITS, beside=beside[claim.id]).proposals[0] for claim in false]
    assert [each.latex for each in found] == proposed
    assert all([change.kind for change in each.changes] == ["sign"] for each in found)
    assert {each.verdict.outcome for each in found} == {Outcome.PROVED}


def test_trivial_step_is_no_proposal_beside_a_false_neighbour(tmp_path: Path) -> None:
    """Of two false steps, the second is not mended by the sign that repeats the first one's fault."""
    steps = r"a \times r &= r \times a + a \\ &= r \times a - a"
    (tmp_path / "text.tex").write_text(rf"\begin{{align}} {steps} \end{{align}}")
    (tmp_path / "text.toml").write_text("source = 'text.tex'\n[symbols]\na = 'vector'\nr = 'vector'\n")
    results = judge_claims(load_paper(tmp_path / "text.toml").claims)
    beside = neighbours_of([result.claim for result in results])
    claim = results[1].claim
    found = repair(claim, LIMITS, beside=beside[claim.id])
    assert all("r \\times a + a = r \\times a + a" not in p.latex for p in found.proposals), str(found)


def test_no_proposal_holds_an_addend_that_another_takes_away() -> None:
    found = check("M^T = -M", {"M": {"kind": "tensor", "symmetric": True}}).repair(LIMITS)
    assert found.proposals and all("2" not in proposal.latex for proposal in found.proposals), str(found)


@pytest.mark.parametrize(
    ("printed", "definition", "proposed"),
    [("c = a - 2 b", "-a", "c = -a"), ("c = a + 2 b", "3 a", "c = 3 a")],
)
def test_no_proposal_holds_two_multiples_of_an_addend(printed: str, definition: str, proposed: str) -> None:
    """The change of b to a would leave a - 2 a and a + 2 a."""
    found = repaired(printed, {"c": definition})
    assert [proposal.latex for proposal in found.proposals] == [proposed], str(found)
