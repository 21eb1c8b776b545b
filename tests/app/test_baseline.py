"""Findings that were known before: by a file, by a git revision; and the commit since which a display is false."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from workbench.app.commands.commands import main

HEAD = "%! workbench: symbols.'a' = \"vector\"\n%! workbench: symbols.'b' = \"vector\"\n"
SWAP, TWICE, RIGHT = r"a \times b = b \times a", r"a + a = 3 a", r"a \cdot b = b \cdot a"


def text(*formulas: str) -> str:
    return HEAD + "".join(f"\\[ {each} \\]\n" for each in formulas)


def check(*arguments: str) -> Result:
    words = ["check", *arguments, "--no-motions", "--no-proposals", "--format", "github"]
    result = CliRunner().invoke(main, words)
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result


def errors(result: Result) -> list[str]:
    return [
        line.partition("::refuted")[0].split("line=")[1].split(",")[0] for line in result.stdout.splitlines()
    ]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("p.tex").write_text(text(SWAP, RIGHT))
    return tmp_path


def test_faults_listed_in_a_baseline_are_not_reported(folder: Path) -> None:
    assert errors(check("p.tex")) == ["3"]
    assert check("p.tex", "--write-baseline", "known.json").exit_code == 0
    again = check("p.tex", "--baseline", "known.json", "--strict")
    assert again.exit_code == 0 and again.stdout == "" and again.stderr == ""
    Path("p.tex").write_text(text(RIGHT, TWICE, SWAP))
    found = check("p.tex", "--baseline", "known.json")
    assert found.exit_code == 1 and errors(found) == ["4"]
    told = CliRunner().invoke(main, ["check", "p.tex", "--baseline", "known.json"]).stdout
    assert "p.tex: 1 error, 1 known, 1 holds" in told and SWAP not in told


@settings(max_examples=8, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    kept=st.lists(st.sampled_from([SWAP, TWICE, RIGHT]), max_size=4),
    more=st.lists(st.sampled_from([SWAP, TWICE, RIGHT]), max_size=2),
    data=st.data(),
)
def test_as_many_are_new_as_were_added(
    folder: Path, kept: list[str], more: list[str], data: st.DataObject
) -> None:
    Path("p.tex").write_text(text(RIGHT, *kept))
    check("p.tex", "--write-baseline", "known.json")
    mixed = data.draw(st.permutations([*kept, *more]))
    blanks = [each.replace(" ", data.draw(st.sampled_from([" ", "  ", "\n"]))) for each in mixed]
    Path("p.tex").write_text(text(RIGHT, *blanks))
    found = check("p.tex", "--baseline", "known.json")
    assert len(errors(found)) == len([each for each in more if each != RIGHT])


def test_the_same_findings_give_the_same_bytes(folder: Path) -> None:
    check("p.tex", "--write-baseline", "one.json")
    Path("p.tex").write_text(text(RIGHT, RIGHT, SWAP))
    check("p.tex", "--write-baseline", "two.json")
    assert Path("one.json").read_bytes() == Path("two.json").read_bytes()
    (entry,) = json.loads(Path("one.json").read_text())["known"]
    assert entry == {"file": "p.tex", "formula": SWAP, "verdict": "refuted", "grade": "error"}


def test_stale_entries_are_reported(folder: Path) -> None:
    check("p.tex", "--write-baseline", "known.json")
    Path("p.tex").write_text(text(RIGHT))
    told = check("p.tex", "--baseline", "known.json")
    assert told.exit_code == 0 and f"no longer wrong: {SWAP}" in told.stderr
    Path("q.tex").write_text(text(RIGHT))
    assert "no longer" not in check("q.tex", "--baseline", "known.json").stderr, "p.tex is not looked at"


@pytest.mark.parametrize(
    "content",
    [
        "",
        "[",
        "[]",
        "{}",
        '{"version": 2, "known": []}',
        '{"version": 1, "known": [{"file": 1}]}',
        "[" * 9999,
    ],
)
def test_a_bad_baseline_is_one_error(folder: Path, content: str) -> None:
    Path("known.json").write_text(content)
    result = check("p.tex", "--baseline", "known.json")
    assert result.exit_code == 2 and "--write-baseline" in result.stderr and "Traceback" not in result.stderr


def test_a_missing_baseline_is_one_error(folder: Path) -> None:
    result = check("p.tex", "--baseline", "known.json")
    assert result.exit_code == 2 and "known.json: no such file" in result.stderr


def test_a_watched_file_has_no_baseline(folder: Path) -> None:
    assert check("p.tex", "--watch", "--since", "HEAD").exit_code == 2


def git(*arguments: str) -> None:
    identity = ["-c", "user.name=n", "-c", "user.email=n@example.org", "-c", "commit.gpgsign=false"]
    subprocess.run(["git", *identity, *arguments], check=True, capture_output=True)


@pytest.fixture
def repository(folder: Path) -> Path:
    if shutil.which("git") is None:
        pytest.skip("no git is installed")
    git("init", "-q")
    for message, formulas in [
        ("Begin", (RIGHT, r"a + a = 2 a")),
        ("Swap", (RIGHT, r"a + a = 2 a", SWAP)),
        ("Spoil", (RIGHT, TWICE, SWAP)),
        ("Move", (SWAP, RIGHT, TWICE)),
    ]:
        Path("p.tex").write_text(text(*formulas))
        git("add", "p.tex")
        git("commit", "-q", "-m", message)
    return folder


def test_faults_of_an_earlier_revision_are_not_reported(repository: Path) -> None:
    assert errors(check("p.tex")) == ["3", "5"]
    assert errors(check("p.tex", "--since", "HEAD")) == []
    assert errors(check("p.tex", "--since", "HEAD~2")) == ["5"]
    assert errors(check("p.tex", "--since", "HEAD~3")) == ["3", "5"]
    Path("new.tex").write_text(text(SWAP))
    assert errors(check("new.tex", "--since", "HEAD")) == ["3"]


def declared(kind: str) -> str:
    return (
        f"%! workbench: symbols.'A' = \"{kind}\"\n%! workbench: symbols.'B' = \"{kind}\"\n\\[ A B = B A \\]\n"
    )


def test_a_display_that_a_declaration_makes_false_is_new(repository: Path) -> None:
    Path("p.tex").write_text(declared("scalar"))
    git("commit", "-q", "-a", "-m", "Scalars")
    Path("p.tex").write_text(declared("tensor"))
    assert check("p.tex", "--since", "HEAD").exit_code == 1


def test_the_commit_is_found_since_which_a_display_is_false(repository: Path) -> None:
    with Path("p.tex").open("a") as stream:
        stream.write("\\[ b \\cdot a = 2 a \\cdot b \\]\n")
    result = CliRunner().invoke(main, ["bisect", "p.tex"])
    told = result.stdout.split("✗ ")[1:]
    assert result.exit_code == 1 and len(told) == 3
    assert SWAP in told[0] and ": Swap;" in told[0]
    assert TWICE in told[1] and ": Spoil;" in told[1]
    assert "changes that are not committed" in told[2]
    cut = CliRunner().invoke(main, ["bisect", "p.tex", "--most", "1"]).stdout
    assert cut.count("no older commit was judged") == 2


def test_a_display_that_a_declaration_makes_false_is_traced(repository: Path) -> None:
    for kind in ("scalar", "tensor"):
        Path("p.tex").write_text(declared(kind))
        git("commit", "-q", "-a", "-m", f"Declare {kind}")
    told = CliRunner().invoke(main, ["bisect", "p.tex"]).stdout
    assert ": Declare tensor; not false in " in told and told.endswith(": Declare scalar\n")


@pytest.mark.parametrize("name", ["nope", "--output=x", "HEAD:p.tex", ""])
def test_a_bad_revision_is_one_error(repository: Path, name: str) -> None:
    result = check("p.tex", f"--since={name}")
    assert (
        result.exit_code == 2 and "expected a commit" in result.stderr and os.listdir() == [".git", "p.tex"]
    )


def test_no_repository_is_one_error(folder: Path) -> None:
    for words in (["check", "p.tex", "--since", "HEAD"], ["bisect", "p.tex"]):
        result = CliRunner().invoke(main, words, env={"GIT_CEILING_DIRECTORIES": str(folder.parent)})
        assert result.exit_code == 2 and "expected a file in a git repository" in result.output


def test_hooks_filters_and_links_of_a_repository_are_ignored(repository: Path) -> None:
    Path("link.tex").symlink_to("/etc/hostname")
    Path(".gitattributes").write_text("*.tex filter=bad\n")
    git("add", ".")
    git("commit", "-q", "-m", "Links")
    git("config", "filter.bad.smudge", f"touch {repository}/touched")
    hook = repository / ".git/hooks/post-checkout"
    hook.write_text(f"#!/bin/sh\ntouch {repository}/touched\n")
    hook.chmod(0o755)
    assert errors(check("p.tex", "--since", "HEAD")) == []
    assert not Path("touched").exists()


def fingerprints(*formulas: str) -> list[str]:
    Path("p.tex").write_text(text(*formulas))
    words = ["check", "p.tex", "--no-motions", "--no-proposals", "--format", "sarif"]
    (log,) = json.loads(CliRunner().invoke(main, words).stdout)["runs"]
    return [each["partialFingerprints"]["display/v1"] for each in log["results"]]


def test_fingerprints_of_sarif_are_of_what_is_displayed(folder: Path) -> None:
    before = fingerprints(SWAP, RIGHT, SWAP)
    assert len(set(before)) == 2
    assert fingerprints(RIGHT, RIGHT, SWAP.replace(" ", "  "), SWAP) == before
    assert set(fingerprints(SWAP, TWICE)) - set(before) and fingerprints(SWAP)[0] == before[0]


def test_places_of_sarif_are_uris(folder: Path) -> None:
    Path("é p.tex").write_text(text(SWAP))
    for name, uri in [
        ("é p.tex", "%C3%A9%20p.tex"),
        (str(folder / "é p.tex"), (folder / "é p.tex").as_uri()),
    ]:
        told = CliRunner().invoke(main, ["check", name, "--no-motions", "--format", "sarif"]).stdout
        (result,) = json.loads(told)["runs"][0]["results"]
        files = [result["locations"][0]["physicalLocation"], result["fixes"][0]["artifactChanges"][0]]
        assert [each["artifactLocation"]["uri"] for each in files] == [uri, uri]
