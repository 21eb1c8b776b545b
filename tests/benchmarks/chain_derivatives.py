"""Twist derivatives of serial chains: the workbench against the tools people would use instead.

    python tests/benchmarks/chain_derivatives.py --joints 2,7 --orders 1,4 --peers "JAX jet,Pinocchio"

Each tool runs in a process of its own, so that it can be timed out and its memory measured; the
clock runs in one process at a time, the workbench's and the peer's in turns, and a ratio is the
median over the rounds. All results must agree with the workbench's to 1e-9 before any clock starts.
Each peer gets its input in the order and scale that suit it and leaves its result so, and the
workbench is timed on a batch of the same layout: "last", the states' numbers side by side, which is
from kernel to kernel; "first", a state's numbers side by side; "arrays", from NumPy's documented
array to another.
"""

import argparse
import importlib.util
import json
import multiprocessing
import os
import shutil
import statistics
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from chain_peak import make_peak_works, operations, registers, share_and_peak
from chain_peers import NEEDS_C_COMPILER, PEERS
from chain_problem import LAYOUTS, Problem, Workbench

AGREEMENT = 1e-9
MODULES = {
    "heyoka": "heyoka",
    "JAX": "jax",
    "CasADi": "casadi",
    "SymEngine": "symengine",
    "Drake": "pydrake",
    "Pinocchio": "pinocchio",
}


def problem(joints, order, states):
    rng = np.random.default_rng(1000 * joints + order)
    links = np.tile(np.eye(4), (joints, 1, 1))
    for C in links:
        Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        C[:3, :3], C[:3, 3] = Q * np.linalg.det(Q), 0.3 * rng.normal(size=3)
    shape = (joints, order + 2)
    return Problem(links, rng.normal(size=shape), rng.normal(size=(states, *shape)))


# -- one process a tool ------------------------------------------------------------------------


def seconds_per_call(function, budget):
    function()
    calls, elapsed = 1, 0.0
    while True:
        start = time.perf_counter()
        for _ in range(calls):
            function()
        elapsed = time.perf_counter() - start
        if elapsed > budget / 5:
            break
        calls *= 2
    best = elapsed / calls
    for _ in range(4 if elapsed < budget else 0):
        start = time.perf_counter()
        for _ in range(calls):
            function()
        best = min(best, (time.perf_counter() - start) / calls)
    return best


def resident_megabytes():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def serve(name, connection):
    """Answer the requests of the parent process: build a problem, time it."""
    peer = peak_works = None
    while True:
        request, *details = connection.recv()
        try:
            if request == "build":
                before, start = resident_megabytes(), time.perf_counter()
                peer = (Workbench if name == "workbench" else PEERS[name])(*details)
                single, batch = peer.results()
                figures = time.perf_counter() - start, resident_megabytes() - before
                connection.send(("built", *figures, single, batch))
            elif request == "time":
                which, budget = details
                runs = {"single": peer.run_single, "batch": peer.run_batch, **getattr(peer, "batches", {})}
                run = runs[which]
                connection.send(("timed", seconds_per_call(run, budget)))
            elif request == "peak":
                count, seconds = details
                peak_works = peak_works or make_peak_works()
                connection.send(("peak", *share_and_peak(peer.batches["last"], count, peak_works, seconds)))
        except Exception as error:
            connection.send(("failed", f"{type(error).__name__}: {error}"))


class Worker:
    def __init__(self, name):
        self.name = name
        self.start()

    def start(self):
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self.process = context.Process(target=serve, args=(self.name, theirs), daemon=True)
        self.process.start()

    def ask(self, *request, timeout):
        """The answer, or ('failed', reason) after `timeout` seconds."""
        self.connection.send(request)
        try:
            if self.connection.poll(timeout):
                return self.connection.recv()
            reason = f"longer than {timeout:.0f} s"
        except EOFError:
            reason = "its process died"
        self.stop()
        self.start()
        return "failed", reason

    def must(self, *request, timeout):
        """The answer without its heading; the program ends if there is none."""
        heading, *answer = self.ask(*request, timeout=timeout)
        if heading == "failed":
            raise SystemExit(f"{self.name}, {request[0]}: {answer[0]}")
        return answer

    def stop(self):
        self.process.kill()
        self.process.join()


# -- the comparison ----------------------------------------------------------------------------


def disagreement(result, reference):
    """Greatest deviation, each derivative relative to the greatest component of its order."""
    scale = np.abs(reference).max(axis=tuple(i for i in range(reference.ndim) if i != reference.ndim - 2))
    return float((np.abs(result - reference).max(axis=-1) / scale).max())


def compare(name, ours, theirs, case, options):
    """Build, check and time one peer on one case, in turns with the workbench."""
    row = {"peer": name}
    answer = theirs.ask("build", case, timeout=options.build_limit)
    if answer[0] == "failed":
        return row | {"skipped": answer[1]}
    _, row["build"], row["memory"], single, batch = answer
    reference = options.reference
    row["deviation"] = max(disagreement(single, reference[0]), disagreement(batch, reference[1]))
    if not row["deviation"] < AGREEMENT:
        return row | {"skipped": f"disagrees: {row['deviation']:.1e}"}
    row["layout"] = PEERS[name].layout
    for which, ours_which, count in (("single", "single", 1), ("batch", row["layout"], len(case.batch))):
        times, ratios = [], []
        for _ in range(options.rounds):
            (mine,) = ours.must("time", ours_which, options.budget, timeout=60)
            heading, other = theirs.ask("time", which, options.budget, timeout=60)
            if heading == "failed":
                return row | {"skipped": f"{which} call: {other}"}
            times.append(other / count)
            ratios.append(other / mine)
        row[which] = min(times)
        row[f"{which} ratio"] = statistics.median(ratios)
    return row


def measure_case(joints, order, ours, workers, hopeless, options):
    case = problem(joints, order, options.states)
    build, memory, *options.reference = ours.must("build", case, timeout=options.build_limit)
    own = {"peer": "workbench", "build": build, "memory": memory, "deviation": 0.0}
    count = operations(joints, order) * options.states
    own["of peak"], own["peak"] = ours.must("peak", count, 30 * options.budget, timeout=60)
    if own["of peak"] > 1:
        raise SystemExit(f"{own['of peak']:.0%} of the measured peak: that peak is none")
    own["peak"] /= 1e9
    rounds = []
    for _ in range(max(3, options.rounds)):
        (single,) = ours.must("time", "single", options.budget, timeout=60)
        batches = [
            ours.must("time", name, options.budget, timeout=60)[0] / options.states for name in LAYOUTS
        ]
        rounds.append((single, batches))
    own["single"] = min(single for single, _ in rounds)
    times = np.min([batches for _, batches in rounds], axis=0).tolist()
    rows = [own | {"layout": name, "batch": time} for name, time in zip(LAYOUTS, times, strict=True)]
    for name, worker in workers.items():
        if any(joints >= m and order >= n for m, n in hopeless[name]):
            rows.append({"peer": name, "skipped": "a smaller case took too long"})
            continue
        row = compare(name, ours, worker, case, options)
        if "longer than" in row.get("skipped", ""):
            hopeless[name].append((joints, order))
        rows.append(row)
    return [{"joints": joints, "order": order} | row for row in rows]


def print_case(rows):
    first = rows[0]
    print(
        f"\nm = {first['joints']}, n = {first['order']}: "
        f"{first['of peak']:.0%} of the measured peak of {first['peak']:.0f} GFLOP/s in the batch ({first['layout']})"
    )
    print(f"  {'':18}{'single µs':>10}{'ratio':>8}  {'layout':8}{'batch µs':>8}{'ratio':>8}", end="")
    print(f"{'build s':>9}{'MB':>7}{'deviation':>11}")
    for row in rows:
        if "skipped" in row:
            print(f"  {row['peer']:18}{row['skipped'].splitlines()[0][:70]}")
            continue
        print(
            f"  {row['peer']:18}{row['single'] * 1e6:10.2f}{row.get('single ratio', 1):8.2f}"
            f"  {row['layout']:8}{row['batch'] * 1e6:8.3f}{row.get('batch ratio', 1):8.2f}"
            f"{row['build']:9.2f}{row['memory']:7.0f}{row['deviation']:11.1e}",
            flush=True,
        )


def print_summary(rows):
    """The smallest ratio of each case: the best peer's time over the workbench's; and for the single
    call how much longer it takes than the C code, which needs a compiler."""
    print("\nbest peer's time / workbench's (single: peers that need no C compiler; C code: its single call)")
    cases = sorted({(row["joints"], row["order"]) for row in rows})
    for joints, order in cases:
        here = [r for r in rows if (r["joints"], r["order"]) == (joints, order)]
        for which, layout in (("single", None), *(("batch", name) for name in LAYOUTS)):
            rivals = [
                (r[f"{which} ratio"], r["peer"])
                for r in here
                if f"{which} ratio" in r
                and layout in (None, r["layout"])
                and not (which == "single" and r["peer"] in NEEDS_C_COMPILER)
            ]
            if rivals:
                ratio, peer = min(rivals)
                print(f"  m = {joints:3}, n = {order:2}  {which:6}{layout or '':7}{ratio:8.2f}  ({peer})")
        for row in here:
            if "single ratio" in row and row["peer"] in NEEDS_C_COMPILER:
                more = (here[0]["single"] - row["single"]) * 1e6
                print(
                    f"  m = {joints:3}, n = {order:2}  {'C code':13}{row['single ratio']:8.2f}  (ours - C: {more:+.2f} µs)"
                )


def plot(rows, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    chains = sorted({row["joints"] for row in rows})
    figure, axes = pyplot.subplots(2, len(chains), figsize=(3.2 * len(chains), 6), sharex=True, squeeze=False)
    names = list(dict.fromkeys(row["peer"] for row in rows))
    for column, joints in enumerate(chains):
        for which, axis in zip(("single", "batch"), axes[:, column], strict=True):
            for index, name in enumerate(names):
                points = [
                    (r["order"], r[which] * 1e6)
                    for r in rows
                    if (r["joints"], r["peer"]) == (joints, name)
                    and which in r
                    and r["layout"] == (PEERS[name].layout if name in PEERS else "last")
                ]
                if points:
                    style = {"color": "black", "linewidth": 2} if index == 0 else {"linewidth": 1}
                    axis.plot(*zip(*points, strict=True), marker=".", label=name, **style)
            axis.set_yscale("log")
            axis.set_title(f"{which}, m = {joints}", fontsize=9)
            axis.set_ylabel("µs a state", fontsize=8)
        axes[1, column].set_xlabel("order n", fontsize=8)
    handles = {}
    for axis in axes.flat:
        handles |= dict(zip(*reversed(axis.get_legend_handles_labels()), strict=True))
    figure.legend(handles.values(), handles.keys(), loc="lower center", ncols=5, fontsize=8)
    figure.tight_layout(rect=(0, 0.08, 1, 1))
    figure.savefig(path, dpi=150)


def whole_numbers(text):
    return [int(part) for part in text.split(",")]


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--joints", type=whole_numbers, default=[2, 6, 7, 20, 50])
    parser.add_argument("--orders", type=whole_numbers, default=list(range(1, 11)))
    parser.add_argument("--peers", type=lambda text: text.split(","), default=list(PEERS))
    parser.add_argument("--states", type=int, default=1000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--budget", type=float, default=0.1, help="seconds a measurement")
    parser.add_argument("--build-limit", type=float, default=60.0, help="seconds")
    parser.add_argument("--plot", type=Path, default=Path("chain_derivatives.png"))
    parser.add_argument("--json", type=Path, help="write all figures to this file")
    options = parser.parse_args()
    if unknown := set(options.peers) - set(PEERS):
        parser.error(f"unknown peers {sorted(unknown)}; expected some of {list(PEERS)}")
    return options


def available(names):
    for name in names:
        module = MODULES[name.split()[0]]
        if importlib.util.find_spec(module) is None:
            print(f"{name}: skipped, the Python module {module} is not installed")
        elif name in NEEDS_C_COMPILER and shutil.which("cc") is None:
            print(f"{name}: skipped, there is no C compiler")
        else:
            yield name


def main():
    options = parse()
    print(registers())
    workers = {name: Worker(name) for name in available(options.peers)}
    ours, hopeless, rows = Worker("workbench"), {name: [] for name in workers}, []
    for joints in options.joints:
        for order in options.orders:
            case = measure_case(joints, order, ours, workers, hopeless, options)
            print_case(case)
            rows += case
    for worker in (ours, *workers.values()):
        worker.stop()
    print_summary(rows)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1))
    plot(rows, options.plot)
    print(f"\nplot: {options.plot}")


if __name__ == "__main__":
    main()
