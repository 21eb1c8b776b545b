"""Peaks of a motion along a path: the quantities, and the choice between exact paths and recordings."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.derivative_names import order_name, per_second
from workbench.kinematics.robot.joint_limits import LimitTables, known_limits, of_body
from workbench.kinematics.robot.peaks import Asked, Peak, Violation
from workbench.kinematics.robot.recording.recorded_motion import recorded_peaks, recorded_violations
from workbench.kinematics.robot.states import States
from workbench.kinematics.robot.structure import Structure
from workbench.kinematics.robot.trajectories.exact_peaks import exact_peaks, exact_violations
from workbench.kinematics.robot.trajectories.paths import RecordedPath


def peaks(
    motion: States,
    body: str | None,
    point: ArrayLike,
    limits: LimitTables | None,
    relative_to: str | None,
) -> list[Peak]:
    """See `Motion.peaks`."""
    asked = asked_of(motion, body, limits)
    if not asked:
        return []
    if isinstance(motion.path, RecordedPath):
        return recorded_peaks(motion, body, point, relative_to, asked)
    return exact_peaks(motion, body, point, relative_to, asked)


def violations(
    motion: States,
    body: str | None,
    point: ArrayLike,
    limits: LimitTables | None,
    relative_to: str | None,
) -> list[Violation]:
    """See `Motion.violations`."""
    asked = [one for one in asked_of(motion, body, limits) if one.limit is not None]
    if not asked:
        return []
    find = recorded_violations if isinstance(motion.path, RecordedPath) else exact_violations
    return sorted(find(motion, body, point, relative_to, asked), key=lambda one: one.start)


def asked_of(motion: States, body: str | None, limits: LimitTables | None) -> list[Asked]:
    """Returns the quantities whose peaks are sought.

    These are each joint derivative, those of the point and of the body's rotation, and each coordinate with a
    limit. Mimic joints count only with a limit.
    """
    if motion.path is None:
        raise ValueError("expected a motion along a path (`Robot.along`), which has times between its states")
    robot, order, known = motion.robot, motion.order, known_limits(motion.robot, limits)
    units = robot.units
    per = {n: per_second(n) for n in range(1, order + 1)}
    sources = _sources(robot)
    free = set(robot.velocities)
    found = [
        Asked(name, n, "upper", units[name] + per[n], known[name].get(order_name(n)), *sources[name])
        for n in per
        for name in sources
        if name in free or order_name(n) in known[name]
    ]
    if body is not None:
        for of, unit in zip(of_body(robot), ("m", "rad"), strict=True):
            found += [Asked(of, n, "upper", unit + per[n], known[of].get(order_name(n))) for n in per]
    if order >= 2:
        found += [
            Asked(name, 2, "deceleration", units[name] + per[2], known[name]["deceleration"], *sources[name])
            for name in sources
            if "deceleration" in known[name]
        ]
    return found + [
        Asked(name, 0, bound, units[name], known[name][bound], *sources[name])
        for name in sources
        for bound in ("lower", "upper")
        if bound in known[name] and sources[name][0] is not None
    ]


def _sources(robot: Structure) -> dict[str, tuple[int | None, int, float, float]]:
    """Returns (position, velocity, factor, offset) of each velocity, mimic joints last.

    position: None if the velocity is no derivative of a coordinate (those of balls).
    """
    found: dict[str, tuple[int | None, int, float, float]] = {}
    position = velocity = 0
    for joint in robot.joints:
        if joint.mimic is not None:
            continue
        for move in joint.moves():
            is_rate = not isinstance(move.joint, str)
            for i in range(move.sizes[1]):
                at = velocity + move.velocity + i
                found[robot.velocities[at]] = (position + move.position if is_rate else None, at, 1.0, 0.0)
        position += len(joint.coordinates)
        velocity += len(joint.velocities)
    found = {name: found[name] for name in robot.velocities}
    for joint in robot.joints:
        if joint.mimic is not None:
            (row,), (offset,) = robot.follow([joint.name])
            source = int(np.argmax(np.abs(row)))
            name = robot.positions[source]
            found[joint.name] = (source, robot.velocities.index(name), float(row[source]), float(offset))
    return found
