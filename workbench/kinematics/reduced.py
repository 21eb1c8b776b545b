"""Reduced accelerations of every order and their helicoidal fields, Eqs. (89)–(103).

ω̲ = ω + ε v is the dual angular velocity of a body, v = ρ̇ − ω × ρ being the velocity of the body
point at the origin of the fixed frame. The reduced acceleration of order n of the body point at ρ is
A^[n] = v⁽ⁿ⁾ + ω⁽ⁿ⁾ × ρ: order 0 is the velocity, 1 the reduced acceleration, 2 the reduced jerk and
3 the reduced jounce. Vectors have shape (..., 3), leading axes are a batch, over any scalar ring;
A^[n] has the unit length/timeⁿ⁺¹, ω⁽ⁿ⁾ rad/timeⁿ⁺¹.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from workbench.algebra.dual import Du, Dual
from workbench.algebra.dual_tensors import cross, norm, transpose, unit, vect
from workbench.kinematics.numbers import takes_numbers, takes_reals


@takes_numbers
def dual_angular_velocity(R: Dual, R_dot: Dual) -> Dual:
    """Returns ω̲ = vect(Ṙ̲ R̲ᵀ), Eq. (89), of an orthogonal dual tensor and its time derivative."""
    return vect(R_dot @ transpose(R))


@takes_numbers
def twist(rho: np.ndarray, velocity: np.ndarray, omega: np.ndarray) -> Dual:
    """Returns ω̲ = ω + ε (ρ̇ − ω × ρ), Eqs. (90) and (92), from one body point's place and velocity."""
    return Dual(omega, velocity - cross(omega, rho))


def reduced_acceleration(
    point_derivatives: Sequence[np.ndarray], omega_derivatives: Sequence[np.ndarray]
) -> np.ndarray:
    """Returns a^[n] of a body point from its motion and the body's, Eq. (100) at every order n.

    A^[n] = ρ⁽ⁿ⁺¹⁾ − Σ_{k=0}^{n−1} C(n, k) ω⁽ᵏ⁾ × ρ⁽ⁿ⁻ᵏ⁾

    ``point_derivatives`` = [ρ̇, …, ρ⁽ⁿ⁺¹⁾] (velocity, acceleration, jerk, …) and
    ``omega_derivatives`` = [ω, …, ω⁽ⁿ⁻¹⁾] or longer; n is one less than the number of the former.
    Raises `ValueError` if there are too few of either.
    """
    n = len(point_derivatives) - 1
    if n < 0 or len(omega_derivatives) < n:
        raise ValueError(
            f"expected n + 1 >= 1 derivatives of the point and at least n of ω, got "
            f"{len(point_derivatives)} and {len(omega_derivatives)}"
        )
    reduced = point_derivatives[n]
    for k in range(n):
        term = cross(omega_derivatives[k], point_derivatives[n - k - 1])
        reduced = reduced - math.comb(n, k) * term
    return reduced


def dual_reduced_acceleration(
    point_derivatives: Sequence[np.ndarray], omega_derivatives: Sequence[np.ndarray]
) -> Dual:
    """Returns ω⁽ⁿ⁾ + ε A^[n], Eqs. (93) and (99), from [ρ̇, …, ρ⁽ⁿ⁺¹⁾] and [ω, …, ω⁽ⁿ⁾] or longer."""
    n = len(point_derivatives) - 1
    if len(omega_derivatives) <= n:
        raise ValueError(f"expected ω and its derivatives up to order {n}")
    return Dual(omega_derivatives[n], reduced_acceleration(point_derivatives, omega_derivatives))


@takes_numbers
def invariant(at_point: Dual, rho: np.ndarray) -> Dual:
    """Returns ω̲⁽ⁿ⁾ = e^{ε ρ̃} A̲_ρ, the same for every body point, Eqs. (95), (98), (103)."""
    return shift(at_point, rho)


@takes_numbers
def field(omega_n: Dual, rho: np.ndarray) -> Dual:
    """Returns a̲_ρ = e^{−ε ρ̃} ω̲⁽ⁿ⁾ = ω⁽ⁿ⁾ + ε (v⁽ⁿ⁾ + ω⁽ⁿ⁾ × ρ), the inverse of Eq. (103)."""
    return shift(omega_n, -rho)


@takes_numbers
def transport(at_Q: Dual, PQ: np.ndarray) -> Dual:
    """Returns a̲_P = e^{ε P̃Q} A̲_Q with PQ = ρ_Q − ρ_P, Eqs. (97) and (101)."""
    return shift(at_Q, PQ)


@takes_numbers
def shift(a: Dual, r: np.ndarray) -> Dual:
    """Returns e^{ε r̃} a = (I + ε r̃) a = a + ε r × Re a, Eq. (94)."""
    return Dual(a.re, a.du + cross(r, a.re))


@takes_reals
def minimum_of_reduced_acceleration(omega_n: Dual) -> Any:
    """Returns min over all ρ of ‖A_ρ^[n]‖ = |Du |ω̲⁽ⁿ⁾||, Eq. (102), by the norm (74).

    It is |ω⁽ⁿ⁾·v⁽ⁿ⁾| / ‖ω⁽ⁿ⁾‖, and ‖v⁽ⁿ⁾‖ where ω⁽ⁿ⁾ = 0, when the field is uniform.
    """
    return abs(Du(norm(omega_n)))


@takes_reals
def locus_of_minimum(omega_n: Dual) -> Dual:
    """Returns the line, a unit dual vector, of the points where ‖A_ρ^[n]‖ is least.

    It is the axis of the screw ω̲⁽ⁿ⁾, ω̲⁽ⁿ⁾ / |ω̲⁽ⁿ⁾|. Raises `ZeroDivisor` if ω⁽ⁿ⁾ = 0: the field is
    then uniform and every point of space is one of least reduced acceleration.
    """
    return unit(omega_n)
