"""A process that is forked to judge finds the engines imported."""

import subprocess
import sys

SHOWN = """
import sys
from workbench.prover.preload import load_engines
load_engines()
before = set(sys.modules)
from workbench.core.verdict import Outcome
from workbench import check
from workbench.runtime import workers
workers.get_all_start_methods = list
assert check(r"a \\times b = -b \\times a", {"a": "vector", "b": "vector"}).outcome is Outcome.PROVED
rooms = ("workbench.engines.", "workbench.prover.decide.")
print(sorted(name for name in set(sys.modules) - before if name.startswith(rooms)))
"""


def test_no_engine_is_imported_after_preloading() -> None:
    done = subprocess.run([sys.executable, "-c", SHOWN], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n", done.stdout
