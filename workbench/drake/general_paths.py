"""General joint paths and joint axes of small numbers, on which no derivative vanishes."""

from __future__ import annotations

import random
from collections.abc import Iterable

import numpy as np

from workbench.drake.joint_paths import JointPath
from workbench.drake.plants import CylindricalAxis


def _three(values: Iterable[float]) -> tuple[float, float, float]:
    x, y, z = values
    return x, y, z


def small_path(seed: int, joints: int) -> JointPath:
    """Returns q = c₀ + c₁ t + c₆ t⁶: few terms, yet no derivative up to the sixth is zero.

    The coefficients are dyadic, hence exact in doubles.
    """
    draw = random.Random(seed)
    coefficients = np.zeros((7, joints))
    for power, unit in ((0, 1 / 4), (1, 1 / 4), (6, 1 / 32)):
        coefficients[power] = [draw.choice((-4, -3, -2, 2, 3, 4)) * unit for _ in range(joints)]
    return JointPath(coefficients)


def small_axes(seed: int, count: int = 2) -> tuple[CylindricalAxis, ...]:
    """Returns skew axes, at most four, whose directions are rational unit vectors."""
    draw = random.Random(seed)
    integer_lengths = (((1, 2, 2), 3), ((2, -3, 6), 7), ((1, 4, -8), 9), ((2, 6, 9), 11))
    return tuple(
        CylindricalAxis(
            _three(component / length for component in draw.sample(direction, 3)),
            _three(draw.randint(-4, 4) / 4 for _ in range(3)),
        )
        for direction, length in draw.sample(integer_lengths, count)
    )
