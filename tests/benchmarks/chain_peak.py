"""The floating-point work of the recursion, the machine's peak, and how wide the engine is."""

import ctypes
import time

import llvmlite.binding as llvm
from numba import config

from workbench.kinematics.simd_lanes import WIDTH


def operations(joints, order):
    """Additions and multiplications that the recursion needs for one state, sines included."""
    terms = order + 1
    pairs = terms * (terms + 1) // 2
    exponential = 4 * (pairs - terms) + 6 + 45  # 45: reduction and polynomials of cos and sin
    product = 16 * pairs - 4 * terms + terms
    step = 24 * terms
    tip_and_base = 14 * terms + 8 * terms
    return (joints - 1) * (exponential + product + step) + tip_and_base + joints * terms


PEAK_SHAPES = [(2, 12), (4, 8), (4, 12), (8, 8), (8, 12), (8, 24)]  # lanes, independent sums


def peak_source(lanes, sums):
    """LLVM code of a loop of multiply-adds x ← a x + b in registers, `sums` of them independent."""
    vector, names = f"<{lanes} x double>", [f"%x{i}" for i in range(sums)]
    constants = ", ".join(["double 0.5"] * lanes)
    steps = [
        f"{name}n = call {vector} @llvm.fma.v{lanes}f64({vector} {name}, {vector} <{constants}>, {vector} <{constants}>)"
        for name in names
    ]
    starts = [f"{name} = phi {vector} [ zeroinitializer, %entry ], [ {name}n, %loop ]" for name in names]
    totals = [f"%t0 = fadd {vector} zeroinitializer, %x0n"]
    totals += [f"%t{i} = fadd {vector} %t{i - 1}, {name}n" for i, name in enumerate(names[1:], 1)]
    return "\n".join(
        [
            f"declare {vector} @llvm.fma.v{lanes}f64({vector}, {vector}, {vector})",
            "define double @spin(i64 %rounds) {",
            "entry:",
            "br label %loop",
            "loop:",
            "%n = phi i64 [ 0, %entry ], [ %next, %loop ]",
            *starts,
            *steps,
            "%next = add i64 %n, 1",
            "%more = icmp ult i64 %next, %rounds",
            "br i1 %more, label %loop, label %end",
            "end:",
            *totals,
            f"%result = extractelement {vector} %t{sums - 1}, i32 0",
            "ret double %result",
            "}",
        ]
    )


def make_peak_works(rounds=2000):
    """A function and its operations a call for each of PEAK_SHAPES: no width suits all processors. They are
    compiled for what Numba compiles for, and no wider than the engine is."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    cpu = config.CPU_NAME or llvm.get_host_cpu_name()
    features = llvm.get_host_cpu_features().flatten() if config.CPU_FEATURES is None else config.CPU_FEATURES
    works = []
    for lanes, sums in [(lanes, sums) for lanes, sums in PEAK_SHAPES if lanes <= WIDTH]:
        machine = llvm.Target.from_default_triple().create_target_machine(cpu=cpu, features=features, opt=2)
        engine = llvm.create_mcjit_compiler(llvm.parse_assembly(peak_source(lanes, sums)), machine)
        engine.finalize_object()
        spin = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_int64)(engine.get_function_address("spin"))
        spin.engine = engine  # its code must live as long
        works.append((lambda spin=spin: spin(rounds), rounds * sums * lanes * 2))
    return works


def least_in_turns(calls, seconds, turn=2e-3):
    """The least seconds of each call, over short turns of all of them for so many seconds: a turn that other
    work disturbs does not count, and all have the same clock and the same neighbours."""
    repeats, least = [], [float("inf")] * len(calls)
    for call in calls:
        call()
        start = time.perf_counter()
        call()
        repeats.append(max(1, int(turn / (time.perf_counter() - start))))
    end = time.perf_counter() + seconds
    while time.perf_counter() < end:
        for i, call in enumerate(calls):
            start = time.perf_counter()
            for _ in range(repeats[i]):
                call()
            least[i] = min(least[i], (time.perf_counter() - start) / repeats[i])
    return least


def share_and_peak(run, count, works, seconds):
    """The share of the measured peak at which `run` does its `count` operations, and the peak in 1/s."""
    own, *others = least_in_turns([run, *(work for work, _ in works)], seconds)
    peak = max(operations / least for (_, operations), least in zip(works, others, strict=True))
    return count / own / peak, peak


def registers():
    """How wide the engine is, and whether somebody has said so instead of the processor."""
    chosen = config.CPU_NAME is not None or config.CPU_FEATURES is not None
    why = "as NUMBA_CPU_NAME and NUMBA_CPU_FEATURES say" if chosen else "of the processor's registers"
    return f"{WIDTH} states at a time, {why}; the processor: {llvm.get_host_cpu_name()}"
