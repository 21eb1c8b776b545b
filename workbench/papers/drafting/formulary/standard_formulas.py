"""The standard formulas of the field, one .toml file a subject."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import resources
from typing import Any

from workbench.core.terms import Relation
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_formula
from workbench.papers.drafting.formulary.normal_sums import (
    NO_CELL,
    Leaf,
    Monomial,
    Node,
    Sum,
    equation_sum,
    leaves_of,
    normal_sum,
    parts_of,
)
from workbench.papers.drafting.formulary.renamings import as_letter

#: Operations that no misprint loses, by the LaTeX of formulas here.
_OPERATIONS = {
    "block": re.compile(r"\\begin"),
    "cross": re.compile(r"\\times|skew"),
    "root": re.compile(r"\\sqrt|\^\{\d+/2\}"),
    "sin": re.compile(r"\\(?:sin|cos|tan|cot|sec|csc)(?![a-zA-Z])"),
}
#: A dot over a symbol, a mark that makes a skew tensor of one, and a family of symbols.
_DOTS = re.compile(r"\\d*dot\{([^{}]*)\}")
_SKEW = re.compile(r"\\(?:wide)?(?:tilde|hat)\{[^{}]*\}(?:_\w)?")
_WORDS = re.compile(r"\\(?:begin|end|operatorname|mathbf|text)\{[^{}]*\}")
_FAMILY = re.compile(r"_\{?[ijk]|\^")
#: Numbers that are not declared.
_UNDECLARED = ("\\pi", "t")
#: Kinds of a left side → what it is.
_SHAPES = {
    "scalar": "number",
    "vector": "column",
    "tensor": "square",
    "rotation": "square",
    "transform": "square",
}
_SYMBOL = re.compile(r"(?:\\Delta )?(?:\\[a-zA-Z]+|[a-zA-Z])(?:_(?:\{[^{}]*\}|\\[a-zA-Z]+|\w))?'*")
_LETTER = re.compile(r"\\[a-zA-Z]+|[a-zA-Z]")
#: How often a symbol of its LaTeX may stand in its sum, and the weight of a formula that needs no letters.
_MOST_COPIES, LONG = 2, 20
#: A capital letter that is not part of an escape.
_CAPITAL = re.compile(r"(?<!\\)[A-Z]")


@dataclass(frozen=True)
class Profile:
    """What no renaming changes.

    operations: those of its operations that no misprint loses.   numbers, others: the counts of its symbols.
    shape: what its addends are, if that is known: numbers, columns, square matrices, or others.
    """

    operations: frozenset[str]
    numbers: int
    others: int
    shape: str = ""

    def may_be(self, printed: Profile) -> bool:
        """True if a printed formula may be one of this profile, or a misprint of one, which may lose a
        symbol."""
        lost = (self.numbers - printed.numbers, self.others - printed.others)
        is_alike = "" in (self.shape, printed.shape) or self.shape == printed.shape
        return sum(lost) in (0, 1) and min(lost) >= 0 and is_alike and self.operations == printed.operations


@dataclass(frozen=True, eq=False)
class Entry:
    """What the forms of a formula share.

    Attributes:
        name: What it is the formula for.
        words: A regular expression for words by which texts speak of it.
        source: Where it is derived.
        symbols: Symbol → kind, as in a model.
    """

    name: str
    words: str
    source: str
    symbols: Mapping[str, str | Mapping[str, Any]]

    @cached_property
    def table(self) -> SymbolTable:
        kinds = self.symbols.items()
        return SymbolTable.build({name: {"kind": it} if isinstance(it, str) else it for name, it in kinds})

    @cached_property
    def has_families(self) -> bool:
        return any(_FAMILY.search(name) for name in self.symbols)

    @cached_property
    def has_quaternions(self) -> bool:
        return "quaternion" in str(self.symbols.values())

    @cached_property
    def spelled(self) -> Mapping[str, str]:
        """Its symbols, and the numbers that need no declaration, by their spelling without braces."""
        return {re.sub(r"[{} ]", "", name): name for name in (*_UNDECLARED, *self.symbols)}


@dataclass(frozen=True, eq=False)
class StandardFormula:
    """A form of a formula that texts of the field print.

    Attributes:
        entry: What its other forms have, too.
        formula: In LaTeX.
        given: The assumptions from which it follows.
        definition: True if nothing proves it, as it says what its left side is.
    """

    entry: Entry
    formula: str
    given: tuple[str, ...] = ()
    definition: bool = False

    @property
    def name(self) -> str:
        return self.entry.name

    @property
    def words(self) -> str:
        return self.entry.words

    @property
    def symbols(self) -> Mapping[str, str | Mapping[str, Any]]:
        return self.entry.symbols

    @cached_property
    def statement(self) -> Relation:
        (said,) = read_formula(self.formula, self.entry.table).statements
        assert isinstance(said, Relation), self.formula
        return said

    @cached_property
    def sum(self) -> Sum:
        return equation_sum(self.statement)

    @cached_property
    def plain(self) -> str:
        """Its LaTeX without words and dots over symbols."""
        return _WORDS.sub(" ", _DOTS.sub(r"\1", self.formula))

    @cached_property
    def counts(self) -> Mapping[str, int]:
        """How often its LaTeX has each of its symbols."""
        spelled = self.entry.spelled
        found = (re.sub(r"[{} ]", "", each) for each in _SYMBOL.findall(self.plain))
        return Counter(spelled[each] for each in found if each in spelled)

    @cached_property
    def profile(self) -> Profile:
        """What each printed form of it has, read from its LaTeX as far as that tells."""
        if self.entry.has_families or ("begin" in self.formula and self.entry.has_quaternions):
            return profile_of(self.sum)
        found = {name for name, sign in _OPERATIONS.items() if sign.search(self.formula)}
        if any(mark not in self.symbols for mark in _SKEW.findall(self.plain)):
            found.add("cross")
        own = [self.symbols.get(name, "scalar") for name in self.counts]
        numbers = sum((kind if isinstance(kind, str) else kind["kind"]) == "scalar" for kind in own)
        left = self.symbols.get(_DOTS.sub(r"\1", self.formula).partition("=")[0].strip(), "")
        shape = left if isinstance(left, str) else left["kind"]
        return Profile(frozenset(found), numbers, len(own) - numbers, _SHAPES.get(shape, ""))

    def may_keep_letters(self, letters: Collection[str]) -> bool:
        """True if it is long, or half of its symbols have one of the letters."""
        is_long = _MOST_COPIES * sum(self.counts.values()) >= LONG
        own = [as_letter(_LETTER.findall(name)[0]) for name in self.counts]
        return is_long or 2 * sum(each in letters for each in own) >= len(own)

    @cached_property
    def left(self) -> frozenset[Monomial]:
        """The monomial of its left side, if that is one."""
        found = normal_sum(self.statement.left).monomials
        return frozenset(found if len(found) == 1 else ())

    @cached_property
    def size(self) -> int:
        """The count of its symbols, each as often as it occurs."""
        return sum(1 for each in self.sum.monomials for _ in leaves_of(each))

    @cached_property
    def weight(self) -> int:
        """The count of its symbols and addends."""
        return self.size + len(self.sum.monomials)

    def is_meant_in(self, text: str) -> bool:
        """True if a text, in lower case, has the words."""
        return _pattern(self.words).search(text) is not None


def profile_of(own: Sum) -> Profile:
    """Returns the operations and counts of a sum."""
    found = {"block" for each in own.monomials if each.cell != NO_CELL}
    for part in parts_of(own):
        if isinstance(part, Node):
            found.add({"skew": "cross", "cos": "sin"}.get(part.head, part.head))
    bases = {leaf.base for leaf in leaves_of(own)}
    lone = [each for each in own.monomials if each.cell == NO_CELL]
    words = [each.word for each in lone]
    shape = "number" if lone and None in words else ""
    for word in words:
        if isinstance(word, Leaf):
            own_type = word.base.type
            shape = "column" if own_type.is_column else "square" if own_type.is_square else "other"
    numbers = sum(each.type.kind == "scalar" for each in bases)
    return Profile(frozenset(found & _OPERATIONS.keys()), numbers, len(bases) - numbers, shape)


@cache
def _pattern(words: str) -> re.Pattern[str]:
    return re.compile(_CAPITAL.sub(lambda letter: letter[0].lower(), words))


@cache
def standard_formulas() -> tuple[StandardFormula, ...]:
    """Returns the formulas of all subjects."""
    folder = resources.files(__package__ or "") / "formulas"
    files = sorted((each for each in folder.iterdir() if each.name.endswith(".toml")), key=str)
    return tuple(each for file in files for each in _formulas_in(file.read_text(encoding="utf-8")))


def _formulas_in(text: str) -> Iterator[StandardFormula]:
    """Yields the forms of each formula of a file."""
    for own in tomllib.loads(text)["formula"]:
        entry = Entry(own["name"], own["words"], own["source"], own["symbols"])
        for form in own["form"]:
            yield StandardFormula(entry, **{**form, "given": tuple(form.get("given", ()))})
