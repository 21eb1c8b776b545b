"""Section 4: the ring of homogeneous matrices; the operators Pₙ, whether they are unique, where they begin.

An operator of degree m acts term by term, Σ Aₖ Dᵏ x = Σ Aₖ x⁽ᵏ⁾. So what is shown of one term A Dᵏ, with a
free A and a free y for x⁽ᵏ⁾, holds for the sum, of any degree.
"""

from __future__ import annotations

from workbench.judge.theorems.arguments import Step, argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.theorems.proofs import (
    At,
    Broken,
    Each,
    False_,
    Follows,
    Have,
    Impossible,
    Induction,
    Kernel,
    Proven,
    Use,
    Witness,
)
from workbench.judge.verdict import Verdict

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


_FIELDS, _TENSORS_OF_39 = Use(-1), Use(-1, part=1)
_NEXT = Each(
    Follows(r"\dot{Y} + Z \mathbf{v}", Y=_FIELDS, Z=_TENSORS_OF_39),
    Follows(r"\dot{Z} + Z \tilde{\omega}", Z=_TENSORS_OF_39),
)
_OF_P_N = (
    r"\forall n \geq 1 : \mathbf{a}_n = \mathbf{P}_n \mathbf{v} \wedge \Phi_n = \mathbf{P}_n \tilde{\omega}"
)
_P_N = Have(
    _OF_P_N,
    Induction(step=_NEXT),
    Witness(
        {"P": r"\mathbf{P}_n"},
        Each(Follows("Y", Y=Use(0, {"n": "n"})), Follows("Y", Y=Use(0, {"n": "n"}, part=1))),
    ),
)
_AT_REST = {r"\omega": "0", r"\mathbf{v}": "0"}

THEOREMS = {
    "operators_are_a_ring": operators_are_a_ring,
    "homogeneous_matrices_are_a_ring": Proven(
        Each(
            Witness({"H": "F + G", "h": "f + g"}),
            Witness({"H": "F - G", "h": "f - g"}),
            Witness({"H": "F G", "h": "F g"}),
            Kernel(),
            Kernel(),
            Kernel(),
        )
    ),
    "operator_polynomial_exists": Proven(Each(_P_N, Kernel())),
    "operator_polynomial_exists_for_fields": Proven(_P_N),
    "twist_operator_is_not_unique": Proven(against=Broken(False_())),
    "no_operator_for_n_0": Proven(
        against=At(_AT_REST, Impossible(Follows(r"1 - \frac{1}{3} \operatorname{tr} Y", Y=Use(-1, part=1))))
    ),
    "twist_operator_recurrence": Proven(_NEXT),
    "operators_make_the_vectors": Proven(
        Have(_OF_P_N, Induction(step=_NEXT), Follows("Y", Y=Use(0, {"n": "n"})))
    ),
    "operators_make_the_tensors": Proven(Induction(step=Follows(r"\dot{Z} + Z \tilde{\omega}", Z=Use(-1)))),
}
