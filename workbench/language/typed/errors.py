"""What can be wrong with a formula: it cannot be read, or it is read and does not fit together."""

from __future__ import annotations

from workbench.language.typed.terms import IllFormed

#: The messages of formulas that only say what their symbols are declared to be, and of expressions.
SAYS_NOTHING = "the formula says nothing"
ALONE = "expected a relation (= or \\neq), got an expression alone"


class ReadError(ValueError):
    """The text is not a formula of the claim language. `line` and `column` count from 1."""

    def __init__(self, message: str, line: int, column: int) -> None:
        super().__init__(f"line {line}, column {column}: {message}")
        self.message = message
        self.line = line
        self.column = column

    def __reduce__(self) -> tuple:
        """So that it can come from another process, as the other errors here can."""
        return ReadError, (self.message, self.line, self.column)


class IllFormedAt(IllFormed):
    """A formula whose types or weights do not fit; the place is the operation at fault."""

    def __init__(self, fault: IllFormed, line: int, column: int) -> None:
        super().__init__(f"line {line}, column {column}: {fault}", fault.intent, fault.usual)
        self.message = str(fault)
        self.line = line
        self.column = column

    def __reduce__(self) -> tuple:
        return IllFormedAt, (IllFormed(self.message, self.intent, self.usual), self.line, self.column)


class SpecError(ValueError):
    """An entry of [symbols] or [definitions] that cannot be used. `key` is the entry's LaTeX key."""

    def __init__(self, message: str, key: str) -> None:
        super().__init__(f"{key}: {message}")
        self.message = message
        self.key = key

    def __reduce__(self) -> tuple:
        return SpecError, (self.message, self.key)


def place(text: str, offset: int) -> tuple[int, int]:
    """Line and column of an offset, both from 1."""
    before = text[:offset]
    return before.count("\n") + 1, offset - (before.rfind("\n") + 1) + 1


class Fault(Exception):
    """A ReadError whose place is still an offset in the text."""

    def __init__(self, message: str, at: int) -> None:
        super().__init__(message)
        self.at = at


class Unranged(Fault):
    """An index, or the last of a sum, that nothing states a range for; it may be any."""

    def __init__(self, variable: str, message: str, at: int) -> None:
        super().__init__(message, at)
        self.variable = variable


class Misfit(Exception):
    """An IllFormedAt whose place is still an offset in the text."""

    def __init__(self, fault: IllFormed, at: int) -> None:
        super().__init__(str(fault))
        self.fault = fault
        self.at = at
