"""The instantaneous screw axes of three bodies and their common perpendiculars, Remark 7.

ω̲₁ is the dual twist of body 1 relative to body 0, ω̲₂ that of body 2 relative to body 1, both seen
from one frame; ω̲₁ + ω̲₂ is that of body 2 relative to body 0. Where ω₁ × ω₂ ≠ 0, the line of the
dual vector ω̲₁ × ω̲₂ is the one common perpendicular of the three axes. The remark does not say so,
but where ω₁ × ω₂ = 0 the dual vector has no real part and belongs to no line. What is true then:

======================  =====================================================================
configuration           common perpendiculars of the axes that there are
======================  =====================================================================
SKEW                    one, the line of ω̲₁ × ω̲₂; no two axes meet
TWO_MEET                the same; two of the axes meet on it, the third passes elsewhere
CONCURRENT              the same; all three meet in one point of it
PARALLEL                three distinct axes in one plane, whatever the pitches: every line of
                        that plane at right angles to them; Du(ω̲₁ × ω̲₂) is its direction
COINCIDENT              three axes on one line: every line that meets it at right angles
PARALLEL_TRANSLATION    two distinct parallel axes, the third motion is a translation: as
                        PARALLEL, and all of them are at right angles to the translation
COINCIDENT_TRANSLATION  two axes on one line, the third motion slides along it: as COINCIDENT
COINCIDENT_REST         two axes on one line, the third motion is rest: as COINCIDENT
TRANSLATIONS            no motion has an axis, and one at least is a translation
REST                    nothing moves
======================  =====================================================================

With axes that meet (TWO_MEET, CONCURRENT) the feet decide: if those of ω̲₁ and ω̲₂ are one point,
that of ω̲₁ + ω̲₂ is at (p₂ − p₁) ω₁ × ω₂ / ‖ω₁ + ω₂‖² from it, p being the pitches. So the third
axis passes through the point if the pitches are equal, as they are for three pure rotations.

Twists are `Dual`s of shape (..., 3) over any ordered field: floats in batches, Fractions, fmpq.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import numpy as np

from workbench.algebra.dual import Dual, as_array, divide
from workbench.algebra.dual_tensors import cross, dot, scale, vector

if TYPE_CHECKING:
    from workbench.drake.gate import Context, MultibodyPlant

ROUNDING = 64 * np.finfo(float).eps
"""Of the size of its terms: what of a float sum is taken for rounding."""


class Configuration(StrEnum):
    """How the three axes lie; see the table of this module."""

    SKEW = "skew axes"
    TWO_MEET = "two of three axes meet"
    CONCURRENT = "three axes through one point"
    PARALLEL = "three parallel axes in a plane"
    COINCIDENT = "three axes on one line"
    PARALLEL_TRANSLATION = "two parallel axes and a translation"
    COINCIDENT_TRANSLATION = "two axes on one line and a translation along it"
    COINCIDENT_REST = "two axes on one line and rest"
    TRANSLATIONS = "translations only"
    REST = "rest"

    @property
    def freedom(self) -> int:
        """How many numbers choose one of the common perpendiculars of the axes.

        0: there is one; 1: they are parallel, in a plane; 2: all that meet a line at right angles;
        4: no motion has an axis, so the condition is void and every line of space meets it.
        """
        if self in (Configuration.SKEW, Configuration.TWO_MEET, Configuration.CONCURRENT):
            return 0
        if self in (Configuration.PARALLEL, Configuration.PARALLEL_TRANSLATION):
            return 1
        return 4 if self in (Configuration.TRANSLATIONS, Configuration.REST) else 2

    @property
    def remark_7_holds(self) -> bool:
        """True if ω̲₁ × ω̲₂ has a line, which then is the unique common perpendicular."""
        return self.freedom == 0


@dataclass(frozen=True)
class ThreeAxes:
    """The axes of ω̲₁, ω̲₂ and ω̲₁ + ω̲₂ (in this order, along the second last axis) and where they lie.

    A line is given by Plücker coordinates u + ε p × u whose direction u need not have length 1 (so
    that exact scalars stay exact; `dual_tensors.unit` makes it so); zeros where there is no line.

    configuration: (...) of `Configuration`, one member where there is no batch.
    axes: (..., 3, 3), directed as the angular velocities. has_axis: (..., 3).
    pitches: (..., 3), 0 where there is no axis.
    perpendicular: (..., 3), a common perpendicular of all axes: where `freedom` is 0 the only one,
       where it is 1 the one nearest to the origin, where it is 2 one through the point of the axes
       nearest to the origin, and zeros where it is 4.
    """

    configuration: Any
    axes: Dual
    has_axis: np.ndarray
    pitches: np.ndarray
    perpendicular: Dual

    def perpendicular_at(self, slide: Any) -> Dual:
        """Returns the perpendicular moved by ``slide`` (...) times the angular velocity along the axes.

        Raises `ValueError` where freedom is 0 or 4: what is moved is not a common perpendicular.
        """
        for configuration in np.atleast_1d(np.asarray(self.configuration, dtype=object)).flat:
            if configuration.freedom not in (1, 2):
                raise ValueError(f"{configuration}: there is no family of common perpendiculars")
        direction = _first(self.axes.re, self.has_axis)
        line = self.perpendicular
        return Dual(line.re, line.du + cross(scale(slide, direction), line.re))


def three_axes(first: Dual, second: Dual, tolerance: float | None = None) -> ThreeAxes:
    """Returns the axes of two twists and of their sum, how they lie, and their common perpendicular.

    first, second: ω̲₁ and ω̲₂, (..., 3). ``tolerance``: what counts as zero, relative to the terms
    that cancel; exactly 0 for exact scalars unless given, `ROUNDING` for floats.
    Raises `ValueError` for another shape, `TypeError` for what is not a dual vector.

    >>> found = three_axes(Dual([0, 0, 1], [0, 0, 0]), Dual([1, 0, 0], [0, 2, 0]))
    >>> print(found.configuration)
    three axes through one point
    """
    first, second = _twist(first, "first"), _twist(second, "second")
    if tolerance is None:
        tolerance = 0 if object in (first.re.dtype, second.re.dtype) else ROUNDING
    first, second = _broadcast(first, second)
    twists = _stack([first, second, first + second])
    judged = _Judgement(tolerance)
    has_axis = judged.has_axis(twists)
    pitches, axes = _pitches_and_axes(twists, has_axis)
    product = cross(first, second)
    lengths = _size(first.re) * _size(second.re)
    oblique = ~judged.is_zero(product.re, lengths) & has_axis.all(axis=-1)
    moments = _size(first.re) * _size(second.du) + _size(first.du) * _size(second.re)
    apart = ~judged.is_zero(product.du, moments)
    names = np.select(
        [oblique, has_axis.all(axis=-1), has_axis.any(axis=-1), _size(twists.du).any(axis=-1)],
        [
            judged.of_oblique_axes(axes),
            np.where(apart, "PARALLEL", "COINCIDENT"),
            judged.of_two_axes(twists, has_axis, apart),
            "TRANSLATIONS",
        ],
        default="REST",
    )
    perpendicular = _perpendicular(product, oblique, apart, axes, has_axis)
    return ThreeAxes(_members(names), axes, has_axis, pitches, perpendicular)


def relative_twists(
    plant: MultibodyPlant, context: Context, bodies: tuple[str, str, str]
) -> tuple[Dual, Dual, Dual]:
    """Returns Drake's twists of three bodies: 1 relative to 0, 2 to 1, 2 to 0, as dual vectors (3,) in W.

    The dual part is the velocity of the body point that is at Wo. Each comes from Drake, so that
    the third need not be the sum of the others to the last bit. Raises RuntimeError (Drake's) for a
    body that the plant does not have.
    """
    zero, one, two = (plant.GetBodyByName(name).body_frame() for name in bodies)

    def twist(moving: Any, fixed: Any) -> Dual:
        V = moving.CalcSpatialVelocity(context, fixed, plant.world_frame())
        V_at_Wo = V.Shift(-moving.CalcPoseInWorld(context).translation())
        return Dual(V_at_Wo.rotational(), V_at_Wo.translational())

    return twist(one, zero), twist(two, one), twist(two, zero)


def _twist(a: Any, name: str) -> Dual:
    if not isinstance(a, Dual):
        raise TypeError(f"{name} twist: expected a dual vector (a Dual), got {type(a).__name__}")
    a = vector(a.re, a.du)
    for part in (a.re, a.du):
        if part.dtype != object and not np.isfinite(part).all():
            raise ValueError(f"{name} twist: expected finite numbers, got {part}")
    return a


def _broadcast(a: Dual, b: Dual) -> tuple[Dual, Dual]:
    try:
        parts = np.broadcast_arrays(a.re, a.du, b.re, b.du)
    except ValueError:
        raise ValueError(
            f"expected two batches of twists that fit, got shapes {a.re.shape} and {b.re.shape}"
        ) from None
    return Dual(*parts[:2]), Dual(*parts[2:])


def _stack(twists: list[Dual]) -> Dual:
    return Dual(np.stack([t.re for t in twists], axis=-2), np.stack([t.du for t in twists], axis=-2))


def _size(a: np.ndarray) -> np.ndarray:
    """Returns the largest entry of vectors: (..., 3) → (...)."""
    return np.abs(a).max(axis=-1)


@dataclass(frozen=True)
class _Judgement:
    """The test for zero: not larger than ``tolerance`` times the terms that a number is the sum of."""

    tolerance: float

    def is_zero(self, a: np.ndarray, terms: Any) -> np.ndarray:
        """Returns which vectors (..., 3) are zero. terms (...): the sizes of the terms that they are sums
        of."""
        return np.asarray(_size(a) <= self.tolerance * terms, dtype=bool)

    def has_axis(self, twists: Dual) -> np.ndarray:
        return ~self.is_zero(twists.re, _size(twists.re).max(axis=-1, keepdims=True))

    def meet(self, first: Dual, second: Dual) -> np.ndarray:
        """Returns whether two lines that are not parallel meet: Du(u̲₁ · u̲₂) = 0."""
        terms = _size(first.re) * _size(second.du) + _size(first.du) * _size(second.re)
        return self.is_zero(as_array(dot(first, second).du)[..., None], terms)

    def of_oblique_axes(self, axes: Dual) -> np.ndarray:
        pairs = ((0, 1), (1, 2), (0, 2))
        meeting = sum(self.meet(axes[..., i, :], axes[..., j, :]).astype(int) for i, j in pairs)
        return np.where(meeting > 1, "CONCURRENT", np.where(meeting == 1, "TWO_MEET", "SKEW"))

    def of_two_axes(self, twists: Dual, has_axis: np.ndarray, apart: np.ndarray) -> np.ndarray:
        without_axis = _first(twists.du, ~has_axis)
        rests = self.is_zero(without_axis, _size(twists.du).max(axis=-1))
        coincident = np.where(rests, "COINCIDENT_REST", "COINCIDENT_TRANSLATION")
        return np.where(apart, "PARALLEL_TRANSLATION", coincident)


def _first(vectors: np.ndarray, chosen: np.ndarray) -> np.ndarray:
    """Returns the first chosen of the vectors (..., 3, 3), the first of all where none is: (..., 3)."""
    place = np.argmax(chosen, axis=-1)[..., None, None]
    return np.take_along_axis(vectors, place, axis=-2)[..., 0, :]


def _inner(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns a · b as an array of shape (..., 1), which stays one of exact scalars where they are exact."""
    return (a * b).sum(axis=-1, keepdims=True)


def _pitches_and_axes(twists: Dual, has_axis: np.ndarray) -> tuple[np.ndarray, Dual]:
    """Returns p = ω · v / ω · ω and the line ω + ε (v − p ω), which is (1 − ε p) ω̲."""
    exists = has_axis[..., None]
    square = np.where(exists, _inner(twists.re, twists.re), 1)
    pitches = np.where(exists, divide(_inner(twists.re, twists.du), square), 0)
    moments = twists.du - pitches * twists.re
    return pitches[..., 0], Dual(np.where(exists, twists.re, 0), np.where(exists, moments, 0))


def _perpendicular(
    product: Dual, oblique: np.ndarray, apart: np.ndarray, axes: Dual, has_axis: np.ndarray
) -> Dual:
    oblique, apart = oblique[..., None], apart[..., None]
    square = np.where(oblique, _inner(product.re, product.re), 1)
    along = divide(_inner(product.re, product.du), square)
    moment_if_oblique = product.du - along * product.re

    axis = Dual(_first(axes.re, has_axis), _first(axes.du, has_axis))
    exists = np.asarray(has_axis.any(axis=-1))[..., None]
    square = np.where(exists, _inner(axis.re, axis.re), 1)
    foot = divide(cross(axis.re, axis.du), square)
    basis_vector = np.eye(3, dtype=int)[np.argmin(np.abs(axis.re), axis=-1)]
    direction = np.where(apart, product.du, cross(axis.re, basis_vector))
    direction = np.where(exists, direction, 0)
    return Dual(
        np.where(oblique, product.re, direction),
        np.where(oblique, moment_if_oblique, cross(foot, direction)),
    )


def _members(names: np.ndarray) -> Any:
    """Returns names of configurations as an array of them; one member where there is no batch."""
    members = np.empty(names.shape, dtype=object)
    for place in np.ndindex(names.shape):
        members[place] = Configuration[str(names[place])]
    return members[()]
