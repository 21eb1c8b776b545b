"""Every key and value of a TOML file is found where it stands."""

import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.source.toml.toml_positions import Places, characters, string_end

SAMPLE = r'''# a comment with ] and "quotes"
title = "x # not a comment"
bare.dotted."quoted.part" = 1

[symbols]
'\omega' = { kind = "vector", weight = 1, aliases = ['\boldsymbol{\omega}', "\u03c9"] }
"a\"b" = 'single'

[[claim]] # first
id = "58.det"
printed = """
two \
   lines
and "quotes" \\ end"""
long = """ends in a quote""""
numbers = [ 1, 2.5, # comment ]
  [3, 4], 1979-05-27T07:32:00Z, ]
[claim.nested.deeper]
flag = true
[[claim]]
id = \'\'\'
 raw \n stays'\'\'\'
empty = ""
[claim.nested]
list = [ { a = [] }, { b = {} } ]
'''.replace(r"\'", "'")


def leaves(node, path=()):
    if isinstance(node, dict):
        items = node.items()
    elif isinstance(node, list):
        items = enumerate(node)
    else:
        yield path, node
        return
    for key, child in items:
        yield from leaves(child, (*path, key))


def assert_each_leaf_stands_at_its_place(text):
    places = Places.scan(text)
    for path, value in leaves(tomllib.loads(text)):
        start = places.values[path]
        if isinstance(value, str):
            literal = text[start : string_end(text, start)]
            assert tomllib.loads(f"x = {literal}")["x"] == value
            read = list(characters(text, start))
            assert len(read) == len(value)
            for (offset, shown), character in zip(read, value, strict=True):
                assert shown in (character, "?") and (shown == "?" or text[offset] in (character, "\\"))
        else:
            rest = text[start:].splitlines()[0]
            candidates = (rest[:end] for end in range(len(rest), 0, -1))
            assert any(parses_to(candidate, value) for candidate in candidates)


def parses_to(literal, value):
    try:
        return tomllib.loads(f"x = {literal}")["x"] == value
    except ValueError:
        return False


def test_each_leaf_of_the_sample_is_found():
    assert_each_leaf_stands_at_its_place(SAMPLE)


keys = st.from_regex(r"[A-Za-z0-9_-]{1,4}", fullmatch=True) | st.builds(
    lambda s: "'" + s + "'", st.text("ab.\\]=# [", max_size=4)
)
basic = st.text(st.sampled_from(list("ab#=]}'\\\"\n\té")), max_size=8).map(
    lambda s: (
        '"' + s.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'
    )
)
literal = st.text('ab#=]}"\\é', max_size=8).map(lambda s: f"'{s}'")
scalars = st.sampled_from(["1", "-2.5e3", "true", "inf", "1979-05-27 07:32:00"]) | basic | literal
values = st.recursive(
    scalars,
    lambda inner: (
        st.lists(inner, max_size=3).map(lambda i: "[" + ", # ]\n ".join(i) + "]")
        | st.lists(
            st.tuples(keys, inner.filter(lambda s: "\n" not in s)),
            max_size=3,
            unique_by=lambda p: p[0].strip("'"),
        ).map(lambda ps: "{ " + ", ".join(f"{k} = {v}" for k, v in ps) + " }")
    ),
    max_leaves=6,
)
tables = st.lists(st.tuples(keys, values), max_size=4, unique_by=lambda p: p[0].strip("'")).map(
    lambda ps: "".join(f" {k} = {v} # note\n" for k, v in ps)
)


@given(st.lists(st.tuples(st.sampled_from(["[[claim]]", "[[ claim ]]\n[claim.x]"]), tables), max_size=4))
@settings(max_examples=80)
def test_each_leaf_of_any_file_is_found(parts):
    text = "\n".join(f"{header}\n{body}" for header, body in parts)
    try:
        tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return
    assert_each_leaf_stands_at_its_place(text)


@pytest.mark.parametrize(
    ("path", "place"),
    [
        (("symbols", "\\omega"), (6, 1)),
        (("claim", 0), (9, 1)),
        (("claim", 1, "nested"), (24, 1)),
        (("nosuch",), (1, 1)),
    ],
)
def test_keys_and_tables(path, place):
    assert Places.scan(SAMPLE).of_key(path) == place


def test_positions_in_a_multiline_string_map_to_the_file():
    places = Places.scan(SAMPLE)
    path = ("claim", 0, "printed")
    assert places.in_string(path, 1, 1) == (12, 1)
    assert places.in_string(path, 1, 5) == (13, 4)  # behind the line-ending backslash
    assert places.in_string(path, 2, 5) == (14, 5)
    assert places.in_string(path, 9, 9) == (14, 22)  # beyond the end: the closing quote
