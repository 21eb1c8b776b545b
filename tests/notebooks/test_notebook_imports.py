"""What notebooks import from the workbench exists. CI executes them whole; this is the quick check."""

from __future__ import annotations

import ast
import json
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb"))


def imports(notebook: Path) -> Iterator[tuple[str, str]]:
    """Yields (module, name) of each import from the workbench."""
    for cell in json.loads(notebook.read_text("utf-8"))["cells"]:
        lines = [line for line in "".join(cell["source"]).splitlines() if not line.startswith(("%", "!"))]
        if cell["cell_type"] == "code":
            for node in ast.walk(ast.parse("\n".join(lines))):
                if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("workbench"):
                    yield from ((str(node.module), alias.name) for alias in node.names)


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_imports_of_notebook_exist(notebook: Path) -> None:
    for module, name in imports(notebook):
        try:
            assert hasattr(import_module(module), name), f"{module}.{name}"
        except AssertionError:
            import_module(f"{module}.{name}")
