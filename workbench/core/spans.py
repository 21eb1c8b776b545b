"""Positions in a file of an author."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Span:
    """The author's own characters: lines and columns from 1, the end is behind the last character."""

    file: Path
    line: int
    column: int
    end_line: int
    end_column: int
