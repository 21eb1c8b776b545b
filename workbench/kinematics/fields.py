"""The n-th order acceleration field of a rigid body: Φₙ, aₙ, Ψₙ, tₙ, Sₙ and the field's invariants.

Every point ρ of a moving rigid body has the n-th order acceleration (n = 1 velocity, 2 acceleration,
3 jerk, ...; Eq. (13). Eq. (107) of the chapter counts from 0 instead and is not used here)

    dⁿρ/dtⁿ = aₙ + Φₙ ρ,                          Eq. (19)

with the tensor Φₙ = R⁽ⁿ⁾ Rᵀ (Eq. (15)) and the invariant vector aₙ, the n-th order acceleration of
the body point that is at the origin of the fixed frame (Eq. (16)).

Shapes. A motion at one instant is its twist (ω, v) with the time derivatives,

    omega, v : (N, ..., 3),   omega[k] = dᵏω/dtᵏ in rad/s¹⁺ᵏ,   v[k] = dᵏv/dtᵏ in m/s¹⁺ᵏ,

derivative first, batch axes between. From N of them follow the orders up to N:

    Phi : (N+1, ..., 3, 3),   Phi[n] = Φₙ in 1/sⁿ, Phi[0] = I,
    a   : (N+1, ..., 3),      a[n] = aₙ in m/sⁿ,   a[0] = 0.

All vectors are measured and differentiated in the fixed frame. The chapter's v = a₁ is the velocity
of the body point at the fixed origin; Drake's is that of the body frame's origin Bo:
`chapter_twist` and `drake_twist` convert.

Scalars: float64, or exact and symbolic ones in arrays of dtype object (see `tensors`).
"""

from __future__ import annotations

from math import comb

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual import divide
from workbench.algebra.dual_tensors import adjugate, apply, cross, determinant, skew, trace, vect
from workbench.kinematics.tensors import as_tensors, as_vectors, identity_like, scalar_kind, sym


def paired_derivatives(x: ArrayLike, y: ArrayLike, names: tuple[str, str]) -> tuple[np.ndarray, np.ndarray]:
    """Returns two vectors, each (N, ..., 3). Raises ValueError unless both have equally many derivatives."""
    x, y = _derivatives(x, names[0]), _derivatives(y, names[1])
    if len(x) != len(y):
        raise ValueError(
            f"{names[0]} and {names[1]}: expected as many derivatives of one as of the other, "
            f"got {len(x)} and {len(y)}"
        )
    return x, y


def _derivatives(x: ArrayLike, name: str) -> np.ndarray:
    x = as_vectors(x, name)
    if x.ndim < 2 or x.shape[0] == 0:
        raise ValueError(f"{name}: expected shape (N, ..., 3) with N >= 1, derivative first, got {x.shape}")
    return x


def acceleration_tensors(omega: ArrayLike) -> np.ndarray:
    """Returns Φ₀ ... Φ_N of omega (N, ..., 3), as (N+1, ..., 3, 3): Φₙ = R⁽ⁿ⁾ Rᵀ, Eq. (15).

    By Leibniz on Ṙ = ω̃ R, and so free of derivatives of Φ (equivalent to Eq. (20)):
        Φₙ₊₁ = Σₖ C(n,k) ω̃⁽ⁿ⁻ᵏ⁾ Φₖ,  k = 0..n,  Φ₀ = I.
    Units: rad/s to the power of the derivative's order in, 1/sⁿ out. Raises ValueError for a wrong shape.

    >>> Phi = acceleration_tensors([[0, 0, 2], [0, 0, 0]])  # a steady turn about z
    >>> Phi[2].tolist()
    [[-4.0, 0.0, 0.0], [0.0, -4.0, 0.0], [0.0, 0.0, 0.0]]
    """
    omega_tilde = skew(_derivatives(omega, "omega"))
    Phi = [identity_like(omega_tilde[0])]
    for n in range(len(omega_tilde)):
        higher = [comb(n, k) * omega_tilde[n - k] @ Phi[k] for k in range(1, n + 1)]
        Phi.append(sum(higher, start=omega_tilde[n]))
    return np.stack(Phi)


def invariant_vectors(omega: ArrayLike, v: ArrayLike) -> np.ndarray:
    """Returns a₀ ... a_N of omega, v (N, ..., 3), as (N+1, ..., 3): the aₙ of Eqs. (16), (20).

    By Leibniz on ρ̇ = v + ω × ρ for the body point at the origin:
        aₙ₊₁ = v⁽ⁿ⁾ + Σₖ C(n,k) ω⁽ⁿ⁻ᵏ⁾ × aₖ,  k = 1..n,  a₀ = 0.
    Units: rad/s and m/s and their derivatives in, m/sⁿ out. Raises ValueError for a wrong shape.

    >>> invariant_vectors([[0, 0, 2], [0, 0, 0]], [[1, 0, 0], [0, 0, 0]]).tolist()
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]
    """
    omega, v = paired_derivatives(omega, v, ("omega", "v"))
    a = [0 * (omega[0] + v[0])]
    for n in range(len(v)):
        higher = [comb(n, k) * cross(omega[n - k], a[k]) for k in range(1, n + 1)]
        a.append(sum(higher, start=v[n] + a[0]))
    return np.stack(a)


def homogeneous_tensors(Phi: ArrayLike, a: ArrayLike) -> np.ndarray:
    """Returns Ψₙ = [Φₙ aₙ; 0 0], (..., 4, 4), of Phi (..., 3, 3) and a (..., 3); Eq. (29)."""
    Phi, a = as_tensors(Phi, "Phi"), as_vectors(a, "a")
    Phi, a = np.broadcast_arrays(Phi, a[..., None])
    upper = np.concatenate([Phi, a[..., :1]], axis=-1)
    return np.concatenate([upper, 0 * upper[..., :1, :]], axis=-2)


def twist_from_field(Phi: ArrayLike, a: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Returns (omega, v), each (N, ..., 3), of Phi (N+1, ..., 3, 3) and a (N+1, ..., 3): the way back.

    The inverse of `acceleration_tensors` and `invariant_vectors`, order by order (cf. Eq. (22)):
        ω⁽ⁿ⁾ = vect(Φₙ₊₁ - Σₖ C(n,k) ω̃⁽ⁿ⁻ᵏ⁾ Φₖ),   v⁽ⁿ⁾ = aₙ₊₁ - Σₖ C(n,k) ω⁽ⁿ⁻ᵏ⁾ × aₖ,  k = 1..n.
    Only the skew parts of Phi are asked; `acceleration_tensors(omega)` shows whether the symmetric
    parts belong to a rigid motion. Raises ValueError for a wrong shape.
    """
    Phi, a = as_tensors(Phi, "Phi"), as_vectors(a, "a")
    if Phi.ndim < 3 or a.ndim < 2 or len(Phi) != len(a) or len(Phi) < 2:
        raise ValueError(
            "Phi and a: expected shapes (N+1, ..., 3, 3) and (N+1, ..., 3) with N >= 1, "
            f"order first and from 0, got {Phi.shape} and {a.shape}"
        )
    omega: list[np.ndarray] = []
    v: list[np.ndarray] = []
    for n in range(len(Phi) - 1):
        known = [comb(n, k) * skew(omega[n - k]) @ Phi[k] for k in range(1, n + 1)]
        omega.append(vect(Phi[n + 1] - sum(known, start=0 * Phi[0])))
        known = [comb(n, k) * cross(omega[n - k], a[k]) for k in range(1, n + 1)]
        v.append(a[n + 1] - sum(known, start=0 * a[0]))
    return np.stack(omega), np.stack(v)


def acceleration(Phi: ArrayLike, a: ArrayLike, rho: ArrayLike) -> np.ndarray:
    """Returns aₙ + Φₙ ρ, (..., 3), in m/sⁿ: the n-th order acceleration of the body point at rho; Eq. (19).

    Phi (..., 3, 3), a (..., 3) and rho (..., 3) in m broadcast: whole stacks of orders with one
    point, or one order (Phi[n], a[n]) with many points. Raises ValueError for a wrong shape.

    >>> Phi = acceleration_tensors([[0, 0, 2], [0, 0, 0]])
    >>> acceleration(Phi[2], [0, 0, 0], [3, 0, 5]).tolist()  # towards the axis
    [-12.0, 0.0, 0.0]
    """
    return as_vectors(a, "a") + apply(as_tensors(Phi, "Phi"), as_vectors(rho, "rho"))


def t(Phi: ArrayLike) -> np.ndarray:
    """Returns tₙ = vect Φₙ, (..., 3); recurrence Eq. (54)."""
    return vect(as_tensors(Phi, "Phi"))


def S(Phi: ArrayLike) -> np.ndarray:
    """Returns Sₙ = sym Φₙ, (..., 3, 3); recurrence Eq. (55)."""
    return sym(as_tensors(Phi, "Phi"))


def divergence(Phi: ArrayLike) -> np.ndarray:
    """Returns div of the n-th order acceleration field, (...): tr Φₙ; Eq. (52)."""
    return trace(as_tensors(Phi, "Phi"))


def curl(Phi: ArrayLike) -> np.ndarray:
    """Returns curl of the n-th order acceleration field, (..., 3): 2 vect Φₙ; Eq. (52)."""
    return 2 * t(Phi)


def invariant_I(Phi: ArrayLike, a_rho: ArrayLike, rho: ArrayLike) -> np.ndarray:
    """Returns Iₙ = a_ρ⁽ⁿ⁾ - Φₙ ρ, (..., 3), the same at every point (and equal to aₙ); Eq. (46).

    a_rho (..., 3): the n-th order acceleration of the body point at rho (..., 3).
    """
    return as_vectors(a_rho, "a_rho") - apply(as_tensors(Phi, "Phi"), as_vectors(rho, "rho"))


def invariant_J(Phi: ArrayLike, a_rho: ArrayLike, rho: ArrayLike) -> np.ndarray:
    """Returns Jₙ = Φₙ* a_ρ⁽ⁿ⁾ - (det Φₙ) ρ, (..., 3), the same at every point (Φₙ* aₙ); Eq. (48)."""
    Phi, rho = as_tensors(Phi, "Phi"), as_vectors(rho, "rho")
    return apply(adjugate(Phi), as_vectors(a_rho, "a_rho")) - np.asarray(determinant(Phi))[..., None] * rho


def invariant_K(Phi_m: ArrayLike, a_rho_m: ArrayLike, Phi_n: ArrayLike, a_rho_n: ArrayLike) -> np.ndarray:
    """Returns K_{m,n} = a_ρ⁽ᵐ⁾ - Φₘ Φₙ⁻¹ a_ρ⁽ⁿ⁾, (..., 3), the same at every point; Eq. (51).

    Equal to aₘ - Φₘ Φₙ⁻¹ aₙ, the m-th order acceleration of the n-th order centre.
    Raises ValueError where Φₙ is singular, as `solve` does.
    """
    Phi_m, Phi_n = as_tensors(Phi_m, "Phi_m"), as_tensors(Phi_n, "Phi_n")
    a_rho_m, a_rho_n = as_vectors(a_rho_m, "a_rho_m"), as_vectors(a_rho_n, "a_rho_n")
    return a_rho_m - apply(Phi_m, solve(Phi_n, a_rho_n))


def solve(T: ArrayLike, x: ArrayLike) -> np.ndarray:
    """Returns T⁻¹ x = T* x / det T, (..., 3), of a regular tensor T (..., 3, 3) and x (..., 3).

    Floats go through LU. Raises ValueError where an exact or float T is singular; symbolic scalars are
    taken to be regular, as nobody can know.
    """
    T, x = as_tensors(T, "T"), as_vectors(x, "x")
    kind = scalar_kind(T, x)
    if kind == "float":
        try:
            return np.linalg.solve(T.astype(float), x.astype(float)[..., None])[..., 0]
        except np.linalg.LinAlgError:
            raise ValueError("T: expected a regular tensor, got one with det T = 0") from None
    volume = np.asarray(determinant(T))
    if kind == "exact" and np.any(volume == 0):
        raise ValueError("T: expected a regular tensor, got one with det T = 0")
    return divide(apply(adjugate(T), x), volume[..., None])
