"""The stages of loading: each returns what it could read, and its errors as values.

A stage reads views of files without the entries at fault; `ErrorLog` keeps the errors of all stages.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Generic, TypeVar

from workbench.core.codes.model_codes import ModelCode
from workbench.core.paper_errors import PaperError, PaperErrors
from workbench.core.reasons import Reason
from workbench.runtime import stop_if_asked
from workbench.source.toml.toml_file import TomlFile

T = TypeVar("T")

#: The most errors that are collected.
MOST = 100
#: If one of these keys is faulty, the other keys of the claim are not checked.
_GROUNDS = frozenset({"orders", "reading", "theorem", "goal", "hypothesis", "fault", "formula", "statement"})
_NOTATION = ("symbols", "definitions", "notation", "frames", "points")
_LETTERS = re.compile(r"\\[A-Za-z]+|[^\W_]")


@dataclass(frozen=True)
class Stage(Generic[T]):
    """What one stage of loading could read.

    Attributes:
        value: The value; None if the stage cannot do without a faulty entry.
        errors: The errors, in the order in which they were found.
        omitted: How many of them, from the first, are in an entry that was left out, or in a file that the
            stage itself opened: other errors may follow from them.
    """

    value: T | None
    errors: tuple[PaperError, ...] = ()
    omitted: int = 0

    @property
    def whole(self) -> T | None:
        """The value; None if an entry was left out."""
        return None if self.omitted else self.value


def stage(read: Callable[..., T], *files: TomlFile) -> Stage[T]:
    """Returns what `read` makes of the files, without the entries that it raises PaperError for.

    The files are not changed: `read` gets views of them. Each step leaves out one entry more, so it ends.
    """
    views, errors = files, list[PaperError]()
    while True:
        stop_if_asked()
        try:
            return Stage(read(*views), tuple(errors), len(errors))
        except PaperError as error:
            smaller = [view.without(error.path) if error.toml is view.origin else None for view in views]
            if not any(smaller):
                return Stage(None, (*errors, error), len(errors) + _is_of_another(error, views))
            errors.append(error)
            views = tuple(less or view for less, view in zip(smaller, views, strict=True))


def _is_of_another(error: PaperError, views: Sequence[TomlFile]) -> bool:
    """True for an entry of a file that the stage itself opened, which others may follow from."""
    is_given = any(error.toml is view.origin for view in views)
    return not is_given and error.toml is not None and error.toml.without(error.path) is not None


class ErrorLog(list[PaperError]):
    """The errors of the stages, each once, without those that only follow from another."""

    def __init__(self) -> None:
        super().__init__()
        self._omitted: list[PaperError] = []
        self._told: set[tuple[object, ...]] = set()

    def past(self, done: Stage[T]) -> T | None:
        """Adds the errors of a stage. Returns its value."""
        self._add(done)
        return done.value

    def whole(self, done: Stage[T]) -> T | None:
        """Adds the errors of a stage. Returns its value if no entry was left out."""
        self._add(done)
        return done.whole

    def _add(self, done: Stage[T]) -> None:
        for number, error in enumerate(done.errors):
            self.tell(error)
            if number < done.omitted:
                self._omitted.append(error)

    def need(self, done: Stage[T]) -> T:
        """Adds the errors of a stage. Returns its value; raises PaperError if it has none."""
        made = self.past(done)
        if made is None:
            self.stop()
        assert made is not None, "a stage without a value has an error"
        return made

    def tell(self, error: PaperError) -> None:
        for each in error.faults:
            if each.fields not in self._told and len(self) < MOST and not self._follows(each):
                self.append(each)
                self._told.add(each.fields)

    def stop(self) -> None:
        """Raises PaperError with all collected errors, if there are any."""
        if self:
            raise self[0] if len(self) == 1 else PaperErrors(sorted(self, key=_place))

    def _follows(self, error: PaperError) -> bool:
        return any(_follows(error, known) for known in self._omitted)


def _follows(error: PaperError, omitted: PaperError) -> bool:
    """True if the error may be a consequence of removing an entry: a missing key, a key that depends on it,
    or a formula with a symbol that it declares."""
    path = omitted.path
    while isinstance(path[-1], int):
        path = path[:-1]
    *table, last = path
    key = str(last)
    if error.toml is omitted.toml and list(error.path[: len(table)]) == table:
        missing = _missing_keys(error.message) if len(error.path) == len(table) else ()
        if key in _GROUNDS or _repeats(error, omitted) or get_close_matches(key, missing, 1):
            return True
    is_notation = any(get_close_matches(str(part), _NOTATION, 1, cutoff=0.8) for part in path[:3:2])
    if error.latex is None or not is_notation:
        return False
    declares = table[-1:] and table[-1] in ("symbols", "definitions", "notation")
    return not declares or set(_LETTERS.findall(key)) <= set(_LETTERS.findall(error.latex))


def _repeats(error: PaperError, omitted: PaperError) -> bool:
    """True if two keys of an entry have the same fault: the same reason with the same arguments."""
    one, other = error.message, omitted.message
    if not isinstance(one, Reason) or not isinstance(other, Reason):
        return False
    return (one.code, one.arguments) == (other.code, other.arguments)


def _missing_keys(message: str) -> Sequence[str]:
    """The keys that a message of a model misses in a table."""
    if isinstance(message, Reason) and isinstance(message.code, ModelCode):
        return [str(key) for key in message.arguments.values()]
    return ()


def _place(error: PaperError) -> tuple[str, int, int]:
    return str(error.file), error.line or 0, error.column or 0
