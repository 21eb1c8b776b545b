"""Bounds on the terms of a body's motion, to which rounding errors are relative.

On a chain of joints R_WB is a product of rotations by the joint angles qᵢ, each of which satisfies ‖dⁿ/dtⁿ
exp(qᵢ ũ)‖ ≤ n! [sⁿ] exp(Σ_k |qᵢ^(k)| s^k / k!). The product is thus bounded by the same series with Σᵢ
|qᵢ^(k)|, and p_WBo, a sum of such products times link lengths and displacements, by that series times the
series of the lengths. The bound is that of a sum of absolute values of terms. Cancellation may make the value
itself smaller, but not its rounding error. The same holds for each qᵢ^(k): its error is measured against the
terms of the path that it is summed from, and propagated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import factorial

import numpy as np

from workbench.drake.gate import Joint, MultibodyPlant
from workbench.drake.joint_paths import Path
from workbench.drake.plants import body_named

EPSILON = np.finfo(float).eps

#: In rad/s: slower joints do not widen the windows of `Reach.half_widths` any further.
SLOWEST = 1e-3


@dataclass(frozen=True)
class Reach:
    """The joints between W and a body: indices into q by kind, and the lengths between them."""

    rotations: tuple[int, ...]
    translations: tuple[int, ...]
    length: float

    @property
    def joints(self) -> int:
        return len(set(self.rotations + self.translations))

    def turning(self, path: Path, t: float, order: int) -> np.ndarray:
        """Returns Σᵢ |qᵢ^(k)| / k! over the rotations, k = 0 .. order."""
        return _taylor(np.abs(path.jet(t, order)), self.rotations)

    def bound(self, path: Path, t: float, order: int) -> float:
        """Returns a bound on the terms of the n-th derivatives of R_WB and p_WBp, n = order."""
        return self._bound(np.abs(path.jet(t, order)))

    def rounding_error(self, path: Path, t: float, order: int) -> float:
        """Returns the rounding error of Drake's n-th derivative.

        It consists of some roundings for every joint on terms of this size, and those of the path's own
        values.
        """
        sizes = np.abs(path.jet(t, order))
        noise = 8 * EPSILON * path.magnitudes(t, order)
        turned = noise[0, list(self.rotations)].sum()
        bound, disturbed = self._bound(sizes), self._bound(sizes + noise)
        return (8 * (self.joints + 1) * EPSILON + turned) * disturbed + (disturbed - bound)

    def _bound(self, sizes: np.ndarray) -> float:
        order = len(sizes) - 1
        lengths = _taylor(sizes, self.translations)
        lengths[0] += self.length
        rotation = _exponential(_taylor(sizes, self.rotations))
        position = np.convolve(rotation, lengths)[order]
        return factorial(order) * float(max(rotation[order], position))

    def half_widths(self, path: Path, turns: Sequence[float]) -> list[float]:
        """Returns half-widths around t = 0, in s, in which the joints together turn by at most each of
        `turns`, in rad."""
        near = path.taylor(0.0)
        turning = self.turning(near, 0.0, max(1, near.degree))
        turning[0] = 0.0
        if not np.any(turning):
            return [0.5, 1.0]
        turning[1] = max(turning[1], SLOWEST)
        widths = []
        for turn in turns:
            polynomial = turning.copy()
            polynomial[0] = -turn
            roots = np.roots(np.trim_zeros(polynomial[::-1], "f"))
            widths.append(max(root.real for root in roots if abs(root.imag) < 1e-9 * abs(root)))
        return widths


def _taylor(sizes: np.ndarray, joints: tuple[int, ...]) -> np.ndarray:
    return sizes[:, list(joints)].sum(axis=1) / np.array([float(factorial(k)) for k in range(len(sizes))])


def _exponential(series: np.ndarray) -> np.ndarray:
    """Returns exp of a power series without its constant term, since a constant angle moves nothing."""
    result = np.zeros_like(series)
    result[0] = 1.0
    for n in range(1, len(series)):
        result[n] = sum(k * series[k] * result[n - k] for k in range(1, n + 1)) / n
    return result


def reach(plant: MultibodyPlant, body: str, p_BoBp_B: np.ndarray) -> Reach:
    """Returns the joints that carry the body's point Bp. A joint of another kind counts as both."""
    inboard: dict[int, Joint] = {}
    for index in plant.GetJointIndices():
        joint = plant.get_joint(index)
        inboard[int(joint.child_body().index())] = joint
    rotations: list[int] = []
    translations: list[int] = []
    length = float(np.linalg.norm(p_BoBp_B))
    here = int(body_named(plant, body).index())
    while here in inboard:
        joint = inboard[here]
        start = joint.position_start()
        positions = range(start, start + joint.num_positions())
        if joint.type_name() != "prismatic":
            rotations += positions
        if joint.type_name() != "revolute":
            translations += positions
        for frame in (joint.frame_on_parent(), joint.frame_on_child()):
            length += float(np.linalg.norm(frame.GetFixedPoseInBodyFrame().translation()))
        here = int(joint.parent_body().index())
    return Reach(tuple(rotations), tuple(translations), length)
