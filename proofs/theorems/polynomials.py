"""Section 4: products of polynomials in D; the operators Pₙ, whether they are unique, where they begin."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    At,
    Broken,
    Each,
    False_,
    Follows,
    Given,
    Have,
    Impossible,
    Induction,
    Kernel,
    Pascal,
    Proven,
    Termwise,
    Use,
    Witness,
)

_OF_TERMS = r"\mathsf{E}_m \mathsf{Y}^{(m)}"
_BY_LEIBNIZ = r"\sum_{i=0}^{n} \binom{n}{i} \mathsf{E}_m^{(n-i)} \mathsf{Y}^{(m+i)}"
_SUM = r"\sum_{m=0}^{q}"
_PRODUCT = Have(
    rf"\forall m, n \geq 0 : \frac{{d^n}}{{dt^n}} [{_OF_TERMS}] = {_BY_LEIBNIZ}",
    Pascal(r"\mathsf{E}_m^{(j)} \mathsf{Y}^{(m+k)}"),
    Have(
        rf"\forall n, q \geq 0 : {_SUM} \frac{{d^n}}{{dt^n}} [{_OF_TERMS}] = {_SUM} {_BY_LEIBNIZ}",
        Given(Termwise("l", Given(Follows("Y", Y=Use(0, {"m": "l", "n": "n"}))))),
        Given(Termwise("m", Given(Follows(r"\mathsf{C}_m Y", Y=Use(-1, {"n": "m", "q": "q"}))))),
    ),
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
    "products_of_operator_polynomials": Proven(Each(Witness({"H": r"\dot{F}", "h": r"\dot{f}"}), _PRODUCT)),
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
