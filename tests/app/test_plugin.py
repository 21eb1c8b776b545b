"""Each claim of a paper file is a pytest item. The run of all files is a process of its own, as users have it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from workbench.prover.preload import load_engines

pytest_plugins = ["pytester"]

HEAD = """title = "x"
[symbols]
a = { kind = "vector" }
b = { kind = "vector" }
"""
TRUE = "[[claim]]\nid = 'true'\nprinted = 'a \\times b = -b \\times a'\n"
FALSE = "[[claim]]\nid = 'false'\nprinted = 'a \\times b = b \\times a'\n"
ERRATUM = FALSE.replace("'false'", "'erratum'") + "corrected = 'a \\times b = -b \\times a'\n"
FILES = {
    "paper": HEAD + TRUE + ERRATUM + FALSE,
    "better": HEAD + ERRATUM.replace("= b \\times a'", "= -b \\times a'", 1),
    "nothing": HEAD + TRUE + "assume = ['a = 0', 'a \\neq 0']\n",
    "other": "[tool]\nname = 'x'\n# [[claim]] in a comment\n",
}
NO_SETTINGS_FROM_ABOVE = "[pytest]\n"


ALONE = ("-p", "no:cacheprovider", "-p", "no:hypothesispytest", "-p", "no:xdist")


@pytest.fixture(scope="module")
def papers(tmp_path_factory) -> Path:
    load_engines()  # pytester forgets what is imported meanwhile, and Drake is imported once
    directory = tmp_path_factory.mktemp("papers")
    for name, text in FILES.items():
        (directory / f"{name}.toml").write_text(text, encoding="utf-8")
    (directory / "pytest.ini").write_text(NO_SETTINGS_FROM_ABOVE, encoding="utf-8")
    return directory


@pytest.fixture(scope="module")
def output(papers) -> str:
    """What pytest prints of all the files."""
    call = [sys.executable, "-m", "pytest", *ALONE, "-v"]
    done = subprocess.run(call, cwd=papers, capture_output=True, text=True, timeout=60)
    assert done.stderr == ""
    return done.stdout


def test_each_claim_is_an_item_of_its_own(output):
    items = re.findall(r"^(\w+\.toml::\w+) (\w+)", output, re.MULTILINE)
    assert sorted(items) == [
        ("better.toml::erratum", "FAILED"),
        ("nothing.toml::true", "FAILED"),
        ("paper.toml::erratum", "PASSED"),
        ("paper.toml::false", "FAILED"),
        ("paper.toml::true", "PASSED"),
    ]


def test_a_failure_shows_expectation_and_evidence_only(output):
    failure = output[output.index("paper.toml:12: claim false") :]
    assert "as printed: expected proved, got refuted" in failure
    assert failure.index("counterexample") < failure.index("the left side is (")
    assert "Traceback" not in output and "pytest_plugin.py" not in output


def test_a_verdict_that_got_better_than_expected_fails_too(output):
    assert "as printed: expected refuted, got proved" in output


def test_unsatisfiable_assumptions_fail_with_one_message(output):
    assert re.search(r"nothing\.toml:5: claim true: .*assum", output)


def test_other_toml_files_are_left_alone(output):
    assert "other.toml" not in output


def test_one_claim_can_be_run_alone(papers, pytester):
    pytester.runpytest_inprocess(*ALONE, papers / "paper.toml::erratum").assert_outcomes(passed=1)


def test_an_unusable_paper_is_one_collection_error(papers, pytester):
    (pytester.path / "bad.toml").write_text(HEAD + TRUE.replace("-b", "-c"), encoding="utf-8")
    output = pytester.runpytest_inprocess(*ALONE, papers / "other.toml", "bad.toml").stdout.str()
    assert "other.toml:1:1: unknown key 'tool'" in output
    assert re.search(r"bad\.toml:7:26: printed: unknown symbol c", output)
    assert "2 errors" in output and "Traceback" not in output
