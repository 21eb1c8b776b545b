"""One compiled pass over a tree of joints: poses, twist derivatives and Jacobian derivatives of its bodies.

From the base outwards, in the world's axes, on Taylor coefficients. The axis z of a joint and its offset r
from the origin of the frame before it, which turns with ω and is at p with the rotation R, are carried along:

    (k + 1) z₍ₖ₊₁₎ = Σⱼ ω₍ⱼ₎ × z₍ₖ₋ⱼ₎,    (k + 1) r₍ₖ₊₁₎ = Σⱼ ω₍ⱼ₎ × r₍ₖ₋ⱼ₎,
    a turn:   ω'₍ₖ₎ = ω₍ₖ₎ + Σⱼ z₍ⱼ₎ α̇₍ₖ₋ⱼ₎,    R' = R C Rz(α)
    a shift:  p'₍ₖ₎ = p₍ₖ₎ + r₍ₖ₎ + Σⱼ z₍ⱼ₎ d₍ₖ₋ⱼ₎    (d = 0 of a joint that only turns),

Eq. (119) of *Higher-Order Kinematics in Dual Lie Algebra* with the reference point carried along, so that no
number is about the world's origin, and positions are reckoned from the first joint: a base far away loses
no digits. The column of the Jacobian of a turn
is (z; z × (p_F − p')), of a shift (0; z). States go WIDTH at a time (`lanes`), a few such blocks in turns.
`tree_plan` makes the plan, which holds everything constant and the workspace.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from workbench.kinematics import simd_lanes
from workbench.kinematics.compiled_kernels import OF_BOUND, BoundKernel, Kernel, compiled_kernel
from workbench.kinematics.simd_lanes import SIZE, WIDTH, load, number, scalar_cosines_and_sines, spread, store
from workbench.kinematics.trees import tree_arithmetic, tree_bodies, tree_joints, tree_memory
from workbench.kinematics.trees.tree_arithmetic import (
    LARGEST_ANGLE,
    OPTIONS,
    Number,
    compiled,
    cosine_and_sine,
    inlined,
)
from workbench.kinematics.trees.tree_bodies import (
    ALIGNED,
    AT_ONCE,
    COLUMN,
    PAST_CACHES,
    POSE,
    body_out,
    jacobian_out,
    turning_out,
)
from workbench.kinematics.trees.tree_joints import SCREW, SLIDE, TURN, first_step, next_step, scaled_rates
from workbench.kinematics.trees.tree_memory import (
    Axis,
    Memory,
    bound_input,
    bound_output,
    memory_of,
    read_block,
    read_side_by_side,
    runs,
    write_block,
)

HEAD, STEP, BODY = 14, 24, 19  # doubles of the header, a step and a body in the plan
ORIGIN = 10  # where in the header the point is that positions are reckoned from
TURNING = 13  # and how many orders of the Jacobian's turning parts are wanted
LARGE = 2_000_000  # doubles of a result that is written past the caches, which it would only empty
PARTS = (simd_lanes, tree_arithmetic, tree_bodies, tree_joints, tree_memory)  # what is compiled into the pass


class Room(NamedTuple):
    """The workspace of a block: the address of the first one, the bytes from one to the next, and in it
    those to the slots S, cosines and sines E, scaled rates F, axes U, two series v and d, and the result
    W."""

    work: int
    apart: int
    slot: int
    S: int
    E: int
    F: int
    U: int
    v: int
    d: int
    W: int


class Constants(NamedTuple):
    """Addresses in the plan: the point that positions are reckoned from, the factors of the inputs
    (channels, N + 1) and of the results (k! or 1), 0 amid …, 2, 1, 0, 1, 1/2, …, and the rows of steps,
    bodies and columns."""

    origin: int
    factors: int
    out_factors: int
    reciprocals: int
    steps: int
    bodies: int
    columns: int


@inlined
def constants_of(plan: int, channels: int, columns: int) -> Constants:
    factors = plan + 8 * HEAD
    out_factors = factors + 8 * channels * columns
    reciprocals = out_factors + 8 * 2 * columns
    steps = reciprocals + 8 * (columns + 1)
    bodies = steps + 8 * STEP * int(number(plan, 0))
    return Constants(
        plan + 8 * ORIGIN,
        factors,
        out_factors,
        reciprocals,
        steps,
        bodies,
        bodies + 8 * BODY * int(number(plan, 1)),
    )


@inlined
def room_of(plan: int, channels: int, columns: int) -> Room:
    slot = SIZE * (6 + 6 * columns)  # R, and N + 1 and N vectors
    S = SIZE * channels * columns
    E = S + slot * int(number(plan, 2))
    F = E + 2 * SIZE * int(number(plan, 0))
    U = F + 2 * SIZE * columns
    v = U + SIZE * int(number(plan, 6))
    d = v + 3 * SIZE * columns
    W = d + 3 * SIZE * columns
    return Room(plan + int(number(plan, 8)), W + SIZE * int(number(plan, 9)), slot, S, E, F, U, v, d, W)


@inlined
def read_states(
    q: Memory, first: int, blocks: int, inputs: tuple[Axis, Axis], factors: int, room: Room
) -> None:
    here, of_state = min(WIDTH, q.shape[1]), q.strides[1]
    last = q.shape[1] - here  # of the states that begin a block: it repeats some of the block before
    if here == WIDTH and of_state == 8:
        source = q.address + 8 * first
        read_side_by_side(source, q.address + 8 * last, blocks, inputs, factors, room.work, room.apart)
        return
    for block in range(blocks):
        source = q.address + of_state * min(first + WIDTH * block, last)
        read_block(source, of_state, here, inputs, factors, room.work + block * room.apart)


@compiled
def sines_of_steps(Q: int, E: int, steps: int, table: int, columns: int, exactly: bool) -> Number:
    """Returns cos and sin of all angles of a block, to E; the sum of the squares of the angles."""
    squares = spread(0.0)
    for step in range(steps):
        row = table + 8 * STEP * step
        if int(number(row, 0)) in (TURN, SCREW):
            alpha = number(row, 5) * load(Q, int(number(row, 4)) * columns) + spread(number(row, 6))
            squares = squares + alpha * alpha
            if exactly:
                c, s = scalar_cosines_and_sines(alpha)
            else:
                c, s = cosine_and_sine(alpha)
            store(E, 2 * step, c)
            store(E, 2 * step + 1, s)
    return squares


@inlined
def move_joint(step: int, blocks: int, constants: Constants, room: Room, keep: bool, N: int) -> None:
    """Computes the frame after a step, for each block."""
    row = constants.steps + 8 * STEP * step
    kind, parent, own, channel = (
        int(number(row, 0)), int(number(row, 1)), int(number(row, 2)), int(number(row, 4)),
    )  # fmt: skip
    for block in range(blocks):
        Q = room.work + block * room.apart
        S, F = Q + room.S, Q + room.F
        u, slot = Q + room.U + SIZE * int(number(row, 23)), S + own * room.slot
        turn_rate = slide_rate = Q
        if kind in (TURN, SCREW):
            turn_rate = scaled_rates(Q, channel, number(row, 5), number(row, 6), F, N)
        if kind in (SLIDE, SCREW):
            slide_rate = scaled_rates(
                Q, int(number(row, 7)), number(row, 8), number(row, 9), F + SIZE * (N + 1), N
            )
        drives = Q + room.E + 2 * SIZE * step, Q, channel, turn_rate, slide_rate
        if parent == 0:
            first_step(row, kind, drives, slot, u, N, constants.reciprocals)
        else:
            before = S + parent * room.slot
            next_step(row, kind, drives, before, slot, u, Q + room.v, keep, N, constants.reciprocals)


@inlined
def write_body(
    row: int,
    first: int,
    blocks: int,
    out: Memory,
    way: int,
    outputs: tuple[Axis, Axis],
    constants: Constants,
    room: Room,
    jacobians: tuple[int, int, int],
    N: int,
) -> None:
    """Writes the results of a body, for each block.

    way: AT_ONCE or PAST_CACHES writes directly to the result, else through W.
    jacobians: (orders of the Jacobian, orders of its rotational parts, velocities).
    """
    orders, turning, velocities = jacobians
    target = out.address + out.strides[0] * int(number(row, 2))
    here, of_state = min(WIDTH, out.shape[1]), out.strides[1]
    of_part = out.strides[3]
    of_order = 6 * of_part
    for block in range(blocks):
        Q = room.work + block * room.apart
        slot, v, W = Q + room.S + room.slot * int(number(row, 15)), Q + room.v, Q + room.W
        state = min(first + WIDTH * block, out.shape[1] - here)
        if way != ALIGNED:
            to = target + 8 * state
            rows = to, of_part, to + POSE * of_part, of_order, of_part
            own_way = AT_ONCE if state % WIDTH else way
            body_out(row, slot, v, N, constants, rows, own_way)
            continue
        rows = W, SIZE, W + SIZE * POSE, 6 * SIZE, SIZE
        body_out(row, slot, v, N, constants, rows, ALIGNED)
        if orders > 0:
            entries = constants.columns + 8 * COLUMN * int(number(row, 16))
            J = W + SIZE * (POSE + 6 * N)
            where = Q + room.S, room.slot, Q + room.U, v, Q + room.d
            columns, factors = int(number(row, 17)), constants.out_factors
            jacobian_out(entries, columns, where, J, orders, velocities, factors)
            if turning > 0:
                D, w = J + SIZE * 6 * orders * velocities, slot + (12 + 3 * N) * SIZE
                turning_out(entries, columns, Q + room.U, w, D, turning, velocities, factors)
        write_block(W, here, outputs, target + of_state * state, of_state)


@inlined
def way_of(out: Memory, orders: int) -> int:
    """Returns how results are written: directly if states are adjacent, past the caches if they are many."""
    if out.shape[1] < WIDTH or out.strides[1] != 8 or orders > 0:
        return ALIGNED
    size = out.shape[0] * out.shape[1] * out.shape[2] * out.shape[3]
    misaligned = out.address | out.strides[0] | out.strides[2] | out.strides[3]
    return PAST_CACHES if SIZE == 64 and size > LARGE and misaligned % SIZE == 0 else AT_ONCE


@compiled
def pass_of(q: Memory, plan: int, out: Memory, exactly: bool) -> bool:
    """Returns q (N + 1, states, channels) → out (bodies, states, orders, parts), as the plan at that
    address says. False, with `out` unusable, if an angle is beyond LARGEST_ANGLE and its sine was not
    computed `exactly`. The arrays may lie in memory in any way; states that are neighbours there need no
    transposition."""
    columns, states, channels = q.shape
    steps, bodies, together = int(number(plan, 0)), int(number(plan, 1)), int(number(plan, 3))
    keep, orders = number(plan, 7) != 0.0, int(number(plan, 4))
    jacobians = orders, int(number(plan, TURNING)), int(number(plan, 5))
    constants, room = constants_of(plan, channels, columns), room_of(plan, channels, columns)
    inputs = runs((columns, q.strides[0], 1), (channels, q.strides[2], columns))
    outputs = runs((out.shape[2], out.strides[2], out.shape[3]), (out.shape[3], out.strides[3], 1))
    way = way_of(out, orders)
    squares, first = spread(0.0), 0
    while first < states:
        blocks = min(together, (states - first + WIDTH - 1) // WIDTH)
        read_states(q, first, blocks, inputs, constants.factors, room)
        for block in range(blocks):
            Q = room.work + block * room.apart
            squares = squares + sines_of_steps(Q, Q + room.E, steps, constants.steps, columns, exactly)
        body = 0
        for step in range(-1, steps):
            if step >= 0:
                move_joint(step, blocks, constants, room, keep, columns - 1)
            while body < bodies and int(number(constants.bodies + 8 * BODY * body, 0)) == step:
                row = constants.bodies + 8 * BODY * body
                write_body(row, first, blocks, out, way, outputs, constants, room, jacobians, columns - 1)
                body += 1
        first += WIDTH * together
    largest, spare = 0.0, room.work + room.v
    store(spare, 0, squares)
    for lane in range(WIDTH):
        largest = max(largest, number(spare, lane))
    return exactly or largest <= LARGEST_ANGLE**2


def tree_pass(q: np.ndarray, plan: int, out: np.ndarray, exactly: bool) -> bool:
    return pass_of(memory_of(q), plan, memory_of(out), exactly)


def bound_tree_pass(arguments: int) -> bool:
    return pass_of(bound_input(arguments), int(number(arguments, 7)), bound_output(arguments), False)


@cache
def tree_kernel() -> Kernel:
    """Returns `pass_of` for arrays, compiled."""
    return compiled_kernel(tree_pass, PARTS, OPTIONS)


@cache
def bound_tree_kernel() -> BoundKernel:
    """Returns `pass_of` for the arguments of a `BoundCall`, compiled."""
    return compiled_kernel(bound_tree_pass, PARTS, OPTIONS, OF_BOUND)
