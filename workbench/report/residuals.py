"""How far a formula is off over time, as printed and as corrected: a small picture without a script."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from math import ceil, floor, log10

from workbench.verify.on_motions import Course, courses_of, percent
from workbench.verify.results import ClaimResult

WIDTH, HEIGHT = 360, 150
LEFT, RIGHT, TOP, BOTTOM = 46, 8, 18, 30

#: What a residual of 0 is shown as.
LEAST = 1e-17

_FORMS = (("as printed", "#b3261e", ""), ("as corrected", "#1b6e3a", "4 2"))


def residuals_svg(result: ClaimResult) -> str | None:
    """Inline SVG of both residuals over the size of the sides, on a logarithmic scale, over the time of the
    motion; None for a claim that has not both (see `Witnessed.error`). It has a title and a description for
    those who do not see it, no script, no link and no id, so that it can stand in several places of a page.
    """
    courses, cost = courses_of(result.verdicts), result.on_motions.error
    if courses is None or cost is None:
        return None
    values = [max(r, LEAST) for course in courses for r in course.residuals if r is not None]
    plot = _Plot(courses[0].times, floor(log10(min(values))), ceil(log10(max(values))))
    title = f"Equation {result.claim.equation or result.claim.id} on {cost.motion}"
    description = (
        f"Difference of the two sides over their size, against time. As printed it is largest at "
        f"t = {cost.time:g} s, {percent(cost.false)}; corrected it is there below {cost.right:.0e}."
    )
    body = "".join((*plot.axes(), *_curves(plot, courses), *_legend()))
    return (
        f'<svg class="residuals" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'aria-label="{escape(f"{title}. {description}")}" xmlns="http://www.w3.org/2000/svg">'
        f"<title>{escape(title)}</title><desc>{escape(description)}</desc>"
        f'<g font-family="sans-serif" font-size="9" fill="currentColor">{body}</g></svg>'
    )


class _Plot:
    """Places on the page: times across, decades up."""

    def __init__(self, times: Sequence[float], lowest: int, highest: int) -> None:
        self.first, self.last = min(times), max(times)
        self.lowest, self.highest = lowest, max(highest, lowest + 1)

    def x(self, time: float) -> float:
        return round(LEFT + (time - self.first) / (self.last - self.first) * (WIDTH - LEFT - RIGHT), 1)

    def y(self, residual: float) -> float:
        share = (log10(max(residual, LEAST)) - self.lowest) / (self.highest - self.lowest)
        return round(HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM), 1)

    def axes(self) -> Iterator[str]:
        step = max(1, (self.highest - self.lowest) // 4)
        for decade in range(self.highest, self.lowest - 1, -step):
            height = self.y(10.0**decade)
            yield f'<path d="M{LEFT} {height}H{WIDTH - RIGHT}" stroke="currentColor" stroke-opacity=".2"/>'
            yield f'<text x="{LEFT - 4}" y="{height + 3}" text-anchor="end">{_decade(decade)}</text>'
        for time in (self.first, (self.first + self.last) / 2, self.last):
            yield f'<text x="{self.x(time)}" y="{HEIGHT - BOTTOM + 12}" text-anchor="middle">{time:g}</text>'
        middle = (LEFT + WIDTH - RIGHT) / 2
        yield f'<text x="{middle}" y="{HEIGHT - 6}" text-anchor="middle">t in s</text>'


def _curves(plot: _Plot, courses: Sequence[Course]) -> Iterator[str]:
    for course, (_, colour, dashes) in zip(courses, _FORMS, strict=True):
        for run in _runs(course.times, course.residuals):
            points = " ".join(f"{plot.x(time)},{plot.y(residual)}" for time, residual in run)
            yield (
                f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.5"'
                f' stroke-dasharray="{dashes}"/>'
            )


def _runs(times: Sequence[float], residuals: Sequence[float | None]) -> Iterator[list[tuple[float, float]]]:
    """Stretches of time at which the residual can be told."""
    run: list[tuple[float, float]] = []
    for time, residual in zip(times, residuals, strict=True):
        if residual is None:
            if run:
                yield run
            run = []
        else:
            run.append((time, residual))
    if run:
        yield run


def _legend() -> Iterator[str]:
    for place, (name, colour, dashes) in enumerate(_FORMS):
        x = LEFT + 110 * place
        line = f'stroke="{colour}" stroke-width="1.5" stroke-dasharray="{dashes}"'
        yield f'<path d="M{x} 8h18" {line}/><text x="{x + 22}" y="11">{name}</text>'


def _decade(decade: int) -> str:
    if decade == 0:
        return "100 %"
    return "1 %" if decade == -2 else f"1e{decade}"
