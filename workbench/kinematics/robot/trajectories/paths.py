"""Trajectories along which a robot can move.

`workbench.drake.joint_paths` has the paths by formula: `JointPath` (coefficients), `SinePath`. Here are those
by samples (`RecordedPath`, from arrays or a CSV file) and by Drake's Trajectory objects (`DrakePath`). Times
in s, coordinates in rad and m; derivatives have the order first, (order + 1, ..., joints).
"""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path as FilePath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.drake.joint_paths import JointPath, LinearPath, Path, SinePath
from workbench.kinematics.robot.derivative_names import order_name
from workbench.kinematics.robot.recording.recordings import HIGHEST_RECORDED_ORDER, LEAST_SAMPLES, record
from workbench.kinematics.robot.structure import reals
from workbench.kinematics.robot.trajectories.planner_paths import planner_path
from workbench.kinematics.robot.trajectories.sampled_path import SampledPath
from workbench.kinematics.robot.trajectories.spline_paths import SplinePath
from workbench.kinematics.robot.trajectories.trajectory_breaks import trajectory_breaks

__all__ = [
    "DrakePath",
    "JointPath",
    "LinearPath",
    "Path",
    "RecordedPath",
    "SinePath",
    "as_path",
    "read_samples",
]


class DrakePath(SampledPath):
    """A path of a `pydrake.trajectories.Trajectory` whose value is the vector of the robot's positions."""

    def __init__(self, trajectory: Any) -> None:
        """trajectory: of a vector of positions, with derivatives. Raises ValueError."""
        try:
            columns = trajectory.cols()
        except RuntimeError as error:
            raise ValueError(f"trajectory: {error}") from None
        if columns != 1:
            raise ValueError(f"trajectory: expected a vector of positions, got {columns} columns")
        if not trajectory.has_derivative():
            raise ValueError("trajectory: expected one that has derivatives")
        self.trajectory, self.joints = trajectory, trajectory.rows()
        self.start, self.end = trajectory.start_time(), trajectory.end_time()

    def derivatives(self, t: ArrayLike, order: int) -> np.ndarray:
        t = self._inside(t)
        trajectory = self.trajectory
        values = [trajectory.vector_values(t.ravel()).T.reshape(*t.shape, self.joints)]
        for k in range(1, order + 1):
            rows = [trajectory.EvalDerivative(float(s), k).ravel() for s in t.ravel()]
            values.append(np.reshape(rows, (*t.shape, self.joints)))
        return np.stack(values)

    @cached_property
    def breaks(self) -> np.ndarray:
        """The times in s at which derivatives may jump, increasing."""
        return trajectory_breaks(self.trajectory, self.derivatives)


class RecordedPath(SampledPath):
    """A path of samples: derivatives to the snap by local least-squares polynomials, with stated errors.

    times (samples,), samples (samples, joints): what was recorded, angles unwrapped; names: of the
    coordinates. recordings: one `Recording` a coordinate; noise (joints,): the standard deviation of each
    coordinate's samples; notes: what was changed in the samples before, one sentence each; breaks: times
    in s at which a derivative jumps."""

    def __init__(
        self,
        t: ArrayLike,
        q: ArrayLike,
        names: Sequence[str] | None = None,
        angles: Sequence[int] = (),
        quaternions: Sequence[int] = (),
    ) -> None:
        """t (samples,) increasing, in s; q (samples, joints) in rad or m.

        names: of the coordinates, for the notes. angles: columns of angles that are known modulo 2π, which
        are unwrapped. quaternions: the first of four columns each, whose sign is made continuous. Raises
        ValueError for bad samples.
        """
        t, q = _samples(t, q)
        names = [f"coordinate {i}" for i in range(q.shape[1])] if names is None else list(names)
        notes = [_unwrap(t, q, i, names[i]) for i in angles] + [
            _align_signs(t, q, i, names[i].removesuffix("_qw")) for i in quaternions
        ]
        self.start, self.end, self.joints = float(t[0]), float(t[-1]), q.shape[1]
        self.times, self.samples, self.names = t, q, tuple(names)
        self.recordings = tuple(record(t, np.ascontiguousarray(column)) for column in q.T)
        self.noise = np.array([recording.noise for recording in self.recordings])
        notes += [
            f"joint {name!r}: what counts as noise, {recording.noise:.2g}, is not noise: the motion may be "
            "faster than the samples show"
            for name, recording in zip(self.names, self.recordings, strict=True)
            if recording.is_undersampled
        ]
        self.notes = tuple(filter(None, notes))
        self.breaks = np.array(sorted({one.time for r in self.recordings for one in r.breaks}))

    def derivatives(self, t: ArrayLike, order: int) -> np.ndarray:
        """Returns q, …, q⁽ᵒʳᵈᵉʳ⁾ at the times t (...) in s, (order + 1, ..., joints). Raises ValueError
        for a time outside, and for an order beyond 4."""
        return self._estimates(t, order)[0]

    def error(self, t: ArrayLike, order: int) -> np.ndarray:
        """Returns the stated error of each derivative, (order + 1, ..., joints), infinite where nothing is
        known."""
        return self._estimates(t, order)[1]

    def estimate(self, order: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns (value, error), each (samples, joints), of the derivative of that order at the samples
        `times`."""
        pairs = [recording.estimate(order) for recording in self.recordings]
        values, errors = (np.stack([pair[i] for pair in pairs], axis=-1) for i in (0, 1))
        return values, errors

    def _estimates(self, t: ArrayLike, order: int) -> tuple[np.ndarray, np.ndarray]:
        t = self._inside(t)
        pairs = [recording.between(t, order) for recording in self.recordings]
        shape = (order + 1, *t.shape, 0)
        if not pairs:
            return np.zeros(shape), np.zeros(shape)
        values, errors = (np.stack([pair[i] for pair in pairs], axis=-1) for i in (0, 1))
        return values, errors

    def taylor(self, t: float, degree: int | None = None) -> JointPath:
        """Returns the polynomial of the derivatives to the snap at ``t``, its clock restarted there."""
        highest = HIGHEST_RECORDED_ORDER
        return super().taylor(t, highest if degree is None else min(degree, highest))


def _unwrap(t: np.ndarray, q: np.ndarray, column: int, name: str) -> str | None:
    """Adds multiples of 2π so that no two samples differ by more than π, in place; says how often."""
    turns = np.round(np.diff(q[:, column]) / (2 * np.pi))
    if not turns.any():
        return None
    q[1:, column] -= 2 * np.pi * np.cumsum(turns)
    at, most = np.flatnonzero(turns) + 1, int(np.abs(turns).max())
    size = "2 pi" if most == 1 else f"up to {most} times 2 pi"
    return f"joint {name!r}: unwrapped, it jumps by {size} at {_counted(t[at])}"


def _align_signs(t: np.ndarray, q: np.ndarray, column: int, name: str) -> str | None:
    """Makes the sign of a quaternion continuous, in place; says how often it was not: q and −q are one
    rotation."""
    four = q[:, column : column + 4]
    changes = (four[1:] * four[:-1]).sum(axis=1) < 0
    if not changes.any():
        return None
    four[1:] *= np.cumprod(np.where(changes, -1.0, 1.0))[:, None]
    return f"joint {name!r}: the quaternion changes its sign at {_counted(t[np.flatnonzero(changes) + 1])}"


def _counted(times: np.ndarray) -> str:
    count = "1 sample" if len(times) == 1 else f"{len(times)} samples"
    return f"{count}, first at {times[0]:.6g} s"


def _samples(t: ArrayLike, q: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Copies of the samples, checked."""
    t, q = np.array(reals(t, "t")), np.array(reals(q, "q"))
    if t.ndim != 1 or q.ndim != 2 or len(q) != len(t):
        raise ValueError(
            f"t and q: expected shapes (samples,) and (samples, joints), got {t.shape} and {q.shape}"
        )
    if len(t) < LEAST_SAMPLES:
        raise ValueError(f"t: expected at least {LEAST_SAMPLES} samples, got {len(t)}")
    if not (np.diff(t) > 0).all():
        first = int(np.flatnonzero(np.diff(t) <= 0)[0])
        raise ValueError(f"t: expected increasing times, got {t[first]:g} s before {t[first + 1]:g} s")
    return t, q


UNITS = {
    "s": ("s", 1.0),
    "ms": ("s", 1e-3),
    "rad": ("rad", 1.0),
    "deg": ("rad", np.pi / 180),
    "°": ("rad", np.pi / 180),
    "m": ("m", 1.0),
    "cm": ("m", 1e-2),
    "mm": ("m", 1e-3),
}
"""The units that a column's name may end with, and their sizes in s, rad or m."""


def read_samples(
    file: str | FilePath, positions: Sequence[str], units: Mapping[str, str] | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Returns (t, q) of a CSV file, t (samples,) in s, q (samples, positions) in rad or m.

    The file has a header `t` and names of coordinates, then a row a time; coordinates without a column stay
    at 0. A name may end with its unit in brackets, as "j1 (deg)"; units: of the coordinates, rad or m, which
    it must fit. Without a header the columns are t and then all the positions. Columns of derivatives and of
    a body's point, which `Motion.to_csv` adds, are not read. Raises ValueError with the line.
    """
    try:
        with open(file, newline="", encoding="utf-8-sig") as text:
            rows = [
                (number, row)
                for number, row in enumerate(csv.reader(text), start=1)
                if any(map(str.strip, row))
            ]
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"{file}: cannot be read: {error}") from None
    if not rows:
        raise ValueError(f"{file}: expected a CSV file with rows, got none")
    if _is_number(rows[0][1][0]):
        names, sizes = ["t", *positions], [1.0] * (1 + len(positions))
    else:
        expected = {"t": "s", "time": "s", **(units or {})}
        pairs = [_name_and_size(name.strip(), positions, expected, file) for name in rows[0][1]]
        names, sizes = [name for name, _ in pairs], [size for _, size in pairs]
        rows = rows[1:]
    if names[0] not in ("t", "time"):
        raise ValueError(f"{file}: expected the first column to be t, got {names[0]!r}")
    for name in names[1:]:
        if name not in positions and not _is_derived(name):
            raise ValueError(f"{file}: unknown joint {name!r}: expected one of {', '.join(positions)}")
        if names.count(name) > 1:
            raise ValueError(f"{file}: joint {name!r} is there twice: expected one column of each")
    for number, row in rows:
        if len(row) != len(names) or not all(map(_is_number, row)):
            raise ValueError(f"{file}, line {number}: expected {len(names)} numbers, got {','.join(row)!r}")
    table = np.array([[float(x) for x in row] for _, row in rows]).reshape(len(rows), len(names)) * sizes
    q = np.zeros((len(rows), len(positions)))
    for column, name in zip(table.T[1:], names[1:], strict=True):
        if name in positions:
            q[:, list(positions).index(name)] = column
    return table[:, 0], q


def _name_and_size(
    column: str, positions: Sequence[str], units: Mapping[str, str], file: str | FilePath
) -> tuple[str, float]:
    """Returns the name and the size of the unit of a column such as "j1 (deg)"."""
    found = None if column in positions else re.fullmatch(r"(.*\S)\s*[(\[]([^()\[\]]*)[)\]]", column)
    if found is None:
        return column, 1.0
    name, unit = found[1], found[2].strip()
    if name not in positions and name not in ("t", "time"):
        return (name if _is_derived(name) else column), 1.0
    kind, size = UNITS.get(unit, ("", 1.0))
    if kind != units.get(name, kind) or not kind:
        wanted = units.get(name, "")
        known = ", ".join(unit for unit, (kind, _) in UNITS.items() if wanted in ("", kind))
        raise ValueError(f"{file}: column {column!r}: expected one of the units {known}, got {unit!r}")
    return name, size


def _is_derived(name: str) -> bool:
    """True if a column is one that `Motion.table` computes: "jerk NAME", "BODY position x", "BODY jerk
    size"."""
    orders = [*map(order_name, range(5))]
    words = name.split(" ")
    if words[0] in orders[1:] or re.match(r"derivative \d+ ", name):
        return True
    of_point = re.search(r" (position|velocity|acceleration|jerk|snap|derivative \d+) (x|y|z|size)$", name)
    return of_point is not None


def _is_number(text: str) -> bool:
    try:
        return bool(np.isfinite(float(text)))
    except ValueError:
        return False


def as_path(
    trajectory: Any, names: Sequence[str], angles: Sequence[int] = (), quaternions: Sequence[int] = ()
) -> Path:
    """Returns a `Path`, a Drake Trajectory, a SciPy spline, a trajectory of toppra or Ruckig, or samples (t,
    q), as a path of the coordinates of those names.

    angles, quaternions: see `RecordedPath`. Raises ValueError.
    """
    if isinstance(trajectory, Path):
        path = trajectory
    elif hasattr(trajectory, "EvalDerivative"):
        path = DrakePath(trajectory)
    elif callable(trajectory) and hasattr(trajectory, "derivative"):
        path = SplinePath(trajectory)
    elif (planned := planner_path(trajectory)) is not None:
        path = planned
    elif isinstance(trajectory, tuple) and len(trajectory) == 2:
        t, q = trajectory
        _require_columns(np.shape(q)[-1] if np.ndim(q) == 2 else len(names), names)
        path = RecordedPath(t, q, names, angles, quaternions)
    else:
        raise ValueError(
            "trajectory: expected a Path, a Drake Trajectory, a SciPy spline, a trajectory of toppra or "
            f"Ruckig, or (t, q), got {type(trajectory).__name__}"
        )
    _require_columns(path.joints, names)
    return path


def _require_columns(count: int, names: Sequence[str]) -> None:
    if count != len(names):
        raise ValueError(f"trajectory: expected {len(names)} coordinates, got {count}")
