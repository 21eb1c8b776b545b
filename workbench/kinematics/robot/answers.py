"""Answers out: the peaks of a motion along a path beside limits, and its table for a CSV file or a data
frame."""

from __future__ import annotations

import csv
import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States

ORDERS = ("position", "velocity", "acceleration", "jerk", "snap")
SAMPLES = 401
REFINED = 33  # points that a bracket of two samples is refined with, twice

Limits = Mapping[str, Mapping[str, float]]


def order_name(n: int) -> str:
    return ORDERS[n] if n < len(ORDERS) else f"derivative {n}"


@dataclass(frozen=True)
class Peak:
    """Where a quantity is largest on a path. `of`: a coordinate or "point"; order: which derivative.

    value: the largest |derivative|, time in s; limit: None where there is none. Of order 0 `bound` is "lower"
    or "upper", and value is the coordinate at its least or greatest.
    """

    of: str
    order: int
    value: float
    time: float
    limit: float | None
    unit: str
    bound: str = "upper"

    @property
    def within(self) -> bool | None:
        if self.limit is None:
            return None
        return self.value <= self.limit if self.bound == "upper" else self.value >= self.limit

    def __str__(self) -> str:
        verdict = "within" if self.within else "BEYOND"
        against = "" if self.limit is None else f", {self.bound} limit {self.limit:g}: {verdict}"
        value = f"{self.value:.6g} {self.unit} at {self.time:.6g} s"
        return f"{order_name(self.order)} of {self.of}: {value}{against}"


def peaks(motion: States, body: str | None, point: ArrayLike, limits: Limits | None) -> list[Peak]:
    """See `Motion.peaks`."""
    if motion.path is None:
        raise ValueError("expected a motion along a path (`Robot.along`), which has times between its states")
    robot, path, order = motion.robot, motion.path, motion.order
    known = known_limits(robot, limits)
    start, end = motion.times.min(), motion.times.max()
    times = np.unique(
        np.concatenate(
            [np.linspace(start, end, SAMPLES), motion.times.ravel(), _around_breaks(path, start, end)]
        )
    )
    values = _sizes(motion.at(times), body, point)
    at = np.argmax(values, axis=1)
    lows, highs = times[np.maximum(at - 1, 0)], times[np.minimum(at + 1, len(times) - 1)]
    best, best_time = values[np.arange(len(values)), at], times[at]
    for _ in range(2):  # each quantity in its own bracket
        inside = np.linspace(lows, highs, REFINED, axis=1)
        refined = _sizes(motion.at(inside), body, point)
        rows = np.arange(len(refined))
        own = refined[rows, rows]
        at = np.argmax(own, axis=1)
        better = own[rows, at] > best
        best, best_time = np.where(better, own[rows, at], best), np.where(better, inside[rows, at], best_time)
        lows, highs = inside[rows, np.maximum(at - 1, 0)], inside[rows, np.minimum(at + 1, REFINED - 1)]
    found = []
    names = _quantities(robot, body, order)
    for (of, n, unit), value, time in zip(names, best, best_time, strict=True):
        found.append(Peak(of, n, float(value), float(time), known.get(of, {}).get(order_name(n)), unit))
    return found + _positions(robot, path, times, known)


def _positions(robot, path, times, known) -> list[Peak]:
    """The coordinates beside their limits lower and upper."""
    found = []
    q = path.derivatives(times, 0)[0]
    for i, name in enumerate(robot.positions):
        for bound, pick in (("lower", np.argmin), ("upper", np.argmax)):
            limit = known.get(name, {}).get(bound)
            if limit is not None:
                at = pick(q[:, i])
                found.append(
                    Peak(name, 0, float(q[at, i]), float(times[at]), limit, _unit(robot, name), bound)
                )
    return found


def _quantities(robot, body: str | None, order: int) -> list[tuple[str, int, str]]:
    per = ["", "/s", *(f"/s^{n}" for n in range(2, order + 1))]
    velocities = [(name, _unit(robot, name)) for name in robot.velocities]
    of_joints = [(name, n, unit + per[n]) for n in range(1, order + 1) for name, unit in velocities]
    return of_joints + ([] if body is None else [("point", n, f"m{per[n]}") for n in range(1, order + 1)])


def _unit(robot, name: str) -> str:
    """Of a coordinate or velocity: m of a shift, rad of an angle, 1 of a quaternion's component."""
    if name.endswith("_qw"):
        return "1"
    shifts = {joint.name for joint in robot.joints if joint.kind == "prismatic"}
    suffixes = ("_x", "_y", "_z", "_vx", "_vy", "_vz", "_shift")
    return "m" if name in shifts or name.endswith(suffixes) else "rad"


def _sizes(motion: States, body: str | None, point: ArrayLike) -> np.ndarray:
    """(quantities, ...) in the order of `_quantities`."""
    sizes = list(np.abs(np.moveaxis(motion.rates, -1, 1)).reshape(-1, *motion.shape))
    if body is not None:
        sizes += list(np.linalg.norm(motion.frame(body).point(point).derivatives[1:], axis=-1))
    return np.array(sizes)


def _around_breaks(path: Any, start: float, end: float) -> np.ndarray:
    breaks = np.asarray(getattr(path, "breaks", ()), dtype=float)
    near = 1e-9 * max(1.0, abs(start), abs(end))
    around = np.concatenate([breaks - near, breaks, breaks + near])
    return around[(around >= start) & (around <= end)]


def known_limits(robot, limits: Limits | None) -> dict[str, dict[str, float]]:
    known: dict[str, dict[str, float]] = {}
    for name, own in robot.limits.items():
        entries = {"velocity": own.velocity, "lower": own.lower, "upper": own.upper}
        known[name] = {kind: value for kind, value in entries.items() if np.isfinite(value)}
    if not isinstance(limits, Mapping | None):
        raise ValueError(f"limits: expected tables by joint, got {limits!r}")
    for name, entries in (limits or {}).items():
        if name not in ("*", "point", *robot.velocities):
            expected = ", ".join(("*", "point", *robot.velocities))
            raise ValueError(f"limits: unknown joint {name!r}: expected one of {expected}")
        if not isinstance(entries, Mapping):
            raise ValueError(f"limits of {name!r}: expected a table such as velocity = 1, got {entries!r}")
        for kind, value in entries.items():
            allowed = (*ORDERS[1:], *(() if name == "point" else ("lower", "upper")))
            if kind not in allowed:
                raise ValueError(f"limits of {name!r}: expected one of {', '.join(allowed)}, got {kind!r}")
            number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
            if not (number and np.isfinite(value)) or (kind in ORDERS and value < 0):
                raise ValueError(f"limits of {name!r}: expected a finite number for {kind}, got {value!r}")
    for name in robot.velocities:
        known.setdefault(name, {}).update((limits or {}).get("*", {}))
        known[name].update((limits or {}).get(name, {}))
    known["point"] = dict((limits or {}).get("point", {}))
    return known


def read_limits(file: str | Path) -> dict[str, dict[str, float]]:
    """Limits from a TOML file: a table [NAME] for a joint, ["*"] for all of them, [point] for the point, with
    velocity, acceleration, jerk, snap (per s, s², ...), lower, upper. Raises ValueError."""
    try:
        data = tomllib.loads(Path(file).read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ValueError(f"{file}: cannot be read: {error}") from None
    for name, entries in data.items():
        if not isinstance(entries, dict):
            raise ValueError(
                f"{file}: expected tables like [{name}] with velocity, jerk, ..., got {name} = {entries!r}"
            )
    return data


def table(motion: States, body: str | None, point: ArrayLike) -> dict[str, np.ndarray]:
    """See `Motion.table`: the columns by name, each (states,)."""
    if len(motion.shape) != 1:
        raise ValueError(f"expected a motion at a row of states, got the shape {motion.shape}")
    columns = {} if motion.times is None else {"t": motion.times}
    columns |= {name: motion.q[:, i] for i, name in enumerate(motion.robot.positions)}
    for k, rates in enumerate(motion.rates, start=1):
        columns |= {f"{order_name(k)} {name}": rates[:, i] for i, name in enumerate(motion.robot.velocities)}
    if body is not None:
        for n, values in enumerate(motion.frame(body).point(point).derivatives):
            columns |= {f"{body} {order_name(n)} {axis}": values[:, i] for i, axis in enumerate("xyz")}
            if n:
                columns[f"{body} {order_name(n)} size"] = np.linalg.norm(values, axis=-1)
    return columns


def write_csv(columns: Mapping[str, np.ndarray], file: str | Path) -> None:
    """One row a state; the file appears when it is whole."""
    file = Path(file)
    draft = file.with_name(f".unfinished-{os.getpid()}-{file.name}")
    try:
        with open(draft, "w", newline="", encoding="utf-8") as text:
            writer = csv.writer(text)
            writer.writerow(columns)
            writer.writerows(zip(*(column.tolist() for column in columns.values()), strict=True))
        os.replace(draft, file)
    except OSError as error:
        raise ValueError(f"{file}: cannot be written: {error.strerror or error}") from None
    finally:
        draft.unlink(missing_ok=True)
