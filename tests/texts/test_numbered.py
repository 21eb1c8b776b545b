"""e_i for i = 1, 2, 3 of symbols that are declared one by one is read as all of them; else it is unknown as before."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers import load_paper

AXES = "[frames]\nbase = 'N'\ndot = 'N'\nnames = ['B']\naxes = { B = ['e_1', 'e_2', 'e_3'] }\n"
VECTORS = "[symbols]\n'e_1' = 'vector'\n'e_2' = 'vector'\n'e_3' = 'vector'\n"
SYMBOLS = "[symbols]\n'w' = 'vector'\n'x_1' = 'scalar'\n'x_2' = 'scalar'\n'x_3' = 'scalar'\n'y_2' = 'scalar'\n'z_1' = 'scalar'\n'z_2' = 'vector'\n"
DEFINED = "[definitions]\n'x_1' = 'w \\cdot e_1'\n'x_2' = 'w \\cdot e_2'\n'x_3' = 'w \\cdot e_3'\n"
RANGE = r"\quad i = 1, 2, 3"


def outcome(folder: Path, formula: str, model: str) -> str:
    return verdicts(folder, shown(formula), model)[-1].outcome.value


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (rf"e_i \cdot e_i = 1 {RANGE}", "proved"),
        (rf"e_i \cdot e_i = 2 {RANGE}", "refuted"),
        (rf"x_i = w \cdot e_i {RANGE}", "definition"),
        (rf"x_i = 2 w \cdot e_i {RANGE}", "refuted"),
        (r"w = \sum_{i=1}^{3} x_i e_i", "proved"),
        (r"w \cdot w = \sum_{i=1}^{3} x_i^2", "proved"),
        (r"w \cdot w = \sum_{i=1}^{2} x_i^2", "refuted"),
        (r"\dot{e}_i \cdot e_k = -e_i \cdot \dot{e}_k \quad \forall \quad i, k = 1, 2, 3", "proved"),
        (r"x_i = w \cdot e_i \quad i = 1, \ldots, 4", "unread"),
        (r"e_i \times w = -w \times e_i", "unread"),
        (r"y_i = y_i + 1, \quad i = 1, 2", "unread"),
        (r"z_i = z_i + 1, \quad i = 1, 2", "unread"),
    ],
)
def test_members_declared_one_by_one(tmp_path: Path, formula: str, expected: str) -> None:
    model = f"{SYMBOLS}{AXES}{DEFINED}"
    found = outcome(tmp_path, formula, model)
    reads = load_paper(tmp_path / "p.toml").claims[0].printed.statement is not None
    assert (found if reads else "unread") == expected


def test_figure_relations_of_numbered_vectors_are_proposed(tmp_path: Path) -> None:
    formula = rf"e_i \cdot (e_i \times e_i) + e_i \cdot e_i = 1 {RANGE}"
    assert outcome(tmp_path, formula, VECTORS) == "refuted"
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"), motions=False)
    assert result.verdict.grade == "warning" and result.verdict.unless == ("$e_{1}$, $e_{2}$, $e_{3}$: unit",)
    assert outcome(tmp_path, rf"e_i \times (e_i \times e_i) = e_i {RANGE}", VECTORS) == "refuted"


TWO = (
    "[symbols]\n'v' = 'vector'\n"
    + "".join(f"'\\omega_{{{i}{j}}}' = 'scalar'\n" for i in (1, 2, 3) for j in (1, 2, 3))
    + AXES
    + "[definitions]\n"
    + "".join(f"'\\omega_{{{i}{j}}}' = '\\dot{{e}}_{i} \\cdot e_{j}'\n" for i in (1, 2, 3) for j in (1, 2, 3))
)


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (rf"\dot{{e}}_i = \sum_{{j=1}}^{{3}} \omega_{{ij}} e_j {RANGE}", "proved"),
        (rf"\dot{{e}}_i = \sum_{{j=1}}^{{3}} \omega_{{ji}} e_j {RANGE}", "refuted"),
        (rf"\dot{{e}}_i = \sum_{{j=1}}^{{2}} \omega_{{ij}} e_j {RANGE}", "refuted"),
        (r"\omega_{ij} = -\omega_{ji} \quad i, j = 1, 2, 3", "proved"),
        (r"\omega_{ij} = \omega_{ji} \quad i, j = 1, 2, 3", "refuted"),
        (r"\dot{e}_1 = \sum_{j=1}^{3} \omega_{1j} e_j", "proved"),
        (r"e_i \cdot e_j = \delta_{ij} \quad i, j = 1, 2, 3", "proved"),
        (r"e_i \cdot e_j = 2\delta_{ij} \quad i, j = 1, 2, 3", "refuted"),
        (rf"v \cdot e_i = \sum_{{k=1}}^{{3}} \delta_{{ik}} v \cdot e_k {RANGE}", "proved"),
        (r"\omega_{1 2} = -\omega_{21}", "proved"),
        (r"\dot{e}_i = \omega_{ij} e_j \quad i, j = 1, 2, 3", "unread"),  # a sum over j, for some
        (rf"\omega_{{ii}} = 0 {RANGE}", "unread"),  # and this one over i
        (r"\delta_{ii} = 3 \quad i = 1, 2, 3", "unread"),
        (r"e_i \cdot e_j = \delta_{ij}", "unread"),
        (r"\omega_{ij} = -\omega_{ji} \quad i, j = 1, \ldots, 4", "unread"),
    ],
)
def test_members_of_two_indices(tmp_path: Path, formula: str, expected: str) -> None:
    found = outcome(tmp_path, formula, TWO)
    reads = load_paper(tmp_path / "p.toml").claims[0].printed.statement is not None
    assert (found if reads else "unread") == expected


@pytest.mark.parametrize("declared", ["\\delta", "\\delta_i"])
def test_a_declared_delta_is_no_kronecker_delta(tmp_path: Path, declared: str) -> None:
    outcome(
        tmp_path,
        r"e_i \cdot e_j = \delta_{ij} \quad i, j = 1, 2, 3",
        f"[symbols]\n'{declared}' = 'scalar'\n{AXES}",
    )
    assert load_paper(tmp_path / "p.toml").claims[0].printed.statement is None
