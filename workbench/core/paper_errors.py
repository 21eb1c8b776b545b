"""Errors in files of a user: what was expected, what was found, and where."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

from workbench.core.codes.input_codes import InputCode
from workbench.core.reasons import Reason


class SourceFile(Protocol):
    """A file whose entries can be left out."""

    def without(self, path: KeyPath) -> SourceFile | None: ...


class PaperError(ValueError):
    """A paper that cannot be used. It has the file and, if known, the line and column from 1. For a TOML file
    it also has the entry. latex: the formula that cannot be parsed.   reason: the message with its code."""

    def __init__(
        self,
        file: Path | str | None,
        line: int | None,
        column: int | None,
        message: str,
        toml: SourceFile | None = None,
        path: KeyPath = (),
        latex: str | None = None,
    ) -> None:
        place = ":".join(str(part) for part in (file, line, column) if part is not None)
        super().__init__(f"{place}: {message}" if place else message)
        self.file, self.line, self.column, self.message = file, line, column, message
        self.reason = _reason(message, is_of_entry=bool(path))
        self.toml, self.path, self.latex = toml, path, latex

    @property
    def faults(self) -> Sequence[PaperError]:
        return (self,)

    @property
    def fields(self) -> tuple[object, ...]:
        """File, line, column and message: equal for errors that read the same."""
        return self.file and str(self.file), self.line, self.column, str(self.message)

    def __reduce__(self) -> tuple[object, ...]:
        """Makes the error picklable, so that it can be sent between processes."""
        return PaperError, (self.file, self.line, self.column, self.reason)


def _reason(message: str, is_of_entry: bool) -> Reason:
    if isinstance(message, Reason):
        return message
    if is_of_entry:
        return InputCode.ENTRY_UNUSABLE(complaint=message)
    return InputCode.FILE_UNUSABLE(message=message)


class NoDisplay(PaperError):
    """A text without a displayed formula."""

    def __init__(self, file: Path) -> None:
        super().__init__(file, None, None, InputCode.NO_DISPLAY())

    def __reduce__(self) -> tuple[object, ...]:
        return NoDisplay, (self.file,)


class PaperErrors(PaperError):
    """Several faults of a file; the message is that of the first."""

    def __init__(self, faults: Sequence[PaperError]) -> None:
        first = faults[0]
        super().__init__(first.file, first.line, first.column, first.message)
        self._faults = tuple(faults)

    @property
    def faults(self) -> Sequence[PaperError]:
        return self._faults

    def __reduce__(self) -> tuple[object, ...]:
        return PaperErrors, (self._faults,)


#: Keys and array positions from the top of the file: ("claim", 3, "printed").
KeyPath = tuple[str | int, ...]
