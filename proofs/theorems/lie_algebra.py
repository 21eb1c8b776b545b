"""Section 5.3, (81): the Lie algebra of the orthogonal dual tensors."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    ExistsIntroduction,
    Instance,
    Introductions,
    Kernel,
    Proven,
    UniqueExists,
)

#: Through I at t = 0 with the velocity b̃: the rotation with the Rodrigues vector t b/2.
_CURVE = r"\mathbf{I} + \frac{4 t}{4 + t^2 b^2} \tilde{b} + \frac{2 t^2}{4 + t^2 b^2} \tilde{b}^2"

_SKEW = Cut(
    r"\forall Q \in \underline{SO}_3^\mathbb{R} : \dot{Q} Q^T = -Q (\frac{d}{dt} Q)^T",
    Kernel(),
    Introductions(
        Congruence(
            r"Y + A (\frac{d}{dt} A)^T - \dot{A} Z^T - Z (\frac{d}{dt} A)^T + (\frac{d}{dt} A)^T",
            Y=Instance(0, {"Q": "A"}),
            Z=Instance(1),
        )
    ),
)

THEOREMS = {
    "lie_algebra_of_the_dual_group": Proven(
        AndIntroduction(
            _SKEW,
            ExistsIntroduction({"A": _CURVE}),
            UniqueExists(
                {"b": r"\operatorname{vect} T"},
                exists=Congruence(r"\frac{1}{2} (T - Y)", Y=Instance(0, back=True)),
                only=Congruence(r"\operatorname{vect} Y", Y=Instance(-1, back=True)),
            ),
            Kernel(),
        )
    ),
}
