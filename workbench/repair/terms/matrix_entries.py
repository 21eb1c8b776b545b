"""Entry-by-entry repair of a matrix: each wrong entry gets other coefficients or one edit."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from workbench.core.construct import block, number, zero
from workbench.core.terms import Apply, Block, IllFormed, Number, Relation, Term, Zero
from workbench.engines.jet.rings import PRIME
from workbench.language.printing.printer import to_latex
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.changes import Candidate, Change, rescaled
from workbench.repair.terms.coefficients import Vector, contributions, fewest_changes, rational
from workbench.repair.terms.linear_places import addend_places
from workbench.repair.terms.subterm_positions import Place, replaced, subterm
from workbench.repair.terms.term_arithmetic import times
from workbench.repair.terms.term_edits import Edit, edits

#: The most wrong entries for which a misprint is assumed.
MOST_WRONG = 9
_MOST_OPTIONS = 6
_LARGEST_NUMBER = 12

#: (new term of an entry, its changes).
_Option = tuple[Term, tuple[Change, ...]]


@dataclass(frozen=True)
class _Printed:
    """A matrix of scalars on one side, its position, and the required values of its entries at the points."""

    matrix: Block
    place: Place
    targets: list[Vector]

    @property
    def entries(self) -> list[tuple[Place, Term]]:
        return [((*self.place, number), entry) for number, entry in enumerate(self.matrix.children)]


def entrywise(
    relation: Relation, screen: Screen, replacements: Sequence[Term], tick: Callable[[], None]
) -> Iterator[Candidate]:
    """Yields the equation with all wrong entries of a matrix corrected.

    Either two rows or columns are exchanged, or the matrix is transposed, or each wrong entry is changed.
    Changes of one kind come first.
    """
    for free in (1, 0):
        printed = _printed_matrix(relation, free, screen)
        if printed is None:
            continue
        values = [_own(screen, entry) for _, entry in printed.entries]
        wrong = [k for k, value in enumerate(values) if value != printed.targets[k]]
        if not wrong or None in values:
            continue
        yield from _exchanged(relation, printed, values)
        if len(wrong) > MOST_WRONG:
            continue
        options = [_options(relation, printed, k, screen, replacements, tick) for k in wrong]
        if all(options):
            yield from _together(relation, printed, wrong, options)


def wrong_places(relation: Relation, screen: Screen) -> list[Place]:
    """Returns the positions of all entries of a matrix with more than one wrong entry."""
    for free in (1, 0):
        printed = _printed_matrix(relation, free, screen)
        if printed is None:
            continue
        values = [_own(screen, entry) for _, entry in printed.entries]
        if sum(value != target for value, target in zip(values, printed.targets, strict=True)) > 1:
            return [place for place, _ in printed.entries]
    return []


def _printed_matrix(relation: Relation, free: int, screen: Screen) -> _Printed | None:
    """Returns the matrix of scalars that is a side, or a multiple of a side."""
    side, scale = subterm(relation, (free,)), None
    place: Place = (free,)
    other = screen.components(subterm(relation, (1 - free,)), side)
    match side:
        case Apply(head="mul", arguments=(factor, Block() as inner)) if factor.type.kind == "scalar":
            side, place, scale = inner, (free, 1), _own(screen, factor)
    if not isinstance(side, Block) or other is None or side.type.dual:
        return None
    entries = side.children
    if len(entries) < 2 or any(entry.type.kind != "scalar" for entry in entries):
        return None
    size, points = len(entries), len(screen.points)
    if len(other) != 2 * size * points:
        return None
    factors = [1] * points if scale is None else [0 if x == 0 else pow(x, -1, PRIME) for x in scale]
    targets = [
        tuple(other[2 * size * p + k] * factors[p] % PRIME for p in range(points)) for k in range(size)
    ]
    return _Printed(side, place, targets)


def _own(screen: Screen, scalar: Term) -> Vector | None:
    """Returns the values of a scalar at the points."""
    found = screen.components(scalar, scalar)
    return None if found is None else found[::2]


def _options(
    relation: Relation,
    printed: _Printed,
    number: int,
    screen: Screen,
    replacements: Sequence[Term],
    tick: Callable[[], None],
) -> list[_Option]:
    place, entry = printed.entries[number]
    target = printed.targets[number]
    found = [*_rescaled_entries(entry, target, screen), *_number(entry, target)]
    for edit in edits(relation, replacements, within=place):
        if len(found) >= _MOST_OPTIONS:
            break
        tick()
        if not isinstance(edit, Edit):
            continue
        new = subterm(edit.statement, place)
        if new.type.kind == "scalar" and _own(screen, new) == target:
            found.append((new, (Change(edit.kind, edit.description),)))
    return found


def _rescaled_entries(entry: Term, target: Vector, screen: Screen) -> Iterator[_Option]:
    """Yields the entry with other coefficients of its addends."""
    equation = Relation("=", entry, entry)
    for chosen in addend_places(entry):
        columns = contributions(entry, chosen, screen)
        if columns is None:
            continue
        for factors in fewest_changes([column[::2] for column in columns], target):
            new: Term | None = entry
            changes = []
            for at, factor in zip(chosen, factors, strict=True):
                if factor == 1 or new is None:
                    continue
                if factor == 0:
                    new = None
                    continue
                changes.append(rescaled(equation, (0, *at), factor))
                new = _replaced_within(new, at, times(factor, subterm(equation, (0, *at))))
            if new is not None:
                yield new, tuple(changes)


def _number(entry: Term, target: Vector) -> Iterator[_Option]:
    """Yields another number for an entry that is a number."""
    value = rational(target[0], _LARGEST_NUMBER) if len(set(target)) == 1 else None
    if value is not None and isinstance(entry, Number | Zero):
        new = number(value) if value else zero()
        shown = f"change the entry ${to_latex(entry)}$ to ${to_latex(new)}$"
        yield new, (Change("coefficient", shown),)


def _replaced_within(entry: Term, at: Place, new: Term) -> Term | None:
    try:
        return subterm(replaced(Relation("=", entry, entry), (0, *at), new), (0,))
    except IllFormed:
        return None


def _together(
    relation: Relation, printed: _Printed, wrong: Sequence[int], options: Sequence[list[_Option]]
) -> Iterator[Candidate]:
    """Yields all wrong entries with changes of one kind; else each with its first change."""
    kinds = dict.fromkeys(change.kind for ways in options for _, changes in ways for change in changes)
    chosen: list[list[_Option]] = []
    for kind in kinds:
        of_kind = [[way for way in ways if {c.kind for c in way[1]} == {kind}] for ways in options]
        if all(of_kind):
            chosen.append([ways[0] for ways in of_kind])
    chosen.append([ways[0] for ways in options])
    for ways in chosen:
        statement = relation
        try:
            for number, (new, _) in zip(wrong, ways, strict=True):
                statement = replaced(statement, printed.entries[number][0], new)
        except IllFormed:
            continue
        yield Candidate(statement, tuple(change for _, changes in ways for change in changes))


def _exchanged(relation: Relation, printed: _Printed, values: Sequence[Vector | None]) -> Iterator[Candidate]:
    """Yields the matrix with two rows or two columns exchanged, or transposed."""
    rows = printed.matrix.entries
    height, width = len(rows), len(rows[0])
    ways: list[tuple[str, list[list[int]]]] = []
    plain = [[width * i + j for j in range(width)] for i in range(height)]
    for a, b in combinations(range(height), 2):
        order = [b if i == a else a if i == b else i for i in range(height)]
        ways.append((f"exchange rows {a + 1} and {b + 1}", [plain[i] for i in order]))
    for a, b in combinations(range(width), 2):
        columns = [b if j == a else a if j == b else j for j in range(width)]
        ways.append((f"exchange columns {a + 1} and {b + 1}", [[r[j] for j in columns] for r in plain]))
    if height == width:
        ways.append(("transpose the matrix", [list(column) for column in zip(*plain, strict=True)]))
    for said, places in ways:
        flat = [number for row in places for number in row]
        if all(values[number] == target for number, target in zip(flat, printed.targets, strict=True)):
            entries = printed.matrix.children
            new = block([[entries[number] for number in row] for row in places])
            shown = f"{said} of ${to_latex(printed.matrix)}$"
            yield Candidate(replaced(relation, printed.place, new), (Change("swap", shown),))
