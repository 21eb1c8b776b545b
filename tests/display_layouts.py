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


Rows = Callable[[Sequence[Chain], Random], list[str]]


def _in_pairs(chains: Sequence[Chain], random: Random) -> list[str]:
    return [row for chain in chains for row in rows_of(chain, random, "&=", "", "&")]


def _eqnarray(chains: Sequence[Chain], random: Random) -> list[str]:
    return [row for chain in chains for row in rows_of(chain, random, "&=&", "", "&&")]


def _one_a_row(chains: Sequence[Chain], random: Random) -> list[str]:
    """Each chain in a row without marks."""
    return [f"{' '.join(chain.left)} = {' = '.join(map(' '.join, chain.sides))}" for chain in chains]


def _at_the_left(chains: Sequence[Chain], random: Random) -> list[str]:
    """Each chain in a row of its own behind a mark: & A = B."""
    return [f"& {row}" for row in _one_a_row(chains, random)]


def _terms_in_columns(chains: Sequence[Chain], random: Random) -> list[str]:
    """Terms behind further marks: A &= b && + c."""
    return [
        f"{'' if at else ' '.join(chain.left)} &= {' && '.join(side)}"
        for chain in chains
        for at, side in enumerate(chain.sides)
    ]


def _signs_in_columns(chains: Sequence[Chain], random: Random) -> list[str]:
    """Each sign in a column of its own: a & + & b & = & c."""
    return [
        " & = & ".join(" & ".join(_apart(side)) for side in (chain.left, *chain.sides)) for chain in chains
    ]


def _apart(side: Side) -> list[str]:
    return [side[0], *(part for term in side[1:] for part in (term[0], term[2:]))]


def _environment(name: str, argument: str = "") -> tuple[str, str]:
    return f"\\begin{{{name}}}{argument}", f"\\end{{{name}}}"


def _within(outer: str, name: str, argument: str = "") -> tuple[str, str]:
    opening, closing = _environment(name, argument)
    return f"\\begin{{{outer}}}{opening}", f"{closing}\\end{{{outer}}}"


def _layout(rows: Rows, opening: str, closing: str) -> Callable[[Sequence[Chain], Random], str]:
    return lambda chains, random: " ".join((opening, r" \\ ".join(rows(chains, random)), closing))


LAYOUTS: dict[str, Callable[[Sequence[Chain], Random], str]] = {
    "align": _layout(_in_pairs, *_environment("align")),
    "align*": _layout(_in_pairs, *_environment("align*")),
    "flalign": _layout(_in_pairs, *_environment("flalign")),
    "alignat": _layout(_in_pairs, *_environment("alignat", "{2}")),
    "split": _layout(_in_pairs, *_within("equation", "split")),
    "aligned": _layout(_in_pairs, *_within("equation", "aligned")),
    "array{rl}": _layout(_in_pairs, *_within("equation", "array", "{rl}")),
    "brace": _layout(_in_pairs, r"\[\left\{\begin{aligned}", r"\end{aligned}\right.\]"),
    "dollars": _layout(_in_pairs, r"$$\begin{aligned}", r"\end{aligned}$$"),
    "eqnarray": _layout(_eqnarray, *_environment("eqnarray")),
    "eqnarray*": _layout(_eqnarray, *_environment("eqnarray*")),
    "array{rcl}": _layout(_eqnarray, *_within("equation", "array", "{rcl}")),
    "gather": _layout(_one_a_row, *_environment("gather")),
    "gathered": _layout(_one_a_row, *_within("equation", "gathered")),
    "cases": _layout(_one_a_row, *_within("equation", "cases")),
    "align at the left": _layout(_at_the_left, *_environment("align")),
    "split at the left": _layout(_at_the_left, *_within("equation", "split")),
    "cases at the left": _layout(_at_the_left, *_within("equation", "cases")),
    "eqnarray at the left": _layout(_at_the_left, *_environment("eqnarray")),
    "alignat in columns": _layout(_terms_in_columns, *_environment("alignat", "{4}")),
    "align in columns": _layout(_terms_in_columns, *_environment("align")),
    "array in columns": _layout(_signs_in_columns, *_within("equation", "array", "{rcrcrcrcr}")),
}
