"""Matrices that words call Jacobians: the functions and variables whose partial derivatives they print."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import product
from random import Random
from typing import Any

from workbench.core.terms import Block, Relation, Symbol, Term
from workbench.engines.jet import sympy_gate as sympy
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.drafted_definitions import Formula, Proposed
from workbench.papers.drafting.meanings.symbolic_values import NO_VALUE, symbolic
from workbench.papers.drafting.trial_reading import Outcome
from workbench.source.documents.condition_words import in_last_sentence

_WORDS = in_last_sentence("jacobians?", "partial derivatives", r"lineari[sz]\w+")
#: The most entries of a Jacobian that differ from what it should print.
_MOST_WRONG = 2
_MOST_FUNCTIONS = 8
_NEAR = 1e-9
#: The values of symbols at a point.
_RANGE = (0.3, 0.9)


@dataclass(frozen=True)
class _Function:
    """A scalar that a formula gives.

    Attributes:
        name: What differentiates it: the symbol's LaTeX, or the formula's right side.
        slopes: Variable → the value of the partial derivative at each point.
    """

    name: str
    slopes: Mapping[str, tuple[complex, ...]]


def printed_jacobians(
    formulas: Sequence[Formula], defined: Collection[str], spoken: Iterable[Outcome] = ()
) -> Iterator[tuple[Proposed, tuple[str, ...]]]:
    r"""Yields J as the partial derivatives of given scalars, for a printed J with nearly these entries.

    Words right before the matrix say that it is a Jacobian. All but two of its entries must be ∂f_i/∂q_j
    for one choice of consecutive f_i and of different q_j. All q_j but one must have such an entry that is
    not zero.

    defined: the symbols with a definition.   spoken: definitions of sentences.
    Yields also all symbols on which the f_i depend.
    """
    values: dict[str, Any] = {}
    for said in (said for each in spoken for said in each.statements or ()):
        if isinstance(said, Relation):
            with suppress(*NO_VALUE):
                values.setdefault(to_latex(said.left), symbolic(said.right, values)[0])
    for place, formula in enumerate(formulas):
        for said in formula.outcome.statements or ():
            match said:
                case Relation(operator="=", left=Symbol() as own, right=Block() as printed) if min(
                    printed.type.rows, printed.type.columns
                ) > 1 and _WORDS.search(formula.display.before):
                    with suppress(*NO_VALUE):
                        earlier = _functions(formulas[:place], values, defined)
                        yield from _matched(formula, own, printed, earlier, values)
                case Relation(operator="=", left=Symbol() as own) if own.type.kind == "scalar":
                    with suppress(*NO_VALUE):
                        values.setdefault(to_latex(own), symbolic(said.right, values)[0])


def _functions(
    formulas: Sequence[Formula], values: Mapping[str, Any], defined: Collection[str]
) -> list[_Function]:
    """Returns the scalars that formulas give, in their order; entries of columns count, too."""
    given: dict[str, Term] = {}
    for formula in formulas:
        for said in formula.outcome.statements or ():
            match said:
                case Relation(operator="=", left=Symbol() as own, right=right) if own.type.kind == "scalar":
                    name = to_latex(own)
                    given[name if name in defined else f"({to_latex(right)})"] = right
                case Relation(operator="=", left=Symbol(), right=Block(entries=rows) as right) if (
                    right.type.columns == 1
                ):
                    given |= {f"({to_latex(row[0])})": row[0] for row in rows if len(row) == 1}
    found = []
    for name, right in list(given.items())[-_MOST_FUNCTIONS:]:
        with suppress(*NO_VALUE):
            body = symbolic(right, values)[0]
            variables = sorted(map(str, body.free_symbols))
            slopes = {each: _numbers(body.diff(sympy.Symbol(each))) for each in variables}
            found.append(_Function(name, slopes))
    return found


def _numbers(body: Any) -> tuple[complex, ...]:
    """Returns the values at two points, which give each symbol a number by its name."""
    points = [{each: Random(f"{k} {each}").uniform(*_RANGE) for each in body.free_symbols} for k in (0, 1)]
    return tuple(complex(body.subs(point).evalf()) for point in points)


def _matched(
    formula: Formula, own: Symbol, printed: Block, functions: Sequence[_Function], values: Mapping[str, Any]
) -> Iterator[tuple[Proposed, tuple[str, ...]]]:
    entries = symbolic(printed, values)
    cells = [[_numbers(entries[i, j]) for j in range(entries.cols)] for i in range(entries.rows)]
    found: dict[tuple[int, int], list[tuple[Sequence[_Function], tuple[str, ...]]]] = {}
    for start in range(len(functions) - entries.rows + 1):
        rows = functions[start : start + entries.rows]
        for columns, wrong in _columns(cells, rows):
            found.setdefault((wrong, _unlikeness(columns)), []).append((rows, columns))
    best = found[min(found)] if found else []
    if len(best) == 1:
        ((rows, columns),) = best
        lines = (
            " & ".join(rf"\frac{{\partial {row.name}}}{{\partial {name}}}" for name in columns)
            for row in rows
        )
        body = r"\begin{bmatrix} " + r" \\ ".join(lines) + r" \end{bmatrix}"
        variables = tuple(sorted(set().union(*(row.slopes for row in rows))))
        yield Proposed(to_latex(own), body, formula.display.line, "words call it a Jacobian", True), variables


def _columns(
    cells: Sequence[Sequence[tuple[complex, ...]]], rows: Sequence[_Function]
) -> Iterator[tuple[tuple[str, ...], int]]:
    """Yields the variables of the columns with which few entries are wrong, and the number of these."""
    choices: list[list[tuple[str, int, bool]]] = []
    for column in zip(*cells, strict=True):
        own = []
        for name in sorted(set().union(*(row.slopes for row in rows))):
            slopes = [row.slopes.get(name) for row in rows]
            right = [_is_near(cell, slope) for cell, slope in zip(column, slopes, strict=True)]
            is_seen = any(slope and each for slope, each in zip(slopes, right, strict=True))
            own += [(name, right.count(False), is_seen)] if right.count(False) <= _MOST_WRONG else []
        choices.append(own)
    for chosen in product(*choices):
        names, wrong, seen = zip(*chosen, strict=True)
        if len({*names}) < len(names) or sum(wrong) > _MOST_WRONG:
            continue
        if sum(seen) >= len(names) - bool(sum(wrong)):
            yield names, sum(wrong)


def _unlikeness(names: Sequence[str]) -> int:
    """Returns how many different subscripts the names have."""
    return len({name.partition("_")[2] if not re.search(r"_\{\d+\}$", name) else "" for name in names})


def _is_near(printed: tuple[complex, ...], slope: tuple[complex, ...] | None) -> bool:
    wanted = slope or (0,) * len(printed)
    return all(abs(one - other) < _NEAR for one, other in zip(printed, wanted, strict=True))
