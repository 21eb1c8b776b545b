"""Relative motion of two bodies without the motion of their common base.

The twist of B relative to A does not depend on how their common base moves. Without that motion its terms,
which would cancel, do not occur.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from workbench.kinematics.robot.structure import Structure

if TYPE_CHECKING:
    from workbench.kinematics.robot.joints import TreeJoint


def coordinates_that_move(robot: Structure, body: str, relative_to: str | None = None) -> list[int]:
    """Returns the indices of the coordinates that move a body relative to another one, or to the world."""
    between = _between(robot, body, relative_to)
    matrix, _ = robot.follow([name for joint in between for name in joint.coordinates])
    return np.flatnonzero(np.abs(matrix).sum(axis=0)).tolist()


def _between(robot: Structure, body: str, relative_to: str | None) -> list[TreeJoint]:
    """Returns the joints on the way from one body to the other that not both of them are moved by."""
    first = _from_world(robot, robot.body(body).name)
    second = [] if relative_to is None else _from_world(robot, robot.body(relative_to).name)
    shared = {joint.name for joint in first} & {joint.name for joint in second}
    return [joint for joint in (*first, *second) if joint.name not in shared]


def _from_world(robot: Structure, body: str) -> list[TreeJoint]:
    inboard = {joint.child: joint for joint in robot.joints}
    found = []
    while body != robot.world:
        found.append(inboard[body])
        body = inboard[body].parent
    return found


def without_common_base(
    robot: Structure, body: str, relative_to: str, q: np.ndarray, rates: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Returns q (..., positions) and rates (N, ..., velocities) with those coordinates at rest in their
    default positions that do not move a body relative to the other."""
    moving = set(coordinates_that_move(robot, body, relative_to))
    still = [i for i in range(len(robot.positions)) if i not in moving]
    names = {robot.positions[i] for i in still}
    velocities = [
        robot.velocities.index(name)
        for joint in robot.joints
        if joint.mimic is None and names.issuperset(joint.coordinates)
        for name in joint.velocities
    ]
    q, rates = q.copy(), rates.copy()
    q[..., still] = robot.default_positions[still]
    rates[..., velocities] = 0.0
    return q, rates
