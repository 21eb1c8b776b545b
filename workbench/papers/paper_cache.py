"""Cache of what was read from paper files, keyed by the files and by the code of the workbench."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from pickle import PicklingError, UnpicklingError
from typing import Any, TypeVar

from workbench.runtime.fingerprint import code_digest, digest
from workbench.runtime.store import Store
from workbench.runtime.stored_objects import packed, unpacked
from workbench.source.toml.toml_file import TomlFile

T = TypeVar("T")

_DAMAGE = (UnpicklingError, AttributeError, ImportError, TypeError, ValueError, RecursionError)

#: Hexadecimal digits: 256 slots for newest results.
_SLOT_DIGITS = 2


class Kept:
    """Results of reading, in a store; nothing is kept without one."""

    def __init__(self, store: Store | None) -> None:
        self._store = store

    def key(self, what: str, files: Sequence[TomlFile]) -> str:
        """Returns the key of the content of these files, without entries that were removed."""
        return self.key_of((what, [(str(file.path), file.places.text, file.data) for file in files]))

    def key_of(self, content: Any, rests_on: Sequence[str] = ("lark",)) -> str:
        """Returns the key of what is made of the content, by the workbench and these libraries."""
        return digest(repr((content, code_digest(("workbench",), rests_on))))

    def get(self, key: str) -> Any:
        with suppress(*_DAMAGE):
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

    def newest(self, name: str, key: str, make: Callable[[], T], kind: type[T]) -> T:
        """Returns the result under the key. Only the last one is kept of a name, and of few names in all."""
        slot, mark = f"newest {digest(name)[:_SLOT_DIGITS]}", key.encode()
        data = None if self._store is None else self._store.get(slot)
        if data is not None and data.startswith(mark):
            with suppress(*_DAMAGE):
                if isinstance(value := unpacked(data[len(mark) :]), kind):
                    return value
        value = make()
        if self._store is not None:
            with suppress(PicklingError, RecursionError):
                self._store.put(slot, mark + packed(value))
        return value
