"""Columns of four beside quaternions, the groups of motions as sets, Ad as a name, ω × R: identities, and the same
with one sign or one factor changed."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome

SYMBOLS = {
    "p": "hamilton quaternion",
    "q": "hamilton quaternion",
    "R": "rotation",
    "w": "vector",
    "u": "vector",
    "A": "tensor",
    "M": "matrix 4×4",
}
DEFINITIONS = [
    r"H = \begin{bmatrix} R & u \\ 0 & 1 \end{bmatrix}",
    r"\operatorname{Ad}_H = \begin{bmatrix} R & 0 \\ \tilde{u} R & R \end{bmatrix}",
]
_COLUMN = r"\begin{bmatrix} \operatorname{Sc}(p) \\ \operatorname{Vec}(p) \end{bmatrix}"
_LEFT = r"\begin{bmatrix} \operatorname{Sc}(q) & -(\operatorname{Vec}(q))^T \\ \operatorname{Vec}(q) & \operatorname{Sc}(q) \mathbf{I} %s \operatorname{skew}(\operatorname{Vec}(q)) \end{bmatrix}"
TRUE_AND_FALSE = [
    (f"q p = {_LEFT % '+'} {_COLUMN}", f"q p = {_LEFT % '-'} {_COLUMN}"),
    (f"p q = {_LEFT % '-'} {_COLUMN}", f"p q = {_LEFT % '+'} {_COLUMN}"),
    (rf"2 q p + p = 2 \left( {_LEFT % '+'} {_COLUMN} \right) + {_COLUMN}", rf"2 q p - p = 2 \left( {_LEFT % '+'} {_COLUMN} \right) + {_COLUMN}"),
    (r"q^* = M q + (\mathbf{I}_{4} - M) q - 2 \begin{bmatrix} 0 \\ \operatorname{Vec}(q) \end{bmatrix}", r"q^* = M q + (\mathbf{I}_{4} - M) q - \begin{bmatrix} 0 \\ \operatorname{Vec}(q) \end{bmatrix}"),
    (r"\begin{bmatrix} -w^T \\ \tilde{w} \end{bmatrix} u = w (\begin{bmatrix} 0 \\ u \end{bmatrix} + 0 q)", r"\begin{bmatrix} -w^T \\ -\tilde{w} \end{bmatrix} u = w (\begin{bmatrix} 0 \\ u \end{bmatrix} + 0 q)"),
    (r"q^T p = \operatorname{Sc}(q^* p)", r"q^T p = \operatorname{Sc}(q p)"),
    (r"(q p)^T (q p) = q^T q p^T p", r"(q p)^T (p q) = q^T q p^T p"),
    (r"(q q^T) p = q (q^T p)", r"(q q^T) p = p (q^T p)"),
    (r"\operatorname{Re}(q p) = \operatorname{Re}(p q)", r"\operatorname{Re}(q p) = \operatorname{Re}(p^* q)"),
    (r"2 \operatorname{Re}(q) = q + q^*", r"\operatorname{Re}(q) = q"),
    (r"H^{-1} \dot{H} \in se(3)", r"H^T \dot{H} \in se(3)"),
    (r"\dot{H} H^{-1} \in \mathfrak{se}(3)", r"\dot{H} \in \mathfrak{se}(3)"),
    (r"H H \in SE(3)", r"2 H \in SE(3)"),
    (r"\begin{bmatrix} R^T & w \\ 0 & 1 \end{bmatrix} \in SE(3)", r"\begin{bmatrix} -R & w \\ 0 & 1 \end{bmatrix} \in SE(3)"),
    (r"\begin{bmatrix} R & w \\ 0 & 1 \end{bmatrix} \in SE(3)", r"\begin{bmatrix} R & w \\ 0 & 2 \end{bmatrix} \in SE(3)"),
    (r"R^T (w \times R) = \widetilde{R^T w}", r"R (w \times R) = \widetilde{R^T w}"),
    (r"(w \times A) u = w \times (A u)", r"(w \times A) u = A (w \times u)"),
    (r"\operatorname{Ad}_H^{-1} = \begin{bmatrix} R^T & 0 \\ -R^T \tilde{u} & R^T \end{bmatrix}", r"\operatorname{Ad}_H^{-1} = \begin{bmatrix} R^T & 0 \\ R^T \tilde{u} & R^T \end{bmatrix}"),
]  # fmt: skip


@pytest.mark.parametrize(("true", "false"), TRUE_AND_FALSE)
def test_true_claims_are_proved_and_changed_ones_refuted(true: str, false: str) -> None:
    symbols = {name: {"kind": kind} for name, kind in SYMBOLS.items()}
    assert check(true, symbols=symbols, definitions=DEFINITIONS).outcome is Outcome.PROVED
    assert check(false, symbols=symbols, definitions=DEFINITIONS).outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    "entries", [("f", "0", "1", "g"), ("f", "0", "g", "h"), ("f", "g", "0", "h"), ("f", "g", "1", "h")]
)
@pytest.mark.parametrize("duals", ["", "f", "g", "fg", "fgh"])
def test_the_inverse_of_a_2x2_matrix_of_real_or_dual_numbers(entries: tuple, duals: str) -> None:
    a, b, c, d = (rf"\underline{{{x}}}" if x in duals and x.isalpha() else x for x in entries)
    symbols = {"f": "scalar", "g": "scalar", "h": "scalar"}
    symbols |= {rf"\underline{{{x}}}": "dual scalar" for x in duals}
    inverse = rf"\begin{{bmatrix}} {a} & {b} \\ {c} & {d} \end{{bmatrix}}^{{-1}} = "
    cofactors = rf"\frac{{1}}{{{a} \cdot {d} - {b} \cdot {c}}} \begin{{bmatrix}} {d} & -{b} \\ -{c} & {a} \end{{bmatrix}}"
    assert check(inverse + cofactors, symbols=symbols).outcome is Outcome.CONDITIONAL
    assert check(f"{inverse} 2 {cofactors}", symbols=symbols).outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\langle f, g, h \rangle \cdot \langle 1, 2, 3 \rangle = f + 2 g + 3 h", Outcome.PROVED),
        (r"\langle f, g, h \rangle \cdot \langle 1, 2, 3 \rangle = f + 2 g + 2 h", Outcome.REFUTED),
        (r"\langle a, b, c \rangle = a \cdot (b \times c)", Outcome.PROVED),
        (r"\langle a, b, c \rangle = b \cdot (a \times c)", Outcome.REFUTED),
    ],
)
def test_three_numbers_in_angle_brackets_are_a_vector(formula: str, outcome: Outcome) -> None:
    symbols = {**dict.fromkeys("abc", "vector"), **dict.fromkeys("fgh", "scalar")}
    assert check(formula, symbols).outcome is outcome
