"""Cache of what was read from paper files, keyed by the files and by the code of the workbench."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from pickle import UnpicklingError
from typing import Any, TypeVar

from workbench.runtime.fingerprint import code_digest, digest
from workbench.runtime.store import Store
from workbench.runtime.stored_objects import packed, unpacked
from workbench.source.toml.toml_file import TomlFile

T = TypeVar("T")


class Kept:
    """Results of reading, in a store; nothing is kept without one."""

    def __init__(self, store: Store | None) -> None:
        self._store = store

    def key(self, what: str, files: Sequence[TomlFile]) -> str:
        """Returns the key of the content of these files, without entries that were removed."""
        said = [(str(file.path), file.places.text, file.data) for file in files]
        return digest(repr((what, said, code_digest(("workbench",), ("lark",)))))

    def get(self, key: str) -> Any:
        with suppress(UnpicklingError, AttributeError, ImportError, TypeError, ValueError):
            if self._store is not None and (data := self._store.get(key)) is not None:
                return unpacked(data)
        return None

    def put(self, key: str, value: Any) -> None:
        if self._store is not None:
            self._store.put(key, packed(value))

    def once(self, what: str, files: Sequence[TomlFile], make: Callable[[], T]) -> T:
        key = self.key(what, files)
        if (value := self.get(key)) is None:
            self.put(key, value := make())
        return value
