"""Section 3: the field of n-th order accelerations is affine; (21), (22), (31) for all n; the group SE(3)."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    ExistsIntroduction,
    Extensionality,
    Induction,
    Instance,
    Kernel,
    Proven,
    UniqueExists,
)

# The body point at ρ_Q + R r: at the places of all body points the fields b + B ρ and aₙ + Φₙ ρ agree.
_SAME_FIELD = (
    r"\forall \mathbf{r} \in \mathbf{V}_3 : b + B (\boldsymbol{\rho}_Q + \mathbf{R} \mathbf{r})"
    r" = \mathbf{a}_n + \boldsymbol{\Phi}_n (\boldsymbol{\rho}_Q + \mathbf{R} \mathbf{r})"
)
_AT_Q = Instance(1, {r"\mathbf{r}": "0"})
_FROM_Q_BY_C = Instance(1, {r"\mathbf{r}": r"\mathbf{R}^T c"})
_AT_THE_ORIGIN = Instance(1, {r"\mathbf{r}": r"-\mathbf{R}^T \boldsymbol{\rho}_Q"})

_UNROLLED_TENSORS = (
    r"\forall n \geq 2 : \boldsymbol{\Phi}_n = \boldsymbol{\Phi}_{n-1} \boldsymbol{\Phi}_1"
    r" + \frac{d^{n-1}}{dt^{n-1}} [\boldsymbol{\Phi}_1]"
    r" + \sum_{k=1}^{n-2} \left[ \frac{d^k}{dt^k} (\boldsymbol{\Phi}_{n-k-1} \boldsymbol{\Phi}_1) \right]"
)
_REST_OF_22 = (
    r"\text{vect} \left[ Y - \boldsymbol{\Phi}_{n-1} \boldsymbol{\Phi}_1"
    r" - \sum_{k=1}^{n-2} \left[ \frac{d^k}{dt^k} (\boldsymbol{\Phi}_{n-k-1} \boldsymbol{\Phi}_1) \right]"
    r" \right]"
)
_TENSORS = Induction(step=Congruence(r"\dot{Y} + \boldsymbol{\Phi}_n \boldsymbol{\Phi}_1", Y=Instance(-1)))
_VECTORS = Induction(step=Congruence(r"\dot{Y} + \boldsymbol{\Phi}_n \mathbf{a}_1", Y=Instance(-1)))
_BY_TENSORS = Cut(_UNROLLED_TENSORS, _TENSORS, Congruence(_REST_OF_22, Y=Instance(0, {"n": "n"}, back=True)))
_SKEW = Cut(
    r"\boldsymbol{\Phi}_1 = \tilde{\boldsymbol{\omega}}",
    Kernel(),
    Congruence(r"\frac{d^{n-1}}{dt^{n-1}} Y", Y=Instance(0, back=True)),
)

THEOREMS = {
    "acceleration_field_is_affine": Proven(
        UniqueExists(
            {"B": r"\boldsymbol{\Phi}_n", "b": r"\mathbf{a}_n"},
            only=Cut(
                _SAME_FIELD,
                Congruence("Y", Y=Instance(0, {r"\mathbf{r}": r"\mathbf{r}"}, back=True)),
                AndIntroduction(
                    Extensionality("c", Congruence("Y - Z", Y=_FROM_Q_BY_C, Z=_AT_Q)),
                    Congruence("Y", Y=_AT_THE_ORIGIN),
                ),
            ),
        )
    ),
    "unrolled_recurrence": Proven(AndIntroduction(_TENSORS, _VECTORS)),
    "unrolled_tensors": Proven(_TENSORS),
    "unrolled_vectors": Proven(_VECTORS),
    "angular_accelerations_by_tensors": Proven(AndIntroduction(_BY_TENSORS, _SKEW)),
    "angular_accelerations_by_sums_of_tensors": Proven(_BY_TENSORS),
    "skew_angular_accelerations": Proven(_SKEW),
    "unrolled_matrices": Proven(Induction(step=Congruence(r"\dot{Y} + \Psi_n \Psi_1", Y=Instance(-1)))),
    "rigid_motions_are_a_group": Proven(
        AndIntroduction(
            ExistsIntroduction(
                {
                    "Q": r"\mathbf{R}_1 \mathbf{R}_2",
                    "q": r"\mathbf{R}_1 \mathbf{w}_2 + \mathbf{w}_1",
                }
            ),
            ExistsIntroduction({"Q": r"\mathbf{I}", "q": "0"}),
            ExistsIntroduction({"Q": r"\mathbf{R}_1^T", "q": r"-\mathbf{R}_1^T \mathbf{w}_1"}),
            ExistsIntroduction(
                {
                    "Q": r"\mathbf{R}_2 \mathbf{R}_1^T",
                    "q": r"\mathbf{w}_2 - \mathbf{R}_2 \mathbf{R}_1^T \mathbf{w}_1",
                }
            ),
        )
    ),
}
