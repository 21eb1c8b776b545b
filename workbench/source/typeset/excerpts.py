"""Excerpts of a formula for one line of a table: its left side, and the surroundings of its marked leaves."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from workbench.source.typeset.latex_atoms import (
    Atom,
    LatexNotTypesettable,
    atoms_of,
    closing_of,
    latex_of,
    opens,
)

#: A longer left side is not shown.
_LONG_SIDE = 16


def left_side(latex: str) -> str | None:
    """Returns the part before the first relation of a formula if it is short; None if there is none."""
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return None
    place = 0
    while place < len(atoms) and not (atoms[place].family == "rel" and atoms[place].leaf):
        if atoms[place].latex.startswith(r"\begin"):
            return None
        place = closing_of(atoms, place) + 1
    side = [atom for atom in atoms[:place] if atom.latex not in ("&", r"\\")]
    length = sum(len(atom.glyphs) for atom in side)
    return latex_of(side) if 0 < length <= _LONG_SIDE and place < len(atoms) else None


def excerpts(
    old: str, new: str, marked_old: Collection[int], marked_new: Collection[int], width: int
) -> tuple[tuple[str, frozenset[int]], tuple[str, frozenset[int]]] | None:
    """Returns the surroundings of the first change in two formulas, each with its marked leaves.

    Returns None if both formulas are short, or cannot be parsed.
    """
    try:
        first, second = atoms_of(old), atoms_of(new)
    except LatexNotTypesettable:
        return None
    if max(_length(first), _length(second)) <= width:
        return None
    starts = [_first_mark(first, marked_old), _first_mark(second, marked_new)]
    counts = [_unmarked_before(first, marked_old, starts[0]), _unmarked_before(second, marked_new, starts[1])]
    known = [count for count in counts if count is not None]
    if not known:
        return None
    place = min(known)
    return (
        _around(first, marked_old, place, width),
        _around(second, marked_new, place, width),
    )


def in_one_line(latex: str, marked: Collection[int]) -> tuple[str, frozenset[int]]:
    """Returns the formula and its marked leaves with fractions written with a slash."""
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return latex, frozenset(marked)
    if not any(atom.latex in _FRACTIONS for atom in atoms):
        return latex, frozenset(marked)
    kept = _slashed([(atom, place in marked) for place, atom in enumerate(atoms)])
    shown = latex_of([atom for atom, _ in kept])
    marks = [is_marked for atom, is_marked in kept if atom.leaf]
    leaves = [place for place, atom in enumerate(atoms_of(shown)) if atom.leaf]
    return shown, frozenset(place for place, is_marked in zip(leaves, marks, strict=True) if is_marked)


_FRACTIONS = frozenset((r"\frac{", r"\dfrac{", r"\tfrac{"))
_Marked = tuple[Atom, bool]


def _slashed(atoms: Sequence[_Marked]) -> list[_Marked]:
    found: list[_Marked] = []
    place = 0
    while place < len(atoms):
        if atoms[place][0].latex not in _FRACTIONS:
            found.append(atoms[place])
            place += 1
            continue
        plain = [atom for atom, _ in atoms]
        end = closing_of(plain, place)
        inside = _inside(plain, place, end + 1, place + 1)
        middle = inside[1] if inside else end
        above, below = atoms[place + 1 : middle], atoms[middle + 1 : end]
        found += [*_bracketed(above), (_SLASH, False), *_bracketed(below)]
        place = end + 1
    return found


def _bracketed(atoms: Sequence[_Marked]) -> list[_Marked]:
    """Returns the atoms in brackets if they are more than one factor with its scripts."""
    inner = _slashed(atoms)
    plain = [atom for atom, _ in inner]
    items = list(_items(plain, 0, len(plain)))
    is_group = (
        plain[0].latex == "("
        and sum(atom.latex == "(" for atom in plain) == 1
        and (plain[items[-1][0]].latex in (")", "!"))
    )
    if len(items) == 1 or is_group or (len(items) == 2 and plain[items[1][0]].latex == "!"):
        return inner
    return [(_OPEN, False), *inner, (_CLOSE, False)]


def _length(atoms: Sequence[Atom]) -> int:
    return sum(len(atom.glyphs) for atom in atoms)


def _first_mark(atoms: Sequence[Atom], marked: Collection[int]) -> int | None:
    return min((place for place in marked if atoms[place].leaf), default=None)


def _unmarked_before(atoms: Sequence[Atom], marked: Collection[int], start: int | None) -> int | None:
    if start is None:
        return None
    return sum(atom.leaf and place not in marked for place, atom in enumerate(atoms[:start]))


def _around(
    atoms: Sequence[Atom], marked: Collection[int], place: int, width: int
) -> tuple[str, frozenset[int]]:
    """Returns the items around the leaf with `place` unmarked leaves before it."""
    seen, target = 0, len(atoms) - 1
    for at, atom in enumerate(atoms):
        if atom.leaf and (at in marked or seen == place) and seen >= place:
            target = at
            break
        seen += atom.leaf and at not in marked
    first, last = _window(atoms, target, width)
    kept = list(atoms[first:last])
    marks = {at - first for at in marked if first <= at < last}
    if first > 0:
        kept, marks = [_DOTS, *kept], {at + 1 for at in marks}
    if last < len(atoms):
        kept = [*kept, _DOTS]
    # The excerpt is parsed again and gets its own braces: only leaves count among its atoms.
    latex = latex_of(kept)
    leaves = [at for at, atom in enumerate(kept) if atom.leaf]
    again = [at for at, atom in enumerate(atoms_of(latex)) if atom.leaf]
    return latex, frozenset(new for old, new in zip(leaves, again, strict=False) if old in marks)


def _window(atoms: Sequence[Atom], target: int, width: int) -> tuple[int, int]:
    """Returns the start and end of the excerpt: whole items of one level around the target."""
    bounds = (0, len(atoms))
    while True:
        items = list(_items(atoms, *bounds))
        start = end = next((n for n, (a, b) in enumerate(items) if a <= target < b), len(items) - 1)
        inside = _inside(atoms, *items[start], target)
        if inside is None or _length(atoms[slice(*items[start])]) <= width:
            break
        bounds = inside
    size = _length(atoms[slice(*items[start])])
    for step in (1, -1, 1, -1, 1, -1, 1):
        at = end + 1 if step > 0 else start - 1
        if not 0 <= at < len(items) or atoms[items[at][0]].latex in ("&", r"\\"):
            continue
        size += _length(atoms[slice(*items[at])])
        if size > width:
            break
        start, end = (start, at) if step > 0 else (at, end)
    return items[start][0], items[end][1]


_OPEN, _CLOSE, _SLASH = (Atom(sign, sign, sign, leaf=True, glyphs=sign) for sign in "()/")
_DOTS = Atom(r"\dots", "…", "…", leaf=True, glyphs="…")


def _items(atoms: Sequence[Atom], start: int, end: int) -> Iterator[tuple[int, int]]:
    """Yields the ranges of symbols with their scripts, fractions, environments: the items of one level."""
    place = start
    while place < end:
        head = place
        place = _end_of(atoms, place)
        while place < end and atoms[place].is_script:
            place = closing_of(atoms, place) + 1
        yield head, min(place, end)


def _end_of(atoms: Sequence[Atom], place: int) -> int:
    if atoms[place].latex.startswith(r"\begin{"):
        depth = 0
        for at in range(place, len(atoms)):
            depth += atoms[at].latex.startswith(r"\begin{") - atoms[at].latex.startswith(r"\end{")
            if depth == 0:
                return at + 1
    if atoms[place].latex.startswith(r"\left"):
        depth = 0
        for at in range(place, len(atoms)):
            depth += _side(atoms[at])
            if depth == 0:
                return at + 1
    return closing_of(atoms, place) + 1


def _side(atom: Atom) -> int:
    if atom.latex.startswith(r"\left") and not atom.latex.startswith(r"\leftrightarrow"):
        return 1
    return -(atom.latex.startswith(r"\right") and not atom.latex.startswith(r"\rightarrow"))


def _inside(atoms: Sequence[Atom], start: int, end: int, target: int) -> tuple[int, int] | None:
    """Returns the range inside a group, an environment or the argument of a fraction around the target; else
    None."""
    if end - start < 3 or atoms[start].leaf:
        return None
    last = _end_of(atoms, start)
    if target >= last:  # in a script
        start = next(
            at for at in range(last, target + 1) if atoms[at].is_script and closing_of(atoms, at) >= target
        )
        last = closing_of(atoms, start) + 1
    if not start < target < last - 1:
        return None
    first, depth = start + 1, 0
    for at in range(start + 1, last - 1):
        if depth == 0 and atoms[at].latex == "}{":
            if at > target:
                return first, at
            first = at + 1
        depth += opens(atoms[at])
    return first, last - 1
