"""Which lines of the kernel and of the engines no test would miss: a sample of mutants by mutmut.

    uv run --group mutation python tests/mutation.py --sample 400

Mutants that only change the wording of a message are left out. A mutant that no test notices is printed
with its difference; one line a file says how many of the sample were killed.
"""

import argparse
import ast
import json
import random
import subprocess
from collections import Counter
from pathlib import Path

ROOT = Path("mutants")

#: Which test calls which function; mutmut writes it once all mutants are written, before it looks for a name.
STATISTICS = ROOT / "mutmut-stats.json"


def functions(path):
    """The original and the mutants of each function of a file that mutmut wrote, by name."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.FunctionDef) and "__mutmut_" in node.name:
            yield node.name, node


def is_wording(original, mutant):
    """Whether the two differ by strings with a space in them alone, which are messages."""

    def without_messages(node):
        text = ast.dump(node)
        for constant in ast.walk(node):
            if (
                isinstance(constant, ast.Constant)
                and isinstance(constant.value, str)
                and " " in constant.value
            ):
                text = text.replace(repr(constant.value), "message")
        return text.replace(mutant.name, original.name)

    return without_messages(original) == without_messages(mutant)


def mutants_of(path):
    found = dict(functions(path))
    module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for name, node in found.items():
        stem, number = name.split("__mutmut_")
        if number != "orig" and not is_wording(found[f"{stem}__mutmut_orig"], node):
            yield f"{module}.{name}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sample", type=int, default=400, help="mutants, spread over all files")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--again", action="store_true", help="only the survivors of the last run")
    options = parser.parse_args()
    mutmut = ["mutmut", "run", "--max-children", "1"]
    if not STATISTICS.exists():
        subprocess.run([*mutmut, "no.such.mutant"], check=False, stderr=subprocess.DEVNULL)
    if not STATISTICS.exists():
        raise SystemExit("mutmut did not find which test calls which function: see what it printed above")
    files = sorted(path.with_suffix("") for path in ROOT.glob("workbench/judge/*/*.py.meta"))
    pool = [name for path in files for name in mutants_of(path)]
    names = random.Random(options.seed).sample(pool, min(options.sample, len(pool)))
    if options.again:
        names = [name for name in names if verdicts(files).get(name) != "killed"]
    subprocess.run([*mutmut, *names], check=False)
    results, total = verdicts(files), Counter()
    for name in names:
        if results[name] != "killed":
            subprocess.run(["mutmut", "show", name], check=False)
    for path in files:
        module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        count = Counter(results[name] for name in names if name.startswith(module + "."))
        total += count
        print(f"{module:48}{count['killed']:5} of {count.total():4}")
    print(f"{'all':48}{total['killed']:5} of {total.total():4}  ({len(pool)} mutants in all)")


def verdicts(files):
    """What became of each mutant that was tried: a test that fails or does not end has killed it."""
    codes = {}
    for path in files:
        codes |= json.loads(path.with_name(path.name + ".meta").read_text())["exit_code_by_key"]
    survived = (0, 5, 33, None)  # all passed, no test collected, no test calls it, not tried
    return {name: "survived" if code in survived else "killed" for name, code in codes.items()}


if __name__ == "__main__":
    main()
