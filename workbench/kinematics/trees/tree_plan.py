"""The plan of a pass over a tree of joints: its steps, its bodies, all constants and the workspace in one
array."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any

import numpy as np

from workbench.kinematics.compiled_kernels import BoundKernel, Kernel
from workbench.kinematics.simd_lanes import SIZE, WIDTH
from workbench.kinematics.trees.tree_arithmetic import ABOUT_X, GENERAL, IDENTITY
from workbench.kinematics.trees.tree_bodies import COLUMN, POSE
from workbench.kinematics.trees.tree_joints import BALL, SCREW, SLIDE, TURN
from workbench.kinematics.trees.tree_kernel import (
    BODY,
    HEAD,
    ORIGIN,
    STEP,
    TURNING,
    bound_tree_kernel,
    tree_kernel,
)
from workbench.kinematics.trees.tree_steps import WORLD, Frame, Step, Wanted

NEAR = 4096  # doubles of the first-level cache that alternating blocks may fill
EXACT = 1e-16  # the bound on rounding errors of a constant rotation


@dataclass(frozen=True, eq=False)
class Plan:
    """`memory`, whose address the kernel is given; `rows`: numbers of a body and a state in the result;
    `bound_kernel`: gives the kernel of a `BoundCall`."""

    memory: np.ndarray
    address: int
    rows: int
    kernel: Kernel
    bound_kernel: Callable[[], BoundKernel]


def plan_of(
    steps: Sequence[Step], frames: Sequence[Frame], channels: int, velocities: int, wanted: Wanted
) -> Plan:
    """Returns the plan of a pass for some frames of a tree with so many input channels and velocities."""
    return _Planner(steps, frames, channels, velocities, wanted).plan()


class _Planner:
    def __init__(
        self, steps: Sequence[Step], frames: Sequence[Frame], channels: int, velocities: int, wanted: Wanted
    ):
        self.steps, self.frames, self.wanted = steps, frames, wanted
        self.channels, self.velocities = channels, velocities
        self.order = self._steps_on_the_way()
        self.place = {at: i for i, at in enumerate(self.order)}
        # positions are reckoned from the first joint, which may be far from the world's origin
        self.origin = steps[0].before[:3, 3] if steps else np.zeros(3)
        self.after: dict[int, np.ndarray] = {WORLD: _transform(p=-self.origin)}
        self.axes_of: dict[int, int] = {}
        self._choose_slots()

    def _steps_on_the_way(self) -> list[int]:
        needed: set[int] = set()
        for frame in self.frames:
            at = frame.after
            while at != WORLD and at not in needed:
                needed.add(at)
                at = self.steps[at].parent
        return sorted(needed)

    def _choose_slots(self) -> None:
        """Chooses the slot of each step: with Jacobians its own, else one that no later step or body needs.

        Slot 0 is the world's.
        """
        last_use: dict[int, int] = {}
        for at in self.order:
            last_use[self.steps[at].parent] = at
        free: list[int] = []
        self.slot, self.slots = {WORLD: 0}, 1
        for at in self.order:
            if free and not self.wanted.jacobians:
                self.slot[at] = free.pop()
            else:
                self.slot[at], self.slots = self.slots, self.slots + 1
            parent = self.steps[at].parent
            if parent != WORLD and last_use[parent] == at:
                free.append(self.slot[parent])
            if at not in last_use:
                free.append(self.slot[at])

    def plan(self) -> Plan:
        N, J = self.wanted.order, self.wanted.jacobians
        columns, axes_size = N + 1, self._place_axes()
        rows = POSE + 6 * N + 6 * self.velocities * J + 3 * self.velocities * self.wanted.turning
        table = [self._step_row(at) for at in self.order]
        bodies, entries = self._body_rows()
        slot_size = 9 + 3 * columns + 3 * N
        of_W = self.channels * columns + self.slots * slot_size + 2 * len(table) + 2 * columns
        of_W += axes_size + 6 * columns
        block = WIDTH * (of_W + rows)
        together = max(1, min(4, NEAR // block))
        header = np.zeros(HEAD)
        header[:8] = (
            len(table), len(bodies), self.slots, together, J, self.velocities, axes_size, J > 0,
        )  # fmt: skip
        header[ORIGIN : ORIGIN + 3], header[TURNING] = self.origin, self.wanted.turning
        constants: list[Any] = [
            np.tile(self._input_factors(), self.channels),
            self._output_factors(),
            np.arange(float(columns), -1.0, -1.0),
            1 / np.arange(1.0, N + 2),
            *table,
            *bodies,
            *entries,
        ]
        head = HEAD + sum(len(part) for part in constants)
        memory = np.concatenate([header, *constants, np.zeros(block * together + WIDTH)])
        start = head + (-(memory.ctypes.data + 8 * head) % SIZE) // 8
        memory[8:10] = 8 * start, rows
        for block_start in range(start, start + block * together, block):
            memory[block_start + WIDTH * (of_W + 15) :][:WIDTH] = 1.0  # the pose's last row: 0 0 0 1
            world = block_start + WIDTH * self.channels * columns
            for i in range(3):
                memory[world + WIDTH * 4 * i :][:WIDTH] = 1.0
        return Plan(memory, memory.ctypes.data, rows, tree_kernel(), bound_tree_kernel)

    def _place_axes(self) -> int:
        """Places the series of each step's axis (three for a ball), and returns the space; with Jacobians
        each has its own."""
        columns, at = 3 * (self.wanted.order + 1), 0
        for step in self.order:
            self.axes_of[step] = at if self.wanted.jacobians else 0
            at += columns * (3 if self.steps[step].joint is None else 1)
        return at if self.wanted.jacobians else 3 * columns

    def _input_factors(self) -> list[float]:
        """Returns the factors from a channel's derivatives (or coefficients) to its value and its rate's
        coefficients."""
        N = self.wanted.order
        return [1.0, *(1.0 / factorial(k) for k in range(N))]

    def _output_factors(self) -> list[float]:
        return [_factorial(k) for k in range(self.wanted.order + 1)]

    def _step_row(self, at: int) -> np.ndarray:
        step, row = self.steps[at], np.zeros(STEP)
        A, point, kind = np.eye(3), np.zeros(3), BALL
        if step.joint is not None:
            A, point = _aligned(step.joint.axis), step.joint.point if step.turn else np.zeros(3)
            kind = SCREW if step.turn and step.slide else TURN if step.turn else SLIDE
        before = self.after[step.parent] @ step.before @ _transform(p=point) @ _transform(A)
        self.after[at] = _transform(A.T) @ _transform(p=-point)
        row[:4] = kind, self.slot[step.parent], self.slot[at], _turn(before[:3, :3])
        for start, drive in ((4, step.turn), (7, step.slide)):
            if drive is not None:
                row[start : start + 3] = drive.channel, drive.factor, drive.offset
        row[10:13], row[13:22] = before[:3, 3], before[:3, :3].T.ravel()
        row[22], row[23] = before[:3, 3].any(), self.axes_of[at]
        return row

    def _body_rows(self) -> tuple[list[np.ndarray], list[np.ndarray]]:
        bodies: list[np.ndarray] = []
        entries: list[np.ndarray] = []
        in_order = sorted(enumerate(self.frames), key=lambda pair: self.place.get(pair[1].after, -1))
        for out, frame in in_order:
            X = self.after[frame.after] @ frame.X_MB
            columns = self._columns(frame.after) if self.wanted.jacobians else []
            row = np.zeros(BODY)
            row[:3] = self.place.get(frame.after, -1), _turn(X[:3, :3]), out
            row[3:6], row[6:15] = X[:3, 3], X[:3, :3].T.ravel()
            row[15:18] = self.slot[frame.after], len(entries), len(columns)
            row[18] = X[:3, 3].any()
            bodies.append(row)
            entries += columns
        return bodies, entries

    def _columns(self, at: int) -> list[np.ndarray]:
        """Returns the columns of the Jacobian of what follows a step: whether it slides, where its axis
        and the origin on it are, its velocity and its factor."""
        found = []
        while at != WORLD:
            step = self.steps[at]
            for slides, drive in ((0, step.turn), (1, step.slide)):
                if drive is None:
                    continue
                for axis in range(1 if step.joint is not None else 3):
                    where = self.axes_of[at] + 3 * (self.wanted.order + 1) * axis
                    row = np.zeros(COLUMN)
                    row[:5] = slides, where, self.slot[at], drive.velocity + axis, drive.factor
                    found.append(row)
            at = step.parent
        return found


def _factorial(k: int) -> float:
    try:
        return float(factorial(k))
    except OverflowError:  # no result: of the highest Jacobian alone
        return np.inf


def _transform(R: np.ndarray | None = None, p: np.ndarray | None = None) -> np.ndarray:
    X = np.eye(4)
    if R is not None:
        X[:3, :3] = R
    if p is not None:
        X[:3, 3] = p
    return X


def _aligned(axis: np.ndarray) -> np.ndarray:
    """Returns a rotation (3, 3) whose third column is the axis: the identity if that is z."""
    if np.abs(axis - [0, 0, 1]).max() < EXACT:
        return np.eye(3)
    x = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])


def _turn(R: np.ndarray) -> int:
    off = np.abs(R - np.eye(3))
    if off.max() < EXACT:
        return IDENTITY
    return ABOUT_X if max(off[0].max(), off[:, 0].max()) < EXACT else GENERAL
