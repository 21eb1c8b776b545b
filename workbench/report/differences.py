"""What exactly differs between a printed formula and the right one: sign, number, mark, symbol, part."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from workbench.report.glyphs import SPACES
from workbench.report.latex_atoms import Atom, LatexNotTypesettable, atoms_of, latex_of

# Below this share of common atoms a list of differences would be longer than the two formulas.
_RECOGNISABLE = 0.35

_OPENING, _CLOSING = frozenset(("(", "[", r"\{", "{")), frozenset((")", "]", r"\}", "}"))
_MARK_NAMES = r"d{0,4}dot\(|~\(|hat\(|widehat\(|bar\(|overline\(|vec\(|underline\(|\)"

_Sides = tuple[Sequence[Atom], Sequence[Atom]]
_Key = Callable[[Atom], str | None]


@dataclass(frozen=True)
class Change:
    """One place where two formulas differ. kind: sign, number, mark, symbol, part.

    before: what the first formula has there (LaTeX, None if nothing); after: what the second has.
    following: the atom that stands before the place, None at the beginning.
    """

    kind: str
    before: str | None
    after: str | None
    following: str | None


@dataclass(frozen=True)
class Difference:
    """changes, in reading order, and the leaves to mark in each formula (indices into their atoms).

    rewritten: so little is common that no list of changes is given.
    """

    changes: tuple[Change, ...] = ()
    marked_before: frozenset[int] = frozenset()
    marked_after: frozenset[int] = frozenset()
    rewritten: bool = False


def difference(before: str, after: str) -> Difference | None:
    """What differs, or None where one of the formulas cannot be taken apart.

    Bold, italic and upright letters count as the same unless they are all that differs.
    """
    try:
        first, second = (_without_final_stop(atoms_of(latex)) for latex in (before, after))
    except LatexNotTypesettable:
        return None
    by_shape = _compare(first, second, lambda atom: atom.shape)
    if by_shape.changes or by_shape.rewritten:
        return by_shape
    return _compare(first, second, lambda atom: atom.identity)


def _without_final_stop(atoms: list[Atom]) -> list[Atom]:
    while atoms and (atoms[-1].latex in (".", ",", ";") or atoms[-1].latex in SPACES):
        atoms = atoms[:-1]
    return atoms


def _compare(first: list[Atom], second: list[Atom], key: _Key) -> Difference:
    sides = (first, second)
    counted = [[i for i, atom in enumerate(atoms) if key(atom) is not None] for atoms in sides]
    keys = [[key(sides[side][i]) for i in counted[side]] for side in (0, 1)]
    blocks = _unequal_blocks(keys, [[sides[side][i] for i in counted[side]] for side in (0, 1)])
    uncommon = sum(ends[1] - ends[0] + ends[3] - ends[2] for ends in blocks)
    if all(keys) and uncommon > (1 - _RECOGNISABLE) * (len(keys[0]) + len(keys[1])):
        return Difference(rewritten=True)
    changes, marked = [], (set(), set())
    for ends in blocks:
        places = [counted[0][ends[0] : ends[1]], counted[1][ends[2] : ends[3]]]
        for side in (0, 1):
            marked[side].update(_leaves_within(sides[side], places[side]))
        changes.append(_change(sides, places, _preceding(second, counted[1], ends[2])))
    return Difference(tuple(changes), frozenset(marked[0]), frozenset(marked[1]))


def _unequal_blocks(keys: list[list], atoms: list[list[Atom]]) -> list[list[int]]:
    """The cheapest way from the first to the second, as [start, end, start, end], in order.

    Replacing one atom by another of its family costs less than dropping it and adding the other.
    """
    rows, columns = len(keys[0]), len(keys[1])

    def across(row: int, column: int) -> float:
        if keys[0][row] == keys[1][column]:
            return 0.0
        return 1.5 if _are_akin(atoms[0][row], atoms[1][column]) else 2.0

    cost = [[float(row + column) for column in range(columns + 1)] for row in range(rows + 1)]
    for row in range(rows):
        for column in range(columns):
            cost[row + 1][column + 1] = min(
                cost[row][column] + across(row, column),
                cost[row][column + 1] + 1,
                cost[row + 1][column] + 1,
            )
    blocks: list[list[int]] = []
    row, column = rows, columns
    while row or column:
        here, end = cost[row][column], (row, column)
        if row and column and here == cost[row - 1][column - 1] + across(row - 1, column - 1):
            row, column = row - 1, column - 1
            if keys[0][row] == keys[1][column]:
                continue
        elif row and here == cost[row - 1][column] + 1:
            row -= 1
        else:
            column -= 1
        if blocks and (blocks[-1][0], blocks[-1][2]) == end:
            blocks[-1][0], blocks[-1][2] = row, column
        else:
            blocks.append([row, end[0], column, end[1]])
    return blocks[::-1]


def _are_akin(first: Atom, second: Atom) -> bool:
    return first.leaf == second.leaf and first.family == second.family


def _leaves_within(atoms: Sequence[Atom], places: Sequence[int]) -> set[int]:
    """The leaves at the places, and those inside a mark, script or fraction that opens there."""
    leaves = set()
    for place in places:
        end = _closing_of(atoms, place) if _opens(atoms[place]) > 0 else place
        leaves.update(i for i in range(place, end + 1) if atoms[i].leaf)
    return leaves


def _closing_of(atoms: Sequence[Atom], opening: int) -> int:
    depth = 0
    for place in range(opening, len(atoms)):
        depth += _opens(atoms[place])
        if depth == 0:
            return place
    return len(atoms) - 1


def _change(sides: _Sides, places: list[list[int]], following: str | None) -> Change:
    before, after = (_fragment(sides[side], places[side]) for side in (0, 1))
    if not (places[0] and places[1]) and all(
        sides[side][place].is_accent for side in (0, 1) for place in places[side]
    ):
        bare = _fragment(*_content_of(sides[0], places[0]) or _content_of(sides[1], places[1]))
        return Change("mark", before or bare, after or bare, following)
    kind = _kind(*([sides[side][i] for i in places[side]] for side in (0, 1)))
    return Change(kind, before, after, following)


def _content_of(atoms: Sequence[Atom], openings: Sequence[int]) -> tuple | None:
    """What stands under the marks that open at the places."""
    if not openings:
        return None
    return atoms, range(openings[-1] + 1, _closing_of(atoms, openings[-1]))


def _preceding(atoms: Sequence[Atom], counted: Sequence[int], position: int) -> str | None:
    """The symbol or bracket before a place, with its exponents and indices."""
    end = counted[position] if position < len(counted) else len(atoms)
    braces = brackets = 0
    for start in range(end - 1, -1, -1):
        atom = atoms[start]
        braces += _opens(atom)
        brackets += (atom.identity in _OPENING) - (atom.identity in _CLOSING)
        if braces > 0 or brackets > 0:  # the place lies inside what opens here
            break
        if braces == brackets == 0 and (atom.leaf or atom.identity in _OPENING):
            return latex_of(atoms[start:end])
    leaves = [atom for atom in atoms[:end] if atom.leaf]
    return leaves[-1].latex if leaves else None


def _kind(before: Sequence[Atom], after: Sequence[Atom]) -> str:
    either = [*before, *after]
    if all(atom.latex in ("+", "-") for atom in either):
        return "sign"
    if all(atom.leaf and atom.family in ("bin", "rel") for atom in either):
        return "operator"
    if all(atom.latex.isdigit() for atom in either):
        return "number"
    if len(before) == len(after) == 1 and before[0].leaf and after[0].leaf:
        letters = [re.sub(_MARK_NAMES, "", atom.shape or "") for atom in either]
        return "mark" if letters[0] == letters[1] else "symbol"
    return "part"


def _fragment(atoms: Sequence[Atom], places: Sequence[int]) -> str | None:
    """LaTeX from the first to the last of the places, completed to the end of what opens there."""
    if not places:
        return None
    end = max(_closing_of(atoms, place) if _opens(atoms[place]) > 0 else place for place in places)
    text = latex_of(atoms[places[0] : end + 1])
    return "{}" + text if text.startswith(("^", "_")) else text


def _opens(atom: Atom) -> int:
    return 0 if atom.leaf else atom.latex.count("{") - atom.latex.count("}")
