"""Statements, their conditions, and the zeros, units and signs in them: as they are printed, or why not."""

from __future__ import annotations

import pytest

from tests.language.as_read import reads


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\lambda, x", r"refused 1: expected a relation (= or \neq), got an expression"),
        (r"\lambda \approx 0", r"refused 9: \approx: an approximation is not read unless symbo"),
        (r"\lambda = 0 \neq 1", r"\lambda = 0 \neq 1"),
        (r"\lambda = 0, x = e", r"\lambda = 0 ;; x = e"),
        (r"\lambda = 0 \text{ and } x = e", r"\lambda = 0 ;; x = e"),
        (r"\lambda = 0 \Rightarrow x = e", r"\lambda = 0 \Rightarrow x = e"),
        (r"\lambda = 0 \Leftrightarrow x = e", r"\lambda = 0 \Leftrightarrow x = e"),
        (
            r"\lambda = 0 \Leftrightarrow x = e \Leftrightarrow x = y",
            r"\lambda = 0 \Leftrightarrow x = e, \quad x = e \Leftrightarrow x = y",
        ),
        (
            r"\lambda = 0 \Leftrightarrow x = e \Rightarrow x = y",
            r"\lambda = 0 \Leftrightarrow x = e, \quad x = e \Rightarrow x = y",
        ),
        (
            r"\lambda = 0, x = e \Rightarrow x = y",
            r"refused 14: how far does the implication reach? join its condi",
        ),
        (r"\lambda = 0 \text{ if } x = e", r"x = e \Rightarrow \lambda = 0"),
        (r"\text{if } x = e \text{ then } \lambda = 0", r"x = e \Rightarrow \lambda = 0"),
        (
            r"\text{if } x = e, \lambda = 0, x = y",
            r"refused 12: conditions of nothing: write them behind what they",
        ),
        (r"\lambda = 1, x \neq 0, x = y", r"refused 14: a condition of what is before it, or of what follo"),
        (
            r"\lambda = 1, x = y, x \neq 0",
            r"x \neq \mathbf{0} \Rightarrow \lambda = 1 ;; x \neq \mathbf{0} \Rightarrow x = y",
        ),
        (
            r"x \neq 0, \lambda = 1, x = y",
            r"x \neq \mathbf{0} \Rightarrow \lambda = 1 ;; x \neq \mathbf{0} \Rightarrow x = y",
        ),
        (r"x \neq 0", r"x \neq \mathbf{0}"),
        (r"x \neq 0, \lambda \neq 0", r"x \neq \mathbf{0} ;; \lambda \neq 0"),
        (
            r"\lambda = \begin{cases} 0, & x = e \\ 1, & x \neq e \end{cases}",
            r"x = e \Rightarrow \lambda = 0 ;; x \neq e \Rightarrow \lambda = 1",
        ),
        (
            r"\lambda = \begin{cases} 0, & x = e \\ 1 \end{cases}",
            r"refused 39: expected a value and its condition on each line",
        ),
        (
            r"\lambda = \begin{cases} 0, & x = e, x = y \\ 1, & x \neq e \end{cases}",
            r"refused 25: expected a value and its condition on each line",
        ),
        (
            r"\lambda = \begin{cases} 0 & \text{if } x = e \\ 1 & \text{if } x \neq e \end{cases}",
            r"x = e \Rightarrow \lambda = 0 ;; x \neq e \Rightarrow \lambda = 1",
        ),
        (
            r"A = \begin{bmatrix} x \\ y \\ e \end{bmatrix}",
            r"refused 5: vectors below each other: the rows of a matrix? wr",
        ),
        (r"A = \begin{bmatrix} x & y & e \end{bmatrix}", r"A = \begin{bmatrix} x & y & e \end{bmatrix}"),
        (r"x \parallel y", r"x \times y = \mathbf{0}"),
        (r"x \perp y", r"x \cdot y = 0"),
        (r"x \parallel A", r"misfit 3: expected a vector, argument 2 is a tensor"),
        (r"q = x", r"q = \operatorname{quat}\left(0, x\right)"),
        (
            r"q = \begin{bmatrix} \lambda \\ x \end{bmatrix}",
            r"q = \operatorname{quat}\left(\lambda, x\right)",
        ),
        (
            r"\lambda = \begin{bmatrix} \lambda \\ x \end{bmatrix}",
            r"\operatorname{quat}\left(\lambda, \mathbf{0}\right) = \operatorname{quat}\left(\lambda, x\right)",
        ),
        (r"\lambda > 0", r"refused 1: expected an integer variable before the bound"),
        (r"\lambda", r"refused 1: expected a relation (= or \neq), got an expression"),
        (r"= \lambda", r"refused 1: unexpected ="),
    ],
)
def test_statements_and_their_conditions(latex: str, expected: str) -> None:
    reads(latex, expected)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"x = y = e", r"x = y = e"),
        (r"x = y = \mathbf{0}", r"x = y = \mathbf{0}"),
        (r"x = \mathbf{0} = y", r"x = \mathbf{0} = y"),
        (r"\mathbf{0} = x = y", r"\mathbf{0} = x = y"),
        (r"x = y \neq \mathbf{0}", r"x = y \neq \mathbf{0}"),
        (r"x \neq y = e", r"x \neq y = e"),
        (r"x \neq \mathbf{0} \neq y", r"x \neq \mathbf{0} \neq y"),
        (r"\lambda = 0 = 0", r"\lambda = 0 = 0"),
        (r"A = \mathbf{I} = R", r"A = \mathbf{I} = R"),
        (r"A = \mathbf{0}", r"A = \mathbf{0}"),
        (r"A = \mathbf{0} = R", r"A = \mathbf{0} = R"),
        (r"\mathbf{I} = A", r"\mathbf{I} = A"),
        (
            r"\mathbf{0}_{3 \times 3} = \mathbf{0}_{3 \times 3}",
            r"\mathbf{0}_{3 \times 3} = \mathbf{0}_{3 \times 3}",
        ),
        (r"A + \mathbf{I} = R + \mathbf{0}", r"A + \mathbf{I} = R + \mathbf{0}"),
        (r"x^T = \mathbf{0}", r"x^{T} = \mathbf{0}"),
        (r"x^T = y^T = \mathbf{0}", r"x^{T} = y^{T} = \mathbf{0}"),
        (r"x = \mathbf{0} = \mathbf{0}", r"x = \mathbf{0} = \mathbf{0}"),
        (r"\lambda + 0 = \lambda", r"\lambda + 0 = \lambda"),
        (r"x + \mathbf{0} = y", r"x + \mathbf{0} = y"),
        (
            r"H = \begin{bmatrix} A & x \\ \mathbf{0} & 1 \end{bmatrix}",
            r"H = \begin{bmatrix} A & x \\ \mathbf{0} & 1 \end{bmatrix}",
        ),
        (
            r"H = \begin{bmatrix} \mathbf{0} & x \\ y^{T} & 0 \end{bmatrix}",
            r"H = \begin{bmatrix} \mathbf{0} & x \\ y^{T} & 0 \end{bmatrix}",
        ),
        (
            r"H = \begin{bmatrix} A & \mathbf{0} \\ \mathbf{0} & \lambda \end{bmatrix}",
            r"H = \begin{bmatrix} A & \mathbf{0} \\ \mathbf{0} & \lambda \end{bmatrix}",
        ),
        (
            r"H = \begin{bmatrix} \mathbf{0}_{3 \times 3} & \mathbf{0} \\ \mathbf{0} & 1 \end{bmatrix}",
            r"H = \begin{bmatrix} \mathbf{0}_{3 \times 3} & \mathbf{0} \\ \mathbf{0}_{1 \times 3} & 1 \end{bmatrix}",
        ),
        (
            r"u = \begin{bmatrix} x \\ \mathbf{0} \end{bmatrix}",
            r"u = \begin{bmatrix} x \\ \mathbf{0} \end{bmatrix}",
        ),
        (
            r"u = \begin{bmatrix} \mathbf{0} \\ \mathbf{0} \end{bmatrix}",
            r"u = \begin{bmatrix} \mathbf{0} \\ \mathbf{0} \end{bmatrix}",
        ),
        (
            r"\begin{bmatrix} \mathbf{I} & \mathbf{0} \\ \mathbf{0} & \mathbf{I} \end{bmatrix} u = u",
            r"\begin{bmatrix} \mathbf{I} & \mathbf{0} \\ \mathbf{0} & \mathbf{I} \end{bmatrix} u = u",
        ),
        (
            r"\begin{bmatrix} A & \mathbf{0} \\ \mathbf{0} & \mathbf{I} \end{bmatrix} u = u",
            r"\begin{bmatrix} A & \mathbf{0} \\ \mathbf{0} & \mathbf{I} \end{bmatrix} u = u",
        ),
        (
            r"\begin{bmatrix} 0 & \lambda \\ 1 & 0 \end{bmatrix} = \mathbf{0}",
            r"\begin{bmatrix} 0 & \lambda \\ 1 & 0 \end{bmatrix} = \mathbf{0}",
        ),
        (
            r"\begin{bmatrix} 0 & 0 \\ 0 & 0 \end{bmatrix} \begin{bmatrix} \lambda \\ 1 \end{bmatrix} = \begin{bmatrix} 0 \\ 0 \end{bmatrix}",
            r"\begin{bmatrix} 0 & 0 \\ 0 & 0 \end{bmatrix} \begin{bmatrix} \lambda \\ 1 \end{bmatrix} = \begin{bmatrix} 0 \\ 0 \end{bmatrix}",
        ),
        (r"x \perp y, \lambda = 0", r"x \cdot y = 0 ;; \lambda = 0"),
        (r"x = y \text{ and } \lambda = 0", r"x = y ;; \lambda = 0"),
        (r"x = y \text{ and } y = e", r"x = y ;; y = e"),
        (r"x = y \text{ and } y = e \text{ and } \lambda = 0", r"x = y ;; y = e ;; \lambda = 0"),
        (r"(x = y \text{ and } \lambda = 0) \Rightarrow A = R", r"refused 8: unexpected and"),
        (
            r"x = y \text{ and } \lambda = 0 \Rightarrow A = R",
            r"x = y \text{ and } \lambda = 0 \Rightarrow A = R",
        ),
        (
            r"A = R \text{ if } x = y \text{ and } \lambda = 0",
            r"x = y \text{ and } \lambda = 0 \Rightarrow A = R",
        ),
        (
            r"x = y \Leftrightarrow \lambda = 0, \quad A \neq \mathbf{0}",
            r"x = y \Leftrightarrow \lambda = 0 \text{ for } A \neq \mathbf{0}",
        ),
        (
            r"x = y, \lambda \neq 0, A \neq \mathbf{0}",
            r"\lambda \neq 0 \text{ and } A \neq \mathbf{0} \Rightarrow x = y",
        ),
        (r"x \approx y", r"refused 3: \approx: an approximation is not read unless symbo"),
        (r"z_{n} = x, n \geq 1", r"z_{n} = x ;; n 1 None False"),
        (
            r"q = \begin{bmatrix} \lambda \\ x \end{bmatrix} = \operatorname{quat}(0, y)",
            r"q = \operatorname{quat}\left(\lambda, x\right) = \operatorname{quat}\left(0, y\right)",
        ),
        (r"J = \mathbf{0}", r"J = \mathbf{0}"),
        (r"J^T J = \mathbf{0}", r"J^{T} J = \mathbf{0}"),
        (r"u^T u = 0", r"u^{T} u = 0"),
        (r"\mathbf{0} x = y", r"refused 12: of vectors, or of quaternions? write \cdot, \times"),
        (r"\lambda \mathbf{0} = y", r"\lambda \mathbf{0} = y"),
        (r"A \mathbf{0} = y", r"A \mathbf{0} = y"),
        (r"2 \mathbf{I} = A", r"2 \mathbf{I} = A"),
        (r"-\mathbf{I} = A", r"-\mathbf{I} = A"),
        (r"\mathbf{I}^T = A", r"\mathbf{I}^{T} = A"),
        (r"x \times \mathbf{0} = y", r"x \times \mathbf{0} = y"),
        (r"x \cdot \mathbf{0} = \lambda", r"x \cdot \mathbf{0} = \lambda"),
        (r"x \otimes \mathbf{0} = A", r"x \otimes \mathbf{0} = A"),
        (r"\tilde{0} = A", r"\widetilde{\mathbf{0}} = A"),
        (r"\tilde{\mathbf{0}} = A", r"\widetilde{\mathbf{0}} = A"),
        (r"\operatorname{vect} \mathbf{0} = x", r"misfit 1: expected a tensor, got a vector"),
        (r"\operatorname{tr} \mathbf{I} = 3", r"\operatorname{trace}\left(\mathbf{I}\right) = 3"),
        (r"\det \mathbf{I} = 1", r"\det\left(\mathbf{I}\right) = 1"),
        (r"\lambda = -1", r"\lambda = -1"),
        (r"\lambda = -\frac{1}{2}", r"\lambda = -\frac{1}{2}"),
        (r"\lambda = 2 - 1", r"\lambda = 2 - 1"),
        (r"\lambda = -(-1)", r"\lambda = -\left(-1\right)"),
        (r"\lambda = -(2) \lambda", r"\lambda = -2 \lambda"),
        (r"\lambda = 1 - (-1)", r"\lambda = 1 - \left(-1\right)"),
        (r"\lambda = \frac{-1}{\lambda}", r"\lambda = \frac{-1}{\lambda}"),
    ],
)
def test_statements_with_zeros_units_and_signs(latex: str, expected: str) -> None:
    reads(latex, expected)
