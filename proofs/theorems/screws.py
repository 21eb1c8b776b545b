"""Section 5.3: the natural invariants of a displacement, exp and log (80)–(82).

α = a + ε d is a dual angle, u = w + ε m a unit dual vector, X = I + sin α ũ + (1 − cos α) ũ², Eq. (80).
"""

from __future__ import annotations

from proofs.theorems.euler import rotations_are_unit_quaternions
from workbench.judge.theorems.arguments import Step, argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Counterexample, Verdict

SCREW = Letters(
    {
        r"\alpha": {"kind": "dual scalar"},
        "a": {"kind": "scalar"},
        "d": {"kind": "scalar"},
        "u": {"kind": "dual vector", "unit": True, "constant": True},
        "w": {"kind": "vector", "unit": True, "constant": True},
        "p": {"kind": "vector"},
        "x": {"kind": "vector"},
        "r": {"kind": "vector"},
        "k": {"kind": "scalar"},
        "Y": {"kind": "dual tensor"},
        "T": {"kind": "dual tensor"},
        "b": {"kind": "dual vector"},
        "c": {"kind": "dual vector"},
        "e": {"kind": "dual vector"},
        "A": {"kind": "dual rotation"},
    },
    {
        "X": r"\mathbf{I} + \sin \alpha \tilde{u} + (1 - \cos \alpha) \tilde{u}^2",
        "Q": r"\mathbf{I} + \sin a \tilde{w} + (1 - \cos a) \tilde{w}^2",
        "m": r"p \times w",
        r"\rho": r"d w + \sin a m + (1 - \cos a) w \times m",
        "R": r"\mathbf{I} + \sin(2a) \tilde{w} + (1 - \cos(2a)) \tilde{w}^2",
        "n": r"\frac{1}{2} \left( \frac{\cos a}{\sin a} (r - (w \cdot r) w) - w \times r \right)",
    },
)

PAIR = Letters(
    {r"\psi": {"kind": "vector"}, r"\psi_0": {"kind": "vector"}},
    {r"\underline{\psi}": r"\psi + \varepsilon \psi_0"},
)

_SAME = Counterexample(
    values={
        r"\cos \alpha": ("-1",),
        r"\sin \alpha": ("0",),
        r"\mathbf{R}": ("-1", "0", "0", "0", "-1", "0", "0", "0", "1"),
    },
    left=("0", "0", "1"),
    right=("0", "0", "-1"),
)


def representation_theorem() -> Verdict:
    """Theorem 6: every R̲ = (I + ε ρ̃) R has a dual angle and a unit dual vector with (80)."""
    return argue(_representation())


def exponential_of_a_screw() -> Verdict:
    """(80): the series and the differential equation of the exponential give Rodrigues' formula."""
    return argue(_exponential())


def exponential_is_onto() -> Verdict:
    """Theorem 7: exp sends every skew dual tensor into the group, and every element has a preimage."""
    return argue(_onto())


def logarithm_is_a_set() -> Verdict:
    """(82): the set log R̲ is empty for no R̲; it holds α̲ u̲ for every pair of natural invariants."""
    return argue(_onto())


def logarithm_is_no_inverse() -> Verdict:
    """exp has no inverse: w and −w times π have one exponential, and 2 π w has that of 0."""
    return argue(
        [
            SCREW.step(
                "exp(α ũ) − exp(−α ũ) = 2 sin α ũ, which is 0 at the half turn α = π",
                r"X - (\mathbf{I} + \sin(-\alpha) \tilde{u} + (1 - \cos(-\alpha)) \tilde{u}^2) = 2 \sin"
                r" \alpha \tilde{u}",
                but_not=r"X - (\mathbf{I} + \sin(-\alpha) \tilde{u} + (1 - \cos(-\alpha)) \tilde{u}^2) ="
                r" \sin \alpha \tilde{u}",
            ),
            SCREW.refutation(
                "while the screws α u and −α u differ",
                r"\alpha u = -\alpha u",
                but_not=r"\alpha u = (-\alpha) (-u)",
            ),
            *full_turn(),
        ],
        refutes=True,
        counterexample=_SAME,
        reason="exp takes one value at π u and at −π u; everywhere full turns add infinitely many screws",
    )


def full_turn() -> list[Step]:
    return [
        SCREW.step(
            "R − I = 2 sin a (cos a w̃ + sin a w̃²) for the angle 2 a: at the full turn, a = π, it is 0",
            r"R - \mathbf{I} = 2 \sin a (\cos a \tilde{w} + \sin a \tilde{w}^2)",
            but_not=r"R - \mathbf{I} = \sin a (\cos a \tilde{w} + \sin a \tilde{w}^2)",
        )
    ]


def _exponential() -> list[Step]:
    return [
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


def _representation() -> list[Step]:
    quaternion = (
        r"((\cos a)^2 - (\sin a w)^2) \mathbf{I} + 2 (\sin a w) \otimes (\sin a w)"
        r" + 2 \cos a \widetilde{(\sin a w)}"
    )
    return [
        rotations_are_unit_quaternions(),
        SCREW.step(
            "the unit quaternion (cos a, sin a w) is the rotation (80) by 2 a about w",
            rf"{quaternion} = R",
            but_not=r"((\cos a)^2 - (\sin a w)^2) \mathbf{I} + 2 \cos a \widetilde{(\sin a w)} = R",
        ),
        SCREW.step(
            "where sin a ≠ 0, d = w·r and u₀ = ½ (cot a (r − (w·r) w) − w × r) give any translation r, and"
            " w·u₀ = 0",
            r"(w \cdot r) w + \sin(2a) n + (1 - \cos(2a)) w \times n = r",
            r"w \cdot n = 0",
            but_not=r"\sin(2a) n + (1 - \cos(2a)) w \times n = r",
        ),
        SCREW.step(
            "(80) for α̲ = 2 a + ε d, u̲ = w + ε n is (I + ε ρ̃) R with that ρ",
            r"\mathbf{I} + \sin(2a + \varepsilon d) \widetilde{(w + \varepsilon m)}"
            r" + (1 - \cos(2a + \varepsilon d)) \widetilde{(w + \varepsilon m)}^2"
            r" = (\mathbf{I} + \varepsilon \widetilde{(d w + \sin(2a) m + (1 - \cos(2a)) w \times m)}) R",
            but_not=r"\mathbf{I} + \sin(2a + \varepsilon d) \widetilde{(w + \varepsilon m)}"
            r" = (\mathbf{I} + \varepsilon \widetilde{(d w + \sin(2a) m)}) R",
        ),
        SCREW.step(
            "where R = I, α̲ = ε d gives the translation d w; any vector is d w with a unit vector w",
            r"\mathbf{I} + \sin(\varepsilon d) \tilde{w} + (1 - \cos(\varepsilon d)) \tilde{w}^2 ="
            r" \mathbf{I} + \varepsilon d \tilde{w}",
            but_not=r"\mathbf{I} + \sin(\varepsilon d) \tilde{w} + (1 - \cos(\varepsilon d)) \tilde{w}^2 ="
            r" \mathbf{I} + d \tilde{w}",
        ),
    ]


def _onto() -> list[Step]:
    direction = r"\frac{\underline{\psi}}{|\underline{\psi}|}"
    return [
        PAIR.step(
            "where ψ ≠ 0, ψ̲ is |ψ̲| times a unit dual vector",
            rf"{direction} \cdot {direction} = 1",
            rf"|\underline{{\psi}}| {direction} = \underline{{\psi}}",
            but_not=r"\underline{\psi} \cdot \underline{\psi} = 1",
        ),
        *_exponential(),
        SCREW.step(
            "X is orthogonal with determinant 1",
            r"X X^T = \mathbf{I}",
            r"\det X = 1",
            but_not=r"X X = \mathbf{I}",
        ),
        SCREW.step(
            "where ψ = 0, (ε r̃)² = 0 ends the series, and I + ε r̃ is orthogonal with determinant 1",
            r"(\varepsilon \tilde{r})^2 = 0",
            r"(\mathbf{I} + \varepsilon \tilde{r}) (\mathbf{I} + \varepsilon \tilde{r})^T = \mathbf{I}",
            r"\det(\mathbf{I} + \varepsilon \tilde{r}) = 1",
            but_not=r"\varepsilon \tilde{r} = 0",
        ),
        *_representation(),
    ]


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        representation_theorem,
        exponential_of_a_screw,
        exponential_is_onto,
        logarithm_is_a_set,
        logarithm_is_no_inverse,
    )
}
