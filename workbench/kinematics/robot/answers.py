"""The table of a motion along a path, for a CSV file or a data frame."""

from __future__ import annotations

import csv
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.derivative_names import order_name, per_second
from workbench.kinematics.robot.peaks import point_of

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States


def table(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, with_units: bool = False
) -> dict[str, np.ndarray]:
    """See `Motion.table`: the columns by name, each (states,); with_units: as in "t (s)"."""
    if len(motion.shape) != 1:
        raise ValueError(f"expected a motion at a row of states, got the shape {motion.shape}")
    robot, columns, units = motion.robot, {}, []

    def add(name: str, unit: str, values: np.ndarray) -> None:
        columns[name] = values
        units.append(unit)

    if motion.times is not None:
        add("t", "s", motion.times)
    for i, name in enumerate(robot.positions):
        add(name, robot.units[name], motion.q[:, i])
    for k, rates in enumerate(motion.rates, start=1):
        for i, name in enumerate(robot.velocities):
            add(f"{order_name(k)} {name}", robot.units[name] + per_second(k), rates[:, i])
    if body is not None:
        for n, values in enumerate(point_of(motion, body, point, relative_to).derivatives):
            for i, axis in enumerate("xyz"):
                add(f"{body} {order_name(n)} {axis}", "m" + per_second(n), values[:, i])
            if n:
                add(f"{body} {order_name(n)} size", "m" + per_second(n), np.linalg.norm(values, axis=-1))
    if not with_units:
        return columns
    return {
        name if unit == "1" else f"{name} ({unit})": values
        for (name, values), unit in zip(columns.items(), units, strict=True)
    }


def write_csv(columns: Mapping[str, np.ndarray], file: str | Path) -> None:
    """Writes one row for each state; the file appears when it is complete."""
    with draft_of(Path(file)) as draft, open(draft, "w", newline="", encoding="utf-8") as text:
        writer = csv.writer(text)
        writer.writerow(columns)
        writer.writerows(zip(*(column.tolist() for column in columns.values()), strict=True))


@contextmanager
def draft_of(file: Path) -> Iterator[Path]:
    """Yields the path of a draft, which becomes the file at the end. Raises ValueError."""
    draft = file.with_name(f".unfinished-{os.getpid()}-{file.name}")
    try:
        yield draft
        os.replace(draft, file)
    except OSError as error:
        raise ValueError(f"{file}: cannot be written: {error.strerror or error}") from None
    finally:
        draft.unlink(missing_ok=True)
