"""What is known while a text is read: the author's declarations, what could not be expanded, and warnings."""

from __future__ import annotations

from dataclasses import dataclass, field

from workbench.papers.texts.tex.stream import TokenStream
from workbench.papers.texts.tex.tokens import Token
from workbench.papers.texts.view import Source

NO_VALUE = "\\NoValueMarker"
TRUE, FALSE = "\\BooleanTrueMarker", "\\BooleanFalseMarker"


@dataclass(frozen=True)
class Parameter:
    """One argument. kind: braces | until | star | optional | token; `marks`: the tokens around it or behind.
    `counted`: a # means it."""

    kind: str
    marks: tuple[str, ...] = ()
    default: tuple[Token, ...] | None = None
    counted: bool = True


@dataclass(frozen=True)
class Macro:
    """`prefix`: tokens that must follow the name; `keeps`: it stands for a command of TeX itself."""

    parameters: tuple[Parameter, ...]
    body: tuple[Token, ...]
    defined: tuple[Source, int] | None
    prefix: tuple[str, ...] = ()
    keeps: bool = False


@dataclass(frozen=True)
class Environment:
    begin: Macro
    end: Macro


@dataclass
class Names:
    """What the author has declared."""

    macros: dict[str, Macro] = field(default_factory=dict)
    environments: dict[str, Environment] = field(default_factory=dict)
    flags: dict[str, bool] = field(default_factory=dict)


class State(TokenStream):
    """`overrides`: macros that are kept whatever the text declares. `opaque`: names of macros that cannot be
    expanded, and are left as they stand."""

    def __init__(self, overrides: Names | None = None) -> None:
        super().__init__()
        self.names = Names()
        if overrides is not None:
            self.names.macros |= overrides.macros
            self.names.environments |= overrides.environments
        self.overrides = frozenset(self.names.macros)
        self.opaque: set[str] = set()
        self.left_opaque: set[str] = set()  # of these, what the formula being read uses
        self.fences: dict[str, str] = {}  # of these, what seems to be a pair of brackets
        self.in_formula = False
        self.warnings: list[tuple[Token, str]] = []

    def warn(self, token: Token, message: str) -> None:
        if all(known != message for _, known in self.warnings):
            self.warnings.append((token, message))

    def declare(self, name: str, macro: Macro) -> None:
        if name not in self.overrides:
            self.names.macros[name] = macro
            self.opaque.discard(name)

    def undecided(self, token: Token) -> None:
        if self.in_formula:
            self.left_opaque.add(token.word or token.text)
            self.warn(
                token, f"{token.text}: what it depends on is not in the text; its first branch is taken"
            )
