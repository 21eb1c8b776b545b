"""Robots of random joints, and their random motions."""

import numpy as np

from workbench.kinematics.robot import Robot, TreeJoint
from workbench.kinematics.robot.joints import COORDINATES

KINDS = tuple(COORDINATES)
NEAR = {"rtol": 0, "atol": 1e-10}


def random_pose(rng):
    Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = Q * np.linalg.det(Q), rng.uniform(-1, 1, 3)
    return X


def joint(rng, number, kind, parent):
    return TreeJoint(
        f"j{number}", kind, parent, f"b{number}", random_pose(rng), random_pose(rng), rng.normal(size=3), 0.3
    )


def tree(seed, kinds=None):
    """A tree of joints of all kinds; every third one branches off."""
    rng = np.random.default_rng(seed)
    kinds = rng.permutation(KINDS) if kinds is None else kinds
    parents = ["world" if i == 0 else f"b{i - 1 - (i > 1 and i % 3 == 0)}" for i in range(len(kinds))]
    return Robot("tree", [joint(rng, *entry) for entry in zip(range(99), kinds, parents, strict=False)])


def motion(robot, order, states=(), seed=0):
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(order + 1, *states, len(robot.positions)))
    return robot.motion(q)


def series_pose(robot, q_derivatives, body, t):
    """X_WB at the time t on the path with these derivatives at 0."""
    factor = np.cumprod([1, *(t / k for k in range(1, len(q_derivatives)))])
    at = np.tensordot(factor, q_derivatives, axes=1)
    return robot.motion(np.stack([at, at])).frame(body).pose
