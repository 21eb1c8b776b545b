"""The formulas of a paper file: read with its notation, their faults placed in the file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NoReturn

from workbench.language.errors import IllFormedAt, ReadError
from workbench.language.reader import Range, read_formula
from workbench.language.terms import Conjunction, Statement
from workbench.papers.lines import Line
from workbench.papers.model import Formula, Notation
from workbench.papers.orders import Orders, orders_within
from workbench.papers.toml_file import TomlFile
from workbench.papers.toml_places import KeyPath


@dataclass(frozen=True)
class FormulaReader:
    """Reads the formulas of the claim at `path`."""

    toml: TomlFile
    path: KeyPath
    notation: Notation
    orders: Orders | None

    def printed(self, line: Line, excused: bool) -> tuple[Formula, FormulaReader]:
        """The printed form, and the reader of what belongs to it: with the orders that it states.

        Ill-formed is a verdict and no fault of the file; unreadable is one, unless the claim gives a reading.
        """
        try:
            statement, ranges = self._read(line.latex)
        except IllFormedAt as error:
            return Formula(line.latex, ill_formed=why_ill_formed(error)), self
        except ReadError as error:
            if excused:
                return Formula(line.latex, ill_formed=f"cannot be read: {error}"), self
            self._fail(("printed",), line, error)
        return Formula(line.latex, statement), self._within("printed", ranges)

    def reading(self, line: Line) -> tuple[Formula, FormulaReader]:
        """The intended reading, and the reader of what belongs to it."""
        try:
            statement, ranges = self._read(line.latex)
        except (ReadError, IllFormedAt) as error:
            self._fail(("reading",), line, error)
        return Formula(line.latex, statement), self._within("reading", ranges)

    def intended(self, key: str, line: Line | None = None) -> Formula | None:
        """A reading, a correction or a hypothesis, which must make sense; None if the claim has none."""
        if line is None:
            text = self.toml.text((*self.path, key))
            return None if text is None else self._intended((key,), Line(text))
        return self._intended((key,), line)

    def intended_list(self, key: str) -> tuple[Formula, ...]:
        texts = self.toml.texts((*self.path, key))
        return tuple(self._intended((key, index), Line(text)) for index, text in enumerate(texts))

    def _intended(self, place: KeyPath, line: Line) -> Formula:
        try:
            return Formula(line.latex, self._read(line.latex)[0])
        except (ReadError, IllFormedAt) as error:
            self._fail(place, line, error)

    def _within(self, key: str, ranges: Sequence[Range]) -> FormulaReader:
        try:
            return replace(self, orders=orders_within(self.orders, ranges))
        except ValueError as error:
            where = "orders" if self.orders else key
            raise self.toml.error_at_value((*self.path, where), str(error)) from None

    def _read(self, latex: str) -> tuple[Statement, tuple[Range, ...]]:
        return read_statement(latex, self.notation, self.orders)

    def _fail(self, place: KeyPath, within: Line, error: ReadError | IllFormedAt) -> NoReturn:
        inside = within.place(error.line, error.column)
        message = f"{place[0]}: {error.message}"
        raise self.toml.error_in_string((*self.path, *place), *inside, message) from None


def why_ill_formed(error: IllFormedAt) -> str:
    return f"{error}; likely meant: {error.intent}" if error.intent else str(error)


def read_statement(
    latex: str, notation: Notation, orders: Orders | None
) -> tuple[Statement, tuple[Range, ...]]:
    """What the formula says, as one statement, and the ranges that it states for its integers."""
    reading = read_formula(latex, notation.symbols, orders.variables if orders else ())
    statements = reading.statements
    return statements[0] if len(statements) == 1 else Conjunction(statements), reading.ranges
