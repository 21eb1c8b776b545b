"""Which lines of the judge, of the reader or of the text layer no test would miss: a sample of mutants by mutmut.

    uv run --group mutation python tests/mutation.py judge --sample 400
    uv run --group mutation python tests/mutation.py language --sample 100
    uv run --group mutation python tests/mutation.py texts --sample 100 --seed 35

pyproject.toml says which files and which tests are meant by these names. mutmut writes the mutants; all tests run
once, to see which of them calls which function. Each mutant of the sample then gets a process of its own, which runs
the tests of its function, those first that killed others of it, until one fails. A test that takes five times its processor time and
ten seconds more does not end: that is a kill, too. Mutants that only change a message, or what `zip` asserts, are left
out. A mutant that no test notices is printed with its difference; those that `survivors.toml` beside the tests
explains are not tried. One line a file and one a package say how many of the sample were killed, how many are
explained, and of how many.
"""

import argparse
import ast
import difflib
import gc
import json
import os
import random
import resource
import signal
import subprocess
import sys
import time
import tomllib
from collections import Counter, defaultdict
from functools import cache, wraps
from itertools import accumulate, pairwise
from pathlib import Path

import pytest
from mutmut.mutation import trampoline

ROOT = Path("mutants").resolve()

#: Which tests call which function, and how long they take.
STATISTICS = ROOT / "statistics.json"

#: What became of each mutant that was tried.
RESULTS = ROOT / "results.json"

#: The test that killed the last mutant.
KILLER = ROOT / "killer.txt"

SETTINGS = tomllib.loads(Path("pyproject.toml").read_text())["tool"]

#: mutmut with other settings than the file's.
WRITE = """
from pathlib import Path
from mutmut.__main__ import copy_also_copy_files, copy_src_dir, create_mutants
from mutmut.configuration import config
vars(config()).update({0})
Path("mutants").mkdir(exist_ok=True)
copy_src_dir(), copy_also_copy_files(), create_mutants(1)
"""

MEGABYTES = 3000


def functions(path):
    """The original and the mutants of each function of a file that mutmut wrote, by name."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.FunctionDef) and "__mutmut_" in node.name:
            node.decorator_list = []
            yield node.name, node


class Silent(ast.NodeTransformer):
    """Leaves out what no verdict depends on: messages, and `strict`, which asserts that lists are of one length."""

    def visit_Constant(self, node):
        return ast.Constant("message") if isinstance(node.value, str) and " " in node.value else node

    def visit_Raise(self, node):
        node.exc = node.exc.func if isinstance(node.exc, ast.Call) else node.exc
        return node

    def visit_Call(self, node):
        if isinstance(node.func, ast.Name) and node.func.id == "_unchecked":
            node.args = []
        return self.generic_visit(node)

    def visit_keyword(self, node):
        is_message = node.arg == "reason" and isinstance(node.value, ast.Constant | ast.JoinedStr)
        return None if is_message or node.arg == "strict" else self.generic_visit(node)


def mutants_of(path):
    """The names of the mutants of a file that change more than messages."""
    found = {}
    for name, node in functions(path):
        found[name] = ast.dump(Silent().visit(node)).replace(name, "")
    module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for name, text in found.items():
        stem, number = name.split("__mutmut_")
        if number != "orig" and text != found[f"{stem}__mutmut_orig"]:
            yield f"{module}.{name}"


@cache
def functions_of(module):
    return dict(functions(ROOT.joinpath(*module.split(".")).with_suffix(".py")))


def difference(mutant):
    """The lines that a mutant changes."""
    module, _, name = mutant.rpartition(".")
    found = functions_of(module)
    original = found[f"{name.partition('__mutmut_')[0]}__mutmut_orig"]
    lines = [ast.unparse(node).splitlines()[1:] for node in (original, found[name])]
    changes = difflib.unified_diff(*lines, lineterm="", n=0)
    return "\n".join(f"    {line}" for line in changes if not line.startswith(("---", "+++", "@@")))


def place_of(mutant):
    """Such as prover.decide.case.Case.find, without the number of the mutant."""
    module, _, name = mutant.partition("__mutmut_")[0].rpartition(".")
    place = module.removeprefix("workbench.")
    return f"{place}.{name.removeprefix('x_').removeprefix('xǁ').replace('ǁ', '.')}"


def is_of_class(mutant, known):
    """Whether it changes one line, and there `old` at one place into `new`, in what the class is of."""
    lines = [line.strip()[1:] for line in difference(mutant).splitlines()]
    if not place_of(mutant).startswith(known["in"]) or len(lines) != 2:
        return False
    parts = lines[0].split(known["old"])
    changed = (
        known["old"].join(parts[:i]) + known["new"] + known["old"].join(parts[i:])
        for i in range(1, len(parts))
    )
    return lines[1] in changed


def explained(pool, sample, path):
    """Those of the pool that a file explains one by one, and of the sample those that it explains by class.
    Complains of what it says of no mutant."""
    explanations = tomllib.loads(path.read_text())
    said = {(survivor["in"], survivor["change"].strip()) for survivor in explanations["survivor"]}
    places = {place for place, _ in said}
    found = {}
    for mutant in pool:
        if place_of(mutant) in places:
            change = "\n".join(line.strip() for line in difference(mutant).splitlines())
            found[mutant] = place_of(mutant), change
    for stale in said - set(found.values()):
        print(f"{path} explains what is no mutant of {stale[0]}:\n{stale[1]}")
    of_classes = {name for name in sample if any(is_of_class(name, known) for known in explanations["class"])}
    return of_classes | {mutant for mutant, key in found.items() if key in said}


#: The functions that have been called since a test began.
called = set()


def replaceable(mutants):
    """In place of what mutmut writes above each function, which costs more than most of them."""

    def decorated(function):
        @wraps(function)
        def call(*arguments, **named):
            called.add(function)
            return mutants.get("chosen", function)(*arguments, **named)

        return call

    return decorated


def choose(mutant):
    """From here on the mutant is called; also in processes that the tests start."""
    os.environ["MUTANT_UNDER_TEST"] = mutant
    module, _, name = mutant.rpartition(".")
    mutants = vars(sys.modules[module])[f"mutants_{name.partition('__mutmut_')[0]}__mutmut"]
    mutants["chosen"] = mutants[name]


def mutmut_name(function):
    *owner, name = function.__qualname__.split(".")
    return f"{function.__module__}.{f'xǁ{owner[0]}ǁ' if owner else 'x_'}{name}"


def in_fork(run):
    """The exit code of a fork of this process that runs it."""
    process = os.fork()
    if process:
        return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    run()
    os._exit(0)


class Trials:
    """Tries the mutants where pytest would run the tests that it has collected: each in a fork of this process."""

    def __init__(self, names, seconds, minutes, tell):
        self.names, self.seconds, self.minutes, self.tell = names, seconds, minutes, tell
        self.kills = Counter()

    def pytest_runtestloop(self, session):
        if ROOT not in Path(sys.modules["workbench"].__file__).parents:
            raise SystemExit("the tests do not import the mutants")
        items = {item.nodeid: item for item in session.items}
        gc.freeze()  # nothing of it is garbage in a fork
        if not STATISTICS.exists() and (result := in_fork(lambda: self.count(session.items))) != 0:
            raise SystemExit(f"the tests without a mutant ended with {result}; see {KILLER}")
        self.by_function, self.durations = json.loads(STATISTICS.read_text())
        end = time.monotonic() + 60 * self.minutes
        for name in self.names:
            if time.monotonic() > end:
                break
            function = name.partition("__mutmut_")[0]
            known = sorted(self.by_function.get(function, ()), key=lambda test: self.place(function, test))
            until = accumulate((self.durations[test] for test in known), initial=0.0)
            tests = [test for test, spent in zip(known, until, strict=False) if spent < self.seconds]
            start = time.monotonic()
            result = self.outcome(name, [items[test] for test in tests]) if tests else "no test calls it"
            print(f"{time.monotonic() - start:6.1f} s  {len(tests):4} tests  {result:12}  {name}", flush=True)
            self.tell(name, result)
        return True

    def place(self, function, test):
        """First those that have killed most of the function's, then most of all, then the short ones."""
        return -self.kills[function, test], -self.kills[test], self.durations[test]

    def count(self, items):
        """Writes which tests call which function, and the processor time of each."""
        tests, durations = defaultdict(list), {}
        for item, following in pairwise([*items, None]):
            called.clear()
            start = time.process_time()
            item.ihook.pytest_runtest_protocol(item=item, nextitem=following)
            durations[item.nodeid] = time.process_time() - start
            for function in called:
                tests[mutmut_name(function)].append(item.nodeid)
        STATISTICS.write_text(json.dumps([tests, durations]))

    def outcome(self, mutant, items):
        """ "killed", "does not end", "survived" or what else happened, by the tests in a process of their own."""

        def run():
            signal.signal(signal.SIGPROF, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_DATA, (MEGABYTES * 10**6, resource.RLIM_INFINITY))
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, 1), os.dup2(nowhere, 2)
            choose(mutant)
            for item, following in pairwise([*items, None]):
                signal.setitimer(signal.ITIMER_PROF, 5 * self.durations[item.nodeid] + 10)
                item.ihook.pytest_runtest_protocol(item=item, nextitem=following)

        code = in_fork(run)
        if code == 1:
            self.kills.update((KILLER.read_text(), (mutant.partition("__mutmut_")[0], KILLER.read_text())))
        known = {0: "survived", 1: "killed", -signal.SIGPROF: "does not end"}
        return known.get(code, f"ended with {code}")

    def pytest_runtest_logreport(self, report):
        if report.failed:
            KILLER.write_text(report.nodeid)
            os._exit(1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("which", nargs="?", default="judge", choices=SETTINGS["mutation"])
    parser.add_argument("--sample", type=int, default=400, help="mutants, spread over all files")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", default=[""], help="of what begins so, such as kernel.varied")
    parser.add_argument(
        "--again", action="store_true", help="only those of the sample that survived last time"
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=40,
        help="of tests for one mutant; what survives them may be tried again with more",
    )
    parser.add_argument("--minutes", type=float, default=600, help="after which no other mutant is tried")
    parser.add_argument("--more", action="store_true", help="only those of the sample that were never tried")
    parser.add_argument("--as-written", action="store_true", help="the mutants and tests of the last run")
    options = parser.parse_args()
    chosen = SETTINGS["mutation"][options.which]
    tests = chosen["pytest_add_cli_args_test_selection"]
    if not options.as_written:
        subprocess.run([sys.executable, "-P", "-c", WRITE.format(chosen)], check=True)
        STATISTICS.unlink(missing_ok=True)
    files = [path.with_suffix("") for glob in chosen["only_mutate"] for path in ROOT.glob(f"{glob}.meta")]
    pool = sorted(name for path in files for name in mutants_of(path))
    named = [name for name in pool if place_of(name).startswith(tuple(options.only))]
    sample = random.Random(options.seed).sample(named, min(options.sample, len(named)))
    goes_on = options.again or options.more
    results = json.loads(RESULTS.read_text()) if goes_on and RESULTS.exists() else {}
    equal = explained(pool, sample, Path("tests", options.which, "survivors.toml"))
    tried = [name for name in sample if name not in equal]
    left = [name for name in tried if name in results and not is_killed(results[name])]
    new = [name for name in tried if name not in results]
    names = left if options.again else new if options.more else tried

    def tell(name, result):
        results[name] = result
        RESULTS.write_text(json.dumps(results))
        if not is_killed(result):
            print(difference(name), flush=True)

    arguments = [*SETTINGS["mutmut"]["pytest_add_cli_args"], *tests]
    os.chdir(ROOT)
    sys.path.insert(0, str(ROOT))
    os.environ["MUTANT_UNDER_TEST"] = ""
    trampoline.wrap_in_trampoline = replaceable
    quiet = ["--rootdir=.", "-o", "addopts=", "-p", "no:terminal"]
    trials = Trials(names, options.seconds, options.minutes, tell)
    if pytest.main([*quiet, *arguments], plugins=[trials]) != 0:
        raise SystemExit("the tests cannot be collected")
    counts = defaultdict(Counter)
    counted = [name for name in sample if name in equal or name in results]
    for name in counted:
        module = name.rpartition(".")[0]
        what = "explained" if name in equal else "killed" if is_killed(results[name]) else "left"
        for group in (module, module.rpartition(".")[0], "all"):
            counts[group][what] += 1
    print(f"{'':48}  killed  explained  of")
    for group, count in sorted(counts.items(), key=lambda item: (-item[0].count("."), item[0])):
        print(f"{group:48}{count['killed']:8}{count['explained']:11}{count.total():4}")
    killed, rest = counts["all"]["killed"], len(counted) - counts["all"]["explained"]
    print(f"{killed / rest:.1%} of those that are not explained; {len(pool)} mutants in all")


def is_killed(result):
    return result in ("killed", "does not end")


if __name__ == "__main__":
    main()
