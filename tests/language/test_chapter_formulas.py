"""The chapter's notation: every formula in its intended form is read, printed and read again; at speed."""

from __future__ import annotations

import re
from collections.abc import Iterable

import pytest

from tests.language.chapter import PARTS, Part
from workbench.core.formula_errors import IllFormedAt
from workbench.core.terms import Conjunction, Equivalence, Implication, Relation
from workbench.language.definition_entries import read_definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import Reading, read, read_formula
from workbench.source.rows.formula_lines import split_lines

CASES = [(name, equation, latex) for name, part in PARTS.items() for equation, latex in part.formulas]


@pytest.fixture(scope="module")
def tables() -> dict[str, SymbolTable]:
    return {name: table_of(part) for name, part in PARTS.items()}


def table_of(part: Part) -> SymbolTable:
    return read_definitions(part.definitions, SymbolTable.build(part.symbols))[1]


@pytest.mark.parametrize(("part", "equation", "latex"), CASES, ids=[f"{e}" for _, e, _ in CASES])
def test_read_and_read_back(part: str, equation: str, latex: str, tables: dict[str, SymbolTable]) -> None:
    for reading in _lines(latex, tables[part], PARTS[part].integers):
        variables = {*PARTS[part].integers, *(r.variable for r in reading.ranges)}
        for statement in reading.statements:
            assert read(to_latex(statement), tables[part], variables) == (statement,)


def _lines(latex: str, table: SymbolTable, integers: Iterable[str] = ()) -> list[Reading]:
    return [read_formula(line.latex, table, integers) for line in split_lines(latex)]


def test_one_statement_a_line(tables: dict[str, SymbolTable]) -> None:
    latex = dict(PARTS["real"].formulas)
    said = {e: [s for each in _lines(latex[e], tables["real"], "nm") for s in each.statements] for e in latex}
    assert [len(said[e]) for e in ("2", "18", "20", "40", "53")] == [
        2,
        2,
        2,  # the recurrences; what stands behind "where" is their condition
        3,
        2,
    ]


def test_shapes_of_statements(tables: dict[str, SymbolTable]) -> None:
    latex = dict(PARTS["real"].formulas)
    kinds = [type(read(latex[e], tables["real"], "nm")[0]) for e in ("1", "16", "58.iff", "70.implies")]
    assert kinds == [Relation, Conjunction, Equivalence, Implication]


def test_ranges_are_returned(tables: dict[str, SymbolTable]) -> None:
    latex = dict(PARTS["real"].formulas)
    ranges = read_formula(latex["51"], tables["real"]).ranges
    assert [(r.variable, str(r.lower), r.upper) for r in ranges] == [("m", "1", None), ("n", "1", None)]
    (only,) = read_formula(latex["21"], tables["real"]).ranges
    assert (only.variable, str(only.lower)) == ("n", "3")


# the printed forms whose types or weights do not fit, and the column of the fault
PRINTED = [
    (
        "53",
        r"\Phi^* = \mathbf{S}^* - \tilde{\mathbf{S}}\mathbf{t} + \mathbf{t} \otimes \mathbf{t}",
        r"\tilde",
        "tilde",
    ),
    (
        "53",
        r"\det \Phi = \det \mathbf{S} + \mathbf{t}\mathbf{S}\mathbf{t}",
        r"\mathbf{S}\mathbf{t}",
        "vector and a tensor",
    ),
    (
        "10",
        r"\Phi_2 = \widetilde{\boldsymbol{\omega}^2} \boldsymbol{\varepsilon}",
        r"\widetilde",
        "got a scalar",
    ),
    (
        "58",
        r"\Phi_2^* = -\tilde{\omega}^2 \dot{\omega} + \dot{\omega} \otimes \dot{\omega}",
        r"+",
        "differ in type",
    ),
    (
        "61",
        r"4 \det \Phi_3 = (\mathbf{t}_3 \times \dot{\omega})(\omega \times \mathbf{t}_3)",
        r"(\omega \t",
        "vector and a vector",
    ),
    ("67", r"\alpha = \omega^4 - 2\dot{\omega}^2 - 2\omega \cdot \dot{\omega}", r"- 2\omega \cdot", "weight"),
    ("21", r"\Phi_4 = \frac{d^2}{dt^3} \Phi_2", r"\frac", "order 2 above and 3 below"),
    ("70", r"2\ddot{\omega} + 2\dot{\omega} \times \omega - 4\omega^2 \dot{\omega} = 0", "- 4", "weight"),
]


@pytest.mark.parametrize(
    ("equation", "latex", "at", "part"), PRINTED, ids=[f"{p[0]}-{p[3]}" for p in PRINTED]
)
def test_printed_forms_that_do_not_fit(
    equation: str, latex: str, at: str, part: str, tables: dict[str, SymbolTable]
) -> None:
    with pytest.raises(IllFormedAt, match=re.escape(part)) as caught:
        read(latex, tables["real"])
    assert caught.value.column == latex.index(at) + 1
