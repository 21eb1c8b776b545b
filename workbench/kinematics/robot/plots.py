"""Plot of a motion along a path: the derivatives of every joint and of a point, order by order, with
limits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.derivative_names import order_name
from workbench.kinematics.robot.joint_limits import LimitTables, known_limits, of_body
from workbench.kinematics.robot.peaks import point_of
from workbench.kinematics.robot.trajectories.path_peaks import peaks

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from workbench.kinematics.robot.states import States


def plot(
    motion: States, body: str | None, point: ArrayLike, limits: LimitTables | None, relative_to: str | None
) -> Figure:
    """See `Motion.plot`."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise ImportError("plotting needs matplotlib: pip install matplotlib") from None

    if motion.times is None or len(motion.shape) != 1:
        raise ValueError("expected a motion along a path at a row of times (`Robot.along`)")
    robot, times, order = motion.robot, motion.times, motion.order
    known = known_limits(robot, limits)
    found = peaks(motion, body, point, limits, relative_to)
    columns = 1 if body is None else 2
    figure = Figure(figsize=(5.2 * columns, 1.9 * order), layout="constrained")
    axes = figure.subplots(order, columns, sharex=True, squeeze=False)
    for n in range(1, order + 1):
        per = "s" if n == 1 else f"s$^{n}$"
        for i, name in enumerate(robot.velocities):
            (line,) = axes[n - 1, 0].plot(times, motion.rates[n - 1][:, i], lw=1, label=name)
            limit = known[name].get(order_name(n))
            _limit_lines(axes[n - 1, 0], (limit, -limit) if limit else (), line.get_color())
        axes[n - 1, 0].set_ylabel(f"{order_name(n)} (rad or m)/{per}")
        if body is not None:
            sizes = np.linalg.norm(point_of(motion, body, point, relative_to).derivative(n), axis=-1)
            axes[n - 1, 1].plot(times, sizes, lw=1.2, color="black")
            peak = next(p for p in found if p.of == of_body(robot).point and p.order == n)
            if np.isfinite(peak.value):
                axes[n - 1, 1].plot([peak.time], [peak.value], "o", ms=4, color="black")
            _limit_lines(axes[n - 1, 1], (peak.limit,) if peak.limit else (), "tab:red")
            axes[n - 1, 1].set_ylabel(f"|{order_name(n)}| m/{per}")
    if len(robot.velocities) <= 12:
        axes[0, 0].legend(fontsize=6, ncols=2)
    axes[0, 0].set_title(f"joints of {robot.name}", fontsize=9)
    if body is not None:
        beside = "" if relative_to is None else f" relative to {relative_to}"
        axes[0, 1].set_title(f"point of {body}{beside}", fontsize=9)
    for axis in axes[-1]:
        axis.set_xlabel("t (s)")
    return figure


def _limit_lines(axis: Any, values: tuple[float, ...], colour: str) -> None:
    """Draws limits, except those that would flatten the curves."""
    low, high = axis.get_ylim()
    reach = 3 * max(abs(low), abs(high))
    for value in values:
        if abs(value) <= reach:
            axis.axhline(value, ls="--", lw=0.8, color=colour)
