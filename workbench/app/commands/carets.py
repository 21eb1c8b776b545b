"""Findings on a terminal: the author's line with carets under the faulty characters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from rich.text import Text

from workbench.core.code_labels import suffix
from workbench.core.paper_errors import PaperError
from workbench.core.spans import Span
from workbench.report.findings import fault_finding

_MOST_LINES = 4
_WIDTH = 160


def marked_lines(span: Span, lines: Sequence[str], style: str) -> Iterator[Text]:
    for number in range(span.line, min(span.end_line, span.line + _MOST_LINES - 1) + 1):
        if not 0 < number <= len(lines):
            continue
        line = printable(lines[number - 1])
        start = span.column - 1 if number == span.line else len(line) - len(line.lstrip())
        end = span.end_column - 1 if number == span.end_line else len(line.rstrip())
        shift = max(0, start - _WIDTH // 2) if len(line) > _WIDTH else 0
        line, start, end = line[shift : shift + _WIDTH], start - shift, min(end - shift, _WIDTH)
        yield Text(f"{number:>6} | {line}")
        yield Text.assemble(f"{'':>6} | {' ' * start}", ("^" * max(1, end - start), style))


def faults_text(faults: Sequence[PaperError]) -> str:
    """Returns each fault with its position and a caret."""
    shown = []
    for fault in faults:
        shown.append(f"Error: {printable(str(fault))}{suffix(fault.reason)}")
        if fault.file is not None and fault.column is not None:
            span = fault_finding(fault, Path(fault.file)).span
            shown += [line.plain for line in marked_lines(span, lines_of(span.file), "")]
    return "\n".join(shown)


def printable(text: str) -> str:
    """Returns the text with control characters replaced, one character for each."""
    return "".join(" " if c == "\t" else c if c.isprintable() else "\ufffd" for c in text)


def lines_of(path: Path) -> list[str]:
    """Returns the lines of a text as findings count them; none if it cannot be read."""
    from workbench.source.documents import Source

    try:
        return Source.open(path).text.split("\n")
    except PaperError:
        return []
