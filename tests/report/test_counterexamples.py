"""A value of a counterexample is shown by its kind, wherever it is shown."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench import check
from workbench.app.commands.terminal import claim_lines
from workbench.core.types import QUATERNION, SCALAR, TENSOR, VECTOR, Type
from workbench.core.verdict import Counterexample
from workbench.report.counterexamples import against, told, value_as_text

REAL = [SCALAR, VECTOR, TENSOR, QUATERNION, Type(4, 4)]
REAL += [Type(rows, columns) for rows in (1, 2, 3, 4, 6) for columns in (1, 2, 3, 4, 6)]
TYPES = [each.with_dual(dual) for each in dict.fromkeys(REAL) for dual in (False, True)]
RATIONALS = st.builds(lambda p, q: str(Fraction(p, q)), st.integers(-9, 9), st.integers(1, 9))


def size_of(type_: Type) -> int:
    return type_.rows * type_.columns * (2 if type_.dual else 1)


def value_of_type(type_: Type) -> st.SearchStrategy[tuple[Type, list[str]]]:
    size = size_of(type_)
    return st.tuples(st.just(type_), st.lists(RATIONALS, min_size=size, max_size=size))


VALUES = st.sampled_from(TYPES).flatmap(value_of_type)


def read_part(text: str, type_: Type) -> list[str]:
    """The entries of a real value, from its text of one kind: this reader goes by the type alone."""
    shape = f"{type_.rows}×{type_.columns}"
    if type_ == SCALAR:
        assert "(" not in text
        return [text]
    if type_.algebra == "quaternion":
        scalar, vector = re.fullmatch(r"\((\S+), \(([^()]*)\)\)", text).groups()
        return [scalar, *vector.split(", ")]
    assert text[0] == "(" and text[-1] == ")"
    if type_.columns == 1:
        assert "(" not in text[1:] and text.count(",") == type_.rows - 1, shape
        return text[1:-1].split(", ")
    rows = re.findall(r"\(([^()]*)\)", text[1:-1])
    assert len(rows) == type_.rows and all(row.count(",") == type_.columns - 1 for row in rows), shape
    return [entry for row in rows for entry in row.split(", ")]


def read_value(text: str, type_: Type) -> list[str]:
    if not type_.dual:
        return read_part(text, type_)
    zero, real = ["0"] * (type_.rows * type_.columns), type_.with_dual(False)
    head, sign, tail = re.fullmatch(r"(.*?) ?([+-]?) ?(ε.*)|(.*)", text).groups()[:3]
    if tail is None:
        return read_part(text, real) + zero
    dual = read_part(tail[2:] or "1", real)
    dual = [f"-{dual[0]}"] if sign == "-" else dual
    return (read_part(head, real) if head else zero) + dual


@given(VALUES)
def test_text_of_a_value_is_read_back_by_its_kind(drawn: tuple[Type, list[str]]) -> None:
    type_, entries = drawn
    assert read_value(value_as_text(entries, str(type_)), type_) == entries


@pytest.mark.parametrize(
    ("entries", "kind", "text"),
    [
        (["1"] + 8 * ["0"], "tensor", "((1, 0, 0), (0, 0, 0), (0, 0, 0))"),
        (["2", "-1/2"], "dual scalar", "2 - ε 1/2"),
        (["2", "-1/2"], "matrix 2×1", "(2, -1/2)"),
        (5 * ["0"] + ["1"], "dual vector", "ε (0, 0, 1)"),
        (["2", "3"], "", "(2, 3)"),
        (["about 1"], "scalar", "about 1"),
    ],
)
def test_value_is_laid_out_by_its_kind(entries: list[str], kind: str, text: str) -> None:
    assert value_as_text(entries, kind) == text


@given(st.lists(st.tuples(st.sampled_from("abcd"), VALUES), min_size=1, max_size=3), VALUES)
def test_sentence_names_only_what_is_not_0(
    drawn: list[tuple[str, tuple[Type, list[str]]]], sides: tuple
) -> None:
    kind, entries = str(sides[0]), tuple(sides[1])
    values = {name: tuple(value) for name, (_, value) in drawn}
    kinds = {name: str(type_) for name, (type_, _) in drawn}
    example = Counterexample(values, entries, entries, kinds=kinds, kind=kind)
    found = told(example)
    zero = {name for name, value in values.items() if all(Fraction(each) == 0 for each in value)}
    assert {name for name, _ in found.values} == values.keys() - zero
    assert found.rest == bool(zero)
    assert str(found).endswith(f"the left side is {found.left}, the right side {found.right}")


KINDS = [
    "matrix 2×1", "vector", "matrix 4×1", "matrix 6×1", "dual scalar", "dual vector", "tensor", "matrix 2×3",
    "matrix 2×2", "matrix 3×6", "matrix 1×3", "hamilton quaternion", "scalar", "dual tensor",
]  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_each_output_shows_a_counterexample_by_its_kind(kind: str) -> None:
    checked = check("a + b = a - b", {"a": kind, "b": kind})
    example = checked.verdict.counterexample
    shown = {"matrix 1×3": "covector"}.get(kind, kind.removeprefix("hamilton "))
    assert example.kinds == {"a": shown, "b": shown} and example.kind == shown
    text = value_as_text(example.values["b"], shown)
    assert read_value(text, _type(shown)) == list(example.values["b"])
    sentence = str(told(example))
    assert f"b = {text}" in sentence
    assert sentence in _repr_as_text(checked._repr_markdown_())
    assert any(sentence in str(line) for line in claim_lines(checked.result))
    found = against(checked.result)
    assert dict(found.values)["b"] == text and str(found) == sentence
    assert shown.startswith("dual") or "ε" not in text


def _repr_as_text(markdown: str) -> str:
    return markdown.replace("$", "").replace("\\", "")


def _type(shown: str) -> Type:
    return next(each for each in (*TYPES, Type(3, 6)) if str(each) == shown)
