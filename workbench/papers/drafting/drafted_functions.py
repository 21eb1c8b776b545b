"""Functions that a text takes at other values: R(θ) = … and R(α + β), or R(t) and R(t + h) alone."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import pairwise

from workbench.core.brackets import end_of_group
from workbench.core.formula_errors import Fault, ReadError, SpecError
from workbench.language.definition_entries import read_definition
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.latex_keys import Ignored, latex_key
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Chain,
    Leaf,
    Node,
    Product,
    Scripted,
    Sum,
    core,
    in_a_row,
)
from workbench.language.naming.declarations import read_key
from workbench.language.naming.patterns import parts_of
from workbench.language.naming.symbols import SymbolTable
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.typefaces import Guess, flat

_DEFINES = ("=", ":=")
_TIMES = ("t", "\\tau")
#: A step of time, by its letter.
_STEP = re.compile(r"h|T|\\?(?:Delta|delta|epsilon|varepsilon)\{?[A-Za-z]?\}?|d\{?t\}?|dt")


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


def functions_elsewhere(formulas: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """Returns the symbols that formulas write at letters and at other values of these, as R(t) and R(t + h).

    Partial derivatives in a text exclude all of them: there R(t) may depend on more."""
    places: dict[str, dict[tuple[str, ...], Bracket]] = {}
    for latex in formulas:
        if "\\partial" in latex or "\\nabla" in latex:
            return {}
        if "(" in latex:
            with suppress(Fault, RecursionError):
                for name, bracket in _calls(parse(latex)):
                    own = places.setdefault(name, {})
                    own.setdefault(tuple(flat(latex_of(part)) for part in bracket.parts), bracket)
    found = {name: _formals(own) for name, own in places.items()}
    return {name: formals for name, formals in found.items() if formals}


def _calls(node: object) -> Iterator[tuple[str, Bracket]]:
    """Yields the names before brackets, with the brackets."""
    if isinstance(node, Product):
        for name, behind in pairwise(node.items):
            bracket = behind.nucleus if isinstance(behind, Scripted) else behind
            if isinstance(bracket, Bracket) and bracket.kind == "(" and bracket.parts:
                with suppress(SpecError):
                    own, index = read_key(latex_of(name.body if isinstance(name, Accented) else name))
                    if not index:
                        yield str(own), bracket
    for part in parts_of(node):
        yield from _calls(part)


def _formals(places: Mapping[tuple[str, ...], Bracket]) -> tuple[str, ...]:
    """Returns the letters of the first place with only letters, if another place is made of them."""
    letters = [place for place, bracket in places.items() if all(map(_is_plain, bracket.parts))]
    if not letters:
        return ()
    first = letters[0]
    others = [bracket for place, bracket in places.items() if place not in letters]
    alike = [each for each in others if len(each.parts) == len(first)]
    return first if any(_is_made_of(first, each) for each in alike) else ()


def _is_plain(part: Node) -> bool:
    return isinstance(part, Leaf) and part.kind == "LETTER"


def _is_made_of(letters: tuple[str, ...], bracket: Bracket) -> bool:
    """True for a place that contains a letter; of the time only for t + h and t + \\Delta t."""
    for letter, part in zip(letters, bracket.parts, strict=True):
        inside = [flat(latex_of(each)) for _, _, each in part.addends] if isinstance(part, Sum) else []
        if _is_time(letter):
            steps = [each for each in inside if each != letter]
            return letter in inside and len(steps) == 1 and bool(_STEP.fullmatch(steps[0]))
        factors = part.items if isinstance(part, Product) else ()
        if letter in inside or letter in [flat(latex_of(each)) for each in factors]:
            return True
    return False


def with_places(
    guesses: Mapping[str, Guess], elsewhere: Mapping[str, tuple[str, ...]], defined: Sequence[DraftedFunction]
) -> dict[str, Guess]:
    """Returns the guesses with the letters of the functions that the text takes at other values of them."""
    made = dict(guesses)
    for name in {*guesses}.intersection(elsewhere).difference(each.name for each in defined):
        letters, guess = elsewhere[name], guesses[name]
        if letters == ("t",):
            made[name] = replace(guess, of=letters, constant=False)
        elif guess.kind != "rotation" and not guess.unit and all(_moves(made.get(each)) for each in letters):
            made[name] = replace(guess, of=letters, constant=False)
            made |= {each: replace(made[each], constant=False) for each in letters}
    return made


def _moves(letter: Guess | None) -> bool:
    """False for a letter that words call constant, and for one of a kind that has no partial derivative."""
    if letter is None or letter.of or letter.unit or (letter.constant and letter.is_said):
        return False
    return letter.kind in ("scalar", "vector")
