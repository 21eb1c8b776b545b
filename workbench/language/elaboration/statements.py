"""Statements from the lines of a formula, with their conditions, and ranges of integers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, TypeMismatch, Unranged
from workbench.core.integer_expressions import Linear
from workbench.core.terms import (
    Block,
    Conjunction,
    Equivalence,
    IllFormed,
    Implication,
    Relation,
    Statement,
    Term,
)
from workbench.core.types import SCALAR, Type, type_of_kind
from workbench.language.elaboration.angles import angles_in, is_full_turn, modulo_turns, without_modulus
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.elaboration.namings import is_map, is_set, named_map, named_set, wants_value
from workbench.language.elaboration.operators.derivatives_of_maps import has_differentials
from workbench.language.elaboration.operators.differentials import as_rates, refuse_italic
from workbench.language.elaboration.operators.evaluations import Apart, under_places
from workbench.language.elaboration.operators.extremum_operators import extrema, is_extremal
from workbench.language.elaboration.ranges import (
    Membership,
    Range,
    is_range,
    member_claims,
    qualifies,
    ranges_of,
    refuse_alone,
    require_member,
)
from workbench.language.grammar.syntax import Chain, Conditional, Given, Joined, Lines, Node
from workbench.language.grammar.vocabulary import ORIENTATIONS
from workbench.language.naming.scope import DEEPEST_TERM
from workbench.language.naming.symbols import SymbolTable

#: Number of values that are tried for an index without a range, and the largest number of such indices in a
#: formula.
GENERIC_VALUES, MOST_GENERIC = 3, 4


@dataclass(frozen=True, slots=True)
class Reading:
    """The statements of a formula, line by line, the ranges of its integers, and what stands outside of its
    bars of evaluation."""

    statements: tuple[Statement, ...]
    ranges: tuple[Range, ...] = ()
    apart: tuple[Apart, ...] = ()


def reading_of(
    lines: Lines, table: SymbolTable, integers: frozenset[str], as_condition: bool = False
) -> Reading:
    """Returns the statements of all lines, each under the conditions of its line.

    as_condition: all statements hold together. An index of free symbols without a range is arbitrary. Raises
    Fault and TypeMismatch.
    """
    generic: tuple[Range, ...] = ()
    while True:
        try:
            found = _reading(lines, table, integers.union(each.variable for each in generic), as_condition)
        except Unranged as fault:
            if as_condition or len(generic) == MOST_GENERIC:
                raise
            generic = (*generic, Range(fault.variable, Linear(1), Linear(GENERIC_VALUES), generic=True))
        else:
            return replace(found, ranges=(*found.ranges, *generic))


def _reading(lines: Lines, table: SymbolTable, integers: frozenset[str], as_condition: bool) -> Reading:
    rows = [_Row.sorted(clauses, table, integers, as_condition) for clauses in _rows_of(lines)]
    stated = tuple(dict.fromkeys(r for row in rows for r in row.ranges))
    reader = Elaborator(table, integers.union(r.variable for r in stated))
    is_alone = not any(row.claims or row.conditions for row in rows)
    statements: list[Statement] = []
    for row in rows:
        for membership in row.memberships:
            for member in membership.members:
                term = reader.term(member)
                if is_alone:
                    statements += member_claims(term, membership.where, member.at, table)
                else:
                    require_member(term, membership.where, member.at)
    statements += [statement for row in rows for statement in row.statements(reader)]
    if not statements:
        raise Fault(SyntaxCode.SAYS_NOTHING(), lines.at)
    return Reading(tuple(statements), stated, tuple(reader.apart))


def term_of(lines: Lines, table: SymbolTable, integers: frozenset[str]) -> Term:
    """Returns the one expression of a text without relations. Raises Fault and TypeMismatch."""
    clauses = clauses_of(lines)
    if not clauses:
        raise Fault(SyntaxCode.EXPECTED_EXPRESSION_GOT_NOTHING(), lines.at)
    if len(clauses) > 1:
        raise Fault(SyntaxCode.EXPECTED_ONE_EXPRESSION_GOT(), clauses[1].at)
    reader = Elaborator(table, integers)
    term = reader.term(clauses[0])
    refuse_italic(reader)
    _refuse_applied(reader, [term])
    _refuse_depth(term, clauses[0].at)
    return term


def clauses_of(lines: Lines) -> list[Node]:
    """Returns the clauses of all lines."""
    return [clause for row in _rows_of(lines) for clause in row]


def _rows_of(lines: Lines) -> list[list[Node]]:
    """Returns the clauses of each line; conditions after an environment belong to all of its lines."""
    rows: list[list[Node]] = []
    for line in lines.lines:
        first, *rest = line
        if isinstance(first, Lines):
            conditions = [_given(clause) for clause in rest if _is_condition(clause)]
            rows += [[*row, *conditions] for row in _rows_of(first)]
            rows += [[clause] for clause in rest if not _is_condition(clause)]
        elif rows and wants_value(rows[-1][-1]):
            rows[-1] += line
        else:
            rows.append(list(line))
    return rows


def _is_condition(clause: Node) -> bool:
    match clause:
        case Given():
            return True
        case Chain(relations=relations, universal=universal):
            return universal or not any(sign == "=" for sign, _ in relations)
    return not isinstance(clause, Conditional | Joined | Lines)


def _given(condition: Node) -> Node:
    """Returns f ≠ 0 after an environment as a condition, since a line that only states a range claims
    nothing."""
    is_unequal = isinstance(condition, Chain) and {sign for sign, _ in condition.relations} == {"≠"}
    return Given(condition.at, (condition,)) if is_unequal else condition


@dataclass
class _Row:
    """A line sorted into claims, conditions, and statements about letters."""

    claims: list[Node] = field(default_factory=list)
    joined: list[Node] = field(default_factory=list)  # the claims that "and" joins
    conditions: list[Node] = field(default_factory=list)
    ranges: list[Range] = field(default_factory=list)
    memberships: list[Membership] = field(default_factory=list)

    @staticmethod
    def sorted(
        clauses: Sequence[Node], table: SymbolTable, integers: frozenset[str], as_condition: bool
    ) -> _Row:
        row = _Row()
        if isinstance(clauses[0], Given) and sum(not isinstance(clause, Given) for clause in clauses) > 1:
            message = SyntaxCode.REACH_OF_CONDITION()
            raise Fault(message, clauses[0].at)
        row._take(row.claims, clauses, table, integers)
        if not as_condition:
            row._bind(table, integers)
        return row

    def _take(
        self, into: list[Node], clauses: Sequence[Node], table: SymbolTable, integers: frozenset[str]
    ) -> None:
        members: list[Node] = []  # a, b of "a, b ∈ S"
        for clause in clauses:
            if isinstance(clause, Chain) and clause.universal and not clause.relations:
                members += clause.sides
            elif isinstance(clause, Chain) and is_range(clause, table, integers):
                for said in ranges_of(clause, members, table, integers):
                    if isinstance(said, Range):
                        self.ranges.append(said)
                    else:
                        self.memberships.append(said)
                members = []
            elif isinstance(clause, Given):
                refuse_alone(members)
                self._take(self.conditions, clause.conditions, table, integers)
            elif isinstance(clause, Joined):
                refuse_alone(members)
                self._take(into, clause.statements, table, integers)
                self.joined += clause.statements
            elif isinstance(clause, Chain) and clause.universal:
                self.conditions.append(Chain(clause.at, clause.sides, clause.relations))
            elif isinstance(clause, Chain | Conditional):
                refuse_alone(members)
                into.append(clause)
            else:
                members.append(clause)
        refuse_alone(members)

    def _bind(self, table: SymbolTable, integers: frozenset[str]) -> None:
        """Makes f ≠ 0 and i = j conditions if an equation is next to them; with "and", all of them are
        claims."""
        own = [c for c in self.claims if c in self.joined or not qualifies(c, table, integers)]
        if not own:
            return
        first, last = self.claims.index(own[0]), self.claims.index(own[-1])
        for place, claim in enumerate(self.claims):
            if claim not in own and first < place < last:
                message = SyntaxCode.CONDITION_OF_WHICH_LINE()
                raise Fault(message, claim.at)
        self.conditions += [claim for claim in self.claims if claim not in own]
        if len(own) > 1 and any(isinstance(claim, Conditional) for claim in own):
            message = SyntaxCode.REACH_OF_IMPLICATION()
            raise Fault(message, own[1].at)
        self.claims = own

    def statements(self, reader: Elaborator) -> list[Statement]:
        claimed: list[Statement] = []
        waiting = list(self.claims)
        while waiting:
            claim = waiting.pop(0)
            if is_map(claim):
                value = waiting.pop(0) if wants_value(claim) and waiting else None
                claimed.append(named_map(reader, claim, value))
            else:
                claimed += _statements(reader, claim)
        if not self.conditions:
            return claimed
        if not claimed:
            message = SyntaxCode.CONDITIONS_OF_NOTHING()
            raise Fault(message, self.conditions[0].at)
        premise = _together([_condition(reader, condition) for condition in self.conditions])
        return [Implication(premise, statement) for statement in claimed]


def _condition(reader: Elaborator, node: Node) -> Statement:
    statement = _statement(reader, node)
    parts = statement.parts if isinstance(statement, Conjunction) else (statement,)
    if not all(isinstance(part, Relation) and part.operator != "≈" for part in parts):
        raise Fault(SyntaxCode.CONDITION_EQUATION_OR_INEQUATION(), node.at)
    return statement


def _together(statements: Sequence[Statement]) -> Statement:
    parts = [part for s in statements for part in (s.parts if isinstance(s, Conjunction) else (s,))]
    return parts[0] if len(parts) == 1 else Conjunction(tuple(parts))


def _statements(reader: Elaborator, clause: Node) -> list[Statement]:
    if isinstance(clause, Chain) and isinstance(clause.sides[-1], Lines):
        return _piecewise(reader, clause)
    return [_statement(reader, clause)]


def _piecewise(reader: Elaborator, clause: Chain) -> list[Statement]:
    """Returns p ⇒ x = a and q ⇒ x = b for x = { a, if p; b, if q }."""
    said: list[Statement] = []
    cases = clause.sides[-1]
    assert isinstance(cases, Lines), "a brace"
    for line in cases.lines:
        value, *conditions = line
        if conditions and isinstance(conditions[0], Given):
            conditions = list(conditions[0].conditions)
        if len(conditions) != 1 or not isinstance(conditions[0], Chain | Joined):
            raise Fault(SyntaxCode.EXPECTED_VALUE_CONDITION_EACH(), line[0].at)
        chain = Chain(clause.at, (*clause.sides[:-1], value), clause.relations)
        said.append(Implication(_condition(reader, conditions[0]), _statement(reader, chain)))
    return said


def _statement(reader: Elaborator, clause: Node) -> Statement:
    if is_set(clause):
        return named_set(reader, clause, _statement)
    match clause:
        case Conditional():
            said = [_statement(reader, each) for each in clause.statements]
            makers = [Equivalence if sign == "⇔" else Implication for sign, _ in clause.signs]
            return _together([make(*pair) for make, *pair in zip(makers, said, said[1:], strict=False)])
        case Joined(statements=statements):
            return _together([_statement(reader, statement) for statement in statements])
        case Chain(universal=False):
            return _chain(reader, clause)
    raise Fault(SyntaxCode.EXPECTED_RELATION(), clause.at)


def _chain(reader: Elaborator, chain: Chain) -> Statement:
    sides, moduli = zip(*map(without_modulus, chain.sides), strict=True)
    if any(moduli):
        if not all(is_full_turn(each) for own in moduli for each in own):
            raise Fault(SyntaxCode.MODULUS(), chain.at)
        return modulo_turns(_chain(reader, replace(chain, sides=sides)), chain.at)
    for sign, at in chain.relations:
        if sign == "≈" and not any(each.small for each in reader.table.symbols.values()):
            message = SyntaxCode.APPROXIMATION()
            raise Fault(message, at)
        if sign not in ("=", "≠", "≈", *ORIENTATIONS):
            raise Fault(SyntaxCode.STATES_RANGE_ONLY_STATEMENTS(sign=sign), at)
    if any(map(is_extremal, chain.sides)):
        return _together(extrema(reader, chain))
    reader.tensor_operand = None
    reader.evaluations, reader.takes_bars = [], True
    reader.reaches.known = frozenset(angles_in(chain))
    reader.italic_differentials, reader.has_differentials = [], has_differentials(chain)
    terms = reader.with_units(as_rates(reader, [reader.term(side) for side in chain.sides]))
    reader.takes_bars = False
    if any(term.type == type_of_kind("matrix 4×1") for term in terms):
        terms = [reader.as_point(term, side.at) for term, side in zip(terms, chain.sides, strict=True)]
    _refuse_applied(reader, terms)
    _refuse_rows(terms, chain.sides)
    for term, side in zip(terms, chain.sides, strict=True):
        _refuse_depth(term, side.at)
    links = tuple(
        _link(reader, sign, at, left, right)
        for (sign, at), left, right in zip(chain.relations, terms, terms[1:], strict=False)
    )
    said = links[0] if len(links) == 1 else Conjunction(links)
    return under_places(reader, terms, said)


def _link(reader: Elaborator, sign: str, at: int, left: Term, right: Term) -> Statement:
    if sign in ORIENTATIONS:
        product = reader.apply(at, "dot" if sign == "\\perp" else "cross", left, right)
        return reader.build(at, construct.relation, "=", product, construct.zero(product.type))
    if reader.table.has_quaternions and {left.type, right.type} == {SCALAR, Type(4, 1)}:
        left, right = (reader.build(at, construct.as_quaternion, side) for side in (left, right))
    return reader.build(at, construct.relation, sign, left, right)


def _refuse_applied(reader: Elaborator, terms: Sequence[Term]) -> None:
    """Raises TypeMismatch for \\mathbf{D} T, the derivative of T, next to operators: it could be a product of
    two."""
    if reader.tensor_operand is not None and any(term.type.kind == "operator" for term in terms):
        fault = IllFormed(TypeCode.OPERATOR_BESIDE_TENSOR(), "brackets, or \\circ")
        raise TypeMismatch(fault, reader.tensor_operand)


def _refuse_rows(terms: Sequence[Term], sides: Sequence[Node]) -> None:
    """Raises TypeMismatch for vectors in a column next to a matrix: they may be meant as its rows."""
    sizes = {term.type.rows for term in terms if term.type.is_square}
    for term, side in zip(terms, sides, strict=True):
        entries = term.entries if isinstance(term, Block) else ()
        stacked = [row[0].type.kind for row in entries if len(row) == 1]
        if len(stacked) in sizes and stacked == ["vector"] * len(entries):
            raise Fault(SyntaxCode.VECTORS_BELOW_EACH_OTHER(), side.at)


def _refuse_depth(term: Term, at: int) -> None:
    level, depth = [term], 0
    while level:
        depth += 1
        if depth > DEEPEST_TERM:
            raise Fault(SyntaxCode.FORMULA_NESTS_DEEPER_THAN(DEEPEST_TERM=DEEPEST_TERM), at)
        level = [child for parent in level for child in parent.children]
