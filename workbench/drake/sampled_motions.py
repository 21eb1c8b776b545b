"""Reference motions of plants whose Expressions would grow too large: Drake in doubles, on Chebyshev nodes.

Drake's plant evaluates every quantity in doubles, at a time and on the nodes of several windows around it.
The derivatives are those of its Chebyshev expansions, each with its estimated error.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from pathlib import Path

import numpy as np

from workbench.drake import chebyshev
from workbench.drake.bindings import BINDINGS, Binding
from workbench.drake.gate import (
    FixedOffsetFrame,
    MultibodyPlant,
    RevoluteJoint,
    RigidTransform,
    SpatialInertia,
)
from workbench.drake.general_paths import small_axes, small_path
from workbench.drake.joint_paths import JointPath
from workbench.drake.magnitudes import reach
from workbench.drake.plants import (
    CylindricalAxis,
    PlantError,
    body_named,
    cylindrical_chain,
    load_urdf,
    set_state,
)
from workbench.drake.quantities import (
    P_BO_P_B,
    Quantities,
    body_quantities,
    cylinder_quantities,
    relative_quantities,
    six_coordinates,
    third_body_quantities,
    turn_quantities,
)

SAMPLES = (-0.75, 0.5)
COURSE: tuple[float, ...] = (-1.0, -0.5, 0.0, 0.5, 1.0)

#: The sums of joint angles, in rad, covered by half of a window.
TURNS = (4.0, 6.0)


class Posture:
    """A plant at one instant of a joint path, in Drake's doubles."""

    def __init__(self, plant: MultibodyPlant, path: JointPath) -> None:
        self.plant, self.path = plant, path
        self.context = plant.CreateDefaultContext()
        self.world = plant.world_frame()

    def at(self, t: float) -> Posture:
        self.q, self.v, vdot = self.path.jet(t, 2)
        set_state(self.plant, self.context, self.q, self.v)
        self._A = self.plant.CalcSpatialAccelerationsFromVdot(self.context, vdot)
        return self

    def frame(self, name: str):
        return self.plant.GetFrameByName(name)

    def pose(self, name: str, measured_in: str | None = None):
        return self.frame(name).CalcPose(self.context, self._frame_or_world(measured_in))

    def velocity(self, name: str, measured_in: str | None = None, expressed_in: str | None = None):
        frames = (self._frame_or_world(other) for other in (measured_in, expressed_in))
        return self.frame(name).CalcSpatialVelocity(self.context, *frames)

    def acceleration(self, name: str):
        return self._A[int(body_named(self.plant, name).index())]

    def _frame_or_world(self, name: str | None):
        return self.world if name is None else self.frame(name)


class SampledMotion:
    """Values and time derivatives of named quantities along one motion, as in `ReferenceMotion`.

    ``body``: the name in the plant of the body that the bindings call B.
    """

    course = COURSE

    def __init__(
        self,
        name: str,
        plant: MultibodyPlant,
        path: JointPath,
        quantities: Callable[[Posture], Quantities],
        body: str = "B",
        samples: Sequence[float] = SAMPLES,
        turns: Sequence[float] = TURNS,
    ) -> None:
        if path.joints != plant.num_positions() or not plant.IsVelocityEqualToQDot():
            raise PlantError(f"{name}: a path of {path.joints} joints does not fit the plant")
        self.name, self.samples = name, tuple(samples)
        self.plant, self.path, self.body = plant, path, body
        self._reach = reach(plant, body, P_BO_P_B)
        self._posture = Posture(plant, path)
        self._widths = lru_cache(maxsize=None)(
            lambda time: self._reach.half_widths(path.shifted(time), turns)
        )
        self._quantities = quantities
        self._at = lru_cache(maxsize=None)(self._evaluated)
        self._rounding = lru_cache(maxsize=None)(partial(self._reach.rounding_error, path))
        self._jets: dict[tuple[str, float], tuple[np.ndarray, np.ndarray]] = {}

    def __repr__(self) -> str:
        return f"<SampledMotion {self.name}>"

    def available_bindings(self) -> tuple[str, ...]:
        return tuple(self._at(self.samples[0]))

    def binding(self, name: str) -> Binding:
        """Returns shape, weight and meaning of a binding. Raises ValueError with the existing ones."""
        binding = BINDINGS.get(name)
        if binding is None or binding.name not in self.available_bindings():
            have = ", ".join(self.available_bindings())
            raise ValueError(f"no binding {name!r} on the motion {self.name!r}; it has {have}")
        return binding

    def jet(self, binding: str, order: int, sample: float) -> np.ndarray:
        """Returns the quantity and its time derivatives at the time ``sample``, shape (order + 1, *its
        shape)."""
        return self._jet(binding, order, float(sample))[0]

    def errors(self, binding: str, order: int, sample: float) -> np.ndarray:
        """Returns the error bound estimated for the entries of each of `jet`'s derivatives, shape (order +
        1,)."""
        return self._jet(binding, order, float(sample))[1]

    def _jet(self, name: str, order: int, sample: float) -> tuple[np.ndarray, np.ndarray]:
        binding = self.binding(name)
        if order < 0:
            raise ValueError(f"the order of a jet is 0, 1, 2 ..., got {order}")
        known = self._jets.get((binding.name, sample))
        if known is None or len(known[1]) <= order:
            known = self._jets[binding.name, sample] = self._differentiated(binding, max(order, 4), sample)
        return known[0][: order + 1], known[1][: order + 1]

    def _differentiated(self, binding: Binding, order: int, sample: float) -> tuple[np.ndarray, np.ndarray]:
        widths = self._widths(sample)
        found = chebyshev.derivatives(
            lambda s: np.ravel(self._at(sample + s)[binding.name]), widths, highest=order
        )
        values = [self._at(sample)[binding.name], *(d.value.reshape(binding.shape) for d in found)]
        rounding = [self._rounding(sample, binding.weight + k) for k in range(order + 1)]
        errors = np.array([0.0, *(d.error for d in found)]) + rounding
        return np.array(values), errors

    def _evaluated(self, t: float) -> dict[str, np.ndarray]:
        quantities = self._quantities(self._posture.at(t))
        return {name: np.asarray(value, dtype=float) for name, value in quantities.items()}


def _body(posture: Posture, body: str = "B") -> Quantities:
    return body_quantities(posture.pose(body), posture.velocity(body), posture.acceleration(body))


def _with_intermediate(posture: Posture) -> Quantities:
    return {
        **_body(posture),
        **six_coordinates(posture.plant, posture.context, posture.frame("B"), posture.v),
        **relative_quantities(
            posture.pose("A"),
            posture.velocity("A"),
            posture.pose("B", "A"),
            posture.velocity("B", "A", "A"),
            posture.pose("B"),
            posture.velocity("B", "A"),
        ),
        **turn_quantities(posture.pose("B")),
    }


def _three_cylinders(axes: Sequence[CylindricalAxis], posture: Posture) -> Quantities:
    axis2, axis3 = posture.pose("B_axis_on_parent"), posture.pose("C_axis_on_parent")
    u3_W = posture.pose("B").rotation() @ np.array(axes[2].direction)
    return {
        **_with_intermediate(posture),
        **cylinder_quantities(posture.q, axes, posture.pose("A"), axis2.translation()),
        **third_body_quantities(
            posture.q,
            posture.pose("C"),
            posture.pose("C", "B"),
            posture.velocity("C"),
            posture.velocity("C", "B", "B"),
            posture.velocity("C", "B"),
            u3_W,
            axis3.translation(),
        ),
    }


def three_cylinders_motion(seed: int) -> SampledMotion:
    """Returns a 3C chain: bodies A on W, B on A and C on B, on cylindrical joints; q = (d₁, θ₁, …, d₃,
    θ₃)."""
    axes = small_axes(seed, 3)
    plant = cylindrical_chain(axes, ("A", "B", "C"))
    path = small_path(seed, joints=6)
    name = f"three cylindrical joints, seed {seed}"
    return SampledMotion(name, plant, path, partial(_three_cylinders, axes))


def six_revolute_arm() -> MultibodyPlant:
    """Returns a 6R arm without parallel or intersecting axes; its third link is A and its last one B."""
    plant = MultibodyPlant(0.0)
    parent = plant.world_body()
    first, second = small_axes(5, 3), small_axes(6, 3)
    for number, axis in enumerate((*first, *second), start=1):
        name = {3: "A", 6: "B"}.get(number, f"link{number}")
        inertia = SpatialInertia.SolidSphereWithMass(1.0, 0.1)
        body = plant.AddRigidBody(name, inertia)
        offset = RigidTransform(np.add(axis.point, (0.25, 0.5, 0.75)))
        on_parent = plant.AddFrame(FixedOffsetFrame(f"{name}_axis", parent.body_frame(), offset))
        plant.AddJoint(RevoluteJoint(f"q{number}", on_parent, body.body_frame(), np.array(axis.direction)))
        parent = body
    plant.Finalize()
    return plant


def six_revolute_motion(
    seed: int, samples: Sequence[float] = SAMPLES, turns: Sequence[float] = TURNS
) -> SampledMotion:
    """Returns the 6R arm on a general path; q = (θ₁, …, θ₆)."""
    path = small_path(seed, joints=6)
    name = f"6R arm, seed {seed}"
    return SampledMotion(name, six_revolute_arm(), path, _with_intermediate, samples=samples, turns=turns)


@lru_cache(maxsize=8)
def urdf_motion(urdf: Path, body: str) -> SampledMotion:
    """Returns a body of a URDF file on a general path. Raises PlantError for the file, the body, or its
    joints."""
    plant = load_urdf(urdf)
    body_named(plant, body)
    path = small_path(7, joints=plant.num_positions())
    return SampledMotion(f"{body} of {urdf.name}", plant, path, partial(_body, body=body), body)


@lru_cache(maxsize=1)
def sampled_motions() -> tuple[SampledMotion, ...]:
    """Returns the general motions of longer chains."""
    return three_cylinders_motion(8), six_revolute_motion(9)
