"""A tree of joints as steps of one rotation, translation, screw or ball each, and frames."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from workbench.kinematics.chain_joints import Joint

WORLD = -1  # the step before the first ones: the world
HIGHEST_DERIVATIVE_ORDER = 170  # 170! is the last factorial that a double can hold


class Drive(NamedTuple):
    """An angle or a shift: factor · (input channel) + offset; velocity: whose column of the Jacobian it
    is."""

    channel: int
    velocity: int
    factor: float = 1.0
    offset: float = 0.0


class Step(NamedTuple):
    """One motion of the tree: X_WM = X_WP · before · (the motion), P being the frame that `parent` reaches.

    joint: a moving `Joint` of one or two coordinates, whose drives are `turn` and `slide`; None: a ball,
    whose four input channels from `turn` on are (w, x, y, z) of a unit quaternion, and from the second on
    the derivatives of the angular velocity of M in F, in F's axes."""

    parent: int
    before: np.ndarray
    joint: Joint | None
    turn: Drive | None = None
    slide: Drive | None = None


class Frame(NamedTuple):
    """A body's frame: the step it follows and its constant pose (4, 4) there."""

    after: int
    X_MB: np.ndarray


class Wanted(NamedTuple):
    """What a pass computes: N, the highest derivative of the inputs, and of each body in this order the
    pose's 16 numbers, N twists (6 each), the Jacobian's derivatives (6, velocities) of `jacobians`
    orders, and their turning parts (3, velocities) of `turning` orders (`twist_partial` in
    `robot.partials`)."""

    order: int
    jacobians: int = 0
    turning: int = 0
