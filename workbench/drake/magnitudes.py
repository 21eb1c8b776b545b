"""How large a body's motion can be, term by term: what rounding errors are measured against.

On a chain of joints R_WB is a product of rotations by the joint angles qᵢ, each of which satisfies
‖dⁿ/dtⁿ exp(qᵢ ũ)‖ ≤ n! [sⁿ] exp(Σ_k |qᵢ^(k)| s^k / k!). The product is thus bounded by the same
with Σᵢ |qᵢ^(k)|, and p_WBo, a sum of such products times link lengths and displacements, by that
series times the series of the lengths. The bound is that of a sum of absolute values of terms; the
value itself may be smaller by cancellation, its rounding error not.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import factorial

import numpy as np
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import Joint

from workbench.drake.joint_paths import JointPath
from workbench.drake.plants import body_named

EPSILON = np.finfo(float).eps


@dataclass(frozen=True)
class Reach:
    """The joints between W and a body: indices into q by kind, and the lengths between them."""

    rotations: tuple[int, ...]
    translations: tuple[int, ...]
    length: float

    @property
    def joints(self) -> int:
        return len(set(self.rotations + self.translations))

    def turning(self, path: JointPath, t: float, order: int) -> np.ndarray:
        """Σᵢ |qᵢ^(k)| / k! over the rotations, k = 0 .. order."""
        return self._summed(path, t, order, self.rotations)

    def bound(self, path: JointPath, t: float, order: int) -> float:
        """A bound on the terms of the n-th derivatives of R_WB and p_WBp, n = order."""
        exponent = self.turning(path, t, order)
        lengths = self._summed(path, t, order, self.translations)
        lengths[0] += self.length
        rotation = _exponential(exponent)
        position = np.convolve(rotation, lengths)[order]
        return factorial(order) * float(max(rotation[order], position))

    def rounding_error(self, path: JointPath, t: float, order: int) -> float:
        """Of Drake's n-th derivative: some roundings for every joint, on terms of this size."""
        return 8 * (self.joints + 1) * EPSILON * self.bound(path, t, order)

    @staticmethod
    def _summed(path: JointPath, t: float, order: int, joints: tuple[int, ...]) -> np.ndarray:
        jet = np.abs(path.jet(t, order))[:, list(joints)].sum(axis=1)
        return jet / np.array([float(factorial(k)) for k in range(order + 1)])


def _exponential(series: np.ndarray) -> np.ndarray:
    """exp of a power series, its constant term left out: a constant angle moves nothing."""
    result = np.zeros_like(series)
    result[0] = 1.0
    for n in range(1, len(series)):
        result[n] = sum(k * series[k] * result[n - k] for k in range(1, n + 1)) / n
    return result


def reach(plant: MultibodyPlant, body: str, p_BoBp_B: np.ndarray) -> Reach:
    """The joints that carry the body's point Bp. A joint of another kind counts as both."""
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
