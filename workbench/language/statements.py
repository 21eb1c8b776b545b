"""Lines of a formula to statements and to the ranges of their integers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from workbench.language import construct
from workbench.language.elaborate import Elaborator
from workbench.language.errors import Fault, Misfit
from workbench.language.integers import Linear
from workbench.language.names import INDEX_LETTERS, Scripts, base_name, linear, literal, spell, variable_name
from workbench.language.scope import DEEPEST_TERM
from workbench.language.symbols import SymbolTable
from workbench.language.syntax import (
    Chain,
    Conditional,
    Group,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
)
from workbench.language.terms import Conjunction, Equivalence, IllFormed, Implication, Statement, Term

_NATURALS = {"\\mathbb{N}": 0, "\\mathbb{N}^{*}": 1}


@dataclass(frozen=True, slots=True)
class Range:
    """The values that a formula states for an integer variable: lower … upper, both included.
    None: no bound."""

    variable: str
    lower: Linear
    upper: Linear | None = None


@dataclass(frozen=True, slots=True)
class Reading:
    """What a formula says, line by line, and the ranges it states for its integers."""

    statements: tuple[Statement, ...]
    ranges: tuple[Range, ...] = ()


def reading_of(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> Reading:
    """The statements of all lines. Raises Fault and Misfit."""
    clauses = clauses_of(lines)
    ranges: list[Range] = []
    kept: list[Node] = []
    members: list[Node] = []  # a, b of "a, b ∈ S"
    for clause in clauses:
        if isinstance(clause, Chain) and clause.universal and not clause.relations:
            members += clause.sides
        elif isinstance(clause, Chain) and _is_range(clause, table, integers):
            ranges += _ranges(clause, members, table, integers)
            members = []
        elif isinstance(clause, Chain | Conditional):
            _refuse(members)
            kept.append(clause)
        else:
            members.append(clause)
    _refuse(members)
    reader = Elaborator(table, integers.union(r.variable for r in ranges))
    statements = tuple(statement for clause in kept for statement in _statements(reader, clause))
    if not statements:
        raise Fault("the formula says nothing", lines.at)
    return Reading(statements, tuple(ranges))


def term_of(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> Term:
    """The one expression of a text without relations. Raises Fault and Misfit."""
    clauses = clauses_of(lines)
    if not clauses:
        raise Fault("expected an expression, got nothing", lines.at)
    if len(clauses) > 1:
        raise Fault("expected one expression, got several", clauses[1].at)
    reader = Elaborator(table, integers)
    term = reader.term(clauses[0])
    _refuse_applied(reader, [term])
    _refuse_depth(term, clauses[0].at)
    return term


def clauses_of(lines: Lines) -> list[Node]:
    """The clauses of all lines; a line that begins with a sign and states nothing goes on with the last."""
    clauses: list[Node] = []
    for line in lines.lines:
        for place, clause in enumerate(line):
            if isinstance(clause, Lines):
                clauses += clauses_of(clause)
            elif place == 0 and clauses and isinstance(clause, Sum) and clause.addends[0][0]:
                clauses[-1] = _continued(clauses[-1], clause)
            else:
                clauses.append(clause)
    return clauses


def _continued(clause: Node, more: Sum) -> Node:
    if isinstance(clause, Chain) and clause.relations:
        last = clause.sides[-1]
        addends = last.addends if isinstance(last, Sum) else (("", last.at, last),)
        side = Sum(last.at, addends + more.addends)
        return Chain(clause.at, (*clause.sides[:-1], side), clause.relations, clause.universal)
    raise Fault("a line that begins with a sign must follow a relation", more.at)


def _refuse(members: Sequence[Node]) -> None:
    if members:
        raise Fault("expected a relation (= or \\neq), got an expression alone", members[0].at)


# ranges


def _is_range(clause: Chain, table: SymbolTable, integers: frozenset[str]) -> bool:
    signs = [sign for sign, _ in clause.relations]
    if clause.universal or "∈" in signs or "≥" in signs or ">" in signs:
        return True
    if signs != ["="]:
        return False
    name, value = variable_name(clause.sides[0]), clause.sides[1]
    is_value = isinstance(value, Leaf) and value.text.isdigit()
    is_variable = name in integers | INDEX_LETTERS and name not in table.symbols
    return _bar(value) is not None or (is_value and is_variable)


def _bar(node: Node) -> tuple[Node, ...] | None:
    """The a, b of \\overline{a, b}."""
    match node:
        case Styled(style="\\overline", body=Group(parts=(_, _) as ends)):
            return ends
    return None


def _ranges(
    clause: Chain, members: Sequence[Node], table: SymbolTable, integers: frozenset[str]
) -> list[Range]:
    (sign, at), *more = clause.relations or [("", clause.at)]
    if more or not sign:
        raise Fault("expected one range, such as n \\geq 1 or n \\in \\mathbb{N}", more[0][1] if more else at)
    left, right = clause.sides
    if sign == "∈":
        return _members((*members, left), right, table, integers)
    _refuse(members)
    name = variable_name(left)
    if name is None:
        raise Fault("expected an integer variable before the bound", left.at)
    if name in table.symbols:
        raise _no_variable(name, left.at)
    ends = _bar(right) or (right,)
    bounds = [linear(end, integers | _letters(end)) for end in ends]
    if None in bounds:
        raise Fault("expected an integer bound", right.at)
    lower = bounds[0] + 1 if sign == ">" else bounds[0]
    return [Range(name, lower, bounds[-1] if sign == "=" else None)]


def _no_variable(name: str, at: int) -> Fault:
    return Fault(f"{name} is a symbol; what is assumed of symbols is written with = and \\neq", at)


def _letters(node: Node) -> frozenset[str]:
    """The integer variables that a bound such as m or n − 1 names."""
    if isinstance(node, Sum):
        return frozenset().union(*(_letters(addend) for _, _, addend in node.addends))
    name = variable_name(node)
    return frozenset() if name is None else frozenset({name})


def _members(
    members: Sequence[Node], where: Node, table: SymbolTable, integers: frozenset[str]
) -> list[Range]:
    """n ∈ ℕ is a range; a, b ∈ V₃ says of declared symbols what their declaration says."""
    lower = _NATURALS.get(_set_name(where))
    if lower is None:
        for member in members:
            Elaborator(table, integers).term(member)
        return []
    names = [variable_name(member) for member in members]
    if None in names:
        raise Fault("expected integer variables before \\in", members[names.index(None)].at)
    for name, member in zip(names, members, strict=True):
        if name in table.symbols:
            raise _no_variable(name, member.at)
    return [Range(name, Linear(lower)) for name in names]


def _set_name(node: Node) -> str:
    scripted = node if isinstance(node, Scripted) else Scripted(node.at, node)
    styles, letter = [], scripted.nucleus
    while isinstance(letter, Styled) or (isinstance(letter, Group) and len(letter.parts) == 1):
        if isinstance(letter, Styled):
            styles.append(letter.style)
            letter = letter.body
        else:
            letter = letter.parts[0]
    if isinstance(letter, Product) and all(isinstance(item, Leaf) for item in letter.items):
        letter = Leaf(letter.at, "LETTER", "".join(item.text for item in letter.items))  # SO
    scripts = Scripts(sub=scripted.sub, sup=scripted.sup)
    pieces = None
    if isinstance(letter, Leaf):
        pieces = spell(base_name(styles, letter.text), scripts, ())
    if pieces is None:
        raise Fault("expected a set, such as \\mathbb{N} or \\mathbf{V}_3", node.at)
    return literal(pieces)


# statements


def _statements(reader: Elaborator, clause: Node) -> list[Statement]:
    if isinstance(clause, Chain) and isinstance(clause.sides[-1], Lines):
        return _piecewise(reader, clause)
    return [_statement(reader, clause)]


def _piecewise(reader: Elaborator, clause: Chain) -> list[Statement]:
    """x = { a, if p; b, if q } says p ⇒ x = a and q ⇒ x = b."""
    said: list[Statement] = []
    for line in clause.sides[-1].lines:
        if len(line) != 2 or not isinstance(line[1], Chain | Conditional):
            raise Fault("expected a value and its condition on each line", line[0].at)
        value, condition = line
        chain = Chain(clause.at, (*clause.sides[:-1], value), clause.relations)
        said.append(Implication(_statement(reader, condition), _statement(reader, chain)))
    return said


def _statement(reader: Elaborator, clause: Node) -> Statement:
    match clause:
        case Conditional(statements=(left, right), signs=((sign, _),)):
            pair = _statement(reader, left), _statement(reader, right)
            if sign == "⇔":
                return Equivalence(*pair)
            return Implication(*pair) if sign == "⇒" else Implication(*reversed(pair))
        case Conditional():
            raise Fault("one implication or equivalence to a statement", clause.signs[1][1])
        case Chain(universal=False):
            return _chain(reader, clause)
    raise Fault("expected a relation (= or \\neq)", clause.at)


def _chain(reader: Elaborator, chain: Chain) -> Statement:
    for sign, at in chain.relations:
        if sign not in "=≠":
            raise Fault(f"{sign} states a range only; statements are made with = and \\neq", at)
    reader.tensor_operand = None
    terms = [reader.term(side) for side in chain.sides]
    _refuse_applied(reader, terms)
    for term, side in zip(terms, chain.sides, strict=True):
        _refuse_depth(term, side.at)
    links = tuple(
        reader.build(at, construct.relation, sign, left, right)
        for (sign, at), left, right in zip(chain.relations, terms, terms[1:], strict=False)
    )
    return links[0] if len(links) == 1 else Conjunction(links)


def _refuse_applied(reader: Elaborator, terms: Sequence[Term]) -> None:
    """\\mathbf{D} T is the derivative of T; among operators a reader would take it for a product of two."""
    if reader.tensor_operand is not None and any(term.type.kind == "operator" for term in terms):
        fault = IllFormed("an operator applied to a tensor, or their product?", "brackets, or \\circ")
        raise Misfit(fault, reader.tensor_operand)


def _refuse_depth(term: Term, at: int) -> None:
    level, depth = [term], 0
    while level:
        depth += 1
        if depth > DEEPEST_TERM:
            raise Fault(f"the formula nests deeper than {DEEPEST_TERM}", at)
        level = [child for parent in level for child in parent.children]
