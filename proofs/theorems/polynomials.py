"""Section 4: products of polynomials in D; the operators Pₙ, whether they are unique, where they begin."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    At,
    BinomialInduction,
    Broken,
    Congruence,
    Cut,
    ExistsIntroduction,
    False_,
    Impossible,
    Induction,
    Instance,
    Introductions,
    Kernel,
    Proven,
    SumCongruence,
)

_OF_TERMS = r"\mathsf{E}_m \mathsf{Y}^{(m)}"
_BY_LEIBNIZ = r"\sum_{i=0}^{n} \binom{n}{i} \mathsf{E}_m^{(n-i)} \mathsf{Y}^{(m+i)}"
_SUM = r"\sum_{m=0}^{q}"
_PRODUCT = Cut(
    rf"\forall m, n \geq 0 : \frac{{d^n}}{{dt^n}} [{_OF_TERMS}] = {_BY_LEIBNIZ}",
    BinomialInduction(r"\mathsf{E}_m^{(j)} \mathsf{Y}^{(m+k)}"),
    Cut(
        rf"\forall n, q \geq 0 : {_SUM} \frac{{d^n}}{{dt^n}} [{_OF_TERMS}] = {_SUM} {_BY_LEIBNIZ}",
        Introductions(
            SumCongruence("l", Introductions(Congruence("Y", Y=Instance(0, {"m": "l", "n": "n"}))))
        ),
        Introductions(
            SumCongruence(
                "m", Introductions(Congruence(r"\mathsf{C}_m Y", Y=Instance(-1, {"n": "m", "q": "q"})))
            )
        ),
    ),
)

_FIELDS, _TENSORS_OF_39 = Instance(-1), Instance(-1, part=1)
_NEXT = AndIntroduction(
    Congruence(r"\dot{Y} + Z \mathbf{v}", Y=_FIELDS, Z=_TENSORS_OF_39),
    Congruence(r"\dot{Z} + Z \tilde{\omega}", Z=_TENSORS_OF_39),
)
_OF_P_N = (
    r"\forall n \geq 1 : \mathbf{a}_n = \mathbf{P}_n \mathbf{v} \wedge \Phi_n = \mathbf{P}_n \tilde{\omega}"
)
_P_N = Cut(
    _OF_P_N,
    Induction(step=_NEXT),
    ExistsIntroduction(
        {"P": r"\mathbf{P}_n"},
        AndIntroduction(
            Congruence("Y", Y=Instance(0, {"n": "n"})), Congruence("Y", Y=Instance(0, {"n": "n"}, part=1))
        ),
    ),
)
_AT_REST = {r"\omega": "0", r"\mathbf{v}": "0"}

THEOREMS = {
    "products_of_operator_polynomials": Proven(
        AndIntroduction(ExistsIntroduction({"H": r"\dot{F}", "h": r"\dot{f}"}), _PRODUCT)
    ),
    "homogeneous_matrices_are_a_ring": Proven(
        AndIntroduction(
            ExistsIntroduction({"H": "F + G", "h": "f + g"}),
            ExistsIntroduction({"H": "F - G", "h": "f - g"}),
            ExistsIntroduction({"H": "F G", "h": "F g"}),
            Kernel(),
            Kernel(),
            Kernel(),
        )
    ),
    "operator_polynomial_exists": Proven(AndIntroduction(_P_N, Kernel())),
    "operator_polynomial_exists_for_fields": Proven(_P_N),
    "twist_operator_is_not_unique": Proven(against=Broken(False_())),
    "no_operator_for_n_0": Proven(
        against=At(
            _AT_REST, Impossible(Congruence(r"1 - \frac{1}{3} \operatorname{tr} Y", Y=Instance(-1, part=1)))
        )
    ),
    "twist_operator_recurrence": Proven(_NEXT),
    "operators_make_the_vectors": Proven(
        Cut(_OF_P_N, Induction(step=_NEXT), Congruence("Y", Y=Instance(0, {"n": "n"})))
    ),
    "operators_make_the_tensors": Proven(
        Induction(step=Congruence(r"\dot{Z} + Z \tilde{\omega}", Z=Instance(-1)))
    ),
}
