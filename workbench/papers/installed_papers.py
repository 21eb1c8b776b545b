"""Installed papers: the entry points of the group `workbench.papers`."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path

from workbench.context.claims import InstalledPaper
from workbench.core.close_names import did_you_mean
from workbench.core.paper_errors import PaperError

GROUP = "workbench.papers"

#: The installed paper that is used if none is named.
DEFAULT = "chapter"


@cache
def _points() -> Mapping[str, EntryPoint]:
    return {point.name: point for point in entry_points(group=GROUP)}


def installed_names() -> tuple[str, ...]:
    return tuple(sorted(_points()))


def installed(name: str) -> InstalledPaper:
    """Returns the installed paper of that name.

    Raises:
        PaperError: No installed package provides a usable paper of that name.
    """
    point = _points().get(name)
    if point is None:
        known = ", ".join(installed_names()) or "none"
        message = f"no such file, and no installed paper of that name (known: {known})"
        if hint := did_you_mean(name, installed_names()):
            message = f"{message}. {hint}"
        raise PaperError(name, None, None, message)
    try:
        paper = point.load()
    except (ImportError, AttributeError) as error:
        raise PaperError(name, None, None, f"the installed paper does not load: {error}") from error
    if not isinstance(paper, InstalledPaper):
        got = type(paper).__name__
        raise PaperError(name, None, None, f"{point.value}: expected an InstalledPaper, got a {got}")
    return paper


def paper_of(file: Path) -> InstalledPaper:
    """Returns the installed paper that contains `file`; an empty one if none does."""
    name = name_of(file)
    return InstalledPaper(()) if name is None else installed(name)


def name_of(file: Path) -> str | None:
    """Returns the name of the installed paper that contains `file`."""
    place = file.resolve()
    parts = ((name, path) for name in installed_names() for path in installed(name).files)
    return next((name for name, path in parts if path.resolve() == place), None)
