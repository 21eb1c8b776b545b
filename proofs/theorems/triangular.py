"""Section 6, (114)–(116) and Theorem 10: derivatives of the twist and acceleration invariants, each from the
others, for every order.

F and h stand for R⁽ⁿ⁾ and ρ⁽ⁿ⁾ for some n ≥ 1, as free functions: what holds for them holds for every n.
"""

from __future__ import annotations

from proofs.theorems.leibniz import leibniz_rule
from workbench.judge.theorems.arguments import Step, argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.theorems.proofs import (
    Follows,
    Given,
    Have,
    Induction,
    Kernel,
    Pascal,
    Proven,
    Termwise,
    Use,
)
from workbench.judge.verdict import Verdict

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


def _every_order() -> list[Step]:
    twist = r"(\dot{F} R^T)"
    return [
        _MOTION.step(
            "Φₙ = F Rᵀ and aₙ = h − Φₙ ρ have the recurrence (20), whatever functions F and h are",
            rf"{twist} = \frac{{d}}{{dt}}(F R^T) + (F R^T) \tilde{{\omega}}",
            r"\dot{h} - \dot{F} R^T \rho = \frac{d}{dt}(h - F R^T \rho) + (F R^T) v",
            but_not=rf"{twist} = \frac{{d}}{{dt}}(F R^T) + \tilde{{\omega}} (F R^T)",
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


_FIRST = r"\begin{bmatrix} \mathbf{0} & \mathbf{I} \end{bmatrix}"  # of M: the rows of Ψ


def _product(order: str) -> str:
    return rf"{_FIRST} (\frac{{d^{{{order}}}}}{{dt^{{{order}}}}} [\mathsf{{X}}] \mathsf{{M}}_k)"


_SUMS = rf"\forall n \geq 0 : {_FIRST} \mathsf{{M}}_{{n+1}} = \sum_{{k=0}}^n C_n^k ({_product('n-k')})"
_PARTS = (
    r"\forall n \geq 1 : \mathsf{M}_n = \begin{bmatrix} 0 & \mathbf{0} \\ \mathbf{a}_n & \Phi_n \end{bmatrix}"
)
_ADDENDS = rf"\forall k \geq 1 : \forall j \geq 0 : {_product('j')} = \tilde{{\omega}}^{{(j)}} \Psi_k"
_OF_ORDER_N = r"\sum_{k=1}^{n-1} C_{n-1}^k \tilde{\omega}^{(n-1-k)} \Psi_k"
_THE_SAME = rf"\sum_{{k=1}}^{{n-1}} C_{{n-1}}^k ({_product('n-1-k')})"
_WITH_THE_FIRST = rf"\sum_{{k=0}}^{{n-1}} C_{{n-1}}^k ({_product('n-1-k')})"

#: Mₙ₊₁ = Σ C(n, k) X⁽ⁿ⁻ᵏ⁾ Mₖ by Pascal's rule, M₀ being the unit matrix; X⁽ʲ⁾ Mₖ has ω̃⁽ʲ⁾ Ψₖ for k ≥ 1.
_BY_PASCAL = Have(
    _SUMS,
    Pascal(_product("j"), step=r"\dot{Y} + Y \mathsf{X}"),
    Have(
        _PARTS,
        Induction(step=Follows(r"\dot{Y} + Y \mathsf{X}", Y=Use(-1))),
        Have(
            _ADDENDS,
            Given(Follows(rf"{_FIRST} (\frac{{d^j}}{{dt^j}} [\mathsf{{X}}] Y)", Y=Use(1, {"n": "k"}))),
            Have(
                rf"\forall n \geq 1 : {_THE_SAME} = {_OF_ORDER_N}",
                Given(Termwise("k", Follows("C_{k+j}^k Y", Y=Use(2, {"k": "k", "j": "j"})))),
                Have(
                    rf"\forall n \geq 0 : \mathbf{{T}}^{{(n)}} = {_product('n').replace('k', '0')}",
                    Kernel(using=()),
                    Given(
                        Follows(
                            rf"Z + Y - {_WITH_THE_FIRST} + {_FIRST} (U - \mathsf{{M}}_n) + {_THE_SAME} - V",
                            Z=Use(4, {"n": "n-1"}),
                            Y=Use(0, {"n": "n-1"}, back=True),
                            U=Use(1, {"n": "n"}),
                            V=Use(3, {"n": "n"}),
                        )
                    ),
                ),
            ),
        ),
    ),
)

#: Name in the claim files → proof.
THEOREMS = {
    "twist_derivatives_from_accelerations": Proven(_BY_PASCAL),
    "accelerations_from_twist_derivatives": accelerations_from_twist_derivatives,
}
