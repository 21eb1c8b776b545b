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
    "workbench.prover.decide.decide",
    "workbench.prover.goals.prove_goal",
    "workbench.language.reader",
    "workbench.language.definition_entries",
)

#: By folder: what its files do for a `proved`, and what checks that.
CHECKS = {
    "core": ("which terms there are, and which fit together; verdicts", "types and weights; tests/language"),
    "core/codes": ("codes of reasons", "tests/core, tests/judge"),
    "language": (
        "what the formula says",
        "types and weights; the read-back in every report; read ∘ print = 1 and fuzz (tests/language)",
    ),
    "language/grammar": ("what stands in which brackets", "the same"),
    "language/naming": ("which symbol a name means", "the same"),
    "language/elaboration": ("what each form of the notation says", "the same"),
    "language/elaboration/operators": ("what sums, integrals, derivatives and extrema say", "the same"),
    "language/printing": ("what the read-back shows", "the same"),
    "language/goals": ("what goals and proofs say", "the same; wrong proofs for every rule (test_goals)"),
    "engines/inventory": (
        "what the free quantities are",
        "both engines and Drake's motions on the same parameters (test_engines, tests/drake); mutants",
    ),
    "prover/decide": (
        "when residuals make a verdict",
        "no second implementation: laws, false and mutated identities, red-team cases, mutants (tests/judge)",
    ),
    "prover/decide/families": ("whether a formula holds for all n", "the same; instances for small n"),
    "prover/goals": (
        "which equations make a goal",
        "false goals and wrong proofs for every rule (test_goals, test_sum_rules); every goal and proof of the"
        " chapter tampered with (tests/proofs/test_tampering); mutants",
    ),
    "algebra": ("the ring of the polynomial engine", "the jet engine, on every proof; mutants"),
    "engines/polynomial": ("the residual is 0", "the jet engine, on every proof; mutants"),
    "engines/jet": (
        "the residual is 0, again",
        "the polynomial engine, on every proof; Python's integers are made sure of (test_independence); mutants",
    ),
    "prover/counterexamples": (
        "vetoes and counterexamples only; a wrong point can withhold a `proved`, none can give it",
        "the polynomial engine evaluates counterexamples again; Drake",
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
    rooms = ("engines/inventory", "engines/polynomial", "prover/decide", "prover/decide/families")
    for room in rooms:
        there = {path for path in (ROOT / room).glob("*.py") if path.name != "__init__.py"}
        assert there == set(trusted()[room])


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
