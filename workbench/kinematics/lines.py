"""Lines of Euclidean 3-space as unit dual vectors: u̲ = u + ε p × u for any point p of the line.

u · u = 1 and u · u₀ = 0 (the Plücker condition) together say |u̲| = 1, Eq. (74). Parts have shape
(..., 3); leading axes are a batch. A line is oriented; points and moments share one unit of length.
"""

from typing import Any

import numpy as np

from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import as_vector, cross, dot, norm, scale, unit
from workbench.kinematics.numbers import takes_numbers, takes_reals

PARALLEL = 4 * np.finfo(float).eps  # ‖u₁ × u₂‖ of float lines whose directions differ by rounding


@takes_reals
def line_through(point: np.ndarray, direction: np.ndarray) -> Dual:
    """Returns the line through a point along a direction of any length but zero (`ZeroDivisor`)."""
    point, direction = as_vector(point), as_vector(direction)
    return unit(Dual(direction, cross(point, direction)))


@takes_reals
def line_joining(p: np.ndarray, q: np.ndarray) -> Dual:
    """Returns the line from p to q; raises `ZeroDivisor` if they are one point."""
    p, q = as_vector(p), as_vector(q)
    return line_through(p, q - p)


@takes_numbers
def is_line(a: Dual, tolerance: float = 0.0) -> bool:
    """True if a·a = 1 in both parts: unit direction, and the Plücker condition u · u₀ = 0.

    With ``tolerance`` 0 exactly; else within it, the dual part relative to max(1, ‖u₀‖).
    """
    square = dot(a, a)
    if tolerance == 0:
        return square == Dual(0 * square.re + 1)
    moment = np.maximum(1.0, norm(a.du))
    is_unit = np.abs(square.re - 1) <= tolerance
    return bool(np.all(is_unit) and np.all(np.abs(square.du) <= tolerance * moment))


@takes_numbers
def nearest_point_to_origin(line: Dual) -> np.ndarray:
    """Returns the foot u × u₀ of the perpendicular from the origin."""
    return cross(line.re, line.du)


@takes_numbers
def nearest_point(line: Dual, point: np.ndarray) -> np.ndarray:
    """Returns the foot of the perpendicular from a point."""
    return nearest_point_to_origin(line) + scale(dot(line.re, point), line.re)


@takes_reals
def distance_to_point(line: Dual, point: np.ndarray) -> Any:
    """Returns ‖u₀ − p × u‖, the distance of a point p from a line."""
    return norm(line.du - cross(point, line.re))


@takes_reals
def dual_angle(first: Dual, second: Dual) -> Dual:
    """Returns the dual angle θ̲ = θ + ε h with u̲₁ · u̲₂ = cos θ̲, for float lines: shape (...).

    θ in [0, π] is the angle of the directions, |h| the distance; where the lines are not parallel, h
    has the sign of (p₂ − p₁) · (u₁ × u₂), where they are, h ≥ 0. Directions are taken as parallel
    where ‖u₁ × u₂‖ ≤ 4 machine epsilons; short of that h loses digits as 1/θ.
    """
    product = cross(first, second)
    sine = norm(product.re)
    angle = np.arctan2(sine, dot(first.re, second.re))
    is_parallel = sine <= PARALLEL
    apart = nearest_point_to_origin(second) - nearest_point_to_origin(first)
    normal = product.re / np.where(is_parallel, 1.0, sine)[..., None]
    return Dual(angle, np.where(is_parallel, norm(cross(first.re, apart)), dot(apart, normal)))


@takes_reals
def angle(first: Dual, second: Dual) -> Any:
    """Returns the angle of two oriented float lines, in [0, π]."""
    return dual_angle(first, second).re


@takes_reals
def distance(first: Dual, second: Dual) -> Any:
    """Returns the distance of two float lines, ≥ 0; skew, crossing or parallel."""
    return np.abs(dual_angle(first, second).du)


@takes_reals
def common_normal(first: Dual, second: Dual) -> Dual:
    """Returns the line u̲₁ × u̲₂ / |u̲₁ × u̲₂| that meets both lines at right angles.

    Raises `ZeroDivisor` if the lines are exactly parallel: then it is not unique.
    """
    return unit(cross(first, second))
