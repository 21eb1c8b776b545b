"""Corrections of a formula before typing: unknown accents, brackets, conditions, superscripts and letters."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from workbench.core.formula_errors import Fault, ReadError
from workbench.language.elaboration.statements import clauses_of
from workbench.language.grammar.parser import parse, parses
from workbench.language.grammar.syntax import Lines, Node
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.terms.changes import Change
from workbench.repair.trees.unknown_letters import arguments, arrows, known_letters, left_scripts
from workbench.repair.trees.unparsable import (
    Step,
    conditions,
    is_condition,
    rates,
    repeated_sides,
    stray_signs,
    superscripts,
)
from workbench.source.rows.formula_lines import split_lines

#: The most spellings of one formula that are considered.
MOST = 24

_STRANGE_ACCENT = re.compile(r"\\(?:hat|widehat|check|breve|acute|grave)(?![A-Za-z])")
_CIRCLE = re.compile(r"\\overset\s*\{\s*\\circ\s*\}|\\mathring(?![A-Za-z])|\\r(?![A-Za-z])")
_DOTS = ("\\dot", "\\ddot", "\\dddot", "\\ddddot")

#: The replacements of an unknown accent and of a circle.
_ACCENTS = (("\\tilde", "\\dddot"), *(("\\underline", dots) for dots in _DOTS), ("\\dot", "\\tilde"))


@dataclass(frozen=True)
class Spelling:
    """A formula in which every letter, accent and condition is known to the reader."""

    lines: Lines
    changes: tuple[Change, ...] = ()


def spellings(latex: str, table: SymbolTable, integers: frozenset[str]) -> Iterator[Spelling]:
    """Yields the formula as printed if nothing in it is unknown; else with the fewest changes that make it
    so."""
    steps: tuple[Step, ...] = (
        conditions,
        superscripts,
        rates,
        stray_signs,
        arrows,
        left_scripts,
        known_letters,
        arguments,
        repeated_sides,
    )
    yield from islice(_spelled(_with_rows_joined(latex), steps, table, integers), MOST)


def _with_rows_joined(latex: str) -> str:
    """Returns the formula without an environment of rows, if its rows are one line."""
    if "\\begin{" not in latex and "\\\\" not in latex:
        return latex
    try:
        lines = split_lines(latex)
    except (ReadError, Fault):
        return latex
    return latex if len(lines) != 1 else lines[0].latex


def _spelled(
    latex: str, steps: Sequence[Step], table: SymbolTable, integers: frozenset[str]
) -> Iterator[Spelling]:
    for text, changes in _texts(latex):
        found = [Spelling(_in_rows(parse(text)), changes)]
        for step in steps:
            found = [
                Spelling(lines, (*before.changes, *more))
                for before in found
                for lines, more in step(before.lines, table, integers)
            ]
        yield from found


def _in_rows(lines: Lines) -> Lines:
    """Returns one statement per line with its conditions; continuation lines are joined."""
    if (
        not any(isinstance(clause, Lines) for line in lines.lines for clause in line)
        and len(lines.lines) == 1
    ):
        return lines
    rows: list[tuple[Node, ...]] = []
    try:
        for clause in clauses_of(lines):
            rows[-1:] = [(*rows[-1], clause)] if rows and is_condition(clause) else [*rows[-1:], (clause,)]
    except Fault:
        return lines
    return Lines(lines.at, tuple(rows))


def _texts(latex: str) -> Iterator[tuple[str, tuple[Change, ...]]]:
    if parses(latex):
        yield latex, ()
        return
    accents = [*_STRANGE_ACCENT.findall(latex), *_CIRCLE.findall(latex)]
    seen: set[str] = set()
    if accents:
        for tilde, dots in _ACCENTS:
            text = _CIRCLE.sub(_always(dots), _STRANGE_ACCENT.sub(_always(tilde), latex))
            if text not in seen and parses(text):
                seen.add(text)
                shown = [tilde] * bool(_STRANGE_ACCENT.search(latex)) + [dots] * bool(_CIRCLE.search(latex))
                said = f"replace the accent {accents[0]} by {' and '.join(shown)}"
                yield text, (Change("mark", said),)
        return
    yield from _brackets(latex)


def _always(text: str) -> Callable[[re.Match[str]], str]:
    """Returns a function that replaces each match by the text."""
    return lambda _: text


def _brackets(latex: str) -> Iterator[tuple[str, tuple[Change, ...]]]:
    """Yields the formula with one bracket dropped or inserted, if it then parses."""
    for place, sign in enumerate(latex):
        if sign in "()[]":
            text = latex[:place] + latex[place + 1 :]
            if parses(text):
                yield text, (Change("bracket", f"remove the bracket {sign} in column {place + 1}"),)
    ends = [match.end() for match in re.finditer(r"\\[A-Za-z]+|\\.|[^\\\s]", latex)]
    for sign in (")", "]", "}", "(", "["):
        for place in reversed(ends):
            text = f"{latex[:place]}{sign}{latex[place:]}"
            if parses(text):
                yield text, (Change("bracket", f"insert a bracket {sign} in column {place + 1}"),)
