"""Section 6, (86)–(97): what the dual twist says of a rigid motion x = ρ + R r."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    Extensionality,
    Instance,
    Kernel,
    Proven,
    UniqueExists,
)

_POINT = r"\boldsymbol{\rho} + \mathbf{R} r"
_SAME_FIELD = (
    rf"\forall r \in V_3 : m + w \times ({_POINT}) = \mathbf{{v}} + \boldsymbol{{\omega}} \times ({_POINT})"
)
_C_AWAY, _AT_RHO = Instance(1, {"r": r"\mathbf{R}^T c"}), Instance(1, {"r": "0"})
_SAME_W = Cut(
    r"\tilde{w} = \tilde{\boldsymbol{\omega}}",
    Extensionality("c", Congruence("Y - Z", Y=_C_AWAY, Z=_AT_RHO)),
    Congruence(r"\operatorname{vect} Y", Y=Instance(-1)),
)
_SAME_M = Congruence("Y", Y=Instance(1, {"r": r"-\mathbf{R}^T \boldsymbol{\rho}"}))

THEOREMS = {
    "velocity_at_the_origin": Proven(
        AndIntroduction(
            Congruence(
                r"\dot{\boldsymbol{\rho}} + \dot{\mathbf{R}} \mathbf{R}^T (Y - \boldsymbol{\rho})",
                Y=Instance(0),
            ),
            Kernel(),
        )
    ),
    "twist_and_velocity_field": Proven(
        UniqueExists(
            {"w": r"\boldsymbol{\omega}", "m": r"\mathbf{v}"},
            only=Cut(
                _SAME_FIELD,
                Congruence("Y", Y=Instance(0, {"r": "r"}, back=True)),
                AndIntroduction(_SAME_W, _SAME_M),
            ),
        )
    ),
}
