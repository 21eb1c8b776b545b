"""Installed papers: what the entry points of the group `workbench.papers` bring."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path

from workbench.papers.model import InstalledPaper, PaperError

GROUP = "workbench.papers"

#: The installed paper that is meant where none is named.
DEFAULT = "chapter"


def installed_names() -> tuple[str, ...]:
    return tuple(sorted({point.name for point in entry_points(group=GROUP)}))


def installed(name: str) -> InstalledPaper:
    """Raises PaperError if no installed package announces a usable paper of that name."""
    points = list(entry_points(group=GROUP, name=name))
    if not points:
        known = ", ".join(installed_names()) or "none"
        message = f"no such file, and no installed paper of that name (known: {known})"
        raise PaperError(name, None, None, message)
    try:
        paper = points[0].load()
    except (ImportError, AttributeError) as error:
        raise PaperError(name, None, None, f"the installed paper does not load: {error}") from error
    if not isinstance(paper, InstalledPaper):
        got = type(paper).__name__
        raise PaperError(name, None, None, f"{points[0].value}: expected an InstalledPaper, got a {got}")
    return paper


def paper_of(file: Path) -> InstalledPaper:
    """The installed paper that `file` is part of; one without files and theorems if it is part of none."""
    for name in installed_names():
        paper = installed(name)
        if file.resolve() in {path.resolve() for path in paper.files}:
            return paper
    return InstalledPaper(())
