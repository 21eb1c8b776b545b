"""Section 5.3: the three kinds of displacement that a screw ψ̲ = ψ + ε ψ₀ can stand for."""

from __future__ import annotations

from proofs.theorems.screws import PAIR, SCREW, full_turn
from workbench.judge.arguments import Step, argue
from workbench.judge.verdict import Counterexample, Verdict


def roto_translations() -> Verdict:
    """|ψ̲| = ‖ψ‖ + ε ψ·ψ₀/‖ψ‖ is not real where ψ·ψ₀ ≠ 0, against the first item."""
    return argue(
        [
            *_magnitude(),
            PAIR.refutation(
                "so the dual part of the square of |ψ| is not 0 for all ψ, ψ₀",
                r"\operatorname{Du}(\underline{\psi} \cdot \underline{\psi}) = 0",
                but_not=r"\operatorname{Du}(\psi \cdot \psi) = 0",
            ),
        ],
        refutes=True,
        counterexample=PAIR.counterexample(r"\operatorname{Du}(\underline{\psi} \cdot \underline{\psi}) = 0"),
        reason="where ψ·ψ₀ ≠ 0 the dual part of |ψ̲| is not 0, so |ψ̲| is no real number",
    )


def pure_translations() -> Verdict:
    """ψ = 0 exactly if |ψ̲| is in ε ℝ; the screw 0 of the identity is there too, although ψ₀ = 0."""
    return _conditional(
        "the screw 0, that of the identity, has |ψ̲| = 0 in ε ℝ without ψ₀ ≠ 0",
    )


def pure_rotations() -> Verdict:
    """For ψ ≠ 0, ψ·ψ₀ = 0 exactly if |ψ̲| is real; the screw 0 has a real magnitude too."""
    return _conditional(
        "the screw 0, that of the identity, has the real magnitude 0 without ψ ≠ 0",
    )


def screws_tell_displacements_apart() -> Verdict:
    """d = u·ρ = ψ·ψ₀/‖ψ‖ tells rotations from roto-translations unless exp turns by a full turn."""
    return argue(
        [
            *full_turn(),
            SCREW.step(
                "tr Q = 3 − 2 (1 − cos a): with cos a ≠ 1 the displacement turns",
                r"\operatorname{tr} Q = 3 - 2 (1 - \cos a)",
                but_not=r"\operatorname{tr} Q = 3 - (1 - \cos a)",
            ),
            SCREW.step(
                "ψ·ψ₀ = a d and w·ρ = d: points come back to their places exactly on the axis, and if d = 0",
                r"(a w) \cdot (a m + d w) = a d",
                r"w \cdot \rho = d",
                r"w \cdot (Q x + \rho - x) = d",
                but_not=r"w \cdot (Q x + \rho - x) = 0",
            ),
        ],
        hypothesis=r"\cos \alpha \neq 1",
        counterexample=Counterexample(
            values={
                r"\cos \alpha": ("1",),
                r"\sin \alpha": ("0",),
                r"\mathbf{u}": ("0", "0", "1"),
                r"\mathbf{u}_0": ("0", "0", "0"),
                "d": ("1",),
            },
            left=("0", "0", "1"),
            right=("0", "0", "0"),
        ),
        reason="with a full turn, a roto-translation by ψ̲ is a translation, and a rotation is the identity",
    )


def _magnitude() -> list[Step]:
    return [
        PAIR.step(
            "where ψ ≠ 0, |ψ| has the real part ‖ψ‖ ≠ 0 and ‖ψ‖ times its dual part is ψ·ψ₀",
            r"\operatorname{Re} |\underline{\psi}| = \|\psi\|",
            r"\|\psi\| \operatorname{Du} |\underline{\psi}| = \psi \cdot \psi_0",
            but_not=r"\|\psi\| \operatorname{Du} |\underline{\psi}| = 0",
        ),
        PAIR.step(
            "its square is ψ·ψ + 2 ε ψ·ψ₀",
            r"\underline{\psi} \cdot \underline{\psi} = \psi \cdot \psi + 2 \varepsilon \psi \cdot \psi_0",
            but_not=r"\underline{\psi} \cdot \underline{\psi} = \psi \cdot \psi + \varepsilon \psi \cdot"
            r" \psi_0",
        ),
    ]


def _conditional(reason: str) -> Verdict:
    zero = ("0", "0", "0")
    return argue(
        [
            *_magnitude(),
            PAIR.step(
                "where ψ = 0, exp is I + ε ψ̃₀, a translation by ψ₀, and |ψ| is ε ‖ψ₀‖ by (74)",
                r"\exp(\varepsilon \tilde{\psi}_0) = \mathbf{I} + \varepsilon \tilde{\psi}_0",
                but_not=r"\exp(\varepsilon \tilde{\psi}_0) = \mathbf{I} - \varepsilon \tilde{\psi}_0",
            ),
        ],
        hypothesis=r"\underline{\boldsymbol{\psi}} \neq \mathbf{0}",
        counterexample=Counterexample(
            values={r"\boldsymbol{\psi}": zero, r"\boldsymbol{\psi}_0": zero},
            left=("0", "0"),
            right=("0", "0"),
        ),
        reason=reason,
    )


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (roto_translations, pure_translations, pure_rotations, screws_tell_displacements_apart)
}
