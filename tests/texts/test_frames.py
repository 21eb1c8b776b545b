"""Frames and points by declaration: what every textbook says of them is proved, and nothing else."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from workbench.cli.commands import main
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


def verdicts(path: Path, formulas: list[str]) -> list[str]:
    (path / "p.toml").write_text(MODEL)
    (path / "p.md").write_text("\n\n".join(f"$$\n{formula}\n$$" for formula in formulas))
    result = CliRunner().invoke(main, ["check", str(path / "p.toml"), "--no-proposals", "--json"])
    return [claim["verdict"] for claim in json.loads(result.stdout)["claims"]]


def test_the_laws_of_frames_and_points(tmp_path: Path) -> None:
    found = verdicts(tmp_path, TRUE + FALSE)
    assert found == ["proved"] * len(TRUE) + ["refuted"] * len(FALSE)


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [(r"\dot{x} = x", "unchecked"), (r"\frac{{}^C d x}{dt} = x", "unchecked")],
    ids=["a dot in no frame", "no such frame"],
)
def test_what_names_no_frame_is_not_read(tmp_path: Path, formula: str, verdict: str) -> None:
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
