"""The table of a motion along a path, for a CSV file or a data frame."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.derivative_names import order_name
from workbench.kinematics.robot.peaks import point_of

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States


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
