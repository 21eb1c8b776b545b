"""The displays of a text in order. A display that continues the previous one is merged with it."""

from __future__ import annotations

from dataclasses import replace
from string import whitespace

from workbench.source.documents.tex.displays import Display

#: Characters allowed between them, including the quotation mark of Markdown.
_NOTHING = f"{whitespace}>"

#: Relations that, at the beginning of a display, continue the last side of the previous one.
_GOES_ON = frozenset({"=", "\\approx", "\\equiv", "\\simeq"})


def add(displays: list[Display], display: Display) -> None:
    """Appends a display, or its rows to the last display if it directly follows that and begins with a
    relation."""
    first = next((token.text for row in display.rows for token in row.tokens if token.text.strip()), "")
    last = displays[-1] if displays and first in _GOES_ON and displays[-1].source is display.source else None
    if (
        last is None
        or last.latex.rstrip().endswith(".")
        or display.source.text[last.end : display.start].strip(_NOTHING)
    ):
        displays.append(display)
        return
    displays[-1] = replace(
        last,
        end=display.end,
        rows=last.rows + display.rows,
        opaque=last.opaque | display.opaque,
        warnings=last.warnings + display.warnings,
    )
