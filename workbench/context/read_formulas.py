"""Reader of the formulas of a paper file, which reports faults by their position in the file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NoReturn

from workbench.context.circular_conditions import IS_THE_CONCLUSION, is_conclusion
from workbench.context.claims import Formula, Notation
from workbench.context.index_values import Orders, orders_within
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, IllFormedAt, ReadError, place
from workbench.core.paper_errors import KeyPath
from workbench.core.reasons import Reason
from workbench.core.terms import Conjunction, Statement
from workbench.language.reader import Range, read_formula
from workbench.source.rewriting.formulas_in_models import or_respelled
from workbench.source.rows.formula_lines import Line, whole_line
from workbench.source.toml.toml_file import TomlTable

#: A hypothesis in words: of an argument, or the branch of an inverse function.
WORDS = re.compile(r"\\text\{[^{}\\]+\}")


@dataclass(frozen=True)
class FormulaReader:
    """Reads the formulas of the claim at `path`."""

    toml: TomlTable
    path: KeyPath
    notation: Notation
    orders: Orders | None

    def printed(self, line: Line, excused: bool) -> tuple[Formula, FormulaReader]:
        """Returns the printed form, and a reader of the claim's other formulas that has the printed ranges.

        An ill-typed formula gets a verdict. A syntax error is an error of the file, unless the claim gives a
        reading.
        """
        try:
            statement, ranges = self._read(line.latex)
        except IllFormedAt as error:
            return Formula(line.latex, ill_formed=why_ill_formed(error)), self
        except ReadError as error:
            if excused and _is_latex(line.latex):
                return Formula(line.latex, ill_formed=SyntaxCode.CANNOT_BE_READ(why=error.reason)), self
            self._fail(("printed",), line, error)
        return Formula(line.latex, statement), self._within("printed", ranges)

    def reading(self, line: Line) -> tuple[Formula, FormulaReader]:
        """Returns the intended reading, and a reader of the claim's other formulas that has its ranges."""
        try:
            statement, ranges = self._read_by_hand(line.latex)
        except (ReadError, IllFormedAt) as error:
            self._fail(("reading",), line, error)
        return Formula(line.latex, statement), self._within("reading", ranges)

    def intended(self, key: str, line: Line | None = None) -> Formula | None:
        """Returns a reading, a correction or a hypothesis, which must be well-typed; None if the claim has
        none.
        """
        if line is None:
            text = self.toml.text((*self.path, key))
            return None if text is None else self._intended((key,), whole_line(text))
        return self._intended((key,), line)

    def assumed(self) -> tuple[Formula, ...]:
        """Returns the assumptions, which must be well-typed."""
        texts = enumerate(self.toml.texts((*self.path, "assume")))
        return tuple(self._intended(("assume", index), whole_line(text)) for index, text in texts)

    def conditions(self, printed: Formula) -> tuple[Formula, ...]:
        """Returns the conditions assumed for the printed formula.

        Raises:
            PaperError: A condition is the conclusion itself.
        """
        found = self.assumed()
        for index, formula in enumerate(found):
            self._refuse_conclusion(("assume", index), formula, printed)
        return found

    def hypothesis(self, printed: Formula) -> Formula | None:
        """Returns the supposed hypothesis that the text does not state. Raises PaperError as `conditions`
        does.
        """
        found = self.intended("hypothesis")
        if found is not None:
            self._refuse_conclusion(("hypothesis",), found, printed)
        return found

    def _refuse_conclusion(self, place: KeyPath, formula: Formula, printed: Formula) -> None:
        said, definitions = printed.statement, self.notation.definitions
        if said is not None and is_conclusion(formula.parsed, said, definitions):
            raise self.toml.error_at_value((*self.path, *place), f"{place[0]}: {IS_THE_CONCLUSION}")

    def _intended(self, place: KeyPath, line: Line) -> Formula:
        try:
            as_condition = place[0] in ("hypothesis", "assume")
            return Formula(line.latex, self._read_by_hand(line.latex, as_condition)[0])
        except (ReadError, IllFormedAt) as error:
            self._fail(place, line, error)

    def _within(self, key: str, ranges: Sequence[Range]) -> FormulaReader:
        try:
            return replace(self, orders=orders_within(self.orders, ranges))
        except ValueError as error:
            where = "orders" if self.orders else key
            raise self.toml.error_at_value((*self.path, where), str(error)) from None

    def _read(self, latex: str, as_condition: bool = False) -> tuple[Statement, tuple[Range, ...]]:
        return read_statement(latex, self.notation, self.orders, as_condition)

    def _read_by_hand(self, latex: str, as_condition: bool = False) -> tuple[Statement, tuple[Range, ...]]:
        return or_respelled(latex, self.notation.words, lambda text: self._read(text, as_condition))

    def _fail(self, place: KeyPath, within: Line, error: ReadError | IllFormedAt) -> NoReturn:
        inside = within.place(error.line, error.column)
        message = SyntaxCode.FAULT_OF_KEY(key=place[0], message=error.message)
        raise self.toml.error_in_string((*self.path, *place), *inside, message) from None


def _is_latex(latex: str) -> bool:
    """True if the braces match. A printed formula may be garbled, but it must be valid to typeset."""
    depth = 0
    for mark in re.findall(r"\\.|[{}]", latex, re.DOTALL):
        depth += {"{": 1, "}": -1}.get(mark, 0)
        if depth < 0:
            return False
    return depth == 0


def why_ill_formed(error: IllFormedAt) -> Reason:
    """Returns why the formula is ill-formed, with its likely meaning if there is one."""
    return with_intent(error.reason, error)


def with_intent(reason: Reason, error: IllFormedAt) -> Reason:
    return SyntaxCode.LIKELY_MEANT(fault=reason, intent=error.intent) if error.intent else reason


def read_statement(
    latex: str, notation: Notation, orders: Orders | None, as_condition: bool = False
) -> tuple[Statement, tuple[Range, ...]]:
    """Returns the formula as one statement, and the ranges that it states for its integers. Raises ReadError,
    also for a bar of evaluation whose variable stands outside of it in a definition."""
    integers = orders.variables if orders else ()
    reading = read_formula(latex, notation.symbols, integers, as_condition)
    for apart in reading.apart:
        try:
            apart.require(notation.definitions)
        except Fault as fault:
            raise ReadError(fault.reason, *place(latex, fault.at)) from None
    statements = reading.statements
    return statements[0] if len(statements) == 1 else Conjunction(statements), reading.ranges
