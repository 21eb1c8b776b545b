"""Reference motions: what a paper's symbols are on a motion that Drake made and differentiated.

A motion is a MultibodyPlant whose joint path is a polynomial in t. Its kinematics is evaluated by
Drake's plant on Expressions in t, and every time derivative is Drake's Expression.Differentiate.
No formula of rigid body kinematics stands here: an error in one would then also stand in the judge.
The exceptions are definitions: a dual quantity puts together a real and a dual part.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from functools import lru_cache

import numpy as np
from pydrake.math import RigidTransform_
from pydrake.multibody.math import SpatialVelocity_
from pydrake.symbolic import Variable

from workbench.drake.bindings import ALIASES, BINDINGS, Binding
from workbench.drake.joint_paths import JointPath
from workbench.drake.plants import CylindricalAxis, cylindrical_chain, free_body
from workbench.drake.symbolic_motions import (
    SymbolicMotion,
    evaluated,
    expanded,
    expressions_are_not_nan,
    rate,
)

SAMPLES = (-1.0, -0.75, -0.5, 0.5, 0.75, 1.0)
P_BO_P_B = np.array([0.5, -0.25, 1.0])
P_BO_Q_B = np.array([-0.75, 0.5, 0.25])



class ReferenceMotion:
    """Values and time derivatives of named quantities along one motion, in plain floats.

    ``samples`` are the times (seconds) at which the motion is meant to be looked at.
    """

    def __init__(
        self,
        name: str,
        time: Variable,
        quantities: Mapping[str, np.ndarray],
        samples: Sequence[float] = SAMPLES,
    ):
        self.name = name
        self.samples = tuple(samples)
        self._time = time
        self._derivatives = {key: [expanded(value)] for key, value in quantities.items()}
        self._values: dict[tuple[str, int, float], np.ndarray] = {}

    def __repr__(self) -> str:
        return f"<ReferenceMotion {self.name}>"

    def available_bindings(self) -> tuple[str, ...]:
        return tuple(self._derivatives)

    def binding(self, name: str) -> Binding:
        """Shape, weight and meaning of a binding; ValueError lists those that exist."""
        name = ALIASES.get(name, name)
        if name not in self._derivatives:
            raise ValueError(
                f"no binding {name!r} on the motion {self.name!r}; "
                f"it has {', '.join(self._derivatives)}"
            )
        return BINDINGS[name]

    def jet(self, binding: str, order: int, sample: float) -> np.ndarray:
        """The quantity and its time derivatives up to ``order`` at the time ``sample``.

        Returns shape (order + 1, *shape of the binding). Raises ValueError for a binding that
        this motion does not have, or a negative order.
        """
        name = self.binding(binding).name
        if order < 0:
            raise ValueError(f"the order of a jet is 0, 1, 2 ..., got {order}")
        return np.array([self._value(name, k, float(sample)) for k in range(order + 1)])

    def _value(self, name: str, order: int, sample: float) -> np.ndarray:
        key = (name, order, sample)
        if key not in self._values:
            self._values[key] = evaluated(self._derivative(name, order), self._time, sample)
        return self._values[key]

    def _derivative(self, name: str, order: int) -> np.ndarray:
        known = self._derivatives[name]
        while len(known) <= order:
            known.append(rate(known[-1], self._time))
        return known[order]


def _line(direction: np.ndarray, point: np.ndarray) -> np.ndarray:
    """A line's dual vector: direction, and moment about the origin."""
    return np.array([direction, np.cross(point, direction)])


def _dual_rotation(X: RigidTransform_) -> np.ndarray:
    """R + ε p̃ R: the columns of the dual part are p × the columns of R."""
    R = X.rotation().matrix()
    return np.array([R, np.cross(X.translation(), R.T).T])


def _dual_twist(V_WBp: SpatialVelocity_) -> np.ndarray:
    return np.array([V_WBp.rotational(), V_WBp.translational()])


def _body_quantities(motion: SymbolicMotion) -> dict[str, np.ndarray]:
    X_WB, V_WB, A_WB = motion.pose("B"), motion.velocity("B"), motion.acceleration("B")
    R_WB, p_WBo = X_WB.rotation().matrix(), X_WB.translation()
    V_WB0, A_WB0 = V_WB.Shift(-p_WBo), A_WB.Shift(-p_WBo, V_WB.rotational())
    w_WB = V_WB.rotational()
    p_WP, p_WQ = (expanded(X_WB @ p_BoPoint_B) for p_BoPoint_B in (P_BO_P_B, P_BO_Q_B))
    v_WP, v_WQ = motion.rate(p_WP), motion.rate(p_WQ)
    return {
        "R_WB": R_WB,
        "X_WB": X_WB.GetAsMatrix4(),
        "p_WBo": p_WBo,
        "p_WP": p_WP,
        "p_WQ": p_WQ,
        "p_BoP_B": P_BO_P_B,
        "p_BoQ_B": P_BO_Q_B,
        "p_QP_B": P_BO_P_B - P_BO_Q_B,
        "p_PQ_W": p_WQ - p_WP,
        "w_WB": w_WB,
        "alpha_WB": A_WB.rotational(),
        "v_WBo": V_WB.translational(),
        "v_WP": v_WP,
        "v_WQ": v_WQ,
        "v_WB0": V_WB0.translational(),
        "a_WBo": A_WB.translational(),
        "a_WP": motion.rate(v_WP),
        "a_WQ": motion.rate(v_WQ),
        "a_WB0": A_WB0.translational(),
        "dual_R_WB": _dual_rotation(X_WB),
        "dual_w_WB": _dual_twist(V_WB0),
        "dual_v_WP": np.array([w_WB, v_WP]),
        "dual_v_WQ": np.array([w_WB, v_WQ]),
    }


def _chain_quantities(
    motion: SymbolicMotion, second_joint: SymbolicMotion, axes: Sequence[CylindricalAxis]
) -> dict[str, np.ndarray]:
    """``second_joint`` moves B alone, with A for its world: the relative motion, seen from A."""
    A, B, W = motion.frame("A"), motion.frame("B"), motion.plant.world_frame()
    X_WA, X_AB = motion.pose("A"), second_joint.pose("B")
    V_WA, V_AB_A = motion.velocity("A"), second_joint.velocity("B")
    V_AB_W = B.CalcSpatialVelocity(motion.context, A, W)
    V_WA0 = V_WA.Shift(-X_WA.translation())
    V_AB0_W = V_AB_W.Shift(-motion.pose("B").translation())
    V_AB0_A = V_AB_A.Shift(-X_AB.translation())
    u1_W, u2_A = (np.array(axis.direction) for axis in axes)
    point1_W, point2_A = (np.array(axis.point) for axis in axes)
    u2_W = X_WA.rotation() @ u2_A
    point2_W = motion.pose("B_axis_on_parent").translation()
    d1, theta1, d2, theta2 = motion.q
    return {
        "R_WA": X_WA.rotation().matrix(),
        "R_AB": X_AB.rotation().matrix(),
        "X_WA": X_WA.GetAsMatrix4(),
        "X_AB": X_AB.GetAsMatrix4(),
        "p_WAo": X_WA.translation(),
        "p_ABo_A": X_AB.translation(),
        "w_WA": V_WA.rotational(),
        "w_AB_W": V_AB_W.rotational(),
        "w_AB_A": V_AB_A.rotational(),
        "v_WAo": V_WA.translational(),
        "v_WA0": V_WA0.translational(),
        "v_AB0_W": V_AB0_W.translational(),
        "v_AB0_A": V_AB0_A.translational(),
        "dual_R_WA": _dual_rotation(X_WA),
        "dual_R_AB": _dual_rotation(X_AB),
        "dual_w_WA": _dual_twist(V_WA0),
        "dual_w_AB_W": _dual_twist(V_AB0_W),
        "dual_w_AB_A": _dual_twist(V_AB0_A),
        "theta1": theta1,
        "theta2": theta2,
        "d1": d1,
        "d2": d2,
        "dual_theta1": np.array([theta1, d1]),
        "dual_theta2": np.array([theta2, d2]),
        "u1_W": u1_W,
        "u2_A": u2_A,
        "u2_W": u2_W,
        "dual_u1_W": _line(u1_W, point1_W),
        "dual_u2_A": _line(u2_A, point2_A),
        "dual_u2_W": _line(u2_W, point2_W),
    }


@expressions_are_not_nan
def chain_motion(name: str, axes: Sequence[CylindricalAxis], path: JointPath) -> ReferenceMotion:
    """Bodies A on W and B on A, each on a cylindrical joint; q = (d₁, θ₁, d₂, θ₂)."""
    t = Variable("t")
    motion = SymbolicMotion(cylindrical_chain(axes, ("A", "B")), path, t)
    second_path = JointPath(path.coefficients[:, 2:])
    second_joint = SymbolicMotion(cylindrical_chain(axes[1:], ("B",)), second_path, t)
    relative = _chain_quantities(motion, second_joint, axes)
    return ReferenceMotion(name, t, {**_body_quantities(motion), **relative})


@expressions_are_not_nan
def free_body_motion(name: str, path: JointPath) -> ReferenceMotion:
    """One free body B; q = (roll, pitch, yaw, x, y, z)."""
    t = Variable("t")
    return ReferenceMotion(name, t, _body_quantities(SymbolicMotion(free_body(), path, t)))


def _small_path(seed: int, joints: int) -> JointPath:
    """q = c₀ + c₁ t + c₆ t⁶: few terms, yet no derivative up to the sixth is zero.

    The coefficients are dyadic, hence exact in doubles.
    """
    draw = random.Random(seed)
    coefficients = np.zeros((7, joints))
    for power, unit in ((0, 1 / 4), (1, 1 / 4), (6, 1 / 32)):
        coefficients[power] = [draw.choice((-4, -3, -2, 2, 3, 4)) * unit for _ in range(joints)]
    return JointPath(coefficients)


def _small_axes(seed: int) -> tuple[CylindricalAxis, CylindricalAxis]:
    """Two skew axes whose directions are rational unit vectors."""
    draw = random.Random(seed)
    integer_lengths = (((1, 2, 2), 3), ((2, -3, 6), 7), ((1, 4, -8), 9), ((2, 6, 9), 11))
    return tuple(
        CylindricalAxis(
            tuple(component / length for component in draw.sample(direction, 3)),
            tuple(draw.randint(-4, 4) / 4 for _ in range(3)),
        )
        for direction, length in draw.sample(integer_lengths, 2)
    )


@lru_cache(maxsize=1)
def reference_motions() -> tuple[ReferenceMotion, ...]:
    """The general motions: nothing that moves stands still, in any derivative up to the fifth."""
    chains = (
        chain_motion(
            f"two cylindrical joints, seed {seed}",
            _small_axes(seed),
            _small_path(seed, joints=4),
        )
        for seed in (1, 2)
    )
    return (*chains, free_body_motion("free body, seed 3", _small_path(3, joints=6)))


@lru_cache(maxsize=1)
def special_motions() -> tuple[ReferenceMotion, ...]:
    """Free bodies where something vanishes: where centres are lost and equalities are strict."""
    general = _small_path(4, joints=6).coefficients

    def restricted(name: str, moving: Sequence[int], degree: int = 6) -> ReferenceMotion:
        kept = np.zeros_like(general)
        kept[: degree + 1, moving] = general[: degree + 1, moving]
        return free_body_motion(name, JointPath(kept))

    roll, _pitch, yaw, x, y, z = range(6)
    return (
        restricted("rest", ()),
        restricted("translation", (x, y, z)),
        restricted("spin about a fixed axis", (yaw,)),
        restricted("steady screw motion", (roll, x), degree=1),
        restricted("plane motion", (yaw, x, y)),
    )
