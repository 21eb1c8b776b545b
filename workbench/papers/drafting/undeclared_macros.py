r"""Undeclared macros whose name suggests a bold letter: \bq for \mathbf{q}."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from workbench.language.grammar.parser import parses
from workbench.source.documents import Display

_PREFIXED = re.compile(r"\\(?:bf|bs|bm|bold|vect|vec|mat|vc|b|v|m)([A-Za-z]|[a-z]{2,7}|[A-Z][a-z]{1,6})")
#: Names of fonts in macros.
_FONTS = frozenset({"\\bf", "\\bm", "\\mit", "\\bfseries"})
_COMMAND = re.compile(r"\\([A-Za-z]+)(?![A-Za-z])\*?\s*(\{?)")


def letters_in_bold(displays: Iterable[Display]) -> dict[str, str]:
    """Returns the macros that never take an argument → what they seem to print."""
    found: dict[str, bool] = {}
    for display in displays:
        for match in _COMMAND.finditer(display.latex):
            name = f"\\{match[1]}"
            found[name] = found.get(name, True) and not match[2]
    return dict(_bold(name for name, is_bare in found.items() if is_bare))


def _bold(names: Iterable[str]) -> Iterator[tuple[str, str]]:
    for name in names:
        letter = _PREFIXED.fullmatch(name)
        if letter is None or name in _FONTS or parses(name) or parses(f"{name} x"):
            continue
        if len(letter[1]) == 1:
            yield name, rf"\mathbf{{{letter[1]}}}"
        elif parses(f"\\{letter[1]}"):
            yield name, rf"\boldsymbol{{\{letter[1]}}}"
