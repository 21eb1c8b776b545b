"""The public Python API: a recorded list of names and signatures, and its docstrings' examples."""

from __future__ import annotations

import doctest
import inspect
import re
from importlib import import_module
from pathlib import Path

import pytest

import workbench
from workbench.app import api
from workbench.guide.api_page import FUNCTIONS, MEMBERS, PACKAGES, function_of, numerical, surface

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "workbench/guide").rglob("*.md"))]
PUBLIC = ("workbench", *(f"workbench.{name}" for name in PACKAGES))
RECORDED = (Path(__file__).parent / "public_api.txt").read_text(encoding="utf-8").splitlines()


def test_surface_is_the_recorded_one() -> None:
    assert list(surface()) == RECORDED


def test_all_lists_functions_and_classes() -> None:
    assert sorted(workbench.__all__) == sorted([*FUNCTIONS, *MEMBERS, "__version__"])


@pytest.mark.parametrize("name", MEMBERS)
def test_members_exist(name: str) -> None:
    noun = getattr(workbench, name)
    known = {*dir(noun), *getattr(noun, "__dataclass_fields__", {}), *_assigned(noun)}
    assert set(MEMBERS[name]) <= known and inspect.getdoc(noun)


def _assigned(noun: type) -> set[str]:
    """The attributes that the class assigns to `self`."""
    lines = [line.partition(" = ")[0] for line in inspect.getsource(noun).splitlines() if "self." in line]
    return {word.strip().removeprefix("self.") for line in lines for word in line.split(",")}


@pytest.mark.parametrize("name", ["repair", "report"])
def test_package_can_be_called(name: str) -> None:
    package = getattr(workbench, name)
    assert inspect.signature(package) == inspect.signature(function_of(name))
    assert package.__name__ == f"workbench.{name}"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_first_line_says_what_is_returned(name: str) -> None:
    first = (inspect.getdoc(function_of(name)) or "").splitlines()[0]
    assert first.startswith(("Returns ", "Writes "))


@pytest.mark.slow
def test_docstring_examples_are_right() -> None:
    for module, least in ((api, 12), (workbench, 2)):
        done = doctest.testmod(module)
        assert done.attempted >= least and done.failed == 0


NUMERICAL = {
    f"{package}.{name}": noun
    for package in PACKAGES
    for name, noun in numerical(package).items()
    if inspect.isroutine(noun)
}


@pytest.mark.parametrize("name", NUMERICAL)
def test_numerical_function_has_a_right_example(name: str) -> None:
    function = inspect.unwrap(NUMERICAL[name])
    runner = doctest.DocTestRunner()
    known = vars(inspect.getmodule(function))
    for example in doctest.DocTestFinder(recurse=False).find(function, name, globs=known):
        runner.run(example)
    assert runner.tries and not runner.failures
    assert (inspect.getdoc(function) or "").startswith("Returns ")


def test_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = workbench.nothing  # type: ignore[attr-defined]


@pytest.mark.parametrize("page", PAGES, ids=[page.stem for page in PAGES])
def test_page_imports_the_public_api_only(page: Path) -> None:
    """Each name that a page imports is in `__all__` of a public package."""
    text = page.read_text(encoding="utf-8")
    for module, names in re.findall(r"\bfrom (workbench[\w.]*) import ([\w, ]+)", text):
        assert module in PUBLIC
        assert {name.strip() for name in names.split(",")} <= set(import_module(module).__all__)
    assert not re.search(r"\bimport workbench\.", text)
