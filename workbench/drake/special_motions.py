"""Special motions with vanishing quantities: lost centres, parallel axes, equality cases.

Each is a general motion with some coordinates fixed at 0, or opposite to others.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.drake.motions import ReferenceMotion
    from workbench.drake.plants import CylindricalAxis

ROLL, _PITCH, YAW, X, Y, Z = range(6)
D1, THETA1, D2, THETA2 = range(4)


@dataclass(frozen=True)
class _Kept:
    """The restrictions of a special motion.

    Attributes:
        moving: The coordinates that are not fixed at 0.
        degree: The degree of their polynomials in t.
        opposite: A pair of coordinates, the second being minus the first.
        axes: The axes of a chain, made of two skew ones.
    """

    moving: tuple[int, ...]
    degree: int = 6
    opposite: tuple[int, int] | None = None
    axes: Callable[[CylindricalAxis, CylindricalAxis], tuple[CylindricalAxis, CylindricalAxis]] | None = None


def _skew(first: CylindricalAxis, second: CylindricalAxis) -> tuple[CylindricalAxis, CylindricalAxis]:
    return first, second


def _parallel(first: CylindricalAxis, second: CylindricalAxis) -> tuple[CylindricalAxis, CylindricalAxis]:
    return first, replace(second, direction=first.direction)


def _one(first: CylindricalAxis, _: CylindricalAxis) -> tuple[CylindricalAxis, CylindricalAxis]:
    return first, first


_ALL = (D1, THETA1, D2, THETA2)

_SPECIAL = {
    "rest": _Kept(()),
    "translation": _Kept((X, Y, Z)),
    "spin about a fixed axis": _Kept((YAW,)),
    "steady screw motion": _Kept((ROLL, X), degree=1),
    "plane motion": _Kept((YAW, X, Y)),
    "two parallel cylindrical joints": _Kept(_ALL, axes=_parallel),
    "two cylindrical joints on one axis": _Kept(_ALL, axes=_one),
    "two parallel cylindrical joints, turning against each other": _Kept(
        _ALL, opposite=(THETA1, THETA2), axes=_parallel
    ),
    "two revolute joints": _Kept((THETA1, THETA2), axes=_skew),
    "a cylindrical and a prismatic joint": _Kept((D1, THETA1, D2), axes=_skew),
    "two prismatic joints": _Kept((D1, D2), axes=_skew),
}

NAMES = tuple(_SPECIAL)


@lru_cache(maxsize=len(NAMES))
def special_motion(name: str) -> ReferenceMotion:
    """Returns one of `NAMES`: a free body, or two bodies A on W and B on A. Raises KeyError for another
    name."""
    from workbench.drake.general_paths import small_axes, small_path
    from workbench.drake.joint_paths import JointPath
    from workbench.drake.motions import chain_motion, free_body_motion

    kept = _SPECIAL[name]
    coefficients = small_path(4, joints=4 if kept.axes else 6).coefficients.copy()
    held = [joint for joint in range(coefficients.shape[1]) if joint not in kept.moving]
    coefficients[:, held] = 0
    coefficients[kept.degree + 1 :] = 0
    if kept.opposite is not None:
        one, other = kept.opposite
        coefficients[:, other] = -coefficients[:, one]
    path = JointPath(coefficients)
    return chain_motion(name, kept.axes(*small_axes(4)), path) if kept.axes else free_body_motion(name, path)
