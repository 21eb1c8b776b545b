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
    """One place where two formulas differ. kind: sign, operator, bracket, number,
    exponent, index, mark, symbol, part.

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
    units = [_units(atoms, key) for atoms in sides]
    keys = [[_keys(sides[side][slice(*unit)], key) for unit in units[side]] for side in (0, 1)]
    blocks = _unequal_blocks(*keys)
    changes, marked = [], (set(), set())
    for ends in blocks:
        spans = [_span(units[0][ends[0] : ends[1]]), _span(units[1][ends[2] : ends[3]])]
        for side, leaves in enumerate(_leaves_that_differ(sides, spans, key)):
            marked[side].update(leaves)
        start = units[1][ends[2]][0] if ends[2] < len(units[1]) else len(second)
        parts = [sides[side][slice(*spans[side])] for side in (0, 1)]
        changes.append(Change(_kind(*parts), *(_fragment(part) for part in parts), _preceding(second, start)))
    leaves = sum(atom.leaf for atom in (*first, *second))
    if all(keys) and len(marked[0]) + len(marked[1]) > (1 - _RECOGNISABLE) * leaves:
        return Difference(rewritten=True)
    return Difference(tuple(changes), frozenset(marked[0]), frozenset(marked[1]))


def _units(atoms: Sequence[Atom], key: _Key) -> list[tuple[int, int]]:
    """What is compared as one: a symbol or bracket with its marks, exponents and indices."""
    units, place = [], 0
    while place < len(atoms):
        start, atom = place, atoms[place]
        has_content = atom.is_accent or atom.is_script
        place = (_closing_of(atoms, place) if has_content else place) + 1
        if atom.leaf or atom.is_accent or atom.identity in _CLOSING:
            while place < len(atoms) and atoms[place].is_script:
                place = _closing_of(atoms, place) + 1
        if _keys(atoms[start:place], key):
            units.append((start, place))
    return units


def _keys(atoms: Sequence[Atom], key: _Key) -> tuple[str, ...]:
    return tuple(found for atom in atoms if (found := key(atom)) is not None)


def _span(units: Sequence[tuple[int, int]]) -> tuple[int, int]:
    return (units[0][0], units[-1][1]) if units else (0, 0)


def _leaves_that_differ(
    sides: _Sides, spans: Sequence[tuple[int, int]], key: _Key
) -> tuple[set[int], set[int]]:
    """The leaves to mark in two unequal stretches: those not common to both, or all if all are common."""
    places = [[i for i in range(*spans[side]) if key(sides[side][i]) is not None] for side in (0, 1)]
    leaves = (set(), set())
    for ends in _unequal_blocks(*([key(sides[side][i]) for i in places[side]] for side in (0, 1))):
        for side in (0, 1):
            leaves[side].update(
                _leaves_within(sides[side], places[side][ends[2 * side] : ends[2 * side + 1]])
            )
    return tuple(
        found or {i for i in range(*spans[side]) if sides[side][i].leaf} for side, found in enumerate(leaves)
    )


def _unequal_blocks(first: list[str | None], second: list[str | None]) -> list[list[int]]:
    """Where two sequences differ outside a longest common subsequence: [start, end, start, end], in order."""
    rows, columns = len(first), len(second)
    common = [[0] * (columns + 1) for _ in range(rows + 1)]
    for row in range(rows):
        for column in range(columns):
            if first[row] == second[column]:
                common[row + 1][column + 1] = common[row][column] + 1
            else:
                common[row + 1][column + 1] = max(common[row][column + 1], common[row + 1][column])
    blocks: list[list[int]] = []
    row, column = rows, columns
    while row or column:
        end = (row, column)
        if row and column and first[row - 1] == second[column - 1]:
            row, column = row - 1, column - 1
            continue
        if row and common[row][column] == common[row - 1][column]:
            row -= 1
        else:
            column -= 1
        if blocks and (blocks[-1][0], blocks[-1][2]) == end:
            blocks[-1][0], blocks[-1][2] = row, column
        else:
            blocks.append([row, end[0], column, end[1]])
    return blocks[::-1]


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


def _preceding(atoms: Sequence[Atom], end: int) -> str | None:
    """The symbol or bracket before a place, with its exponents and indices."""
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
    if all(atom.identity in _OPENING | _CLOSING for atom in either):
        return "bracket"
    if all(atom.latex.isdigit() for atom in either):
        return "number"
    bases = [[atom.shape for atom in part if not atom.is_script][:1] for part in (before, after)]
    scripts = [[atom.shape for atom in part][1:] for part in (before, after)]
    if before and after and bases[0] == bases[1] and scripts[0] != scripts[1]:
        openers = {atom.latex for atom in either if atom.is_script}
        return {"^{": "exponent", "_{": "index"}.get(*openers, "part") if len(openers) == 1 else "part"
    letters = [
        [re.sub(_MARK_NAMES, "", atom.shape or "") for atom in part if atom.shape and not atom.is_accent]
        for part in (before, after)
    ]
    if letters[0] == letters[1]:
        return "mark"
    begin_with_symbols = before and after and before[0].leaf and after[0].leaf
    rest = [[atom.shape for atom in part[1:]] for part in (before, after)]
    return "symbol" if begin_with_symbols and rest[0] == rest[1] else "part"


def _fragment(atoms: Sequence[Atom]) -> str | None:
    """LaTeX of a stretch, None if it is empty; a script without a base gets an empty one."""
    text = latex_of(atoms)
    try:
        atoms_of(text)
    except LatexNotTypesettable:  # half of a left-right pair: a plain bracket
        text = re.sub(r"\\(left|right)\s*(?=\\?[^A-Za-z\s.]|\\[lr]angle)", "", text)
    return "{}" + text if text.startswith(("^", "_")) else text or None


def _opens(atom: Atom) -> int:
    return 0 if atom.leaf else atom.latex.count("{") - atom.latex.count("}")
