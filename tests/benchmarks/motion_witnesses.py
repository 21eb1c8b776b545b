"""What Drake's motions cost: user seconds of `workbench verify --no-cache` with and without them, side by side.

    uv run python tests/benchmarks/motion_witnesses.py [--rounds N]

Both run in each round, in turn; printed are all seconds, the ratio in each round and its median. User seconds of
all processes, so that what else the machine does counts little.
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
from pathlib import Path
from statistics import median


def user_seconds(*options: str) -> float:
    """Of one cold run with these options, its processes included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    workbench = Path(sys.executable).with_name("workbench")
    subprocess.run([workbench, "verify", "--no-cache", *options], check=True, stdout=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main() -> None:
    parser = argparse.ArgumentParser(description="What Drake's motions cost.")
    parser.add_argument("--rounds", type=int, default=3)
    rounds = parser.parse_args().rounds
    ratios = []
    for _ in range(rounds):
        bare, witnessed = user_seconds("--no-motions"), user_seconds("--motions")
        ratios.append(witnessed / bare)
        print(f"without {bare:6.1f} s   with {witnessed:6.1f} s   ratio {ratios[-1]:.3f}", flush=True)
    print(f"median ratio {median(ratios):.3f}")


if __name__ == "__main__":
    main()
