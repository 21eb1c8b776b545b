"""Formulas and terms of one table of symbols, and what they must be read as: as they are printed, or where and why not."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.language.naming.reading_conventions import Conventions, Relaxation
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula, read_term

PLAIN = {
    r"\lambda": "scalar",
    r"\mu": "scalar",
    "x": "vector",
    "y": "vector",
    "A": "tensor",
    "B": "tensor",
    "H": "matrix 4×4",
    "u": "matrix 6×1",
}

KINDS = {
    r"\lambda": "scalar",
    r"\underline{s}": "dual scalar",
    "x": "vector",
    "y": "vector",
    "z_n": "vector",
    r"\underline{x}": "dual vector",
}
KINDS |= {
    "A": "tensor",
    r"\underline{A}": "dual tensor",
    "R": "rotation",
    r"\underline{R}": "dual rotation",
    "g": "transform",
}
KINDS |= {"H": "matrix 4×4", "u": "matrix 6×1", "J": "matrix 6×7", "q": "hamilton quaternion"}
UNIT = {"e": {"kind": "vector", "unit": True}}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()} | UNIT)


def said(latex: str) -> str:
    """Its statements, and for each range the variable, its bounds, and whether it is any."""
    found = read_formula(latex, TABLE)
    ranges = (f"{r.variable} {r.lower} {r.upper} {r.generic}" for r in found.ranges)
    return " ;; ".join([*map(to_latex, found.statements), *ranges])


def reads(latex: str, expected: str) -> None:
    verdict, _, told = expected.partition(" ")
    if verdict in ("refused", "misfit"):
        with pytest.raises(
            ReadError if verdict == "refused" else IllFormedAt, match=re.escape(f"column {told}")
        ):
            read_formula(latex, TABLE)
    else:
        assert said(latex) == expected


def term_reads(
    latex: str,
    expected: str,
    kinds: dict[str, str | dict],
    *variables: str,
    loose: frozenset[Relaxation] = frozenset(),
) -> None:
    """expected: the term as it is printed; "refused" or "misfit" with the column and the beginning of the message."""
    table = replace(
        SymbolTable.build(
            {name: {"kind": kind} if isinstance(kind, str) else kind for name, kind in kinds.items()}
        ),
        conventions=Conventions(loose=loose),
    )
    verdict, _, told = expected.partition(" ")
    if verdict in ("refused", "misfit"):
        with pytest.raises(
            ReadError if verdict == "refused" else IllFormedAt, match=re.escape(f"column {told}")
        ):
            read_term(latex, table, variables)
    else:
        assert to_latex(read_term(latex, table, variables)) == expected
