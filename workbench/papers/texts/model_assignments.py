"""Assignment of a model's entries to the claims of its text."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import partial

from workbench.context.claims import Notation
from workbench.core.close_names import did_you_mean
from workbench.core.paper_errors import PaperError
from workbench.papers.texts.text_model import Entry, TextModel, names_of, with_entries
from workbench.source.documents import Display
from workbench.source.rows.chains import Step


@dataclass(frozen=True)
class Placed:
    """A step with the id and the notation of its claim.

    Attributes:
        is_first: Whether the step belongs to the first formula of its display.
    """

    id: str
    display: Display
    step: Step
    notation: Notation
    chain: tuple[str, ...]
    is_first: bool = True


def assigned(
    model: TextModel, placed: Sequence[Placed], displays: Sequence[Display]
) -> dict[str, list[Entry]]:
    """Returns the entries for each claim; an entry for no claim is a fault."""
    assigned: dict[str, list[Entry]] = {}
    for entry in model.entries:
        found = [each for each in placed if means(entry.at, each)]
        if not found:
            model.faults.tell(_nowhere(entry, placed, displays))
        elif model.faults.whole(with_entries(partial(_fits, found=found, placed=placed), [entry])):
            for each in found:
                assigned.setdefault(each.id, []).append(entry)
    return assigned


def _fits(entries: Sequence[Entry], found: Sequence[Placed], placed: Sequence[Placed]) -> bool:
    """True if the entry fits its claims. Raises PaperError if the text has another formula, or several."""
    (entry,) = entries
    _check_printed(entry, found, placed)
    _check_single(entry, found)
    return True


def means(at: str | Display, placed: Placed) -> bool:
    if isinstance(at, Display):
        return placed.display is at
    step, display = placed.step, placed.display
    if (
        at in (placed.id, placed.id.rpartition(".")[0])
        or at in step.labels
        or (step.number and at.strip("()") == step.number)
    ):
        return True
    if at.startswith("line "):
        number = at[5:].strip()
        first, last = display.line, display.source.place(display.end)[0]
        return number.isdecimal() and first <= int(number) <= last
    return at in display.labels


def _nowhere(entry: Entry, placed: Sequence[Placed], displays: Sequence[Display]) -> PaperError:
    known = {*names_of(displays), *(each.id for each in placed)}
    near = get_close_matches(str(entry.at), sorted(known), 1)
    hint = f"; did you mean {near[0]}?" if near else ""
    moved = _same_text(entry, placed)
    if moved is not None:
        hint = f"; the same formula stands at line {moved.display.line}"
    return entry.table.error_at_value(("at",), f"at: the text has no display {entry.at!r} (any more){hint}")


def _same_text(entry: Entry, placed: Sequence[Placed]) -> Placed | None:
    printed = entry.table.text(("printed",))
    if printed is None:
        return None
    return next((each for each in placed if _bare(printed) in _written(each)), None)


def _check_printed(entry: Entry, found: Sequence[Placed], placed: Sequence[Placed]) -> None:
    printed = entry.table.text(("printed",))
    if printed is None or any(_bare(printed) in _written(each) for each in found):
        return
    moved = _same_text(entry, placed)
    hint = f"; the same formula stands at line {moved.display.line}" if moved else ""
    now = found[0].display.latex if len(found) > 1 else found[0].step.spelled()[0]
    raise entry.table.error_at_value(("printed",), f"printed: the text says {_short(now)} there now{hint}")


def _written(placed: Placed) -> set[str]:
    """Returns how a model may quote the formula: as written in the file, or with macros expanded."""
    display = placed.display
    raw = display.source.text[display.start : display.end]
    return {_bare(raw), _bare(display.latex), _bare(placed.step.spelled()[0])}


def _bare(latex: str) -> str:
    return "".join(latex.split()).rstrip(".,;")


def _short(latex: str) -> str:
    text = " ".join(latex.split())
    return text if len(text) <= 80 else f"{text[:79]}…"


def _check_single(entry: Entry, found: Sequence[Placed]) -> None:
    """Raises PaperError for a reading or a correction of more than one step."""
    if len(found) < 2:
        return
    for key in ("reading", "corrected", "fault", "mend"):
        if key in entry.table.value((), dict):
            names = ", ".join(each.id for each in found)
            raise entry.table.error_at_key(
                (key,), f"{key}: {len(found)} steps stand there; name one of {names}"
            )


def unknown_ids(entries: Mapping[str, Sequence[Entry]], ids: Collection[str]) -> Iterator[PaperError]:
    """Yields errors for ids that the model uses and the text does not have."""
    tables = {id(entry): entry.table for group in entries.values() for entry in group}
    for table in tables.values():
        named = [(("inherits", index), name) for index, name in enumerate(table.texts(("inherits",)))]
        by = table.text(("mended_by",))
        for path, name in [*named, *([(("mended_by",), by)] if by else [])]:
            if name not in ids:
                hint = did_you_mean(name, ids)
                message = f"{path[0]}: no claim has the id {name!r}. {hint}".removesuffix(". ")
                yield table.error_at_value(path, message)
