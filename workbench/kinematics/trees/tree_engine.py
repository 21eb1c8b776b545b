"""Evaluates a tree of joints by the compiled kernel, which is loaded at the first computation.

Loading takes some tenths of a second. The first time on a machine the kernel is compiled, which takes some
seconds, and stored on disk.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy import empty

from workbench.kinematics.spare_memory import spare_memory
from workbench.kinematics.trees.tree_steps import Frame, Step, Wanted

if TYPE_CHECKING:
    from workbench.kinematics.trees.tree_plan import Plan


class TreeEngine:
    """Poses, twist derivatives and Jacobian derivatives of frames on a tree of steps.

    frames: by name. channels: how many input channels the steps' drives read; velocities: how many columns
    the Jacobians have."""

    def __init__(
        self,
        steps: Sequence[Step],
        frames: Mapping[str, Frame],
        channels: int,
        velocities: int,
    ):
        self._steps, self._frames = tuple(steps), frames
        self._channels, self._velocities = channels, velocities
        self._plans: dict[tuple[object, ...], Plan] = {}

    def plan(self, names: str | tuple[str, ...], order: int, jacobians: int = 0, turning: int = 0) -> Plan:
        """Returns the plan for one frame or more, inputs with `order` derivatives, and so many orders of
        Jacobians and of their turning parts."""
        key = names, order, jacobians, turning
        if key not in self._plans:
            self._plans[key] = self._new_plan(names, Wanted(order, jacobians, turning))
        return self._plans[key]

    def of_one_state(self, q: np.ndarray, name: str, order: int, jacobians: int = 0) -> np.ndarray:
        """Returns the pose's 16 numbers, the twists (6 order) and so many orders of Jacobians of a frame at
        one state q (order + 1, channels), in one row."""
        plan = self._plans.get((name, order, jacobians, 0)) or self.plan(name, order, jacobians)
        record = empty(plan.rows)
        out = record[None, None, None]
        if not plan.kernel(q[:, None], plan.address, out, False):
            compute(q[:, None], plan, out)
        record.setflags(write=False)
        return record

    def _new_plan(self, names: str | tuple[str, ...], wanted: Wanted) -> Plan:
        from workbench.kinematics.trees.tree_plan import plan_of

        frames = [self._frames[name] for name in ((names,) if isinstance(names, str) else names)]
        return plan_of(self._steps, frames, self._channels, self._velocities, wanted)

    def __getstate__(self) -> dict[str, Any]:
        return vars(self) | {"_plans": {}}  # plans hold addresses of this process


def compute(q: np.ndarray, plan: Plan, out: np.ndarray) -> None:
    """Run a plan: q (order + 1, states, channels) → out (frames, states, orders, parts), both of doubles.

    The numbers of a frame and a state are `plan.rows`: the pose's 16, the twists, the Jacobians. They are
    spread over the last two axes in this order."""
    if not plan.kernel(q, plan.address, out, False):
        plan.kernel(q, plan.address, out, True)  # some angle is so large that only the C library reduces it


def states_side_by_side(frames: int, states: int, rows: int) -> np.ndarray:
    """Returns new memory (frames, states, rows) in which the states' numbers are adjacent, on whole cache
    lines."""
    from workbench.kinematics.simd_lanes import SIZE, WIDTH

    padded = -(-states // WIDTH) * WIDTH
    memory = spare_memory(frames * rows * padded + WIDTH)
    start = -memory.ctypes.data % SIZE // 8
    whole = memory[start : start + frames * rows * padded].reshape(frames, rows, padded)
    return whole[..., :states].swapaxes(1, 2)
