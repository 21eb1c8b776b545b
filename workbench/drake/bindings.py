"""Table of the quantities of reference motions to which a paper's symbols can be bound.

Names are in Drake's monogram notation. W is the fixed frame, B the moving body (the last one of a chain), A
the body between them on a chain (the chapter's C₀, C₁, C₂ are W, A, B). Bo is the body's origin; P and Q are
two more points fixed in B. A suffix ``_W``, ``_A``, ``_B`` names the frame in which a vector is expressed;
the default is W.

A ``0`` in place of a point denotes the body point that is at the origin of W (or of the named frame) at that
instant: v_WB0 is the chapter's v, Eq. (92). ``dual_`` quantities have the real part at index 0 and the dual
part at index 1 of the first axis.

A binding's name can be followed by ``^(k)``, its k-th time derivative in W (``p_WP^(n)`` is a_ρ^[n] of Eq.
(13)), and the name of a family by ``[k]``, its k-th member (``Phi_WB[n]``): `bound` reads both.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import get_close_matches


@dataclass(frozen=True)
class Binding:
    """A quantity to which symbols can be bound.

    Attributes:
        weight: Its power of 1/second (0 for angles and lengths); the n-th member of a family has n +
            ``weight``.
        made_of: The bindings from whose jets it is computed, if a motion does not have it.
    """

    name: str
    shape: tuple[int, ...]
    weight: int
    meaning: str
    made_of: tuple[str, ...] = ()


VECTOR, TENSOR, DUAL_SCALAR, DUAL_VECTOR, DUAL_TENSOR = (3,), (3, 3), (2,), (2, 3), (2, 3, 3)
POSE, SPATIAL, QUATERNION, JACOBIAN = (4, 4), (6,), (4,), (6, 6)

BODY_BINDINGS = (
    Binding("R_WB", TENSOR, 0, "rotation of B in W; the chapter's R"),
    Binding("X_WB", POSE, 0, "pose of B in W, homogeneous; g of Eq. (23)"),
    Binding("p_WBo", VECTOR, 0, "position of Bo; ρ of Eq. (86)"),
    Binding("p_WP", VECTOR, 0, "position of P; ρ of Eq. (1)"),
    Binding("p_WQ", VECTOR, 0, "position of Q; ρ_Q of Eq. (1)"),
    Binding("p_BoP_B", VECTOR, 0, "P from Bo, in B: constant; r of Eq. (1) with Q at Bo"),
    Binding("p_BoQ_B", VECTOR, 0, "Q from Bo, in B: constant"),
    Binding("p_QP_B", VECTOR, 0, "P from Q, in B: constant; r of Eq. (1)"),
    Binding("p_PQ_W", VECTOR, 0, "Q from P, in W; PQ of Eq. (97)"),
    Binding("w_WB", VECTOR, 1, "angular velocity; ω"),
    Binding("w_WB_B", VECTOR, 1, "angular velocity, expressed in B"),
    Binding("alpha_WB", VECTOR, 2, "angular acceleration; ε of Eq. (9)"),
    Binding("V_WB", SPATIAL, 1, "spatial velocity (ω; v of Bo)"),
    Binding("V_WB_B", SPATIAL, 1, "spatial velocity (ω; v of Bo), expressed in B: the body's twist"),
    Binding("A_WB", SPATIAL, 2, "spatial acceleration (α; a of Bo)"),
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
    Binding("dual_v_WBo", DUAL_VECTOR, 1, "dual velocity ω + ε v of Bo: Drake's V_WB; Eq. (93)"),
    Binding("dual_v_WP", DUAL_VECTOR, 1, "dual velocity ω + ε v_P of the point P; Eq. (93)"),
    Binding("dual_v_WQ", DUAL_VECTOR, 1, "dual velocity ω + ε v_Q of the point Q; Eq. (93)"),
)

RELATIVE_BINDINGS = (
    Binding("R_WA", TENSOR, 0, "rotation of A in W"),
    Binding("R_AB", TENSOR, 0, "rotation of B in A"),
    Binding("X_WA", POSE, 0, "pose of A in W, homogeneous"),
    Binding("X_AB", POSE, 0, "pose of B in A, homogeneous"),
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
)

CYLINDER_BINDINGS = (
    Binding("theta1", (), 0, "angle of the first joint; α₁"),
    Binding("theta2", (), 0, "angle of the second joint; α₂"),
    Binding("q_WA", QUATERNION, 0, "rotation of A in W as a quaternion, scalar first"),
    Binding("q_AB", QUATERNION, 0, "rotation of B in A as a quaternion"),
    Binding("q_WB", QUATERNION, 0, "rotation of B in W as a quaternion"),
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

THIRD_BODY_BINDINGS = (
    Binding("X_WC", POSE, 0, "pose of C in W, homogeneous: C is the third body of a 3C chain"),
    Binding("dual_R_WC", DUAL_TENSOR, 0, "⁰R₃ of Eq. (117), dual"),
    Binding("dual_R_BC", DUAL_TENSOR, 0, "²R₃ of Eq. (117), dual"),
    Binding("dual_w_WC", DUAL_VECTOR, 1, "dual twist of C; ₀ω₃ of Eq. (119)"),
    Binding("dual_w_BC_W", DUAL_VECTOR, 1, "dual twist of C in B, seen from W; ω₃ of Eq. (121)"),
    Binding("dual_w_BC_B", DUAL_VECTOR, 1, "dual twist of C in B, in B; Ω₃ of Eq. (120)"),
    Binding("theta3", (), 0, "angle of the third joint; α₃"),
    Binding("d3", (), 0, "displacement along the third joint"),
    Binding("dual_theta3", DUAL_SCALAR, 0, "θ₃ + ε d₃"),
    Binding("dual_u3_W", DUAL_VECTOR, 0, "third axis as a line, in W; u₃"),
)

SIX_BINDINGS = (
    Binding("qDot", SPATIAL, 1, "rates of the six coordinates of a free body, a 3C chain or a 6R arm"),
    Binding("J_WB", JACOBIAN, 0, "Jacobian of V_WB by these rates"),
)

ANGLE_BINDINGS = (
    Binding("roll_WB", (), 0, "roll of a free body, about x of W: R = R_z(yaw) R_y(pitch) R_x(roll)"),
    Binding("pitch_WB", (), 0, "its pitch, about y"),
    Binding("yaw_WB", (), 0, "its yaw, about z"),
    Binding("R_rpy", TENSOR, 0, "the rotation matrix of these angles, by RollPitchYaw"),
    Binding("rpyDt_WB", VECTOR, 1, "the angles' rates, by RollPitchYaw from w_WB"),
)

TURN_BINDINGS = (
    Binding("rotvec_WB", VECTOR, 0, "rotation vector of R_WB on a longer chain, by ToAngleAxis: below π"),
)

CHAIN_BINDINGS = (*RELATIVE_BINDINGS, *CYLINDER_BINDINGS)

FAMILIES = (
    Binding("Phi_WB", TENSOR, 0, "R⁽ⁿ⁾Rᵀ of R_WB; Φₙ of Eq. (15)", ("R_WB",)),
    Binding("a_WB0", VECTOR, 0, "n-th derivative of the point of B at Wo; aₙ of Eq. (16)", ("R_WB", "p_WBo")),
    Binding("Psi_WB", POSE, 0, "Φₙ and aₙ as a block, X⁽ⁿ⁾X⁻¹ for n ≥ 1; Ψₙ of Eq. (29)", ("R_WB", "p_WBo")),
    Binding(
        "A_WP",
        VECTOR,
        1,
        "n-th rate, at the place of P, of the velocity field; A^[n] of P",
        ("dual_w_WB", "p_WP"),
    ),
    Binding("A_WQ", VECTOR, 1, "the same at the place of Q", ("dual_w_WB", "p_WQ")),
    Binding("A_WBo", VECTOR, 1, "the same at the place of Bo", ("dual_w_WB", "p_WBo")),
    Binding("A_W0", VECTOR, 1, "the same at Wo", ("dual_w_WB", "R_WB", "p_WBo")),
    Binding("dual_A_WP", DUAL_VECTOR, 1, "ω⁽ⁿ⁾ + ε A^[n] of P; Eq. (103)", ("dual_w_WB", "p_WP")),
    Binding("dual_A_WQ", DUAL_VECTOR, 1, "ω⁽ⁿ⁾ + ε A^[n] of Q", ("dual_w_WB", "p_WQ")),
    Binding("dual_A_WBo", DUAL_VECTOR, 1, "ω⁽ⁿ⁾ + ε A^[n] of Bo", ("dual_w_WB", "p_WBo")),
    Binding("dual_A_W0", DUAL_VECTOR, 1, "ω⁽ⁿ⁾ + ε A^[n] at Wo", ("dual_w_WB", "R_WB", "p_WBo")),
    Binding("dual_Phi_WB", DUAL_TENSOR, 0, "R̲⁽ⁿ⁾R̲ᵀ of dual_R_WB", ("dual_R_WB",)),
    Binding("dual_Phi_WA", DUAL_TENSOR, 0, "R̲⁽ⁿ⁾R̲ᵀ of dual_R_WA; Φ̲ₙ of Eq. (125)", ("dual_R_WA",)),
    Binding(
        "dual_w_AB",
        DUAL_VECTOR,
        1,
        "R̲_WA times the n-th rate of dual_w_AB_A; ω̲₂^[n]",
        ("dual_R_WA", "dual_w_AB_A"),
    ),
    Binding(
        "dual_w_BC",
        DUAL_VECTOR,
        1,
        "R̲_WB times the n-th rate of dual_w_BC_B; ω̲₃^[n]",
        ("dual_R_WB", "dual_w_BC_B"),
    ),
)

#: Fields of the chapter at the origin: the position of the body point that is there at that instant.
DERIVED = (
    Binding(
        "p_W0", VECTOR, 0, "the point of B at Wo: 0, with the derivatives of that point", ("R_WB", "p_WBo")
    ),
)

ALIASES = {"v_W0": "v_WB0", "u1": "u1_W", "u2": "u2_W"}

#: Binding name or alias → binding.
BINDINGS = {
    binding.name: binding
    for binding in (
        *BODY_BINDINGS,
        *CHAIN_BINDINGS,
        *THIRD_BODY_BINDINGS,
        *SIX_BINDINGS,
        *ANGLE_BINDINGS,
        *TURN_BINDINGS,
        *DERIVED,
    )
}
BINDINGS |= {alias: BINDINGS[name] for alias, name in ALIASES.items()}
MEMBERS = {binding.name: binding for binding in FAMILIES}

_NAME = re.compile(r"(?P<name>\w+)(?:\[(?P<member>[^\]]+)\])?(?:\^\((?P<rate>[^)]+)\))?")
_COUNT = re.compile(r"(?P<variable>[a-z])?(?P<shift>[+-]?\d+)?")


@dataclass(frozen=True)
class Count:
    """An integer, or n + an integer for the index n of the bound symbol."""

    variable: str | None
    shift: int

    def of(self, index: int) -> int:
        return self.shift if self.variable is None else index + self.shift


@dataclass(frozen=True)
class Bound:
    """The target of a symbol: a binding, the member of a family, the derivative."""

    text: str
    binding: Binding
    member: Count | None = None
    rate: Count | None = None

    @property
    def weight(self) -> tuple[int, int]:
        """(a, b): a symbol of index n must have the weight a n + b."""
        counts = [c for c in (self.member, self.rate) if c is not None]
        return sum(c.variable is not None for c in counts), self.binding.weight + sum(c.shift for c in counts)

    @property
    def needs(self) -> tuple[str, ...]:
        """The quantities that a motion must have."""
        return self.binding.made_of or (self.binding.name,)

    def order(self, index: int) -> int:
        """Returns the order of derivatives needed for the symbol of this index."""
        return sum(count.of(index) for count in (self.member, self.rate) if count is not None)

    @property
    def variables(self) -> frozenset[str]:
        return frozenset(c.variable for c in (self.member, self.rate) if c is not None and c.variable)


def bound(text: str) -> Bound:
    """Returns the target of a name of `BINDINGS` or a member of `MEMBERS`, with ``^(k)`` or ``^(n+1)`` for a
    derivative.

    Raises:
        ValueError: The name is unknown; the message lists similar names.
    """
    match = _NAME.fullmatch(text.replace(" ", ""))
    member = _count(match["member"]) if match and match["member"] else None
    rate = _count(match["rate"]) if match and match["rate"] else None
    table = BINDINGS if member is None else MEMBERS
    if match is None or match["name"] not in table:
        known = [*BINDINGS, *(f"{name}[n]" for name in MEMBERS)]
        near = get_close_matches(text, known, 3, 0.5) or sorted(known)
        raise ValueError(f"unknown quantity {text!r}; expected {' or '.join(near)}")
    return Bound(text, table[match["name"]], member, rate)


def alternatives(text: str) -> tuple[Bound, ...]:
    """Returns the alternatives of ``p_WP or p_W0``; the first one that satisfies a claim's premises is
    used."""
    return tuple(bound(part) for part in text.split(" or "))


def _count(text: str) -> Count:
    match = _COUNT.fullmatch(text)
    if match is None or not text:
        raise ValueError(f"expected a number, or an index and a number such as n-1, got {text!r}")
    return Count(match["variable"], int(match["shift"] or 0))
