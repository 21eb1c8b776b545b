"""A robot's motion, and results along a path: peaks, tables, plots, MeshCat."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot import answers, meshcat_scene, plots
from workbench.kinematics.robot.dynamics import GRAVITY, torques
from workbench.kinematics.robot.joint_limits import LimitTables
from workbench.kinematics.robot.peaks import Peak, Violation
from workbench.kinematics.robot.states import States
from workbench.kinematics.robot.trajectories.path_peaks import peaks, violations
from workbench.kinematics.robot.trajectories.time_scaling import RetimedPath, Slowdown, retimed, slowdown

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Motion(States):
    """The motion that `Robot.motion` and `Robot.along` return: `frame(name)`, `frames`, and results along a
    path."""

    robot: Any  # a `Robot`, which makes motions

    def torques(self, order: int = 0, gravity: ArrayLike = GRAVITY) -> np.ndarray:
        """Returns the generalized forces τ that the motion needs and their derivatives to the `order`, (order
        + 1, ..., velocities): N or N m, per sᵏ, one for each velocity.

        Inverse dynamics by Newton, Euler and d'Alembert with the robot's `inertias` and `armatures`; gravity
        (3,) in m/s², in W's axes. Friction and springs are left out. Needs a motion of order + 2. Raises
        ValueError for a robot without inertias, or an order beyond the motion's.
        """
        return torques(self, self.robot.inertias, self.robot.no_inertias, order, gravity)

    def peaks(
        self,
        body: str | None = None,
        point: ArrayLike = (0, 0, 0),
        limits: LimitTables | None = None,
        relative_to: str | None = None,
    ) -> list[Peak]:
        """Returns the largest size of every joint derivative on the path, and of those of a point of a body
        and of the body's rotation (angular velocity, …), in rad or m, per s, s², …, with its time in s.

        point (3,): p_BoP_B in m; relative_to: the body in which it is measured. limits: by joint, joints
        that follow others among them, or "*" for all, or "point" or "rotation" ("body point", "body
        rotation" where a joint has that name): {"velocity": ..., "acceleration": ..., "deceleration":
        ..., "jerk": ..., "snap": ..., "lower": ..., "upper": ...}; they replace the robot's own. The
        times are those from the motion's first to its last, those between its states with them. A peak
        has no bound where a lower derivative jumps. Along samples it has a stated error, or is not
        determined. Raises ValueError for a motion along no path and for bad limits."""
        return peaks(self, body, point, limits, relative_to)

    def violations(
        self,
        body: str | None = None,
        point: ArrayLike = (0, 0, 0),
        limits: LimitTables | None = None,
        relative_to: str | None = None,
    ) -> list[Violation]:
        """Returns the stretches of time in which a limit is exceeded, in their order, with the arguments
        and errors of `peaks`: along samples those that are sure, the samples beyond by more than their
        errors."""
        return violations(self, body, point, limits, relative_to)

    def slowdown(
        self,
        body: str | None = None,
        point: ArrayLike = (0, 0, 0),
        limits: LimitTables | None = None,
        relative_to: str | None = None,
    ) -> Slowdown:
        """Returns the least factor by which to stretch the path's times so that all limits are kept, and the
        peak that asks for it: the largest of (peak/limit)^(1/order); below 1 the path can be faster.

        Arguments: as of `peaks`; see `time_scaling.slowed` for the path in these times. Along a recording
        the factor is enough for all sizes that the stated errors allow. Raises ValueError for a position
        beyond its limit, a peak without bound, a limit of a higher order than the motion's, and where
        nothing is limited."""
        return slowdown(self, body, point, limits, relative_to)

    def retimed(
        self,
        body: str | None = None,
        point: ArrayLike = (0, 0, 0),
        limits: LimitTables | None = None,
        relative_to: str | None = None,
    ) -> RetimedPath:
        """Returns the same path q(s) in other times q(s(t)), t from 0 s on, within all limits of velocity,
        acceleration, jerk and snap: slow where a limit asks for it, else faster; never longer than by the
        uniform `slowdown`. For `Robot.along`.

        Arguments and errors: as of `slowdown`; a recording is refused. The time law is near the fastest
        one of its kind, a spline with continuous derivatives to the order 5, not the time-optimal one.
        """
        return retimed(self, body, point, limits, relative_to)

    def table(
        self, body: str | None = None, point: ArrayLike = (0, 0, 0), relative_to: str | None = None
    ) -> dict[str, np.ndarray]:
        """Returns the columns t, coordinates, their derivatives, and those of a point of a body, each
        (states,)."""
        return answers.table(self, body, point, relative_to)

    def to_dataframe(
        self, body: str | None = None, point: ArrayLike = (0, 0, 0), relative_to: str | None = None
    ) -> Any:
        """Returns `table` as a pandas.DataFrame; ImportError where pandas is not installed."""
        try:
            import pandas
        except ImportError:
            raise ImportError("a data frame needs pandas: pip install pandas (or use `to_csv`)") from None
        return pandas.DataFrame(self.table(body, point, relative_to))

    def to_csv(
        self,
        file: str | Path,
        body: str | None = None,
        point: ArrayLike = (0, 0, 0),
        relative_to: str | None = None,
    ) -> None:
        """Writes `table` as a CSV file, with units in the column names, such as "velocity j1 (rad/s)".

        `along` reads the file. Raises ValueError if it cannot be written.
        """
        answers.write_csv(answers.table(self, body, point, relative_to, with_units=True), file)

    def plot(
        self,
        body: str | None = None,
        point: ArrayLike = (0, 0, 0),
        limits: LimitTables | None = None,
        relative_to: str | None = None,
    ) -> Figure:
        """Returns a matplotlib figure: each order of the joints' derivatives and of the point's, limits
        dashed."""
        return plots.plot(self, body, point, limits, relative_to)

    def show(
        self, meshcat: Any, body: str, point: ArrayLike = (0, 0, 0), orders: Sequence[int] = (1, 2, 3)
    ) -> None:
        """Animate the motion in a pydrake.geometry.Meshcat: the robot's skeleton, the point's path and its
        accelerations of the `orders`, the instantaneous screw axis and the acceleration centres, in
        motion."""
        meshcat_scene.show(self, meshcat, body, point, orders)
