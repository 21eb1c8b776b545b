"""Rigid displacements as orthogonal dual tensors, and their screws, Eqs. (78)–(85).

The displacement x ↦ R x + ρ is the dual tensor R̲ = (I + ε ρ̃) R, a `Dual` whose parts have shape
(..., 3, 3). Its *structural invariants* are (R, ρ). Its *natural invariants* are the dual angle
α̲ = α + ε d and the unit dual vector u̲ = u + ε u₀, the Plücker coordinates of the Mozzi–Chasles
axis: it rotates by α about that line and shifts by d along it. Its screw is ψ̲ = α̲ u̲, and
R̲ = exp ψ̲. Angles are in radians; ρ, d and u₀ share one unit of length. Leading axes are a batch.

Float arrays take a path that is accurate at every angle, in particular at and near 0, π and 2π.
Arrays of dtype object (exact scalars, Drake Expressions; no batch) take the formulas as they stand.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from workbench.algebra import dual_functions
from workbench.algebra.dual import Dual, Re, is_zero
from workbench.algebra.dual_tensors import (
    adjugate,
    apply,
    cross,
    dot,
    identity,
    is_orthogonal,
    norm,
    scale,
    skew,
    trace,
    transpose,
    unit,
    vect,
)
from workbench.kinematics.numbers import takes_numbers, takes_reals
from workbench.kinematics.rotations import angle_and_axis, length_and_direction, rotation, sine_and_versine

if TYPE_CHECKING:
    from workbench.drake.gate import RigidTransform

ROUNDING = 1e-12  # within which `kind` takes a float for zero, and a length relative to those it came from
TOLERANCE = 1e-9  # how far from orthogonal a float tensor may be and still be read as a displacement


@takes_numbers
def displacement(R: np.ndarray, rho: np.ndarray) -> Dual:
    """Returns R̲ = (I + ε ρ̃) R, Eqs. (79) and (84), from (..., 3, 3) and (..., 3)."""
    return Dual(R, skew(rho) @ R)


@takes_numbers
def structural_invariants(R: Dual) -> tuple[np.ndarray, np.ndarray]:
    """Returns (R, ρ) = (Re R̲, vect(Du R̲ · Rᵀ)), Eq. (85): (..., 3, 3) and (..., 3).

    Raises `ValueError` for a float tensor that is not in the group of Eq. (78).
    """
    _require_orthogonal(R)
    return R.re, vect(R.du @ transpose(R.re))


def from_sine_and_cosine(sine: Any, cosine: Any, u: Dual) -> Dual:
    """Returns R̲ = I + sin α̲ ũ̲ + (1 − cos α̲) ũ̲², Eq. (80), over any ring with sine² + cosine² = 1."""
    return _rodrigues(sine, 1 - cosine, u)


@takes_reals
def from_natural_invariants(alpha: Dual, u: Dual) -> Dual:
    """Returns R̲ of the dual angle α̲ (...) and the unit dual vector u̲ (..., 3), Eqs. (80) and (83)."""
    half_sine = dual_functions.sin(alpha / 2)
    return _rodrigues(dual_functions.sin(alpha), 2 * half_sine * half_sine, u)


def _rodrigues(sine: Any, versine: Any, u: Dual) -> Dual:
    U = skew(u)
    return identity_like(u) + scale(sine, U, rank=2) + scale(versine, U @ U, rank=2)


def identity_like(a: Dual) -> np.ndarray:
    """Returns the unit tensor in floats or in Python integers, as the entries of a are."""
    return identity() if _is_symbolic(a) else np.eye(3)


@takes_reals
def natural_invariants(R: Dual) -> tuple[Dual, Dual]:
    """Returns (α̲, u̲) of a displacement with 0 ≤ α ≤ π, Theorem 6: shapes (...) and (..., 3).

    Not unique where the theorem leaves a choice: at α = π both ±u̲ (with ±d) serve, and u has its
    first component that is not zero positive; a pure translation (α = 0, d = ‖ρ‖) moves along every
    line parallel to ρ, and the one through the origin is given; the identity gets e₃. Near α = 0
    the axis is far away (u₀ ~ ρ/α); the screw ψ̲ of `log` has no such growth. Raises `ValueError`
    for a float tensor that is not orthogonal, and as `norm` and `atan2` do for exact scalars.
    """
    if _is_symbolic(R):
        return _natural_invariants_of_objects(R)
    rotation_tensor, rho = structural_invariants(R)
    alpha, u = angle_and_axis(rotation_tensor)
    shift, direction = length_and_direction(rho)
    is_translation = alpha <= 1e-150 * np.maximum(1, shift)  # u₀ would overflow, R is I to 150 digits
    alpha = np.where(is_translation, 0.0, alpha)
    u = np.where(is_translation[..., None], direction, u)
    cotangent = 1 / np.tan(np.where(is_translation, np.pi, alpha) / 2)
    across = cross(u, rho)
    moment = (cotangent[..., None] * -cross(u, across) - across) / 2
    moment = np.where(is_translation[..., None], 0.0, moment)
    return Dual(alpha, np.where(is_translation, shift, dot(u, rho))), Dual(u, moment)


def _natural_invariants_of_objects(R: Dual) -> tuple[Dual, Dual]:
    if is_zero(R.re - identity()):
        rho = vect(R.du)
        shift = norm(rho)
        if is_zero(shift):
            return Dual(shift, shift), Dual(np.array([0, 0, 1], dtype=object))
        return Dual(0 * shift, shift), Dual(scale(1 / shift, rho))
    sine_u = vect(R)
    return dual_functions.atan2(norm(sine_u), (trace(R) - 1) / 2), unit(sine_u)


@takes_reals
def exp(psi: Dual) -> Dual:
    """Returns exp ψ̲̃, Eqs. (80) and (81), of the screw ψ̲ = ψ + ε ψ₀: (..., 3) → (..., 3, 3)."""
    if _is_symbolic(psi):
        if is_zero(psi.re):
            return Dual(identity(), skew(psi.du))
        alpha = norm(psi)
        return from_natural_invariants(alpha, unit(psi))
    alpha, u = length_and_direction(psi.re)
    sine, versine = sine_and_versine(alpha)
    divisor = np.where(alpha == 0, 1.0, alpha)
    sinc = np.where(alpha == 0, 1.0, sine / divisor)
    along = dot(u, psi.du)[..., None] * u
    across = psi.du - along
    rho = along + sinc[..., None] * across + (versine / divisor)[..., None] * cross(u, across)
    return displacement(rotation(alpha, u), rho)


@takes_reals
def log(R: Dual, turns: int = 0) -> Dual:
    """Returns the screw ψ̲ with exp ψ̲ = R̲, Eq. (82): (..., 3, 3) → (..., 3).

    ``turns`` = 0 gives the principal one, ‖ψ‖ ≤ π, which is continuous up to α = π and near α = 0;
    any other integer k adds k full turns about the same axis, ψ̲ = (α̲ + 2πk) u̲, which near α = 0
    loses digits as 1/α because the axis is far away. Choices and errors as in `natural_invariants`.
    """
    if _is_symbolic(R) and is_zero(R.re - identity()) and turns == 0:
        return Dual(vect(R.re), vect(R.du))
    if _is_symbolic(R) or turns != 0:
        alpha, u = natural_invariants(R)
        return scale(alpha + 2 * np.pi * turns if turns else alpha, u)
    rotation_tensor, rho = structural_invariants(R)
    angle, axis = angle_and_axis(rotation_tensor)
    psi = angle[..., None] * axis
    half_tangent = np.tan(angle / 2)
    half_cotangent = np.where(angle == 0, 1.0, angle / 2 / np.where(angle == 0, 1.0, half_tangent))
    along = dot(axis, rho)[..., None] * axis
    return Dual(psi, along + half_cotangent[..., None] * (rho - along) - cross(psi, rho) / 2)


@takes_numbers
def from_rodrigues_vector(b: Dual) -> Dual:
    """Returns R̲ = I + 2 (b̲̃ + b̲̃²) / (1 + b̲·b̲) of b̲ = tan(α̲/2) u̲: rational, so exact over any
    field."""
    B = skew(b)
    return identity_like(b) + scale(2 / (1 + dot(b, b)), B + B @ B, rank=2)


@takes_numbers
def rodrigues_vector(R: Dual) -> Dual:
    """Returns b̲ = tan(α̲/2) u̲ = 2 vect R̲ / (1 + tr R̲); raises `ZeroDivisor` at α = π."""
    return scale(2 / (1 + trace(R)), vect(R))


@takes_reals
def mozzi_chasles_axis(R: Dual) -> Dual:
    """Returns the unit dual vector u̲ of the axis: (..., 3, 3) → (..., 3).

    Raises `ValueError` if a displacement of the batch is the identity, which fixes every line; of a
    pure translation it is the line through the origin (see `natural_invariants`).
    """
    alpha, u = natural_invariants(R)
    if alpha == 0 if _is_symbolic(R) else np.any((alpha.re == 0) & (alpha.du == 0)):
        raise ValueError("the identity has no axis: expected a displacement that moves something")
    return u


@takes_numbers
def kind(R: Dual, tolerance: float | None = None) -> str:
    """Returns "identity", "translation", "rotation" or "roto-translation", of one displacement.

    A test on R̲ and not on ψ̲, because a ψ̲ of a full turn is no rotation. Exact scalars are decided
    exactly and without a root: adj(R − I) = 2 (1 − cos α) u ⊗ u, so it annuls ρ iff d = u·ρ = 0.
    Floats are decided within ``tolerance`` (`ROUNDING` unless given; 0 is exact): the entries of R − I,
    and ρ and d relative to the greatest of 1, ‖ρ‖ and ‖ρ‖/α, the axis's distance where α is small.
    """
    if tolerance is None:
        tolerance = 0.0 if _is_symbolic(R) else ROUNDING
    rotation_tensor, rho = structural_invariants(R)
    turn = rotation_tensor - identity_like(R)
    if _is_within(turn, tolerance):
        return "identity" if _is_within(rho, tolerance) else "translation"
    axis_tensor = adjugate(turn)
    shift = apply(axis_tensor, rho)
    if tolerance:
        length = np.linalg.norm(np.asarray(rho, dtype=float))
        versine = float(trace(axis_tensor)) / 2  # 1 − cos α = α²/2 at small α
        farthest = max(1.0, length, length / np.sqrt(2 * max(versine, 0.5 * tolerance**2)))
        return "rotation" if _is_within(shift, tolerance * 2 * versine * farthest) else "roto-translation"
    return "rotation" if is_zero(shift) else "roto-translation"


def _is_within(a: np.ndarray, tolerance: float) -> bool:
    return bool(np.all(np.abs(a) <= tolerance)) if tolerance else is_zero(a)


def from_rigid_transform(X: "RigidTransform") -> Dual:
    """Returns Φ of Eq. (84): the dual tensor of a pydrake.math.RigidTransform of any scalar type."""
    return displacement(X.rotation().matrix(), X.translation())


@takes_reals
def to_rigid_transform(R: Dual) -> "RigidTransform":
    """Returns Φ⁻¹ of Eq. (85): the Drake RigidTransform, of the scalar type of R's entries.

    Raises `ValueError` if R has not shape (3, 3) or is a float tensor that is not orthogonal,
    `TypeError` if the entries are neither floats nor Drake scalars.
    """
    from workbench.drake.gate import RigidTransform_, RotationMatrix_

    if R.re.shape != (3, 3):
        raise ValueError(f"expected one displacement, shape (3, 3), got {R.re.shape}")
    rotation_tensor, rho = structural_invariants(R)
    scalar = type(rotation_tensor.flat[0]) if _is_symbolic(R) else float
    if (scalar,) not in RigidTransform_.param_list:
        raise TypeError(f"expected entries of type float, AutoDiffXd or Expression, got {scalar.__name__}")
    return RigidTransform_[scalar](RotationMatrix_[scalar](rotation_tensor), rho)


def _is_symbolic(a: Dual) -> bool:
    if not (isinstance(a, Dual) and isinstance(a.re, np.ndarray)):
        raise TypeError(f"expected a dual vector or tensor (a Dual of arrays), got {a!r}")
    return a.re.dtype == object or a.du.dtype == object


def _require_orthogonal(R: Dual) -> None:
    if not _is_symbolic(R) and R.re.shape[-2:] != (3, 3):
        raise ValueError(f"expected a dual tensor, shape (..., 3, 3), got {R.re.shape}")
    if not _is_symbolic(R) and not is_orthogonal(R, TOLERANCE):
        raise ValueError(
            "expected an orthogonal dual tensor, R̲ R̲ᵀ = I and det R̲ = 1 within "
            f"{TOLERANCE}; R̲ R̲ᵀ − I is off by {_defect(R):.2g}"
        )


def _defect(R: Dual) -> float:
    product = R @ transpose(R)
    return float(max(np.abs(Re(product) - np.eye(3)).max(), np.abs(product.du).max()))
