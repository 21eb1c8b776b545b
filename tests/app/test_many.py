"""Many papers at once, on processes and on a cluster that loses a worker; files that are watched; one bad formula."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from contextlib import closing, nullcontext
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from workbench.app.commands.commands import main
from workbench.app.pipeline import dask_workers
from workbench.app.pipeline.judge_claims import PaperJudge
from workbench.app.pipeline.judged_files import Loaded, loaded_file
from workbench.app.pipeline.many_papers import judge_papers
from workbench.app.pipeline.verdict_keys import Memory
from workbench.app.servers import watch
from workbench.runtime import Budget
from workbench.source.documents import texts_in

HEAD = 'title = "p"\n[symbols]\na = { kind = "vector" }\nb = { kind = "vector" }\n'
TRUE = "[[claim]]\nid = 'true'\nprinted = 'a \\times b = -b \\times a'\n"
FALSE = "[[claim]]\nid = 'false'\nprinted = 'a \\times b = b \\times a'\ncorrected = 'a \\times b = -b \\times a'\n"
UNREAD = "[[claim]]\nid = 'unread'\nprinted = 'a \\foo b = 0'\n"
TEXT = """%! workbench: symbols.'a' = { kind = "vector" }
\\[ a \\cdot a = a^2 \\]
\\[ a \\times a = 1 a \\]
\\input{part}
"""


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, [*arguments], catch_exceptions=False)


def papers(folder: Path) -> list[tuple[str, Loaded]]:
    """A paper file, a text with a model, and one without."""
    (folder / "one.toml").write_text(HEAD + TRUE + FALSE)
    (folder / "two.tex").write_text(TEXT)
    (folder / "part.tex").write_text("\\[ 2 a = a + a \\]")
    (folder / "three.md").write_text(
        "$$ \\mathbf{a} \\times \\mathbf{b} = \\mathbf{b} \\times \\mathbf{a} $$\n"
    )
    return [(str(folder / name), loaded_file(folder / name)) for name in ("one.toml", "two.tex", "three.md")]


VERDICTS = [["proved", "refuted"], ["proved", "refuted", "proved"], ["refuted"]]


def outcomes(found) -> list[list[str]]:
    return [[str(result.verdict.outcome) for result in each.results] for each in found]


def test_an_unreadable_formula_hides_no_other(tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(
        HEAD + TRUE + UNREAD + FALSE + "inherits = ['unread']\n" + UNREAD.replace("unread", "again")
    )
    result = run("check", str(path), "--no-proposals")
    assert result.exit_code == 1
    assert "2 claims: 1 proved, 1 refuted; all as expected" in result.output
    assert result.output.count("unknown command \\foo") == 2 and f"{path}:10:14: printed:" in result.output
    data = json.loads(run("check", str(path), "--format", "json", "--no-proposals").stdout)
    assert [fault["line"] for fault in data["faults"]] == [10, 18]
    path.write_text(HEAD + UNREAD)
    assert run("check", str(path)).exit_code == 2


def test_several_papers_on_several_processes(tmp_path: Path) -> None:
    names = [name for name, _ in papers(tmp_path)]
    (tmp_path / "bad.toml").write_text("[")
    result = run("check", *names, "--jobs", "2", "--no-proposals", "--no-motions")
    assert result.exit_code == 1 and all(f"{name}:" in result.output for name in names)
    result = run("check", *names, str(tmp_path / "bad.toml"), "--format", "github", "--no-motions")
    assert result.exit_code == 2 and "not TOML" in result.output and "::error" in result.output


def test_a_text_without_a_model_says_what_it_needs(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("$$ x + y = z $$\n")
    result = run("check", str(path))
    assert result.exit_code == 0 and "no error found; 1 definition" in result.output
    assert "drafted a model of p.md (3 symbols" in result.output
    assert f"workbench draft {path}" in " ".join(result.output.split())


def test_a_worker_judges_what_has_the_very_same_key_alone(tmp_path: Path) -> None:
    (name, loaded), *_ = papers(tmp_path)
    paper = loaded.paper
    judge, bundle = PaperJudge(paper, motions=False), dask_workers.Bundle.of(paper, name)
    claim = paper.claims[1]
    options = {"motions": False}
    told = [
        dask_workers._judged({}, bundle, claim.id, form, key, options, judge.budget, b"secret")
        for form in claim.forms
        for key in (judge.key(claim, form), "another")
    ]
    refused = "the worker's workbench is another one, or its files; its verdict does not count"
    answers = [each if isinstance(each, str) else each["outcome"] for each in told]
    assert answers == ["refuted", refused, "proved", refused]


def test_a_scheduler_that_is_none_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbench.app.pipeline.dask_workers.CONNECT", 1)
    (name, _), *_ = papers(tmp_path)
    result = run("check", name, "--scheduler", "tcp://127.0.0.1:1")
    assert (result.exit_code, "no scheduler of Dask answers there" in result.output) == (2, True)


def test_a_cluster_that_loses_a_worker_loses_no_verdict(tmp_path: Path) -> None:
    """The second run has its verdicts from the first one's memory, and asks no worker."""
    from distributed import LocalCluster

    chosen = papers(tmp_path)
    memory = Memory(tmp_path / "verdicts.sqlite")
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        processes = [worker.pid for worker in cluster.workers.values()]

        def kill() -> None:
            time.sleep(0.3)
            os.kill(processes[0], signal.SIGKILL)

        thread = threading.Thread(target=kill)
        thread.start()
        found = outcomes(
            judge_papers(chosen, scheduler=cluster.scheduler_address, memory=memory, motions=False)
        )
        thread.join()
    assert found == VERDICTS
    assert outcomes(judge_papers(chosen, memory=memory, motions=False)) == VERDICTS
    memory.close()


def test_an_interrupted_run_continues_from_its_verdicts(tmp_path: Path) -> None:
    chosen = papers(tmp_path)
    memory = Memory(tmp_path / "verdicts.sqlite")

    def interrupt(result) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        list(
            judge_papers(chosen, memory=memory, motions=False, progress=lambda count: nullcontext(interrupt))
        )
    judge = PaperJudge(chosen[0][1].paper, memory=memory, motions=False)
    claims = chosen[0][1].paper.claims
    assert memory.recall(judge.key(claims[0], "printed")) is not None
    assert memory.recall(judge.key(claims[1], "printed")) is None
    memory.close()


def test_a_watched_paper_is_judged_again_when_it_changes(tmp_path: Path) -> None:
    papers(tmp_path)
    code = "from workbench.app.commands.commands import main; main()"
    call = [sys.executable, "-uc", code, "check", "--watch", "--jobs", "2", "two.tex", "--no-motions"]
    environment = {**os.environ, "WORKBENCH_CACHE": str(tmp_path / "cache")}
    with subprocess.Popen(call, cwd=tmp_path, stdout=subprocess.PIPE, text=True, env=environment) as process:
        try:
            assert "two.tex: 1 error" in _until(process, "waiting for changes")
            time.sleep(0.5)
            (tmp_path / "part.tex").write_text("\\[ 3 a = a + a \\]")
            start = time.monotonic()
            assert "two.tex: 2 errors" in _until(process, "waiting for changes")
            assert time.monotonic() - start < 15  # a second on a quiet machine
        finally:
            process.terminate()  # what runs in the background may not hear SIGINT


def test_a_watched_text_without_a_model_is_drafted(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    path = tmp_path / "plain.tex"
    path.write_text("\\[ \\mathbf{a} \\times \\mathbf{b} = \\mathbf{b} \\times \\mathbf{a} \\]\n")
    assert path in watch._judged(path, "text", None, 1, None, None, {"motions": False})
    told = capsys.readouterr().out
    assert "drafted a model of plain.tex" in told and "1 warning" in told


def _until(process: subprocess.Popen, words: str) -> str:
    told = ""
    while words not in told:
        line = process.stdout.readline()
        assert line, told
        told += line
    return told


def test_a_worker_keeps_few_papers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    closed: list[str] = []
    monkeypatch.setattr(dask_workers.PaperJudge, "close", lambda judge: closed.append(judge.paper.title))
    judges: dict = {}
    for number in range(dask_workers._KEPT + 2):
        path = tmp_path / f"{number}.toml"
        path.write_text(HEAD + TRUE)
        bundle = dask_workers.Bundle.of(loaded_file(path).paper, str(path))
        told = dask_workers._judged(judges, bundle, "true", "printed", "another key", {}, Budget.of(), b"s")
        assert "its verdict does not count" in told
    assert len(judges) == dask_workers._KEPT and len(closed) == 2


@pytest.mark.slow
def test_a_scheduler_that_dies_and_comes_back_loses_no_verdict(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = tmp_path / "many.toml"
    claims = (
        TRUE.replace("'true'", f"'{n}'").replace("a \\times b =", f"{n} a \\times b = {n - 1} a \\times b")
        for n in range(2, 42)
    )
    path.write_text(HEAD + "".join(claims))
    paper = loaded_file(path)
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]

    def start() -> list[subprocess.Popen]:
        words = [
            ["scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"],
            ["worker", f"tcp://127.0.0.1:{port}", "--nthreads", "1", "--no-dashboard", "--no-nanny"],
        ]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": tmp_path}
        return [
            subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_" + first, *rest], **quiet)
            for first, *rest in words
        ]

    running = start()
    seen = []

    def replaced(result) -> None:
        seen.append(result.claim.id)
        if len(seen) == 3:
            for process in running:
                process.kill()
            running[:] = start()

    try:
        found = list(
            judge_papers(
                [(str(path), paper)],
                scheduler=f"tcp://127.0.0.1:{port}",
                progress=lambda count: nullcontext(replaced),
                motions=False,
            )
        )
    finally:
        for process in running:
            process.kill()
    assert outcomes(found) == [["proved"] * 40] and sorted(seen) == sorted(set(seen))
    told = [each for each in caplog.messages if "Traceback" in each or "the scheduler is gone" in each]
    assert len(told) == 1 and "the scheduler is gone" in told[0]


def test_a_folder_is_its_texts_without_their_parts(tmp_path: Path) -> None:
    for name, text in {
        "main.tex": "\\documentclass{article}\\input{parts/one} % \\input{old}\n\\subfile{two.tex}\\import{parts/}{three}",
        "parts/one.tex": "\\input four\n",
        "parts/three.tex": "",
        "two.tex": "",
        "four.tex": "",
        "parts/five.tex": "\\input{data}",
        "data.tex": "",
        "old.tex": "",
        "notes.md": "\\input{notes}",
        "data.csv": "",
        ".git/x.tex": "",
    }.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "link.tex").symlink_to(tmp_path / "old.tex")
    found = [str(path.relative_to(tmp_path)) for path in texts_in(tmp_path)]
    assert found == ["data.tex", "main.tex", "notes.md", "old.tex", "parts/five.tex"]


def test_each_text_of_a_folder_is_shown_when_it_is_judged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    papers(tmp_path)
    (tmp_path / "prose.md").write_text("No formula.")
    told = run("check", str(tmp_path), "--no-motions", "--no-proposals")
    assert told.exit_code == 1 and "prose" not in told.output and "part.tex" not in told.output
    assert "two.tex: 1 error" in told.output and "three.md: 1 warning" in told.output
    shown: list[str] = []

    def broken(judged, *_: object, **__: object) -> None:
        shown.append(judged.paper.paths[-1].name)
        raise KeyboardInterrupt

    monkeypatch.setattr("workbench.app.commands.check.print_for_people", broken)
    assert run("check", str(tmp_path), "--no-motions").exit_code == 130 and shown == ["three.md"]


def test_a_folder_without_a_text_is_said(tmp_path: Path) -> None:
    told = run("check", str(tmp_path))
    assert told.exit_code == 2 and "holds no text; expected" in told.output


def test_prose_on_standard_input_is_said() -> None:
    told = CliRunner().invoke(main, ["check", "-"], input="No formula.")
    assert told.exit_code == 2 and "no displayed equation in it" in told.output
