"""A robot: bodies on a tree of joints, built once; its motions to any order, in NumPy arrays.

Every array has the order axis first, then the states, then what belongs to one state:
q_derivatives[k, ..., i] is the k-th time derivative of coordinate i. Units: rad, m, s.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.drake.urdf import base_joint_name
from workbench.kinematics.one_state import require_order
from workbench.kinematics.robot.dynamics import NO_INERTIAS, Inertia
from workbench.kinematics.robot.evaluator import Evaluator, evaluator_of
from workbench.kinematics.robot.inverse import DampedInverse, Task, damped_inverse, inverse_kinematics
from workbench.kinematics.robot.joints import Mimic, TreeJoint
from workbench.kinematics.robot.motion import Motion
from workbench.kinematics.robot.robot_urdf import WORLD, UrdfError, read_urdf
from workbench.kinematics.robot.scalars import autodiff_motion, casadi_function, jax_function, object_motion
from workbench.kinematics.robot.states import states_on_path
from workbench.kinematics.robot.structure import MOST_ROWS, Structure, reals, whole
from workbench.kinematics.robot.trajectories.paths import Path as JointPath
from workbench.kinematics.robot.trajectories.paths import as_path, read_samples
from workbench.kinematics.trees.tree_steps import HIGHEST_DERIVATIVE_ORDER

if TYPE_CHECKING:
    from workbench.drake.gate import MultibodyPlant
    from workbench.drake.mjcf import Mjcf

BLOCK = 4096  # states that are worked on at a time, where a batch is streamed


class Robot(Structure):
    """A robot with named joints and bodies; make it by `from_urdf`, `from_plant`, or of `TreeJoint` objects.

    name; bodies, positions, velocities: names, in the order of every array; limits: by joint. The world is
    the body "world". inertias: of the bodies, for `Motion.torques`; where there are none `no_inertias` says
    why.
    """

    inertias: Mapping[str, Inertia] = MappingProxyType({})
    no_inertias: str = NO_INERTIAS

    @classmethod
    def from_urdf(cls, path: str | Path, base: str = "fixed", rotations: str = "quaternion") -> Robot:
        """Returns the robot of a URDF file; its meshes are not needed.

        base: how its root moves in the world: "fixed" or "floating", by a joint `base` (`floating_base` where
        the file has a joint of that name). rotations: how this
        and the file's own floating joints are turned: "quaternion" or "rpy" (roll, pitch, yaw).
        Raises UrdfError, a ValueError, in one line.
        """
        if base not in ("fixed", "floating") or rotations not in ("quaternion", "rpy"):
            expected = "fixed or floating, rotations quaternion or rpy"
            raise ValueError(f"base: expected {expected}, got {base!r} and {rotations!r}")
        floating = {"floating": "floating" if rotations == "quaternion" else "floating_rpy"}
        urdf = read_urdf(path)
        name = base_joint_name(joint.name for joint in urdf.joints)
        root = [TreeJoint(name, floating.get(base, base), WORLD, urdf.root)]
        if urdf.root == WORLD:  # the file's own name for what does not move
            if base != "fixed":
                raise ValueError(f"{path}: its root is the world itself, so its base cannot be {base}")
            root = []
        try:
            joints = [replace(j, kind=floating.get(j.kind, j.kind)) for j in urdf.joints]
            robot = cls(urdf.name, [*root, *joints])
        except ValueError as error:
            raise UrdfError(f"{path}: {error}") from None
        robot.inertias, robot.no_inertias = urdf.inertias, f"{path}: {urdf.no_inertias}"
        return robot

    @classmethod
    def from_plant(cls, plant: MultibodyPlant, mimics: Mapping[str, Mimic] | None = None) -> Robot:
        """Returns the robot of a finalized Drake plant; its coordinates and velocities are the plant's, in
        its order.

        mimics: joints that follow others (a plant does not tell). The armature of an MJCF joint without an
        actuator is not in a plant: see `from_file`. Raises ValueError.
        """
        return cls._of_plant(plant, "plant", mimics)

    @classmethod
    def _of_plant(
        cls, plant: MultibodyPlant, name: str, mimics: Mapping[str, Mimic] | None, mjcf: Mjcf | None = None
    ) -> Robot:
        from workbench.kinematics.robot.plant import inertias, plant_armatures, tree_joints

        why, armatures = "", {}
        try:
            armatures = plant_armatures(plant, mjcf)
        except ValueError as error:
            why = f"{name}: {error}"
        robot = cls(name, tree_joints(plant, mimics or {}, armatures))
        if why:  # kinematics needs no armatures
            robot.no_inertias = why
        else:
            robot.inertias = inertias(plant)
        return robot

    @classmethod
    def from_file(
        cls,
        path: str | Path,
        base: str = "fixed",
        packages: Mapping[str, str | Path] | None = None,
        mimics: Mapping[str, Mimic] | None = None,
    ) -> Robot:
        """Returns the robot of an SDF, MJCF, URDF or model-directives file, all models of it, by Drake's
        parser.

        base: "fixed" welds the root of each model that nothing holds to the world, "floating" lets it move.
        packages: folders by the names that package:// paths start with. mimics: the joints that follow
        others; else these move freely, as in Drake, also where the file says otherwise (`from_urdf` follows
        the file). A body that several models have is model::body. A file with an inertia that no body can
        have, which Drake would replace, or with masses or armatures that it does not read, gives a robot
        without inertias. Raises ValueError in one line.
        """
        if base not in ("fixed", "floating"):
            raise ValueError(f"base: expected fixed or floating, got {base!r}")
        from workbench.drake.plants import PlantError, load_models

        try:
            models = load_models(path, base, packages)
            robot = cls._of_plant(models.plant, Path(path).stem, mimics, models.mjcf)
        except PlantError as error:
            raise ValueError(str(error)) from None
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from None
        if models.unweighed:
            robot.inertias, robot.no_inertias = MappingProxyType({}), models.unweighed
        return robot

    def motion(
        self, q_derivatives: ArrayLike, v_derivatives: ArrayLike | None = None, order: int | None = None
    ) -> Motion:
        """Returns the motion of all bodies to the order N, at one state or at many.

        q_derivatives (N + 1, ..., positions): the coordinates and their time derivatives, the order first; or
        q_derivatives (..., positions) and v_derivatives (N, ..., velocities): the coordinates, and the
        velocities with their derivatives; they are copied. order: N; where it is given another number of
        rows is refused, so that a table (states, positions) cannot be taken for derivatives. Without it a
        table is taken for the derivatives of one state, with a warning the first time, and more than 21
        rows are refused. Raises ValueError for another shape, and a NaN or infinity.
        """
        if v_derivatives is None:
            return Motion(self, self.derivatives(q_derivatives, order))
        motion = Motion(self, *self.state(q_derivatives, v_derivatives))
        if order not in (None, motion.order):
            raise ValueError(f"order: expected that of v_derivatives, {motion.order}, got {order!r}")
        return motion

    def evaluator(self, frame: str, order: int, jacobians: int = 0) -> Evaluator:
        """Returns a call for a control loop: reads its array `q` and writes its `pose`, `twists` and
        `jacobians`.

        order: N, the highest derivative of the coordinates. jacobians: of how many orders the Jacobian is
        computed, too, N + 1 at most. The call checks nothing and makes no new array; see `Evaluator`.
        Raises ValueError for an unknown frame or another order, and for a robot with ball or floating joints.
        """
        order = whole(order, "order", 1, HIGHEST_DERIVATIVE_ORDER)
        jacobians = whole(jacobians, "jacobians", 0, order + 1)
        self.require_rates("evaluator")
        plan = self.engine.plan(self.body(frame).name, order, jacobians)
        return evaluator_of(plan, order, len(self.positions), jacobians)

    def on_objects(
        self, frame: str, q_derivatives: ArrayLike, order: int | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Returns the pose (4, 4) and the twists (N, 6) of a frame as arrays of objects.

        q_derivatives (N + 1, positions): one state of Drake's Expression or AutoDiffXd, or SymPy's symbols.

        Twists are V_WF = (ω; velocity of Fo) and its derivatives, in W's axes. The gradients of
        AutoDiffXd are the partial derivatives in closed form, see `RobotFrame.twist_partial`. order: N, as
        of `motion`. Raises ValueError for another shape, an unknown frame, gradients of several sizes, and
        a robot with ball or floating joints."""
        q = np.asarray(q_derivatives, dtype=object)
        if q.ndim != 2 or q.shape[1] != len(self.positions) or len(q) < 2:
            raise ValueError(
                f"q_derivatives: expected shape (N + 1, {len(self.positions)}) with N >= 1, got {q.shape}"
            )
        self.require_rates("this arithmetic")
        require_order(q, order, "one call for each", MOST_ROWS)
        if all(type(x).__name__.startswith("AutoDiff") for x in q.flat):
            return autodiff_motion(self, frame, q)
        return object_motion(self, frame, q)

    def casadi(self, frame: str, order: int) -> Any:
        """Returns a casadi.Function q (positions, N + 1) → pose (4, 4), twists (6, N) of a frame, N = order.

        A column is an order. Raises ImportError without CasADi, ValueError as `on_objects`.
        """
        return casadi_function(self, frame, whole(order, "order", 1))

    def jax(self, frame: str, order: int) -> Any:
        """Returns a function of JAX arrays q (N + 1, positions) → pose (4, 4), twists (N, 6) of a frame, N
        = order; for jax.jit, jax.vmap (batches) and jax.jacfwd. Raises ImportError without JAX, ValueError
        as `on_objects`."""
        return jax_function(self, frame, whole(order, "order", 1))

    def to_c(self, frame: str, order: int) -> str:
        """Returns C code of a function frame_motion(arg, res, iw, w, mem), in CasADi's calling convention.

        arg[0]: q, the derivatives of all coordinates order by order, (N + 1) × positions. res[0]: the pose,
        16 numbers column by column. res[1]: the twists, N × 6. Raises ImportError without CasADi, ValueError
        as `on_objects`."""
        function = self.casadi(frame, order)
        import casadi

        generator = casadi.CodeGenerator("frame_motion")
        generator.add(function)
        return generator.dump()

    def with_frame(self, name: str, body: str, X_BF: ArrayLike) -> Robot:
        """Returns this robot with one more frame, of a tool: fixed to a body at X_BF (4, 4), m. Raises
        ValueError for a name that is there, an unknown body, or a transform that is not rigid."""
        if name in self.frames:
            raise ValueError(f"frame {name!r}: the robot has a body of that name, expected a new name")
        joint = TreeJoint(f"{name}_weld", "fixed", self.body(body).name, name, np.asarray(X_BF, dtype=float))
        robot = Robot(self.name, [*self.joints, joint], self.world)
        robot.inertias, robot.no_inertias = self.inertias, self.no_inertias
        return robot

    def along(
        self, trajectory: Any, times: ArrayLike | None = None, order: int = 4, samples: int = 201
    ) -> Motion:
        """Returns the motion along a trajectory at `times` (...) in s (`samples` of them over all of it
        unless given).

        trajectory: a `Path` of `workbench.kinematics.robot.trajectories.paths`, a Drake Trajectory, a SciPy
        spline or a trajectory of toppra or Ruckig of the positions, `spline_paths.waypoints`, or samples
        (t, q): t (samples,) increasing, in s, q (samples, positions) in rad or m, whose derivatives are
        estimated to the order 4 at most; or the name of a CSV file of samples, see `paths.read_samples`.
        Raises ValueError for a time outside of the trajectory."""
        path = self.path(trajectory)
        order = whole(order, "order", 1, HIGHEST_DERIVATIVE_ORDER)
        if times is None:
            if not np.isfinite([path.start, path.end]).all():
                raise ValueError("times: expected finite times in s, for a path without end")
            times = np.linspace(path.start, path.end, whole(samples, "samples", 1))
        at = np.array(reals(times, "times"))
        return states_on_path(Motion, self, path, at, order)

    def path(self, trajectory: Any) -> JointPath:
        """Returns the trajectory as a path of this robot's coordinates, as `along` takes it.

        Of samples, angles without limits are unwrapped and the signs of quaternions made continuous; the
        path's `notes` say where. Raises ValueError for another number of coordinates and for bad samples.
        """
        if isinstance(trajectory, str | Path):
            trajectory = read_samples(trajectory, self.positions, self.units)
        angles = [i for i, name in enumerate(self.positions) if name in self.unlimited_angles]
        return as_path(trajectory, self.positions, angles, self._quaternions)

    def from_degrees(self, values: ArrayLike, names: Sequence[str] | None = None) -> np.ndarray:
        """Returns a copy of values (..., positions) whose angles are in degrees, in radians: of coordinates,
        samples, waypoints or derivatives; metres and quaternions stay as they are.

        names: those of the last axis, `positions` unless given (`velocities` of rates). Raises ValueError."""
        names = self.positions if names is None else tuple(names)
        values = reals(values, "values")
        unknown = [name for name in names if name not in self.units]
        if unknown:
            raise ValueError(f"names: no coordinate or velocity {unknown[0]!r} of {self.name!r}")
        if values.ndim < 1 or values.shape[-1] != len(names):
            raise ValueError(f"values: expected shape (..., {len(names)}), got {values.shape}")
        return values * [np.pi / 180 if self.units[name] == "rad" else 1.0 for name in names]

    def blocks(
        self, q_derivatives: np.ndarray, v_derivatives: np.ndarray | None = None, size: int = BLOCK
    ) -> Iterator[Motion]:
        """Yields the motions of a large batch, block by block: q_derivatives (N + 1, states, positions).

        The memory is that of one block of `size` states, independent of the batch (which may be a np.memmap).
        """
        with_velocities = v_derivatives is not None
        axis = 0 if with_velocities else 1
        q_derivatives = np.asanyarray(q_derivatives)
        if q_derivatives.ndim < axis + 2:
            raise ValueError(f"expected a batch of states, got the shape {q_derivatives.shape}")
        size, states = whole(size, "size", 1), q_derivatives.shape[axis]
        for start in range(0, states, size):
            block = slice(start, start + size)
            if v_derivatives is not None:
                yield self.motion(q_derivatives[block], v_derivatives[:, block])
            else:
                yield self.motion(q_derivatives[:, block])

    def inverse(
        self,
        body: str,
        q: ArrayLike,
        twist_derivatives: ArrayLike,
        *,
        expressed: str = "mixed",
        point: ArrayLike = (0, 0, 0),
        rows: Sequence[int] = range(6),
        weight: ArrayLike | None = None,
        null_space: ArrayLike | None = None,
        relative_to: str | None = None,
        rtol: float = 1e-6,
    ) -> np.ndarray:
        """Returns the velocities and their derivatives (N, ..., velocities) that move a body as prescribed.

        q (..., positions); twist_derivatives (N, ..., len(rows)): those rows of (ω; v) and of its
        derivatives, as `FrameMotion.jacobian` with the same `expressed` and `point` has them. As many
        moving joints as rows: the solution. More: at each order the one of least Σ weightᵢ vᵢ² among those
        that fit, nearest to `null_space` (N, ..., velocities), 0 unless given; weight (velocities,) > 0, 1
        unless given. Raises SingularJacobian, with the singular values, where σ_min <= rtol · σ_max.
        """
        return inverse_kinematics(
            self,
            Task(body, expressed, point, tuple(np.atleast_1d(rows).tolist()), relative_to),
            q,
            twist_derivatives,
            weight=weight,
            null_space=null_space,
            rtol=rtol,
        )

    def inverse_damped(
        self,
        body: str,
        q: ArrayLike,
        twist_derivatives: ArrayLike,
        damping: float,
        *,
        expressed: str = "mixed",
        point: ArrayLike = (0, 0, 0),
        rows: Sequence[int] = range(6),
        weight: ArrayLike | None = None,
        null_space: ArrayLike | None = None,
        relative_to: str | None = None,
    ) -> DampedInverse:
        """As `inverse`, near and at singular positions, too: at each order the velocities of least |V − V
        wanted|² + damping² Σ weightᵢ (vᵢ − nullᵢ)², and what is missed.

        damping > 0, in the units of a singular value of the Jacobian (m, or 1 of rotations); damped least
        squares of Nakamura and Hanafusa (1986), order by order. Returns rates (N, ..., velocities) and
        residual (N, ..., len(rows)) = wanted − reached. Raises ValueError."""
        return damped_inverse(
            self,
            Task(body, expressed, point, tuple(np.atleast_1d(rows).tolist()), relative_to),
            q,
            twist_derivatives,
            damping=damping,
            weight=weight,
            null_space=null_space,
        )
