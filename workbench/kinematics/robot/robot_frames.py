"""The motion of one frame, and of points fixed in it: twists, accelerations, centres, screw axes."""

from __future__ import annotations

from functools import cached_property
from math import comb
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import apply, cross, dot
from workbench.kinematics.centres import Locus, acceleration_centre, field_scales
from workbench.kinematics.fields import acceleration_tensors, invariant_vectors
from workbench.kinematics.robot.balls import quaternion_of_rotation, rpy_of_rotation
from workbench.kinematics.robot.leibniz import (
    about_world_origin,
    carried_vector,
    inverse_pose,
    origin_derivatives,
    relative_twist,
)
from workbench.kinematics.robot.structure import is_whole
from workbench.kinematics.tensors import as_vectors

if TYPE_CHECKING:
    from workbench.drake.gate import SpatialAcceleration, SpatialVelocity

ROUNDING = 1e-13
"""Of a bound on its terms: what of Φₙ or aₙ of a chain of joints is taken for rounding."""

RANK_TOLERANCE = 1e-9


class Field(NamedTuple):
    """The n-th order accelerations of all body points, aₙ + Φₙ ρ (Eq. (19)): Phi (..., 3, 3), a (..., 3)."""

    Phi: np.ndarray
    a: np.ndarray

    def at(self, rho: ArrayLike) -> np.ndarray:
        """Returns the acceleration of the body point now at rho (..., 3), (..., 3) in m/sⁿ."""
        return self.a + apply(self.Phi, as_vectors(rho, "rho"))


class ScrewAxis(NamedTuple):
    """The axis of a twist: the point (..., 3) nearest to the origin, the unit direction (..., 3), the pitch
    (...) in m/rad and the rate (...) in rad/s about it. Of a translation the pitch is infinite and the rate
    is m/s."""

    point: np.ndarray
    direction: np.ndarray
    pitch: np.ndarray
    rate: np.ndarray


class FrameMotion:
    """The motion of a frame F to the order N, `order`, in the frame it is measured in (the world W unless
    relative).

    name; pose (..., 4, 4): X_WF. twists (N, ..., 6): Drake's V_WF = (ω; velocity of Fo), and its derivatives.
    Arrays are read-only.
    """

    def __init__(self, name: str, order: int, pose: np.ndarray, twists: np.ndarray):
        self.name, self.order = name, order
        self.pose, self.twists = pose, twists
        for array in (pose, twists):
            array.flags.writeable = False

    def twist(self, k: int = 0) -> Twist:
        """Returns the k-th time derivative of the frame's twist, k < N."""
        if type(k) is not int or not 0 <= k < self.order:
            self._require(k, self.order - 1)
        return Twist(self, k)

    def _twist(self, k: int) -> np.ndarray:
        return self.twists[k]

    @cached_property
    def origin_twist(self) -> np.ndarray:
        """(N, ..., 6): the chapter's twist (ω; v) and its derivatives, v of the body point at W's origin."""
        return _read_only(about_world_origin(self.twists, self.pose[..., :3, 3]))

    @property
    def quaternion(self) -> np.ndarray:
        """The unit quaternion (..., 4), w x y z with w >= 0, of the pose's rotation."""
        return quaternion_of_rotation(self.pose[..., :3, :3])

    @property
    def rpy(self) -> np.ndarray:
        """(roll, pitch, yaw), (..., 3) in rad, R = Rz(yaw) Ry(pitch) Rx(roll) of the pose's rotation; pitch
        from −π/2 to π/2, and roll 0 where pitch is at one of these."""
        return rpy_of_rotation(self.pose[..., :3, :3])

    def point(self, p: ArrayLike = (0, 0, 0)) -> PointMotion:
        """Returns the motion of a point P fixed in F; p (3,) is p_FoP_F in m."""
        p = as_vectors(p, "point")
        if p.shape != (3,):
            raise ValueError(f"point: expected three coordinates, got shape {p.shape}")
        return PointMotion(self, p)

    def acceleration(self, n: int) -> np.ndarray:
        """Returns the n-th order acceleration of the frame's origin, (..., 3) in m/sⁿ:
        `point().derivative(n)`."""
        return self.point().derivative(n)

    @cached_property
    def Phi(self) -> np.ndarray:
        """Φ₀, …, Φ_N, (N + 1, ..., 3, 3), Eq. (15)."""
        return _read_only(acceleration_tensors(self.twists[..., :3]))

    @cached_property
    def a(self) -> np.ndarray:
        """a₀, …, a_N, (N + 1, ..., 3), Eq. (16)."""
        return _read_only(invariant_vectors(self.origin_twist[..., :3], self.origin_twist[..., 3:]))

    def field(self, n: int) -> Field:
        """Returns Φₙ and aₙ, the field of the n-th order accelerations, 1 <= n <= N."""
        self._require(n, self.order, 1)
        return Field(self.Phi[n], self.a[n])

    def centre(self, n: int) -> Locus:
        """Returns the points with zero n-th order acceleration, Eq. (50): a point, a line, a plane, all of
        space or none."""
        Phi, a = self.field(n)
        Phi_scale, a_scale = (ROUNDING / RANK_TOLERANCE * scale[n] for scale in self._scales)
        return acceleration_centre(Phi, a, rtol=RANK_TOLERANCE, Phi_scale=Phi_scale, a_scale=a_scale)

    @cached_property
    def _scales(self) -> tuple[np.ndarray, np.ndarray]:
        """The sizes of the terms of Φₙ and aₙ, each (N + 1, ...)."""
        return field_scales(self.origin_twist[..., :3], self.origin_twist[..., 3:])

    def screw_axis(self) -> ScrewAxis:
        """Returns the instantaneous screw axis: the axis of the twist, Eq. (102) with n = 0."""
        omega, v, p = self.twists[0][..., :3], self.twists[0][..., 3:], self.pose[..., :3, 3]
        rate, speed = np.linalg.norm(omega, axis=-1), np.linalg.norm(v, axis=-1)
        turns = rate > ROUNDING * np.maximum(speed, rate)
        square = np.where(turns, rate * rate, 1.0)
        direction = np.where(turns[..., None], omega, v)
        length = np.linalg.norm(direction, axis=-1)
        direction = direction / np.where(length == 0, 1.0, length)[..., None]
        foot = p + cross(omega, v) / square[..., None]
        point = np.where(turns[..., None], foot - dot(foot, direction)[..., None] * direction, 0.0)
        pitch = np.where(turns, dot(omega, v) / square, np.inf)
        return ScrewAxis(point, direction, pitch, np.where(turns, rate, speed))

    def relative_to(self, other: FrameMotion) -> FrameMotion:
        """Returns the motion of this frame B as an observer in the frame A of `other` sees it, expressed in
        A."""
        if not isinstance(other, FrameMotion):
            raise ValueError(f"other: expected the motion of a frame, got {type(other).__name__}")
        if other.pose.shape != self.pose.shape:
            states = [frame.pose.shape[:-2] for frame in (self, other)]
            raise ValueError(f"other: expected as many states, {states[0]}, got {states[1]}")
        order = min(self.order, other.order)
        twist = relative_twist(other.twists[:order], other.pose, self.twists[:order], self.pose)
        pose = inverse_pose(other.pose) @ self.pose
        return FrameMotion(f"{self.name} relative to {other.name}", order, pose, twist)

    def _require(self, order: int, highest: int, lowest: int = 0) -> None:
        if type(order) is int and lowest <= order <= highest:
            return
        if not is_whole(order) or not lowest <= order <= highest:
            raise ValueError(
                f"order: expected one from {lowest} to {highest} of a motion of order {self.order}, "
                f"got {order!r}"
            )

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.name!r}, order {self.order})"

    def __dir__(self) -> list[str]:
        return [name for name in super().__dir__() if not name.startswith("_")]


class Twist:
    """The k-th time derivative of the twist of a frame F, in W's axes: rad/s¹⁺ᵏ and m/s¹⁺ᵏ.

    It is an array of Drake's six numbers for NumPy: np.asarray(twist) = (angular; linear).
    """

    __slots__ = ("frame", "order")

    def __init__(self, frame: FrameMotion, order: int):
        self.frame, self.order = frame, order

    @property
    def array(self) -> np.ndarray:
        """(..., 6): dᵏ/dtᵏ of Drake's V_WF = (w_WF; v_WFo)."""
        return self.frame._twist(self.order)

    @property
    def angular(self) -> np.ndarray:
        """ω⁽ᵏ⁾, (..., 3)."""
        return self.array[..., :3]

    @property
    def linear(self) -> np.ndarray:
        """The k-th derivative of the velocity of Fo, (..., 3): the (k + 1)-st order acceleration of Fo."""
        return self.array[..., 3:]

    @property
    def dual(self) -> Dual:
        """ω̲⁽ᵏ⁾ = ω⁽ᵏ⁾ + ε v⁽ᵏ⁾, where v is the velocity of the body point at W's origin, Eq. (92)."""
        at_origin = self.frame.origin_twist[self.order]
        return Dual(at_origin[..., :3], at_origin[..., 3:])

    def drake(self) -> SpatialVelocity | SpatialAcceleration:
        """Returns Drake's V_WF (k = 0) or A_WF (k = 1), of one state. Raises ValueError for what Drake has
        no type for."""
        from workbench.drake.gate import SpatialAcceleration, SpatialVelocity

        types = (SpatialVelocity, SpatialAcceleration)
        if self.order >= len(types) or self.array.ndim != 1:
            raise ValueError(
                "expected a twist (k = 0) or its first derivative (k = 1) of one state, "
                f"got k = {self.order} and an array of shape {self.array.shape}"
            )
        return types[self.order](self.array)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.array, dtype=dtype) if copy or dtype else self.array

    def __repr__(self) -> str:
        return (
            f"Twist({self.frame.name!r}, derivative {self.order}: {np.array2string(self.array, precision=6)})"
        )


class PointMotion:
    """The motion of a point P fixed in a frame F: position and derivatives, each (..., 3), in W.

    position m, velocity m/s, acceleration m/s², jerk m/s³, snap m/s⁴; any other by `derivative`.
    """

    def __init__(self, frame: FrameMotion, p_FoP_F: np.ndarray):
        self.frame, self.p_FoP_F = frame, p_FoP_F

    @cached_property
    def position(self) -> np.ndarray:
        return _read_only(self._arm + self.frame.pose[..., :3, 3])

    @cached_property
    def _arm(self) -> np.ndarray:
        """p_FoP in W's axes, (..., 3)."""
        return apply(self.frame.pose[..., :3, :3], self.p_FoP_F)

    @cached_property
    def derivatives(self) -> np.ndarray:
        """(N + 1, ..., 3): the position and its derivatives, the order first."""
        twists = self.frame.twists
        of_origin = origin_derivatives(twists, self.frame.pose[..., :3, 3])
        found = of_origin + carried_vector(twists[..., :3], self._arm)
        if not np.isfinite(found).all():
            raise ValueError("point: expected finite derivatives, got some beyond the largest double")
        return _read_only(found)

    def derivative(self, n: int) -> np.ndarray:
        """Returns dⁿp/dtⁿ, (..., 3) in m/sⁿ; the n-th order acceleration of Eq. (13) for n >= 1."""
        self.frame._require(n, self.frame.order)
        return self.derivatives[n]

    @property
    def velocity(self) -> np.ndarray:
        return self.derivative(1)

    @property
    def acceleration(self) -> np.ndarray:
        return self.derivative(2)

    @property
    def jerk(self) -> np.ndarray:
        return self.derivative(3)

    @property
    def snap(self) -> np.ndarray:
        return self.derivative(4)

    def __repr__(self) -> str:
        return f"PointMotion({self.frame.name!r}, {self.p_FoP_F.tolist()} m)"


def _read_only(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


def chain_scales(sizes: np.ndarray, terms: np.ndarray, reach: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the scales (N + 1, ...) of Φₙ and aₙ of a chain of joints, `ROUNDING` of which is their
    rounding error.

    sizes (N, ...): the summed |velocities| of the joints and of their derivatives; terms (N, ...): of the
    terms that these are summed from, which their own errors are relative to; reach (...) in m.
    """
    noise = ROUNDING * terms
    exact, disturbed = _chain_bounds(sizes, reach), _chain_bounds(sizes + noise, reach)
    return tuple(b + (b - a) / ROUNDING for a, b in zip(exact, disturbed, strict=True))


def _chain_bounds(rates: np.ndarray, reach: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns bounds on the terms of Φₙ and aₙ. With unit axes turning as uᵢ' = ω × uᵢ, the norms in ω = Σ
    q̇ᵢ uᵢ bound ω⁽ᵏ⁾ without seeing terms cancel; v is taken to be as large as these at the chain's reach.
    """
    turning, axes = [], [np.ones_like(rates[0])]
    for k in range(len(rates)):
        turning.append(sum(comb(k, j) * rates[k - j] * axes[j] for j in range(k + 1)))
        axes.append(sum(comb(k, j) * turning[k - j] * axes[j] for j in range(k + 1)))
    bound = np.stack(turning)[..., None] * np.array([1.0, 0.0, 0.0])
    return field_scales(bound, reach[..., None] * bound)
