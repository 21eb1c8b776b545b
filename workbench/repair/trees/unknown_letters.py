"""Replacement of unknown letters by known ones: fonts, underlines, similar letters, left scripts,
arguments."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice, pairwise, product, zip_longest

from workbench.core.names import Name
from workbench.core.types import VECTOR
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Bracket,
    Group,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Sum,
    in_a_row,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.trees.letter_candidates import Occurrence, meaning_of, other_letters
from workbench.repair.trees.lost_marks import Mark, marked_lines
from workbench.repair.trees.misprinted_integers import bound_variables
from workbench.repair.trees.tree_nodes import below
from workbench.repair.trees.unparsable import Found, changes_of, letters_of_clauses

#: The most corrections of the letters of one formula.
MOST = 24


def arrows(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns PQ as the vector from P to Q, if the paper has the positions of both, such as r_P and r_Q."""
    letters = letters_of_clauses(lines)
    strange = {id(f.node): f.text for f in letters if meaning_of(f, table, integers) is None}
    found: list[Found] = []
    for part in below(lines):
        if not (isinstance(part, Product) and len(part.items) > 1):
            continue
        ends = part.items[-2:]
        names = [strange.get(id(end), "") for end in ends]
        if not all(len(name) == 1 and name.isupper() for name in names):
            continue
        for letter in _letters_with_subscripts(names, table):
            start, end = (parse(str(replace(letter, sub=(name,)))).lines[0][0] for name in names)
            vector = Bracket(part.at, "(", (Sum(part.at, (("", part.at, end), ("-", part.at, start))),))
            rest = part.items[:-2]
            new = Product(part.at, (*rest, vector)) if rest else vector
            said = f"replace ${''.join(names)}$ by ${latex_of(vector)}$"
            others = [
                Mark(other, new, 1, "symbol", said)
                for other in below(lines)
                if isinstance(other, Product) and latex_of(other) == latex_of(part)
            ]
            found.append((marked_lines(others, lines), changes_of(others)))
    return found or [(lines, ())]


def _letters_with_subscripts(labels: Sequence[str], table: SymbolTable) -> list[Name]:
    """Returns the letters x for which the paper has vectors x_P for all the labels P."""
    first, *others = (
        [
            replace(n, sub=())
            for n, d in table.symbols.items()
            if n.sub == (label,) and not n.sup and d.type == VECTOR
        ]
        for label in labels
    )
    return [letter for letter in first if all(letter in other for other in others)]


def known_letters(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns the lines with unknown letters replaced by known ones, each consistently."""
    known = integers | bound_variables(lines)
    strange: dict[str, list[Occurrence]] = {}
    for found in letters_of_clauses(lines):
        if meaning_of(found, table, known) is None:
            left = latex_of(found.left) if found.left is not None else ""
            strange.setdefault(f"{left} {found.base}", []).append(found)
    if not strange:
        return [(lines, ())]
    ways = []
    for alike in strange.values():
        of_letter = sorted(_known_forms(alike, lines, table, known), key=lambda way: way[1])
        if not of_letter:
            return [(lines, ())]
        ways.append([marks for marks, _ in of_letter[:4]])
    chosen = [[mark for marks in way for mark in marks] for way in islice(product(*ways), MOST)]
    return [(marked_lines(marks, lines), changes_of(marks)) for marks in chosen]


def _known_forms(
    found: Sequence[Occurrence], lines: Lines, table: SymbolTable, integers: frozenset[str]
) -> Iterator[tuple[list[Mark], int]]:
    """Yields other letters, also with the left scripts swapped or removed."""
    yield from other_letters(found, table, integers)
    if found[0].left is None:
        return
    for change in (_swapped, _without_left):
        marks = [mark for one in found for mark in change(one, lines)[1]]
        moved = [change(one, lines)[0] for one in found]
        if None not in [meaning_of(one, table, integers) for one in moved]:
            yield marks, 1
        for more, cost in other_letters(moved, table, integers):
            yield [*marks, *more], cost + 1


def _swapped(one: Occurrence, lines: Lines) -> tuple[Occurrence, list[Mark]]:
    left = one.left
    assert left is not None, f"{one.text} has no left scripts"
    new = Scripted(left.at, left.nucleus, left.sup, left.sub)
    said = f"replace ${latex_of(left)}$ by ${latex_of(new)}$"
    scripts = replace(one.scripts, left_sub=one.scripts.left_sup, left_sup=one.scripts.left_sub)
    return replace(one, scripts=scripts), [Mark(left, new, 1, "index", said)]


def _without_left(one: Occurrence, lines: Lines) -> tuple[Occurrence, list[Mark]]:
    left, marks = one.left, []
    assert left is not None, f"{one.text} has no left scripts"
    for part in below(lines):
        if isinstance(part, Product) and any(item is left for item in part.items):
            rest = tuple(item for item in part.items if item is not left)
            new = in_a_row(part.at, rest)
            said = f"remove the index ${latex_of(left)}$"
            marks.append(Mark(part, new, 1, "index", said))
    return replace(one, scripts=replace(one.scripts, left_sub=None, left_sup=None)), marks


def left_scripts(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns the lines with left scripts that had merged with the preceding symbol: a subscript on a
    bracket, or the second digit of an index."""
    marks: list[Mark] = []
    for part in below(lines):
        if isinstance(part, Product):
            marks += _from_brackets(part)
    found = [(marked_lines(marks, lines), changes_of(marks))]
    letters = list(letters_of_clauses(lines))
    more = [mark for one, following in pairwise(letters) for mark in _from_index(one, following)]
    if more:
        found.append((marked_lines([*marks, *more], lines), changes_of([*marks, *more])))
    return found


def _from_index(one: Occurrence, following: Occurrence) -> Iterator[Mark]:
    sub, holder = one.scripts.sub, one.holder
    if sub is None or holder is None:
        return
    digits = latex_of(sub).strip("{}")
    if len(digits) == 2 and digits.isdigit() and following.holder is not None and following.left is None:
        at = following.holder.at
        left = Scripted(at, Group(at, ()), Leaf(at, "NUMBER", digits[1]))
        said = f"move ${digits[1]}$ from ${latex_of(holder)}$ to ${latex_of(following.holder)}$"
        yield Mark(sub, Leaf(sub.at, "NUMBER", digits[0]), 1, "index", said)
        row = Group(at, (Product(at, (left, following.holder)),))
        yield Mark(following.holder, row, 1, "index", said)


def _from_brackets(product: Product) -> Iterator[Mark]:
    row: list[Node] = []
    said = ""
    for item, following in zip_longest(product.items, product.items[1:]):
        match item:
            case Scripted(at=at, nucleus=Bracket() as bracket, sub=Node() as sub) if following is not None:
                row.append(bracket if item.sup is None else Scripted(at, bracket, None, item.sup))
                row.append(Scripted(at, Group(at, ()), sub))
                said = f"move the index ${latex_of(sub)}$ of the bracket to ${latex_of(following)}$"
            case _:
                row.append(item)
    if said:
        yield Mark(product, Product(product.at, tuple(row)), 1, "index", said)


def arguments(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns the lines with a function of the paper that takes one more argument than written."""
    known = integers | bound_variables(lines)
    for found in letters_of_clauses(lines):
        if found.bracket is None:
            continue
        meant = meaning_of(found, table, known)
        name = None if meant is None else meant.name
        formals = table.formals.get(name, ()) if isinstance(name, Name) else ()
        given = found.bracket.parts
        if len(formals) != len(given) + 1:
            continue
        ways: list[Found] = []
        formal_names = {f.name for fs in table.formals.values() for f in fs}
        for index, formal in enumerate(formals):
            for other, declaration in table.symbols.items():
                if declaration.type != formal.type or other.indices or other in formal_names:
                    continue
                argument = parse(str(other)).lines[0][0]
                parts = (*given[:index], argument, *given[index:])
                bracket = Bracket(found.bracket.at, found.bracket.kind, parts)
                said = f"insert the argument ${other}$ in ${latex_of(bracket)}$"
                mark = Mark(found.bracket, bracket, 1, "symbol", said)
                ways.append((marked_lines([mark], lines), changes_of([mark])))
        return ways or [(lines, ())]
    return [(lines, ())]
