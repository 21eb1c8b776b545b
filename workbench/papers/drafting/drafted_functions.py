"""Functions that a text defines by their value at a letter, and takes at other values: R(θ) = …, R(α + β)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

from workbench.core.brackets import end_of_group
from workbench.core.formula_errors import Fault, ReadError, SpecError
from workbench.language.definition_entries import read_definition
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.latex_keys import Ignored, latex_key
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Bracket, Chain, Node, Product, core, in_a_row
from workbench.language.naming.declarations import read_key
from workbench.language.naming.symbols import SymbolTable
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.typefaces import flat

_DEFINES = ("=", ":=")
_TIMES = ("t", "\\tau")


@dataclass(frozen=True)
class DraftedFunction:
    """A function by its value at letters.

    Attributes:
        name: The symbol's LaTeX.
        formals: The letters.
        body: The LaTeX of the value.
    """

    name: str
    formals: tuple[str, ...]
    body: str
    line: int

    @property
    def key(self) -> str:
        """The key of the definition in a model."""
        return f"{self.name}({', '.join(self.formals)})"


def functions_in(formulas: Iterable[tuple[str, int]]) -> list[DraftedFunction]:
    """Returns the functions that formulas (with their lines) define, and take at other values elsewhere."""
    written = list(formulas)
    values = [_flat(latex) for latex, _ in written]
    found: dict[str, DraftedFunction] = {}
    for latex, line in written:
        for each in _defined(latex, line):
            if each.name not in found and _has_other_values(each, values):
                found[each.name] = each
    return list(found.values())


def with_functions(
    table: SymbolTable, functions: Sequence[DraftedFunction]
) -> tuple[SymbolTable, list[DraftedFunction]]:
    """Returns the table with the functions that it can read, and these functions."""
    known = []
    for each in functions:
        with suppress(SpecError, ReadError, Fault):
            _, table = read_definition(each.key, each.body, table)
            known.append(each)
    return table, known


def _defined(latex: str, line: int) -> Iterator[DraftedFunction]:
    if "(" not in latex:
        return
    with suppress(Fault, SpecError, RecursionError):
        match parse(latex).lines:
            case ((Chain(relations=((sign, _), *_), sides=(left, right, *_)),),) if sign in _DEFINES:
                yield from _of_sides(left, right, line)


def _of_sides(left: Node, right: Node, line: int) -> Iterator[DraftedFunction]:
    match core(left):
        case Product(items=(*name, Bracket(kind="(", parts=parts))) if name:
            own, index = read_key(latex_of(in_a_row(left.at, name)))
            formals = tuple(latex_of(part) for part in parts)
            body = latex_of(right)
            if not index and not any(map(_is_time, formals)) and all(map(_is_letter, formals)):
                walker = Walker()
                used = {flat(each) for tree in operations_of(body, walker) for each in tree.names}
                if used.issuperset(map(flat, formals)) and flat(str(own)) not in used:
                    yield DraftedFunction(str(own), formals, body, line)


def _is_time(formal: str) -> bool:
    return flat(formal) in _TIMES


def _is_letter(formal: str) -> bool:
    _, index = read_key(formal)
    return not index


def _has_other_values(function: DraftedFunction, formulas: Sequence[str]) -> bool:
    own = _flat(", ".join(function.formals))
    call = re.compile(rf"(?<![A-Za-z\\]){re.escape(_flat(function.name))}\(")
    behind = (text[match.end() - 1 :] for text in formulas for match in call.finditer(text))
    values = ((text, end_of_group(text, "(", ")")) for text in behind)
    return any(end is not None and text[1 : end - 1] != own for text, end in values)


def _flat(latex: str) -> str:
    return flat(latex_key(latex, Ignored.SIZES))
