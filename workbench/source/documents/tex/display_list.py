"""The displays of a text in order; one that goes on with the one before it is part of it."""

from __future__ import annotations

from dataclasses import replace
from string import whitespace

from workbench.source.documents.tex.displays import Display

#: What may stand between them: also the mark of a quotation in Markdown.
_NOTHING = f"{whitespace}>"

#: What a display begins with that goes on with the last side of the one before it.
_GOES_ON = frozenset({"=", "\\approx", "\\equiv", "\\simeq"})


def add(displays: list[Display], display: Display) -> None:
    """One more display, or more rows of the last one, where it begins with a relation and follows it."""
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
