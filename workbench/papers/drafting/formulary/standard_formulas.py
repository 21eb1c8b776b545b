"""The standard formulas of the field, one .toml file a subject."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib import resources
from typing import Any

from workbench.core.terms import Relation
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_formula
from workbench.papers.drafting.formulary.normal_sums import (
    NO_CELL,
    Monomial,
    Node,
    Sum,
    equation_sum,
    leaves_of,
    normal_sum,
)

#: Operations that no misprint loses, by the LaTeX of formulas here.
_OPERATIONS = {
    "block": re.compile(r"\\begin"),
    "cross": re.compile(r"\\times|skew"),
    "sin": re.compile(r"\\(?:sin|cos|tan|cot|sec|csc)(?![a-zA-Z])"),
}
#: Marks that may be those of a skew tensor.
_MARKED = re.compile(r"\\(?:wide)?(?:tilde|hat)")
#: A capital letter that is not part of an escape.
_CAPITAL = re.compile(r"(?<!\\)[A-Z]")


@dataclass(frozen=True)
class StandardFormula:
    """A formula that texts of the field print.

    Attributes:
        name: What it is the formula for.
        words: A regular expression for words by which texts speak of it.
        source: Where it is derived.
        symbols: Symbol → kind, as in a model.
        formula: In LaTeX.
        given: The assumptions from which it follows.
        definition: True if nothing proves it, as it says what its left side is.
    """

    name: str
    words: str
    source: str
    symbols: Mapping[str, str | Mapping[str, Any]] = field(hash=False)
    formula: str
    given: tuple[str, ...] = ()
    definition: bool = False

    @cached_property
    def statement(self) -> Relation:
        table = SymbolTable.build(
            {name: {"kind": kind} if isinstance(kind, str) else kind for name, kind in self.symbols.items()}
        )
        (said,) = read_formula(self.formula, table).statements
        assert isinstance(said, Relation), self.formula
        return said

    @cached_property
    def sum(self) -> Sum:
        return equation_sum(self.statement)

    @cached_property
    def operations(self) -> frozenset[str]:
        """The operations that it has, of those that no misprint loses."""
        if _MARKED.search(self.formula):
            return operations_in(self.sum)
        return frozenset(name for name, sign in _OPERATIONS.items() if sign.search(self.formula))

    @cached_property
    def left(self) -> frozenset[Monomial]:
        """The monomials of its left side."""
        return frozenset(normal_sum(self.statement.left).monomials)

    @cached_property
    def size(self) -> int:
        """The count of its symbols, each as often as it occurs."""
        return sum(1 for each in self.sum.monomials for _ in leaves_of(each))

    def is_meant_in(self, text: str) -> bool:
        """True if a text, in lower case, has the words."""
        return _pattern(self.words).search(text) is not None


def operations_in(own: Sum) -> frozenset[str]:
    """Returns the operations in a sum, of those that no misprint loses."""
    found = set()
    waiting: list[object] = [own]
    while waiting:
        match waiting.pop():
            case Sum(monomials=monomials):
                found |= {"block" for each in monomials if each.cell != NO_CELL}
                waiting += [part for each in monomials for part, _ in each.powers]
                waiting += [each.word for each in monomials]
            case Node(head=head, parts=parts):
                found.add({"skew": "cross", "cos": "sin"}.get(head, head))
                waiting += parts
    return frozenset(found & _OPERATIONS.keys())


@cache
def _pattern(words: str) -> re.Pattern[str]:
    return re.compile(_CAPITAL.sub(lambda letter: letter[0].lower(), words))


@cache
def standard_formulas() -> tuple[StandardFormula, ...]:
    """Returns the formulas of all subjects."""
    found = []
    folder = resources.files(__package__ or "")
    for file in sorted((each for each in folder.iterdir() if each.name.endswith(".toml")), key=str):
        for entry in tomllib.loads(file.read_text(encoding="utf-8"))["formula"]:
            found.append(StandardFormula(**{**entry, "given": tuple(entry.get("given", ()))}))
    return tuple(found)
