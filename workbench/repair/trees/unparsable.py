"""Corrections of conditions, superscripts, orders and signs that have no meaning as printed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import product

from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.terms import IllFormed
from workbench.language.elaboration.statements import reading_of
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Chain,
    Fraction,
    Given,
    Group,
    Infix,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Styled,
    in_a_row,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.terms.changes import Change
from workbench.repair.trees.letter_candidates import Occurrence, has_readable_sup, occurrences
from workbench.repair.trees.lost_marks import Mark, letter_of, marked, marked_lines
from workbench.repair.trees.misprinted_integers import bound_variables
from workbench.repair.trees.tree_nodes import bare, below

#: A formula, and the changes that led to it.
Found = tuple[Lines, tuple[Change, ...]]
Step = Callable[[Lines, SymbolTable, frozenset[str]], Sequence[Found]]


def conditions(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns the lines with conditions on integers whose variable was in bold; unreadable ones are
    dropped."""
    found: list[Found] = [(lines, ())]
    for line in lines.lines:
        stated = line[1:]
        if not stated or _state_ranges(stated, table, integers):
            continue
        marks = []
        chains = [clause for clause in stated if isinstance(clause, Chain)]
        for part in (part for chain in chains for part in chain.sides[:-1]):
            letter = letter_of(part)
            if isinstance(part, Styled) and letter is not None and len(letter.text) == 1:
                said = f"replace ${latex_of(part)}$ in the condition by ${letter.text}$"
                marks.append(Mark(part, letter, 1, "mark", said))
        ways: list[tuple[tuple[Node, ...], tuple[Change, ...]]] = []
        plain = tuple(marked(marks, clause) for clause in stated)
        if marks and _state_ranges(plain, table, integers):
            ways.append((plain, changes_of(marks)))
        kept = tuple(clause for clause in stated if _state_ranges((clause,), table, integers))
        lost = [clause for clause in stated if clause not in kept]
        said = ", ".join(f"${latex_of(clause)}$" for clause in lost)
        ways.append((kept, (Change("condition", f"the condition {said} cannot be read"),)))
        found = [
            (_with_conditions(before, line, after), (*changes, *more))
            for before, changes in found
            for after, more in ways
        ]
    return found


def _state_ranges(clauses: Sequence[Node], table: SymbolTable, integers: frozenset[str]) -> bool:
    trivial = parse("\\mathbf{I} = \\mathbf{I}").lines[0][0]
    try:
        reading_of(Lines(0, ((trivial, *clauses),)), table, integers)
    except (Fault, TypeMismatch, IllFormed):
        return not any(is_condition(clause) for clause in clauses)
    return True


def is_condition(clause: Node) -> bool:
    if isinstance(clause, Given):
        return True
    if not isinstance(clause, Chain):
        return False
    barred = any(isinstance(side, Styled) and side.style == "\\overline" for side in clause.sides)
    return barred or clause.universal or any(sign in "∈≥>" for sign, _ in clause.relations)


def _with_conditions(lines: Lines, old: tuple[Node, ...], conditions: tuple[Node, ...]) -> Lines:
    return Lines(lines.at, tuple((old[0], *conditions) if line is old else line for line in lines.lines))


def superscripts(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns the lines with a meaningless superscript read as a factor."""
    marks = []
    for found in letters_of_clauses(lines):
        holder = found.holder
        if holder is None or holder.sup is None:
            continue
        if not has_readable_sup(found, table, integers | bound_variables(lines)):
            nucleus = Scripted(holder.at, holder.nucleus, holder.sub) if holder.sub else holder.nucleus
            row = Product(holder.at, (nucleus, *_row(holder.sup)))
            said = f"write the superscript of ${latex_of(holder)}$ as a factor"
            marks.append(Mark(holder, Group(holder.at, (row,)), 1, "exponent", said))
    return [(marked_lines(marks, lines), changes_of(marks))]


def repeated_sides(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns a = b = a as a = b."""
    marks = []
    for part in below(lines):
        if isinstance(part, Chain) and len(part.sides) > 2:
            first, last = latex_of(part.sides[0]), latex_of(part.sides[-1])
            if first == last:
                new = Chain(part.at, part.sides[:-1], part.relations[:-1], part.universal)
                marks.append(Mark(part, new, 1, "side", f"remove one of the two sides ${last}$"))
    return [(marked_lines(marks, lines), changes_of(marks))]


def _row(node: Node) -> tuple[Node, ...]:
    inner = bare(node)
    return inner.items if isinstance(inner, Product) else (inner,)


def rates(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns d^k/dt^m with either order in both positions."""
    faults = []
    for part in below(lines):
        if isinstance(part, Fraction) and (orders := _orders(part)) is not None:
            (above, upper), (under, lower) = orders
            if latex_of(bare(upper)) != latex_of(bare(lower)):
                order = _exchanged_order(under, upper), _exchanged_order(above, lower)
                faults.append([[mark] for mark in order])
    ways = [[mark for marks in chosen for mark in marks] for chosen in product(*faults)]
    return [(marked_lines(marks, lines), changes_of(marks)) for marks in ways]


def _orders(fraction: Fraction) -> tuple[tuple[Scripted, Node], tuple[Scripted, Node]] | None:
    """Returns the nodes with the orders above and below, and the orders."""
    above, below_ = _row(fraction.numerator)[0], _row(fraction.denominator)
    if not (isinstance(above, Scripted) and isinstance(above.nucleus, Leaf) and above.nucleus.text == "d"):
        return None
    if len(below_) != 2 or not isinstance(under := below_[1], Scripted):
        return None
    if above.sup is None or under.sup is None:
        return None
    return (above, above.sup), (under, under.sup)


def _exchanged_order(holder: Scripted, order: Node) -> Mark:
    new = Scripted(holder.at, holder.nucleus, holder.sub, order)
    said = f"replace ${latex_of(holder)}$ by ${latex_of(new)}$: one order above and below"
    return Mark(holder, new, 1, "dots", said)


def stray_signs(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> list[Found]:
    """Returns the lines without a product sign that lacks an operand."""
    marks = []
    for part in below(lines):
        if isinstance(part, Product) and any(isinstance(part.items[end], Infix) for end in (0, -1)):
            items = list(part.items)
            while items and isinstance(items[0], Infix):
                del items[0]
            while items and isinstance(items[-1], Infix):
                del items[-1]
            if items:
                new = in_a_row(part.at, items)
                marks.append(Mark(part, new, 1, "product", f"remove a sign of ${latex_of(part)}$"))
    return [(marked_lines(marks, lines), changes_of(marks))]


def letters_of_clauses(lines: Lines) -> Iterator[Occurrence]:
    """Yields the letters of all clauses that are no conditions on integers."""
    for line in lines.lines:
        for clause in line:
            if not is_condition(clause):
                yield from occurrences(clause)


def changes_of(marks: Sequence[Mark]) -> tuple[Change, ...]:
    return tuple(dict.fromkeys(Change(mark.kind, mark.description) for mark in marks))
