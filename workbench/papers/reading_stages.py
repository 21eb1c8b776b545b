"""Collection of all errors in a file: a faulty entry is removed, and reading continues."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from typing import TypeVar

from workbench.core.codes.model_codes import ModelCode
from workbench.core.paper_errors import PaperError, PaperErrors
from workbench.core.reasons import Reason

T = TypeVar("T")

#: The most errors that are collected.
MOST = 100
#: If one of these keys is faulty, the other keys of the claim are not checked.
_GROUNDS = frozenset({"orders", "reading", "theorem", "goal", "hypothesis", "fault", "formula", "statement"})
_NOTATION = ("symbols", "definitions", "notation", "frames", "points")
_LETTERS = re.compile(r"\\[A-Za-z]+|[^\W_]")


class Faults(list[PaperError]):
    """A list of errors without duplicates and without errors that only follow from others."""

    def __init__(self) -> None:
        super().__init__()
        self._aside: list[PaperError] = []

    def past(self, make: Callable[[], T], whole: bool = False) -> T | None:
        """Returns the result of `make` with the faulty entries removed.

        Returns None if `make` fails without them, or if an entry was removed and `whole` is set.
        """
        put_back: list[Callable[[], None]] = []
        met: set[str] = set()
        try:
            while len(put_back) < MOST:
                try:
                    made = make()
                    return None if whole and put_back else made
                except PaperError as error:
                    self.tell(error)
                    if error.toml is None or str(error) in met:
                        return None
                    met.add(str(error))
                    undo = error.toml.set_aside(error.path)
                    if undo is None:
                        return None
                    put_back.append(undo)
                    self._aside.append(error)
            return None
        finally:
            for undo in reversed(put_back):
                undo()

    def need(self, make: Callable[[], T]) -> T:
        """What `make` gives without the entries at fault. Raises PaperError where it cannot do without."""
        made = self.past(make)
        if made is None:
            self.stop()
        assert made is not None, "nothing is made, and no fault is told"
        return made

    def tell(self, error: PaperError) -> None:
        for each in error.faults:
            is_told = any(str(each) == str(known) for known in self)
            if not is_told and len(self) < MOST and not self._follows(each):
                self.append(each)

    def stop(self) -> None:
        """Raises PaperError with all collected errors, if there are any."""
        if self:
            raise self[0] if len(self) == 1 else PaperErrors(sorted(self, key=_place))

    def _follows(self, error: PaperError) -> bool:
        return any(_follows(error, known) for known in self._aside)


def _follows(error: PaperError, aside: PaperError) -> bool:
    """True if the error may be a consequence of removing an entry: a missing key, a key that depends on it,
    or a formula with a symbol that it declares."""
    path = aside.path
    while isinstance(path[-1], int):
        path = path[:-1]
    *table, last = path
    key = str(last)
    if error.toml is aside.toml and list(error.path[: len(table)]) == table:
        missing = _missing_keys(error.message) if len(error.path) == len(table) else ()
        if key in _GROUNDS or error.message == aside.message or get_close_matches(key, missing, 1):
            return True
    is_notation = any(get_close_matches(str(part), _NOTATION, 1, cutoff=0.8) for part in path[:3:2])
    if error.latex is None or not is_notation:
        return False
    declares = table[-1:] and table[-1] in ("symbols", "definitions", "notation")
    return not declares or set(_LETTERS.findall(key)) <= set(_LETTERS.findall(error.latex))


def _missing_keys(message: str) -> Sequence[str]:
    """The keys that a message of a model misses in a table."""
    if isinstance(message, Reason) and isinstance(message.code, ModelCode):
        return [str(key) for key in message.arguments.values()]
    return ()


def _place(error: PaperError) -> tuple[str, int, int]:
    return str(error.file), error.line or 0, error.column or 0
