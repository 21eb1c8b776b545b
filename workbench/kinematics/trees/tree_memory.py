"""Transfer of an array's states to the kernel's workspace and back."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from workbench.kinematics import simd_lanes
from workbench.kinematics.compiled_kernels import compiled_kernel
from workbench.kinematics.simd_lanes import (
    CHUNK,
    SIZE,
    WIDTH,
    load_side_by_side,
    load_states,
    number,
    set_number,
    spread,
    store,
    store_past_caches,
    store_states,
)
from workbench.kinematics.spare_memory import spare_memory
from workbench.kinematics.trees.tree_arithmetic import OPTIONS, compiled, inlined

AHEAD = 1024  # bytes that are asked for before they are read


class Memory(NamedTuple):
    """An array of doubles: its address, its shape, and the bytes between neighbours along each axis."""

    address: int
    shape: tuple[int, ...]
    strides: tuple[int, ...]


@inlined
def memory_of(array: np.ndarray) -> Memory:
    return Memory(array.ctypes.data, array.shape, array.strides)


@inlined
def bound_input(record: int) -> Memory:
    """Returns q from the arguments of a `BoundCall`."""
    return Memory(
        int(number(record, 0)),
        (int(number(record, 1)), int(number(record, 2)), int(number(record, 3))),
        (int(number(record, 4)), int(number(record, 5)), int(number(record, 6))),
    )


@inlined
def bound_output(record: int) -> Memory:
    return Memory(
        int(number(record, 8)),
        (int(number(record, 9)), int(number(record, 10)), int(number(record, 11)), int(number(record, 12))),
        (int(number(record, 13)), int(number(record, 14)), int(number(record, 15)), int(number(record, 16))),
    )


Axis = tuple[int, int, int]  # count, bytes between numbers, distance of their rows in the workspace


@compiled
def runs(first: Axis, second: Axis) -> tuple[Axis, Axis]:
    """Returns the two axes of one state of an array, each (count, bytes between numbers, distance of their
    rows in the workspace), that whose numbers are neighbours first. Where one axis continues the other
    they are one."""
    inner, outer = first, second
    if inner[1] != 8:
        inner, outer = outer, inner
    if outer[1] == inner[0] * inner[1] and outer[2] == inner[0] * inner[2]:
        inner, outer = (outer[0] * inner[0], inner[1], inner[2]), (1, 0, 0)
    return inner, outer


@compiled
def read_side_by_side(
    source: int, last: int, blocks: int, axes: tuple[Axis, Axis], factors: int, Q: int, apart: int
) -> None:
    """Reads blocks of states that are adjacent in memory, from `source` up to `last`, times their factors,
    into Q.

    Rows are read in the order of memory, with prefetching of those that the next turn reads.
    """
    (count, of_row, rows), (runs_there, of_run, rows_apart) = axes
    for run in range(runs_there):
        for i in range(count):
            at, start = run * rows_apart + i * rows, run * of_run + i * of_row
            factor = spread(number(factors, at))
            for block in range(blocks):
                states = load_side_by_side(min(source + SIZE * block, last) + start, SIZE * blocks)
                store(Q + block * apart, at, factor * states)


@compiled
def read_block(source: int, of_state: int, here: int, axes: tuple[Axis, Axis], factors: int, Q: int) -> None:
    """Reads `here` states, `of_state` bytes apart, times their factors, into Q; other lanes get the first
    one."""
    (count, apart, rows), (runs_there, runs_apart, rows_apart) = axes
    for run in range(runs_there):
        row, start = run * rows_apart, source + run * runs_apart
        if here == WIDTH and apart == 8 and count >= CHUNK:
            for i in range(0, count, CHUNK):
                i = min(i, count - CHUNK)
                load_states(start + 8 * i, of_state, factors, Q, row + i * rows, rows)
        else:
            for i in range(count):
                at = row + i * rows
                store(Q, at, spread(number(factors, at) * number(start + i * apart, 0)))
                for lane in range(1, here):
                    value = number(start + i * apart + lane * of_state, 0)
                    set_number(Q, WIDTH * at + lane, number(factors, at) * value)


@compiled
def write_block(W: int, here: int, axes: tuple[Axis, Axis], target: int, of_state: int) -> None:
    """Writes `here` states of the rows of W to memory, `of_state` bytes apart."""
    (count, apart, rows), (runs_there, runs_apart, rows_apart) = axes
    for run in range(runs_there):
        row, start = run * rows_apart, target + run * runs_apart
        if here == WIDTH and apart == 8 and count >= CHUNK:
            for i in range(0, count, CHUNK):
                i = min(i, count - CHUNK)
                store_states(W, row + i * rows, rows, start + 8 * i, of_state)
        else:
            for lane in range(here):
                for i in range(count):
                    value = number(W, WIDTH * (row + i * rows) + lane)
                    set_number(start + i * apart + lane * of_state, 0, value)


def copy_past_caches(source: int, target: int, count: int, sums: int) -> bool:
    """Copy `count` doubles, a multiple of 2 WIDTH, between two addresses; the target and `sums`, the address
    of WIDTH doubles, are aligned. Whether all are finite; not, too, where their sum is not."""
    s, t = spread(0.0), spread(0.0)
    for i in range(0, count, 2 * WIDTH):
        x, y = load_side_by_side(source + 8 * i, AHEAD), load_side_by_side(source + 8 * i + SIZE, AHEAD)
        store_past_caches(target + 8 * i, x)
        store_past_caches(target + 8 * i + SIZE, y)
        s, t = s + x, t + y
    store(sums, 0, s + t)
    total = 0.0
    for lane in range(WIDTH):
        total += number(sums, lane)
    return total - total == 0.0


@cache
def _copier() -> Callable[[int, int, int, int], bool]:
    return compiled_kernel(copy_past_caches, (simd_lanes,), OPTIONS, "boolean(int64, int64, int64, int64)")


def finite_copy(numbers: np.ndarray) -> np.ndarray | None:
    """Returns a copy of a large contiguous array of doubles in one pass over memory, which caches are
    spared of; None unless all numbers, and their sum, are finite."""
    memory = spare_memory(numbers.size + 2 * WIDTH)
    start = -memory.ctypes.data % SIZE // 8
    copy = memory[start : start + numbers.size]
    whole = numbers.size // (2 * WIDTH) * (2 * WIDTH)
    flat, room = numbers.reshape(-1), np.empty(2 * WIDTH)
    room_at = room.ctypes.data + -room.ctypes.data % SIZE
    if not _copier()(numbers.ctypes.data, copy.ctypes.data, whole, room_at):
        return None
    copy[whole:] = flat[whole:]
    return copy.reshape(numbers.shape) if np.isfinite(copy[whole:]).all() else None
