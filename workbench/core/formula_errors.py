"""Errors in a formula: a syntax error, or types and weights that do not match."""

from __future__ import annotations

from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.reasons import Code, Reason
from workbench.core.terms import IllFormed


class ReadError(ValueError):
    """A text that is not a formula of the claim language. `line` and `column` count from 1."""

    def __init__(self, message: str, line: int, column: int) -> None:
        self.message = _reason(message, SyntaxCode.UNREADABLE)
        self.reason = self.message.at(line, column)
        super().__init__(self.reason)
        self.line = line
        self.column = column

    @property
    def code(self) -> Code:
        return self.message.code

    def __reduce__(self) -> tuple[object, ...]:
        """Makes the error picklable, so that it can be sent between processes."""
        return ReadError, (self.message, self.line, self.column)


class IllFormedAt(IllFormed):
    """A formula whose types or weights do not match, with the position of the faulty operation."""

    def __init__(self, fault: IllFormed, line: int, column: int) -> None:
        super().__init__(fault.reason.at(line, column), fault.intent)
        self.message = fault.reason
        self.line = line
        self.column = column

    def __reduce__(self) -> tuple[object, ...]:
        return IllFormedAt, (IllFormed(self.message, self.intent), self.line, self.column)


class SpecError(ValueError):
    """An unusable entry of [symbols] or [definitions]. `key` is the entry's LaTeX key."""

    def __init__(self, message: str, key: str) -> None:
        self.message = _reason(message, DeclarationCode.REFUSED)
        self.reason = DeclarationCode.OF_ENTRY(key=key, message=self.message)
        super().__init__(self.reason)
        self.key = key

    @property
    def code(self) -> Code:
        return self.message.code

    def __reduce__(self) -> tuple[object, ...]:
        return SpecError, (self.message, self.key)


def place(text: str, offset: int) -> tuple[int, int]:
    """Returns the line and column of an offset, both from 1."""
    before = text[:offset]
    return before.count("\n") + 1, offset - (before.rfind("\n") + 1) + 1


class Fault(Exception):
    """A ReadError whose position is still an offset in the text."""

    def __init__(self, message: str, at: int) -> None:
        self.reason = _reason(message, SyntaxCode.UNREADABLE)
        super().__init__(self.reason)
        self.at = at


class Unranged(Fault):
    """An index or a sum bound without a declared range; it may take any value."""

    def __init__(self, variable: str, message: str, at: int) -> None:
        super().__init__(message, at)
        self.variable = variable


class TypeMismatch(Exception):
    """An IllFormedAt whose position is still an offset in the text."""

    def __init__(self, fault: IllFormed, at: int) -> None:
        super().__init__(fault.reason)
        self.fault = fault
        self.at = at


def _reason(message: str, otherwise: Code) -> Reason:
    return message if isinstance(message, Reason) else otherwise(message=message)
