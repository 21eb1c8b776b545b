"""Files that are written whole, or not at all."""

from __future__ import annotations

import os
from pathlib import Path


def replace_file(path: Path, data: bytes) -> None:
    """Writes a file beside its old content, which it then replaces; the permissions stay. Raises OSError."""
    draft = path.with_name(f".unfinished-{os.getpid()}-{path.name}")
    try:
        draft.write_bytes(data)
        if path.exists():
            draft.chmod(path.stat().st_mode & 0o777)
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)
