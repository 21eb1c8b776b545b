"""The joints of a robot's tree, and the elementary motions that they are composed of.

A joint leads from the parent body's frame P over a frame F fixed in it to a frame M fixed in the child C:
X_PC(q) = X_PF · X_FM(q) · X_MC. Its coordinates and velocities are Drake's, in Drake's order:

kind              coordinates                    velocities
fixed             –                              –
revolute          angle about the axis           its rate        (URDF: also continuous)
prismatic         shift along the axis           its rate
helical           angle; shift = pitch · angle   its rate
cylindrical       angle, shift                   their rates
universal         angles about x, then y         their rates
planar            x, y, angle about z            their rates
ball              quaternion w x y z             ω of M in F, in F
ball_rpy          roll, pitch, yaw               ω of M in F, in F
floating          quaternion, then x y z         ω and velocity of Mo, in F
floating_rpy      roll, pitch, yaw, x y z        ω and velocity of Mo, in F

Units: rad, m, s; pitch in m/rad. A quaternion need not be normalized: only its direction matters.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from workbench.kinematics.chain_joints import Joint, rigid_matrix

QUATERNION, RPY = ("_qw", "_qx", "_qy", "_qz"), ("_qx", "_qy", "_qz")
PLACE, TURN, SPEED = ("_x", "_y", "_z"), ("_wx", "_wy", "_wz"), ("_vx", "_vy", "_vz")

COORDINATES: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "fixed": ((), ()),
    "revolute": (("",), ("",)),
    "prismatic": (("",), ("",)),
    "helical": (("",), ("",)),
    "cylindrical": (("_angle", "_shift"), ("_angle", "_shift")),
    "universal": (("_qx", "_qy"), ("_qx", "_qy")),
    "planar": (("_x", "_y", "_qz"), ("_x", "_y", "_qz")),
    "ball": (QUATERNION, TURN),
    "ball_rpy": (RPY, TURN),
    "floating": (QUATERNION + PLACE, TURN + SPEED),
    "floating_rpy": (RPY + PLACE, TURN + SPEED),
}
"""What is added to a joint's name to name its coordinates and its velocities."""

ANGLES = {
    "cylindrical": ("_angle",),
    "universal": ("_qx", "_qy"),
    "planar": ("_qz",),
    "ball_rpy": ("_qx", "_qz"),
    "floating_rpy": ("_qx", "_qz"),
}
"""The coordinates, beside those of revolute joints, that are angles known modulo 2π."""

X, Y, Z = np.eye(3)
SHIFTS = tuple(Joint.prismatic(axis) for axis in (X, Y, Z))


class Mimic(NamedTuple):
    """A joint's one coordinate is multiplier · (that of the joint `source`) + offset, at every time."""

    source: str
    multiplier: float = 1.0
    offset: float = 0.0


class Limits(NamedTuple):
    """The limits of a joint of one coordinate, in rad or m, per s, s², s³; NaN where there is none.

    velocity, acceleration, jerk bound the size; deceleration bounds |q̈| where q̈ and q̇ have opposite signs.
    """

    lower: float = np.nan
    upper: float = np.nan
    velocity: float = np.nan
    acceleration: float = np.nan
    deceleration: float = np.nan
    jerk: float = np.nan


@dataclass(frozen=True, eq=False)
class TreeJoint:
    """A joint between two bodies of a robot, named; X_PF and X_MC are (4, 4) rigid transforms in m.

    armature: what the joint's rotors add to the inertia of each of its velocities, (rotor inertia) · (gear
    ratio)², in kg m² (of shifts kg); see `Motion.torques`. Raises ValueError for an unknown kind, a transform
    that is not rigid, an axis of length zero, or a negative armature.
    """

    name: str
    kind: str
    parent: str
    child: str
    X_PF: np.ndarray = field(default_factory=lambda: np.eye(4))
    X_MC: np.ndarray = field(default_factory=lambda: np.eye(4))
    axis: np.ndarray = field(default_factory=lambda: X)
    pitch: float = 0.0
    limits: Limits = field(default_factory=Limits)
    mimic: Mimic | None = None
    armature: float = 0.0

    def __post_init__(self) -> None:
        if self.kind not in COORDINATES:
            kinds = ", ".join(COORDINATES)
            raise ValueError(f"joint {self.name!r}: expected one of {kinds}, got {self.kind!r}")
        for name in ("X_PF", "X_MC"):
            object.__setattr__(self, name, rigid_matrix(getattr(self, name), f"joint {self.name!r}: {name}"))
        if self.mimic is not None and len(self.coordinates) != 1:
            raise ValueError(f"joint {self.name!r}: a {self.kind} joint has not one coordinate to mimic with")
        if not 0 <= self.armature < np.inf:
            raise ValueError(f"joint {self.name!r}: expected an armature >= 0, got {self.armature!r}")
        try:
            self.moves()
        except ValueError as error:
            raise ValueError(f"joint {self.name!r}: {error}") from None

    @property
    def coordinates(self) -> tuple[str, ...]:
        return tuple(self.name + suffix for suffix in COORDINATES[self.kind][0])

    @property
    def velocities(self) -> tuple[str, ...]:
        return tuple(self.name + suffix for suffix in COORDINATES[self.kind][1])

    def unit(self, name: str) -> str:
        """Returns the unit of a coordinate or velocity: m, rad, or 1 for a quaternion's component."""
        part = name.removeprefix(self.name)
        if self.kind in ("ball", "floating") and part in QUATERNION:
            return "1"
        return "m" if self.kind == "prismatic" or part in (*PLACE, *SPEED, "_shift") else "rad"

    def moves(self) -> tuple[Move, ...]:
        """Returns X_FM as a product of motions, from F to M; their coordinates and velocities within the
        joint's."""
        if self.kind == "fixed":
            return ()
        if self.kind == "revolute":
            return (Move(Joint.revolute(self.axis), 0, 0),)
        if self.kind == "prismatic":
            return (Move(Joint.prismatic(self.axis), 0, 0),)
        if self.kind == "helical":
            return (Move(Joint.helical(self.axis, pitch=self.pitch), 0, 0),)
        if self.kind == "cylindrical":
            return (Move(Joint.revolute(self.axis), 0, 0), Move(Joint.prismatic(self.axis), 1, 1))
        if self.kind == "universal":
            return (Move(Joint.revolute(X), 0, 0), Move(Joint.revolute(Y), 1, 1))
        if self.kind == "planar":
            return (Move(SHIFTS[0], 0, 0), Move(SHIFTS[1], 1, 1), Move(Joint.revolute(Z), 2, 2))
        angles = len(self.coordinates) - (3 if self.kind.startswith("floating") else 0)
        ball = Move("quaternion" if angles == 4 else "rpy", 0, 0)
        if self.kind.startswith("ball"):
            return (ball,)
        return (*(Move(shift, angles + i, 3 + i) for i, shift in enumerate(SHIFTS)), ball)


class Move(NamedTuple):
    """One motion of a joint: a `Joint` of one coordinate, or "quaternion" or "rpy", a ball of three
    velocities.

    position, velocity: where its first coordinate and velocity are; `sizes`: how many it has.
    """

    joint: Joint | str
    position: int
    velocity: int

    @property
    def ball(self) -> str:
        """The kind of a ball; "" for another joint."""
        return self.joint if isinstance(self.joint, str) else ""

    @property
    def sizes(self) -> tuple[int, int]:
        return {"quaternion": (4, 3), "rpy": (3, 3)}[self.joint] if isinstance(self.joint, str) else (1, 1)
