"""The limits for peaks: those of the robot, and others by joint or from a TOML file."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

from workbench.kinematics.robot.derivative_names import ORDERS
from workbench.kinematics.robot.structure import Structure

LimitTables = Mapping[str, Mapping[str, float]]
KINDS = (*ORDERS[1:], "deceleration")


class OfBody(NamedTuple):
    """The names of a body's point and rotation in limits and peaks."""

    point: str
    rotation: str


def of_body(robot: Structure) -> OfBody:
    """Returns "point" and "rotation"; where the robot has a joint of that name, "body point" or "body
    rotation"."""
    taken = {*robot.velocities, *robot.limits}
    return OfBody(*(f"body {name}" if name in taken else name for name in OfBody._fields))


def known_limits(robot: Structure, limits: LimitTables | None) -> dict[str, dict[str, float]]:
    """Returns all limits by the name of a joint, and of a body's point and rotation (`of_body`), which have
    none of their own: kind → value.

    limits: by joint, joints that follow others among them, "*" for all of the robot's velocities,
    "point", "rotation" ("body point", "body rotation" where a joint has that name): velocity,
    acceleration, deceleration, jerk, snap, lower, upper, in rad or m, per s, s², …; they replace the
    robot's own. Raises ValueError."""
    bodily = of_body(robot)
    known: dict[str, dict[str, float]] = {name: {} for name in robot.velocities}
    for name, own in robot.limits.items():
        known[name] = {kind: value for kind, value in own._asdict().items() if np.isfinite(value)}
    if not isinstance(limits, Mapping | None):
        raise ValueError(f"limits: expected tables by joint, got {limits!r}")
    for name, entries in (limits or {}).items():
        _require(name, entries, ("*", *bodily, *known), name in bodily)
    for name in robot.velocities:
        known[name].update((limits or {}).get("*", {}))
    for name in known:
        known[name].update((limits or {}).get(name, {}))
    return known | {name: dict((limits or {}).get(name, {})) for name in bodily}


def _require(name: str, entries: object, names: tuple[str, ...], bodily: bool) -> None:
    if name not in names:
        raise ValueError(f"limits: unknown joint {name!r}: expected one of {', '.join(names)}")
    if not isinstance(entries, Mapping):
        raise ValueError(f"limits of {name!r}: expected a table such as velocity = 1, got {entries!r}")
    for kind, value in entries.items():
        allowed = ORDERS[1:] if bodily else (*KINDS, "lower", "upper")
        if kind not in allowed:
            raise ValueError(f"limits of {name!r}: expected one of {', '.join(allowed)}, got {kind!r}")
        number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
        if not (number and np.isfinite(value)) or (kind in KINDS and value < 0):
            raise ValueError(f"limits of {name!r}: expected a finite number for {kind}, got {value!r}")


def read_limits(file: str | Path) -> dict[str, dict[str, float]]:
    """Returns limits from a TOML file. Raises ValueError.

    A table [NAME] is for a joint, ["*"] for all of them, [point] and [rotation] for the body. The keys are
    velocity, acceleration, jerk, snap (per s, s², ...), deceleration, lower, upper.
    """
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
