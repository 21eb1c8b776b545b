"""Whatever the text, only the reader's own errors escape, and at once: random text, and real formulas cut,
doubled, swapped and spliced."""

from __future__ import annotations

import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.language.chapter import PARTS
from tests.language.generated import TABLE
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.language.definition_entries import read_definition, read_definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula

REAL = read_definitions(PARTS["real"].definitions, SymbolTable.build(PARTS["real"].symbols))[1]
FORMULAS = [latex for part in PARTS.values() for _, latex in part.formulas]
_PIECE = re.compile(r"\\[A-Za-z]+|\\.|[0-9]+|.", re.DOTALL)
PIECES = sorted({piece for latex in FORMULAS for piece in _PIECE.findall(latex)})
_QUIET = {"suppress_health_check": list(HealthCheck)}


@st.composite
def mutated(draw) -> str:
    pieces = _PIECE.findall(draw(st.sampled_from(FORMULAS)))
    for _ in range(draw(st.integers(1, 4))):
        place = draw(st.integers(0, max(0, len(pieces) - 1)))
        match draw(st.integers(0, 5)):
            case 0:
                del pieces[place : place + draw(st.integers(1, 3))]
            case 1:
                pieces.insert(place, draw(st.sampled_from(PIECES)))
            case 2:
                pieces[place : place + 1] = [draw(st.sampled_from(PIECES))]
            case 3:
                pieces[place:place] = pieces[place : place + draw(st.integers(1, 12))]
            case 4:
                other = _PIECE.findall(draw(st.sampled_from(FORMULAS)))
                start = draw(st.integers(0, len(other)))
                pieces[place:place] = other[start : start + draw(st.integers(1, 12))]
            case _:
                other_place = draw(st.integers(0, max(0, len(pieces) - 1)))
                if pieces:
                    pieces[place], pieces[other_place] = pieces[other_place], pieces[place]
    return "".join(pieces)


def survives(latex: str, table: SymbolTable) -> None:
    try:
        reading = read_formula(latex, table, ("n", "m"))
    except (ReadError, IllFormedAt) as error:
        lines = latex.split("\n")
        assert 1 <= error.line <= len(lines)
        assert 1 <= error.column <= len(lines[error.line - 1]) + 1
        return
    for statement in reading.statements:
        to_latex(statement)
        hash(statement)


@settings(max_examples=500, **_QUIET)
@given(mutated())
def test_mutated_formulas(latex: str) -> None:
    survives(latex, REAL)


@settings(max_examples=300, **_QUIET)
@given(st.lists(st.sampled_from(PIECES), max_size=40).map("".join))
def test_random_pieces(latex: str) -> None:
    survives(latex, TABLE)


@settings(max_examples=200, **_QUIET)
@given(st.text(max_size=60))
def test_random_text(latex: str) -> None:
    survives(latex, TABLE)


@settings(max_examples=200, **_QUIET)
@given(st.text(alphabet="\\{}()[]|_^&'!=+-,.0123nkx \n\t\0", max_size=40))
def test_random_brackets(latex: str) -> None:
    survives(latex, TABLE)


@settings(max_examples=200, **_QUIET)
@given(st.lists(st.sampled_from(PIECES), max_size=8).map("".join), mutated())
def test_random_definitions(key: str, body: str) -> None:
    try:
        read_definition(key, body, REAL)
    except (SpecError, ReadError, IllFormedAt) as error:
        assert str(error)


@settings(max_examples=200, **_QUIET)
@given(
    st.dictionaries(
        st.lists(st.sampled_from(PIECES), max_size=6).map("".join),
        st.one_of(
            st.none(),
            st.fixed_dictionaries(
                {"kind": st.sampled_from(["scalar", "dual vector", "tensors", 3])},
                optional={"weight": st.sampled_from([1, "n", "n+1", "2x", 1.5, True]), "unit": st.booleans()},
            ),
        ),
        max_size=3,
    )
)
def test_random_specs(specs: dict) -> None:
    try:
        SymbolTable.build(specs)
    except SpecError as error:
        assert error.key in specs


@pytest.mark.slow
@settings(max_examples=20_000, **_QUIET)
@given(st.one_of(mutated(), st.lists(st.sampled_from(PIECES), max_size=60).map("".join)))
def test_mutated_formulas_many_times(latex: str) -> None:
    survives(latex, REAL)
