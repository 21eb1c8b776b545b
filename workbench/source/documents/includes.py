"""Includes in a text other than TeX; the included files are not read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

_OF_RST = re.compile(r"(?m)^[ \t]*\.\. include::[ \t]*(?P<name>\S+)")
#: Includes of MyST, mdBook, Quarto, PyMdown and Jekyll.
_OF_MARKDOWN = re.compile(
    r"""(?mx)
    ^[ \t>]*(?:`{3,}|:{3,}|~{3,})\{include\}[ \t]*(?P<name>\S+)
    | \{\{\#include[ \t]+(?P<book>[^\s}:]+)
    | \{\{<[ \t]*include[ \t]+(?P<quarto>\S+)
    | ^[ \t]*--8<--[ \t]+["'](?P<snippet>[^"'\n]+)
    | \{%-?[ \t]*include_relative[ \t]+(?P<relative>\S+)
    """
)


def includes(text: str, suffix: str) -> Iterator[tuple[int, str]]:
    """Yields the offset of each include, and the name of its file."""
    if suffix in (".html", ".htm", ".xhtml"):
        return
    for match in (_OF_RST if suffix == ".rst" else _OF_MARKDOWN).finditer(text):
        yield match.start() + len(match[0]) - len(match[0].lstrip()), next(filter(None, match.groups()))


def unread(path: Path, name: str) -> str:
    """Returns the warning for an included file."""
    is_there = (path.parent / name).is_file() if len(name) < 300 and "\0" not in name else False
    what_to_do = "check that file by itself" if is_there else "there is no such file beside this one"
    return f"{name!r} is included here and not read; {what_to_do}"
