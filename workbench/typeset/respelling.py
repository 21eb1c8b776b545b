"""A right form in the spelling of a printed one: the edits of the author's own characters."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher

from workbench.typeset.latex_atoms import Atom, LatexNotTypesettable, atoms_of, closing_of, latex_of, opens

_IGNORED = re.compile(r"[\s{}&]|\\(?:left|right|[bB]igg?[lrm]?)(?![A-Za-z])")


@dataclass(frozen=True)
class Respelling:
    """For the characters from `start` to `end` of the printed form read `new`."""

    start: int
    end: int
    new: str


def respellings(printed: str, right: str) -> tuple[Respelling, ...] | None:
    """What to change in `printed` so that it says `right`, from left to right; None where one of them cannot
    be taken apart, or the change does not fit between whole parts of the formula."""
    try:
        before, after = atoms_of(printed), atoms_of(right)
    except LatexNotTypesettable:
        return None
    places = _places(printed, before)
    if places is None:
        return None
    for behind_braces in (False, True):
        edits = _edits(printed, places, before, after, behind_braces)
        if edits is not None and _says(_edited(printed, edits), after):
            return edits
    return None


def respelled(printed: str, right: str) -> str | None:
    """The printed form with these changes."""
    edits = respellings(printed, right)
    return None if edits is None else _edited(printed, edits)


def relation_at(printed: str) -> int | None:
    """Where the first relation of a formula stands among its characters."""
    try:
        atoms = atoms_of(printed)
    except LatexNotTypesettable:
        return None
    places, at = _places(printed, atoms), 0
    while at < len(atoms) and not (atoms[at].family == "rel" and atoms[at].leaf):
        at = closing_of(atoms, at) + 1
    return places[at][0] if places is not None and at < len(atoms) else None


def _edited(printed: str, edits: Sequence[Respelling]) -> str:
    for edit in reversed(edits):
        printed = printed[: edit.start] + edit.new + printed[edit.end :]
    return printed


def _says(latex: str, atoms: Sequence[Atom]) -> bool:
    try:
        return _keys(atoms_of(latex)) == _keys(atoms)
    except LatexNotTypesettable:
        return False


def _keys(atoms: Sequence[Atom]) -> list[str]:
    """What each atom is compared by; braces that only group, and spaces, are none."""
    return [atom.identity or _IGNORED.sub("", atom.latex) for atom in atoms]


def _edits(
    printed: str,
    places: Sequence[tuple[int, int]],
    before: Sequence[Atom],
    after: Sequence[Atom],
    behind_braces: bool,
) -> tuple[Respelling, ...] | None:
    """behind_braces: whether what is inserted stands behind the braces that close there."""
    edits = []
    matcher = SequenceMatcher(None, _keys(before), _keys(after), autojunk=False)
    for kind, a, b, c, d in matcher.get_opcodes():
        if kind == "equal":
            continue
        if not (_is_whole(before[a:b]) and _is_whole(after[c:d])):
            return None
        start, end = _range(printed, places, a, b, behind_braces)
        edits.append(Respelling(start, end, _spelled(after[c:d], printed[:start], printed[end:])))
    return tuple(edits)


def _places(printed: str, atoms: Sequence[Atom]) -> list[tuple[int, int]] | None:
    """Where each atom stands among the characters: both are the same without white space and braces."""
    kept = [at for at in _kept(printed)]
    spelled = [_IGNORED.sub("", atom.latex) for atom in atoms]
    if "".join(printed[at] for at in kept) != "".join(spelled):
        return None
    places, at = [], 0
    for piece in spelled:
        start = kept[at] if at < len(kept) else len(printed)
        at += len(piece)
        places.append((start, kept[at - 1] + 1 if piece else start))
    return places


def _kept(text: str) -> list[int]:
    kept, at = [], 0
    while at < len(text):
        ignored = _IGNORED.match(text, at)
        if ignored is None:
            kept.append(at)
        at = ignored.end() if ignored else at + 1
    return kept


def _is_whole(atoms: Sequence[Atom]) -> bool:
    depth = 0
    for atom in atoms:
        depth += opens(atom)
        if depth < 0 or (atom.latex == "}{" and depth == 0):
            return False
    return depth == 0


def _range(
    printed: str, places: Sequence[tuple[int, int]], start: int, end: int, behind_braces: bool
) -> tuple[int, int]:
    if start == end:
        at = places[start - 1][1] if start else places[0][0]
        while behind_braces and printed[at : at + 1] == "}":
            at += 1
        at += len(printed[at:]) - len(printed[at:].lstrip())
        return at, at
    first, last = places[start][0], places[end - 1][1]
    inside = printed[first:last]
    for _ in range(inside.count("{") - inside.count("}")):
        last = printed.index("}", last) + 1
    return first, last


def _spelled(atoms: Sequence[Atom], before: str, behind: str) -> str:
    """The atoms as an author writes them: no spaces but where a command would run into a letter."""
    tight = re.sub(r"\s*([_^{}()=+\-,])\s*", r"\1", latex_of(atoms)).strip()
    tight = re.sub(r"([_^])\{(\w)\}", r"\1\2", tight)
    lead = " " if re.search(r"\\[A-Za-z]+$", before) and tight[:1].isalpha() else ""
    trail = " " if re.search(r"\\[A-Za-z]+$", tight) and behind[:1].isalpha() else ""
    return lead + tight + trail
