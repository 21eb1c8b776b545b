"""Ranges of integers, sums, least and greatest values: as they are read, or why not."""

from __future__ import annotations

import pytest

from tests.language.as_read import reads
from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome


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
