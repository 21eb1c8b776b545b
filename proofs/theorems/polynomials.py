"""Section 4: the ring of homogeneous matrices; the operators Pₙ, whether they are unique, where they begin.

An operator of degree m acts term by term, Σ Aₖ Dᵏ x = Σ Aₖ x⁽ᵏ⁾. So what is shown of one term A Dᵏ, with a
free A and a free y for x⁽ᵏ⁾, holds for the sum, of any degree.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from workbench.algebra.matrices import Matrix, add, flat, matrix, product, skew
from workbench.judge.arguments import Engine, Step, Way, argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Counterexample, Verdict

_TENSOR, _VECTOR = {"kind": "tensor"}, {"kind": "vector"}


def _homogeneous(tensor: str, vector: str) -> str:
    return rf"\begin{{bmatrix}} {tensor} & {vector} \\ \mathbf{{0}} & 0 \end{{bmatrix}}"


# A, B, C, Y: any elements of the ring (34). N has no tensor, L is [I c; 0 0], T the spatial twist Ψ₁.
_RING = Letters(
    {
        r"\omega": _VECTOR,
        **{letter: _TENSOR for letter in ("F", "G", "H", "K")},
        **{letter: _VECTOR for letter in ("f", "g", "h", "k", "c", "v", "x")},
    },
    {
        "A": _homogeneous("F", "f"),
        "B": _homogeneous("G", "g"),
        "C": _homogeneous("H", "h"),
        "Y": _homogeneous("K", "k"),
        "M": _homogeneous("G", "0"),
        "N": _homogeneous("0 F", "c"),
        "L": _homogeneous(r"\mathbf{I}", "c"),
        "E": _homogeneous(r"\mathbf{I}", "0"),
        "U": r"\begin{bmatrix} \mathbf{I} & 0 x \\ \mathbf{0} & 1 \end{bmatrix}",
        "T": _homogeneous(r"\tilde{\omega}", "v"),
        "Z": r"A T + B \dot{T}",
    },
)


def homogeneous_matrices_are_a_ring() -> Verdict:
    """(34): a ring, not commutative, with units on the left only."""
    return argue(
        [
            _RING.step(
                "sums, differences and products of matrices [Φ a; 0 0] are such matrices",
                "A + B = " + _homogeneous("F + G", "f + g"),
                "A - B = " + _homogeneous("F - G", "f - g"),
                "A B = " + _homogeneous("F G", "F g"),
                but_not="A B = " + _homogeneous("F G", "F g + f"),
            ),
            _RING.step(
                "the laws of associativity and distributivity hold",
                "(A B) C = A (B C)",
                "A (B + C) = A B + A C",
                "(A + B) C = A C + B C",
                but_not="A (B C) = (B A) C",
            ),
            _RING.step(
                "not commutative: M = [G 0; 0 0] and N = [0 c; 0 0] have N M = 0, but M N = [0 G c; 0 0]",
                "N M + A = A",
                "M N = " + _homogeneous("0 F", "G c"),
                but_not="M N + A = A",
            ),
            _RING.step(
                "[I c; 0 0] is a unit from the left, whatever c is",
                "L A = A",
                but_not="A L = A",
            ),
            _RING.step(
                "none is a unit U from the right: N U = 0 for all of them, and not N",
                "N Y + A = A",
                but_not="Y N + A = A",
            ),
        ]
    )


def operators_are_a_ring() -> Verdict:
    """(35) with D for X: sums are of this form, and products, by induction on the power of D on the left."""
    return argue(
        [
            _RING.step(
                "the derivative of a matrix of the ring is in the ring",
                r"\dot{A} = " + _homogeneous(r"\dot{F}", r"\dot{f}"),
                but_not=r"\dot{A} = " + _homogeneous(r"\dot{F}", "f"),
            ),
            _leibniz(),
            _RING.step(
                "so D (B Dʲ) = Ḃ Dʲ + B Dʲ⁺¹ goes on being of the form; twice, for example",
                r"\frac{d^2}{dt^2} (B Y) = \ddot{B} Y + 2 \dot{B} \dot{Y} + B \ddot{Y}",
                but_not=r"\frac{d^2}{dt^2} (B Y) = \ddot{B} Y + \dot{B} \dot{Y} + B \ddot{Y}",
            ),
            _RING.step(
                "and A (B Dʲ) = (A B) Dʲ, with A B in the ring",
                r"A (B Y) = \left( " + _homogeneous("F G", "F g") + r" \right) Y",
                but_not=r"A (B Y) = \left( " + _homogeneous("G F", "F g") + r" \right) Y",
            ),
        ]
    )


def _leibniz() -> Step:
    return _RING.step(
        "D (A Dᵏ) = Ȧ Dᵏ + A Dᵏ⁺¹: of any Y",
        r"\frac{d}{dt} (A Y) = \dot{A} Y + A \dot{Y}",
        but_not=r"\frac{d}{dt} (A Y) = \dot{A} Y + Y \dot{A}",
    )


def _recurrence() -> Step:
    return _RING.step(
        "D (A + B D) + Z with Z = A Ψ₁ + B Ψ̇₁ = Ψₙ makes Ψ̇ₙ + Ψₙ Ψ₁ = Ψₙ₊₁ of Ψ₁",
        r"\dot{A} T + A \dot{T} + \dot{B} \dot{T} + B \ddot{T} + Z T = \dot{Z} + Z T",
        but_not=r"A \dot{T} + B \ddot{T} + Z T = \dot{Z} + Z T",
    )


def twist_operator_recurrence() -> Verdict:
    """The recurrence of (37), by (33)."""
    return argue([_leibniz(), _recurrence()], scope="all n")


def twist_operator_exists() -> Verdict:
    """Theorem 2 by induction on n: P₁ = [I 0; 0 0], which is in the ring, and the recurrence of (37)."""
    begin = _RING.step("begin: P₁ = [I 0; 0 0] has P₁ Ψ₁ = Ψ₁", "E T = T", but_not="T E = T")
    inside = _RING.step(
        "the new coefficients Ȧ, A and Ψₙ are in the ring",
        r"\dot{A} = " + _homogeneous(r"\dot{F}", r"\dot{f}"),
        "A T = " + _homogeneous(r"F \tilde{\omega}", "F v"),
        but_not="A T = " + _homogeneous(r"F \tilde{\omega}", "F v + f"),
    )
    return argue([begin, _leibniz(), _recurrence(), inside], scope="all n")


def twist_operator_is_not_unique() -> Verdict:
    """The second polynomial: Pₙ + [0 c; 0 0] Dʲ for any c and j."""
    return argue(
        [
            _RING.step(
                "[0 c; 0 0] Y = 0 for every Y of the ring, so for Ψ₁ and its derivatives",
                "N Y + A = A",
                r"N T + N \dot{T} + A = A",
                but_not="Y N + A = A",
            ),
            _RING.step(
                "both [I 0; 0 0] and [I c; 0 0] have the value Ψ₁",
                "E T = T",
                "L T = T",
                "L - E = N",
                but_not="L = E",
            ),
        ],
        refutes=True,
        reason="for every motion and every n there are others",
        counterexample=Counterexample(
            values={
                r"\mathbf{P}_1": _strings(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0),
                r"\mathbf{P}'_1": _strings(1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0),
                r"\omega": _strings(0, 0, 1),
                r"\mathbf{v}": _strings(1, 0, 0),
                r"\mathbf{P}_1 \Psi_1 = \mathbf{P}'_1 \Psi_1": _strings(
                    0, -1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
                ),
            },
            left=_strings(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0),
            right=_strings(1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0),
        ),
    )


_REST = Letters(
    {
        r"\mathbf{R}": {"kind": "rotation"},
        r"\mathbf{Q}": {"kind": "rotation", "constant": True},
        "p": {"kind": "vector", "constant": True},
        **{letter: _VECTOR for letter in (r"\rho", "f", "k")},
        **{letter: _TENSOR for letter in ("F", "K")},
    },
    {
        "A": _homogeneous("F", "f"),
        "B": _homogeneous("K", "k"),
        "S": _homogeneous(r"\dot{\mathbf{Q}} \mathbf{Q}^T", r"\dot{p} - \dot{\mathbf{Q}} \mathbf{Q}^T p"),
    },
)


def no_operator_for_n_0() -> Verdict:
    """(36) for n = 0: Ψ₀ is [I 0; 0 0] for every motion, P(D) Ψ₁ is 0 for every P if the body is at rest."""
    return argue(
        [
            _REST.step(
                "Φ₀ = R Rᵀ = I and a₀ = ρ − Φ₀ ρ = 0, whatever the motion is",
                r"\mathbf{R} \mathbf{R}^T = \mathbf{I}",
                r"\rho - \mathbf{R} \mathbf{R}^T \rho = \mathbf{0}",
                but_not=r"\dot{\mathbf{R}} \mathbf{R}^T = \mathbf{I}",
            ),
            _REST.step(
                "at rest A Ψ₁⁽ᵏ⁾ = 0 for every A",
                "A S + B = B",
                r"A \dot{S} + B = B",
                but_not="B A + B = B",
            ),
        ],
        refutes=True,
        reason="for n = 0: false for a body at rest",
        counterexample=Counterexample(
            values={r"\mathbf{R}": _strings(1, 0, 0, 0, 1, 0, 0, 0, 1), r"\Psi_1": _strings(*[0] * 16)},
            left=_strings(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0),
            right=_strings(*[0] * 16),
        ),
    )


def twist_operator_begins_at_1() -> Verdict:
    """(37) with P₀ = I: then P₁ Ψ₁ is Ψ₂, by the recurrence Pₙ Ψ₁ is Ψₙ₊₁, and Ψ₂ need not be Ψ₁."""
    return argue(
        [
            _RING.step(
                "P₀ = I has P₀ Ψ₁ = Ψ₁, where (36) has Ψ₀",
                "U T = T",
                but_not="T U = E",
            ),
            _recurrence(),
            _RING.step(
                "the next one, P₁ = D + Ψ₁, makes Ψ₂ as in (42) of Ψ₁",
                r"\dot{T} + T T = "
                + _homogeneous(r"\dot{\tilde{\omega}} + \tilde{\omega}^2", r"\dot{v} + \tilde{\omega} v"),
                but_not=r"\dot{T} + T T = T",
            ),
            _steady_rotation(),
        ],
        refutes=True,
        reason="P₀ = I makes Ψₙ₊₁ of Ψ₁",
        counterexample=Counterexample(
            values={
                r"\omega": _strings(0, 0, 1),
                r"\dot{\omega}": _strings(0, 0, 0),
                r"\mathbf{v}": _strings(0, 0, 0),
                r"\dot{\mathbf{v}}": _strings(0, 0, 0),
            },
            left=_strings(0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
            right=_strings(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
        ),
    )


def _steady_rotation() -> Step:
    """ω = e₃ constant and v = 0: Ψ₁ and Ψ₂ have the tensors ω̃ and ω̃², which differ."""

    def differ(other: Callable[[Matrix], Matrix]) -> Iterator[bool]:
        first = skew((Fraction(0), Fraction(0), Fraction(1)))
        yield flat(first) != flat(other(first))

    def differ_in_sympy(power: int) -> Iterator[bool]:
        from sympy import Matrix as SympyMatrix
        from sympy import eye

        omega = SympyMatrix([0, 0, 1])
        first = SympyMatrix.hstack(*(omega.cross(eye(3)[:, j]) for j in range(3)))
        yield first != first**power

    return Step(
        "and Ψ₂ is not Ψ₁: ω̃² is not ω̃ for the steady rotation ω = (0, 0, 1)",
        Way(
            Engine.FRACTIONS,
            lambda: differ(lambda a: product(a, a)),
            but_not=lambda: differ(lambda a: add(a, matrix([Fraction(0)] * 9, 3))),
        ),
        Way(Engine.SYMPY, lambda: differ_in_sympy(2), but_not=lambda: differ_in_sympy(5)),
        by_example=True,
    )


# y and Y: v⁽ᵏ⁾ and ω̃⁽ᵏ⁾, on which the term A Dᵏ of an operator acts; a second term has B and D.
_TENSORS = Letters(
    {
        r"\omega": _VECTOR,
        **{letter: _TENSOR for letter in ("A", "B", "C", "Y", "F", "W")},
        **{letter: _VECTOR for letter in ("v", "y", "b", "c", "x", "z", "f", "w")},
    },
    {
        r"\Phi": r"A \tilde{\omega} + B \dot{\tilde{\omega}}",
        "a": r"A v + B \dot{v}",
        "q(x, y, z)": "A x + B y + C z",
    },
)


def operator_polynomial_exists() -> Verdict:
    """Theorem 3, existence, by induction on n from P₁ = I with the recurrences (39) and (20)."""
    return argue(
        [
            _TENSORS.step(
                "begin: P₁ = I has P₁ v = v = a₁ and P₁ ω̃ = ω̃ = Φ₁",
                r"\mathbf{I} v = v",
                r"\mathbf{I} \tilde{\omega} = \tilde{\omega}",
                but_not=r"\mathbf{I} v = \dot{v}",
            ),
            _TENSORS.step(
                "D (A Dᵏ) = Ȧ Dᵏ + A Dᵏ⁺¹, of v and of ω̃",
                r"\frac{d}{dt} (A y) = \dot{A} y + A \dot{y}",
                r"\frac{d}{dt} (A Y) = \dot{A} Y + A \dot{Y}",
                but_not=r"\frac{d}{dt} (A y) = \dot{A} y + \dot{A} \dot{y}",
            ),
            _TENSORS.step(
                "step: D (A + B D) + Φₙ with aₙ = A v + B v̇, Φₙ = A ω̃ + B ω̃' makes ȧₙ + Φₙ v and Φ̇ₙ + Φₙ ω̃",
                r"\dot{A} v + A \dot{v} + \dot{B} \dot{v} + B \ddot{v} + \Phi v = \dot{a} + \Phi v",
                r"\dot{A} \tilde{\omega} + A \dot{\tilde{\omega}} + \dot{B} \dot{\tilde{\omega}}"
                r" + B \ddot{\tilde{\omega}} + \Phi \tilde{\omega} = \dot{\Phi} + \Phi \tilde{\omega}",
                but_not=r"A \dot{v} + B \ddot{v} + \Phi v = \dot{a} + \Phi v",
            ),
        ],
        scope="all n",
    )


def operator_polynomial_is_unique() -> Verdict:
    """Theorem 3, uniqueness: Q is the difference of two polynomials with the same values."""
    return argue(
        [
            _TENSORS.step(
                "where v⁽ᵏ⁾ alone changes by b, Q v changes by Aₖ b: as the derivatives of v at an instant "
                "are free and Aₖ is the same for all v, Q v = 0 for all v leaves Aₖ b = 0 for all b",
                "q(x, y + b, z) - q(x, y, z) = B b",
                "q(x + b, y, z) - q(x, y, z) = A b",
                but_not="q(x, y + b, z) - q(x, y, z) = A b",
            ),
            _TENSORS.step(
                "but Q = (ω̇·v̇) c ⊗ ω − (ω·v)(c ⊗ ω̇) D, whose coefficients depend on v, annihilates v and ω̃",
                r"(\dot{\omega} \cdot \dot{v}) (c \otimes \omega) v"
                r" - (\omega \cdot v) (c \otimes \dot{\omega}) \dot{v} = \mathbf{0}",
                r"(\dot{\omega} \cdot \dot{v}) (c \otimes \omega) \tilde{\omega}"
                r" - (\omega \cdot v) (c \otimes \dot{\omega}) \dot{\tilde{\omega}} = 0",
                but_not=r"(\omega \cdot v) (c \otimes \omega) v"
                r" - (\omega \cdot v) (c \otimes \dot{\omega}) \dot{v} = \mathbf{0}",
            ),
        ],
        hypothesis=r"\text{the coefficients do not depend on v, and the equation holds for every v}",
        reason="for a single motion, or with coefficients that depend on v, there can be others",
        counterexample=Counterexample(
            values={
                r"\omega": _strings(1, 0, 0),
                r"\dot{\omega}": _strings(0, 1, 0),
                r"\mathbf{v}": _strings(1, 0, 0),
                r"\dot{\mathbf{v}}": _strings(0, 1, 0),
                r"\mathbf{P}'_1, \text{ coefficient of } \mathbf{D}^0": _strings(2, 0, 0, 0, 1, 0, 0, 0, 1),
                r"\mathbf{P}'_1, \text{ coefficient of } \mathbf{D}": _strings(0, -1, 0, 0, 0, 0, 0, 0, 0),
            },
            left=_strings(2, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 0),
            right=_strings(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0),
        ),
        scope="all n",
    )


def twist_determines_the_fields() -> Verdict:
    """Remark 5. Theorem 1 says that the field is Φₙ and aₙ; here is how these depend on the twist.

    Φₙ = W + F and aₙ = w + f, where W = ω̃⁽ⁿ⁻¹⁾, w = v⁽ⁿ⁻¹⁾, and F, f are made of lower derivatives.
    """
    return argue(
        [
            _TENSORS.step(
                "begin: Φ₁ = ω̃ and a₁ = v have F = 0 and f = 0; for n = 2, F = ω̃² and f = ω̃ v",
                r"\frac{d}{dt} [\tilde{\omega}] + \tilde{\omega} \tilde{\omega}"
                r" = \tilde{\dot{\omega}} + \tilde{\omega}^2",
                r"\tilde{\omega} v = \omega \times v",
                but_not=r"\tilde{\omega} v = v \times \omega",
            ),
            _TENSORS.step(
                "step: by (20) the next have Ẇ = ω̃⁽ⁿ⁾, ẇ = v⁽ⁿ⁾, and lower derivatives in Ḟ + Φₙω̃, ḟ + Φₙv",
                r"\frac{d}{dt}(W + F) + (W + F) \tilde{\omega}"
                r" = \dot{W} + (\dot{F} + (W + F) \tilde{\omega})",
                r"\frac{d}{dt}(w + f) + (W + F) v = \dot{w} + (\dot{f} + (W + F) v)",
                but_not=r"\frac{d}{dt}(w + f) + (W + F) v = \dot{w} + (\dot{f} + F v)",
            ),
            _TENSORS.step(
                "back: ω⁽ⁿ⁻¹⁾ = vect(Φₙ − F) and v⁽ⁿ⁻¹⁾ = aₙ − f, one order after the other",
                r"\operatorname{vect} (\tilde{w} + F - F) = w",
                "w + f - f = w",
                but_not=r"\operatorname{vect} (\tilde{w} + F) = w",
            ),
        ],
        scope="all n",
    )


def _strings(*entries: Any) -> tuple[str, ...]:
    return tuple(str(entry) for entry in entries)


THEOREMS = {
    theorem.__name__: theorem
    for theorem in (
        homogeneous_matrices_are_a_ring,
        operators_are_a_ring,
        twist_operator_exists,
        twist_operator_is_not_unique,
        no_operator_for_n_0,
        twist_operator_recurrence,
        twist_operator_begins_at_1,
        operator_polynomial_exists,
        operator_polynomial_is_unique,
        twist_determines_the_fields,
    )
}
