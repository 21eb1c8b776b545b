"""`workbench verify` without remembered verdicts: this tree beside another one, such as a checkout of an
earlier commit.

    python tests/benchmarks/cold_verify.py ../earlier --rounds 3
    python tests/benchmarks/cold_verify.py ../earlier 45-70

The trees take turns on all cores, each in a process of its own with this Python; a ratio is the median over the
rounds of the other tree's time over this one's. Claims about which the trees say something else are named.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).parents[2]
VERIFY = """
import sys
try:
    from workbench.app.commands.commands import main
except ImportError:  # before there were rooms
    from workbench.app.commands import main
if "--no-cache" not in {option for each in main.commands["verify"].params for option in each.secondary_opts}:
    sys.argv.remove("--no-cache")  # before verdicts were remembered
sys.argv[0] = "workbench"
main()
"""


def verify(tree, select):
    """(seconds, processor seconds of all processes, verdicts by claim)."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-c", VERIFY, "verify", "--no-cache", "--json", *select],
        cwd=tree,
        env={**os.environ, "PYTHONPATH": str(tree)},
        capture_output=True,
        text=True,
    )
    seconds, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{tree}: {done.stderr}")
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    claims = json.loads(done.stdout)["claims"]
    return seconds, spent, {claim["id"]: claim["verdict"] for claim in claims}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("other", type=Path, help="the other tree")
    parser.add_argument("select", nargs="*", help="claims, as for `workbench verify`")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_intermixed_args()
    rounds = []
    for number in range(options.rounds):
        *ours, said = verify(HERE, options.select)
        *theirs, told = verify(options.other.resolve(), options.select)
        differing = sorted(name for name in said.keys() & told.keys() if said[name] != told[name])
        rounds.append((ours, theirs))
        print(
            f"round {number + 1}: {len(said)} claims in {ours[0]:.1f} s ({ours[1]:.1f} s of processor time); "
            f"{len(told)} there in {theirs[0]:.1f} s ({theirs[1]:.1f} s)",
            flush=True,
        )
    if differing:
        print(f"another verdict there: {', '.join(differing)}")
    for place, name in enumerate(("time", "processor time")):
        ratios = [theirs[place] / ours[place] for ours, theirs in rounds]
        print(
            f"{name}: there / here {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"
        )


if __name__ == "__main__":
    main()
