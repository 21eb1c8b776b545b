"""The state while a text is read: the author's declarations, unexpandable macros, and warnings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from workbench.source.documents.tex.groups import CELL, CLOSING, LEFT, OPENING, Groups, environment, has_cells
from workbench.source.documents.tex.stream import TokenStream
from workbench.source.documents.tex.tex_tokens import Token

T = TypeVar("T")

NO_VALUE = "\\NoValueMarker"
TRUE, FALSE = "\\BooleanTrueMarker", "\\BooleanFalseMarker"


@dataclass(frozen=True)
class Parameter:
    """A parameter of a macro.

    kind: braces | until | star | optional | token.   marks: the tokens around or after it.
    counted: True if it has a number (#1).
    """

    kind: str
    marks: tuple[str, ...] = ()
    default: tuple[Token, ...] | None = None
    counted: bool = True


@dataclass(frozen=True)
class Macro:
    """A macro.

    prefix: tokens that must follow the name.   keeps: it stands for a primitive of TeX.
    protected: \\edef leaves it unexpanded.
    """

    parameters: tuple[Parameter, ...]
    body: tuple[Token, ...]
    prefix: tuple[str, ...] = ()
    keeps: bool = False
    protected: bool = False


@dataclass(frozen=True)
class Environment:
    begin: Macro
    end: Macro


@dataclass
class Names:
    """The declarations of the author.

    printed: environments declared as printed (True) or not (False); others have LaTeX's meaning.
    """

    macros: dict[str, Macro] = field(default_factory=dict)
    environments: dict[str, Environment] = field(default_factory=dict)
    flags: dict[str, bool] = field(default_factory=dict)
    printed: dict[str, bool] = field(default_factory=dict)


class State(TokenStream):
    """The state of the reader.

    overrides: macros that the text cannot redefine.   opaque: names of macros that cannot be expanded.
    """

    def __init__(self, overrides: Names | None = None) -> None:
        super().__init__()
        self.names = Names()
        self.groups = Groups()
        self.prefixes: frozenset[str] = (
            frozenset()
        )  # \global and similar prefixes before the current declaration
        if overrides is not None:
            self.names.macros |= overrides.macros
            self.names.environments |= overrides.environments
        self.overrides = frozenset(self.names.macros)
        self.opaque: set[str] = set()
        self.left_opaque: set[str] = set()  # the opaque macros that the current formula uses
        self.fences: dict[str, str] = {}  # the opaque macros that seem to be pairs of brackets
        self.in_formula = False
        self.warnings: list[tuple[Token, str]] = []

    def warn(self, token: Token, message: str) -> None:
        if all(known != message for _, known in self.warnings):
            self.warnings.append((token, message))

    def declare(self, name: str, macro: Macro, everywhere: bool = False) -> None:
        """Defines a macro until the end of the innermost group, or in all groups."""
        if name not in self.overrides:
            self.assign(self.names.macros, name, macro, everywhere)
            self.opaque.discard(name)

    def assign(self, values: dict[str, T], name: str, value: T, everywhere: bool = False) -> None:
        """Assigns a value to a name until the end of the innermost group, or in all groups."""
        self.groups.assign(values, name, value, everywhere)

    def end_group(self, kind: str) -> None:
        """Ends the innermost group of this kind, and the groups in it."""
        self.opaque -= self.groups.end(kind)

    def end_groups_to(self, depth: int) -> None:
        """Ends the groups beyond the first `depth`."""
        self.opaque -= self.groups.end_to(depth)

    def begin_environment(self, name: str) -> None:
        self.groups.begin(environment(name))
        if has_cells(name):
            self.groups.begin(CELL)

    def follow_groups(self, text: str) -> None:
        """Begins or ends groups according to a token of the text."""
        if text in OPENING:
            self.groups.begin(OPENING[text])
        elif text in CLOSING:
            self.end_group(CLOSING[text])
        elif text == "\\middle":
            self.end_group(LEFT)
            self.groups.begin(LEFT)
        elif text in ("&", "\\\\") and self.groups.innermost == CELL:
            self.end_group(CELL)
            self.groups.begin(CELL)

    def fully_expanded(self, body: Sequence[Token]) -> list[Token]:
        """Returns the tokens that \\edef stores."""
        raise NotImplementedError

    def undecided(self, token: Token) -> None:
        if self.in_formula:
            self.left_opaque.add(token.word or token.text)
            self.warn(
                token, f"{token.text}: what it depends on is not in the text; its first branch is taken"
            )
