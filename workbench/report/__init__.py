"""Verdicts as documents: JSON, Markdown, HTML and a LaTeX erratum note, from one canonical dictionary.

The rendering libraries load on the first report, not with this package.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

__all__ = ["write_report"]


def write_report(report: Mapping[str, Any], out: Path) -> list[Path]:
    """Write report.json, report.md, report.html and erratum.tex into `out`; see `render.write_report`."""
    from workbench.report import render

    return render.write_report(report, out)
