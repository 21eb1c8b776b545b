"""Reasons: a code, its arguments and a position. Messages are rendered from the templates of the codes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any, Self


@dataclass(frozen=True, order=True)
class Position:
    """A position in a formula: line and column, from 1."""

    line: int
    column: int

    def __str__(self) -> str:
        return f"line {self.line}, column {self.column}"


class Code(Enum):
    """The base class of the tables of codes. A member is `NAME = template`.

    template: the message, with the arguments in braces.
    """

    def __init__(self, template: str) -> None:
        self.template = template

    @property
    def slug(self) -> str:
        """The code as it appears in JSON and in the guide."""
        return self.name.lower().replace("_", "-")

    def __call__(self, **arguments: object) -> Reason:
        """Returns the reason with this code. Arguments are stored as text, except for inner reasons."""
        return Reason(self, {name: _kept(argument) for name, argument in arguments.items()})


class Reason(str):
    """The reason for a fault or a verdict. As a string it is the message; code must compare `code`, not the
    string.

    code: the code to compare.   arguments: the arguments of the message, by name.   position: of the fault.
    """

    code: Code
    arguments: Mapping[str, str]
    position: Position | None

    def __new__(
        cls, code: Code, arguments: Mapping[str, str] | None = None, position: Position | None = None
    ) -> Self:
        text = code.template.format_map(arguments or {})
        reason = super().__new__(cls, f"{position}: {text}" if position else text)
        reason.code, reason.arguments, reason.position = code, dict(arguments or {}), position
        return reason

    def __reduce__(self) -> tuple[Any, ...]:
        return Reason, (self.code, self.arguments, self.position)

    def at(self, line: int, column: int) -> Reason:
        """Returns the reason with a position; its message begins with the position."""
        return Reason(self.code, self.arguments, Position(line, column))

    def parts(self) -> Iterator[Reason]:
        """Yields the reason and all reasons among its arguments."""
        yield self
        for value in self.arguments.values():
            if isinstance(value, Reason):
                yield from value.parts()

    @property
    def codes(self) -> frozenset[Code]:
        """The codes of the reason and of its inner reasons."""
        return frozenset(part.code for part in self.parts())

    def to_dict(self) -> dict[str, Any]:
        """Returns JSON values: the code, the arguments and the position."""
        arguments = {
            name: value.to_dict() if isinstance(value, Reason) else value
            for name, value in self.arguments.items()
        }
        place = [self.position.line, self.position.column] if self.position else None
        return {"code": self.code.slug, "arguments": arguments, "position": place}

    @staticmethod
    def from_dict(data: Mapping[str, Any]) -> Reason:
        """Inverts `to_dict`. Raises KeyError, ValueError or TypeError for other data."""
        arguments = {
            name: value if isinstance(value, str) else Reason.from_dict(value)
            for name, value in data["arguments"].items()
        }
        place = data["position"]
        return Reason(code_named(data["code"]), arguments, Position(*place) if place else None)


def code_of(reason: str | None) -> Code | None:
    """Returns the code of a reason; None if there is no reason."""
    return reason.code if isinstance(reason, Reason) else None


def reason_of(error: Exception, otherwise: Code | None = None) -> Reason:
    """Returns the reason that an error carries, or a reason with the code `otherwise` made of its message."""
    carried = error.args[0] if error.args else None
    return carried if isinstance(carried, Reason) else (otherwise or ErrorCode.ERROR)(what=error)


def code_named(slug: str) -> Code:
    """Returns the code with this slug, from any loaded table. Raises ValueError for an unknown slug."""
    for table in Code.__subclasses__():
        for code in table:
            if code.slug == slug:
                return code
    raise ValueError(f"unknown code of a reason: {slug!r}")


def _kept(argument: object) -> str:
    return argument if isinstance(argument, Reason) else str(argument)


class ErrorCode(Code):
    """The code of an error that carries no reason."""

    ERROR = "{what}"
