"""Letters side by side are one symbol where they are declared as one, and a product where they are not."""

from __future__ import annotations

from itertools import product

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term

WORDS = {
    "DV": "vector",
    r"DV_{\text{sat}}": "vector",
    r"\mathbf{DV}": "vector",
    r"\vec{Focm}": "vector",
    "Focm_1": "scalar",
    "AR": "scalar",
}
LETTERS = {"T": "tensor", "m": "scalar", "a": "vector"}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in (WORDS | LETTERS).items()})


@pytest.mark.parametrize("name", WORDS)
def test_printed_words_read_back(name: str) -> None:
    for text in (name, rf"m {name}", rf"\dot{{{name}}}", rf"m \dot{{{name}}} m"):
        term = read_term(text, TABLE)
        assert read_term(to_latex(term), TABLE) == term


@pytest.mark.parametrize(("before", "word", "after"), [*product(("m", "2", "m m "), WORDS, ("", " m", "_9"))])
def test_it_is_found_among_other_factors(before: str, word: str, after: str) -> None:
    if after == "_9":
        with pytest.raises(ReadError, match=r"unknown symbol|a second subscript|a script at"):
            read_term(before + word + after, TABLE)
        return
    lone = SymbolTable.build({"w": {"kind": WORDS[word]}, "m": {"kind": "scalar"}})
    assert to_latex(read_term(before + word + after, TABLE)) == to_latex(
        read_term(f"{before} w {after}", lone)
    ).replace("w", to_latex(read_term(word, TABLE)))


def test_letters_with_something_between_them_are_a_product() -> None:
    table = SymbolTable.build({name: {"kind": "scalar"} for name in ("AR", "A", "R")})
    for text in ("A R", r"A\,R", "{A}{R}", r"A \cdot R"):
        assert "AR" not in {str(part.declaration.name) for part in read_term(text, table).arguments}
    with pytest.raises(ReadError, match="or the product of A and R"):
        read_term("AR", table)


@pytest.mark.parametrize("text", [r"\vec{OB}'", r"\vec{CD}'", r"\vec{CD}_9", r"\vec{Focm}_1"])
def test_a_script_at_what_stands_under_one_mark_is_never_dropped(text: str) -> None:
    names = (r"\vec{OB}", r"\vec{OB'}", r"\vec{CD}", r"\vec{Focm}")
    table = SymbolTable.build({name: {"kind": "vector"} for name in names})
    assert {str(read_term(name, table).declaration.name) for name in names} == {*names}
    with pytest.raises(ReadError):
        read_term(text, table)


def test_the_longest_name_counts() -> None:
    table = SymbolTable.build({name: {"kind": "scalar"} for name in ("AR", "ARx", "x")})
    assert to_latex(read_term("ARx", table)) == "ARx"
    assert to_latex(read_term("AR x", table)) == "AR x"


def test_it_may_be_defined() -> None:
    symbols = {"AR": "scalar", "b": "scalar", "S": "scalar"}
    given = {"symbols": symbols, "definitions": [r"AR = \frac{b^2}{S}"]}
    assert check(r"AR\,S = b^2", **given).outcome is Outcome.CONDITIONAL
    assert check(r"AR^2 S = b^2", **given).outcome is Outcome.REFUTED
