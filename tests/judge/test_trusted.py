"""Which files a `proved` rests on: those that the judge and the reader reach by imports. The page on trust lists
them; `python tests/judge/test_trusted.py` writes its table anew."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from test_imports import graph, modules

import workbench

ROOT = Path(workbench.__file__).parent
PAGE = ROOT / "guide" / "explanation" / "trust.md"

#: Where a `proved` begins: the judge, the rules for goals, and what reads formulas and definitions.
ENTRANCES = (
    "workbench.judge.kernel.judge",
    "workbench.judge.theorems.prove",
    "workbench.language.reader",
    "workbench.language.defining",
)

#: By folder: what its files do for a `proved`, and what checks that.
CHECKS = {
    "language": (
        "what the formula says",
        "types and weights; the read-back in every report; read ∘ print = 1 and fuzz (tests/language)",
    ),
    "language/typed": ("which terms there are, and which fit together", "the same"),
    "language/grammar": ("what stands in which brackets", "the same"),
    "language/naming": ("which symbol a name means", "the same"),
    "language/elaboration": ("what each form of the notation says", "the same"),
    "language/printing": ("what the read-back shows", "the same"),
    "core": ("codes of reasons, keys of declarations; data only", "tests/judge, tests/papers/test_schema.py"),
    "judge": ("the form of a verdict", "tests/judge"),
    "judge/subject": (
        "what the free quantities are",
        "both engines and Drake's motions on the same parameters (test_engines, tests/drake); mutants",
    ),
    "judge/kernel": (
        "when residuals make a verdict",
        "no second implementation: laws, false and mutated identities, red-team cases, mutants (tests/judge)",
    ),
    "judge/theorems": (
        "which equations make a goal",
        "false goals and wrong proofs for every rule (test_goals, test_sum_rules); every goal and proof of the"
        " chapter tampered with (tests/proofs/test_tampering); mutants",
    ),
    "algebra": ("the first engine's ring", "the second engine, on every proof; mutants"),
    "judge/first": ("the residual is 0", "the second engine, on every proof; mutants"),
    "judge/second": (
        "the residual is 0, again",
        "the first engine, on every proof; Python's integers are made sure of (test_independence); mutants",
    ),
    "judge/evidence": (
        "vetoes and counterexamples only; a wrong point can withhold a `proved`, none can give it",
        "the first engine evaluates counterexamples again; Drake",
    ),
}


def trusted() -> dict[str, list[Path]]:
    """The files by folder, without Drake's, which only veto."""
    edges = graph(modules(ROOT))
    waiting, seen = list(ENTRANCES), set(ENTRANCES)
    while waiting:
        new = edges[waiting.pop()] - seen
        seen |= new
        waiting += new
    files = [ROOT.parent / Path(*name.split(".")).with_suffix(".py") for name in sorted(seen)]
    found: dict[str, list[Path]] = {}
    for path in files:
        folder = path.relative_to(ROOT).parent.as_posix()
        if path.is_file() and folder != "drake":
            found.setdefault(folder, []).append(path)
    return found


def table() -> str:
    rows = ["| files in `workbench/` | what they decide | what checks them |", "|---|---|---|"]
    found = trusted()
    for folder in CHECKS:
        names = ", ".join(path.stem for path in found[folder])
        decides, checks = CHECKS[folder]
        rows.append(f"| `{folder}`: {names} | {decides} | {checks} |")
    return "\n".join(rows)


def test_each_folder_of_what_is_trusted_has_its_row():
    assert set(trusted()) == set(CHECKS)


def test_the_kernel_is_trusted_whole():
    for room in ("subject", "first", "kernel"):
        there = {path for path in (ROOT / "judge" / room).glob("*.py") if path.name != "__init__.py"}
        assert there == set(trusted()[f"judge/{room}"])


def test_the_page_on_trust_lists_what_is_trusted():
    text = PAGE.read_text("utf-8")
    listed = {
        f"{folder}/{name}"
        for folder, names in re.findall(r"^\| `([\w/]+)`: ([^|]+) \|", text, re.MULTILINE)
        for name in names.split(", ")
    }
    assert listed == {f"{folder}/{path.stem}" for folder, paths in trusted().items() for path in paths}


def written(text: str) -> str:
    """The page with the table of today."""
    before, rest = text.split("| files in", 1)
    return before + table() + "\n\n" + rest.split("\n\n", 1)[1]


if __name__ == "__main__":
    PAGE.write_text(written(PAGE.read_text("utf-8")), encoding="utf-8")
