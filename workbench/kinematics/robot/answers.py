"""Answers out: the peaks of a motion along a path beside limits, and its table for a CSV file or a data
frame."""

from __future__ import annotations

import csv
import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    from workbench.kinematics.robot.frames import PointMotion
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


def point_of(motion: States, body: str, point: ArrayLike, relative_to: str | None) -> PointMotion:
    frame = motion.frame(body)
    return (frame if relative_to is None else frame.relative_to(motion.frame(relative_to))).point(point)


def peaks(
    motion: States, body: str | None, point: ArrayLike, limits: Limits | None, relative_to: str | None
) -> list[Peak]:
    """See `Motion.peaks`."""
    if motion.path is None:
        raise ValueError("expected a motion along a path (`Robot.along`), which has times between its states")
    asked = _asked(motion.robot, body, motion.order, known_limits(motion.robot, limits))

    def values_at(times: np.ndarray) -> np.ndarray:
        return _values(motion.at(times), body, point, relative_to, asked)

    start, end = motion.times.min(), motion.times.max()
    times = np.unique(
        np.concatenate(
            [np.linspace(start, end, SAMPLES), motion.times.ravel(), _around_breaks(motion.path, start, end)]
        )
    )
    values = values_at(times)
    at = np.argmax(values, axis=1)
    lows, highs = times[np.maximum(at - 1, 0)], times[np.minimum(at + 1, len(times) - 1)]
    best, best_time = values[np.arange(len(values)), at], times[at]
    for _ in range(2):  # each quantity in its own bracket
        inside = np.linspace(lows, highs, REFINED, axis=1)
        refined = values_at(inside)
        rows = np.arange(len(refined))
        own = refined[rows, rows]
        at = np.argmax(own, axis=1)
        better = own[rows, at] > best
        best, best_time = np.where(better, own[rows, at], best), np.where(better, inside[rows, at], best_time)
        lows, highs = inside[rows, np.maximum(at - 1, 0)], inside[rows, np.minimum(at + 1, REFINED - 1)]
    return [
        replace(peak, value=float(-value if peak.bound == "lower" else value) + 0.0, time=float(time))
        for peak, value, time in zip(asked, best, best_time, strict=True)
    ]


def _asked(robot, body: str | None, order: int, known: dict[str, dict[str, float]]) -> list[Peak]:
    """What is sought: of each joint derivative, of those of the point, of each coordinate with a limit."""
    units = {name: j.unit(name) for j in robot.joints for name in (*j.coordinates, *j.velocities)}
    per = {n: "/s" if n == 1 else f"/s^{n}" for n in range(1, order + 1)}
    sizes = [(name, n, units[name] + per[n]) for n in per for name in robot.velocities]
    sizes += [("point", n, "m" + per[n]) for n in per if body is not None]
    return [
        Peak(of, n, np.nan, np.nan, known.get(of, {}).get(order_name(n)), unit) for of, n, unit in sizes
    ] + [
        Peak(name, 0, np.nan, np.nan, known[name][bound], units[name], bound)
        for name in robot.positions
        for bound in ("lower", "upper")
        if bound in known.get(name, {})
    ]


def _values(motion: States, body, point, relative_to, asked: list[Peak]) -> np.ndarray:
    """(asked, ...): what is largest where the peaks are."""
    values = list(np.abs(np.moveaxis(motion.rates, -1, 1)).reshape(-1, *motion.shape))
    if body is not None:
        derivatives = point_of(motion, body, point, relative_to).derivatives
        values += list(np.linalg.norm(derivatives[1:], axis=-1))
    for peak in asked[len(values) :]:
        q = motion.q[..., motion.robot.positions.index(peak.of)]
        values.append(-q if peak.bound == "lower" else q)
    return np.array(values)


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


def table(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None
) -> dict[str, np.ndarray]:
    """See `Motion.table`: the columns by name, each (states,)."""
    if len(motion.shape) != 1:
        raise ValueError(f"expected a motion at a row of states, got the shape {motion.shape}")
    columns = {} if motion.times is None else {"t": motion.times}
    columns |= {name: motion.q[:, i] for i, name in enumerate(motion.robot.positions)}
    for k, rates in enumerate(motion.rates, start=1):
        columns |= {f"{order_name(k)} {name}": rates[:, i] for i, name in enumerate(motion.robot.velocities)}
    if body is not None:
        for n, values in enumerate(point_of(motion, body, point, relative_to).derivatives):
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
