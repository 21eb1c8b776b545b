"""Section 6, (103)–(116): reduced accelerations of every order, and operators that make Ψₙ of the twist."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    Induction,
    Instance,
    Introductions,
    Kernel,
    Proven,
)

# Leibniz' rule, which the sums of (106) and (108) are.
_AFFINE = r"\forall n \geq 0 : \mathbf{A}_{\rho}^{[n]} = \mathbf{v}^{(n)} + \omega^{(n)} \times \rho"
_AT_N = Instance(0, {"n": "n"})
# Of the body point at ρ; where ρ = 0 is supposed, at an instant, it may not be differentiated.
_OF_POINTS = r"\forall n \geq 0 : \mathbf{a}_n = \mathbf{P}_n \mathbf{v} + (\mathbf{P}_n \tilde{\omega}) \rho"
_TENSORS = r"\forall n \geq 1 : \Phi_n = \mathbf{P}_n \tilde{\omega}"

THEOREMS = {
    "reduced_accelerations_at_the_origin": Proven(
        Cut(
            _AFFINE,
            Kernel(),
            Introductions(Congruence(r"Y + \omega^{(n)} \times (Z - \rho)", Y=_AT_N, Z=Instance(1))),
        )
    ),
    "reduced_accelerations_of_every_order": Proven(
        Cut(
            _AFFINE,
            Kernel(),
            AndIntroduction(
                Congruence("Y", Y=_AT_N),
                Congruence(r"e^{\varepsilon \tilde{\rho}} (\omega^{(n)} + \varepsilon Y)", Y=_AT_N),
            ),
        )
    ),
    "reduced_accelerations_are_helicoidal": Proven(AndIntroduction(Kernel(), Kernel())),
    "operators_make_the_accelerations_at_the_origin": Proven(
        Cut(
            _OF_POINTS,
            Induction(step=Congruence(r"\dot{Y}", Y=Instance(-1))),
            Introductions(
                Congruence(r"Y - (\mathbf{P}_n \tilde{\omega}) (\rho - Z)", Y=_AT_N, Z=Instance(1))
            ),
        )
    ),
    "operators_make_the_invariants": Proven(
        Cut(
            _TENSORS,
            Induction(step=Congruence(r"\dot{Z} + Z \tilde{\omega}", Z=Instance(-1))),
            Induction(step=Congruence(r"\dot{Y} + Z \mathbf{T}", Y=Instance(-1), Z=_AT_N)),
        )
    ),
}
