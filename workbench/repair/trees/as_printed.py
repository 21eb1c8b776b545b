r"""Spelling of a proposed formula in the letters of the printed one: \boldsymbol{\omega} if the formula has
it."""

from __future__ import annotations

from collections.abc import Collection

from workbench.core.formula_errors import Fault
from workbench.core.names import Name
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Node
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.trees.letter_candidates import meaning_of, occurrences
from workbench.repair.trees.lost_marks import Mark, marked
from workbench.repair.trees.misprinted_integers import bound_variables


def as_printed(latex: str, printed: str, table: SymbolTable, integers: Collection[str]) -> str:
    """Returns the formula in the letters of the printed one; unchanged if that cannot be parsed."""
    try:
        lines, shown = parse(latex), parse(printed)
    except Fault:
        return latex
    spelled: dict[Name | str, dict[str, Node]] = {}  # by name: the letters that stand for it in print
    for found in occurrences(shown):
        meant = meaning_of(found, table, frozenset(integers) | bound_variables(shown))
        if meant is not None and not found.styles:
            spelled.setdefault(meant.name, {}).setdefault(latex_of(found.node), found.node)
    marks = []
    for found in occurrences(lines):
        meant = meaning_of(found, table, frozenset(integers) | bound_variables(lines))
        forms = spelled.get(meant.name, {}) if meant is not None and not found.styles else {}
        if forms and latex_of(found.node) not in forms:
            marks.append(Mark(found.node, next(iter(forms.values())), 0, "mark", ""))
    return latex_of(marked(marks, lines)) if marks else latex
