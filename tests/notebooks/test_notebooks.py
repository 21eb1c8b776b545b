"""The notebooks as files: what a reader needs is there, with what it printed. CI executes them and compares."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).parents[2] / "notebooks").glob("*.ipynb"))
NAMES = [
    "00_start_here",
    "01_a_formula_and_its_verdict",
    "02_acceleration_fields",
    "03_errata_step_by_step",
    "04_drake_reference",
    "05_aronhold_kennedy",
    "06_chains_2C_3C",
    "07_jerk_of_a_robot",
    "08_from_the_printed_line_to_a_theorem",
    "09_my_own_paper",
]
LONGEST_CELL = 80
LONGEST_FUNCTION = 15
LARGEST = 1_000_000  # bytes, with its figures


@pytest.fixture(scope="module", autouse=True)
def with_nbformat() -> None:
    """It builds grammars for three seconds, which only the process needs that tests notebooks."""
    global nbformat
    import nbformat


each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


def cells(path: Path, kind: str) -> list[nbformat.NotebookNode]:
    return [cell for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == kind]


def faults(notebook: nbformat.NotebookNode) -> list[str]:
    """What must not be in a committed notebook."""
    found = []
    for number, cell in enumerate(notebook.cells):
        if not cell.source.strip():
            found.append(f"cell {number} is empty")
        if cell.metadata:
            found.append(f"cell {number} has metadata")
        if cell.cell_type == "code" and cell.execution_count is None:
            found.append(f"cell {number} was not executed")
        if cell.cell_type == "code" and any(out.output_type == "error" for out in cell.outputs):
            found.append(f"cell {number} ends in an error")
        if cell.cell_type == "code" and len(cell.source.splitlines()) > LONGEST_CELL:
            found.append(f"cell {number} is longer than {LONGEST_CELL} lines")
    if not any(cell.get("outputs") for cell in notebook.cells):
        found.append("it shows nothing")
    if notebook.metadata.get("kernelspec", {}).get("name") != "python3":
        found.append("its kernel is not python3")
    if set(notebook.metadata) - {"kernelspec", "language_info"}:
        found.append("it has more metadata than its kernel")
    return found


def uncaptioned_figures(notebook: nbformat.NotebookNode) -> list[int]:
    """The numbers of the cells that show a figure and are not followed by text that begins "*Figure"."""
    after = [*notebook.cells[1:], None]
    return [
        number
        for number, (cell, following) in enumerate(zip(notebook.cells, after, strict=True))
        if cell.cell_type == "code"
        and "plt.show()" in cell.source
        and not (following is not None and following.source.startswith("*Figure "))
    ]


def test_these_notebooks_exist():
    assert [path.stem for path in NOTEBOOKS] == NAMES


@each_notebook
def test_valid_and_executed(path):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert faults(notebook) == []
    assert path.stat().st_size < LARGEST


def _dirty(change) -> nbformat.NotebookNode:
    notebook = nbformat.read(NOTEBOOKS[0], as_version=4)
    change(notebook)
    return notebook


def _end_in_error(notebook):
    code = next(cell for cell in notebook.cells if cell.cell_type == "code")
    code.outputs = [nbformat.v4.new_output("error", ename="E", evalue="e", traceback=[])]


def _forget_count(notebook):
    next(cell for cell in notebook.cells if cell.cell_type == "code").execution_count = None


def _forget_outputs(notebook):
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs = []


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (_end_in_error, "error"),
        (_forget_count, "not executed"),
        (_forget_outputs, "shows nothing"),
        (lambda n: n.cells[1].metadata.update(collapsed=True), "metadata"),
        (lambda n: n.cells.append(nbformat.v4.new_code_cell("")), "empty"),
        (lambda n: n.cells.append(nbformat.v4.new_code_cell("x\n" * 99)), "longer"),
        (lambda n: n.metadata.kernelspec.update(name="julia"), "kernel"),
        (lambda n: n.metadata.update(widgets={}), "more metadata"),
    ],
)
def test_a_dirty_notebook_is_noticed(change, expected):
    assert any(expected in fault for fault in faults(_dirty(change)))


@each_notebook
def test_begins_with_its_numbered_title_and_prose(path):
    first = nbformat.read(path, as_version=4).cells[0]
    title, *prose = first.source.splitlines()
    assert first.cell_type == "markdown"
    assert re.match(rf"# {int(path.stem[:2])}\. \S", title)
    assert len(" ".join(prose).split()) > 30


@each_notebook
def test_each_figure_has_a_caption_and_axes_with_units(path):
    notebook = nbformat.read(path, as_version=4)
    assert uncaptioned_figures(notebook) == []
    figures = [cell.source for cell in cells(path, "code") if "plt.show()" in cell.source]
    numbers = [
        int(number)
        for cell in cells(path, "markdown")
        for number in re.findall(r"^\*Figure (\d+)\.", cell.source, flags=re.MULTILINE)
    ]
    assert numbers == list(range(1, len(figures) + 1))
    code = "\n".join(cell.source for cell in cells(path, "code"))
    labels = re.findall(r"[xyz]?label=f?r?\"([^\"]+)\"", code)
    assert not figures or any(re.search(r", (m|s)\b", label) for label in labels) or "relative" in code


def test_a_figure_without_caption_is_noticed():
    notebook = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell("plt.show()"), nbformat.v4.new_markdown_cell("And so on.")]
    )
    assert uncaptioned_figures(notebook) == [0]
    notebook.cells[1].source = "*Figure 1. What is seen.*"
    assert uncaptioned_figures(notebook) == []


@each_notebook
def test_code_is_python_without_local_paths_or_network(path):
    for cell in cells(path, "code"):
        ast.parse(cell.source)
        assert not re.search(r"https?://|/home/|/tmp/|/root/|^[!%]", cell.source, flags=re.MULTILINE)


@each_notebook
def test_no_function_is_longer_than_a_reader_follows(path):
    functions = [
        node
        for cell in cells(path, "code")
        for node in ast.walk(ast.parse(cell.source))
        if isinstance(node, ast.FunctionDef)
    ]
    lengths = {node.name: node.end_lineno - node.lineno + 1 for node in functions}
    assert {name: length for name, length in lengths.items() if length > LONGEST_FUNCTION} == {}


def pictureless_figures(notebook: nbformat.NotebookNode) -> list[str]:
    """The captions "*Figure n" that do not stand behind a picture."""
    shown, found = False, []
    for cell in notebook.cells:
        if cell.cell_type == "code":
            shown = any("image/png" in out.get("data", {}) for out in cell.outputs)
        for caption in re.findall(r"^\*Figure \d+\.", cell.source, flags=re.MULTILINE):
            found += [] if shown else [caption]
    return found


@each_notebook
def test_each_figure_has_its_picture(path):
    assert pictureless_figures(nbformat.read(path, as_version=4)) == []


def test_a_caption_without_a_picture_is_noticed():
    notebook = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell("plt.show()"), nbformat.v4.new_markdown_cell("*Figure 1. A curve.*")]
    )
    assert pictureless_figures(notebook) == ["*Figure 1."]


@each_notebook
def test_tells_its_time_and_goal_and_ends_with_three_exercises(path):
    first, *_, last = nbformat.read(path, as_version=4).cells
    assert re.search(r"^\*\S+ minutes\b.* Goal: [^*]+\*$", first.source, flags=re.MULTILINE)
    assert last.source.startswith("## Exercises\n")
    assert re.findall(r"^(\d)\. ", last.source, flags=re.MULTILINE) == ["1", "2", "3"]
    assert last.source.count("<details><summary>Answer</summary>") == last.source.count("</details>") == 3


@each_notebook
def test_slider_has_a_static_picture_before_it(path):
    notebook = nbformat.read(path, as_version=4)
    for number, cell in enumerate(notebook.cells):
        if "ipywidgets" in cell.source:
            assert cell.source.startswith("# NBVAL_IGNORE_OUTPUT") and not cell.outputs
            before = notebook.cells[number - 2].outputs
            assert any("image/png" in out.get("data", {}) for out in before)


@each_notebook
def test_verifies_what_it_shows(path):
    code = "\n".join(cell.source for cell in cells(path, "code"))
    assert re.search(r"^\s*assert ", code, flags=re.MULTILINE)
