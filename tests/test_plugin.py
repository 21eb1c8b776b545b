"""Each claim of a paper file is a pytest item."""

from __future__ import annotations

import pytest

pytest_plugins = ["pytester"]

HEAD = """title = "x"
[symbols]
a = { kind = "vector" }
b = { kind = "vector" }
"""
TRUE = "[[claim]]\nid = 'true'\nprinted = 'a \\times b = -b \\times a'\n"
FALSE = "[[claim]]\nid = 'false'\nprinted = 'a \\times b = b \\times a'\n"
ERRATUM = FALSE.replace("'false'", "'erratum'") + "corrected = 'a \\times b = -b \\times a'\n"


@pytest.fixture
def run(pytester: pytest.Pytester):
    def run(*arguments: str, **files: str) -> pytest.RunResult:
        for name, text in files.items():
            pytester.path.joinpath(f"{name}.toml").write_text(text, encoding="utf-8")
        return pytester.runpytest_inprocess("-p", "no:cacheprovider", *arguments)

    return run


def test_each_claim_is_an_item_of_its_own(run):
    result = run("-v", paper=HEAD + TRUE + ERRATUM + FALSE)
    result.assert_outcomes(passed=2, failed=1)
    result.stdout.fnmatch_lines(["*paper.toml::true*PASSED*", "*::erratum*PASSED*", "*::false*FAILED*"])


def test_one_claim_can_be_run_alone(run):
    run("paper.toml::true", paper=HEAD + TRUE + FALSE).assert_outcomes(passed=1)


def test_a_failure_says_what_was_expected_and_the_evidence_without_a_traceback(run):
    result = run(paper=HEAD + FALSE)
    result.stdout.fnmatch_lines(
        [
            "*paper.toml:5: claim false",
            "as printed: expected proved, got refuted",
            "*counterexample*",
            "*left  = (*",
        ]
    )
    result.stdout.no_fnmatch_line("*Traceback*")
    result.stdout.no_fnmatch_line("*pytest_plugin.py*")


def test_a_verdict_that_got_better_than_expected_fails_too(run):
    result = run(paper=HEAD + ERRATUM.replace("= b \\times a'", "= -b \\times a'", 1))
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*as printed: expected refuted, got proved*"])


def test_other_toml_files_are_left_alone(run):
    run(other="[tool]\nname = 'x'\n# [[claim]] in a comment\n", paper=HEAD + TRUE).assert_outcomes(passed=1)


def test_a_toml_file_that_is_named_must_be_a_paper(run):
    result = run("other.toml", other="[tool]\nname = 'x'\n")
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*other.toml:1:1: unknown key 'tool'*"])


def test_an_unusable_paper_is_a_collection_error_of_one_message(run):
    result = run(paper=HEAD + TRUE.replace("-b", "-c"), good=HEAD + TRUE)
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*paper.toml:7:26: printed: unknown symbol c*"])
    result.stdout.no_fnmatch_line("*Traceback*")
