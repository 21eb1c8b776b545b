"""What notebooks import from the workbench is public. CI executes them whole; this is the quick check."""

from __future__ import annotations

import ast
import json
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest

from workbench.guide.api_page import PACKAGES

NOTEBOOKS = sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb"))
PUBLIC = ("workbench", *(f"workbench.{name}" for name in PACKAGES))


def parsed(notebook: Path) -> ast.Module:
    """The code of all cells."""
    cells = json.loads(notebook.read_text("utf-8"))["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    lines = "\n".join(code).splitlines()
    return ast.parse("\n".join(line for line in lines if not line.startswith(("%", "!"))))


def private_names(tree: ast.Module) -> Iterator[str]:
    """Yields what the code takes from the workbench that no `__all__` of a public package lists."""
    modules: dict[str, ModuleType] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.startswith("workbench."))
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "workbench":
            for alias in node.names:
                if node.module not in PUBLIC or alias.name not in import_module(node.module).__all__:
                    yield f"{node.module}.{alias.name}"
                elif isinstance(noun := getattr(import_module(node.module), alias.name), ModuleType):
                    modules[alias.asname or alias.name] = noun
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in modules:
            module = modules[node.value.id]
            if not callable(module) and node.attr not in module.__all__:
                yield f"{module.__name__}.{node.attr}"


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_imports_public_names_only(notebook: Path) -> None:
    tree = parsed(notebook)
    assert any(isinstance(node, ast.ImportFrom) for node in ast.walk(tree))
    assert list(private_names(tree)) == []


@pytest.mark.parametrize(
    "code",
    [
        "from workbench.papers.drafting import ingest",
        "from workbench.kinematics import centres",
        "import workbench.drake",
        "from workbench.kinematics import cylindrical_chains as chains\nchains.cross",
    ],
)
def test_private_name_is_noticed(code: str) -> None:
    assert list(private_names(ast.parse(code)))
