"""Frames of a robot: the workbench beside Pinocchio and Drake, one thread, in one run.

    OPENBLAS_NUM_THREADS=1 python tests/benchmarks/robot_frames.py [robot.urdf frame] [--avx2] [--rounds 200] [--plot FILE]

What each call yields: the pose of the frame, its twist and the twist's derivatives to the order of the highest
derivative of the coordinates (order 2: velocity and acceleration, which is what the peers can). Times are the
least of many short rounds, since others may use the machine; a ratio is a peer's time over the workbench's.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

if TYPE_CHECKING:
    from workbench.kinematics import Robot

Call = Callable[[], object]


def best(call: Call, rounds: int) -> float:
    """The least time of a call in µs, over rounds of some 0.2 ms. Calls of many ms, in which others' turns on the
    processor would count, are measured by processor time."""
    call()
    start = time.perf_counter()
    call()
    one = time.perf_counter() - start
    calls = max(1, int(2e-4 / max(one, 1e-7)))
    clock, rounds = (time.perf_counter, rounds) if one < 5e-3 else (time.process_time, max(5, rounds // 20))
    least = np.inf
    for _ in range(rounds):
        start = clock()
        for _ in range(calls):
            call()
        least = min(least, clock() - start)
    return least / calls * 1e6


def workbench_calls(urdf: str, frame: str, q: np.ndarray) -> Iterator[tuple[str, Call, int]]:
    """Names, calls and the states that each call is for."""
    from workbench.kinematics import Robot
    from workbench.kinematics.trees.tree_engine import states_side_by_side

    robot, order = Robot.from_urdf(urdf), len(q) - 1
    states = q[0].size // q.shape[-1]
    yield (
        "motion(q).frame(f).twist(1)",
        lambda: robot.motion(q, order=order).frame(frame).twist(order - 1).array,
        states,
    )
    yield (
        f"motion(q).frame(f).jacobian({order})",
        lambda: robot.motion(q, order=order).frame(frame).jacobian(order),
        states,
    )
    if q.ndim == 2:
        for name, jacobians in (("evaluator", 0), (f"evaluator, jacobians={order + 1}", order + 1)):
            bound = robot.evaluator(frame, order, jacobians)
            bound.q[...] = q
            yield name, bound, 1
    motion = robot.motion(q, order=order)
    yield "motion(q).records(), all frames", lambda: robot.motion(q, order=order).records(), states
    if q.ndim == 3:
        out = states_side_by_side(len(robot.bodies), states, 16 + 6 * order)
        yield "records(out=), all frames", lambda: motion.records(out=out), states
        yield "blocks of 1000, all frames", lambda: in_blocks(robot, q), states


def in_blocks(robot: Robot, q: np.ndarray) -> None:
    for motion in robot.blocks(q, size=1000):
        motion.records()


Peer = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def pinocchio(urdf: str, frame: str) -> tuple[Peer, list[str]]:
    """A call from q, v, a to the frame's acceleration (ω̇; v̇), and the names of its coordinates."""
    import pinocchio as pin

    model = pin.buildModelFromUrdf(urdf)
    data, index = model.createData(), model.getFrameId(frame)

    def call(q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
        pin.forwardKinematics(model, data, q, v, a)
        pin.updateFramePlacement(model, data, index)
        return pin.getFrameClassicalAcceleration(model, data, index, pin.LOCAL_WORLD_ALIGNED).vector

    return call, list(model.names)[1:]


def drake(urdf: str, frame: str) -> tuple[Peer, list[str]]:
    """The same by Drake."""
    from pydrake.multibody.tree import JacobianWrtVariable

    from workbench.drake.plants import load_urdf

    plant = load_urdf(urdf)
    context, W = plant.CreateDefaultContext(), plant.world_frame()
    B, kV = plant.GetBodyByName(frame).body_frame(), JacobianWrtVariable.kV

    def call(q: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
        plant.SetPositions(context, q)
        plant.SetVelocities(context, v)
        J = plant.CalcJacobianSpatialVelocity(context, kV, B, [0, 0, 0], W, W)
        bias = plant.CalcBiasSpatialAcceleration(context, kV, B, [0, 0, 0], W, W)
        return J @ a + bias.get_coeffs()

    moving = [plant.get_joint(i) for i in plant.GetJointIndices()]
    moving = sorted((j for j in moving if j.num_positions()), key=lambda j: j.position_start())
    return call, [joint.name() for joint in moving]


def peers(urdf: str, frame: str, q: np.ndarray) -> Iterator[tuple[str, Call, int]]:
    """The peers' calls on the first 1000 states of q (3, ..., positions), after a look at their values."""
    from workbench.kinematics import Robot

    robot = Robot.from_urdf(urdf)
    for name, peer in (("Pinocchio", pinocchio), ("Drake, J a + bias", drake)):
        try:
            call, coordinates = peer(urdf, frame)
        except ImportError:
            print(f"   {name}: not installed")
            continue
        M, c = robot.follow(coordinates)
        theirs = q @ M.T
        theirs[0] += c
        states = theirs[:, None] if theirs.ndim == 2 else theirs[:, :1000]
        states = np.ascontiguousarray(states.swapaxes(0, 1))
        ours = robot.motion(q if q.ndim == 3 else q[:, None]).frame(frame).twist(1).array
        for state, right in zip(states[:5], ours, strict=False):
            np.testing.assert_allclose(np.sort(call(*state)), np.sort(right), rtol=0, atol=1e-9)
        if q.ndim == 2:
            yield name, lambda call=call, s=states[0]: call(*s), 1
        else:
            yield (
                f"{name}, loop",
                lambda call=call, all_states=states: [call(*s) for s in all_states],
                len(states),
            )


def run_for_avx2(arguments: list[str]) -> None:
    """Runs this program with everything compiled for AVX2, whatever else the processor has."""
    import llvmlite.binding as llvm

    newer = ("avx512", "avx10", "amx")
    features = ",".join(
        ("+" if there and not name.startswith(newer) else "-") + name
        for name, there in llvm.get_host_cpu_features().items()
    )
    with tempfile.TemporaryDirectory() as cache:
        target = {
            "NUMBA_CPU_NAME": "haswell",
            "NUMBA_CPU_FEATURES": features,
            "NUMBA_CACHE_DIR": cache,
        }
        subprocess.run([sys.executable, __file__, *arguments], check=True, env=os.environ | target)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf", nargs="?", type=Path)
    parser.add_argument("frame", nargs="?", default="panda_hand")
    parser.add_argument("--rounds", type=int, default=200)
    parser.add_argument("--states", type=int, nargs="*", default=[1, 1000, 100_000])
    parser.add_argument("--orders", type=int, nargs="*", default=[2, 4])
    parser.add_argument("--plot", type=Path, help="write a figure of all times and ratios to this file")
    parser.add_argument("--avx2", action="store_true", help="compile for AVX2, whatever else there is")
    options = parser.parse_args()
    if options.avx2:
        return run_for_avx2([given for given in sys.argv[1:] if given != "--avx2"])
    urdf = options.urdf
    if urdf is None:
        from workbench.drake.plants import robot_urdf

        urdf = robot_urdf("panda")
    from workbench.kinematics import Robot

    sys.path.insert(0, str(Path(__file__).parent))
    from chain_peak import registers

    positions, rng = len(Robot.from_urdf(urdf).positions), np.random.default_rng(0)
    print(f"{urdf.name}, {options.frame}; {registers()}")
    tables: dict[str, dict[str, float]] = {}
    for order in options.orders:
        for states in options.states:
            shape = (order + 1, positions) if states == 1 else (order + 1, states, positions)
            q = rng.uniform(-1, 1, shape)
            print(f"order {order}, {states} state{'s' * (states > 1)}: µs a state, ratio to the first row")
            rows = [*workbench_calls(str(urdf), options.frame, q)]
            rows += peers(str(urdf), options.frame, q) if order == 2 else []
            first, table = None, tables.setdefault(f"order {order}, {states} states", {})
            for name, call, count in rows:
                spent = best(call, options.rounds) / count
                first = first or spent
                table[name] = spent
                print(f"   {name:42s}{spent:10.4f}{spent / first:10.2f}", flush=True)
    if options.plot is not None:
        plot(tables, options.plot)


def plot(tables: dict[str, dict[str, float]], file: Path) -> None:
    """One panel a table: times a state in µs, on a logarithmic axis, with the ratio to the first row."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 1.2 + 0.28 * sum(map(len, tables.values()))), layout="constrained")
    heights = [len(table) for table in tables.values()]
    panels = figure.subplots(len(tables), 1, sharex=True, squeeze=False, height_ratios=heights)[:, 0]
    for axis, (title, table) in zip(panels, tables.items(), strict=True):
        names, values = list(table), list(table.values())
        colours = ["tab:orange" if name.startswith(("Pinocchio", "Drake")) else "tab:blue" for name in names]
        axis.barh(names, values, color=colours)
        for row, value in enumerate(values):
            axis.text(value, row, f" {value:.3g} µs, × {value / values[0]:.2g}", va="center", fontsize=7)
        axis.invert_yaxis()
        axis.set_xscale("log")
        axis.set_title(title, fontsize=9)
        axis.tick_params(labelsize=7)
    panels[-1].set_xlim(right=3 * max(max(table.values()) for table in tables.values()))
    panels[-1].set_xlabel("µs a state (orange: peers)")
    figure.savefig(file)
    print(f"plot: {file}")


if __name__ == "__main__":
    main()
