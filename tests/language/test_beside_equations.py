"""What stands beside equations and between them: ranges, sums, least values, conditions, sets; each as it is read, or why not."""

from __future__ import annotations

import re

import pytest

from workbench import check
from workbench.judge.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula
from workbench.language.typed.errors import IllFormedAt, ReadError

KINDS = {
    r"\lambda": "scalar",
    r"\underline{s}": "dual scalar",
    "x": "vector",
    "y": "vector",
    "z_n": "vector",
    r"\underline{x}": "dual vector",
}
KINDS |= {
    "A": "tensor",
    r"\underline{A}": "dual tensor",
    "R": "rotation",
    r"\underline{R}": "dual rotation",
    "g": "transform",
}
KINDS |= {"H": "matrix 4×4", "u": "matrix 6×1", "J": "matrix 6×7", "q": "hamilton quaternion"}
UNIT = {"e": {"kind": "vector", "unit": True}}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()} | UNIT)


def said(latex: str) -> str:
    """Its statements, and for each range the variable, its bounds, and whether it is any."""
    found = read_formula(latex, TABLE)
    ranges = (f"{r.variable} {r.lower} {r.upper} {r.generic}" for r in found.ranges)
    return " ;; ".join([*map(to_latex, found.statements), *ranges])


def reads(latex: str, expected: str) -> None:
    verdict, _, told = expected.partition(" ")
    if verdict in ("refused", "misfit"):
        with pytest.raises(
            ReadError if verdict == "refused" else IllFormedAt, match=re.escape(f"column {told}")
        ):
            read_formula(latex, TABLE)
    else:
        assert said(latex) == expected


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\lambda = \lambda, n \geq 1", r"\lambda = \lambda ;; n 1 None False"),
        (r"\lambda = \lambda, n > 1", r"\lambda = \lambda ;; n 2 None False"),
        (r"\lambda = \lambda, n \in \mathbb{N}", r"\lambda = \lambda ;; n 0 None False"),
        (r"\lambda = \lambda, n \in \mathbb{N}^*", r"\lambda = \lambda ;; n 1 None False"),
        (r"\lambda = \lambda, n \in \mathbb{N}^{*}", r"\lambda = \lambda ;; n 1 None False"),
        (r"\lambda = \lambda, n, m \in \mathbb{N}", r"\lambda = \lambda ;; n 0 None False ;; m 0 None False"),
        (r"\lambda = \lambda, n = 3", r"\lambda = \lambda ;; n 3 3 False"),
        (r"\lambda = \lambda, n = \overline{1, 5}", r"\lambda = \lambda ;; n 1 5 False"),
        (r"\lambda = \lambda, n = \overline{1, m}", r"\lambda = \lambda ;; n 1 m False"),
        (r"\lambda = \lambda, n = \overline{1, m - 1}", r"\lambda = \lambda ;; n 1 m-1 False"),
        (r"\lambda = \lambda, n \geq m", r"\lambda = \lambda ;; n m None False"),
        (r"\lambda = \lambda, n \geq m + 1", r"\lambda = \lambda ;; n m+1 None False"),
        (r"\lambda = \lambda, n > m", r"\lambda = \lambda ;; n m+1 None False"),
        (
            r"\lambda = \lambda, n \geq 1 \geq 0",
            r"refused 29: expected one range, such as n \geq 1 or n \in \mat",
        ),
        (r"\lambda = \lambda, n \geq \lambda", r"refused 27: expected an integer bound"),
        (r"\lambda = \lambda, n \geq 2 m", r"refused 27: expected an integer bound"),
        (r"\lambda = \lambda, \lambda \geq 1", r"refused 20: expected an integer variable before the bound"),
        (
            r"\lambda = \lambda, x \in \mathbb{N}",
            r"refused 20: x is a symbol; what is assumed of symbols is writt",
        ),
        (
            r"\lambda = \lambda, \lambda, n \in \mathbb{N}",
            r"refused 20: expected integer variables before \in",
        ),
        (r"\lambda = \lambda, n \geq x", r"refused 27: expected an integer bound"),
        (r"\lambda = \lambda, 1 \geq n", r"refused 20: expected an integer variable before the bound"),
        (
            r"\lambda = \lambda, n, m \geq 1",
            r"refused 20: expected a relation (= or \neq), got an expression",
        ),
        (r"\lambda = \lambda, \mathbf{n} \geq 1", r"\lambda = \lambda ;; n 1 None False"),
        (r"\lambda = \lambda, n_1 \geq 1", r"\lambda = \lambda ;; n_1 1 None False"),
        (r"\lambda = \lambda, n = 1 = 2", r"refused 20: unknown symbol n"),
        (r"\lambda = \lambda, \lambda \neq 0", r"\lambda \neq 0 \Rightarrow \lambda = \lambda"),
        (r"\lambda = \lambda, x \neq 0", r"x \neq \mathbf{0} \Rightarrow \lambda = \lambda"),
        (r"\lambda = \lambda, n \neq m", r"refused 20: unknown symbol n"),
        (r"\lambda = \lambda, \forall n \in \mathbb{N}", r"\lambda = \lambda ;; n 0 None False"),
        (r"\lambda = \lambda, \forall x", r"refused 28: expected a relation (= or \neq), got an expression"),
        (r"\lambda = \lambda, \forall x \in \mathbf{V}_3", r"\lambda = \lambda"),
        (r"\lambda = \lambda, \forall x = e", r"x = e \Rightarrow \lambda = \lambda"),
        (r"\lambda = \lambda, x = e", r"\lambda = \lambda ;; x = e"),
        (r"z_i = x, \forall i \neq 1, i = \overline{1, 3}", r"i \neq 1 \Rightarrow z_{i} = x ;; i 1 3 False"),
        (r"\lambda = \lambda, \forall n = m", r"\lambda = \lambda ;; n m m False"),
        (r"\lambda = \lambda, \forall n \neq m", r"refused 28: unknown symbol n"),
        (r"n \geq 1", r"refused 1: the formula says nothing"),
        (r"\lambda = \lambda, x", r"refused 20: expected a relation (= or \neq), got an expression"),
        (r"z_i = x, i \in \mathbb{N}", r"z_{i} = x ;; i 0 None False"),
        (r"z_i = z_j, i = j", r"i = j \Rightarrow z_{i} = z_{j} ;; i 1 3 True ;; j 1 3 True"),
        (r"z_i = z_j, i \neq j", r"i \neq j \Rightarrow z_{i} = z_{j} ;; i 1 3 True ;; j 1 3 True"),
        (
            r"z_i \cdot z_j = 0, \forall i \neq j",
            r"i \neq j \Rightarrow z_{i} \cdot z_{j} = 0 ;; i 1 3 True ;; j 1 3 True",
        ),
    ],
)
def test_ranges(latex: str, expected: str) -> None:
    reads(latex, expected)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\sum_{k=0}^{n} z_k = x, n \geq 1", r"\sum_{k=0}^{n} z_{k} = x ;; n 1 None False"),
        (r"\sum_{k=0}^{\infty} z_k = x", r"refused 12: an infinite sum; sums have integer bounds"),
        (r"\sum_{k=0} z_k = x", r"refused 1: the sum has no upper bound"),
        (r"\sum_{k} z_k = x", r"\sum_{k=1}^{N} z_{k} = x ;; N 1 3 True"),
        (r"\sum_k^m z_k = x", r"\sum_{k=1}^{m} z_{k} = x ;; m 1 3 True"),
        (r"\sum_{k} x = x", r"refused 1: a sum without bounds is not read; expected the bou"),
        (r"\sum z_k = x", r"refused 1: a sum without bounds is not read; expected the bou"),
        (r"\sum^m z_k = x", r"refused 1: expected the bounds of the sum, as in \sum_{k=0}^{"),
        (r"\sum_{i+j=3} z_i = x", r"\sum_{i+j=3} z_{i} = x"),
        (r"\sum_{i+j=m} z_i = x, m \geq 1", r"\sum_{i+j=m} z_{i} = x ;; m 1 None False"),
        (r"\sum_{i+j=m}^3 z_i = x, m \geq 1", r"refused 14: a sum over k_1 + k_2 + … = k has no upper bound"),
        (r"\sum_{i-j=m} z_i = x, m \geq 1", r"refused 7: expected summation variables, as in k_1 + k_2 = k"),
        (
            r"\sum_{i+\lambda=m} z_i = x, m \geq 1",
            r"refused 7: expected summation variables, as in k_1 + k_2 = k",
        ),
        (r"\sum_{k \geq 1} z_k = x", r"refused 1: a sum without bounds is not read; expected the bou"),
        (r"\sum_{k=0=1}^{m} z_k = x", r"refused 1: expected the bounds of the sum, as in \sum_{k=0}^{"),
        (r"\sum_{k=1}^{N_P} z_k = x", r"\sum_{k=1}^{N_P} z_{k} = x ;; N_P 1 3 True"),
        (r"\sum_{k=1}^{N_p} z_k = x", r"refused 12: expected an integer expression; integer variables"),
        (r"\sum_{k=1}^{Q_P} z_k = x", r"refused 12: expected an integer expression; integer variables"),
        (r"\sum_{k=1}^{N_P^2} z_k = x", r"refused 12: expected an integer expression; integer variables"),
        (r"\sum_{k=1}^{m} z_k = x", r"\sum_{k=1}^{m} z_{k} = x ;; m 1 3 True"),
        (r"\sum_{k=1}^{m+1} z_k = x, m \geq 1", r"\sum_{k=1}^{m+1} z_{k} = x ;; m 1 None False"),
        (r"\sum_{k=1}^{\lambda} z_k = x", r"refused 12: expected an integer expression; integer variables"),
        (r"\sum_{k=\lambda}^{3} z_k = x", r"refused 9: expected an integer expression; integer variables"),
        (
            r"\sum_{k=1}^{3} \sum_{k=1}^{3} z_k = x",
            r"refused 16: the summation variable k already has a meaning her",
        ),
        (
            r"\sum_{\lambda=1}^{3} z_\lambda = x",
            r"refused 7: expected summation variables, as in k_1 + k_2 = k",
        ),
    ],
)
def test_sums(latex: str, expected: str) -> None:
    reads(latex, expected)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\min_{x \in \mathbf{V}_3} x \cdot x = 0", r"\min_{x \in \mathbf{V}_{3}} x \cdot x = 0"),
        (
            r"\max_{x \in \mathbf{V}_3} x \cdot x = \lambda",
            r"\max_{x \in \mathbf{V}_{3}} x \cdot x = \lambda",
        ),
        (
            r"\min_{y, x \in \mathbf{V}_3} x \cdot y = 0",
            r"\min_{y \in \mathbf{V}_{3}, x \in \mathbf{V}_{3}} x \cdot y = 0",
        ),
        (r"\min_{a \in \mathbf{V}_3} a \cdot y = 0", r"\min_{a \in \mathbf{V}_{3}} a \cdot y = 0"),
        (r"\min_{a \in \mathbb{R}} a = 0", r"\min_{a \in \mathbb{R}} a = 0"),
        (r"\min_{a \in \mathbb{S}^2} a \cdot y = 0", r"\min_{a \in \mathbb{S}^{2}} a \cdot y = 0"),
        (r"\min_{e \in \mathbb{S}^2} e \cdot y = 0", r"\min_{e \in \mathbb{S}^{2}} e \cdot y = 0"),
        (
            r"\min_{x \in \mathbb{S}^2} x \cdot y = 0",
            r"refused 7: x is declared as another thing than what varies he",
        ),
        (
            r"\min_{e \in \mathbf{V}_3} e \cdot y = 0",
            r"refused 7: e is declared as another thing than what varies he",
        ),
        (r"\min_{a \in SO(3)} \lambda = 0", r"refused 7: a minimum or maximum over SO_{3}; known: ℝ, V_3, a"),
        (
            r"\min_{a \in \mathbf{V}_3, \lambda \in \mathbb{R}} a \cdot y = 0",
            r"\min_{a \in \mathbf{V}_{3}, \lambda \in \mathbb{R}} a \cdot y = 0",
        ),
        (r"\min_{a} \lambda = 0", r"refused 7: over which set? expected a letter and its set, as"),
        (r"\min_{x} x \cdot x = 0", r"\min_{x \in \mathbf{V}_{3}} x \cdot x = 0"),
        (r"\min_x x \cdot x = 0", r"\min_{x \in \mathbf{V}_{3}} x \cdot x = 0"),
        (r"\min_{x = 1} \lambda = 0", r"refused 7: a condition under a minimum or maximum; expected l"),
        (r"\min x \cdot x = 0", r"refused 1: a minimum over what? write it under the sign, as i"),
        (r"\min_{x \in \mathbf{V}_3} x = 0", r"misfit 1: the least or greatest of a vector; expected a real"),
        (
            r"\min_{x \in \mathbf{V}_3} \underline{s} = 0",
            r"misfit 1: the least or greatest of a dual scalar; expected a",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} x \cdot x = y",
            r"misfit 1: what is least or greatest is a scalar, and the oth",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} x \cdot x = x \cdot x",
            r"misfit 1: what a minimum or maximum is taken over stands on",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} \min_{y \in \mathbf{V}_3} x \cdot x = 0",
            r"refused 1: a minimum or maximum within another one",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} + x \cdot x = 0",
            r"refused 1: a minimum or maximum stands alone on a side of an",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} \cdot x = 0",
            r"refused 27: nothing between a minimum or maximum and the sign",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} x \cdot x \neq 0",
            r"refused 37: a minimum or maximum is said to be equal to someth",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} x \cdot x = \max_{y \in \mathbf{V}_3} y \cdot y",
            r"refused 1: of a minimum or maximum a formula says what it is:",
        ),
        (
            r"\min_{x \in \mathbf{V}_3} x \cdot x = \max_{y \in \mathbf{V}_3} y \cdot y = 0",
            r"\min_{x \in \mathbf{V}_{3}} x \cdot x = 0, \quad \max_{y \in \mathbf{V}_{3}} y \cdot y = 0",
        ),
        (r"\min_{A} \lambda = 0", r"refused 7: A is declared as another thing than what varies he"),
        (
            r"\min_{x^2 \in \mathbf{V}_3} \lambda = 0",
            r"refused 7: expected a letter, such as x, under a minimum or m",
        ),
    ],
)
def test_least_and_greatest_values(latex: str, expected: str) -> None:
    reads(latex, expected)


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


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\delta_i = 0, \forall i \neq 3, i = \overline{1, 3}", Outcome.REFUTED),
        (r"\delta_i^2 = 0, \forall i \neq 3, i = \overline{1, 3}", Outcome.REFUTED),
        (r"\delta_i^2 = 0, \forall i \neq 1", None),
    ],
)
def test_for_all_indices_but_one_is_no_range_from_it_on(formula: str, outcome: Outcome | None) -> None:
    known = [r"\delta_1 = 1", r"\delta_2 = 0", r"\delta_3 = 0"]
    if outcome is None:
        with pytest.raises(ReadError, match="has no range here"):
            check(formula, {r"\delta_n": "scalar"}, definitions=known)
    else:
        assert check(formula, {r"\delta_n": "scalar"}, definitions=known).verdict.outcome == outcome


#: A set, what a member of it is called, which of the terms are declared to be in it, and for which it is a claim.
TRIVIAL, CLAIMS = (
    {
        r"\mathbb{R}": r"\lambda",
        r"\mathbb{R}^3": "x e xe",
        r"\mathbf{V}_3": "x e xe",
        r"SO(3)": "R",
        r"\mathbf{SO}_3": "R",
        r"SE(3)": "g",
        r"\mathfrak{so}_3": "~x",
        r"\mathfrak{se}(3)": "",
        r"\mathbb{S}^2": "e",
        r"\mathbb{R}^6": "u",
        r"\mathbb{R}^{6 \times 7}": "J",
        r"\mathbb{R}^{n}": r"\lambda x e u xe",
        r"\mathbb{R}^{m \times n}": r"\lambda x e A R g H u J ~x AA xe Rx",
        r"\underline{\mathbf{V}}_3": r"x e \underline{x} xe",
        r"\underline{\mathbf{SO}}_3": r"R \underline{R}",
    },
    {
        r"SO(3)": "~x AA",
        r"\mathbf{SO}_3": "~x AA",
        r"SE(3)": "Rx",
        r"\mathfrak{so}_3": "AA",
        r"\mathfrak{se}(3)": "Rx",
        r"\mathbb{S}^2": "xe",
        r"\underline{\mathbf{SO}}_3": "~x AA",
    },
)
TERMS = {
    each: each
    for each in (r"\lambda", "x", "e", r"\underline{x}", "A", "R", r"\underline{R}", "g", "H", "u", "J", "q")
}
TERMS |= {
    "~x": r"\tilde{x}",
    "AA": r"A^{T} A",
    "xe": r"x \times e",
    "Rx": r"\begin{bmatrix} R & x \\ \mathbf{0} & 1 \end{bmatrix}",
}


@pytest.mark.parametrize("where", TRIVIAL)
@pytest.mark.parametrize("term", TERMS)
def test_members_of_sets(where: str, term: str) -> None:
    formula = rf"{TERMS[term]} \in {where}"
    if term in TRIVIAL[where].split():
        reads(formula, "refused 1: the formula says nothing")
        assert said(rf"{formula}, \quad \lambda = 0") == r"\lambda = 0"
        return
    if term in CLAIMS.get(where, "").split():
        assert all(TERMS[term] in part or r"\mathbf{I}" in part for part in said(formula).split(" ;; "))
    else:
        reads(formula, "refused 1: a member of ")
    reads(rf"{formula}, \quad \lambda = 0", "refused 1: a member of ")


X = r"\tilde{x}"


@pytest.mark.parametrize(
    ("formula", "claims"),
    [
        (
            r"A^T A \in SO(3)",
            [r"\left(A^{T} A\right)^{T} \left(A^{T} A\right) = \mathbf{I}", r"\det\left(A^{T} A\right) = 1"],
        ),
        (r"\tilde{x} \in SO(3)", [rf"{X}^{{T}} {X} = \mathbf{{I}}", rf"\det {X} = 1"]),
        (r"A^T A \in \mathfrak{so}_3", [r"\left(A^{T} A\right)^{T} = -A^{T} A"]),
        (r"x \times e \in \mathbb{S}^2", [r"\left(x \times e\right) \cdot \left(x \times e\right) = 1"]),
    ],
)
def test_what_makes_a_term_a_member(formula: str, claims: list[str]) -> None:
    assert said(formula).split(" ;; ") == claims


@pytest.mark.parametrize(
    ("matrix", "where", "outcome"),
    [
        (r"R & x \\ 0 & 1", "SE(3)", Outcome.PROVED),
        (r"R^T & x \\ 0 & 1", "SE(3)", Outcome.PROVED),
        (r"2 R & x \\ 0 & 1", "SE(3)", Outcome.REFUTED),
        (r"-R & x \\ 0 & 1", "SE(3)", Outcome.REFUTED),
        (r"R & x \\ 0 & 2", "SE(3)", Outcome.REFUTED),
        (r"R & x \\ y^T & 1", "SE(3)", Outcome.REFUTED),
        (r"\tilde{y} & x \\ 0 & 0", r"\mathfrak{se}(3)", Outcome.PROVED),
        (r"\tilde{y} & x \\ 0 & 1", r"\mathfrak{se}(3)", Outcome.REFUTED),
        (r"\tilde{y} & x \\ y^T & 0", r"\mathfrak{se}(3)", Outcome.REFUTED),
        (r"A & x \\ 0 & 0", r"\mathfrak{se}(3)", Outcome.REFUTED),
    ],
)
def test_a_matrix_of_blocks_is_a_displacement_or_a_twist(matrix: str, where: str, outcome: Outcome) -> None:
    kinds = {"R": "rotation", "x": "vector", "y": "vector", "A": "tensor"}
    formula = rf"\begin{{bmatrix}} {matrix} \end{{bmatrix}} \in {where}"
    assert check(formula, kinds).verdict.outcome == outcome
