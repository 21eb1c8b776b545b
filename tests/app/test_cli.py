"""The command line: what it prints, its exit status, and the one message that bad input gets."""

from __future__ import annotations

import json
import os
import pty
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from bad_papers import BAD_PAPERS, HEAD, SYMBOL_FAULTS, BadPaper
from click.testing import CliRunner, Result

from workbench.app.commands.commands import main

PAPERS = Path(__file__).parents[1] / "papers"
EVERY_VERDICT = str(PAPERS / "every_verdict.toml")
IDENTITIES = str(PAPERS / "vector_identities.toml")
COMMAND = [sys.executable, "-c", "from workbench.app.commands.commands import main; main()"]


def run(*arguments: str) -> Result:
    result = CliRunner().invoke(main, arguments)
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result


def assert_one_message(result: Result, says: str) -> None:
    assert result.exit_code == 2
    assert result.stdout == ""
    message = [line for line in result.stderr.splitlines() if line.startswith("Error: ")]
    assert len(message) == 1 and says in message[0]
    assert "Traceback" not in result.stderr


# what the commands print


def test_list_shows_the_claims_and_what_is_expected_of_them():
    claims = json.loads(run("list", "--paper", EVERY_VERDICT, "--json").stdout)
    assert [c["id"] for c in claims][:3] == ["proved", "defined", "false"]
    assert {c["expected"] for c in claims} == {"proved", "refuted", "ill-formed", "conditional"}
    table = run("list", "--paper", EVERY_VERDICT).stdout.splitlines()
    assert len(table) == 1 + len(claims) and all(c["printed"] in table[i + 1] for i, c in enumerate(claims))


def test_verify_passes_when_each_verdict_is_the_expected_one():
    result = run("verify", "--paper", EVERY_VERDICT)
    assert result.exit_code == 0
    assert "8 claims: 2 proved, 1 definition, 1 conditional, 1 refuted, 3 ill-formed" in result.stdout
    assert "\x1b" not in result.stdout and result.stderr == ""


def test_check_passes_when_all_is_proved():
    assert run("check", IDENTITIES).exit_code == 0
    assert run("check", EVERY_VERDICT).exit_code == 0  # all as its claims expect


def test_a_verdict_that_is_not_the_expected_one_fails_verify(tmp_path):
    paper = tmp_path / "p.toml"
    paper.write_text(
        "title = 'x'\n[symbols]\na = { kind = 'vector' }\n[[claim]]\nid = '1'\nprinted = 'a = 2a'\n"
    )
    result = run("verify", "--paper", str(paper))
    assert result.exit_code == 1
    assert "NO: as printed: expected proved, got refuted" in result.stdout
    assert "1 not as expected" in result.stdout


def test_show_tells_all_of_one_claim():
    result = run("show", "garbled-and-false", "--paper", EVERY_VERDICT)
    assert result.exit_code == 0
    for part in (
        "ill-formed",
        "juxtaposition",
        "reading",
        "corrected",
        "counterexample",
        r"\omega = (",
        "left",
    ):
        assert part in result.stdout


def test_show_as_json_is_the_claim_of_the_report():
    claim = json.loads(run("show", "false", "--paper", EVERY_VERDICT, "--json").stdout)
    assert claim["verdict"] == "refuted" and claim["corrected"]["verdict"] == "proved"
    assert claim["inherits"] == ["garbled-and-false"]
    assert set(claim["counterexample"]) == {"values", "lhs", "rhs", "defined", "behind"}


@pytest.mark.parametrize(
    ("select", "ids"),
    [
        (
            ["2"],
            {
                "defined",
                "proved",
                "false",
                "garbled",
                "garbled-and-false",
                "unequal",
                "conditional",
                "family",
            },
        ),
        (["1"], {"proved"}),
        (["3-5"], {"false", "garbled", "garbled-and-false"}),
        (["3–5", "1"], {"proved", "false", "garbled", "garbled-and-false"}),
        (["garbled*"], {"garbled", "garbled-and-false"}),
        (["unequal"], {"unequal"}),
    ],
)
def test_select(select, ids):
    claims = json.loads(run("list", *select, "--paper", EVERY_VERDICT, "--json").stdout)
    assert {c["id"] for c in claims} == ids


def test_json_is_the_same_twice_and_has_what_the_design_says():
    first, second = (run("verify", "1-3", "--paper", EVERY_VERDICT, "--json") for _ in range(2))
    assert first.stdout_bytes == second.stdout_bytes
    report = json.loads(first.stdout)
    assert report["paper"] == {"title": "A rigid body", "doi": "10.1000/182"}
    assert set(report["versions"]) == {"workbench", "drake", "python-flint", "sympy", "numpy"}
    assert report["summary"] == {"proved": 1, "refuted": 1, "definition": 1}
    keys = {"id", "equation", "section", "printed", "read_back", "verdict", "scope", "reading", "corrected"}
    keys |= {"hypothesis", "counterexample", "evidence", "inherits", "note"}
    for claim in report["claims"]:
        assert keys <= set(claim)
        assert claim["evidence"], "a verdict without evidence"


def test_check_writes_json_to_a_file_too(tmp_path):
    out = tmp_path / "out.json"
    result = run("check", IDENTITIES, "--json", str(out))
    assert result.exit_code == 0 and "6 claims" in result.stdout
    assert json.loads(out.read_text(encoding="utf-8"))["summary"] == {"proved": 6}
    assert [path.name for path in tmp_path.iterdir()] == ["out.json"]


def test_without_the_second_engine_nothing_is_proved():
    result = run("verify", "1", "--paper", EVERY_VERDICT, "--no-second-engine", "--json")
    assert result.exit_code == 1
    assert json.loads(result.stdout)["summary"] == {"probable": 1}


# the report


def test_report_writes_every_format_and_nothing_else(tmp_path):
    out = tmp_path / "deep" / "report"
    result = run("report", "1-4", "--paper", EVERY_VERDICT, "--out", str(out))
    assert result.exit_code == 0
    suffixes = sorted(path.suffix for path in out.iterdir())
    assert suffixes == [".html", ".json", ".json", ".md", ".tex"]
    assert json.loads((out / "report.json").read_text(encoding="utf-8"))["summary"]["refuted"] == 1


def test_a_report_that_fails_midway_leaves_the_old_one(tmp_path, monkeypatch):
    (tmp_path / "report.json").write_text("old")

    def breaks(path, content):
        with path.open("wb") as half:
            half.write(content[:10])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", breaks)
    result = run("report", "1", "--paper", EVERY_VERDICT, "--out", str(tmp_path))
    assert_one_message(result, "No space left on device")
    assert (tmp_path / "report.json").read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]


# bad input


@pytest.mark.parametrize("bad", BAD_PAPERS + SYMBOL_FAULTS, ids=lambda bad: bad.name)
def test_a_bad_paper_is_unusable(bad: BadPaper, tmp_path):
    path = tmp_path / "bad.toml"
    path.write_bytes(bad.content.encode())
    place = "Error: {}:{}:{}: ".format(path, *bad.place)
    result = run("check", str(path), "--no-motions", "--no-proposals")
    assert result.exit_code == 1 + (result.stdout == "")  # 1 where other claims could be judged
    told = [line for line in result.stderr.splitlines() if line.startswith(place)]
    assert told and len({*told}) == len(told) and "Traceback" not in result.stderr


def test_each_fault_has_a_caret_and_each_format_tells_all(tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text(f"{HEAD}'a' = {{ kind = 'vektor' }}\n[[claim]]\nid = 'x'\nprinted = '\\omega = \\psi'\n")
    result = run("check", str(path))
    assert result.exit_code == 2 and result.stdout == ""
    shown = result.stderr.splitlines()
    assert [line.endswith("^") for line in shown] == [False, False, True] * 2
    assert [shown[2].index("^"), shown[5].index("^")] == [9, 9 + len("printed = '\\omega = ")]
    for form in ("github", "rdjsonl"):
        told = run("check", str(path), "--format", form)
        assert told.exit_code == 2 and len(told.stdout.splitlines()) == 2
    assert len(json.loads(run("check", str(path), "--format", "sarif").stdout)["runs"][0]["results"]) == 2
    assert len(json.loads(run("check", str(path), "--format", "json").stdout)["faults"]) == 2


BAD_CALLS = [
    (["check"], "Missing argument 'FILE...'"),
    (["check", "no.toml"], "no.toml: no such file"),
    (["check", "workbench/engines"], "holds no text; expected"),
    (["check", "/dev/null"], "is not a regular file"),
    (["check", IDENTITIES, "--jason"], "No such option"),
    (["check", IDENTITIES, "--json", "no/such/directory/x.json"], "cannot be written"),
    (["verify", "999", "--paper", EVERY_VERDICT], "'999' selects no claim"),
    (["verify", "9-7", "--paper", EVERY_VERDICT], "'9-7' selects no claim"),
    (["verify", "", "--paper", EVERY_VERDICT], "selects no claim"),
    (["verify", "--paper", "nothing"], "no installed paper of that name"),
    (["verify", "--paper", ""], "is a directory"),
    (["verify", "--paper", "no/such.toml"], "no such file"),
    (["verify", "--paper"], "requires an argument"),
    (["show", "--paper", EVERY_VERDICT], "Missing argument 'ID'"),
    (["show", "nothing", "--paper", EVERY_VERDICT], "'nothing' selects no claim"),
    (["list", "nothing", "--paper", EVERY_VERDICT], "'nothing' selects no claim"),
    (["list", "--paper", EVERY_VERDICT, "--josn"], "No such option"),
    (["report", "--paper", EVERY_VERDICT, "--out", EVERY_VERDICT], "expected a directory"),
    (
        ["report", "1", "--paper", EVERY_VERDICT, "--out", f"{EVERY_VERDICT}/x"],
        "expected a directory for the report",
    ),
    (["report", "nothing", "--paper", EVERY_VERDICT, "--out", "unused"], "selects no claim"),
    (["judge"], "no command 'judge'"),
    (["motion"], "Missing argument 'URDF'"),
    (["motion", "no.urdf"], "Missing option '--body'"),
    (["motion", "no.urdf", "--body", "b"], "no.urdf"),
    (["motion", EVERY_VERDICT, "--body", "b"], "every_verdict.toml"),
    (["motion", "no.urdf", "--body", "b", "--order", "0"], "'--order'"),
    (["motion", "no.urdf", "--body", "b", "--order", "1000"], "'--order'"),
    (["motion", "no.urdf", "--body", "b", "--order", "two"], "'--order'"),
    (["motion", "no.urdf", "--body", "b", "--at", "now"], "'--at'"),
    (["motion", "no.urdf", "--body", "b", "--point", "1,2"], "point: expected 3 finite numbers"),
    (["motion", "no.urdf", "--body", "b", "--point", "1,2,inf"], "point: expected 3 finite numbers"),
    (["motion", "no.urdf", "--body", "b", "--joint", "q"], "joint: expected NAME=C0,C1"),
    (["motion", "no.urdf", "--body", "b", "--joint", "q=1,x"], "joint q: expected finite numbers"),
    (
        ["motion", "no.urdf", "--body", "b", "--joint", "q=1", "--joint", "q=2"],
        "joint q: expected one polynomial",
    ),
    (["motion", "no.urdf", "--body", "b", "--limits", "no.toml"], "no.toml: cannot be read"),
    (["motion", "no.urdf", "--body", "b", "--base", "free"], "'--base'"),
]


@pytest.mark.parametrize(
    ("arguments", "says"),
    BAD_CALLS,
    ids=lambda value: "_".join(value)[-40:] if isinstance(value, list) else "",
)
def test_a_bad_call_gets_one_message(arguments, says):
    assert_one_message(run(*arguments), says)


def test_assumptions_that_nothing_satisfies_are_an_error(tmp_path):
    paper = tmp_path / "p.toml"
    paper.write_text(
        "title = 'x'\n[symbols]\na = { kind = 'vector' }\n[[claim]]\nid = '1'\nprinted = 'a^2 = 1'\n"
        "assume = ['a = 0', 'a \\neq 0']\n"
    )
    assert_one_message(run("check", str(paper)), f"{paper}:4: claim 1: ")


def test_engines_that_disagree_are_a_defect_and_no_verdict(monkeypatch):
    from workbench.core.verdict import EngineDisagreement
    from workbench.prover.decide.decide import Judge

    def disagree(*arguments, **options):
        raise EngineDisagreement("zero here, not there")

    monkeypatch.setattr(Judge, "judge", disagree)
    result = run("verify", "1", "--paper", EVERY_VERDICT)
    assert result.exit_code == 1 and "engines disagree: zero here, not there" in " ".join(
        result.stdout.split()
    )


# a real process


def test_a_process_ends_with_status_2_and_no_traceback(tmp_path):
    done = subprocess.run([*COMMAND, "check", str(tmp_path)], capture_output=True, text=True, timeout=30)
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith(f"Error: {tmp_path}: holds no text; expected .htm")


def test_listing_needs_no_engine():
    code = "import sys; from workbench.app.commands.commands import main; main(standalone_mode=False); print(sorted(sys.modules))"
    call = [sys.executable, "-c", code, "list", "--paper", EVERY_VERDICT]
    modules = subprocess.run(call, capture_output=True, text=True, check=True).stdout.splitlines()[-1]
    assert "'lark'" in modules
    for heavy in ("pydrake", "sympy", "flint", "numba", "numpy", "jinja2"):
        assert f"'{heavy}'" not in modules


def test_a_closed_pipe_is_no_fault():
    call = f"{sys.executable} -c 'from workbench.app.commands.commands import main; main()' list --paper {EVERY_VERDICT} | true"
    done = subprocess.run(["bash", "-c", call], capture_output=True, text=True, timeout=30)
    assert done.stderr == ""


def test_a_locale_without_greek_is_no_fault(tmp_path):
    paper = tmp_path / "p.toml"
    text = "title = 'x'\n[symbols]\na = { kind = 'vector' }\n[[claim]]\nid = 'Φ'\nprinted = 'a = a'\n"
    paper.write_text(text, encoding="utf-8")
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    call = [*COMMAND, "list", "--paper", str(paper)]
    done = subprocess.run(call, capture_output=True, text=True, timeout=30, env=environment)
    assert done.returncode == 0 and r"\u03a6" in done.stdout


def test_interrupted_it_says_so_and_leaves_no_half_report(tmp_path):
    code = (
        "import os, signal, workbench.prover.decide.decide as j\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a job in the background ignores it
        "j.Judge.judge = lambda *a, **k: os.kill(os.getppid(), signal.SIGINT) or __import__('time').sleep(9)\n"
        "from workbench.app.commands.commands import main; main()"
    )
    call = [sys.executable, "-c", code, "report", "--paper", EVERY_VERDICT, "--out", str(tmp_path / "out")]
    anew = {**os.environ, "WORKBENCH_CACHE": os.devnull}  # a kept verdict is not judged
    done = subprocess.run(call, capture_output=True, text=True, timeout=30, env=anew)
    assert done.returncode == 128 + signal.SIGINT
    assert done.stderr == "interrupted\n"
    assert not (tmp_path / "out").exists()


def test_interrupted_while_a_library_is_loaded_it_says_so(monkeypatch):
    """What of a library's own makes an ImportError of Ctrl-C is no fault; another ImportError is one."""

    def interrupted(*_):
        raise ImportError("initialization failed") from KeyboardInterrupt()

    def missing(*_):
        raise ImportError("no module of that name")

    for fault, told in ((interrupted, (130, "interrupted\n")), (missing, (1, ""))):
        monkeypatch.setattr("workbench.papers.find_paper", fault)
        found = CliRunner().invoke(main, ["list"])
        assert (found.exit_code, found.output) == told


def on_a_terminal(*arguments: str, **variables: str) -> str:
    """What a command writes to a terminal."""
    leader, follower = pty.openpty()
    environment = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "FORCE_COLOR", "CI")}
    environment |= {"TERM": "xterm-256color", "COLUMNS": "150", **variables}
    process = subprocess.Popen([*COMMAND, *arguments], stdout=follower, stderr=follower, env=environment)
    os.close(follower)
    written = b""
    while True:
        try:
            piece = os.read(leader, 65536)
        except OSError:  # how Linux says that the other end is closed
            break
        if not piece:
            break
        written += piece
    process.wait(30)
    os.close(leader)
    return written.decode()


COLOUR = re.compile(r"\x1b\[[0-9;]*3[1-5]m")


def test_a_terminal_gets_colours_unless_no_color_is_set():
    listing = ("list", "--paper", EVERY_VERDICT)
    assert COLOUR.search(on_a_terminal(*listing))
    assert not COLOUR.search(on_a_terminal(*listing, NO_COLOR="1"))


def test_a_terminal_gets_a_progress_bar():
    engines = ("--no-second-engine", "--no-motions")
    assert "judging" in on_a_terminal("verify", "1", "3", "--paper", EVERY_VERDICT, *engines)
