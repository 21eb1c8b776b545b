"""Section 6, (103)–(116): reduced accelerations of every order, and operators that make Ψₙ of the twist."""

from __future__ import annotations

from workbench.language.goals.proofs import Each, Follows, Given, Have, Induction, Kernel, Proven, Use

# Leibniz' rule, which the sums of (106) and (108) are.
_AFFINE = r"\forall n \geq 0 : \mathbf{A}_{\rho}^{[n]} = \mathbf{v}^{(n)} + \omega^{(n)} \times \rho"
_AT_N = Use(0, {"n": "n"})
# Of the body point at ρ; where ρ = 0 is supposed, at an instant, it may not be differentiated.
_OF_POINTS = r"\forall n \geq 0 : \mathbf{a}_n = \mathbf{P}_n \mathbf{v} + (\mathbf{P}_n \tilde{\omega}) \rho"
_TENSORS = r"\forall n \geq 1 : \Phi_n = \mathbf{P}_n \tilde{\omega}"

THEOREMS = {
    "reduced_accelerations_at_the_origin": Proven(
        Have(
            _AFFINE,
            Kernel(),
            Given(Follows(r"Y + \omega^{(n)} \times (Z - \rho)", Y=_AT_N, Z=Use(1))),
        )
    ),
    "reduced_accelerations_of_every_order": Proven(
        Have(
            _AFFINE,
            Kernel(),
            Each(
                Follows("Y", Y=_AT_N),
                Follows(r"e^{\varepsilon \tilde{\rho}} (\omega^{(n)} + \varepsilon Y)", Y=_AT_N),
            ),
        )
    ),
    "reduced_accelerations_are_helicoidal": Proven(Each(Kernel(), Kernel())),
    "operators_make_the_accelerations_at_the_origin": Proven(
        Have(
            _OF_POINTS,
            Induction(step=Follows(r"\dot{Y}", Y=Use(-1))),
            Given(Follows(r"Y - (\mathbf{P}_n \tilde{\omega}) (\rho - Z)", Y=_AT_N, Z=Use(1))),
        )
    ),
    "operators_make_the_invariants": Proven(
        Have(
            _TENSORS,
            Induction(step=Follows(r"\dot{Z} + Z \tilde{\omega}", Z=Use(-1))),
            Induction(step=Follows(r"\dot{Y} + Z \mathbf{T}", Y=Use(-1), Z=_AT_N)),
        )
    ),
}
