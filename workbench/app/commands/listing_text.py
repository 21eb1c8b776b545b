"""The listing of a text on a terminal: summary, errors and warnings with corrections, open displays.

Only marks and changed characters are coloured; without colours the text is the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path

from rich.text import Text

from workbench.app.commands.carets import lines_of, marked_lines, printable
from workbench.core.verdict import Grade
from workbench.report.counterexamples import Against
from workbench.report.listing import Item, Listing, Open
from workbench.source.documents.source_edits import SourceEdit
from workbench.source.typeset.plain_text import in_plain_text, plain_text

MARKS = {Grade.ERROR: "✗", Grade.WARNING: "!", Grade.OK: "✓", Grade.NOTE: "·", Grade.NOT_JUDGED: "?"}
_ASCII = str.maketrans({"✗": "x", "✓": "+", "·": ".", "…": "...", "−": "-", "×": "x", "≠": "!="})
STYLES = {Grade.ERROR: "red", Grade.WARNING: "yellow", Grade.NOT_JUDGED: "bold"}
_GONE, _NEW = "red", "blue"
_WIDTH = 80
_INDENT = 4
#: The most unreadable positions that are shown for one reason.
_MOST_PLACES = 3


def listing_lines(found: Listing, quiet: bool = False, verbose: bool = False) -> Iterator[Text]:
    """Yields the lines of a listing. quiet: errors only, one line each.   verbose: also every display."""
    if quiet:
        yield from (_heading(item) for item in found.items if item.grade is Grade.ERROR)
        return
    yield Text(f"{printable(str(found.file))}: {found.summary}")
    lines_in = cache(lines_of)
    for item in found.items:
        yield Text("")
        yield from item_lines(item, lines_in)
    for group in found.open:
        yield Text("")
        yield from _open_lines(group, lines_in)
    if found.notes:
        yield Text("")
        yield from (Text(note) for note in found.notes)
    if verbose:
        yield from _display_lines(found)


def item_lines(item: Item, lines_in: Callable[[Path], Sequence[str]]) -> Iterator[Text]:
    yield _heading(item)
    if item.edits:
        yield from _diff(item.edits, lines_in)
    else:
        yield from marked_lines(item.span, lines_in(item.span.file), STYLES[item.grade])
    if item.unless:
        yield _indented(in_plain_text(f"unless {'; '.join(item.unless)}"))
    if item.example is not None:
        yield from example_lines(item.example)
    if item.proposal:
        yield _indented(f"Right: {item.proposal}")
    if item.proved:
        yield _indented("The corrected formula is proved.")


def _heading(item: Item) -> Text:
    where = "" if item.name.startswith("line ") else f", line {item.span.line}"
    what = printable(in_plain_text(item.what))
    return Text.assemble((MARKS[item.grade], STYLES[item.grade]), f" {printable(item.name)}{where}: {what}")


def _indented(text: str) -> Text:
    return Text(f"  {printable(text)}")


def _diff(edits: Sequence[SourceEdit], lines_in: Callable[[Path], Sequence[str]]) -> Iterator[Text]:
    """Yields the author's lines before and after the edits, in the order of the text."""
    by_line: dict[tuple[Path, int, int], list[SourceEdit]] = {}
    for edit in edits:
        by_line.setdefault((edit.span.file, edit.span.line, edit.span.end_line), []).append(edit)
    for (file, first, last), own in by_line.items():
        lines = [printable(line) for line in lines_in(file)[first - 1 : last]]
        if not lines:
            continue
        before = [(_flat_column(lines, each.span.line - first, each.span.column),
                   _flat_column(lines, each.span.end_line - first, each.span.end_column), each.new)
                  for each in own]  # fmt: skip
        whole = " ".join(line.strip() if at else line.rstrip() for at, line in enumerate(lines))
        indent = len(whole) - len(whole.lstrip())
        yield _side("-", whole, [(a, b) for a, b, _ in before], _GONE, indent)
        after, marks, shift = whole, [], 0
        for a, b, new in before:
            new = printable(new)
            after = after[: a + shift] + new + after[b + shift :]
            marks.append((a + shift, a + shift + len(new)))
            shift += len(new) - (b - a)
        yield _side("+", after, marks, _NEW, indent)


def _flat_column(lines: Sequence[str], line: int, column: int) -> int:
    """Returns the column in the lines as `_diff` joins them."""
    if line == 0:
        return column - 1
    joined = len(lines[0].rstrip())
    for between in lines[1:line]:
        joined += 1 + len(between.strip())
    last = lines[line]
    return joined + 1 + max(0, column - 1 - (len(last) - len(last.lstrip())))


def _side(sign: str, line: str, marks: Sequence[tuple[int, int]], style: str, indent: int) -> Text:
    """Returns one line of a difference, cut far from the changes."""
    room = _WIDTH - _INDENT - 2
    text = Text(line[indent:])
    for start, end in marks:
        text.stylize(style, start - indent, end - indent)
    first, last = marks[0][0] - indent, marks[-1][1] - indent
    if len(text) > room:
        start = max(0, min(first - (room - (last - first)) // 2, len(text) - room))
        end = min(len(text), start + room)
        cut = text[start:end]
        text = Text.assemble("…" if start else "", cut, "…" if end < len(text) else "")
    return Text.assemble(" " * _INDENT, (sign, style), " ", text)


def example_lines(example: Against) -> Iterator[Text]:
    values = ", ".join(f"{plain_text(name)} = {value}" for name, value in (*example.values, *example.defined))
    rest = ("all else 0" if values else "all symbols 0") if example.rest else ""
    told = ", ".join(part for part in (values, rest) if part)
    yield _indented(f"As printed, with {told}:" if told else "As printed:")
    yield _indented(f"  left side  {example.left}")
    yield _indented(f"  right side {example.right}")


def _open_lines(group: Open, lines_in: Callable[[Path], Sequence[str]]) -> Iterator[Text]:
    names = ", ".join(group.names[:6]) + (f" and {len(group.names) - 6} more" if len(group.names) > 6 else "")
    mark = Text(MARKS[Grade.NOT_JUDGED], style=STYLES[Grade.NOT_JUDGED])
    yield Text.assemble(mark, f" {len(group.names)} not judged: {printable(names)}")
    yield _indented(group.reason)
    for place in group.places[:_MOST_PLACES]:
        yield from marked_lines(place, lines_in(place.file), "")


def _display_lines(found: Listing) -> Iterator[Text]:
    if not found.rows:
        return
    yield Text("")
    yield Text("Displays")
    width = min(32, max(len(row.name) for row in found.rows))
    for row in found.rows:
        line = f" {printable(row.name):<{width}}  {row.word:<10}  {printable(row.remark)}".rstrip()
        yield Text.assemble("  ", (MARKS[row.grade], STYLES.get(row.grade, "")), line)


def in_ascii(text: str) -> str:
    """Returns the text for a terminal whose encoding lacks mathematical signs."""
    return text.translate(_ASCII)
