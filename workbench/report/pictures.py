"""Plots of the residuals of errors on simulated motions: one of all errors, and one over time for each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from math import ceil, floor, log10

from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.motion_summary import Course, courses_of, percent
from workbench.report.erratum.error_rows import ErrorRow
from workbench.report.mixed_prose import power_of_ten

#: The value at which a residual of 0 is plotted.
LEAST = 1e-17

_WIDTH, _LEFT, _RIGHT, _ROW = 520, 98, 44, 19
_SPARK_WIDTH, _SPARK_HEIGHT = 150, 34


def spark_line(result: ClaimResult) -> str | None:
    """Returns an SVG of both residuals over time, without axes; None if no motion has both forms."""
    courses, cost = courses_of(result.verdicts), result.on_motions.error
    if courses is None or cost is None:
        return None
    values = [max(r, LEAST) for course in courses for r in course.residuals if r is not None]
    scale = _Scale(log10(min(values)), log10(max(values)), _SPARK_HEIGHT - 4, 4)
    words = (
        f"Along the motion: as printed off by up to {percent(cost.false)}, "
        f"as corrected by less than {cost.right:.0e}"
    )
    curves = "".join(
        f'<polyline class="{look}" points="{points}"/>'
        for look, course in zip(("bad", "good"), courses, strict=True)
        for points in _points(course, scale)
    )
    size = f'viewBox="0 0 {_SPARK_WIDTH} {_SPARK_HEIGHT}" width="{_SPARK_WIDTH}" height="{_SPARK_HEIGHT}"'
    return f'<svg class="spark" {size} role="img" aria-label="{escape(words)}">{curves}</svg>'


def all_errors(rows: Sequence[ErrorRow]) -> str | None:
    """Returns an SVG of each error's residual as printed and as corrected, on one logarithmic axis.

    Returns None if no motion shows an error.
    """
    shown = [row for row in rows if row.cost is not None]
    if not shown:
        return None
    costs = [row.cost for row in shown if row.cost is not None]
    lowest = floor(min(log10(max(cost.right, LEAST)) for cost in costs) / 4) * 4
    highest = max(0, ceil(max(log10(cost.false) for cost in costs)))
    scale = _Scale(lowest, highest + 0.3, _LEFT, _WIDTH - _RIGHT)
    bottom = 12 + _ROW * len(shown)
    least, most = min(cost.false for cost in costs), max(cost.false for cost in costs)
    described = (
        f"As printed the two sides differ by {percent(least)} to {percent(most)}; "
        f"as corrected by less than {max(cost.right for cost in costs):.0e}."
    )
    title = "Difference of the two sides of each error on a simulated motion, as printed and as corrected"
    middle, below = (_LEFT + _WIDTH - _RIGHT) / 2, bottom + 31
    parts = [
        f'<svg viewBox="0 0 {_WIDTH} {bottom + 37}" role="img" aria-labelledby="pic-t pic-d">',
        f'<title id="pic-t">{title}</title><desc id="pic-d">{escape(described)}</desc>',
        *_decades(scale, lowest, highest, bottom),
        *(_dumbbell(row, scale, 12 + _ROW * index) for index, row in enumerate(shown)),
        f'<text class="ax" x="{middle:g}" y="{below}" text-anchor="middle">'
        "relative difference of the two sides, log scale</text></svg>",
    ]
    return "".join(parts)


class _Scale:
    """A scale from decades to positions on the page."""

    def __init__(self, lowest: float, highest: float, start: float, end: float) -> None:
        self.lowest, self.span = lowest, max(highest - lowest, 1e-9)
        self.start, self.length = start, end - start

    def __call__(self, residual: float) -> float:
        share = (log10(max(residual, LEAST)) - self.lowest) / self.span
        return round(self.start + min(max(share, 0), 1) * self.length, 1)


def _decades(scale: _Scale, lowest: int, highest: int, bottom: int) -> Iterator[str]:
    for decade in range(lowest, highest + 1, 4):
        x = scale(10.0**decade)
        name = "1 (100 %)" if decade == 0 else power_of_ten(decade)
        yield f'<line class="grid" x1="{x}" x2="{x}" y1="4" y2="{bottom}"/>'
        yield f'<text class="ax" x="{x}" y="{bottom + 15}" text-anchor="middle">{name}</text>'


def _dumbbell(row: ErrorRow, scale: _Scale, y: int) -> str:
    assert row.cost is not None
    good, bad = scale(row.cost.right), scale(row.cost.false)
    return (
        f'<a href="#{row.anchor}"><text class="lab" x="{_LEFT - 24}" y="{y + 4}" text-anchor="end">'
        f'{escape(row.label)}</text><line class="span" x1="{good}" x2="{bad}" y1="{y}" y2="{y}"/>'
        f'<circle class="good" cx="{good}" cy="{y}" r="4"/>'
        f'<path class="bad" d="M{bad - 4:g} {y - 4}l8 8m0 -8l-8 8"/></a>'
    )


def _points(course: Course, scale: _Scale) -> Iterator[str]:
    """Yields the polylines of the time intervals in which the residual is known."""
    first, last = min(course.times), max(course.times)
    run: list[str] = []
    for time, residual in zip(course.times, course.residuals, strict=True):
        if residual is not None:
            x = 2 + (time - first) / ((last - first) or 1) * (_SPARK_WIDTH - 4)
            run.append(f"{x:.1f},{scale(residual):.1f}")
        elif run:
            yield " ".join(run)
            run = []
    if run:
        yield " ".join(run)
