"""Higher-order kinematics of one body of a URDF robot, order by order, compared with Drake.

Our numbers and Drake's share no code: the file is read by two parsers, and the motion is computed by two
libraries.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual_tensors import determinant, vect
from workbench.drake.joint_paths import JointPath, LinearPath, Path, SinePath
from workbench.kinematics.centres import Locus
from workbench.kinematics.robot.robot import Robot
from workbench.kinematics.robot.robot_frames import FrameMotion
from workbench.kinematics.robot.structure import whole
from workbench.kinematics.tensors import as_vectors, sym

if TYPE_CHECKING:
    from workbench.drake.references import Reference


@dataclass(frozen=True)
class DrakeCheck:
    """Drake's number for one order, compared with ours.

    drakes (6,): the (n-1)-th derivative of V_WP = [w_WB; v_WP], so that its lower half is the n-th order
    acceleration of the body point P; method: how Drake computed it; error: the estimated error of Drake's
    number; residual: the deviation of ours from it. Both are the largest of the six components.
    """

    order: int
    drakes: np.ndarray
    method: str
    error: float
    residual: float

    @property
    def agrees(self) -> bool:
        """True if the residual is within the error; an error without a number allows nothing."""
        return bool(np.isfinite(self.error) and self.residual <= self.error)


@dataclass(frozen=True)
class MotionReport:
    """The motion of a robot's body at the time `at` (s) on a path, compared with Drake's numbers.

    joints: what each coordinate does, as text or as polynomial coefficients. point (3,): p_BoP_B in m.
    relative_to: the body A in which motion is measured and expressed; the world if None.
    """

    urdf: str
    body: str
    relative_to: str | None
    point: np.ndarray
    at: float
    joints: Mapping[str, Any]
    path: Path
    robot: Robot
    motion: FrameMotion
    checks: tuple[DrakeCheck, ...]

    @property
    def agrees(self) -> bool:
        return all(check.agrees for check in self.checks)

    def to_dict(self) -> dict[str, Any]:
        """Returns plain numbers, lists and strings, for JSON; orders[n-1] holds the results of order n.

        A number that is not finite is None.
        """
        return _plain(
            {
                "urdf": self.urdf,
                "body": self.body,
                "relative_to": self.relative_to,
                "point_B": self.point,
                "time": self.at,
                "joint_coefficients": self.joints,
                "units": {"time": "s", "point_B": "m", "p_WP": "m", "X_WB": "1 and m", "joints": "rad or m"},
                "X_WB": self.motion.pose,
                "p_WP": self.motion.point(self.point).position,
                "orders": [self._order(n, check) for n, check in enumerate(self.checks, start=1)],
            }
        )

    def _order(self, n: int, check: DrakeCheck) -> dict[str, Any]:
        motion, per = self.motion, "/s" if n == 1 else f"/s^{n}"
        Phi, a = motion.field(n)
        twist = motion.twist(n - 1)
        return {
            "order": n,
            "units": {
                "w_WB": f"rad{per}", "v_WBo": f"m{per}", "v": f"m{per}", "Phi": f"1{per}", "t": f"1{per}",
                "S": f"1{per}", "a": f"m{per}", "det_Phi": f"1/s^{3 * n}", "point_acceleration": f"m{per}",
                "centre": "m",
            },
            "w_WB": twist.angular,
            "v_WBo": twist.linear,
            "v": twist.dual.du,
            "Phi": Phi,
            "a": a,
            "t": vect(Phi),
            "S": sym(Phi),
            "det_Phi": determinant(Phi),
            "point_acceleration": motion.point(self.point).derivative(n),
            "centre": _centre_dict(motion.centre(n)),
            "drake": {
                "V_WP_derivative": check.drakes,
                "method": check.method,
                "error": check.error,
                "residual": check.residual,
                "agrees": check.agrees,
            },
        }  # fmt: skip


def _centre_dict(centre: Locus) -> dict[str, Any]:
    dimension = int(centre.dimension)
    return {
        "kind": centre.kind,
        "point": None if dimension < 0 else centre.point,
        "directions": centre.directions[: max(dimension, 0)],
    }


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, np.ndarray | list | tuple):
        return [_plain(entry) for entry in (value.tolist() if isinstance(value, np.ndarray) else value)]
    if isinstance(value, float | np.floating):
        return float(value) if np.isfinite(value) else None
    return value


def motion_report(
    urdf: FilePath | str,
    body: str,
    point: ArrayLike = (0, 0, 0),
    order: int = 4,
    at: float = 0.0,
    joints: Mapping[str, Sequence[float]] | None = None,
    *,
    trajectory: Path | None = None,
    relative_to: str | None = None,
    base: str = "fixed",
) -> MotionReport:
    """Returns the motion of a URDF robot's body to the `order`, compared with Drake's own numbers.

    point: p_BoP_B in m. at: time in s. joints: by name the coefficients c₀, c₁, ... of q(t) = Σₖ cₖ tᵏ (rad
    or m, per sᵏ); those not named stay at 0. trajectory: a path of the robot's coordinates instead. With
    neither, coordinate i = 1, 2, ... follows sin(t + i)/2. relative_to: the body A that motion is relative
    to. base: "fixed" or "floating" (as `Robot.from_urdf`, with rotations by roll, pitch, yaw).
    Raises ValueError for a file that is missing or that cannot be read, an unknown body, an order below 1,
    and joints, a point or a time that do not fit; each message says what was expected.
    """
    order = whole(order, "order", 1)
    if not np.isfinite(at):
        raise ValueError(f"at: expected a finite time in s, got {at}")
    from workbench.drake.plants import load_urdf

    robot = Robot.from_urdf(urdf, base, rotations="rpy")
    path, described = _joint_path(joints, trajectory, robot)
    moving = robot.along(path, at, order)
    motion: FrameMotion = moving.frame(body)
    if relative_to is not None:
        motion = motion.relative_to(moving.frame(relative_to))
    p = motion.point(point).p_FoP_F
    plant = load_urdf(urdf, base)
    now = at if trajectory is None else 0.0
    on_plant = _on_plant(path if trajectory is None else path.taylor(at), robot, plant)
    checks = []
    for n, reference in enumerate(_references(plant, body, relative_to, on_plant, now, order, p), start=1):
        ours = np.concatenate([motion.twist(n - 1).angular, motion.point(p).derivative(n)])
        residual = float(np.abs(ours - reference.value).max())
        checks.append(DrakeCheck(n, reference.value, reference.method, float(reference.error), residual))
    return MotionReport(
        urdf=str(urdf),
        body=body,
        relative_to=relative_to,
        point=as_vectors(p, "point"),
        at=float(at),
        joints=described,
        path=path,
        robot=robot,
        motion=motion,
        checks=tuple(checks),
    )


def _references(
    plant: Any,
    body: str,
    relative_to: str | None,
    path: Path,
    at: float,
    order: int,
    point: np.ndarray,
) -> list[Reference]:
    from workbench.drake.references import twist_derivatives
    from workbench.drake.relative import relative_twist_derivatives

    p_BoBp_B = point.tolist()
    if relative_to is None:
        return twist_derivatives(plant, body, path, at, order, p_BoBp_B)
    return relative_twist_derivatives(plant, body, relative_to, path, at, order, p_BoBp_B)


def _on_plant(path: Path, robot: Robot, plant: Any) -> Path:
    """Returns the path of the plant's positions, those that mimic among them."""
    names = plant.GetPositionNames(False, False)
    matrix, offset = robot.follow(names)
    return LinearPath(path, matrix, offset)


def _joint_path(
    joints: Mapping[str, Sequence[float]] | None, trajectory: Path | None, robot: Robot
) -> tuple[Path, dict[str, Any]]:
    names = robot.positions
    if trajectory is not None:
        if joints:
            raise ValueError("joints and trajectory: expected one of them, got both")
        return robot.path(trajectory), dict.fromkeys(names, "trajectory")
    if joints is None:
        return SinePath(len(names)), {name: f"sin(t + {i})/2" for i, name in enumerate(names, start=1)}
    for name, row in joints.items():
        if name not in names:
            raise ValueError(f"unknown joint {name!r}: expected one of {', '.join(names)}")
        if len(row) == 0:
            raise ValueError(f"joint {name!r}: expected at least one coefficient, got none")
    table = np.zeros((max((len(row) for row in joints.values()), default=1), len(names)))
    for name, row in joints.items():
        table[: len(row), names.index(name)] = row
    path = JointPath(table)
    return path, dict(zip(names, path.coefficients.T.tolist(), strict=True))
