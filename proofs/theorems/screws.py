"""Section 5.3, (80): the series of the exponential. Its sum is a limit, so that this is an argument.

α = a + ε d is a dual angle, u a unit dual vector, X = I + sin α ũ + (1 − cos α) ũ², Eq. (80).
"""

from __future__ import annotations

from workbench.judge.theorems.arguments import argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Verdict

SCREW = Letters(
    {
        r"\alpha": {"kind": "dual scalar"},
        "d": {"kind": "scalar"},
        "u": {"kind": "dual vector", "unit": True, "constant": True},
        "Y": {"kind": "dual tensor"},
        "b": {"kind": "dual vector"},
    },
    {"X": r"\mathbf{I} + \sin \alpha \tilde{u} + (1 - \cos \alpha) \tilde{u}^2"},
)


def exponential_of_a_screw() -> Verdict:
    """(80): the series and the differential equation of the exponential give Rodrigues' formula."""
    return argue(
        [
            SCREW.step(
                "ũ³ = −ũ: the even and odd powers of the series Σ αᵏ ũᵏ/k! are ±ũ² and ±ũ, with the"
                " coefficients of 1 − cos α and sin α",
                r"\tilde{u}^3 = -\tilde{u}",
                r"\tilde{u}^4 = -\tilde{u}^2",
                but_not=r"\tilde{b}^3 = -\tilde{b}",
            ),
            SCREW.step(
                "Ẋ = α̇ ũ X, the differential equation of exp(α ũ); X = I at α = 0",
                r"\dot{X} = \dot{\alpha} \tilde{u} X",
                r"\mathbf{I} + \sin(d - d) \tilde{u} + (1 - \cos(d - d)) \tilde{u}^2 = \mathbf{I}",
                but_not=r"\dot{X} = \dot{\alpha} \tilde{u}",
            ),
            SCREW.step(
                "(Xᵀ Y)˙ = Xᵀ (Ẏ − α̇ ũ Y) and Xᵀ X = I: another solution Y that begins with I is X",
                r"\frac{d}{dt}(X^T Y) = X^T (\dot{Y} - \dot{\alpha} \tilde{u} Y)",
                r"X^T X = \mathbf{I}",
                but_not=r"\frac{d}{dt}(X^T Y) = X^T \dot{Y}",
            ),
        ]
    )


THEOREMS = {"exponential_of_a_screw": exponential_of_a_screw}
