"""The texts that a page was started with: reading, watching and saving them, and their models."""

from __future__ import annotations

from pathlib import Path

from workbench.papers import PaperError
from workbench.runtime.atomic_files import replace_file
from workbench.source.documents import texts_in
from workbench.source.toml.file_bytes import file_bytes

#: Bytes of a text that the page takes.
MOST_BYTES = 1_000_000


class Changed(Exception):
    """A file has changed since it was read."""


class PageTexts:
    """The texts that a page may open: one, or those of a folder.

    Attributes:
        folder: No file outside of it is read.
    """

    def __init__(self, path: Path) -> None:
        """Raises PaperError if the text cannot be read, or the folder has none."""
        self._one = None if path.is_dir() else path.name
        self.folder = path.resolve() if path.is_dir() else path.resolve().parent
        if self._one is None:
            texts_in(self.folder)
        else:
            self._path = path.resolve()
            PageFile(self._path, self._one).read()

    @property
    def names(self) -> list[str]:
        """Returns the names of the texts, relative to the folder."""
        if self._one is not None:
            return [self._one]
        return [path.relative_to(self.folder).as_posix() for path in texts_in(self.folder)]

    def open(self, name: str) -> PageFile:
        """Returns a text by its name. Raises PaperError if it is not one of the texts."""
        if name not in self.names:
            raise PaperError(name, None, None, "is not one of the texts of this page")
        path = self._path if self._one is not None else (self.folder / name).resolve()
        if not path.is_relative_to(self.folder):
            raise PaperError(name, None, None, "is outside of the folder of this page")
        return PageFile(path, name)


class PageFile:
    """A text on disk. Line ends and a byte order mark stay as they are when it is saved."""

    def __init__(self, path: Path, name: str) -> None:
        self.path, self.name = path, name

    @property
    def model(self) -> Path:
        return self.path.with_suffix(".toml")

    def read(self) -> tuple[str, str]:
        """Returns the text, and a stamp that changes with it. Raises PaperError."""
        raw = file_bytes(self.path, "a text", MOST_BYTES)
        try:
            text = raw.decode("utf-8-sig")
        except UnicodeDecodeError:
            raise PaperError(self.path, None, None, "is not UTF-8; expected a text in UTF-8") from None
        return text.replace("\r\n", "\n").replace("\r", "\n"), self._stamp()

    def _stamp(self) -> str:
        return _stamp_of(self.path)

    @property
    def model_stamp(self) -> str | None:
        """Returns a stamp that differs for a changed model; None if there is none."""
        try:
            return _stamp_of(self.model)
        except OSError:
            return None

    def save(self, text: str, stamp: str) -> str:
        """Writes the text; returns the new stamp. Raises Changed if the file is not the one that was read,
        and OSError."""
        if self._stamp() != stamp:
            raise Changed(f"{self.name} was changed by another program; nothing was written")
        raw = file_bytes(self.path, "a text", MOST_BYTES)
        mark = b"\xef\xbb\xbf" if raw.startswith(b"\xef\xbb\xbf") else b""
        ends = "\r\n" if b"\r\n" in raw else "\n"
        replace_file(self.path, mark + text.replace("\n", ends).encode("utf-8"))
        return self._stamp()

    def save_model(self, text: str) -> None:
        """Writes the model next to the text. Raises Changed if there is one already, and OSError."""
        if self.model.exists():
            raise Changed(f"{self.model.name} is there already; nothing was written")
        replace_file(self.model, text.encode("utf-8"))


def _stamp_of(path: Path) -> str:
    found = path.stat()
    return f"{found.st_mtime_ns}-{found.st_size}-{found.st_ino}"
