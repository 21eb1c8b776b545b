"""Cache of earlier results on disk. A key contains everything that its result depends on.

A corrupt file, or one of another user, is ignored. A value counts only under the seal of the secret in the
file beside it, which only the user can read.
"""

from __future__ import annotations

import hmac
import os
import secrets
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TypeVar

_MOST = 50_000
_SECRET = 32


class Store:
    """A cache file, created on first use."""

    def __init__(self, file: Path) -> None:
        self._database: sqlite3.Connection | None = None
        self.secret = secrets.token_bytes(_SECRET)
        with suppress(OSError, sqlite3.Error):
            self._database = _opened(file)
            self.secret = _secret_of(file.with_suffix(".secret"))

    def get(self, key: str) -> bytes | None:
        """Returns the value of the key; None if it is missing or damaged."""
        if self._database is None:
            return None
        with suppress(sqlite3.Error, TypeError):
            row = self._database.execute("SELECT value, seal FROM kept WHERE key = ?", (key,)).fetchone()
            if row is not None and row[1] == self._seal(key, row[0]):
                return row[0]
        return None

    def put(self, key: str, value: bytes) -> None:
        if self._database is not None:
            with suppress(sqlite3.Error), self._database:
                insert = "INSERT OR REPLACE INTO kept (key, value, seal) VALUES (?, ?, ?)"
                self._database.execute(insert, (key, value, self._seal(key, value)))

    def close(self) -> None:
        if self._database is not None:
            with suppress(sqlite3.Error), self._database:
                newest = "SELECT max(rowid) FROM kept"
                self._database.execute(f"DELETE FROM kept WHERE rowid <= ({newest}) - ?", (_MOST,))
            self._database.close()
            self._database = None

    def _seal(self, key: str, value: bytes) -> str:
        return hmac.new(self.secret, key.encode() + b"\n" + value, "sha256").hexdigest()


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


def _secret_of(file: Path) -> bytes:
    """Returns the secret in the file, which is made on first use. Raises OSError where there is none."""
    with suppress(FileExistsError):
        draft = file.with_suffix(f".{os.getpid()}-{secrets.token_hex(4)}")
        handle = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        try:
            os.write(handle, secrets.token_bytes(_SECRET))
            os.link(draft, file)
        finally:
            os.close(handle)
            draft.unlink()
    secret = file.read_bytes()
    if len(secret) != _SECRET:
        raise OSError(f"{file}: expected {_SECRET} bytes, got {len(secret)}")
    return secret
