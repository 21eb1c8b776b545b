"""Errors in files of a user: what was expected, what was got, and where."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol


class Entries(Protocol):
    """A file that can be read without one of its entries."""

    def set_aside(self, path: KeyPath) -> Callable[[], None] | None: ...


class PaperError(ValueError):
    """A paper that cannot be used: the file and, where the fault has one, the line and column, from 1. Of a
    TOML file also the entry; `latex`: the formula there that cannot be read."""

    def __init__(
        self,
        file: Path | str | None,
        line: int | None,
        column: int | None,
        message: str,
        toml: Entries | None = None,
        path: KeyPath = (),
        latex: str | None = None,
    ) -> None:
        place = ":".join(str(part) for part in (file, line, column) if part is not None)
        super().__init__(f"{place}: {message}" if place else message)
        self.file, self.line, self.column, self.message = file, line, column, message
        self.toml, self.path, self.latex = toml, path, latex

    @property
    def faults(self) -> Sequence[PaperError]:
        return (self,)

    def __reduce__(self) -> tuple:
        """So that it can come from another process."""
        return PaperError, (self.file, self.line, self.column, self.message)


class PaperErrors(PaperError):
    """Several faults at once; it speaks of the first."""

    def __init__(self, faults: Sequence[PaperError]) -> None:
        first = faults[0]
        super().__init__(first.file, first.line, first.column, first.message)
        self._faults = tuple(faults)

    @property
    def faults(self) -> Sequence[PaperError]:
        return self._faults

    def __reduce__(self) -> tuple:
        return PaperErrors, (self._faults,)


#: Keys and array positions from the top of the file: ("claim", 3, "printed").
KeyPath = tuple[str | int, ...]
