"""One compiled pass over a serial chain from tip to base: the twist of its last body about the base's origin,
to any order.

From joint to joint the twist series V is carried along, in the frames of `chain_plan`:

    V ← z α̇ + e^{iα} V,    then turned by the twist angle and shifted to the axis before,

with e^{iα} acting on the parts across the axis, Eq. (119) of *Higher-Order Kinematics in Dual Lie Algebra*.
That is 10 multiply-adds for each pair of coefficients, where a pass from the base outwards (`tree_kernel`),
which tells every body's motion, has 15. States go WIDTH at a time (`lanes`), a few such blocks in turns.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from workbench.kinematics import chain_recursion, simd_lanes
from workbench.kinematics.chain_recursion import (
    Base,
    extend_exponential,
    rotate_and_step,
    slide,
    step,
    turn_and_step,
)
from workbench.kinematics.compiled_kernels import OF_BOUND, BoundKernel, Kernel, compiled_kernel
from workbench.kinematics.simd_lanes import SIZE, WIDTH, load, number, scalar_cosines_and_sines, spread, store
from workbench.kinematics.trees import tree_arithmetic, tree_memory
from workbench.kinematics.trees.tree_arithmetic import (
    LARGEST_ANGLE,
    OPTIONS,
    compiled,
    cosine_and_sine,
    inlined,
)
from workbench.kinematics.trees.tree_memory import (
    Memory,
    bound_input,
    bound_output,
    memory_of,
    read_block,
    read_side_by_side,
    runs,
    write_block,
)

HEAD, ROW = 4, 10  # numbers before the factors, and for each joint, in the plan
PARTS = (simd_lanes, tree_arithmetic, tree_memory, chain_recursion)  # what is compiled into the pass


class Room(NamedTuple):
    """Addresses of the workspace: squares of the angles, a slide's series, and of the first block the inputs,
    the exponentials and two twist series; the bytes from one block to the next."""

    squares: int
    D: int
    Q: int
    E: int
    V: int
    W: int
    apart: int


class Constants(NamedTuple):
    """The number of joints and of coefficients, and addresses in the plan: 0, 1, 1/2, …, and the rows of the
    joints."""

    joints: int
    terms: int
    reciprocals: int
    rows: int


class Target(NamedTuple):
    """Where results go: the address of the first block's, the bytes to the next block's, the last address."""

    first: int
    apart: int
    last: int


@inlined
def pass_joint(
    joint: int,
    blocks: int,
    room: Room,
    V: int,
    W: int,
    constants: Constants,
    target: Target | None,
    base: Base | None,
) -> None:
    """Computes the twists W before a joint, or at the base the result, from the twists V after it."""
    zero, terms, columns = spread(0.0), constants.terms, constants.terms + 1
    row = constants.rows + 8 * ROW * joint
    angle, sliding, pitch = int(number(row, 0)), int(number(row, 1)), number(row, 2)
    link = (
        spread(number(row, 3)),
        spread(number(row, 4)),
        spread(number(row, 5)),
        spread(number(row, 6)),
        spread(number(row, 7)),
    )
    for i in range(blocks):
        block = i * room.apart
        to = W + block if target is None else min(target.first + i * target.apart, target.last)
        rate = room.Q + SIZE * (angle * columns + 1) + block
        slide_at = room.Q + SIZE * sliding * columns + block
        if joint == constants.joints - 1:
            for k in range(terms):
                z = load(rate, k) if angle >= 0 else zero
                vz = pitch * load(slide_at, k + 1) if sliding >= 0 else zero
                step(to, k, (zero, zero, zero, zero), z, vz, link, base)
            continue
        if sliding >= 0:
            slide(V + block, room.D, slide_at, pitch, constants.reciprocals, terms)
        if angle >= 0:
            E = room.E + 2 * SIZE * terms * joint + block
            rotate_and_step(V + block, to, E, rate, terms, link, base)
        else:
            turn_and_step(V + block, to, number(row, 8), number(row, 9), terms, link, base)


@compiled
def exponentials(blocks: int, room: Room, constants: Constants, exactly: bool) -> None:
    """Computes the series e^{i(α + constant)} of all joints that move something; adds the squares of the
    angles."""
    columns, squares = constants.terms + 1, load(room.squares, 0)
    for joint in range(constants.joints - 1):
        row = constants.rows + 8 * ROW * joint
        angle, E = int(number(row, 0)), room.E + 2 * SIZE * constants.terms * joint
        for i in range(blocks if angle >= 0 else 0):
            alpha = load(room.Q + i * room.apart, angle * columns)
            squares = squares + alpha * alpha
            if exactly:
                c, s = scalar_cosines_and_sines(alpha)
            else:
                c, s = cosine_and_sine(alpha)
            store(E + i * room.apart, 0, number(row, 8) * c - number(row, 9) * s)
            store(E + i * room.apart, 1, number(row, 8) * s + number(row, 9) * c)
    store(room.squares, 0, squares)
    for joint in range(constants.joints - 1):
        angle = int(number(constants.rows + 8 * ROW * joint, 0))
        E = room.E + 2 * SIZE * constants.terms * joint
        for i in range(blocks if angle >= 0 else 0):
            rate = room.Q + SIZE * (angle * columns + 1) + i * room.apart
            extend_exponential(E + i * room.apart, rate, constants.terms, constants.reciprocals)


@compiled
def twists_of_blocks(
    blocks: int, room: Room, constants: Constants, target: Target, base: Base, exactly: bool
) -> None:
    """Computes the results of some blocks from their inputs.

    The steps of the blocks alternate, since they are independent of each other.
    """
    exponentials(blocks, room, constants, exactly)
    V, W = room.V, room.W
    for joint in range(constants.joints - 1, 0, -1):
        pass_joint(joint, blocks, room, V, W, constants, None, None)
        V, W = W, V
    pass_joint(0, blocks, room, V, W, constants, target, base)


@inlined
def room_of(plan: int, dof: int, constants: Constants) -> Room:
    joints, terms = constants.joints, constants.terms
    squares = (constants.rows + 8 * ROW * joints + SIZE - 1) // SIZE * SIZE
    D = squares + SIZE
    Q = D + SIZE * terms
    E = Q + SIZE * dof * (terms + 1)
    V = E + 2 * SIZE * terms * joints
    W = V + 6 * SIZE * terms
    return Room(squares, D, Q, E, V, W, W + 6 * SIZE * terms - Q)


@compiled
def pass_of(q: Memory, plan: int, out: Memory, exactly: bool) -> bool:
    """Returns q (n + 2, states, dof) → out (1, states, n + 1, 6), as the plan at that address says.

    False, with `out` unusable, if an angle is beyond LARGEST_ANGLE and its sine was not computed `exactly`.
    The arrays may lie in memory in any way; states that are neighbours there need no transposition."""
    columns, states, dof = q.shape
    joints, together = int(number(plan, 0)), int(number(plan, 1))
    factors = plan + 8 * HEAD
    out_factors = factors + 8 * dof * columns
    reciprocals = out_factors + 8 * (columns - 1)
    constants = Constants(joints, columns - 1, reciprocals, reciprocals + 8 * (columns - 1))
    room = room_of(plan, dof, constants)
    store(room.squares, 0, spread(0.0))
    inputs = runs((columns, q.strides[0], 1), (dof, q.strides[2], columns))
    outputs = runs((columns - 1, out.strides[2], 6), (6, out.strides[3], 1))
    of_state, out_of_state = q.strides[1], out.strides[1]
    here = min(WIDTH, states)
    last = states - here  # of the states that begin a block: it repeats some of the block before
    at_once = here == WIDTH and out_of_state == 8  # results go where they are wanted, not by way of V or W
    if at_once:
        base = Base(
            number(plan, 2), number(plan, 3), out_factors, out.strides[2], out.strides[3], SIZE * together
        )
    else:
        base = Base(number(plan, 2), number(plan, 3), out_factors, 6 * SIZE, SIZE, 0)
    free = room.W if joints & 1 else room.V
    first = 0
    while first < states:
        blocks = min(together, (states - first + WIDTH - 1) // WIDTH)
        if here == WIDTH and of_state == 8:
            source = q.address + 8 * first
            end = q.address + 8 * last
            read_side_by_side(source, end, blocks, inputs, factors, room.Q, room.apart)
        else:
            for block in range(blocks):
                source = q.address + of_state * min(first + WIDTH * block, last)
                read_block(source, of_state, here, inputs, factors, room.Q + block * room.apart)
        target = Target(free, room.apart, free + blocks * room.apart)
        if at_once:
            target = Target(out.address + 8 * first, SIZE, out.address + 8 * last)
        twists_of_blocks(blocks, room, constants, target, base, exactly)
        for block in range(0 if at_once else blocks):
            to = out.address + out_of_state * min(first + WIDTH * block, last)
            write_block(free + block * room.apart, here, outputs, to, out_of_state)
        first += WIDTH * together
    largest = 0.0
    for lane in range(WIDTH):
        largest = max(largest, number(room.squares, lane))
    return exactly or largest <= LARGEST_ANGLE**2


def chain_pass(q: np.ndarray, plan: int, out: np.ndarray, exactly: bool) -> bool:
    return pass_of(memory_of(q), plan, memory_of(out), exactly)


def bound_chain_pass(arguments: int) -> bool:
    return pass_of(bound_input(arguments), int(number(arguments, 7)), bound_output(arguments), False)


@cache
def chain_kernel() -> Kernel:
    """Returns `pass_of` for arrays, compiled."""
    return compiled_kernel(chain_pass, PARTS, OPTIONS)


@cache
def bound_chain_kernel() -> BoundKernel:
    """Returns `pass_of` for the arguments of a `BoundCall`, compiled."""
    return compiled_kernel(bound_chain_pass, PARTS, OPTIONS, OF_BOUND)
