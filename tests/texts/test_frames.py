"""Frames and points by declaration: what every textbook says of them is proved, and nothing else."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.context.read_formulas import read_statement
from workbench.core.verdict import Outcome
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.papers import PaperError, load_paper

MODEL = r"""
source = "p.md"
[frames]
base = "N"
names = ["A", "B"]
'{}^F\omega^G' = "angular velocity of G in F"
'{}^F\alpha^G' = "angular acceleration of G in F"
'{}^F R_G' = "rotation to F from G"
axes = { N = ['n_x', 'n_y', 'n_z'], B = ['b_x', 'b_y', 'b_z'] }
[points]
names = ["O", "P", "Q"]
fixed = { O = "N", Q = "B" }
'r^{P/O}' = "to P from O"
'{}^F v^P' = "velocity of P in F"
'{}^F a^P' = "acceleration of P in F"
[symbols]
'x' = { kind = "vector" }
"""
TRUE = [
    r"\frac{{}^A d x}{dt} = \frac{{}^B d x}{dt} + {}^A\omega^B \times x",
    r"\frac{{}^A d x}{dt} = \frac{dx}{dt_B} - \frac{d r^{P/O}}{dt_A} + \frac{d}{dt_A} r^{P/O} + {}^A\omega^B \times x",
    r"\frac{{}^\mathcal{A} d x}{dt} - \frac{{}^{\mathcal{B}} d}{dt} x = {}^A\omega^B \times x",
    r"{}^N\omega^B = {}^N\omega^A + {}^A\omega^B",
    r"{}^A\omega^B = -{}^B\omega^A",
    r"{}^N R_B = {}^N R_A {}^A R_B",
    r"{}^B R_A = ({}^A R_B)^T",
    r"b_x \times b_y = b_z",
    r"{}^B\frac{d}{dt} b_x = 0",
    r"r^{P/O} = -r^{O/P}",
    r"{}^B v^Q = 0",
    r"{}^N v^P = {}^B v^P + {}^N v^Q + {}^N\omega^B \times r^{P/Q}",
    r"{}^A\alpha^B = \frac{{}^B d {}^A\omega^B}{dt}",
]
FALSE = [
    r"\frac{{}^A d x}{dt} = \frac{{}^B d x}{dt} - {}^A\omega^B \times x",
    r"{}^A\omega^B = {}^B\omega^A",
    r"{}^N R_B = {}^A R_B {}^N R_A",
    r"b_x \times b_y = -b_z",
]


CRAIG = r"""
source = "p.md"
[conventions]
points = "homogeneous"
[frames]
base = "U"
names = ["A", "B", "C"]
'{}^F_G R' = "rotation to F from G"
'{}^F_G T' = "transform to F from G"
'{}^F P_{XORG}' = "origin of X in F"
axes = { B = ['\hat X_B', '\hat Y_B', '\hat Z_B'] }
[points]
names = ["P"]
'{}^F P' = "place of P in F"
"""
OF_TRANSFORMS = [
    r"{}^A P = {}^A_B T\, {}^B P",
    r"{}^A P = {}^A_B R\, {}^B P + {}^A P_{BORG}",
    r"{}^A P = {}^A_B T\, {}^B_C T\, {}^C P",
    r"{}^B_A T = {}^A_B T^{-1}",
    r"{}^B_A T = \begin{bmatrix} {}^A_B R^T & -{}^A_B R^T {}^A P_{BORG} \\ 0 & 1 \end{bmatrix}",
]
TURNED = r"""
source = "p.md"
[frames]
base = "N"
names = ["A", "B", "C"]
'{}^F\omega^G' = "angular velocity of G in F"
'{}^F R^G' = "rotation to F from G"
axes = { A = ['a_x', 'a_y', 'a_z'] }
[frames.orientation]
A = '\begin{bmatrix} \cos\psi & -\sin\psi & 0 \\ \sin\psi & \cos\psi & 0 \\ 0 & 0 & 1 \end{bmatrix}'
B = ["A", '\begin{bmatrix} 1 & 0 & 0 \\ 0 & \cos\theta & -\sin\theta \\ 0 & \sin\theta & \cos\theta \end{bmatrix}']
C = ['\frac{r}{\|r\|}', '\frac{(r \times s) \times r}{\|r \times s\| \|r\|}', '\frac{r \times s}{\|r \times s\|}']
[symbols]
'\psi' = "scalar"
'\theta' = "scalar"
'r' = "vector"
's' = "vector"
"""

SCHAUB = r"""
source = "p.md"
[frames]
base = "N"
names = ["B", "R", '\mathcal{S}']
dot = "N"
'[BN]' = "rotation to B from N"
'{}^F\omega_{P/Q}' = "angular velocity of P in Q, resolved in F"
axes = { B = ['\hat b_1', '\hat b_2', '\hat b_3'] }
[symbols]
'\omega' = "vector"
[definitions]
'\omega' = '{}^B\omega_{B/N}'
"""
OF_MATRICES = [
    r"[RN] = [RB][BN]",
    r"[BN]^T = [NB]",
    r"[B\mathcal{S}] [\mathcal{S} N] = [BN]",
    r"[\dot{BN}] = -[\tilde{\omega}] [BN]",
    r"\dot{[BN]} = -\tilde{\omega} [BN(t)]",
    r"\frac{d}{dt}[NB] = [NB] [\tilde\omega]",
    r"{}^N\omega_{B/N} = [NB] \omega",
    r"[\ddot{BN}] = [\tilde{\omega}]^2 [BN] - [\tilde{\dot{\omega}}] [BN]",
    r"\hat b_1 = [BN]^T \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix}",
    r"\det [RB] = 1",
]
NOT_OF_MATRICES = [
    r"[RN] = [BN][RB]",
    r"[BN] = [NB]",
    r"[\dot{BN}] = [\tilde{\omega}] [BN]",
    r"{}^N\omega_{B/N} = [BN] \omega",
    r"[\ddot{BN}] = [\tilde{\omega}]^2 [BN] + [\tilde{\dot{\omega}}] [BN]",
]


def verdicts(path: Path, formulas: list[str], model: str = MODEL) -> list[str]:
    (path / "p.toml").write_text(model)
    (path / "p.md").write_text("\n\n".join(f"$$\n{formula}\n$$" for formula in formulas))
    result = CliRunner().invoke(main, ["check", str(path / "p.toml"), "--no-proposals", "--json"])
    return [claim["verdict"] for claim in json.loads(result.stdout)["claims"]]


def test_the_laws_of_frames_and_points(tmp_path: Path) -> None:
    found = verdicts(tmp_path, TRUE + FALSE)
    assert found == ["proved"] * len(TRUE) + ["refuted"] * len(FALSE)


def test_the_laws_of_matrices_that_two_frames_name(tmp_path: Path) -> None:
    found = verdicts(tmp_path, OF_MATRICES + NOT_OF_MATRICES, SCHAUB)
    assert found == ["proved"] * len(OF_MATRICES) + ["refuted"] * len(NOT_OF_MATRICES)
    for claim in load_paper(tmp_path / "p.toml").claims:
        statement = claim.printed.statement
        with printed_for(claim.notation.author_notation):
            assert read_statement(to_latex(statement), claim.notation, None)[0] == statement


def test_only_symbols_in_a_bracket_are_a_product_not_frames(tmp_path: Path) -> None:
    undeclared = SCHAUB.replace("'[BN]' =", "'C_{B/N}' =")
    symbols = "'B' = \"tensor\"\n'N' = \"tensor\"\n'[PQ]' = \"rotation\"\n'P' = \"tensor\"\n[definitions]"
    undeclared = undeclared.replace("[definitions]", symbols)
    formulas = [r"[BN] = BN", r"[BP]^T = P^T B^T", r"[PQ][PQ]^T = \mathbf{I}", r"[PQ]^T [PQ]^T = \mathbf{I}"]
    assert verdicts(tmp_path, formulas, undeclared) == ["unchecked", "proved", "proved", "refuted"]
    reason = load_paper(tmp_path / "p.toml").claims[0].printed.unread
    assert "'[BN]' = \"rotation to B from N\"" in reason
    own = undeclared.replace("[symbols]", "[notation]\n'[BN]' = { means = 'B^2' }\n[symbols]")
    assert verdicts(tmp_path, [r"[BN]^T = B^T B^T", r"[BN] + N = BN"], own) == ["proved", "refuted"]


def test_transforms_act_on_points_as_columns_of_four(tmp_path: Path) -> None:
    wrong = [
        r"{}^A P = {}^B_A T\, {}^B P",
        r"{}^A P = {}^A_B R\, {}^B P - {}^A P_{BORG}",
        r"\hat X_B = {}^A_B T \hat X_B",  # a direction
    ]
    found = verdicts(tmp_path, OF_TRANSFORMS + wrong, CRAIG)
    assert found == ["proved"] * len(OF_TRANSFORMS) + ["refuted", "refuted", "unchecked"]


DRAKE = r"""
source = "p.md"
[conventions]
points = "vectors"
[frames]
base = "W"
names = ["A", "B", "C"]
'{}^F R^G' = "rotation to F from G"
'{}^F X^G' = "transform to F from G"
'{}^F p^G_D' = "origin of G in F, resolved in D"
'{}^F p^G' = "origin of G in F"
'{}^F\omega^G_D' = "angular velocity of G in F, resolved in D"
'{}^F v^G_D' = "velocity of the origin of G in F, resolved in D"
'{}^F u' = "u resolved in F"
'{}^F z' = 'u \times w resolved in F'
[symbols]
u = "vector"
w = "vector"
"""
OF_COMPONENTS = [
    r"{}^A p^B_C = {}^C R^A {}^A p^B",
    r"{}^A p^B_C + {}^B p^A_C = 0",
    r"{}^A p^C = {}^A p^B + {}^A R^B {}^B p^C",
    r"{}^A p^C = {}^A X^B {}^B p^C",
    r"{}^W p^C = {}^W X^A ({}^A X^B {}^B p^C)",
    r"{}^W X^A {}^A X^B {}^B p^C = {}^W p^B + {}^W R^B {}^B p^C",
    r"({}^A X^B)^{-1} {}^A p^C = {}^B p^C",
    r"{}^A p^C_W = {}^A p^B_W + {}^B p^C_W",
    r"{}^A v^C_W = {}^A v^B_W + {}^B v^C_W + {}^A\omega^B_W \times {}^B p^C_W",
    r"{}^A v^B_C = -{}^B v^A_C - {}^A\omega^B_C \times {}^B p^A_C",
    r"{}^A u = {}^A R^B {}^B u",
    r"{}^A u = {}^A R^W u",
    r"{}^A u = {}^A R^C {}^C R^B {}^B u",
    r"{}^A z = {}^A R^B {}^B z",
    r"{}^A z = {}^A u \times {}^A R^W w",
]
OF_WRONG_COMPONENTS = [
    r"{}^A p^C = {}^B X^A {}^B p^C",
    r"{}^A p^B_C = {}^A R^C {}^A p^B",
    r"{}^A u = {}^B R^A {}^B u",
    r"{}^A p^B_C = {}^B p^A_C",
    r"{}^A z = {}^B z",
]


def test_components_in_frames(tmp_path: Path) -> None:
    found = verdicts(tmp_path, OF_COMPONENTS + OF_WRONG_COMPONENTS, DRAKE)
    assert found == ["proved"] * len(OF_COMPONENTS) + ["refuted"] * len(OF_WRONG_COMPONENTS)


@pytest.mark.parametrize("phrase", ["k resolved in F", "2 resolved in F", "u", "u resolved in"])
def test_only_vectors_are_resolved_in_frames(tmp_path: Path, phrase: str) -> None:
    (tmp_path / "p.toml").write_text(DRAKE.replace('"u resolved in F"', f'"{phrase}"'))
    (tmp_path / "p.md").write_text("$$\nu = u\n$$\n")
    with pytest.raises(PaperError, match="a vector resolved in F"):
        load_paper(tmp_path / "p.toml")


def test_frames_made_of_others_and_of_vectors(tmp_path: Path) -> None:
    formulas = [
        r"{}^N\omega^B = \dot\psi a_z + \dot\theta a_x",
        r"{}^N R^B = {}^N R^A {}^A R^B",
        r"({}^N R^C)^T r = \begin{bmatrix} \|r\| \\ 0 \\ 0 \end{bmatrix}",
        r"{}^N R^B = {}^A R^B {}^N R^A",
    ]
    assert verdicts(tmp_path, formulas, TURNED) == ["proved", "proved", "conditional", "refuted"]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (r"-\sin\psi", r"\sin\psi", "A is not seen to be a rotation"),
        (r"1 \end", r"-1 \end", "A is not seen to be a rotation"),
        (r"\|r \times s\|}'", r"\|s\|}'", "C is not seen to be a rotation"),
        ('B = ["A", ', 'B = ["C", ', "C is to be given before"),
        ('B = ["A", ', 'B = ["D", ', "D is not among the names"),
        ('B = ["A", ', 'B = ["A", "A", "A", ', "expected a matrix"),
    ],
)
def test_orientations_that_are_none(tmp_path: Path, old: str, new: str, message: str) -> None:
    (tmp_path / "p.toml").write_text(TURNED.replace(old, new, 1))
    (tmp_path / "p.md").write_text("$$\nr = r\n$$\n")
    with pytest.raises(PaperError, match=message):
        load_paper(tmp_path / "p.toml")


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [(r"\dot{x} = x", "unchecked"), (r"\frac{{}^C d x}{dt} = x", "unchecked")],
    ids=["a dot in no frame", "no such frame"],
)
def test_formulas_without_known_frames_are_not_read(tmp_path: Path, formula: str, verdict: str) -> None:
    assert verdicts(tmp_path, [formula]) == [verdict]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('base = "N"', ""),
        ('"rotation to F from G"', '"rotation"'),
        ("{}^F R_G'", "R_G'"),
        ('Q = "B"', 'Q = "C"'),
        ("['n_x', 'n_y', 'n_z']", "['n_x']"),
        ("'x' =", "'{}^A\\omega^B' = { kind = \"vector\" }\n'\\mathsf{Q}_A' ="),
    ],
)
def test_tables_that_cannot_be_used(tmp_path: Path, old: str, new: str) -> None:
    assert old in MODEL
    (tmp_path / "p.toml").write_text(MODEL.replace(old, new))
    (tmp_path / "p.md").write_text("$$\nx = x\n$$\n")
    with pytest.raises(PaperError):
        load_paper(tmp_path / "p.toml")


GEOMETRIC = r"""
source = "p.md"
[frames]
base = "N"
names = ["B"]
'\omega_{F/G}' = "angular velocity of F in G"
axes = { B = ['b_x', 'b_y', 'b_z'], N = ['n_x', 'n_y', 'n_z'] }
MORE
[symbols]
'x' = "scalar"
'y' = "scalar"
'w' = "vector"
"""


@pytest.mark.parametrize(
    ("formula", "is_true"),
    [
        (r"{}^B\begin{bmatrix} x \\ y \\ 0 \end{bmatrix} = x b_x + y b_y", True),
        (r"{}^N\begin{bmatrix} x \\ y \\ 0 \end{bmatrix} = x n_x + y n_y", True),
        (r"{}^B\begin{bmatrix} x \\ y \\ 0 \end{bmatrix} = x b_y + y b_x", False),
        (r"\frac{{}^N d}{dt} b_x = \omega_{B/N} \times {}^B\begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix}", True),
        (r"\frac{{}^N d}{dt} b_x = {}^B\begin{bmatrix} 0 \\ 0 \\ 0 \end{bmatrix} + b_x", False),
    ],
)
def test_a_column_with_a_frame_is_a_vector_in_that_frame(tmp_path: Path, formula: str, is_true: bool) -> None:
    (tmp_path / "p.md").write_text(f"$$\n{formula}\n$$")
    (tmp_path / "p.toml").write_text(GEOMETRIC.replace("MORE", ""))
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert result.verdict.outcome is (Outcome.PROVED if is_true else Outcome.REFUTED)


@pytest.mark.parametrize(
    "more",
    ["'{}^F C^G' = \"rotation to F from G\"", "'{}^F v' = 'w resolved in F'"],
    ids=["rotation", "resolved"],
)
def test_a_resolved_vector_is_rejected_beside_component_columns(tmp_path: Path, more: str) -> None:
    (tmp_path / "p.md").write_text(r"$$ {}^B\begin{bmatrix} x \\ y \\ 0 \end{bmatrix} = x b_x + y b_y $$")
    (tmp_path / "p.toml").write_text(GEOMETRIC.replace("MORE", more))
    (claim,) = load_paper(tmp_path / "p.toml").claims
    assert claim.printed.statement is None


TWO_FIGURES = """
source = "p.md"
[frames]
base = "0"
names = ["1", "2", "12", "e"]
dot = "0"
'R_{FG}' = "rotation to F from G"
'T_{FG}' = "transform to F from G"
"""


def test_two_figures_are_two_frames(tmp_path: Path) -> None:
    true = [
        r"R_{02} = R_{01} R_{12}",
        r"T_{0e} = T_{01} T_{12} T_{2e}",
        r"R_{01} = R_{10}^T",
        r"T_{21} = T_{12}^{-1}",
    ]
    false = [r"R_{02} = R_{12} R_{01}", r"R_{0e} = R_{e0}"]
    unread = [r"R_{0 12} = R_{0112}", r"R_{012} = R_{01}"]
    found = verdicts(tmp_path, true + false + unread, TWO_FIGURES)
    assert found == ["proved"] * len(true) + ["refuted"] * len(false) + ["unchecked"] * 2
