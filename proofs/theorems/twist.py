"""Section 6, (86)–(97): what the dual twist says of a rigid motion x = ρ + R r."""

from __future__ import annotations

from workbench.language.goals.proofs import Each, Follows, Have, Kernel, Pointwise, Proven, Unique, Use

_POINT = r"\boldsymbol{\rho} + \mathbf{R} r"
_SAME_FIELD = (
    rf"\forall r \in V_3 : m + w \times ({_POINT}) = \mathbf{{v}} + \boldsymbol{{\omega}} \times ({_POINT})"
)
_C_AWAY, _AT_RHO = Use(1, {"r": r"\mathbf{R}^T c"}), Use(1, {"r": "0"})
_SAME_W = Have(
    r"\tilde{w} = \tilde{\boldsymbol{\omega}}",
    Pointwise("c", Follows("Y - Z", Y=_C_AWAY, Z=_AT_RHO)),
    Follows(r"\operatorname{vect} Y", Y=Use(-1)),
)
_SAME_M = Follows("Y", Y=Use(1, {"r": r"-\mathbf{R}^T \boldsymbol{\rho}"}))

THEOREMS = {
    "velocity_at_the_origin": Proven(
        Each(
            Follows(
                r"\dot{\boldsymbol{\rho}} + \dot{\mathbf{R}} \mathbf{R}^T (Y - \boldsymbol{\rho})", Y=Use(0)
            ),
            Kernel(),
        )
    ),
    "twist_and_velocity_field": Proven(
        Unique(
            {"w": r"\boldsymbol{\omega}", "m": r"\mathbf{v}"},
            only=Have(_SAME_FIELD, Follows("Y", Y=Use(0, {"r": "r"}, back=True)), Each(_SAME_W, _SAME_M)),
        )
    ),
}
