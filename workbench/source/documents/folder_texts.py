"""The texts of a folder."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from pathlib import Path

from workbench.core.paper_errors import PaperError
from workbench.source.documents.read_text import SUFFIXES, TEX_SUFFIXES
from workbench.source.documents.tex.tex_files import FROM_FOLDER, INCLUDING
from workbench.source.documents.tex.tex_tokens import COMMENT

#: The number of texts that one folder may hold.
MOST_TEXTS = 5000
_IN_PLACE = "|".join(sorted(set(INCLUDING) - set(FROM_FOLDER)))
_INCLUDED = re.compile(
    rf"\\(?:{'|'.join(FROM_FOLDER)})\s*\{{(?P<folder>[^{{}}]*)\}}\s*\{{(?P<there>[^{{}}]+)\}}"
    rf"|\\(?:{_IN_PLACE})\b\s*(?:\{{(?P<named>[^{{}}]+)\}}|(?P<bare>[^\s{{}}\\]+))"
)


def texts_in(folder: Path) -> list[Path]:
    """Returns the texts below a folder, in order, without the parts that another text includes.

    Hidden folders and links are left out. Raises PaperError if there is no text, or too many.
    """
    found = sorted(_texts_below(folder))
    if len(found) > MOST_TEXTS:
        raise PaperError(folder, None, None, f"holds {len(found):,} texts; expected at most {MOST_TEXTS:,}")
    parts: set[Path] = set()
    while new := {part for path in found for part in _named_by(path, folder, parts)} - parts:
        parts |= new
    texts = [path for path in found if path.resolve() not in parts]
    if not texts:
        raise PaperError(folder, None, None, f"holds no text; expected {', '.join(sorted(SUFFIXES))}")
    return texts


def _texts_below(folder: Path) -> Iterator[Path]:
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        for name in names:
            path = Path(place, name)
            if not name.startswith(".") and path.suffix.lower() in SUFFIXES and not path.is_symlink():
                yield path


def _named_by(path: Path, folder: Path, parts: Collection[Path]) -> Iterator[Path]:
    """Yields the files that a TeX file names: from its own folder, or, for a part, from one above it."""
    try:
        text = path.read_text("utf-8", errors="replace") if path.suffix.lower() in TEX_SUFFIXES else ""
    except OSError:
        return
    own = path.resolve()
    above = [parent for parent in own.parents if parent.is_relative_to(folder.resolve())]
    for match in _INCLUDED.finditer(COMMENT.sub("", text)):
        name = "".join(part for part in match.groups() if part).strip().strip('"')
        for place in above if own in parts else above[:1]:
            for suffix in ("", ".tex"):
                part = (place / f"{name}{suffix}").resolve()
                if part != own:
                    yield part
