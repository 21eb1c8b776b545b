"""Spans: positions in a file of an author."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Span:
    """A range of characters in a file; lines and columns count from 1, the end is exclusive."""

    file: Path
    line: int
    column: int
    end_line: int
    end_column: int
