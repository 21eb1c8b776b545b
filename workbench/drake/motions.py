"""Reference motions: the values of a paper's symbols on a motion that Drake evaluates and differentiates.

A motion is a MultibodyPlant whose joint path is a polynomial in t. Its kinematics is evaluated by Drake's
plant on Expressions in t, and every time derivative is Drake's Expression.Differentiate.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache, partial

import numpy as np

from workbench.drake.bindings import ALIASES, BINDINGS, Binding
from workbench.drake.gate import Variable
from workbench.drake.general_paths import small_axes, small_path
from workbench.drake.joint_paths import JointPath
from workbench.drake.magnitudes import reach
from workbench.drake.plants import CylindricalAxis, cylindrical_chain, free_body
from workbench.drake.quantities import (
    P_BO_P_B,
    Quantities,
    angle_quantities,
    body_quantities,
    cylinder_quantities,
    relative_quantities,
    six_coordinates,
)
from workbench.drake.symbolic_motions import Entries, SymbolicMotion, expressions_are_not_nan

SAMPLES = (-1.0, -0.75, -0.5, 0.5, 0.75, 1.0)
COURSE = tuple(k / 8 for k in range(-8, 9))


class ReferenceMotion:
    """Values and time derivatives of named quantities along one motion, in plain floats.

    Attributes:
        samples: The times (seconds) at which the motion is evaluated.
        course: The times of plots.
    """

    course = COURSE

    def __init__(
        self,
        name: str,
        moving: SymbolicMotion,
        quantities: Mapping[str, np.ndarray],
        samples: Sequence[float] = SAMPLES,
    ):
        self.name = name
        self.samples = tuple(samples)
        self._reach = reach(moving.numeric_plant, "B", P_BO_P_B)
        self.plant, self.path, self.body = moving.numeric_plant, moving.path, "B"
        entries = Entries(moving.time)
        self._quantities = {name: entries.of(quantity) for name, quantity in quantities.items()}
        self._rounding = lru_cache(maxsize=None)(partial(self._reach.rounding_error, self.path))

    def __repr__(self) -> str:
        return f"<ReferenceMotion {self.name}>"

    def available_bindings(self) -> tuple[str, ...]:
        return tuple(self._quantities)

    def binding(self, name: str) -> Binding:
        """Returns shape, weight and meaning of a binding. Raises ValueError with the existing ones."""
        name = ALIASES.get(name, name)
        if name not in self._quantities:
            raise ValueError(
                f"no binding {name!r} on the motion {self.name!r}; it has {', '.join(self._quantities)}"
            )
        return BINDINGS[name]

    def jet(self, binding: str, order: int, sample: float) -> np.ndarray:
        """Returns the quantity and its time derivatives up to ``order`` at the time ``sample``.

        The shape is (order + 1, *shape of the binding). Raises ValueError for a binding that this motion does
        not have, or a negative order.
        """
        name = self.binding(binding).name
        if order < 0:
            raise ValueError(f"the order of a jet is 0, 1, 2 ..., got {order}")
        entries, time = self._quantities[name], float(sample)
        values = [[entry.value(k, time) for entry in entries.flat] for k in range(order + 1)]
        return np.array(values).reshape(order + 1, *entries.shape)

    def errors(self, binding: str, order: int, sample: float) -> np.ndarray:
        """Returns the rounding error estimated for the entries of each of `jet`'s derivatives, shape (order +
        1,)."""
        weight = self.binding(binding).weight
        return np.array([self._rounding(sample, weight + k) for k in range(order + 1)])


@expressions_are_not_nan
def _body_quantities(motion: SymbolicMotion) -> Quantities:
    return body_quantities(motion.pose("B"), motion.velocity("B"), motion.acceleration("B"))


def _chain_quantities(
    motion: SymbolicMotion, second_joint: SymbolicMotion, axes: Sequence[CylindricalAxis]
) -> Quantities:
    """Returns the quantities of a chain. ``second_joint`` moves B alone, with A as its world: the relative
    motion."""
    A, B, W = motion.frame("A"), motion.frame("B"), motion.plant.world_frame()
    X_WA, X_WB = motion.pose("A"), motion.pose("B")
    X_AB, V_AB_A = second_joint.pose("B"), second_joint.velocity("B")
    V_AB_W = B.CalcSpatialVelocity(motion.context, A, W)
    point2_W = motion.pose("B_axis_on_parent").translation()
    return {
        **relative_quantities(X_WA, motion.velocity("A"), X_AB, V_AB_A, X_WB, V_AB_W),
        **cylinder_quantities(motion.q, axes, X_WA, point2_W),
    }


@expressions_are_not_nan
def chain_motion(name: str, axes: Sequence[CylindricalAxis], path: JointPath) -> ReferenceMotion:
    """Returns a motion of the bodies A on W and B on A, each on a cylindrical joint; q = (d₁, θ₁, d₂, θ₂).

    axes: the two joints. path: four coordinates, in m and rad. Raises PlantError for another number of them.

    >>> from workbench.drake import CylindricalAxis, JointPath
    >>> axes = [CylindricalAxis((0, 0, 1), (0, 0, 0)), CylindricalAxis((1, 0, 0), (0, 0, 1))]
    >>> turn = chain_motion("turn", axes, JointPath([[0, 0, 0, 0], [0, 2, 0, 0]]))
    >>> turn.jet("w_WB", order=0, sample=0.5).tolist()
    [[0.0, 0.0, 2.0]]
    """
    t = Variable("t")
    motion = SymbolicMotion(cylindrical_chain(axes, ("A", "B")), path, t)
    second_path = JointPath(path.coefficients[:, 2:])
    second_joint = SymbolicMotion(cylindrical_chain(axes[1:], ("B",)), second_path, t)
    relative = _chain_quantities(motion, second_joint, axes)
    return ReferenceMotion(name, motion, {**_body_quantities(motion), **relative})


@expressions_are_not_nan
def free_body_motion(name: str, path: JointPath) -> ReferenceMotion:
    """Returns one free body B; q = (roll, pitch, yaw, x, y, z)."""
    t = Variable("t")
    motion = SymbolicMotion(free_body(), path, t)
    rates = motion.rate(motion.q)
    own = {
        **_body_quantities(motion),
        **six_coordinates(motion.plant, motion.context, motion.frame("B"), rates),
        **angle_quantities(motion.q[:3], motion.velocity("B").rotational()),
    }
    return ReferenceMotion(name, motion, own)


@lru_cache(maxsize=1)
def reference_motions() -> tuple[ReferenceMotion, ...]:
    """Returns the general motions: no derivative up to the fifth of a moving quantity vanishes.

    >>> for motion in reference_motions():
    ...     print(motion.name)
    two cylindrical joints, seed 1
    two cylindrical joints, seed 2
    free body, seed 3
    """
    chains = (
        chain_motion(f"two cylindrical joints, seed {seed}", small_axes(seed), small_path(seed, joints=4))
        for seed in (1, 2)
    )
    return (*chains, free_body_motion("free body, seed 3", small_path(3, joints=6)))
