"""Three bodies in every configuration of Remark 7: in rational numbers, and as plants of Drake's.

Bodies A on W and B on A, each on a cylindrical joint; in the state that is looked at the frames of
all bodies coincide, so that the twists are θ̇ and ḋ along the joints' lines. A check asks whether the
common perpendiculars that `three_axes` gives hold a point of every axis, one whose velocity is along
ω, and are normal to every ω and, in the cases with a translation that has no axis, to it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import cross, dot, scale
from workbench.kinematics.aronhold_kennedy import Configuration, ThreeAxes, relative_twists, three_axes

TOLERANCE = 1e-13
SLIDES = (Fraction(0), Fraction(3, 2), Fraction(-2, 5))
X, Z, OBLIQUE = (1, 0, 0), (0, 0, 1), (Fraction(1, 3), Fraction(2, 3), Fraction(2, 3))


@dataclass(frozen=True)
class CylindricalJoint:
    """direction: a unit vector; point: in m; turn, slide: θ̇ in rad/s and ḋ in m/s."""

    direction: tuple[Any, Any, Any]
    point: tuple[Any, Any, Any]
    turn: Any
    slide: Any

    def twist(self) -> Dual:
        u, p = (np.array([Fraction(x) for x in v], dtype=object) for v in (self.direction, self.point))
        turn, slide = Fraction(self.turn), Fraction(self.slide)
        return Dual(turn * u, slide * u + turn * cross(p, u))


_Joint = CylindricalJoint

#: The joints of A and B; the pitches agree in the second example of PARALLEL alone.
JOINTS = {
    Configuration.SKEW: [
        (_Joint(OBLIQUE, (1, 0, 2), 3, -1), _Joint(Z, (0, 1, 0), -2, 5)),
        (_Joint(X, (0, 0, 1), 1, 0), _Joint(Z, (0, 3, 0), 1, 0)),
    ],
    Configuration.TWO_MEET: [
        (_Joint(OBLIQUE, (1, 2, 3), 3, 1), _Joint(Z, (1, 2, -4), 2, -1)),
    ],
    Configuration.CONCURRENT: [
        (_Joint(OBLIQUE, (1, 2, 3), 3, 0), _Joint(Z, (1, 2, -4), 2, 0)),
        (_Joint(X, (0, 1, 0), 1, 2), _Joint(Z, (0, 1, 0), -3, -6)),
    ],
    Configuration.PARALLEL: [
        (_Joint(Z, (1, 0, 0), 1, 1), _Joint(Z, (4, -2, 1), 2, -3)),
        (_Joint(OBLIQUE, (1, 0, 0), 2, 1), _Joint(OBLIQUE, (0, 3, 1), -4, -2)),
    ],
    Configuration.COINCIDENT: [
        (_Joint(Z, (1, 2, 0), 1, 1), _Joint(Z, (1, 2, 5), 2, -3)),
        (_Joint(OBLIQUE, (1, 2, 3), 1, 0), _Joint(OBLIQUE, (2, 4, 5), -3, 0)),
    ],
    Configuration.PARALLEL_TRANSLATION: [
        (_Joint(Z, (1, 0, 0), 2, 1), _Joint(Z, (4, -2, 1), -2, 3)),
        (_Joint(OBLIQUE, (1, 0, 0), 2, 1), _Joint(OBLIQUE, (0, 3, 1), -2, -1)),
    ],
    Configuration.COINCIDENT_TRANSLATION: [
        (_Joint(OBLIQUE, (1, 2, 3), 2, 1), _Joint(OBLIQUE, (2, 4, 5), -2, 3)),
    ],
    Configuration.COINCIDENT_REST: [
        (_Joint(OBLIQUE, (1, 2, 3), 2, 1), _Joint(OBLIQUE, (2, 4, 5), -2, -1)),
    ],
    Configuration.TRANSLATIONS: [
        (_Joint(X, (1, 2, 3), 0, 1), _Joint(OBLIQUE, (2, 0, 0), 0, -3)),
        (_Joint(X, (1, 2, 3), 0, 1), _Joint(X, (2, 0, 0), 0, -1)),
    ],
    Configuration.REST: [
        (_Joint(X, (1, 2, 3), 0, 0), _Joint(OBLIQUE, (2, 0, 0), 0, 0)),
    ],
}
#: The same configurations where the first motion, and not the third, is the one without an axis.
JOINTS_FIRST_TRANSLATES = {
    Configuration.PARALLEL_TRANSLATION: [
        (_Joint(OBLIQUE, (1, 2, 3), 0, 3), _Joint(Z, (1, 2, -4), 2, 1)),
    ],
    Configuration.COINCIDENT_TRANSLATION: [
        (_Joint(Z, (1, 2, 3), 0, 3), _Joint(Z, (1, 5, -4), 2, 1)),
    ],
}


def examples(configuration: Configuration, first_translates: bool) -> list[tuple[Any, Any]]:
    return (JOINTS_FIRST_TRANSLATES if first_translates else JOINTS)[configuration]


def rational_checks(configuration: Configuration, first_translates: bool, spoilt: bool) -> Iterator[bool]:
    """In Fractions, by the velocities of points; ``spoilt``: of lines moved off the axes."""
    for joints in examples(configuration, first_translates):
        first, second = (joint.twist() for joint in joints)
        found = three_axes(first, second)
        yield found.configuration == _expected(configuration, spoilt)
        for line in _perpendiculars(found, spoilt):
            for twist, has_axis in zip((first, second, first + second), found.has_axis, strict=True):
                if not has_axis:
                    yield dot(line.re, twist.du) == 0
                    continue
                yield dot(line.re, twist.re) == 0
                foot = _foot(line, twist)
                yield not np.any(cross(twist.re, twist.du + cross(twist.re, foot)))


def drake_checks(configuration: Configuration, first_translates: bool, spoilt: bool) -> Iterator[bool]:
    """The same on a plant: twists and the velocities of points are Drake's, the line is ours."""
    for joints in examples(configuration, first_translates):
        plant, context = _plant(joints)
        twists = relative_twists(plant, context, ("world", "A", "B"))
        found = three_axes(twists[0], twists[1])
        yield found.configuration == _expected(configuration, spoilt)
        for line in _perpendiculars(found, spoilt):
            pairs = (("A", "world"), ("B", "A"), ("B", "world"))
            for twist, has_axis, pair in zip(twists, found.has_axis, pairs, strict=True):
                residuals = _drake_residuals(plant, context, pair, line, twist, has_axis)
                yield all(abs(r) <= TOLERANCE for r in residuals)


def _expected(configuration: Configuration, spoilt: bool) -> Configuration:
    """The control moves the lines; where no motion has an axis, there are none to move."""
    return Configuration.SKEW if spoilt and configuration.freedom == 4 else configuration


def _drake_residuals(
    plant: Any, context: Any, pair: tuple[str, str], line: Dual, twist: Dual, has_axis: bool
) -> Iterator[float]:
    moving, fixed = (plant.GetBodyByName(name).body_frame() for name in pair)
    V = moving.CalcSpatialVelocity(context, fixed, plant.world_frame())
    direction = line.re / np.linalg.norm(line.re)
    if not has_axis:
        yield direction @ V.translational()
        return
    p_WBo = moving.CalcPoseInWorld(context).translation()
    V_at_foot = V.Shift(_foot(line, twist) - p_WBo)
    yield direction @ V_at_foot.rotational()
    yield from np.cross(V_at_foot.rotational(), V_at_foot.translational())


def _plant(joints: tuple[Any, Any]) -> tuple[Any, Any]:
    from workbench.drake.plants import CylindricalAxis, cylindrical_chain, set_state

    axes = [CylindricalAxis(tuple(map(float, j.direction)), tuple(map(float, j.point))) for j in joints]
    plant = cylindrical_chain(axes, ("A", "B"))
    context = plant.CreateDefaultContext()
    rates = [float(rate) for joint in joints for rate in (joint.slide, joint.turn)]
    set_state(plant, context, np.zeros(4), rates)
    return plant, context


def _perpendiculars(found: ThreeAxes, spoilt: bool) -> Iterator[Dual]:
    """The one, or some of the family; where no motion has an axis, none."""
    freedom = found.configuration.freedom
    if freedom == 4:
        return
    for slide in SLIDES if freedom else SLIDES[:1]:
        exact = found.perpendicular.re.dtype == object
        line = found.perpendicular
        if freedom:
            line = found.perpendicular_at(slide if exact else float(slide))
        if spoilt:
            axis = next(a for a, has in zip(found.axes.re, found.has_axis, strict=True) if has)
            line = Dual(line.re, line.du + cross(cross(axis, line.re), line.re))
        yield line


def _foot(line: Dual, twist: Dual) -> np.ndarray:
    """The point of the line at which ω × (v + ω × x), in the line's direction, is 0."""
    d, omega = line.re, twist.re
    base = scale(1 / dot(d, d), cross(d, line.du))
    across = cross(omega, twist.du + cross(omega, base))
    return base + scale(dot(d, across) / (dot(omega, omega) * dot(d, d)), d)
