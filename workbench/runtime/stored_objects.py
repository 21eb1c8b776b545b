"""Serialization of terms, notations and claims. Unpickling admits these types only."""

from __future__ import annotations

import io
import pickle
import re
from typing import Any

_OURS = tuple(f"workbench.{package}." for package in ("core", "language", "papers", "context", "source"))
_PLAIN = frozenset({
    ("builtins", "range"), ("builtins", "frozenset"), ("builtins", "set"), ("fractions", "Fraction"),
    ("pathlib", "PosixPath"), ("pathlib", "WindowsPath"), ("workbench.runtime.limits", "Budget"),
})  # fmt: skip


def packed(value: Any) -> bytes:
    return pickle.dumps(value, protocol=5)


def unpacked(data: bytes) -> Any:
    """Returns the stored object. Raises UnpicklingError for other types."""
    return _Unpickler(io.BytesIO(data)).load()


class _Unpickler(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        if (module, name) == ("re", "_compile"):
            return re.compile
        if module.startswith(_OURS) or (module, name) in _PLAIN:
            found = super().find_class(module, name)
            if isinstance(found, type) and found.__module__ == module:
                return found
        raise pickle.UnpicklingError(f"{module}.{name} is not kept")
