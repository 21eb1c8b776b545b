"""The reader: LaTeX to typed terms, strictly by type, without guesses."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import chain, starmap
from typing import TypeVar

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, IllFormedAt, ReadError, TypeMismatch, place
from workbench.core.reasons import Reason
from workbench.core.terms import Relation, Statement, Term
from workbench.core.types import SCALAR
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.elaboration.ranges import Range, names_a_set
from workbench.language.elaboration.statements import Reading, reading_of, term_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Lines, Node
from workbench.language.grammar.vocabulary import BY_HAND, EXPECTED
from workbench.language.naming.reading_conventions import Queries, Relaxation
from workbench.language.naming.symbols import SymbolTable

__all__ = ["IllFormedAt", "Range", "ReadError", "Reading", "read", "read_formula", "read_term", "unclaimed"]

Result = TypeVar("Result")

_SIGNS = re.compile(r"\\(pm|mp)(?![A-Za-z])")


def read(latex: str, table: SymbolTable, integers: Iterable[str] = ()) -> tuple[Statement, ...]:
    """Returns the statements of a formula, in reading order.

    There is one statement for each line of cases, aligned or array, and for each relation between commas.
    `integers` are the allowed integer variables (n, k_1 …), besides those for which the formula itself states
    a range (", n ≥ 1"). Raises ReadError for a syntax error, IllFormedAt if types or weights do not match;
    both with line and column.
    """
    return read_formula(latex, table, integers).statements


def read_formula(
    latex: str, table: SymbolTable, integers: Iterable[str] = (), as_condition: bool = False
) -> Reading:
    """Like `read`, but also returns the ranges that the formula states for its integers.

    as_condition: the statements between commas hold together, and none of them is a condition of the others.
    """
    names = frozenset(integers)
    sides = [len(_SIGNS.findall(side)) for side in latex.split("=")]
    says_both, says_either = all(sides) and len(sides) > 1, sorted(sides) == [0, 1]
    both = [_SIGNS.sub(partial(_sign, above), latex) for above in (True, False)]
    read = [
        _placed(text, table, lambda lines, table: reading_of(lines, table, names, as_condition))
        for text in (both if says_both or says_either else [latex])
    ]
    said = [each.statements for each in read]
    if says_either:
        return replace(read[0], statements=tuple(starmap(partial(_either, latex), zip(*said, strict=True))))
    return replace(read[0], statements=tuple(chain.from_iterable(said)))


def _either(latex: str, upper: Statement, lower: Statement) -> Statement:
    """Returns the statement that one of two scalar equations holds: the product of their differences is 0."""
    if upper == lower:
        return upper
    both = [each for each in (upper, lower) if isinstance(each, Relation)]
    if len(both) < 2 or both[0].operator != "=" or both[0].left.type != SCALAR:
        sign = _SIGNS.search(latex)
        assert sign is not None, "\\pm"
        raise ReadError(EXPECTED["pm"], *place(latex, sign.start()))
    differences = (construct.apply("add", each.left, construct.apply("neg", each.right)) for each in both)
    product = construct.apply("mul", *differences)
    return construct.relation("=", product, construct.zero())


def _sign(above: bool, match: re.Match[str]) -> str:
    return "+  " if above == (match[1] == "pm") else "-  "


def read_term(latex: str, table: SymbolTable, integers: Iterable[str] = ()) -> Term:
    """Returns the term of an expression without relations. Raises as `read`."""
    names = frozenset(integers)
    return _placed(latex, table, lambda lines, table: term_of(lines, table, names))


def meaning_of(node: Node, table: SymbolTable) -> Term | None:
    """Returns the term of a tree that may contain terms; None if it has none."""
    try:
        return Elaborator(table, frozenset()).term(node)
    except (Fault, TypeMismatch, RecursionError):
        return None


def unclaimed(error: ReadError, latex: str, table: SymbolTable) -> Reason:
    """Returns the reason why a formula states nothing. Raises `error` if it cannot be read as a statement,
    and as `read` for an expression that cannot be read."""
    if error.code is SyntaxCode.SAYS_NOTHING:
        return SyntaxCode.DECLARES_ONLY()
    if error.code is not SyntaxCode.ALONE:
        raise error
    try:
        read_term(latex, table)
    except ReadError:
        if not _placed(latex, table, lambda lines, table: names_a_set(lines)):
            raise
    return SyntaxCode.AN_EXPRESSION()


#: Questions on a formula that matches only in a reading that its paper neither uses nor excludes.
_QUESTIONS = {
    Relaxation.DYADS: SyntaxCode.OR_DYADS(),
    Relaxation.UNIT_TENSOR: SyntaxCode.OR_UNIT_TENSORS(),
    Relaxation.MERE_BRACKETS: SyntaxCode.OR_MERE_BRACKETS(),
    Relaxation.CROSS_OF_LAST_FACTOR: SyntaxCode.REACH_OF_CROSS(),
    Relaxation.ROW_FOR_COLUMN: SyntaxCode.ROW_OR_COLUMN(),
    Relaxation.OWN_SIGN: SyntaxCode.OR_A_DYAD(),
    Relaxation.LOGARITHM_AS_COLUMN: SyntaxCode.OR_A_COLUMN(),
}


def _placed(latex: str, table: SymbolTable, make: Callable[[Lines, SymbolTable], Result]) -> Result:
    if (number := BY_HAND.search(latex)) is not None:
        raise ReadError(SyntaxCode.NUMBER_FORMULA_OR_FACTOR(), *place(latex, number.start()))
    try:
        return make(parse(latex), table)
    except Fault as fault:
        raise ReadError(_short(fault.reason), *place(latex, fault.at)) from None
    except TypeMismatch as misfit:
        at = place(latex, misfit.at)
        if (question := _question(lambda loose: make(parse(latex), loose), table)) is not None:
            raise ReadError(question, *at) from None
        raise IllFormedAt(misfit.fault, *at) from None
    except RecursionError:
        raise ReadError(SyntaxCode.NOTATION_LEADS_BACK_ITSELF(), 1, 1) from None


def _question(make: Callable[[SymbolTable], object], table: SymbolTable) -> Reason | None:
    """Returns the question on a formula that does not match as read, but does in another reading; else None.

    Only readings that the reader asked for can change the result.
    """
    queries = Queries()
    with suppress(Fault, TypeMismatch):
        make(replace(table, conventions=table.conventions.logged(queries)))
    operands = (Relaxation.DYADS, Relaxation.UNIT_TENSOR)
    others = [each for each in _QUESTIONS if each not in operands]
    return (
        _question_on_relaxations(make, table, queries, [(each,) for each in operands])
        or _question_on_functions(make, table, queries)
        or _question_on_relaxations(make, table, queries, [*((each,) for each in others), operands])
    )


def _question_on_relaxations(
    make: Callable[[SymbolTable], object],
    table: SymbolTable,
    queries: Queries,
    trials: Iterable[tuple[Relaxation, ...]],
) -> Reason | None:
    """Returns the question on the first relaxations with which the formula matches."""
    conventions = table.conventions
    for several in trials:
        if queries.relaxations.isdisjoint(several) or not conventions.excluded.isdisjoint(several):
            continue
        with suppress(Fault, TypeMismatch):
            make(replace(table, conventions=conventions.relaxed(*several)))
            questions = [_QUESTIONS[each] for each in several if each not in conventions.loose]
            return (
                questions[0]
                if len(questions) == 1
                else SyntaxCode.TWO_QUESTIONS(first=questions[0], second=questions[1])
            )
    return None


def _question_on_functions(
    make: Callable[[SymbolTable], object], table: SymbolTable, queries: Queries
) -> Reason | None:
    """Returns the question on a symbol before a bracket if the formula matches with it as a function only."""
    conventions, symbols = table.conventions, sorted(queries.symbols)
    if not symbols or Relaxation.FACTORS_IN_BRACKETS in conventions.loose:
        return None
    for several in (*((each,) for each in symbols), tuple(symbols)):
        with suppress(Fault, TypeMismatch):
            make(replace(table, conventions=conventions.with_functions(several)))
            return _fault_of(make, replace(table, conventions=conventions.asking_about(several[:1])))
    return None


def _fault_of(make: Callable[[SymbolTable], object], table: SymbolTable) -> Reason | None:
    """Returns the reason of the fault that reading raises; None if it raises none."""
    try:
        make(table)
    except Fault as fault:
        return fault.reason
    except TypeMismatch:
        pass
    return None


def _short(reason: Reason) -> Reason:
    return reason if len(reason) <= 300 else SyntaxCode.SHORTENED(shortened=f"{reason[:299]}…", reason=reason)
