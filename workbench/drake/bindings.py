"""The quantities of a reference motion that a paper's symbols can be bound to: one table.

Names are Drake's monogram notation. W is the fixed frame, B the moving body (the last one of a
chain), A the body between them on a chain (the chapter's C₀, C₁, C₂ are W, A, B). Bo is the body's
origin, P and Q are two more points fixed in B. ``_W``, ``_A``, ``_B`` at the end say the frame that
a vector is expressed in; without one it is W.

A ``0`` in place of a point is the point of the body that passes the origin of W (or of the frame
named) at that instant: v_WB0 is the chapter's v, Eq. (92). ``dual_`` quantities have the real part
at index 0 and the dual part at index 1 of the first axis.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Binding:
    """``weight``: the power of 1/second it carries (0 for angles and lengths)."""

    name: str
    shape: tuple[int, ...]
    weight: int
    meaning: str


VECTOR, TENSOR, DUAL_SCALAR, DUAL_VECTOR, DUAL_TENSOR = (3,), (3, 3), (2,), (2, 3), (2, 3, 3)

BODY_BINDINGS = (
    Binding("R_WB", TENSOR, 0, "rotation of B in W; the chapter's R"),
    Binding("X_WB", (4, 4), 0, "pose of B in W, homogeneous; g of Eq. (23)"),
    Binding("p_WBo", VECTOR, 0, "position of Bo; ρ of Eq. (86)"),
    Binding("p_WP", VECTOR, 0, "position of P; ρ of Eq. (1)"),
    Binding("p_WQ", VECTOR, 0, "position of Q; ρ_Q of Eq. (1)"),
    Binding("p_BoP_B", VECTOR, 0, "P from Bo, in B: constant; r of Eq. (1) with Q at Bo"),
    Binding("p_BoQ_B", VECTOR, 0, "Q from Bo, in B: constant"),
    Binding("p_QP_B", VECTOR, 0, "P from Q, in B: constant; r of Eq. (1)"),
    Binding("p_PQ_W", VECTOR, 0, "Q from P, in W; PQ of Eq. (97)"),
    Binding("w_WB", VECTOR, 1, "angular velocity; ω"),
    Binding("alpha_WB", VECTOR, 2, "angular acceleration; ε of Eq. (9)"),
    Binding("v_WBo", VECTOR, 1, "velocity of Bo"),
    Binding("v_WP", VECTOR, 1, "velocity of P; v of Eq. (2)"),
    Binding("v_WQ", VECTOR, 1, "velocity of Q; v_Q of Eq. (2)"),
    Binding("v_WB0", VECTOR, 1, "velocity of the point of B at Wo; v of Eq. (92), a₁ of Eq. (4)"),
    Binding("a_WBo", VECTOR, 2, "acceleration of Bo"),
    Binding("a_WP", VECTOR, 2, "acceleration of P; a of Eq. (2)"),
    Binding("a_WQ", VECTOR, 2, "acceleration of Q; a_Q of Eq. (2)"),
    Binding("a_WB0", VECTOR, 2, "acceleration of the point of B at Wo; a₂ of Eq. (4)"),
    Binding("dual_R_WB", DUAL_TENSOR, 0, "dual rotation (I + ε p̃) R; Eq. (87)"),
    Binding("dual_w_WB", DUAL_VECTOR, 1, "dual twist ω + ε v; Eq. (90)"),
    Binding("dual_v_WP", DUAL_VECTOR, 1, "dual velocity ω + ε v_P of the point P; Eq. (93)"),
    Binding("dual_v_WQ", DUAL_VECTOR, 1, "dual velocity ω + ε v_Q of the point Q; Eq. (93)"),
)

CHAIN_BINDINGS = (
    Binding("R_WA", TENSOR, 0, "rotation of A in W"),
    Binding("R_AB", TENSOR, 0, "rotation of B in A"),
    Binding("X_WA", (4, 4), 0, "pose of A in W, homogeneous"),
    Binding("X_AB", (4, 4), 0, "pose of B in A, homogeneous"),
    Binding("p_WAo", VECTOR, 0, "position of Ao"),
    Binding("p_ABo_A", VECTOR, 0, "position of Bo from Ao, in A"),
    Binding("w_WA", VECTOR, 1, "angular velocity of A"),
    Binding("w_AB_W", VECTOR, 1, "angular velocity of B in A, expressed in W"),
    Binding("w_AB_A", VECTOR, 1, "angular velocity of B in A, expressed in A"),
    Binding("v_WAo", VECTOR, 1, "velocity of Ao"),
    Binding("v_WA0", VECTOR, 1, "velocity of the point of A at Wo"),
    Binding("v_AB0_W", VECTOR, 1, "velocity in A of the point of B at Wo, expressed in W"),
    Binding("v_AB0_A", VECTOR, 1, "velocity in A of the point of B at Ao, expressed in A"),
    Binding("dual_R_WA", DUAL_TENSOR, 0, "⁰R₁ of Eq. (117), dual"),
    Binding("dual_R_AB", DUAL_TENSOR, 0, "¹R₂ of Eq. (117), dual"),
    Binding("dual_w_WA", DUAL_VECTOR, 1, "dual twist of A; ω₁ of Eqs. (120)-(122)"),
    Binding("dual_w_AB_W", DUAL_VECTOR, 1, "dual twist of B in A, seen from W; ω₂ of Eq. (121)"),
    Binding("dual_w_AB_A", DUAL_VECTOR, 1, "dual twist of B in A, in A; Ω₂ of Eq. (120)"),
    Binding("theta1", (), 0, "angle of the first joint; α₁"),
    Binding("theta2", (), 0, "angle of the second joint; α₂"),
    Binding("d1", (), 0, "displacement along the first joint"),
    Binding("d2", (), 0, "displacement along the second joint"),
    Binding("dual_theta1", DUAL_SCALAR, 0, "θ₁ + ε d₁; dual angle of Eq. (137)"),
    Binding("dual_theta2", DUAL_SCALAR, 0, "θ₂ + ε d₂; dual angle of Eq. (138)"),
    Binding("u1_W", VECTOR, 0, "unit vector of the first axis: constant"),
    Binding("u2_A", VECTOR, 0, "unit vector of the second axis, in A: constant"),
    Binding("u2_W", VECTOR, 0, "unit vector of the second axis, in W"),
    Binding("dual_u1_W", DUAL_VECTOR, 0, "first axis as a line: constant; u₁ of Eq. (139)"),
    Binding("dual_u2_A", DUAL_VECTOR, 0, "second axis as a line, in A: constant; u₂ of Eq. (138)"),
    Binding("dual_u2_W", DUAL_VECTOR, 0, "second axis as a line, in W; u₂ of Eq. (140)"),
)

ALIASES = {"v_W0": "v_WB0", "u1": "u1_W", "u2": "u2_W"}

#: Every binding by its name and by its aliases.
BINDINGS = {binding.name: binding for binding in (*BODY_BINDINGS, *CHAIN_BINDINGS)}
BINDINGS |= {alias: BINDINGS[name] for alias, name in ALIASES.items()}
