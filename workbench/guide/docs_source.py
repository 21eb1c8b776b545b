"""The source of the site, for Sphinx: `workbench help --site FOLDER` writes it."""

from __future__ import annotations

import re
import shutil
from collections.abc import Sequence
from pathlib import Path

import click

from workbench.guide.api_page import api_site_page
from workbench.guide.contents import PARTS
from workbench.guide.generated import manual
from workbench.guide.pages import Page

#: A mention of another page.
MENTION = re.compile(r"`workbench help ([\w-]+)`")
CONF = """project = "Kinematics workbench"
author = "the kinematics-workbench authors"
copyright = "2026, the kinematics-workbench authors"
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_theme = "alabaster"
myst_heading_anchors = 3
nb_execution_mode = "off"
autodoc_typehints = "none"
highlight_language = "none"
exclude_patterns = ["_build"]
"""


def write_source(out: Path, command_line: click.Group, notebooks: Path | None = None) -> list[Path]:
    """Writes conf.py, the index, all pages and the notebooks to the folder; returns the pages' paths."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "conf.py").write_text(CONF, encoding="utf-8")
    pages = manual(command_line)
    written = []
    for page in pages:
        path = out / page.folder / f"{page.topic}.md"
        path.parent.mkdir(exist_ok=True)
        text = api_site_page() if page.topic == "api" else page.text
        path.write_text(_linked(text, pages), encoding="utf-8")
        written.append(path)
    shown = sorted(notebooks.glob("*.ipynb")) if notebooks is not None else []
    for notebook in shown:
        (out / "notebooks").mkdir(exist_ok=True)
        shutil.copy(notebook, out / "notebooks" / notebook.name)
    (out / "index.md").write_text(_index(pages, shown), encoding="utf-8")
    return written


def _linked(text: str, pages: Sequence[Page]) -> str:
    """Returns the text with each `workbench help TOPIC` as a link to the page."""
    folders = {page.topic: page.folder for page in pages}

    def link(found: re.Match[str]) -> str:
        topic = found[1]
        return f"[{found[0]}](../{folders[topic]}/{topic}.md)" if topic in folders else found[0]

    return MENTION.sub(link, text)


def _index(pages: Sequence[Page], notebooks: Sequence[Path]) -> str:
    parts = ["# Kinematics workbench", "Checks the printed formulas of kinematics texts."]
    for part, folder, _ in PARTS:
        names = [f"{folder}/{page.topic}" for page in pages if page.folder == folder]
        parts += [_toctree(part, names)] if names else []
    if notebooks:
        parts.append(_toctree("Notebooks", [f"notebooks/{path.stem}" for path in notebooks]))
    return "\n\n".join(parts) + "\n"


def _toctree(caption: str, names: Sequence[str]) -> str:
    return "\n".join(["```{toctree}", f":caption: {caption}", ":maxdepth: 1", "", *names, "```"])
