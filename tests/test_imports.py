"""Imports run in one direction: no circles, no layer that knows one above it, no `proofs` in the engine."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import workbench

ROOT = Path(workbench.__file__).parent

#: What a part of the engine may import: the parts before it.
LAYERS = (
    ("core",),
    ("runtime", "language", "algebra"),
    ("source", "drake"),
    ("engines",),
    ("kinematics", "context"),
    ("prover",),
    ("repair",),
    ("papers",),
    ("report", "certificates"),
    ("guide",),
    ("app",),
    ("__main__",),
)

#: The same inside of a part. The two engines stand beside each other: neither imports the other.
ROOMS = {
    "engines": (("inventory",), ("polynomial", "jet")),
    "prover": (
        ("counterexamples", "motions"),
        ("decide",),
        ("goals", "preload"),
        ("results",),
        ("explain",),
    ),
    "certificates": (
        ("coqc", "emission"),
        ("handwritten", "reading", "values"),
        ("theorem",),
        ("generalized", "disequations"),
        ("certified_forms",),
        ("goals", "refutation"),
        ("steps",),
        ("certify",),
    ),
}


@cache
def modules(root: Path) -> Mapping[str, str]:
    """The source of each module of a package, by its dotted name."""
    found = {}
    for path in sorted(root.rglob("*.py")):
        parts = path.relative_to(root.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path.read_text("utf-8")
    return found


def imported(source: str, package: str) -> Iterator[str]:
    """The names that a module of the package imports anywhere: in functions and for type checkers only, too."""
    for level, origin, names in _import_statements(source):
        outer = package.split(".")[: len(package.split(".")) + 1 - level] if level else []
        yield from (".".join([*outer, *origin, name]) for name in names)


@cache
def _import_statements(source: str) -> list[tuple[int, list[str], list[str]]]:
    """(dots before it, from where, what) of each import."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import | ast.ImportFrom):
            level, module = getattr(node, "level", 0), getattr(node, "module", None)
            found.append((level, [module] if module else [], [alias.name for alias in node.names]))
    return found


def graph(sources: Mapping[str, str]) -> dict[str, set[str]]:
    """Module → the modules it imports, with the packages that are initialized on the way to them."""
    edges = {}
    for module, source in sources.items():
        edges[module] = set()
        is_package = any(other.startswith(f"{module}.") for other in sources)
        for name in imported(source, module if is_package else module.rpartition(".")[0]):
            parts = name.split(".")
            packages = (".".join(parts[:end]) for end in range(1, len(parts) + 1))
            edges[module] |= {p for p in packages if p in sources and not f"{module}.".startswith(f"{p}.")}
    return edges


def circle(edges: Mapping[str, set[str]]) -> list[str]:
    """The modules of one circle; none if there is no circle."""
    try:
        TopologicalSorter(edges).prepare()
    except CycleError as error:
        return error.args[1]
    return []


def part(module: str, root: str = "workbench") -> str:
    """The part of a package in which a module stands; "" for the package itself and for what is outside."""
    return module.removeprefix(f"{root}.").split(".")[0] if module.startswith(f"{root}.") else ""


def upward(
    edges: Mapping[str, set[str]], layers: tuple[tuple[str, ...], ...] = LAYERS, root: str = "workbench"
) -> list[str]:
    """Imports of a part that stands beside or above."""
    level = {name: height for height, names in enumerate(layers) for name in names}
    return [
        f"{module} imports {other}"
        for module, others in edges.items()
        for other in others
        if part(module, root) not in ("", part(other, root))
        and part(other, root)
        and level[part(module, root)] <= level[part(other, root)]
    ]


def test_no_module_imports_itself_in_the_end() -> None:
    assert circle(graph(modules(ROOT))) == []


def test_each_file_name_occurs_once() -> None:
    names = Counter(path.name for path in ROOT.rglob("*.py"))
    assert {name for name, count in names.items() if count > 1} <= {"__init__.py"}


def test_no_file_is_longer_than_400_lines() -> None:
    lengths = {
        str(path.relative_to(ROOT)): path.read_text("utf-8").count("\n") for path in ROOT.rglob("*.py")
    }
    assert {name: length for name, length in lengths.items() if length > 400} == {}


def test_no_room_has_more_than_25_files() -> None:
    here = Path(__file__).parent
    sizes = Counter(path.parent for root in (ROOT, here) for path in root.rglob("*.py"))
    assert {str(room): size for room, size in sizes.items() if size > 25} == {}


def test_each_package_says_what_it_is() -> None:
    first = {
        path: ast.get_docstring(ast.parse(path.read_text("utf-8"))) for path in ROOT.rglob("__init__.py")
    }
    assert [str(path) for path, docstring in first.items() if not docstring] == []
    questions = ("What is this?", "When do I come here?", "What may it import?", "What checks it?")
    rooms = {
        path.parent.name: " ".join((said or "").split())
        for path, said in first.items()
        if path.parent.parent == ROOT
    }
    assert [room for room, said in rooms.items() if not all(each in said for each in questions)] == []


def test_names_of_tests_have_60_characters_at_most() -> None:
    names = {
        name
        for path in Path(__file__).parent.rglob("test_*.py")
        for name in re.findall(r"def (test_\w+)", path.read_text("utf-8"))
    }
    assert {name for name in names if len(name) > 60} == set()


def test_no_part_of_the_engine_imports_one_beside_or_above_it() -> None:
    sources = modules(ROOT)
    assert {part(module) for module in sources} - {""} == {name for names in LAYERS for name in names}
    assert upward(graph(sources)) == []


@pytest.mark.parametrize("room", ROOMS)
def test_no_room_imports_one_beside_or_above_it(room: str) -> None:
    sources = modules(ROOT)
    root = f"workbench.{room}"
    assert {part(module, root) for module in sources} - {""} == {n for names in ROOMS[room] for n in names}
    assert upward(graph(sources), ROOMS[room], root) == []


def test_pipeline_imports_no_command_and_no_server() -> None:
    edges = {
        m: others for m, others in graph(modules(ROOT)).items() if m.startswith("workbench.app.pipeline.")
    }
    assert edges
    above = {
        other for others in edges.values() for other in others if part(other, "workbench.app") != "pipeline"
    }
    assert {other for other in above if other.startswith("workbench.app.")} == set()


def test_terms_and_symbols_know_no_reading() -> None:
    knows = {m for m, others in graph(modules(ROOT)).items() for o in others if ".language.elaboration" in o}
    language = {m for m in knows if m.startswith("workbench.language.") and ".elaboration." not in m}
    assert language == {"workbench.language.reader"}


def test_an_engine_that_imports_the_other_is_detected() -> None:
    name = "workbench.engines.polynomial.polynomial_engine"
    sources = {"workbench.engines.jet.jets": f"from {name} import value\n", name: ""}
    assert upward(graph(sources), ROOMS["engines"], "workbench.engines") == [
        f"workbench.engines.jet.jets imports {name}"
    ]


def test_the_engine_knows_no_paper() -> None:
    outside = {name.split(".")[0] for source in modules(ROOT).values() for name in imported(source, "")}
    assert not outside & {"proofs", "tests"}


LATE = "def f():\n    from workbench.prover.b import g\n"
FOR_TYPES = "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from workbench.prover import b\n"


@pytest.mark.parametrize(
    "back",
    [
        LATE,
        FOR_TYPES,
        "import workbench.prover.b\n",
        "from . import b\n",
        "from .b import g\n",
        "from ..prover.b import g\n",
    ],
)
def test_a_hidden_circle_is_detected(back: str) -> None:
    sources = {"workbench.prover.a": back, "workbench.prover.b": "from workbench.prover.a import f\n"}
    assert set(circle(graph(sources))) == set(sources)


@pytest.mark.parametrize(
    ("module", "other"), [("language", "algebra"), ("prover", "report"), ("engines", "kinematics")]
)
def test_an_import_of_a_sibling_or_higher_module_is_detected(module: str, other: str) -> None:
    name = f"workbench.{other}.x"
    sources = {f"workbench.{module}.y": f"def f():\n    from {name} import z\n", name: ""}
    assert upward(graph(sources)) == [f"workbench.{module}.y imports {name}"]
