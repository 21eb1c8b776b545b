"""The operator polynomials Pₙ(D) with aₙ = Pₙ v and Φₙ = Pₙ ω̃; Eqs. (36)-(40).

The coefficients are polynomials with integer coefficients in the letters ω̃, its first derivative, its
second, ..., which do not commute; D = d/dt stands on their right and passes a tensor by
D A = Ȧ + A D. Everything here is exact and holds for every motion; `OperatorPolynomial.apply` puts the
numbers of one motion in.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import comb
from typing import Any

import numpy as np
from numpy import matmul
from numpy.typing import ArrayLike

from workbench.algebra.dual_tensors import apply, skew
from workbench.kinematics.tensors import as_tensors, as_vectors

Word = tuple[int, ...]
"""A product of letters: (2, 0) is the second derivative of ω̃ times ω̃; () is the unit tensor I."""

OMEGA_TILDE = r"\tilde{\boldsymbol{\omega}}"
DOTS = ("", r"\dot", r"\ddot", r"\dddot", r"\ddddot")


class TensorPolynomial:
    """A polynomial with integer coefficients in the non-commuting letters ω̃, its derivative, ...

    Immutable, hashable; +, -, * (with another one or an int), == and `derivative`. `terms` maps each
    word to its coefficient, none of which is 0.
    """

    __slots__ = ("_terms",)

    def __init__(self, terms: Mapping[Any, int] | Iterable[tuple[Word, int]] = ()):
        total: dict[Word, int] = {}
        for word, coefficient in terms.items() if isinstance(terms, Mapping) else terms:
            total[word] = total.get(word, 0) + coefficient
        self._terms = {word: c for word, c in sorted(total.items()) if c != 0}

    @classmethod
    def letter(cls, derivative: int = 0) -> TensorPolynomial:
        """Returns the `derivative`-th time derivative of ω̃."""
        if derivative < 0:
            raise ValueError(f"derivative: expected an order >= 0, got {derivative}")
        return cls({(derivative,): 1})

    @classmethod
    def integer(cls, value: int) -> TensorPolynomial:
        """Returns value · I."""
        return cls({(): value})

    @property
    def terms(self) -> Mapping[Word, int]:
        return dict(self._terms)

    def derivative(self, order: int = 1) -> TensorPolynomial:
        """Returns the `order`-th time derivative, by the product rule letter by letter."""
        result = self
        for _ in range(order):
            result = TensorPolynomial(
                ((*word[:i], word[i] + 1, *word[i + 1 :]), c)
                for word, c in result._terms.items()
                for i in range(len(word))
            )
        return result

    def __add__(self, other: TensorPolynomial) -> TensorPolynomial:
        if not isinstance(other, TensorPolynomial):
            return NotImplemented
        return TensorPolynomial([*self._terms.items(), *other._terms.items()])

    def __neg__(self) -> TensorPolynomial:
        return self * -1

    def __sub__(self, other: TensorPolynomial) -> TensorPolynomial:
        return self + -other if isinstance(other, TensorPolynomial) else NotImplemented

    def __mul__(self, other: TensorPolynomial | int) -> TensorPolynomial:
        if isinstance(other, int):
            return TensorPolynomial((word, c * other) for word, c in self._terms.items())
        if not isinstance(other, TensorPolynomial):
            return NotImplemented
        return TensorPolynomial(
            (left + right, c * d) for left, c in self._terms.items() for right, d in other._terms.items()
        )

    def __rmul__(self, other: int) -> TensorPolynomial:
        return self * other if isinstance(other, int) else NotImplemented

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TensorPolynomial) and self._terms == other._terms

    def __hash__(self) -> int:
        return hash(tuple(self._terms.items()))

    def __bool__(self) -> bool:
        return bool(self._terms)

    def __repr__(self) -> str:
        return f"TensorPolynomial({self._terms})"

    def to_latex(self, symbol: str = OMEGA_TILDE) -> str:
        """Returns LaTeX: short words first, among equals the higher derivatives first, as in Eq. (40)."""
        order = sorted(self._terms, key=lambda word: (len(word), tuple(-k for k in word)))
        return _signed_sum([_term_latex(self._terms[w], _word_latex(w, symbol)) for w in order])


UNIT_SIGNS = {TensorPolynomial.integer(1): "", TensorPolynomial.integer(-1): "-"}


@dataclass(frozen=True)
class OperatorPolynomial:
    """A₀ + A₁ D + ... + A_m Dᵐ with D = d/dt on the right; Eq. (35).

    `coefficients` is (A₀, ..., A_m), lowest power first, without trailing zeros. +, -, and the
    product * of operators (one after the other, right one first), by D A = Ȧ + A D.
    """

    coefficients: tuple[TensorPolynomial, ...]

    def __post_init__(self) -> None:
        coefficients = list(self.coefficients)
        while coefficients and not coefficients[-1]:
            coefficients.pop()
        object.__setattr__(self, "coefficients", tuple(coefficients))

    @property
    def degree(self) -> int:
        """The highest power of D; -1 of the zero operator."""
        return len(self.coefficients) - 1

    def __add__(self, other: OperatorPolynomial) -> OperatorPolynomial:
        if not isinstance(other, OperatorPolynomial):
            return NotImplemented
        return OperatorPolynomial(
            tuple(self._at(k) + other._at(k) for k in range(max(self.degree, other.degree) + 1))
        )

    def __neg__(self) -> OperatorPolynomial:
        return OperatorPolynomial(tuple(-A for A in self.coefficients))

    def __sub__(self, other: OperatorPolynomial) -> OperatorPolynomial:
        return self + -other if isinstance(other, OperatorPolynomial) else NotImplemented

    def __mul__(self, other: OperatorPolynomial | int) -> OperatorPolynomial:
        if isinstance(other, int):
            return OperatorPolynomial(tuple(A * other for A in self.coefficients))
        if not isinstance(other, OperatorPolynomial):
            return NotImplemented
        product = [TensorPolynomial()] * max(self.degree + other.degree + 1, 0)
        for i, A in enumerate(self.coefficients):
            for j, B in enumerate(other.coefficients):
                for k in range(i + 1):  # Dⁱ B = Σₖ C(i,k) B⁽ᵏ⁾ Dⁱ⁻ᵏ
                    product[i - k + j] += comb(i, k) * (A * B.derivative(k))
        return OperatorPolynomial(tuple(product))

    def __rmul__(self, other: int) -> OperatorPolynomial:
        return self * other if isinstance(other, int) else NotImplemented

    def _at(self, power: int) -> TensorPolynomial:
        return self.coefficients[power] if power <= self.degree else TensorPolynomial()

    def of(self, X: TensorPolynomial) -> TensorPolynomial:
        """Returns the operator applied to a tensor: Σ A_k X⁽ᵏ⁾. (The product self * X would be an
        operator.)"""
        terms = (A * X.derivative(k) for k, A in enumerate(self.coefficients))
        return sum(terms, start=TensorPolynomial())

    def apply(self, omega: ArrayLike, x: ArrayLike) -> np.ndarray:
        """Returns the operator applied to the vector or tensor x of one motion (or of a batch of them).

        omega (N, ..., 3): ω and its derivatives; x (M, ..., 3) or a tensor x (M, ..., 3, 3) (taken
        for one if it has one axis more than omega): x and its derivatives. N and M must reach the
        derivatives that occur. So P(n).apply(omega, v) is aₙ, and with x = skew(omega) it is Φₙ.
        Raises ValueError for a wrong shape or too few derivatives.
        """
        omega = as_vectors(omega, "omega")
        is_tensor = np.ndim(x) == omega.ndim + 1
        x = as_tensors(x, "x") if is_tensor else as_vectors(x, "x")
        highest = max((k for A in self.coefficients for w in A.terms for k in w), default=-1)
        for name, array, needed in (("omega", omega, highest + 1), ("x", x, self.degree + 1)):
            if array.ndim < 2 or len(array) < max(needed, 1):
                raise ValueError(
                    f"{name}: expected at least {max(needed, 1)} derivatives (first axis, from 0), "
                    f"got shape {array.shape}"
                )
        act = matmul if is_tensor else apply
        letters = skew(omega)
        result = 0 * x[0] + act(0 * letters[0], x[0])
        for power, A in enumerate(self.coefficients):
            for word, coefficient in A.terms.items():
                value = x[power]
                for letter in reversed(word):
                    value = act(letters[letter], value)
                result = result + coefficient * value
        return result

    def to_latex(self, symbol: str = OMEGA_TILDE, operator: str = r"\mathbf{D}") -> str:
        r"""Returns LaTeX, highest power of D first, e.g. P₃: \mathbf{D}^2 + ω̃ \mathbf{D} + 2 ω̃' + ω̃² as in
        Eq. (40)."""
        pieces = []
        for power in range(self.degree, -1, -1):
            A = self.coefficients[power]
            if not A:
                continue
            inner = A.to_latex(symbol)
            if power == 0:
                pieces.append(inner)
                continue
            D = operator if power == 1 else f"{operator}^{_exponent(power)}"
            if A in UNIT_SIGNS:
                pieces.append(UNIT_SIGNS[A] + D)
            elif len(A.terms) > 1:
                pieces.append(f"({inner}){D}")
            else:
                pieces.append(inner.removesuffix(r"\mathbf{I}") + D)
        return _signed_sum(pieces)

    def _repr_latex_(self) -> str:
        return f"${self.to_latex()}$"

    def __str__(self) -> str:
        return self.to_latex()


D = OperatorPolynomial((TensorPolynomial(), TensorPolynomial.integer(1)))
"""d/dt."""

I = OperatorPolynomial((TensorPolynomial.integer(1),))  # noqa: E741
"""The unit operator."""


def multiplication(A: TensorPolynomial) -> OperatorPolynomial:
    """Returns the operator x ↦ A x."""
    return OperatorPolynomial((A,))


@lru_cache(maxsize=64)
def P(n: int) -> OperatorPolynomial:
    """Returns Pₙ with aₙ = Pₙ v and Φₙ = Pₙ ω̃, n >= 1: P₁ = I, Pₙ₊₁ = D Pₙ + (Pₙ ω̃); Eq. (39).

    The bracket is the tensor Φₙ as a factor, not the product of operators Pₙ * ω̃. Pₙ has degree
    n - 1 and about 2ⁿ terms. Raises ValueError unless n is an integer >= 1 (Eq. (37), which starts at
    P₀ = I, does not give Ψₙ = Pₙ Ψ₁).

    >>> print(P(2)._repr_latex_())
    $\\mathbf{D} + \\tilde{\\boldsymbol{\\omega}}$
    """
    if not isinstance(n, int) or n < 1:
        raise ValueError(f"n: expected an integer >= 1, got {n!r}")
    if n == 1:
        return I
    return D * P(n - 1) + multiplication(P(n - 1).of(TensorPolynomial.letter()))


def _word_latex(word: Word, symbol: str) -> str:
    text, i = "", 0
    while i < len(word):
        run = 1
        while i + run < len(word) and word[i + run] == word[i]:
            run += 1
        text += _letter_latex(word[i], run, symbol)
        i += run
    return text or r"\mathbf{I}"


def _letter_latex(derivative: int, power: int, symbol: str) -> str:
    if derivative < len(DOTS):
        letter = f"{DOTS[derivative]}{{{symbol}}}" if derivative else symbol
    else:
        letter = f"{symbol}^{{({derivative})}}"
        letter = letter if power == 1 else f"\\left({letter}\\right)"
    return letter if power == 1 else f"{letter}^{_exponent(power)}"


def _exponent(power: int) -> str:
    return str(power) if power < 10 else f"{{{power}}}"


def _term_latex(coefficient: int, word: str) -> str:
    return {1: word, -1: "-" + word}.get(coefficient, f"{coefficient}{word}")


def _signed_sum(pieces: list[str]) -> str:
    if not pieces:
        return "0"
    joined = pieces[0]
    for piece in pieces[1:]:
        joined += f" - {piece[1:]}" if piece.startswith("-") else f" + {piece}"
    return joined
