"""Reasons: a code, its arguments and a position. Messages are made from the templates of the codes here."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any, Self


@dataclass(frozen=True, order=True)
class Position:
    """A place in a formula: line and column, from 1."""

    line: int
    column: int

    def __str__(self) -> str:
        return f"line {self.line}, column {self.column}"


class Code(Enum):
    """The base of the tables of codes. A member is `NAME = template`.

    template: the message, with the arguments in braces."""

    def __init__(self, template: str) -> None:
        self.template = template

    @property
    def slug(self) -> str:
        """The code as JSON and the guide have it."""
        return self.name.lower().replace("_", "-")

    def __call__(self, **arguments: object) -> Reason:
        """The reason with this code. An argument is kept as a reason if it is one, else as its text."""
        return Reason(self, {name: _kept(argument) for name, argument in arguments.items()})


class Reason(str):
    """Why a formula or a verdict is what it is. As a string it is the message, which no code may compare.

    code: what is compared.   arguments: what stands in the message, by name.   position: of the fault."""

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
        """The reason with its position, from which its message then begins."""
        return Reason(self.code, self.arguments, Position(line, column))

    def parts(self) -> Iterator[Reason]:
        """The reason, and those among its arguments."""
        yield self
        for value in self.arguments.values():
            if isinstance(value, Reason):
                yield from value.parts()

    @property
    def codes(self) -> frozenset[Code]:
        """The codes of its parts."""
        return frozenset(part.code for part in self.parts())

    def to_dict(self) -> dict[str, Any]:
        """JSON values: the code, the arguments and the position."""
        arguments = {
            name: value.to_dict() if isinstance(value, Reason) else value
            for name, value in self.arguments.items()
        }
        place = [self.position.line, self.position.column] if self.position else None
        return {"code": self.code.slug, "arguments": arguments, "position": place}

    @staticmethod
    def from_dict(data: Mapping[str, Any]) -> Reason:
        """Inverts `to_dict`. Raises KeyError, ValueError or TypeError for anything else."""
        arguments = {
            name: value if isinstance(value, str) else Reason.from_dict(value)
            for name, value in data["arguments"].items()
        }
        place = data["position"]
        return Reason(code_named(data["code"]), arguments, Position(*place) if place else None)


def code_of(reason: str | None) -> Code | None:
    """The code of a reason; None for no reason."""
    return reason.code if isinstance(reason, Reason) else None


def reason_of(error: Exception) -> Reason:
    """The reason that an error carries, or else its message as one."""
    carried = error.args[0] if error.args else None
    return carried if isinstance(carried, Reason) else ErrorCode.ERROR(what=error)


def code_named(slug: str) -> Code:
    """The code with this slug, from any table that is loaded. Raises ValueError for an unknown one."""
    for table in Code.__subclasses__():
        for code in table:
            if code.slug == slug:
                return code
    raise ValueError(f"unknown code of a reason: {slug!r}")


def _kept(argument: object) -> str:
    return argument if isinstance(argument, Reason) else str(argument)


class ErrorCode(Code):
    """The code of an error that carries no reason of its own."""

    ERROR = "{what}"
