"""States of an array in memory, into the kernel's workspace and out of it."""

from __future__ import annotations

from workbench.kinematics.lanes import (
    CHUNK,
    SIZE,
    WIDTH,
    load_side_by_side,
    load_states,
    number,
    set_number,
    spread,
    store,
    store_states,
)
from workbench.kinematics.tree_arithmetic import compiled

Axis = tuple[int, int, int]  # count, bytes between numbers, distance of their rows in the workspace


@compiled
def runs(first: Axis, second: Axis) -> tuple[Axis, Axis]:
    """The two axes of one state of an array, each (count, bytes between numbers, distance of their rows in
    the workspace), that whose numbers are neighbours first. Where one axis continues the other they are
    one."""
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
    """Blocks of states side by side, the first from `source` on but none beyond `last`, times their factors,
    into Q. It goes row by row, as they lie in memory, and asks for what the next turn will read."""
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
    """`here` states, `of_state` bytes apart, times their factors, into Q; the first in all other lanes."""
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
    """`here` states of the rows of W to memory, `of_state` bytes apart."""
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
