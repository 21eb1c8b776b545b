"""Section 6, (114)–(116) and Theorem 10: derivatives of the twist and acceleration invariants, each from the
others, for every order.

F and h stand for R⁽ⁿ⁾ and ρ⁽ⁿ⁾ for some n ≥ 1, as free functions: what holds for them holds for every n.
"""

from __future__ import annotations

from proofs.theorems.leibniz import leibniz_rule
from workbench.judge.arguments import Step, argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Counterexample, Verdict

_MOTION = Letters(
    {name: {"kind": "vector"} for name in (r"\rho", "h", "y")}
    | {name: {"kind": "tensor"} for name in "FGA"}
    | {"R": {"kind": "rotation"}},
    {r"\omega": r"\operatorname{vect}(\dot{R} R^T)", "v": r"\dot{\rho} - \omega \times \rho"},
)

#: Ψₙ = (aₙ, Φₙ) and T = (v, ω̃) by (20) and (39), for free v and ω.
_INVARIANTS = Letters(
    {
        r"\omega": {"kind": "vector"},
        "v": {"kind": "vector"},
        "x": {"kind": "vector"},
        "P_n": {"kind": "operator"},
    },
    {
        r"\Phi_1": r"\tilde{\omega}",
        r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1",
        "a_1": "v",
        "a_{n+1}": r"\dot{a}_n + \Phi_n a_1",
        "P_1": r"\mathbf{I}",
        "P_{n+1}": r"\mathbf{D} P_n + P_n (\tilde{\omega})",
        r"\Psi_n": r"(a_n, \Phi_n)",
        r"\mathbf{T}": r"(v, \tilde{\omega})",
    },
)

#: Blocks below the diagonal: any tensors.
_BLOCKS = Letters(
    {name: {"kind": "tensor"} for name in "ABCEFG"} | {r"\omega": {"kind": "vector"}},
    {
        "M": r"\begin{bmatrix} \mathbf{I} & \mathbf{0} & \mathbf{0} & \mathbf{0} \\ A & \mathbf{I} &"
        r" \mathbf{0} & \mathbf{0} \\"
        r" B & C & \mathbf{I} & \mathbf{0} \\ E & F & G & \mathbf{I} \end{bmatrix}",
        "J": r"\begin{bmatrix} \mathbf{I} & \mathbf{0} & \mathbf{0} & \mathbf{0} \\"
        r" \mathbf{0} & \mathbf{I} & \mathbf{0} & \mathbf{0} \\"
        r" \mathbf{0} & \mathbf{0} & \mathbf{I} & \mathbf{0} \\"
        r" \mathbf{0} & \mathbf{0} & \mathbf{0} & \mathbf{I} \end{bmatrix}",
        "N": "M - J",
        "L": r"\begin{bmatrix} \mathbf{I} & \mathbf{0} & \mathbf{0} & \mathbf{0} \\"
        r" -\tilde{\omega} & \mathbf{I} & \mathbf{0} & \mathbf{0} \\"
        r" -2\dot{\tilde{\omega}} & -\tilde{\omega} & \mathbf{I} & \mathbf{0} \\"
        r" -3\ddot{\tilde{\omega}} & -3\dot{\tilde{\omega}} & -\tilde{\omega} & \mathbf{I} \end{bmatrix}",
        "U": r"\begin{bmatrix} \mathbf{I} & \mathbf{0} & \mathbf{0} & \mathbf{0} \\"
        r" \tilde{\omega} & \mathbf{I} & \mathbf{0} & \mathbf{0} \\"
        r" 2\dot{\tilde{\omega}} + \tilde{\omega}^2 & \tilde{\omega} & \mathbf{I} & \mathbf{0} \\"
        r" 3\ddot{\tilde{\omega}} + 2\tilde{\omega}\dot{\tilde{\omega}} + 3\dot{\tilde{\omega}}\tilde{\omega}"
        r" + \tilde{\omega}^3 & 3\dot{\tilde{\omega}} + \tilde{\omega}^2 & \tilde{\omega} & \mathbf{I}"
        r" \end{bmatrix}",
    },
)


def twist_derivatives_from_accelerations() -> Verdict:
    """(116) for every n ≥ 1, by Leibniz' rule for Ṙ = ω̃ R and ρ̇ = ω̃ ρ + v."""
    return argue(_every_order(), scope="all n")


def triangular_systems_are_inverse() -> Verdict:
    """(114) and (115), and their continuations by (116), are inverse to each other.

    For v, v̇, … at an instant are arbitrary: if L and U send (Ψ₁, Ψ₂, …) to (T, Ṫ, …) and back for every
    motion, then L U w = w for every w.
    """
    return argue(
        [
            _BLOCKS.step(
                "the printed matrices have the products L U = I and U L = I",
                r"L U = \mathbf{I}",
                r"U L = \mathbf{I}",
                but_not=r"L L = \mathbf{I}",
            ),
            _BLOCKS.step(
                "with any blocks below the diagonal N⁴ = 0 for four rows, and Nⁿ = 0 for n, so that I + N"
                " has one inverse",
                "N^4 = N - N",
                r"M (J - N + N^2 - N^3) = J",
                but_not="N^3 = N - N",
            ),
            *_every_order(),
        ],
        scope="all n",
    )


def accelerations_from_twist_derivatives() -> Verdict:
    """Theorem 10: Ψₙ is T⁽ⁿ⁻¹⁾ plus what Ψ₁, …, Ψₙ₋₁ give, for every n ≥ 1."""
    return argue(
        [
            *_every_order(),
            _INVARIANTS.step(
                "what is added to T⁽ⁿ⁻¹⁾ holds lower derivatives only: a change x of v⁽ⁿ⁻¹⁾ alone changes"
                " aₙ by x",
                r"a_2 = (\dot{v}) + \tilde{\omega} v",
                r"(\dot{v} + x) + \tilde{\omega} v = a_2 + x",
                r"(\ddot{v} + x) + 2 \dot{\tilde{\omega}} v + \tilde{\omega} (\dot{v} + \tilde{\omega} v)"
                r" = a_3 + x",
                but_not=r"(\dot{v} + x) + \tilde{\omega} v = a_2",
            ),
            _INVARIANTS.step(
                "the field a + Φ x determines a, its value at 0, and Φ, its linear part",
                r"(a_n + \Phi_n x) - a_n = \Phi_n x",
                but_not=r"(a_n + \Phi_n x) - a_n = 0",
                orders={"n": range(1, 4)},
            ),
        ],
        scope="all n",
    )


def accelerations_counted_from_zero() -> Verdict:
    """Theorem 10 with the velocity as order 0: then the field of order n holds v⁽ⁿ⁾ itself."""
    return argue(
        [
            *_every_order(),
            _INVARIANTS.refutation(
                "a₁ = v, what (107) calls the order 0, is not fixed by an empty set of derivatives",
                "a_1 = v - v",
                but_not="a_1 = v",
            ),
        ],
        refutes=True,
        counterexample=Counterexample(
            values={"n": ("0",), r"\omega": ("0", "0", "0"), r"\mathbf{v}": ("0", "0", "1")},
            left=("0", "0", "1"),
            right=("0", "0", "0"),
        ),
        reason="for n = 0 nothing is given, and the velocity of one motion is not that of another",
    )


def _every_order() -> list[Step]:
    twist = r"(\dot{F} R^T)"
    return [
        _MOTION.step(
            "Φₙ = F Rᵀ and aₙ = h − Φₙ ρ have the recurrence (20), whatever functions F and h are",
            rf"{twist} = \frac{{d}}{{dt}}(F R^T) + (F R^T) \tilde{{\omega}}",
            r"\dot{h} - \dot{F} R^T \rho = \frac{d}{dt}(h - F R^T \rho) + (F R^T) v",
            but_not=rf"{twist} = \frac{{d}}{{dt}}(F R^T) - (F R^T) \tilde{{\omega}}",
        ),
        _MOTION.step(
            "Ṙ = ω̃ R and ρ̇ = ω̃ ρ + v: so R⁽ⁿ⁾ = (ω̃ R)⁽ⁿ⁻¹⁾ and ρ⁽ⁿ⁾ = (ω̃ ρ + v)⁽ⁿ⁻¹⁾",
            r"\dot{R} = \tilde{\omega} R",
            r"\dot{\rho} = \tilde{\omega} \rho + v",
            but_not=r"\dot{R} = R \tilde{\omega}",
        ),
        *leibniz_rule(),
        _MOTION.step(
            "each term ω̃⁽ᵐ⁾ R⁽ᵏ⁾ Rᵀ of the sum is ω̃⁽ᵐ⁾ Φₖ, each ω̃⁽ᵐ⁾ ρ⁽ᵏ⁾ less its part in Φₙ ρ is"
            " ω̃⁽ᵐ⁾ aₖ; for k = 0 these are ω̃⁽ⁿ⁻¹⁾ and 0",
            r"A h - (A F) R^T \rho = A (h - F R^T \rho)",
            r"A R R^T = A",
            r"A \rho - (A R) R^T \rho = 0",
            but_not=r"A h - (A F) R^T \rho = A h",
        ),
        _MOTION.step(
            "each term A Dᵏ of Pₙ has (D ∘ A) y = (A y)˙ with y = v⁽ᵏ⁾, and the same for ω̃: Pₙ₊₁ v = (Pₙ"
            " v)˙ + Pₙ(ω̃) v = ȧₙ + Φₙ v",
            r"(\mathbf{D} \circ A) y = \frac{d}{dt}(A y)",
            r"(\mathbf{D} \circ A) G = \frac{d}{dt}(A G)",
            but_not=r"(\mathbf{D} \circ A) y = A \dot{y}",
        ),
        _INVARIANTS.step(
            "n = 1 is T = Ψ₁; for n = 1 … 6 both lines of (116) are what (20) gives",
            r"\mathbf{T}^{(n-1)} = \Psi_n - \sum_{k=1}^{n-1} C_{n-1}^k \tilde{\omega}^{(n-1-k)} \Psi_k",
            r"\Psi_n = P_n \mathbf{T}",
            but_not=r"\mathbf{T}^{(n-1)} = \Psi_n - \sum_{k=1}^{n-1} \tilde{\omega}^{(n-1-k)} \Psi_k",
            orders={"n": range(1, 7)},
        ),
    ]


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        twist_derivatives_from_accelerations,
        triangular_systems_are_inverse,
        accelerations_from_twist_derivatives,
        accelerations_counted_from_zero,
    )
}
