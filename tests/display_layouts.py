"""Displays of known formulas in many layouts, for the tests of the cutter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random

#: Of the form that each layout takes: a side is a list of signed terms.
Side = list[str]
TERMS = [
    "a",
    "b_1",
    r"\dot{c}",
    r"\frac{a}{b}",
    "(a + b)^2",
    r"R^T x",
    r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}",
]


@dataclass(frozen=True)
class Chain:
    """left = sides[0] = sides[1] …"""

    left: Side
    sides: list[Side]

    def steps(self) -> list[str]:
        """The formulas that the chain states, without spaces."""
        all_sides = [plain(self.left), *map(plain, self.sides)]
        return [f"{one}={other}" for one, other in pairwise(all_sides)]


def plain(side: Side) -> str:
    return "".join("".join(side).split())


def some_side(random: Random, may_begin_with_a_sign: bool = True) -> Side:
    sign = "-" if may_begin_with_a_sign and random.random() < 0.3 else ""
    terms = [f"{sign}{random.choice(TERMS)}"]
    return terms + [f"{random.choice('+-')} {random.choice(TERMS)}" for _ in range(random.randrange(3))]


def some_chains(random: Random) -> list[Chain]:
    return [
        Chain(some_side(random), [some_side(random) for _ in range(random.randint(1, 3))])
        for _ in range(random.randint(1, 3))
    ]


def rows_of(chain: Chain, random: Random, sign: str, empty: str, goes_on: str) -> list[str]:
    """The chain in rows: `sign` before a side behind the left one, `empty` for a left cell without a side."""
    rows = [f"{' '.join(chain.left)} {sign}"]
    for at, side in enumerate(chain.sides):
        if at:
            rows.append(f"{empty} {sign}")
        rows[-1] += f" {side[0]}"
        for term in side[1:]:
            breaks = random.random()
            if breaks < 0.2:
                rows.append(f"{goes_on} {term}")
            elif breaks < 0.3:  # the sign at the end of a row, and once more before the next one
                rows[-1] += f" {term[0]}"
                rows.append(f"{goes_on} {term}")
            elif breaks < 0.4:
                rows[-1] += f" {term[0]}"
                rows.append(f"{goes_on} {term[1:]}")
            else:
                rows[-1] += f" {term}"
    return rows


def _in_pairs(opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    def layout(chains: Sequence[Chain], random: Random) -> str:
        rows = [row for chain in chains for row in rows_of(chain, random, "&=", "", "&")]
        return f"{opening} {_joined(rows)} {closing}"

    return layout


def _joined(rows: Sequence[str]) -> str:
    return r" \\ ".join(rows)


def _eqnarray(opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    def layout(chains: Sequence[Chain], random: Random) -> str:
        rows = [row for chain in chains for row in rows_of(chain, random, "&=&", "", "&&")]
        return f"{opening} {_joined(rows)} {closing}"

    return layout


def _at_the_left(opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    """Each chain in a row of its own behind a mark: & A = B."""

    def layout(chains: Sequence[Chain], random: Random) -> str:
        rows = [f"& {' '.join(chain.left)} = {' = '.join(map(' '.join, chain.sides))}" for chain in chains]
        return f"{opening} {_joined(rows)} {closing}"

    return layout


def _one_a_row(opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    """Each chain in a row without marks."""

    def layout(chains: Sequence[Chain], random: Random) -> str:
        rows = [f"{' '.join(chain.left)} = {' = '.join(map(' '.join, chain.sides))}" for chain in chains]
        return f"{opening} {_joined(rows)} {closing}"

    return layout


def _terms_in_columns(opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    """Terms behind further marks: A &= b && + c."""

    def layout(chains: Sequence[Chain], random: Random) -> str:
        rows = []
        for chain in chains:
            for at, side in enumerate(chain.sides):
                left = " ".join(chain.left) if at == 0 else ""
                rows.append(f"{left} &= {' && '.join(side)}")
        return f"{opening} {_joined(rows)} {closing}"

    return layout


def _signs_in_columns(opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    """Each sign in a column of its own: a & + & b & = & c."""

    def layout(chains: Sequence[Chain], random: Random) -> str:
        rows = []
        for chain in chains:
            sides = [chain.left, *chain.sides]
            row = " & = & ".join(" & ".join(_apart(side)) for side in sides)
            rows.append(row)
        return f"{opening} {_joined(rows)} {closing}"

    return layout


def _apart(side: Side) -> list[str]:
    return [side[0], *(part for term in side[1:] for part in (term[0], term[2:]))]


def _environment(name: str, argument: str = "") -> tuple[str, str]:
    return f"\\begin{{{name}}}{argument}", f"\\end{{{name}}}"


def _within(outer: str, name: str, argument: str = "") -> tuple[str, str]:
    opening, closing = _environment(name, argument)
    return f"\\begin{{{outer}}}{opening}", f"{closing}\\end{{{outer}}}"


LAYOUTS: dict[str, Callable[[Sequence[Chain], Random], str]] = {
    "align": _in_pairs(*_environment("align")),
    "align*": _in_pairs(*_environment("align*")),
    "flalign": _in_pairs(*_environment("flalign")),
    "alignat": _in_pairs(*_environment("alignat", "{2}")),
    "split": _in_pairs(*_within("equation", "split")),
    "aligned": _in_pairs(*_within("equation", "aligned")),
    "array{rl}": _in_pairs(*_within("equation", "array", "{rl}")),
    "brace": _in_pairs(r"\[\left\{\begin{aligned}", r"\end{aligned}\right.\]"),
    "dollars": _in_pairs(r"$$\begin{aligned}", r"\end{aligned}$$"),
    "eqnarray": _eqnarray(*_environment("eqnarray")),
    "eqnarray*": _eqnarray(*_environment("eqnarray*")),
    "array{rcl}": _eqnarray(*_within("equation", "array", "{rcl}")),
    "gather": _one_a_row(*_environment("gather")),
    "gathered": _one_a_row(*_within("equation", "gathered")),
    "cases": _one_a_row(*_within("equation", "cases")),
    "align at the left": _at_the_left(*_environment("align")),
    "split at the left": _at_the_left(*_within("equation", "split")),
    "cases at the left": _at_the_left(*_within("equation", "cases")),
    "eqnarray at the left": _at_the_left(*_environment("eqnarray")),
    "alignat in columns": _terms_in_columns(*_environment("alignat", "{4}")),
    "align in columns": _terms_in_columns(*_environment("align")),
    "array in columns": _signs_in_columns(*_within("equation", "array", "{rcrcrcrcr}")),
}
