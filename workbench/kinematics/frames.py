"""The same motion in Drake's terms and in the chapter's, about another origin, and in another frame.

Twist order: Drake writes a spatial velocity V_WB as (ω; v), rotation first; so do we.
Point: Drake's v is that of the body frame's origin, v_WBo; the chapter's v = a₁ that of the body point
which is at the fixed frame's origin Wo at the instant. Their derivatives differ as well, because the
chapter's v belongs to another body point at each instant.
"""

from __future__ import annotations

from math import comb

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual_tensors import apply, cross, transpose
from workbench.kinematics.tensors import as_tensors, as_vectors

from .fields import paired_derivatives


def chapter_twist(w_WB: ArrayLike, v_WBo: ArrayLike, p_WBo: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns the chapter's (omega, v), each (N, ..., 3), of a body B moving in W, all expressed in W.

    w_WB (N, ..., 3): angular velocity and its derivatives, rad/s¹⁺ᵏ; v_WBo (N, ..., 3): velocity of Bo
    and its derivatives, m/s¹⁺ᵏ; p_WBo (..., 3): position of Bo in m. Eq. (106) with ρ = p_WBo:
        v⁽ⁿ⁾ = p⁽ⁿ⁺¹⁾ - Σₖ C(n,k) ω⁽ⁿ⁻ᵏ⁾ × p⁽ᵏ⁾,  k = 0..n.
    Raises ValueError for a wrong shape.
    """
    omega, v_WBo = paired_derivatives(w_WB, v_WBo, ("w_WB", "v_WBo"))
    p = [as_vectors(p_WBo, "p_WBo"), *v_WBo]
    v = [p[n + 1] - _transport(omega, p, n) for n in range(len(omega))]
    return omega, np.stack(v)


def drake_twist(omega: ArrayLike, v: ArrayLike, p_WBo: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns (w_WB, v_WBo), each (N, ..., 3), of the chapter's (omega, v): the inverse of `chapter_twist`.

    p⁽ⁿ⁺¹⁾ = v⁽ⁿ⁾ + Σₖ C(n,k) ω⁽ⁿ⁻ᵏ⁾ × p⁽ᵏ⁾,  k = 0..n,  p = p_WBo (..., 3) in m. As p is any body point,
    this is also how to get the velocity and its derivatives of one. Raises ValueError for a wrong shape.
    """
    omega, v = paired_derivatives(omega, v, ("omega", "v"))
    p = [as_vectors(p_WBo, "p_WBo")]
    for n in range(len(omega)):
        p.append(v[n] + _transport(omega, p, n))
    return omega, np.stack(p[1:])


def _transport(omega: np.ndarray, p: list[np.ndarray], n: int) -> np.ndarray:
    """Returns (ω × p)⁽ⁿ⁾ by Leibniz."""
    return sum(
        (comb(n, k) * cross(omega[n - k], p[k]) for k in range(1, n + 1)),
        start=cross(omega[n], p[0]),
    )


def about_origin(Phi: ArrayLike, a: ArrayLike, p_WO: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns (Phi, a) about another fixed origin O at the constant p_WO (..., 3): Φ stays, a becomes a + Φ
    p_WO.

    Phi (..., 3, 3), a (..., 3) of orders n >= 1 (a₀ = 0 has no other origin).
    Follows from Eq. (19) with ρ = p_WO + ρ'.
    """
    Phi, a = as_tensors(Phi, "Phi"), as_vectors(a, "a")
    return Phi, a + apply(Phi, as_vectors(p_WO, "p_WO"))


def expressed_in(Phi: ArrayLike, a: ArrayLike, R_FW: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns (R Phi Rᵀ, R a): the field of Phi (..., 3, 3), a (..., 3) expressed in F, R_FW (..., 3, 3)
    constant."""
    Phi, a, R = as_tensors(Phi, "Phi"), as_vectors(a, "a"), as_tensors(R_FW, "R_FW")
    return R @ Phi @ transpose(R), apply(R, a)
