"""Differences between a printed formula and the correct one: sign, number, mark, symbol, part.

Formatting is no difference: spacing, alignment, the size of brackets, the command for bold, braces that group
nothing, the order of two accents or of an index and an exponent, and, outside scripts, round or square
brackets.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise
from typing import Any

from workbench.source.typeset.glyphs import ACCENTS, STYLES, TWO_ARGUMENTS
from workbench.source.typeset.latex_atoms import (
    Atom,
    LatexNotTypesettable,
    atoms_of,
    closing_of,
    decorated,
    latex_of,
    opens,
)

# Below this share of common atoms a list of differences would be longer than the two formulas.
_RECOGNISABLE = 0.35

_BRACKETS = frozenset("()[]{}")
_ROUND = {"[": "(", "]": ")"}
_DECORATIONS = frozenset((*ACCENTS, *STYLES))
_SIZE = re.compile(r"\\(?:left|right|[bB]igg?[lrm]?)(?![A-Za-z])")
_MARK_NAMES = r"d{0,4}dot\(|~\(|hat\(|widehat\(|bar\(|overline\(|vec\(|underline\(|\)"

_Key = Callable[[Atom], str]


@dataclass(frozen=True)
class Change:
    """One position where two formulas differ. kind: sign, operator, bracket, number, exponent, index, mark,
    symbol, part.

    before: the part of the first formula (LaTeX, None if nothing); after: that of the second.
    """

    kind: str
    before: str | None
    after: str | None


@dataclass(frozen=True)
class Difference:
    """The changes, in reading order, and the leaves to mark in each formula (indices into their atoms).

    parts: both formulas side by side, as {"same": latex} or {"printed": latex, "proposed": latex}, either of
    which may be "". rewritten: so little is common that no list of changes is given.
    """

    changes: tuple[Change, ...] = ()
    marked_before: frozenset[int] = frozenset()
    marked_after: frozenset[int] = frozenset()
    rewritten: bool = False
    parts: tuple[dict[str, str], ...] = ()


def difference(before: str, after: str) -> Difference | None:
    """Returns the difference, or None if one of the formulas cannot be parsed.

    Bold, italic and upright letters count as the same unless they are the only difference; the parts always
    distinguish them.
    """
    try:
        first, second = (_canonical(atoms_of(latex)) for latex in (before, after))
    except LatexNotTypesettable:
        return None
    if _has_pairs(first) and _has_pairs(second):
        first, second = _with_round_brackets(first), _with_round_brackets(second)
    by_shape = _compare(first, second, lambda atom: _in_any_order(_shape_of(atom)))
    if by_shape.changes or by_shape.rewritten:
        return by_shape
    return _compare(first, second, lambda atom: _in_any_order(_identity_of(atom)))


def in_one_line(parts: Iterable[Mapping[str, str]]) -> str:
    """Returns the parts of a difference as plain text: [-only printed-] and {+only proposed+}."""
    pieces = []
    for part in parts:
        pieces.append(part.get("same", ""))
        for key, (opening, closing) in (("printed", ("[-", "-]")), ("proposed", ("{+", "+}"))):
            if part.get(key):
                pieces.append(f"{opening}{part[key]}{closing}")
    return " ".join(filter(None, pieces))


def _shape_of(atom: Atom) -> str:
    assert atom.shape is not None, f"{atom.latex} does not count"
    return atom.shape


def _identity_of(atom: Atom) -> str:
    assert atom.identity is not None, f"{atom.latex} does not count"
    return atom.identity


def _in_any_order(marks: str) -> str:
    """Returns the accents of a letter in alphabetical order."""
    *names, letter = marks.split("(")
    return "(".join((*sorted(names), letter))


def _canonical(atoms: Sequence[Atom]) -> list[Atom]:
    """Returns the atoms that count, in canonical spelling, without a final stop."""
    counted = [
        replace(atom, latex=_SIZE.sub("", atom.latex))
        for atom in atoms
        if atom.identity is not None or atom.latex in ("{", "}")
    ]
    grouped = _grouped(counted)
    while grouped and grouped[-1].latex in (".", ",", ";"):
        del grouped[-1]
    return grouped


def _grouped(atoms: Sequence[Atom]) -> list[Atom]:
    """Returns the atoms without braces that group nothing, with marks on letters instead of their scripts,
    and with subscripts first."""
    found: list[Atom] = []
    place = exponent = 0  # exponent: start of the exponent at the end
    while place < len(atoms):
        head, end = atoms[place], closing_of(atoms, place)
        inner, last = _grouped(atoms[place + 1 : end]), atoms[max(place + 1, end) : end + 1]
        place = end + 1
        scripts = {a.latex for a in atoms[place : _after_scripts(atoms, place)] if a.is_script}
        is_one = bool(inner) and _after_scripts(inner, closing_of(inner, 0) + 1) == len(inner)
        is_one = is_one and not any(atom.is_script and atom.latex in scripts for atom in inner)
        start = len(found)
        if head.latex == "{":
            if is_one or not scripts:
                found += inner
            elif inner:
                found += [_counted(head, "{}"), *inner, _counted(last[0], "end {}")]
            else:
                found.append(replace(_counted(head, "{}"), latex="{}"))
        elif is_one and inner[0].leaf and not head.leaf and head.latex[:-1] in _DECORATIONS:
            found += [decorated(head.latex[:-1], inner[0], inner[0].latex), *inner[1:]]
        elif head.identity in (r"\stackrel", r"\overset") and inner[-1].identity == "=":
            found.append(inner[-1])
        elif head.latex == "_{" and exponent:
            found[exponent:exponent] = [head, *inner, *last]
        else:
            found += [head, *inner, *last]
        exponent = start if head.latex == "^{" else 0
    return found


def _counted(atom: Atom, identity: str) -> Atom:
    return replace(atom, identity=identity, shape=identity)


def _has_pairs(atoms: Sequence[Atom]) -> bool:
    """True if each round and each square bracket is closed by one of its kind."""
    waiting = []
    for sign in (atom.identity for atom in atoms):
        if sign in ("(", "["):
            waiting.append({"(": ")", "[": "]"}[sign])
        elif sign in (")", "]") and (not waiting or waiting.pop() != sign):
            return False
    return not waiting


def _with_round_brackets(atoms: Sequence[Atom]) -> list[Atom]:
    """Returns the atoms with round brackets for square ones, except in scripts."""
    found: list[Atom] = []
    while len(found) < len(atoms):
        atom = atoms[len(found)]
        if atom.is_script:
            found += atoms[len(found) : closing_of(atoms, len(found)) + 1]
        else:
            found.append(_counted(atom, _ROUND[atom.identity]) if atom.identity in _ROUND else atom)
    return found


def _compare(first: list[Atom], second: list[Atom], key: _Key) -> Difference:
    sides = (first, second)
    keys = [list(map(key, atoms)) for atoms in sides]
    starts = [_units(atoms) for atoms in sides]
    units = [[tuple(k[a:b]) for a, b in pairwise(start)] for k, start in zip(keys, starts, strict=True)]
    changes: list[Change] = []
    blocks: list[list[int]] = []
    marked: tuple[set[int], set[int]] = (set(), set())
    for ends in _unequal_blocks(*units):
        spans = [(starts[side][ends[2 * side]], starts[side][ends[2 * side + 1]]) for side in (0, 1)]
        offsets = [span[0] for span in spans for _ in range(2)]
        within = [
            [offset + end for offset, end in zip(offsets, block, strict=True)]
            for block in _unequal_blocks(*(keys[side][slice(*spans[side])] for side in (0, 1)))
        ]
        blocks += within
        for side, span in enumerate(spans):
            new = [place for block in within for place in range(*block[2 * side : 2 * side + 2])]
            leaves = _leaves_within(sides[side], new)
            marked[side].update(leaves or _leaves_within(sides[side], range(*span)))
        before, after = (sides[side][slice(*spans[side])] for side in (0, 1))
        changes.append(Change(_kind(before, after), _fragment(before), _fragment(after)))
    parts = tuple(_side_by_side(first, second, blocks))
    count = sum(atom.leaf for atom in (*first, *second))
    if all(keys) and len(marked[0]) + len(marked[1]) > (1 - _RECOGNISABLE) * count:
        return Difference(rewritten=True, parts=parts)
    in_first, in_second = (
        frozenset(atoms[i].place for i in found) for atoms, found in zip(sides, marked, strict=True)
    )
    return Difference(tuple(changes), in_first, in_second, parts=parts)


def _side_by_side(
    first: Sequence[Atom], second: Sequence[Atom], blocks: Iterable[Sequence[int]]
) -> Iterator[dict[str, str]]:
    start = end = 0
    for a, b, c, d in (*blocks, (len(first),) * 2 + (len(second),) * 2):
        aligned = zip(first[start:a], second[end:c], strict=True)
        for is_same, pairs in groupby(aligned, _is_same):
            before, after = map(_close, zip(*pairs, strict=True))
            yield {"same": after} if is_same else {"printed": before, "proposed": after}
        if a < b or c < d:
            yield {"printed": _close(first[a:b]), "proposed": _close(second[c:d])}
        start, end = b, d


def _is_same(pair: tuple[Atom, Atom]) -> bool:
    one, other = map(_identity_of, pair)
    return _in_any_order(one) == _in_any_order(other)


def _close(atoms: Sequence[Atom]) -> str:
    """Returns LaTeX without the spaces inside braces and before scripts."""
    text = ""
    for atom in atoms:
        is_close = not text or text.endswith("{") or atom.is_script or opens(atom) < 0 or atom.latex == "}{"
        text += atom.latex if is_close else f" {atom.latex}"
    return text


def _units(atoms: Sequence[Atom]) -> list[int]:
    """Returns the starts of the units of comparison, and the end. A unit is a symbol or bracket with its
    marks, exponents and indices."""
    starts, place = [], 0
    while place < len(atoms):
        starts.append(place)
        atom = atoms[place]
        end = place if atom.identity in TWO_ARGUMENTS else closing_of(atoms, place)
        place = end + 1 if opens(atom) < 0 else _after_scripts(atoms, end + 1)
    return [*starts, len(atoms)]


def _after_scripts(atoms: Sequence[Atom], place: int) -> int:
    while place < len(atoms) and atoms[place].is_script:
        place = closing_of(atoms, place) + 1
    return place


def _unequal_blocks(first: Sequence[Any], second: Sequence[Any]) -> list[list[int]]:
    """Returns the blocks outside a longest common subsequence as [start, end, start, end], in order."""
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


def _leaves_within(atoms: Sequence[Atom], places: Iterable[int]) -> set[int]:
    """Returns the leaves at the positions, and those inside a mark, script or fraction that opens there."""
    ends = {place: closing_of(atoms, place) for place in places}
    return {i for place, end in ends.items() for i in range(place, end + 1) if atoms[i].leaf}


def _kind(before: Sequence[Atom], after: Sequence[Atom]) -> str:
    either = [*before, *after]
    if all(atom.latex in ("+", "-") for atom in either):
        return "sign"
    if all(atom.leaf and atom.family in ("bin", "rel") for atom in either):
        return "operator"
    if all(atom.identity in _BRACKETS for atom in either):
        return "bracket"
    if all(atom.latex.isdigit() for atom in either):
        return "number"
    bases = [[atom.shape for atom in part if not atom.is_script][:1] for part in (before, after)]
    scripts = [[atom.shape for atom in part][1:] for part in (before, after)]
    if before and after and bases[0] == bases[1] and scripts[0] != scripts[1]:
        openers = {atom.latex for atom in either if atom.is_script}
        opener = openers.pop() if len(openers) == 1 else ""
        return {"^{": "exponent", "_{": "index"}.get(opener, "part")
    letters = [
        [re.sub(_MARK_NAMES, "", _shape_of(atom)) for atom in part if not atom.is_accent and opens(atom) >= 0]
        for part in (before, after)
    ]
    if letters[0] == letters[1]:
        return "mark"
    begin_with_symbols = before and after and before[0].leaf and after[0].leaf
    rest = [[atom.shape for atom in part[1:]] for part in (before, after)]
    return "symbol" if begin_with_symbols and rest[0] == rest[1] else "part"


def _fragment(atoms: Sequence[Atom]) -> str | None:
    """Returns the LaTeX of the atoms, None if it is empty; a script without a base gets an empty one."""
    text = latex_of(atoms)
    return "{}" + text if text.startswith(("^", "_")) else text or None
