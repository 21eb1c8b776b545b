"""Places of points and origins of frames that a text gives."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.texts.test_frames import verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers import PaperError, load_paper

PENDULUM = r"""
source = "p.md"
[frames]
base = "N"
names = ["B", "C"]
'{}^F\omega^G' = "angular velocity of G in F"
axes = { B = ['b_x', 'b_y', 'b_z'], C = ['c_x', 'c_y', 'c_z'], N = ['n_x', 'n_y', 'n_z'] }
[frames.orientation]
B = '\begin{bmatrix} \cos\theta & -\sin\theta & 0 \\ \sin\theta & \cos\theta & 0 \\ 0 & 0 & 1 \end{bmatrix}'
C = ["B", '\begin{bmatrix} \cos\phi & -\sin\phi & 0 \\ \sin\phi & \cos\phi & 0 \\ 0 & 0 & 1 \end{bmatrix}']
[points]
names = ["O", "P", "Q"]
fixed = { O = "N" }
place = { Q = ["O", 'l b_x'], P = ["Q", 's c_x'] }
'r^{OP}' = "to P from O"
'{}^F v^P' = "velocity of P in F"
'{}^F a^P' = "acceleration of P in F"
[symbols]
'\theta' = "scalar"
'\phi' = "scalar"
'l' = { kind = "scalar", constant = true }
's' = "scalar"
"""
OF_PLACES = [
    r"r^{OQ} = l b_x",
    r"r^{OP} = l b_x + s c_x",
    r"r^{PQ} = -s c_x",
    r"{}^N v^Q = l \dot{\theta} b_y",
    r"{}^N v^P = {}^N v^Q + \dot{s} c_x + s (\dot{\theta} + \dot{\phi}) c_y",
    r"{}^N a^Q = l \ddot{\theta} b_y - l \dot{\theta}^2 b_x",
]
NOT_OF_PLACES = [
    r"{}^N v^P = {}^N v^Q + s (\dot{\theta} + \dot{\phi}) c_y - 2 \dot{s} c_x",
    r"{}^N a^Q = l \ddot{\theta} b_y + l \dot{\theta}^2 b_x",
    r"r^{QO} = l b_x",
]


def test_places_that_a_text_gives(tmp_path: Path) -> None:
    found = verdicts(tmp_path, OF_PLACES + NOT_OF_PLACES, PENDULUM)
    assert found[: len(OF_PLACES)] == ["proved"] * len(OF_PLACES)
    assert "proved" not in found[len(OF_PLACES) :] and found[-2:] == ["refuted"] * 2


@pytest.mark.parametrize(
    ("place", "why"),
    [
        ("{ P = ['Q', 's c_x'], Q = ['O', 'l b_x'] }", "that of Q is to be given before"),
        ("{ P = ['P', 's c_x'] }", "that of P is to be given before"),
        ("{ O = ['Q', 's c_x'] }", "O is fixed, too"),
        ("{ T = ['Q', 's c_x'] }", "T is not among the names"),
        ("{ Q = ['T', 's c_x'] }", "T is not among the names"),
        ("{ Q = 's c_x' }", "expected another point and the vector from there"),
        ("{ Q = ['O', 's'] }", "expected a vector, got a scalar"),
        ("{ Q = ['O', 'r^{OP}'] }", "column 1"),
    ],
)
def test_places_that_cannot_be_used(tmp_path: Path, place: str, why: str) -> None:
    (tmp_path / "p.md").write_text("$$ s = s $$")
    before, _, after = PENDULUM.partition("place = ")
    (tmp_path / "p.toml").write_text(f"{before}place = {place}\n{after.partition(chr(10))[2]}")
    with pytest.raises(PaperError, match=re.escape(why)):
        load_paper(tmp_path / "p.toml")


@pytest.mark.parametrize(("body", "is_circle"), [("r^{OP} + b_x", True), ("y", True), ("l b_x", False)])
def test_a_position_with_a_circular_definition_is_rejected(
    tmp_path: Path, body: str, is_circle: bool
) -> None:
    (tmp_path / "p.md").write_text("$$ r^{OP} = x $$")
    model = re.sub(r"place = .*", "place = { P = ['O', 'x'] }", PENDULUM)
    definitions = f"'x' = {{ kind = 'vector' }}\n[definitions]\n'y' = 'r^{{OP}} - b_x'\n'x' = '{body}'\n"
    (tmp_path / "p.toml").write_text(model + definitions)
    if is_circle:
        with pytest.raises(PaperError, match="its definition leads back to it"):
            load_paper(tmp_path / "p.toml")
    else:
        (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
        assert result.verdict.outcome is Outcome.PROVED


ARM = r"""
source = "p.md"
[symbols]
'L' = { kind = "scalar", constant = true }
'\alpha' = "scalar"
'\beta' = "scalar"
[frames]
base = "0"
names = ["1", "2", "e"]
dot = "0"
'{}^F_GR' = "rotation to F from G"
'{}^F\omega_G' = "angular velocity of G in 0, resolved in F"
'{}^F v_G' = "velocity of the origin of G in 0, resolved in F"
'{}^F P_G' = "origin of G in F"
axes = { 1 = ['\hat{x}_1', '\hat{y}_1', '\hat{z}_1'], 2 = ['\hat{x}_2', '\hat{y}_2', '\hat{z}_2'] }
[frames.orientation]
1 = '\begin{bmatrix} \cos\alpha & -\sin\alpha & 0 \\ \sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 1 \end{bmatrix}'
2 = ["1", '\begin{bmatrix} \cos\beta & -\sin\beta & 0 \\ \sin\beta & \cos\beta & 0 \\ 0 & 0 & 1 \end{bmatrix}']
e = ["2", '\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 1 \end{bmatrix}']
[points]
names = ["U", "V", "E"]
fixed = { U = ["0", "1"], V = "2", E = "e" }
place = { V = ["U", 'L \hat{x}_1'], E = ["V", '2 L \hat{x}_2'] }
"""


def test_origins_of_an_arm_are_at_their_given_positions(tmp_path: Path) -> None:
    true = [
        r"{}^2_0R = {}^2_1R {}^1_0R",
        r"{}^0\omega_0 + {}^1\omega_0 = 0",
        r"{}^1\omega_1 = {}^1_0R {}^0\omega_0 + \begin{bmatrix} 0 \\ 0 \\ \dot\alpha \end{bmatrix}",
        r"{}^1 P_2 = \begin{bmatrix} L \\ 0 \\ 0 \end{bmatrix}",
        r"{}^1 v_1 = 0",
        r"{}^2 v_2 = {}^2_1R ({}^1v_1 + {}^1\omega_1 \times {}^1P_2)",
        r"{}^2 v_2 = \begin{bmatrix} L \dot\alpha \sin\beta \\ L \dot\alpha \cos\beta \\ 0 \end{bmatrix}",
        r"{}^2 v_e = {}^2 v_2 + {}^2\omega_2 \times {}^2 P_e",
        r"{}^0 v_e = \frac{d}{dt}({}^0 P_e)",
    ]
    false = [
        r"{}^2 v_2 = \begin{bmatrix} L \dot\alpha \sin\beta \\ -L \dot\alpha \cos\beta \\ 0 \end{bmatrix}",
        r"{}^2 v_e = {}^2 v_2 - {}^2\omega_2 \times {}^2 P_e",
    ]
    assert verdicts(tmp_path, true + false, ARM) == ["proved"] * len(true) + ["refuted"] * len(false)


@pytest.mark.parametrize(
    ("fixed", "place"),
    [
        ('U = "2", V = "2"', r"""V = ["U", 'L \hat{x}_1']"""),
        ('U = "1", V = "2", E = "2"', r"""U = ["E", 'L \hat{x}_1'], V = ["U", 'L \hat{x}_2']"""),
        ('V = "2", U = ["2", "1"], E = ["1", "e"]', r"""V = ["E", 'L \hat{x}_1']"""),
    ],
)
def test_an_origin_that_rests_on_its_own_frame_is_refused(tmp_path: Path, fixed: str, place: str) -> None:
    model = re.sub(r"fixed = .*", lambda _: f"fixed = {{ {fixed} }}", ARM)
    (tmp_path / "p.toml").write_text(re.sub(r"place = .*", lambda _: f"place = {{ {place} }}", model))
    (tmp_path / "p.md").write_text("$$ L = L $$")
    with pytest.raises(PaperError, match=r"is to be given before|is fixed, too"):
        load_paper(tmp_path / "p.toml")
