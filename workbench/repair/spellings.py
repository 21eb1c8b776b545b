"""What is wrong with a formula before any type is looked at: an accent, a bracket, a condition, a superscript
or a letter that the reader does not know, each put right in the ways an editor would think of first."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, product

from workbench.language.errors import Fault, Misfit
from workbench.language.statements import clauses_of, reading_of
from workbench.language.symbols import SymbolTable
from workbench.language.syntax import (
    Bracket,
    Chain,
    Fraction,
    Group,
    Infix,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    parse,
)
from workbench.language.terms import IllFormed
from workbench.language.types import VECTOR
from workbench.repair.integers import bound_variables
from workbench.repair.letters import Occurrence, has_readable_sup, is_known, occurrences, other_letters
from workbench.repair.marks import Mark, letter_of, marked
from workbench.repair.nodes import below, latex_of
from workbench.repair.search import Change

#: The most spellings of one formula that are looked at.
MOST = 24

_STRANGE_ACCENT = re.compile(r"\\(?:hat|widehat|check|breve|acute|grave)(?![A-Za-z])")
_CIRCLE = re.compile(r"\\overset\s*\{\s*\\circ\s*\}|\\mathring(?![A-Za-z])|\\r(?![A-Za-z])")
_DOTS = ("\\dot", "\\ddot", "\\dddot", "\\ddddot")

#: What a strange accent and what a circle may stand for.
_ACCENTS = (("\\tilde", "\\dddot"), *(("\\underline", dots) for dots in _DOTS), ("\\dot", "\\tilde"))


@dataclass(frozen=True)
class Spelling:
    """A formula in which every letter, accent and condition is one that the reader knows."""

    lines: Lines
    changes: tuple[Change, ...] = ()


def spellings(latex: str, table: SymbolTable, integers: frozenset[str]) -> Iterator[Spelling]:
    """The formula as printed if nothing in it is unknown; else with the fewest changes that make it so."""
    steps: tuple[_Step, ...] = (_conditions, _superscripts, _rates, _stray_signs, _arrows, _letters)
    yield from islice(_spelled(latex, steps, table, integers), MOST)


def _spelled(
    latex: str, steps: Sequence[_Step], table: SymbolTable, integers: frozenset[str]
) -> Iterator[Spelling]:
    for text, changes in _texts(latex):
        found = [Spelling(_in_rows(parse(text)), changes)]
        for step in steps:
            found = [
                Spelling(lines, (*before.changes, *more))
                for before in found
                for lines, more in step(before.lines, table, integers)
            ]
        yield from found


def _in_rows(lines: Lines) -> Lines:
    """One statement to a line, with the conditions that follow it; a line that goes on joined to the last."""
    if (
        not any(isinstance(clause, Lines) for line in lines.lines for clause in line)
        and len(lines.lines) == 1
    ):
        return lines
    rows: list[tuple[Node, ...]] = []
    try:
        for clause in clauses_of(lines):
            rows[-1:] = [(*rows[-1], clause)] if rows and _is_range(clause) else [*rows[-1:], (clause,)]
    except Fault:
        return lines
    return Lines(lines.at, tuple(rows))


# text that cannot be parsed


def _texts(latex: str) -> Iterator[tuple[str, tuple[Change, ...]]]:
    if _parses(latex):
        yield latex, ()
        return
    accents = [*_STRANGE_ACCENT.findall(latex), *_CIRCLE.findall(latex)]
    seen: set[str] = set()
    if accents:
        for tilde, dots in _ACCENTS:
            text = _CIRCLE.sub(lambda _, d=dots: d, _STRANGE_ACCENT.sub(lambda _, t=tilde: t, latex))
            if text not in seen and _parses(text):
                seen.add(text)
                shown = [tilde] * bool(_STRANGE_ACCENT.search(latex)) + [dots] * bool(_CIRCLE.search(latex))
                said = f"the accent {accents[0]} should be {' and '.join(shown)}"
                yield text, (Change("mark", said),)
        return
    yield from _brackets(latex)


def _brackets(latex: str) -> Iterator[tuple[str, tuple[Change, ...]]]:
    """One bracket dropped or put in, where that makes a formula."""
    for place, sign in enumerate(latex):
        if sign in "()[]":
            text = latex[:place] + latex[place + 1 :]
            if _parses(text):
                yield text, (Change("bracket", f"the bracket {sign} in column {place + 1} is one too many"),)
    ends = [match.end() for match in re.finditer(r"\\[A-Za-z]+|\\.|[^\\\s]", latex)]
    for sign in (")", "]", "}", "(", "["):
        for place in reversed(ends):
            text = f"{latex[:place]}{sign}{latex[place:]}"
            if _parses(text):
                yield text, (Change("bracket", f"a bracket {sign} is missing in column {place + 1}"),)


def _parses(latex: str) -> bool:
    try:
        parse(latex)
    except Fault:
        return False
    return True


# what the parser lets through

_Found = tuple[Lines, tuple[Change, ...]]
_Step = Callable[[Lines, SymbolTable, frozenset[str]], Sequence[_Found]]


def _conditions(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[_Found]:
    """Conditions on integers whose variable is in bold; those that cannot be read at all are left out."""
    found: list[_Found] = [(lines, ())]
    for line in lines.lines:
        conditions = line[1:]
        if not conditions or _states_ranges(conditions, table, integers):
            continue
        marks = []
        chains = [clause for clause in conditions if isinstance(clause, Chain)]
        for part in (part for chain in chains for part in chain.sides[:-1]):
            letter = letter_of(part)
            if isinstance(part, Styled) and letter is not None and len(letter.text) == 1:
                said = f"${latex_of(part)}$ in the condition should be ${letter.text}$"
                marks.append(Mark(part, letter, 1, "mark", said))
        ways: list[_Found] = []
        plain = tuple(marked(marks, clause) for clause in conditions)
        if marks and _states_ranges(plain, table, integers):
            ways.append((plain, _changes(marks)))
        kept = tuple(clause for clause in conditions if _states_ranges((clause,), table, integers))
        lost = [clause for clause in conditions if clause not in kept]
        said = ", ".join(f"${latex_of(clause)}$" for clause in lost)
        ways.append((kept, (Change("condition", f"the condition {said} cannot be read"),)))
        found = [
            (_with_conditions(before, line, after), (*changes, *more))
            for before, changes in found
            for after, more in ways
        ]
    return found


def _states_ranges(clauses: Sequence[Node], table: SymbolTable, integers: frozenset[str]) -> bool:
    trivial = parse("\\mathbf{I} = \\mathbf{I}").lines[0][0]
    try:
        reading_of(Lines(0, ((trivial, *clauses),)), table, integers)
    except (Fault, Misfit, IllFormed):
        return not any(_is_range(clause) for clause in clauses)
    return True


def _is_range(clause: Node) -> bool:
    if not isinstance(clause, Chain):
        return False
    barred = any(isinstance(side, Styled) and side.style == "\\overline" for side in clause.sides)
    return barred or clause.universal or any(sign in "∈≥>" for sign, _ in clause.relations)


def _with_conditions(lines: Lines, old: tuple[Node, ...], conditions: tuple[Node, ...]) -> Lines:
    return Lines(lines.at, tuple((old[0], *conditions) if line is old else line for line in lines.lines))


def _superscripts(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[_Found]:
    """A superscript that is none: a factor set too high."""
    marks = []
    for found in _occurrences(lines):
        if found.holder is not None and not has_readable_sup(found, table, integers | bound_variables(lines)):
            holder = found.holder
            nucleus = Scripted(holder.at, holder.nucleus, holder.sub) if holder.sub else holder.nucleus
            row = Product(holder.at, (nucleus, *_row(holder.sup)))
            said = f"the superscript of ${latex_of(holder)}$ should be a factor"
            marks.append(Mark(holder, Group(holder.at, (row,)), 1, "exponent", said))
    return [(marked(marks, lines), _changes(marks))]


def _row(node: Node) -> tuple[Node, ...]:
    inner = node.parts[0] if isinstance(node, Group) and len(node.parts) == 1 else node
    return inner.items if isinstance(inner, Product) else (inner,)


def _rates(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[_Found]:
    """d^k/dt^m: the order above is meant, or that below."""
    faults = []
    for part in below(lines):
        if isinstance(part, Fraction) and (orders := _orders(part)) is not None:
            above, under = orders
            if latex_of(_inner(above.sup)) != latex_of(_inner(under.sup)):
                order = _exchanged_order(under, above.sup), _exchanged_order(above, under.sup)
                faults.append([[mark] for mark in order])
    ways = [[mark for marks in chosen for mark in marks] for chosen in product(*faults)]
    return [(marked(marks, lines), _changes(marks)) for marks in ways]


def _orders(fraction: Fraction) -> tuple[Scripted, Scripted] | None:
    """What carries the orders above and below."""
    above, below_ = _row(fraction.numerator)[0], _row(fraction.denominator)
    if not (isinstance(above, Scripted) and isinstance(above.nucleus, Leaf) and above.nucleus.text == "d"):
        return None
    if len(below_) != 2 or not isinstance(below_[1], Scripted) or above.sup is None or below_[1].sup is None:
        return None
    return above, below_[1]


def _inner(node: Node) -> Node:
    return node.parts[0] if isinstance(node, Group) and len(node.parts) == 1 else node


def _exchanged_order(holder: Scripted, order: Node) -> Mark:
    new = Scripted(holder.at, holder.nucleus, holder.sub, order)
    said = f"${latex_of(holder)}$ should be ${latex_of(new)}$: one order above and below"
    return Mark(holder, new, 1, "dots", said)


def _stray_signs(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[_Found]:
    """A sign of a product with nothing before or after it."""
    marks = []
    for part in below(lines):
        if isinstance(part, Product) and any(isinstance(part.items[end], Infix) for end in (0, -1)):
            items = list(part.items)
            while items and isinstance(items[0], Infix):
                del items[0]
            while items and isinstance(items[-1], Infix):
                del items[-1]
            if items:
                new = items[0] if len(items) == 1 else Product(part.at, tuple(items))
                marks.append(Mark(part, new, 1, "product", f"a sign of ${latex_of(part)}$ is one too many"))
    return [(marked(marks, lines), _changes(marks))]


def _arrows(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[_Found]:
    """PQ for the vector between P and Q, where the paper has the places of both, as r_P and r_Q."""
    strange = {id(f.node): f.text for f in _occurrences(lines) if not is_known(f, table, integers)}
    found: list[_Found] = []
    for part in below(lines):
        if not (isinstance(part, Product) and len(part.items) > 1):
            continue
        ends = part.items[-2:]
        names = [strange.get(id(end), "") for end in ends]
        if not all(len(name) == 1 and name.isupper() for name in names):
            continue
        for letter in _letters_with_subscripts(names, table):
            start, end = (parse(f"{letter}_{{{name}}}").lines[0][0] for name in names)
            vector = Bracket(part.at, "(", (Sum(part.at, (("", part.at, end), ("-", part.at, start))),))
            rest = part.items[:-2]
            new = Product(part.at, (*rest, vector)) if rest else vector
            said = f"${''.join(names)}$ should be ${latex_of(vector)}$"
            others = [
                Mark(other, new, 1, "symbol", said)
                for other in below(lines)
                if isinstance(other, Product) and latex_of(other) == latex_of(part)
            ]
            found.append((marked(others, lines), _changes(others)))
    return found or [(lines, ())]


def _letters_with_subscripts(names: Sequence[str], table: SymbolTable) -> list[str]:
    """The letters x for which the paper has vectors x_P for all the names P."""
    having = []
    for name in names:
        ending = f"_{{{name}}}"
        vectors = [n for n, d in table.symbols.items() if n.endswith(ending) and d.type == VECTOR]
        having.append([n.removesuffix(ending) for n in vectors])
    first, *others = having
    return [letter for letter in first if all(letter in other for other in others)]


def _letters(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[_Found]:
    """Letters that the paper does not have become letters that it has, each in the same way throughout."""
    known = integers | bound_variables(lines)
    strange: dict[str, list[Occurrence]] = {}
    for found in _occurrences(lines):
        if not is_known(found, table, known):
            strange.setdefault(f"{found.base} {bool(found.left)}", []).append(found)
    if not strange:
        return [(lines, ())]
    ways = []
    for found in strange.values():
        of_letter = sorted(_known_forms(found, table, known), key=lambda way: way[1])
        if not of_letter:
            return [(lines, ())]
        ways.append([marks for marks, _ in of_letter[:4]])
    chosen = [[mark for marks in way for mark in marks] for way in islice(product(*ways), MOST)]
    return [(marked(marks, lines), _changes(marks)) for marks in chosen]


def _known_forms(
    found: Sequence[Occurrence], table: SymbolTable, integers: frozenset[str]
) -> Iterator[tuple[list[Mark], int]]:
    """Other letters; also with the left scripts up for down."""
    yield from other_letters(found, table, integers)
    if found[0].left is not None:
        moved, marks = [], []
        for one in found:
            left = one.left
            new = Scripted(left.at, left.nucleus, left.sup, left.sub)
            said = f"${latex_of(left)}$ should be ${latex_of(new)}$"
            marks.append(Mark(left, new, 1, "index", said))
            scripts = one.scripts
            swapped = type(scripts)(
                scripts.left_sup, scripts.left_sub, scripts.sub, scripts.sup, scripts.primes
            )
            moved.append(Occurrence(one.node, one.styles, swapped, one.holder, one.left, one.bracket))
        if all(is_known(one, table, integers) for one in moved):
            yield marks, 1
        for more, cost in other_letters(moved, table, integers):
            yield [*marks, *more], cost + 1


def _occurrences(lines: Lines) -> Iterator[Occurrence]:
    """The letters of all clauses that are no conditions on integers."""
    for line in lines.lines:
        for clause in line:
            if not _is_range(clause):
                yield from occurrences(clause)


def _changes(marks: Sequence[Mark]) -> tuple[Change, ...]:
    return tuple(dict.fromkeys(Change(mark.kind, mark.description) for mark in marks))
