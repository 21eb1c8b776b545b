r"""Accents for rates in a turning frame: x̊ of a text with ẋ = x̊ + ω × x."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from workbench.papers.drafting.drafted_definitions import Proposed
from workbench.papers.drafting.typefaces import Guess, flat

_ONE = r"(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\?[A-Za-z]+)"
_SPACING = re.compile(r"\s+|\\[,;!:]|[.,]+$|(?<!\\)&")
#: The equation between the rates of a vector in two frames (the transport theorem).
_TWO_RATES = re.compile(
    rf"\\dot(?P<one>{_ONE})=(?P<mark>\\(?:mathring|breve|check))(?P=one)"
    rf"\+(?P<spin>(?:\\[a-z]+)?{_ONE})\\times(?P<other>.+)"
)


def rates_in_turning_frames(
    formulas: Iterable[str], guesses: Mapping[str, Guess], lines: Mapping[str, int]
) -> Iterator[Proposed]:
    """Yields each vector with the accent as its rate less ω × x.

    lines: symbol → line of its first occurrence.
    """
    for mark, spin in _marks(formulas).items():
        accent = re.compile(rf"{re.escape(mark)}\{{(\\?[A-Za-z]+)\}}")
        for name, guess in guesses.items():
            plain = accent.sub(r"\1", name)
            if guess.kind == "vector" and plain != name:
                body = rf"\dot{{{plain}}} - {spin} \times {plain}"
                yield Proposed(name, body, lines.get(name, 1), "the rate in a turning frame", True)


def _marks(formulas: Iterable[str]) -> dict[str, str]:
    """Returns the accents of rates in a turning frame, each with the frame's angular velocity."""
    found: dict[str, str] = {}
    for formula in formulas:
        match = _TWO_RATES.fullmatch(_SPACING.sub("", formula))
        if match is not None and flat(match["one"]) == flat(match["other"]):
            found.setdefault(match["mark"], match["spin"])
    return found
