"""Contents of a file that a user named, or one clear error."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from workbench.core.codes.input_codes import InputCode
from workbench.core.paper_errors import PaperError

_unsaved: ContextVar[Mapping[Path, bytes]] = ContextVar("unsaved", default={})  # noqa: B039
_folder: ContextVar[Path | None] = ContextVar("folder", default=None)


@contextmanager
def within(folder: Path | None) -> Iterator[None]:
    """Within it no file outside of the folder is read, whatever a text or a link says; None: no limit."""
    token = _folder.set(folder.resolve() if folder is not None else None)
    try:
        yield
    finally:
        _folder.reset(token)


def may_be_read(path: Path) -> bool:
    """True unless the file is outside of the folder of `within`."""
    folder = _folder.get()
    return folder is None or path.resolve().is_relative_to(folder)


@contextmanager
def unsaved(texts: Mapping[Path, str]) -> Iterator[None]:
    """Makes these files read as the texts within the context: an editor has not saved them yet."""
    token = _unsaved.set({path.resolve(): text.encode("utf-8") for path, text in texts.items()})
    try:
        yield
    finally:
        _unsaved.reset(token)


def file_bytes(path: Path, expected: str, most: int) -> bytes:
    """Returns the contents. Raises PaperError if the file is missing, unreadable, forbidden, or larger than
    `most` bytes."""
    fault = None
    buffers = _unsaved.get()
    try:
        if buffers and (buffer := buffers.get(path.resolve())) is not None and len(buffer) <= most:
            return buffer
        if not may_be_read(path):
            fault = "is outside of the folder of the text, and is not read here"
        elif path.is_dir():
            fault = f"is a directory; expected {expected}"
        elif path.exists() and not path.is_file():
            fault = f"is not a regular file; expected {expected}"
        else:
            with path.open("rb") as stream:
                raw = stream.read(most + 1)
            if len(raw) <= most:
                return raw
            fault = f"is larger than {most:,} bytes"
    except FileNotFoundError:
        fault = InputCode.FILE_NOT_FOUND()
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        fault = f"cannot be read: {getattr(error, 'strerror', None) or error}"
    raise PaperError(path, None, None, fault)
