"""Stages of loading: all errors as values, all other entries read, and the files as they were."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.paper_errors import PaperError
from workbench.papers.reading_stages import ErrorLog, stage
from workbench.source.toml.toml_file import TomlFile

KEYS = st.dictionaries(st.from_regex(r"[a-z]{1,4}", fullmatch=True), st.booleans(), min_size=1)


def file_of(keys: dict[str, bool]) -> TomlFile:
    """Returns a file with numbers, and texts where a number is wanted."""
    lines = [f"{key} = {'1' if is_right else 'true'}" for key, is_right in keys.items()]
    return TomlFile(Path("paper.toml"), "\n".join(["[numbers]", *lines]))


def numbers(file: TomlFile) -> dict[str, int]:
    """Reads the table up to the first entry at fault."""
    return {key: file.value(("numbers", key), int) for key in file.value(("numbers",), dict)}


@given(KEYS, KEYS)
def test_stage_reads_what_is_right_and_returns_each_error(
    one: dict[str, bool], other: dict[str, bool]
) -> None:
    files = file_of(one), file_of(other)
    before = deepcopy([file.data for file in files])
    done = stage(lambda *views: [numbers(view) for view in views], *files)
    assert done.value == [{key: 1 for key, is_right in keys.items() if is_right} for keys in (one, other)]
    wrong = [
        (file, key) for file, keys in zip(files, (one, other), strict=True) for key in keys if not keys[key]
    ]
    assert [(error.toml, error.path[-1]) for error in done.errors] == wrong
    assert done.omitted == len(wrong) and (done.whole is None) is bool(wrong)
    assert [file.data for file in files] == before


def test_stage_has_no_limit_on_the_number_of_errors() -> None:
    done = stage(numbers, file_of({f"k{number}": False for number in range(150)}))
    assert done.value == {} and len(done.errors) == 150


def test_stage_ends_where_an_error_does_not_go_away() -> None:
    def read(file: TomlFile) -> int:
        file.value(("numbers", "a"), int)
        raise file.error_at_key(("numbers", "a"), "a: always wrong")

    for is_right in (True, False):
        done = stage(read, file_of({"a": is_right}))
        assert (done.value, len(done.errors), done.omitted) == (None, 2, 1)


def test_view_of_a_view_reports_errors_of_the_file() -> None:
    file = file_of({"a": True, "b": True})
    view = file.without(("numbers", "a"))
    assert view is not None
    last = view.without(("numbers", "b"))
    assert last is not None and last.data == {"numbers": {}} and last.origin is view.origin is file
    assert last.error_at_key((), "none").toml is file
    assert view.without(("numbers", "a")) is None and len(file.data["numbers"]) == 2


def test_error_that_follows_from_an_omitted_entry_is_not_logged() -> None:
    file, log = TomlFile(Path("p.toml"), "[symbols]\nv = 1\n[definitions]\nw = 'v'\n"), ErrorLog()
    path = ("symbols", "v")
    assert log.past(stage(lambda view: view.value(path, str), file)) is None
    for latex in ("v", "u"):
        log.tell(PaperError("p.toml", 4, 1, f"unknown symbol {latex}", file, ("definitions", "w"), latex))
    assert [error.message for error in log] == [
        "v: expected a string, got an integer",
        "unknown symbol u",
    ]


def test_one_fault_in_two_keys_of_an_entry_is_logged_once() -> None:
    file, log = TomlFile(Path("p.toml"), "[[claim]]\nprinted = 1\nsteps = 1\nlhs = 1\n"), ErrorLog()
    keys = {"printed": "x", "steps": "x", "lhs": "y"}
    faults = {
        key: SyntaxCode.UNKNOWN_SYMBOL(text=name).at(1, at) for at, (key, name) in enumerate(keys.items())
    }
    errors = [PaperError("p.toml", 2, None, faults[key], file, ("claim", 0, key)) for key in keys]

    def read(view: TomlFile) -> None:
        if "printed" in view.data["claim"][0]:
            raise errors[0]

    log.whole(stage(read, file))
    for error in errors[1:]:
        log.tell(error)
    assert [error.path[-1] for error in log] == ["printed", "lhs"]
