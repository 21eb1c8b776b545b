"""Serial chains of random joints."""

import numpy as np
from kinematics.random_robots import random_pose

from workbench.kinematics.chain import Joint

MOVING = ("revolute", "prismatic", "cylindrical", "helical")


def random_joint(rng, kind):
    axis, point = rng.normal(size=3), rng.normal(size=3)
    return {
        "revolute": lambda: Joint.revolute(axis, point),
        "prismatic": lambda: Joint.prismatic(axis),
        "cylindrical": lambda: Joint.cylindrical(axis, point),
        "helical": lambda: Joint.helical(axis, point, pitch=rng.normal()),
        "fixed": lambda: Joint.fixed(random_pose(rng)),
    }[kind]()


def random_joints(rng, count, kinds=(*MOVING, "fixed")):
    joints = [random_joint(rng, rng.choice(kinds)) for _ in range(count)]
    return [random_joint(rng, rng.choice(MOVING)), *joints]


def close(actual, expected, digits=11):
    expected = np.asarray(expected, dtype=float)
    scale = np.abs(expected).max(initial=1e-300)
    np.testing.assert_allclose(actual, expected, rtol=0, atol=scale * 10.0**-digits)
