"""The formulas of one step of a display, read in its notation, with the positions of their faults."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Formula, Notation
from workbench.context.condition_facts import opaque
from workbench.context.facts import Fact
from workbench.context.index_values import Orders, orders_within
from workbench.context.read_formulas import read_statement, with_intent
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.names import Name
from workbench.core.reasons import Reason, reason_of
from workbench.core.spans import Span
from workbench.language.reader import unclaimed
from workbench.papers.numbered_symbols import written_out
from workbench.papers.texts.model_assignments import Placed
from workbench.source.documents import Display, Token, spelled
from workbench.source.rows.display_vocabulary import RELATIONS

_IN_WORDS = re.compile(r"\\(?:text|textrm|mbox|mathrm)\{\s*(?:is|are|denotes?|represents?)\b")
_TILDE = re.compile(r"\\(?:wide)?tilde(?![A-Za-z])")


def printed_formula(placed: Placed, orders: Orders | None, excused: bool) -> tuple[Formula, Orders | None]:
    latex, owners = placed.step.spelled()
    if placed.step.denied is not None:
        return Formula(latex, unread=SyntaxCode.DENIED(words=placed.step.denied)), orders
    opaque = sorted(
        name for name in placed.display.opaque if re.search(rf"\\{re.escape(name)}(?![A-Za-z])", latex)
    )
    if opaque:
        names = ", ".join(f"\\{name}" for name in opaque)
        return Formula(latex, unread=SyntaxCode.OPAQUE_MACROS(names=names)), orders
    try:
        statement, ranges = read_statement(latex, placed.notation, orders)
        return Formula(latex, statement), orders_within(orders, ranges)
    except IllFormedAt as error:
        at = _at(latex, owners, error.line, error.column)
        if _TILDE.search(latex):
            return Formula(
                latex, unread=SyntaxCode.CANNOT_BE_READ(why=SyntaxCode.TILDE_DOES_NOT_FIT()), at=at
            ), orders
        return Formula(latex, ill_formed=_message(error), at=at), orders
    except ReadError as error:
        if placed.step.ranges:
            bare = replace(placed, step=placed.step.without_ranges())
            if (found := printed_formula(bare, orders, excused))[0].statement is not None:
                return found
        if (said := written_out(latex, placed.notation)) is not None:
            return Formula(latex, said), orders
        if _IN_WORDS.search(latex) and not any(token.text in RELATIONS for token in placed.step.tokens):
            return Formula(latex, unread=SyntaxCode.SAYS_IN_WORDS()), orders
        at = _at(latex, owners, error.line, error.column)
        return Formula(latex, unread=_why_unread(error, latex, placed.notation), at=at), orders
    except ValueError as error:
        return Formula(latex, unread=SyntaxCode.UNUSABLE_ORDERS(orders_fault=error)), orders


def _why_unread(error: ReadError, latex: str, notation: Notation) -> Reason:
    with suppress(ReadError, IllFormedAt):
        return unclaimed(error, latex, notation.symbols)
    return unreadable(error.message)


def unreadable(why: Reason) -> Reason:
    return why if why.code is SyntaxCode.CANNOT_BE_READ else SyntaxCode.CANNOT_BE_READ(why=why)


def assumed_formulas(placed: Placed, printed: Formula) -> tuple[tuple[Formula, ...], Formula]:
    """Returns the conditions next to the formula, and the formula, which is unread if a condition is."""
    made: list[Formula] = []
    for tokens in placed.step.assumed:
        latex, owners = spelled(tokens)
        try:
            made.append(Formula(latex, read_statement(latex, placed.notation, None)[0]))
        except (ReadError, IllFormedAt) as error:
            why = SyntaxCode.CONDITION_UNREAD(formula=latex, why=error.message)
            return (), replace(
                printed, statement=None, unread=why, at=_at(latex, owners, error.line, error.column)
            )
    return tuple(made), printed


def reasons_of(placed: Placed, about: frozenset[Name]) -> tuple[list[Formula], tuple[Fact, ...]]:
    """Returns the reasons that the author gives for the step, and opaque facts for unreadable ones."""
    made: list[Formula] = []
    unread: list[Fact] = []
    for tokens in placed.step.reasons:
        formula = side_formula(tokens, placed)
        if formula.statement is not None:
            made.append(formula)
        elif about:
            unread.append(opaque(formula.latex, placed.display.source.place(tokens[0].start)[0], about))
    return made, tuple(unread)


def side_formula(tokens: Sequence[Token], placed: Placed) -> Formula:
    """Returns the formula of tokens next to a step or in its place, with the reason if it cannot be read."""
    latex, _ = spelled(tokens)
    try:
        return Formula(latex, read_statement(latex, placed.notation, None)[0])
    except IllFormedAt as error:
        return Formula(latex, ill_formed=_message(error))
    except (ReadError, ValueError) as error:
        return Formula(latex, unread=unreadable(reason_of(error)))


def _message(error: IllFormedAt) -> Reason:
    """Returns why it is ill-formed, without the position, which is that of the claim."""
    return with_intent(error.message, error)


def _at(latex: str, owners: Sequence[Token], line: int, column: int) -> Span:
    """Returns the span of the author's characters at a position of the formula."""
    offset = sum(len(text) + 1 for text in latex.split("\n")[: line - 1]) + column - 1
    token = owners[min(max(offset, 0), len(owners) - 1)]
    return _span([token])


def span_of(tokens: Sequence[Token], display: Display) -> Span:
    """Returns the span of the author's characters; macros stand where they are called."""
    own = [token for token in tokens if token.source is display.source]
    own = [token for token in own if display.start <= token.start and token.end <= display.end]
    if own:
        return _span(own)
    source = display.source
    return Span(source.path, *source.place(display.start), *source.place(display.end))


def _span(tokens: Sequence[Token]) -> Span:
    first = min(tokens, key=lambda token: token.start)
    last = max(tokens, key=lambda token: token.end)
    return Span(first.source.path, *first.source.place(first.start), *last.source.place(last.end))
