"""What stands in a file that somebody named, or one clear error."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from workbench.core.paper_errors import PaperError

_unsaved: ContextVar[Mapping[Path, bytes]] = ContextVar("unsaved", default={})  # noqa: B039


@contextmanager
def unsaved(texts: Mapping[Path, str]) -> Iterator[None]:
    """Within it these files read as the texts, whatever stands on disk: an editor has not saved them yet."""
    token = _unsaved.set({path.resolve(): text.encode("utf-8") for path, text in texts.items()})
    try:
        yield
    finally:
        _unsaved.reset(token)


def file_bytes(path: Path, expected: str, most: int) -> bytes:
    """Raises PaperError for what is no such file, cannot be read, or has more than `most` bytes."""
    fault = None
    buffers = _unsaved.get()
    try:
        if buffers and (buffer := buffers.get(path.resolve())) is not None and len(buffer) <= most:
            return buffer
        if path.is_dir():
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
        fault = "no such file"
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        fault = f"cannot be read: {getattr(error, 'strerror', None) or error}"
    raise PaperError(path, None, None, fault)
