"""Section 6, (114)–(116): derivatives of the twist and acceleration invariants, each from the others."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    BinomialInduction,
    Congruence,
    Cut,
    Induction,
    Instance,
    Introductions,
    Kernel,
    Proven,
    SumCongruence,
)

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
_BY_PASCAL = Cut(
    _SUMS,
    BinomialInduction(_product("j"), step=r"\dot{Y} + Y \mathsf{X}"),
    Cut(
        _PARTS,
        Induction(step=Congruence(r"\dot{Y} + Y \mathsf{X}", Y=Instance(-1))),
        Cut(
            _ADDENDS,
            Introductions(
                Congruence(rf"{_FIRST} (\frac{{d^j}}{{dt^j}} [\mathsf{{X}}] Y)", Y=Instance(1, {"n": "k"}))
            ),
            Cut(
                rf"\forall n \geq 1 : {_THE_SAME} = {_OF_ORDER_N}",
                Introductions(
                    SumCongruence("k", Congruence("C_{k+j}^k Y", Y=Instance(2, {"k": "k", "j": "j"})))
                ),
                Cut(
                    rf"\forall n \geq 0 : \mathbf{{T}}^{{(n)}} = {_product('n').replace('k', '0')}",
                    Kernel(using=()),
                    Introductions(
                        Congruence(
                            rf"Z + Y - {_WITH_THE_FIRST} + {_FIRST} (U - \mathsf{{M}}_n) + {_THE_SAME} - V",
                            Z=Instance(4, {"n": "n-1"}),
                            Y=Instance(0, {"n": "n-1"}, back=True),
                            U=Instance(1, {"n": "n"}),
                            V=Instance(3, {"n": "n"}),
                        )
                    ),
                ),
            ),
        ),
    ),
)

_FOR_EVERY_N = rf"\forall n \geq 1 : \mathbf{{T}}^{{(n-1)}} = \Psi_n - {_OF_ORDER_N}"
_COLUMN = r"\begin{bmatrix} 1 \\ \mathbf{0} \end{bmatrix}"
_OF_FIRST_COLUMNS = (
    r"\forall k \geq 1 : \forall j \geq 0 :"
    rf" \tilde{{\omega}}^{{(j)}} \Psi_k {_COLUMN} = \omega^{{(j)}} \times \mathbf{{a}}_k"
)
_OF_TENSORS = rf"\sum_{{k=1}}^n C_n^k (\tilde{{\omega}}^{{(n-k)}} \Psi_k {_COLUMN})"
_OF_VECTORS = r"\sum_{k=1}^n C_n^k \omega^{(n-k)} \times \mathbf{a}_k"

#: Name in the claim files → proof.
THEOREMS = {
    "twist_derivatives_from_accelerations": Proven(_BY_PASCAL),
    "velocity_derivatives_from_accelerations": Proven(
        Cut(
            _FOR_EVERY_N,
            _BY_PASCAL,
            Cut(
                _OF_FIRST_COLUMNS,
                Kernel(),
                Cut(
                    rf"\forall n \geq 0 : {_OF_TENSORS} = {_OF_VECTORS}",
                    Introductions(
                        SumCongruence("k", Congruence("C_{k+j}^k Y", Y=Instance(1, {"k": "k", "j": "j"})))
                    ),
                    Introductions(
                        Congruence(
                            rf"Y {_COLUMN} + {_OF_TENSORS} - Z",
                            Y=Instance(0, {"n": "n+1"}),
                            Z=Instance(2, {"n": "n"}),
                        )
                    ),
                ),
            ),
        )
    ),
}
