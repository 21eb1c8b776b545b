"""Formulas that once had a wrong verdict, with the verdict that is right."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError

FRAMES = r"""[frames]
base = "N"
names = ["A", "B", "C"]
dot = "N"
'{}^F\omega^G' = "angular velocity of G in F"
'{}^F\alpha^G' = "angular acceleration of G in F"
'{}^F R^G' = "rotation to F from G"
'{}^F x' = 'x resolved in F'
'{}^F y' = 'y resolved in F'
[points]
names = ["O", "P", "Q", "S"]
fixed = { O = "N", Q = "B", S = "A" }
'r^{P/O}' = "to P from O"
'{}^F v^P' = "velocity of P in F"
'{}^F a^P' = "acceleration of P in F"
[symbols]
x = "vector"
y = "vector"
f = "scalar"
"""
#: Wrong transport terms: another letter of a frame, sign or order.
FALSE = [
    r"{}^B\alpha^A = \frac{{}^B d}{dt} {}^B\omega^C",
    r"{}^B\alpha^C = \frac{{}^A d}{dt} {}^B\omega^C",
    r"\dot{x} = \frac{{}^A d x}{dt} + {}^N\omega^B \times x",
    r"{}^B\alpha^C = \frac{{}^A d}{dt} \left({}^B\omega^A\right)",
    r"{}^C\frac{d}{dt} x - \frac{{}^Bdx}{dt} = {}^C\omega^A \times x",
    r"\frac{{}^C d x}{dt} = \frac{{}^A d x}{dt}+{}^C\omega^B \times x",
    r"{}^C v^Q - {}^N v^P = \frac{{}^B d}{dt} r^{Q/P}+{}^N\omega^B\times r^{Q/P}",
    r"\frac{{}^N d}{dt} \left(x\right) - {}^A\frac{d}{dt} x = x \times {}^N\omega^C",
]
KINDS = {"f": "scalar", "g": "scalar", "x": "scalar", "y": "scalar"}
#: Rows in brackets, which are true where they are read.
ROWS = [
    r"[f \quad -g] \begin{bmatrix} x \\ y \end{bmatrix} = f x - g y",
    r"[f \; g]^T = \begin{bmatrix} f \\ g \end{bmatrix}",
]


@pytest.mark.parametrize("rotation", ["'{}^F R^G'", "'[FG]'"])
@pytest.mark.parametrize("latex", FALSE)
def test_wrong_transport_term_is_refuted(latex: str, rotation: str, tmp_path: Path) -> None:
    file = tmp_path / "notation.toml"
    file.write_text(FRAMES.replace("'{}^F R^G'", rotation), encoding="utf-8")
    assert str(check(latex, notation=file).outcome) == "refuted"


@pytest.mark.parametrize("latex", ROWS)
def test_row_in_brackets_is_no_false_alarm(latex: str) -> None:
    try:
        found = str(check(latex, KINDS).outcome)
    except ReadError:
        return
    assert found in ("proved", "unchecked")
