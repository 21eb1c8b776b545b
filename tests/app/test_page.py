"""The server behind `workbench serve`: verdicts for its own page only, and no file beyond the given folder."""

from __future__ import annotations

import json
import re
import shlex
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from urllib.request import urlopen

import pytest

pytest.importorskip("uvicorn")
from click.testing import CliRunner
from page_server import Served, served

from workbench.app.commands.commands import main
from workbench.app.servers import desk
from workbench.app.servers.desk import Superseded, Turn
from workbench.app.servers.page import page_app
from workbench.app.servers.page.page_view import Places

FALSE = r"\[ \mathbf{a} \times \mathbf{b} = \mathbf{b} \times \mathbf{a} \]" + "\n"
TRUE = FALSE.replace("= ", "= -")


@pytest.fixture(scope="module")
def scratch():
    with served() as page:
        yield page


@pytest.fixture
def on_disk(tmp_path: Path):
    (tmp_path / "folder").mkdir()
    path = tmp_path / "folder" / "paper.tex"
    path.write_text(FALSE)
    with served(path) as page:
        yield page, path


def grades(view: dict) -> list[str]:
    return [each["grade"] for each in view["displays"]]


def test_a_false_display_is_corrected_by_its_edits(scratch: Served) -> None:
    status, view = scratch.call("check", text="é𝒳 " + FALSE)
    assert status == 200 and grades(view) == ["warning"] and view["findings"][0]["level"] == "warning"
    assert "refuted" in view["findings"][0]["message"]
    status, view = scratch.call("corrections")
    (edit,) = view["displays"][0]["items"][0]["edits"]
    assert "<math" in view["displays"][0]["items"][0]["what"] and "&lt;" not in json.dumps(view["displays"])
    text = ("é𝒳 " + FALSE).encode("utf-16-le")
    start, end = (2 * place for place in edit["place"])
    corrected = (text[:start] + edit["new"].encode("utf-16-le") + text[end:]).decode("utf-16-le")
    assert corrected == "é𝒳 " + TRUE, "places count units of UTF-16"
    assert grades(scratch.call("check", text=corrected)[1]) == ["ok"]


def test_an_answer_judges_anew(scratch: Served) -> None:
    before = scratch.call("check", text=FALSE)[1]
    assert {each["label"]: each["kind"] for each in before["assumptions"]} == {
        r"\mathbf{a}": "vector",
        r"\mathbf{b}": "vector",
    }
    answers = [
        {"table": "symbols", "key": each["key"], "value": '"vector"'} for each in before["assumptions"]
    ]
    after = scratch.call("check", text=FALSE, answers=answers)[1]
    assert grades(after) == ["error"], "what the author says is declared"
    assert {each["basis"] for each in after["assumptions"]} == {"asked"}
    status, model = scratch.call("model")
    assert status == 200 and model["name"] == "text.toml" and "'\\mathbf{a}'" in model["model"]


def test_the_report_is_one_page(scratch: Served) -> None:
    scratch.call("check", text=FALSE)
    status, report = scratch.call("report")
    assert (
        status == 200
        and report["html"].lower().startswith("<!doctype html>")
        and "errata.json" not in report["html"]
    )


def test_another_page_gets_nothing(scratch: Served) -> None:
    token = scratch.page.token
    assert scratch.request("POST", "/api/text", {}, X_Workbench_Token="é")[0] == 401
    assert scratch.request("GET", "/", Host="evil.example")[0] == 403
    assert scratch.request("POST", "/api/text", {}, X_Workbench_Token=token, Host="evil.example")[0] == 403
    assert (
        scratch.request("POST", "/api/text", {}, X_Workbench_Token=token, Origin="http://evil.example")[0]
        == 403
    )
    assert scratch.request("POST", "/api/text", {})[0] == 401
    assert scratch.request("POST", "/api/text", {}, X_Workbench_Token="x" + token)[0] == 401
    assert scratch.request("GET", "/api/text", X_Workbench_Token=token)[0] == 405
    status, headers, body = scratch.request("GET", "/")
    assert status == 200 and "access-control-allow-origin" not in headers and token.encode() not in body
    assert "default-src 'none'" in headers["content-security-policy"]


@pytest.mark.parametrize(
    "name", ["../page_app.py", "..%2fpage_app.py", "page.html", "%2fetc%2fhostname", "none.js"]
)
def test_only_the_files_of_the_page_are_given(scratch: Served, name: str) -> None:
    assert scratch.request("GET", f"/static/{name}")[0] == 404


@pytest.mark.parametrize("name", ["page.js", "codemirror.js", "page.css", "codemirror.LICENSE"])
def test_the_files_of_the_page_are_given(scratch: Served, name: str) -> None:
    status, headers, _ = scratch.request("GET", f"/static/{name}")
    assert status == 200 and headers["content-type"].startswith("text/")


BAD = {
    "no JSON": (b"{", 400),
    "no object": (b"[]", 400),
    "a deep one": (b"[" * 100_000, 400),
    "half a character": (b'{"tab": "t", "text": "\\ud800"}', 400),
    "no text": (b'{"tab": "t"}', 400),
    "no tab": (b'{"text": ""}', 400),
    "no such table": (b'{"tab": "t", "text": "", "answers": [{"table": "source", "key": "a", "value": "1"}]}', 400),
    "two entries": (
        b'{"tab": "t", "text": "", "answers": [{"table": "symbols", "key": "a", "value": "1\\nb = 2"}]}', 400,
    ),
    "a kind that is a table": (
        b'{"tab": "t", "text": "", "answers": [{"table": "symbols", "key": "a", "value": "{k = 1}"}]}', 400,
    ),
    "a definition by a number": (
        b'{"tab": "t", "text": "", "answers": [{"table": "definitions", "key": "a", "value": "7"}]}', 400,
    ),
    "a key of two levels": (
        b'{"tab": "t", "text": "", "answers": [{"table": "symbols", "key": "a.b", "value": "\'x\'"}]}', 400,
    ),
    "a list for a suffix": (b'{"tab": "t", "text": "", "suffix": ["x"]}', 400),
    "another document": (b'{"tab": "t", "text": "", "document": "file"}', 400),
    "another suffix": (b'{"tab": "t", "text": "", "suffix": "/../x.tex"}', 400),
}  # fmt: skip


@pytest.mark.parametrize("body,status", BAD.values(), ids=BAD)
def test_a_bad_request_is_one_error(scratch: Served, body: bytes, status: int) -> None:
    got, _, told = scratch.request("POST", "/api/check", body, X_Workbench_Token=scratch.page.token)
    assert got == status and json.loads(told)["error"]


def test_a_text_that_is_too_large_is_refused(scratch: Served) -> None:
    assert scratch.call("check", text="x" * (page_app.MOST_BYTES + 1))[0] == 400
    assert scratch.call("check", text="é" * (page_app.MOST_BYTES - 1))[0] == 413
    token = scratch.page.token
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(page_app, "_MOST_BODY", 10)
        assert scratch.request("POST", "/api/check", b" " * 11, X_Workbench_Token=token)[0] == 413


def test_no_file_outside_of_the_folder_is_read(on_disk, tmp_path: Path) -> None:
    page, path = on_disk
    secret = tmp_path / "secret.tex"
    secret.write_text(r"\[ \mathbf{s} = \mathbf{s} + \mathbf{s} \]")
    (path.parent / "link.tex").symlink_to(secret)
    inputs = [str(secret), "../secret", "../secret.tex", "link", "/etc/hostname"]
    text = FALSE + "".join(f"\\input{{{each}}}\n" for each in inputs)
    for document in ("file", "scratch"):
        status, view = page.call("check", text=text, document=document)
        assert status == 200 and len(view["displays"]) == 1 and "mathbf{s}" not in json.dumps(view)
        assert len(view["faults"]) >= len(inputs) - 1
    (path.parent / "part.tex").write_text(TRUE)
    _, view = page.call("check", text=FALSE + r"\input{part}", document="file")
    assert grades(view) == ["warning", "ok"], "a part in the folder is read"
    assert [each["file"] for each in view["displays"]] == [None, "part.tex"]


def test_each_text_of_a_folder_can_be_opened(tmp_path: Path) -> None:
    folder = tmp_path / "book"
    (folder / "parts").mkdir(parents=True)
    (folder / "a.md").write_text(f"$$ {FALSE[3:-3]} $$\n")
    (folder / "parts" / "b.tex").write_text(r"\input{c}" + TRUE)
    (folder / "c.tex").write_text(TRUE)
    (tmp_path / "secret.tex").write_text(TRUE)
    (folder / "link.tex").symlink_to(tmp_path / "secret.tex")
    with served(folder) as page:
        told = page.call("text", name=None)[1]
        assert told["name"] == "a.md" and told["names"] == ["a.md", "c.tex", "parts/b.tex"]
        told = page.call("text", name="parts/b.tex")[1]
        assert told["text"] == r"\input{c}" + TRUE
        view = page.call("check", text=told["text"], document="file", name="parts/b.tex")[1]
        assert grades(view) == ["ok"] and "no file 'c'" in view["faults"][0]
        assert page.call("save", name="parts/b.tex", text=FALSE, stamp=told["stamp"])[0] == 200
        assert (folder / "parts" / "b.tex").read_text() == FALSE
        assert page.call("model", name="a.md", write=True)[0] == 409
        assert page.call("model", name="parts/b.tex", write=True)[0] == 200
        assert (folder / "parts" / "b.toml").exists()
        for name in ("link.tex", "../secret.tex", str(tmp_path / "secret.tex"), "c.tex/", "no.tex"):
            assert page.call("text", name=name)[0] == 422
            assert page.call("check", name=name, text=TRUE, document="file")[0] == 422
        (folder / "new.rst").write_text("none")
        assert "new.rst" in page.call("text", name="a.md")[1]["names"]


def test_a_text_that_became_a_link_is_not_opened(tmp_path: Path) -> None:
    folder = tmp_path / "book"
    folder.mkdir()
    (folder / "paper.tex").write_text(TRUE)
    (tmp_path / "secret.tex").write_text(TRUE)
    with served(folder) as page:
        told = page.call("text")[1]
        (folder / "paper.tex").unlink()
        (folder / "paper.tex").symlink_to(tmp_path / "secret.tex")
        for name, data in {"text": {}, "save": {"text": FALSE, "stamp": told["stamp"]}}.items():
            assert page.call(name, **data)[0] == 422
    assert (tmp_path / "secret.tex").read_text() == TRUE


def test_commands_in_a_text_are_not_executed(scratch: Served, tmp_path: Path) -> None:
    touched = tmp_path / "touched"
    text = rf"""\immediate\write18{{touch {touched}}}\openout5={touched}\directlua{{os.execute('touch {touched}')}}
\[ \text{{<img src=x onerror=alert(1)>}} = \mathbf{{<script>}} \]
\[ __import__('os').system('touch {touched}') = {{{{ 7*7 }}}} \]
\begin{{equation}}\label{{<b>x</b>}} a = a + 1 \end{{equation}}
"""
    status, view = scratch.call("check", text=text)
    assert status == 200 and not touched.exists()
    html = json.dumps(
        [[each["formulas"], each["items"], each["details"], each["remark"]] for each in view["displays"]]
    )
    assert "<img" not in html and "<script" not in html and "<b>" not in html


def test_the_file_is_saved_unless_it_changed(on_disk) -> None:
    page, path = on_disk
    _, told = page.call("text")
    assert told["text"] == FALSE and told["model"] is None
    assert "text" not in page.call("text", stamp=told["stamp"])[1]
    status, saved = page.call("save", text=TRUE, stamp=told["stamp"])
    assert status == 200 and path.read_text() == TRUE and list(path.parent.iterdir()) == [path]
    path.write_text("other")
    status, error = page.call("save", text=FALSE, stamp=saved["stamp"])
    assert status == 412 and "changed" in error["error"] and path.read_text() == "other"


def test_line_ends_and_mark_of_the_file_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "paper.tex"
    path.write_bytes(b"\xef\xbb\xbf" + FALSE.replace("\n", "\r\n").encode())
    with served(path) as page:
        _, told = page.call("text")
        assert told["text"] == FALSE
        assert page.call("save", text=TRUE, stamp=told["stamp"])[0] == 200
    assert path.read_bytes() == b"\xef\xbb\xbf" + TRUE.replace("\n", "\r\n").encode()


def test_the_model_is_written_once(on_disk) -> None:
    page, path = on_disk
    page.call("check", text=FALSE, document="file")
    assert page.call("model", write=True)[0] == 200 and path.with_suffix(".toml").exists()
    assert page.call("model", write=True)[0] == 412
    view = page.call("check", text=FALSE, document="file")[1]
    assert not view["drafted"] and not view["assumptions"]
    assert page.call("model")[0] == 400


def test_tabs_do_not_disturb_each_other(scratch: Served) -> None:
    scratch.call("check", tab="one", text=FALSE)
    scratch.call("check", tab="two", text=TRUE)
    assert grades(scratch.call("corrections", tab="one")[1]) == ["warning"]
    assert grades(scratch.call("corrections", tab="two")[1]) == ["ok"]
    assert scratch.call("corrections", tab="three")[0] == 409


def test_a_later_text_of_a_tab_ends_the_earlier(scratch: Served, monkeypatch: pytest.MonkeyPatch) -> None:
    began, go = threading.Event(), threading.Event()
    check = Turn._check

    def slow(turn: Turn) -> None:
        began.set()
        go.wait(30)
        check(turn)

    monkeypatch.setattr(Turn, "_check", slow)
    first: list[tuple[int, dict]] = []
    thread = threading.Thread(target=lambda: first.append(scratch.call("check", text=FALSE)))
    thread.start()
    assert began.wait(30)
    second: list[tuple[int, dict]] = []
    other = threading.Thread(target=lambda: second.append(scratch.call("check", text=TRUE)))
    other.start()
    while scratch.page._tabs["t"].text != TRUE:
        pass
    go.set()
    thread.join(60)
    other.join(60)
    assert first == [(409, {"error": "superseded"})] and grades(second[0][1]) == ["ok"]


def test_judgements_that_take_too_long_are_cancelled(
    scratch: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended = threading.Event()

    def slow(
        path: Path, buffers: object, motions: bool, answers: object, seen: Callable, folder: Path
    ) -> None:
        try:
            for _again in range(600):
                time.sleep(0.05)
                seen(None, None)
        except Superseded:
            ended.set()
            raise

    with monkeypatch.context() as patch:
        patch.setattr(page_app, "SECONDS", 0.3)
        patch.setattr(desk, "judged_file", slow)
        status, told = scratch.call("check", text=FALSE, tab="new")
        assert status == 503 and "given up" in told["error"] and ended.wait(10)
    assert grades(scratch.call("check", text=FALSE)[1]) == ["warning"], "the next is judged"


def test_a_text_that_cannot_be_judged_says_why(scratch: Served) -> None:
    status, view = scratch.call("check", text="no formula")
    assert status == 200 and view["displays"] == [] and "no displayed equation" in view["faults"][0]


@pytest.mark.parametrize(
    "text",
    ["no formula", "\\input{b} " + FALSE, "\\begin{equation} a = a \\] b", "\\def\\x{\\x} \\[ \\x = 1 \\]"],
)
def test_faults_of_a_pasted_text_name_no_folder(scratch: Served, text: str) -> None:
    faults = scratch.call("check", text=text)[1]["faults"]
    assert faults and not any("/" in each.replace("\\", "") for each in faults), faults


@pytest.mark.parametrize(
    "text,line,column,place",
    [("ab\ncd", 2, 1, 3), ("𝒳b\nc", 1, 2, 2), ("𝒳\nc", 2, 2, 4), ("a", 9, 9, 1), ("a", 0, 0, 0)],
)
def test_places_count_units_of_utf_16(text: str, line: int, column: int, place: int) -> None:
    assert Places(text).at(line, column) == place


GUIDE = files("workbench.guide").joinpath("howto/page.md").read_text("utf-8")
COMMANDS = re.findall(r"^workbench serve.*$", GUIDE, flags=re.M)


@pytest.mark.parametrize("command", COMMANDS)
def test_the_commands_of_the_guide_serve_until_interrupted(command: str, tmp_path: Path) -> None:
    (tmp_path / "paper.tex").write_text(re.search(r"```latex\n(.*?)```", GUIDE, re.S)[1])
    words = [word if word != "8000" else "0" for word in shlex.split(command)[1:]]
    code = "from workbench.app.commands.commands import main; main()"
    with subprocess.Popen(
        [sys.executable, "-uc", code, *words], cwd=tmp_path, stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            address = re.search(r"http://127\.0\.0\.1:\d+/#token=\S+", process.stdout.readline())[0]
            with urlopen(address) as answer:
                assert b"workbench" in answer.read()
        finally:
            process.send_signal(signal.SIGTERM)
        process.wait(30)


@pytest.mark.parametrize(
    "words,message",
    [
        (["missing.tex"], "no such file"),
        (["paper.pdf"], "expected a folder, or a text"),
        (["."], "holds no text"),
        (["paper.tex", "--port", "1"], "cannot be used"),
    ],
)
def test_an_unusable_text_or_port_is_one_error(
    words: list[str], message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    if words != ["."]:
        Path("paper.tex").write_text(FALSE)
    if "--port" in words:
        monkeypatch.setattr("socket.socket.bind", _refused)
    done = CliRunner().invoke(main, ["serve", *words])
    assert done.exit_code == 2 and message in done.output


def _refused(*_: object) -> None:
    raise PermissionError(13, "Permission denied")
