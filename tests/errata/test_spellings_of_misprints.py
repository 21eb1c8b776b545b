"""Spellings that hid public misprints: the true formula holds, the false one is refuted; open ones are not judged."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest

from workbench import Checked, check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome

SYMBOLS: dict[str, Any] = {
    **dict.fromkeys(("f", "g", "h", "l", "w", r"\theta", r"\phi"), "scalar"),
    **dict.fromkeys(("a", "b", "x", "y", r"a_{\hat{x}}", r"{}^{\bar{A}} a"), "vector"),
    **dict.fromkeys(("R", "Q"), "rotation"),
    **dict.fromkeys(("A", "B", "X"), "matrix 2×2"),
    "M": "matrix 3×3",
    r"\epsilon": {"kind": "scalar", "small": True},
    "S": "tensor",
}
#: What is read: left side, true and false right sides, and definitions.
READ: list[tuple[str, str, str, Mapping[str, str]]] = [
    (r"w/2 \tan\phi", r"\frac{w \sin\phi}{2 \cos\phi}", r"w \frac{\sin\phi}{\cos\phi}", {}),
    (r"\cos\langle a, b\rangle", r"\frac{a \cdot b}{\|b\| \|a\|}", r"-\frac{a \cdot b}{\|a\| \|b\|}", {}),
    (r"Re^{\tilde{x}} y", r"R (e^{\tilde{x}} y)", r"-R (e^{\tilde{x}} y)", {}),
    (
        r"\begin{bmatrix} f & \\ & g \end{bmatrix}",
        r"\begin{bmatrix} f & 0 \\ 0 & g + 0 \end{bmatrix}",
        r"\begin{bmatrix} f & 0 \\ 0 & f \end{bmatrix}",
        {},
    ),
    (r"\sin\epsilon = \sin(\epsilon + 0) ", r"\sin\epsilon \approx \epsilon", r"\cos\epsilon \approx \epsilon", {}),
    (r"{}^{\bar{A}} a f", r"f {}^{\bar{A}} a", r"2 f {}^{\bar{A}} a", {}),
    (r"a_{\hat{x}} f", r"f a_{\hat{x}}", r"2 f a_{\hat{x}}", {}),
    ("J(-x)", "J(x)^T", "-J(x)", {"J(x)": r"\mathbf{I} + \tilde{x}"}),
    ("H(f + g)", "H(f) + H(g) + 2 f g", "H(f) + H(g)", {"H(f)": "f^2"}),
    (r"\left. \frac{\partial}{\partial f} (f^3) \right|_{f = 2}", "12", "6", {}),
    ("SO(3)", r"\left\{ S \in \mathbb{R}^{3 \times 3} \mid S^T S = \mathbf{I}, \det S = 1 \right\}", r"\left\{ S \in \mathbb{R}^{3 \times 3} \mid S^T S = \mathbf{I}, \det S = -1 \right\}", {}),
    ("so(3)", r"\left\{ S \in \mathbb{R}^{3 \times 3} \mid S^T = -S \right\}", r"\left\{ S \in \mathbb{R}^{3 \times 3} \mid S^T = S \right\}", {}),
    (
        "SE(3)",
        r"\left\{ \begin{bmatrix} R & x \\ 0 & 1 \end{bmatrix} \mid R \in SO(3), x \in \mathbb{R}^3 \right\}",
        r"\left\{ \begin{bmatrix} R & x \\ 0 & 1 \end{bmatrix} \mid R \in so(3), x \in \mathbb{R}^3 \right\}",
        {},
    ),
    (
        "so(3)",
        r"\left\{ \tilde{x} \mid x \in \mathbb{R}^3 \right\}",
        r"\left\{ \tilde{x} + \mathbf{I} \mid x \in \mathbb{R}^3 \right\}",
        {},
    ),
    (r"\log(R^T)", r"-\log R", r"\log R", {}),
    ("T^{-1}", "B^{-1} A^{-1}", "A^{-1} B^{-1}", {"T": "A B"}),
    (r"\nabla_{f, g} (f^2 g)", r"\begin{bmatrix} 2 f g \\ f^2 \end{bmatrix}", r"\begin{bmatrix} 2 f g \\ f \end{bmatrix}", {}),
    ("d(f g)", r"g\, df + f\, dg", r"g\, df - f\, dg", {}),
    (r"\operatorname{vec}(A X B)", r"(B^T \otimes A) \operatorname{vec} X", r"(A \otimes B^T) \operatorname{vec} X", {}),
    (r"\int a \times b\, dm", r"-\int b \times a\, dm", r"\int b \times a\, dm", {}),
    (r"\int_0^1 \frac{f\, df}{g}", r"\frac{1}{g} \int_0^1 f\, df", r"\frac{2}{g} \int_0^1 f\, df", {}),
    (r"\cos\theta f", r"f \cos\theta", r"\cos(\theta f)", {}),
    (r"\langle a, b \rangle", r"b \cdot a", r"- b \cdot a", {}),
    (r"\sqrt{f^2 - 2 f g + g^2}", r"|f - g|", r"|f + g|", {}),
    (r"\exp(A) \exp(-A)", r"\mathbf{I}_2", r"\mathbf{I}_2 + A", {}),
    (r"\det \exp(M)", r"e^{\operatorname{tr} M}", r"e^{\det M}", {}),
    (
        r"\exp(\begin{bmatrix} f & 0 \\ 0 & g \end{bmatrix})",
        r"\begin{bmatrix} e^f & 0 \\ 0 & e^g \end{bmatrix}",
        r"\begin{bmatrix} e^g & 0 \\ 0 & e^f \end{bmatrix}",
        {},
    ),
    (r"\lim_{h \to 0} (f + g)", r"\lim_{h \to 0} f + \lim_{h \to 0} g", r"\lim_{h \to 0} f - \lim_{h \to 0} g", {}),
    (r"\lim_{h \to 0} \frac{(f + h)^2 - f^2}{h}", "2 f", "f", {}),
    (r"\int_0^1 h\, dh", r"\frac{1}{2}", "1", {}),
    (r"\arcsin f + \arccos f", r"\frac{\pi}{2}", r"\pi", {}),
]  # fmt: skip
#: What is not judged yet: a true formula.
OPEN = [
    r"SE(3) = \left\{ \begin{bmatrix} R & x \\ 0 & 1 \end{bmatrix} \mid R \in SO(3), x \in S^2 \right\}",
    r"\cos(l \phi) \tan l\phi = \sin(l \phi)",
    r"R(\theta + \phi)^T R(\theta + \phi) = \mathbf{I}",
]
_NUMBERS = {"f": {"kind": "scalar", "independent": True}, "g": {"kind": "scalar", "independent": True}}


def outcome(formula: str, definitions: Mapping[str, str]) -> Outcome:
    """The verdict on a formula; `unchecked` where it cannot be read."""
    symbols = SYMBOLS | (_NUMBERS if "nabla" in formula else {})
    try:
        checked = check(formula, symbols, definitions=definitions)
    except ReadError:
        return Outcome.UNCHECKED
    return checked.outcome if isinstance(checked, Checked) else checked[-1].outcome


@pytest.mark.parametrize(("left", "true", "false", "definitions"), READ, ids=[row[0] for row in READ])
def test_formula_in_this_spelling_is_judged(
    left: str, true: str, false: str, definitions: Mapping[str, str]
) -> None:
    holds = (Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION)
    assert outcome(f"{left} = {true}", definitions) in holds
    assert outcome(f"{left} = {false}", definitions) is Outcome.REFUTED


@pytest.mark.parametrize("formula", OPEN)
def test_true_formula_in_an_open_spelling_is_not_refuted(formula: str) -> None:
    assert outcome(formula, {}) is Outcome.UNCHECKED
