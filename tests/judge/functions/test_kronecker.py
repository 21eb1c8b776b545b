"""Kronecker products and vec: their laws, and what ⊗ does not take."""

from __future__ import annotations

from typing import Any

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome

SYMBOLS: dict[str, Any] = {
    **dict.fromkeys("ABCX", "matrix 2×2"),
    "M": "matrix 2×3",
    "x": "matrix 2×1",
    "T": "tensor",
    "R": "rotation",
    "v": "vector",
}
LAWS = [
    (r"\operatorname{vec}(A X B) = %s", r"(B^T \otimes A) \operatorname{vec} X", r"(B \otimes A) \operatorname{vec} X"),
    (r"\operatorname{vec}(T R) = %s", r"(\mathbf{I}_3 \otimes T) \operatorname{vec} R", r"(T \otimes \mathbf{I}_3) \operatorname{vec} R"),
    (r"(A \otimes B)(X \otimes C) = %s", r"(A X) \otimes (B C)", r"(X A) \otimes (B C)"),
    (r"(A \otimes M)^T = %s", r"A^T \otimes M^T", r"M^T \otimes A^T"),
    (r"(A \otimes B)^{-1} = %s", r"A^{-1} \otimes B^{-1}", r"B^{-1} \otimes A^{-1}"),
    (r"\operatorname{tr}(A \otimes B) = %s", r"(\operatorname{tr} A)(\operatorname{tr} B)", r"\operatorname{tr}(A B)"),
    (r"\det(A \otimes B) = %s", r"(\det A)^2 (\det B)^2", r"(\det A) (\det B)"),
    (r"\operatorname{vec}(x x^T) = %s", r"(x \otimes \mathbf{I}_2) x", r"(x \otimes x^T) x"),
    (r"(\operatorname{vec} A)^T \operatorname{vec} B = %s", r"\operatorname{tr}(A^T B)", r"\operatorname{tr}(A B)"),
    (r"\frac{d}{dt} (A \otimes M) = %s", r"\dot{A} \otimes M + A \otimes \dot{M}", r"\dot{A} \otimes \dot{M}"),
    (r"\mathbf{I}_2 \otimes x^T = %s", r"\begin{bmatrix} x^T & 0 \\ 0 & x^T \end{bmatrix}", r"\begin{bmatrix} x^T & x^T \\ 0 & x^T \end{bmatrix}"),
    (r"(\mathbf{I}_3 \otimes v^T) \operatorname{vec} T = %s", r"T^T v", r"T v"),
    (r"(R^T R \otimes (R^T v)^T) \operatorname{vec} (T R T) = %s", r"(T R T)^T R^T v", r"(T R T) R^T v"),
    (r"(v^T \otimes \mathbf{I}_3) \operatorname{vec} T = %s", r"T v", r"T^T v"),
    (r"\operatorname{vec} M = %s", r"\operatorname{vec}(2 M) - \operatorname{vec} M", r"\operatorname{vec}(2 M)"),
]  # fmt: skip


@pytest.mark.parametrize(("law", "true", "false"), LAWS)
def test_law_of_kronecker_products(law: str, true: str, false: str) -> None:
    assert check(law % true, SYMBOLS).outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
    verdict = check(law % false, SYMBOLS).outcome
    assert verdict in ((Outcome.REFUTED, Outcome.ILL_FORMED) if "x^T) x" in false else (Outcome.REFUTED,))


def test_sign_between_vectors_is_the_dyad() -> None:
    assert check(r"(v \otimes v) v = (v \cdot v) v", SYMBOLS).outcome is Outcome.PROVED


@pytest.mark.parametrize(
    ("formula", "asked"),
    [
        (r"v \otimes T = T", "of vectors it is the dyad"),
        (r"\mathbf{I} \otimes A = A", "how large is the 0 or I"),
        (r"\operatorname{vec} v = v", "it stacks the columns of a matrix"),
    ],
)
def test_open_meaning_of_the_signs_is_asked_about(formula: str, asked: str) -> None:
    with pytest.raises(ReadError, match=asked):
        check(formula, SYMBOLS)


def test_vec_of_a_quaternion_is_asked_about() -> None:
    with pytest.raises(ReadError, match="it stacks the columns of a matrix"):
        check(r"\operatorname{vec}(q) = v", {**SYMBOLS, "q": "hamilton quaternion"})
