"""Brackets in rows of characters or tokens."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from workbench.core.brackets import end_of_group, nesting, outside

BALANCED = st.recursive(
    st.text("ab", max_size=2), lambda inner: st.lists(inner.map("{{{}}}".format), max_size=3).map("a".join)
)


@given(BALANCED, st.text("ab{}"))
def test_group_ends_with_the_bracket_that_closes_it(inside: str, behind: str) -> None:
    assert end_of_group(f"{{{inside}}}{behind}") == len(inside) + 2
    assert end_of_group(f"{{{inside}") is None


@given(BALANCED, st.sampled_from([",", "="]))
def test_mark_is_outside_where_no_bracket_is_open(text: str, mark: str) -> None:
    for place in range(len(text) + 1):
        marked = text[:place] + mark + text[place:]
        is_free = text[:place].count("{") == text[:place].count("}")
        assert (place in outside(marked)) is is_free


def test_single_token_is_a_group_and_words_can_be_brackets() -> None:
    assert end_of_group("a{b}") == 1 and end_of_group("") is None
    sides = ["left", "x", "left", "right", "right", "y"]
    assert end_of_group(sides, ("left",), ("right",)) == 5
    assert [nesting(each, "([{", ")]}") for each in ("[", "}", "\\{", "a")] == [1, -1, 0, 0]
