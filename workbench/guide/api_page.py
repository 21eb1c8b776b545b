"""The reference of the Python API, made from signatures and docstrings."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from typing import Any

import workbench
from workbench.core.callable_package import CallablePackage

FUNCTIONS = ("check", "load", "judge", "repair", "report")

#: The documented members of each class, and where they are defined.
MEMBERS = {
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


def api_page() -> str:
    """Returns the functions with their docstrings, and the classes with their members."""
    parts = ["# Python API", "What `from workbench import …` gives: five functions and twelve classes."]
    for name in FUNCTIONS:
        function = function_of(name)
        text = inspect.getdoc(function) or ""
        parts.append(f"## {name}\n\n```text\n{name}{inspect.signature(function)}\n\n{text}\n```")
    for name, members in MEMBERS.items():
        said = (inspect.getdoc(getattr(workbench, name)) or "").split("\n\n")[0]
        listed = ", ".join(f"`{member}`" for member in members)
        parts.append(f"## {name}\n\n{' '.join(said.split())}\n\nMembers: {listed}.")
    return "\n\n".join(parts) + "\n"


def api_site_page() -> str:
    """Returns the same page for Sphinx, by autodoc."""
    parts = ["# Python API", "What `from workbench import …` gives: five functions and twelve classes."]
    for name in FUNCTIONS:
        place = "workbench.check" if name == "check" else f"workbench.app.api.{name}"
        parts.append(f"## {name}\n\n```{{eval-rst}}\n.. autofunction:: {place}\n```")
    for name, members in MEMBERS.items():
        listed = ", ".join(f"`{member}`" for member in members)
        parts.append(
            f"## {name}\n\n```{{eval-rst}}\n.. autoclass:: workbench.{name}\n```\n\nMembers: {listed}."
        )
    return "\n\n".join(parts) + "\n"
