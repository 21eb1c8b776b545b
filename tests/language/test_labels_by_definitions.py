"""Index letters of names: labels where a definition uses the name without a range, indices where there is one."""

from __future__ import annotations

import pytest

from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.language.naming.symbols import SymbolTable

NAMES = ("m_{0}", r"\mathbf{{R}}_{0}", r"\hat{{m}}_{0}", "q_{0}")


def indices(key: str, bodies: dict[str, str]) -> set[int]:
    """The numbers of indices of the declarations of a name."""
    table = SymbolTable.build({key: {"kind": "scalar"}, "l": {"kind": "scalar"}}, (), bodies)
    return {own.indices for name, own in table.symbols.items() if name.base in key and name.base != "l"}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("letter", sorted(INDEX_LETTERS - {"l"}))
def test_names_without_a_range(name: str, letter: str) -> None:
    key, braced = name.format(letter), name.format(f"{{ {letter} }}")
    assert indices(key, {}) == {1}
    for written in (key, braced):
        for body in (f"{written} x", f"x + 2 {written}", rf"\frac{{{written}}}{{2}}"):
            assert 0 in indices(key, {r"\mu": body}), body


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("letter", sorted(INDEX_LETTERS - {"l"}))
def test_names_with_a_range(name: str, letter: str) -> None:
    key = name.format(letter)
    for other, body in ((f"u_{letter}", f"{key} x"), ("u", rf"\sum_{{{letter}=1}}^3 {key}")):
        assert indices(key, {other: body}) == {1}
    assert indices(key, {"u": f"\\{key}" if key[0] != "\\" else f"{key}x"}) == {1}
