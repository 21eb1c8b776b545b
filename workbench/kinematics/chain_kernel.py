"""The Taylor recursion of a serial chain, compiled once for all chains and orders."""

from pathlib import Path

from numba import njit

from workbench.kinematics import chain_recursion, lanes
from workbench.kinematics.chain_recursion import (
    LARGEST_ANGLE,
    OPTIONS,
    compiled,
    cosine_and_sine,
    extend_exponential,
    inlined,
    rotate_and_step,
    slide,
    step,
    turn_and_step,
)
from workbench.kinematics.lanes import (
    CHUNK,
    SIZE,
    WIDTH,
    load,
    load_side_by_side,
    load_states,
    number,
    set_number,
    spread,
    store,
    store_states,
)

HEADER, ROW = 4, 10  # numbers before the factors, and for each joint, in the plan
NEAR = 3072  # doubles of the nearest cache that blocks which take turns may fill

# -- how states lie in memory ----------------------------------------------------------------------


@compiled
def runs(array, row_of_order, row_of_part):
    """The axes of one state of an array (orders, states, parts), that whose numbers are neighbours first:
    of each the count, the bytes between numbers, and the distance of their rows in the workspace. Where
    one axis continues the other they are one."""
    inner = array.shape[0], array.strides[0], row_of_order
    outer = array.shape[2], array.strides[2], row_of_part
    if inner[1] != 8:
        inner, outer = outer, inner
    if outer[1] == inner[0] * inner[1] and outer[2] == inner[0] * inner[2]:
        inner, outer = (outer[0] * inner[0], inner[1], inner[2]), (1, 0, 0)
    return inner, outer


@compiled
def read_side_by_side(source, last, blocks, axes, factors, Q, apart):
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
def read_block(source, of_state, here, axes, factors, Q):
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
def write_block(W, here, axes, target, of_state):
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


# -- the kernel -----------------------------------------------------------------------------------


@inlined
def pass_joint(joint, is_tip, blocks, apart, work, V, W, terms, reciprocals, rows, result):
    """From the twists V behind a joint to those before it, W, or at the base to the result: from the address
    `target` on, `to_next` bytes for a block, but not beyond `last`."""
    _sizes, D, Q, E, _V, _W = work
    zero = spread(0.0)
    row = rows + 8 * ROW * joint
    angle, sliding, pitch = int(number(row, 0)), int(number(row, 1)), number(row, 2)
    link = (
        spread(number(row, 3)),
        spread(number(row, 4)),
        spread(number(row, 5)),
        spread(number(row, 6)),
        spread(number(row, 7)),
    )
    (target, to_next, last), base = ((0, 0, 0), None) if result is None else result
    for i in range(blocks):
        block = i * apart
        W_block = W + block if result is None else min(target + i * to_next, last)
        rate = Q + SIZE * (angle * (terms + 1) + 1) + block
        slide_rate = Q + SIZE * (sliding * (terms + 1) + 1) + block
        if is_tip:
            for k in range(terms):
                z = load(rate, k) if angle >= 0 else zero
                vz = pitch * load(slide_rate, k) if sliding >= 0 else zero
                step(W_block, k, zero, zero, zero, zero, z, vz, link, base)
            continue
        if sliding >= 0:
            slide(V + block, D, slide_rate - SIZE, slide_rate, pitch, reciprocals, terms)
        if angle >= 0:
            E_joint = E + 2 * SIZE * terms * joint + block
            rotate_and_step(V + block, W_block, E_joint, rate, terms, link, base)
        else:
            turn_and_step(V + block, W_block, number(row, 8), number(row, 9), terms, link, base)


@compiled
def twists_of_blocks(blocks, apart, work, joints, terms, reciprocals, rows, result):
    """From Q[i (n + 2) + k], coordinate i and its scaled rates, to the results, see `step`. The blocks'
    workspaces are `apart` bytes from one another; their steps take turns, since none waits for another's.
    Adds the squares of the angles to `sizes`."""
    sizes, _D, Q, E, V, W = work
    columns = terms + 1
    squares = load(sizes, 0)
    for joint in range(joints - 1):
        row = rows + 8 * ROW * joint
        angle = int(number(row, 0))
        if angle >= 0:
            for i in range(blocks):
                E_joint = E + 2 * SIZE * terms * joint + i * apart
                alpha = load(Q + i * apart, angle * columns)
                squares = squares + alpha * alpha
                c, s = cosine_and_sine(alpha)
                store(E_joint, 0, number(row, 8) * c - number(row, 9) * s)
                store(E_joint, 1, number(row, 8) * s + number(row, 9) * c)
    store(sizes, 0, squares)
    for joint in range(joints - 1):
        angle = int(number(rows + 8 * ROW * joint, 0))
        if angle >= 0:
            rate = Q + SIZE * (angle * columns + 1)
            E_joint = E + 2 * SIZE * terms * joint
            for i in range(blocks):
                extend_exponential(E_joint + i * apart, rate + i * apart, terms, reciprocals)
    for joint in range(joints - 1, 0, -1):
        pass_joint(joint, joint == joints - 1, blocks, apart, work, V, W, terms, reciprocals, rows, None)
        V, W = W, V
    pass_joint(0, joints == 1, blocks, apart, work, V, W, terms, reciprocals, rows, result)


def workspace(dof, joints, terms):
    """How many blocks take turns, and the doubles to leave for them at the end of a plan."""
    size = WIDTH * (dof * (terms + 1) + 2 * terms * joints + 12 * terms)
    together = max(1, min(8, NEAR // size))
    return together, together * size + WIDTH * (terms + 2)


def _twists_of_states(q, plan, out):
    """q (n + 2, states, dof) → out (n + 1, states, 6), scaled by the factors of the plan, given by its
    address. Returns False, with `out` unusable, if an angle exceeds LARGEST_ANGLE.

    The arrays may lie in memory in any way; states that are neighbours there need no transposition.
    The workspace is the end of the plan: two calls cannot meet there, for Python's global lock is
    held throughout."""
    columns, states, dof = q.shape
    terms = columns - 1
    joints, together = int(number(plan, 0)), int(number(plan, 1))
    factors = plan + 8 * HEADER
    output_factors = factors + 8 * dof * columns
    reciprocals = output_factors + 8 * terms
    rows = reciprocals + 8 * terms
    sizes = (rows + 8 * ROW * joints + SIZE - 1) // SIZE * SIZE
    D = sizes + SIZE
    Q = D + SIZE * terms
    E = Q + SIZE * dof * columns
    V = E + 2 * SIZE * terms * joints
    W = V + 6 * SIZE * terms
    work, apart = (sizes, D, Q, E, V, W), W + 6 * SIZE * terms - Q
    store(sizes, 0, spread(0.0))
    inputs, outputs = runs(q, 1, columns), runs(out, 6, 1)
    of_state, out_of_state = q.strides[1], out.strides[1]
    here = min(WIDTH, states)
    at_once = here == WIDTH and out_of_state == 8  # results go where they are wanted, not by way of V or W
    steps = (out.strides[0], out.strides[2], SIZE * together) if at_once else (6 * SIZE, SIZE, 0)
    base = number(plan, 2), number(plan, 3), output_factors, *steps
    free = W if joints & 1 else V
    first = 0
    while first < states:
        blocks = min(together, (states - first + WIDTH - 1) // WIDTH)
        if here == WIDTH and of_state == 8:
            last = q.ctypes.data + 8 * (states - here)  # it repeats some of the block before
            read_side_by_side(q.ctypes.data + 8 * first, last, blocks, inputs, factors, Q, apart)
        else:
            for block in range(blocks):
                state = min(first + WIDTH * block, states - here)
                start = q.ctypes.data + of_state * state
                read_block(start, of_state, here, inputs, factors, Q + block * apart)
        result = free, apart, free + blocks * apart
        if at_once:
            result = out.ctypes.data + 8 * first, SIZE, out.ctypes.data + 8 * (states - here)
        twists_of_blocks(blocks, apart, work, joints, terms, reciprocals, rows, (result, base))
        for block in range(0 if at_once else blocks):
            state = min(first + WIDTH * block, states - here)
            target = out.ctypes.data + out_of_state * state
            write_block(free + block * apart, here, outputs, target, out_of_state)
        first += WIDTH * together
    largest = 0.0
    for lane in range(WIDTH):
        largest = max(largest, number(sizes, lane))
    return largest <= LARGEST_ANGLE**2


def _compile():
    """The kernel, kept on disk if there is a place for it. Numba would not notice that what it calls has
    changed since, so what is older than these files is removed first."""
    try:
        kernel = njit(cache=True, **OPTIONS)(_twists_of_states)
        changed = max(Path(module.__file__).stat().st_mtime for module in (chain_recursion, lanes))
        for index in Path(kernel.stats.cache_path).glob("chain_kernel._twists_of_states*.nbi"):
            if index.stat().st_mtime < changed:
                index.unlink(missing_ok=True)
    except (RuntimeError, OSError):
        kernel = njit(**OPTIONS)(_twists_of_states)
    kernel.compile("boolean(float64[:,:,:], int64, float64[:,:,:])")
    kernel.disable_compile()
    return kernel


_kernel = _compile()
(twist_kernel,) = (overload.entry_point for overload in _kernel.overloads.values())
"""`_twists_of_states`, called without Numba's look at the arguments' types, which takes 0.1 µs: nothing but
arrays of native doubles with three axes and an int may be given."""
