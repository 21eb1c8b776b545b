"""The reference of the Python API, made from signatures and docstrings."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from importlib import import_module
from typing import Any

import workbench
from workbench.core.callable_package import CallablePackage

FUNCTIONS = ("check", "load", "draft", "judge", "repair", "certify", "report")

#: The packages of numerical kinematics that are public, too: the names in their `__all__`.
PACKAGES = ("kinematics", "drake")

#: The documented members of each class, and where they are defined.
MEMBERS = {
    "Certified": ("statement", "text", "misread", "obstacle", "check"),
    "Checked": ("latex", "verdict", "outcome", "holds", "repair"),
    "CheckedLines": ("holds",),
    "Claim": ("id", "printed", "corrected", "equation", "section", "line"),
    "ClaimResult": ("claim", "verdict", "reading", "corrected", "passed", "fault", "expected"),
    "Counterexample": ("values", "left", "right"),
    "Outcome": (
        *("PROVED", "CONDITIONAL", "REFUTED", "ILL_FORMED"),
        *("DEFINITION", "ARGUED", "PROBABLE", "UNCHECKED"),
    ),
    "Paper": ("title", "claims", "notation", "faults"),
    "PaperError": ("message", "file", "line", "column", "faults"),
    "ReadError": ("line", "column"),
    "Repair": ("proposals", "candidates", "complete"),
    "Robot": (
        "from_urdf",
        "from_file",
        "from_plant",
        "motion",
        "along",
        "evaluator",
        "inverse",
        "inverse_damped",
        "blocks",
        "casadi",
        "to_c",
        "jax",
        "on_objects",
    ),
    "Verdict": ("outcome", "scope", "reason", "hypothesis", "counterexample", "evidence", "read_back"),
}  # fmt: skip


def function_of(name: str) -> Any:
    """Returns the function of a public name, also if the name is that of a callable package."""
    found = getattr(workbench, name)
    return found.called_function() if isinstance(found, CallablePackage) else found


def surface() -> Iterator[str]:
    """Yields the public names with their signatures, as the recorded list has them."""
    for name in FUNCTIONS:
        yield f"{name}{inspect.signature(function_of(name))}"
    for name, members in MEMBERS.items():
        yield from (f"{name}.{member}" for member in members)
    for package in PACKAGES:
        nouns = numerical(package).items()
        yield from sorted(
            f"{package}.{name}{inspect.signature(noun)}" if inspect.isroutine(noun) else f"{package}.{name}"
            for name, noun in nouns
        )


def numerical(package: str) -> dict[str, Any]:
    """Returns the public nouns of a package of numerical kinematics, those of its public modules included."""
    home = import_module(f"workbench.{package}")
    found: dict[str, Any] = {}
    for name in home.__all__:
        noun = getattr(home, name)
        if inspect.ismodule(noun):
            found.update({f"{name}.{each}": getattr(noun, each) for each in noun.__all__})
        else:
            found[name] = noun
    return found


_LEAD = (
    f"What `from workbench import …` gives: {len(FUNCTIONS)} functions and {len(MEMBERS)} classes. Numerical "
    "kinematics stands at the end."
)


def _numerical_pages() -> Iterator[str]:
    """Yields the public names of the packages of numerical kinematics with the first line of each."""
    for package in PACKAGES:
        home = import_module(f"workbench.{package}")
        said = (inspect.getdoc(home) or "").split("\n\n")[0]
        rows = [f"- `{name}`: {_first(noun)}" for name, noun in sorted(numerical(package).items())]
        yield f"## workbench.{package}\n\n{said}\n\n" + "\n".join(rows)


def _first(noun: Any) -> str:
    paragraph = (inspect.getdoc(noun) or "").split("\n\n")[0]
    return " ".join(paragraph.split())


def api_page() -> str:
    """Returns the functions with their docstrings, and the classes with their members."""
    parts = ["# Python API", _LEAD]
    for name in FUNCTIONS:
        function = function_of(name)
        text = inspect.getdoc(function) or ""
        parts.append(f"## {name}\n\n```text\n{name}{inspect.signature(function)}\n\n{text}\n```")
    for name, members in MEMBERS.items():
        said = (inspect.getdoc(getattr(workbench, name)) or "").split("\n\n")[0]
        listed = ", ".join(f"`{member}`" for member in members)
        parts.append(f"## {name}\n\n{' '.join(said.split())}\n\nMembers: {listed}.")
    parts += _numerical_pages()
    return "\n\n".join(parts) + "\n"


def api_site_page() -> str:
    """Returns the same page for Sphinx, by autodoc."""
    parts = ["# Python API", _LEAD]
    for name in FUNCTIONS:
        place = "workbench.check" if name == "check" else f"workbench.app.api.{name}"
        parts.append(f"## {name}\n\n```{{eval-rst}}\n.. autofunction:: {place}\n```")
    for name, members in MEMBERS.items():
        listed = ", ".join(f"`{member}`" for member in members)
        parts.append(
            f"## {name}\n\n```{{eval-rst}}\n.. autoclass:: workbench.{name}\n```\n\nMembers: {listed}."
        )
    parts += _numerical_pages()
    return "\n\n".join(parts) + "\n"
