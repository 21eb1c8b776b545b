"""Section 6, (86)–(97): what the dual twist says of a rigid motion x = ρ + R r."""

from __future__ import annotations

from workbench.judge.arguments import argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Verdict

_LETTERS = Letters(
    {"R": {"kind": "rotation"}}
    | {name: {"kind": "vector"} for name in (r"\rho", "x", "y")}
    | {name: {"kind": "vector", "constant": True} for name in "pqr"}
    | {name: {"kind": "dual vector"} for name in "ab"}
    | {"A": {"kind": "dual rotation"}, "c": {"kind": "dual vector"}},
    {
        r"\omega": r"\operatorname{vect}(\dot{R} R^T)",
        "v": r"\dot{\rho} - \omega \times \rho",
        "P": r"\rho + R p",
        "Q": r"\rho + R q",
    },
)


def motion_is_rigid() -> Verdict:
    """(86): lengths, triple products and the body point at r = 0."""
    return argue(
        [
            _LETTERS.step(
                "the distance of two body points, and the triple product of three, do not depend on R and ρ",
                r"(P - Q)^2 = (p - q)^2",
                r"\langle P - \rho, Q - \rho, R r \rangle = \langle p, q, r \rangle",
                but_not=r"P^2 = p^2",
            ),
            _LETTERS.step(
                "the body point r = 0 is at ρ",
                r"P - R p = \rho",
                but_not=r"P = \rho",
            ),
        ]
    )


def dual_angles_are_kept() -> Verdict:
    """After (88): scalar, cross and triple products of dual vectors go with R̲."""
    return argue(
        [
            _LETTERS.step(
                "scalar products, and so the cosines of dual angles and unit lines, are kept",
                r"(A a) \cdot (A b) = a \cdot b",
                but_not=r"(A a) \cdot b = a \cdot b",
            ),
            _LETTERS.step(
                "the common normal goes along, and with it the signed sine",
                r"(A a) \times (A b) = A (a \times b)",
                but_not=r"(A a) \times (A b) = a \times b",
            ),
            _LETTERS.step(
                "triple products are kept: three lines keep their handedness",
                r"\langle A a, A b, A c \rangle = \langle a, b, c \rangle",
                but_not=r"\langle A a, A b, A c \rangle = -\langle a, b, c \rangle",
            ),
        ]
    )


def dual_velocity_is_skew() -> Verdict:
    """(89): with ω̲ = vect W, W = Ȧ Aᵀ is the tilde of ω̲, and Ȧ = ω̲̃ A."""
    twist = r"\widetilde{\operatorname{vect}(\dot{A} A^T)}"
    return argue(
        [
            _LETTERS.step(
                "W = Ȧ Aᵀ is the tilde of vect W, and Ȧ = W A",
                rf"\dot{{A}} A^T = {twist}",
                rf"\dot{{A}} = {twist} A",
                but_not=rf"\dot{{A}} = {twist}",
            )
        ]
    )


def velocity_at_the_origin() -> Verdict:
    """(92): the body point −Rᵀ ρ is at the origin; and any body point P gives the same v."""
    return argue(
        [
            _LETTERS.step(
                "a body point r has the velocity ρ̇ + Ṙ r; for r = −Rᵀ ρ its place is 0 and its velocity v",
                r"\rho + R (-R^T \rho) = 0",
                r"\dot{\rho} + \dot{R} (-R^T \rho) = v",
                but_not=r"\dot{\rho} + \dot{R} (-R^T \rho) = \dot{\rho}",
            ),
            _LETTERS.step(
                "Ṗ − ω × P = v for every body point P",
                r"\dot{P} - \omega \times P = v",
                but_not=r"\dot{P} = v",
            ),
        ]
    )


def twist_and_velocity_field() -> Verdict:
    """The velocity of P is v + ω × P; from the velocities the twist comes back."""
    return argue(
        [
            _LETTERS.step(
                "Ṗ = v + ω × P: the velocity of a body point at P follows from ω and v",
                r"\dot{P} = v + \omega \times P",
                but_not=r"\dot{P} = v",
            ),
            _LETTERS.step(
                "the field v + x × y has the value v at the origin, and its linear part is x̃, whose"
                " vector is x",
                r"\operatorname{vect} \tilde{x} = x",
                r"\tilde{x} y = x \times y",
                but_not=r"\operatorname{vect} \tilde{x} = 2 x",
            ),
        ]
    )


def nilpotent_series_ends() -> Verdict:
    """(94): (ε ρ̃)² = 0, and with it all higher powers."""
    return argue(
        [
            _LETTERS.step(
                "the second and third powers of ε ρ̃ are 0, and each higher one has a factor that is",
                r"(\varepsilon \tilde{\rho})^2 = 0",
                r"(\varepsilon \tilde{\rho})^3 = 0",
                but_not=r"\varepsilon \tilde{\rho} = 0",
            )
        ]
    )


def transport_of_the_dual_velocity() -> Verdict:
    """(97) with PQ = ρ_Q − ρ_P; its control has the opposite sign."""
    at_p, at_q = r"(\omega + \varepsilon \dot{P})", r"(\omega + \varepsilon \dot{Q})"
    return argue(
        [
            _LETTERS.step(
                "V_P = e^{ε PQ~} V_Q for all body points P and Q",
                rf"{at_p} = e^{{\varepsilon \widetilde{{(Q - P)}}}} {at_q}",
                but_not=rf"{at_p} = e^{{\varepsilon \widetilde{{(P - Q)}}}} {at_q}",
            )
        ]
    )


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        motion_is_rigid,
        dual_angles_are_kept,
        dual_velocity_is_skew,
        velocity_at_the_origin,
        twist_and_velocity_field,
        nilpotent_series_ends,
        transport_of_the_dual_velocity,
    )
}
