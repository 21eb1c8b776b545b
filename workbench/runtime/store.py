"""Cache of earlier results on disk. A key contains everything that its result depends on.

A corrupt file, or one of another user, is ignored.
"""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from typing import TypeVar

_MOST = 50_000


class Store:
    """A cache file, created on first use."""

    def __init__(self, file: Path) -> None:
        self._database: sqlite3.Connection | None = None
        with suppress(OSError, sqlite3.Error):
            self._database = _opened(file)

    def get(self, key: str) -> bytes | None:
        """Returns the value of the key; None if it is missing or damaged."""
        if self._database is None:
            return None
        with suppress(sqlite3.Error, TypeError):
            row = self._database.execute("SELECT value, seal FROM kept WHERE key = ?", (key,)).fetchone()
            if row is not None and row[1] == _seal(key, row[0]):
                return row[0]
        return None

    def put(self, key: str, value: bytes) -> None:
        if self._database is not None:
            with suppress(sqlite3.Error), self._database:
                insert = "INSERT OR REPLACE INTO kept (key, value, seal) VALUES (?, ?, ?)"
                self._database.execute(insert, (key, value, _seal(key, value)))

    def close(self) -> None:
        if self._database is not None:
            with suppress(sqlite3.Error), self._database:
                newest = "SELECT max(rowid) FROM kept"
                self._database.execute(f"DELETE FROM kept WHERE rowid <= ({newest}) - ?", (_MOST,))
            self._database.close()
            self._database = None


AnyStore = TypeVar("AnyStore", bound=Store)


@contextmanager
def standard(kind: type[AnyStore]) -> Iterator[AnyStore]:
    """Yields the cache file in the folder WORKBENCH_CACHE, or in the user's cache folder."""
    from platformdirs import user_cache_path

    place = os.environ.get("WORKBENCH_CACHE")
    store = kind((Path(place) if place else user_cache_path("kinematics-workbench")) / "kept.sqlite")
    try:
        yield store
    finally:
        store.close()


def _opened(file: Path) -> sqlite3.Connection | None:
    """Returns the database; replaces a damaged one, and returns None for one of another user."""
    file.parent.mkdir(parents=True, exist_ok=True)
    if file.exists() and hasattr(os, "getuid") and file.stat().st_uid != os.getuid():
        return None
    table = "CREATE TABLE IF NOT EXISTS kept (key TEXT PRIMARY KEY, value BLOB, seal TEXT)"
    for attempt in range(2):
        database = sqlite3.connect(file, timeout=5.0)
        try:
            database.execute("PRAGMA synchronous = OFF")  # entries damaged by a crash are recomputed
            database.execute(table)
            return database
        except sqlite3.OperationalError:  # locked, or the disk is full
            database.close()
            return None
        except sqlite3.DatabaseError:
            database.close()
            if attempt:
                return None
            file.unlink()
    return None


def _seal(key: str, value: bytes) -> str:
    return sha256(key.encode() + b"\n" + value).hexdigest()
