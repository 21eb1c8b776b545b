"""The server of the page: judges the text in a browser, for one person on one machine."""

from __future__ import annotations

import asyncio
import json
import secrets
import tempfile
from collections.abc import Awaitable, Callable, Coroutine
from dataclasses import dataclass
from hmac import compare_digest
from importlib.resources import files
from pathlib import Path
from socket import socket
from typing import Any

from starlette.applications import Starlette
from starlette.requests import ClientDisconnect, Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route
from uvicorn import Config, Server

from workbench.app.pipeline.judged_files import Judged
from workbench.app.servers.desk import Desk, Superseded, Turn
from workbench.app.servers.page.page_file import MOST_BYTES, Changed, PageFile, PageTexts
from workbench.app.servers.page.page_view import fault_view, page_view
from workbench.papers import PaperError
from workbench.papers.drafting.questions_to_author import Answer
from workbench.report import ReportError
from workbench.source.documents import SUFFIXES

#: Seconds for one request, after which it is cancelled with a message.
SECONDS = 120.0
#: The number of tabs whose last verdicts are kept.
_MOST_TABS = 16
#: How often a character may be written in JSON as six, and some for the rest.
_MOST_BODY = 6 * MOST_BYTES + 100_000
_TYPES = {".js": "text/javascript", ".css": "text/css", ".LICENSE": "text/plain"}
_ANSWERED = frozenset({"symbols", "definitions", "points"})
_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-store",
}


class PageServer(Server):
    """The server of a page. A signal ends the running requests first, so that it stops quietly."""

    def __init__(self, page: Page) -> None:
        super().__init__(Config(page.app, log_level="error", access_log=False, timeout_graceful_shutdown=1))
        self._page = page

    async def shutdown(self, sockets: list[socket] | None = None) -> None:
        self._page.close()
        await super().shutdown(sockets)


class Refused(Exception):
    """A request that is rejected. status: the HTTP status."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


@dataclass
class Tab:
    """The last verdicts of one browser tab, and its running turn.

    Attributes:
        number: The browser's number of the turn.
        before: The last verdicts of an earlier turn on the same path.
    """

    turn: Turn
    number: int = 0
    judged: Judged | None = None
    before: Judged | None = None
    answers: tuple[Answer, ...] = ()
    text: str = ""
    path: Path = Path()


class Page:
    """The page of one start of the server.

    Attributes:
        token: Required in each request.
        texts: The texts on disk, if the page was started with some.
    """

    def __init__(self, port: int, texts: PageTexts | None = None, token: str | None = None) -> None:
        self.token, self.texts = token or secrets.token_urlsafe(24), texts
        self._hosts = {f"127.0.0.1:{port}", f"localhost:{port}"}
        self._empty = tempfile.TemporaryDirectory(prefix="workbench-")
        self._desk = Desk()
        self._desk.prepare()
        self._tabs: dict[str, Tab] = {}
        self._running: set[asyncio.Task[dict[str, Any]]] = set()
        self._is_closed = False
        calls = {
            "text": self._text,
            "check": self._check,
            "corrections": self._corrections,
            "progress": self._progress,
            "save": self._save,
            "model": self._model,
            "report": self._report,
        }
        routes = [Route("/", self._index), Route("/static/{name}", self._static)]
        routes += [Route(f"/api/{name}", self._call(call), methods=["POST"]) for name, call in calls.items()]
        self.app = Starlette(routes=routes)

    def close(self) -> None:
        """Ends the running requests, and refuses later ones."""
        self._is_closed = True
        for task in self._running:
            task.cancel()
        self._desk.close()
        self._empty.cleanup()

    def _guard(self, request: Request) -> None:
        """Raises Refused for a request of another page, or under another name of this machine."""
        if request.headers.get("host", "") not in self._hosts:
            raise Refused(403, "expected a request to 127.0.0.1")
        origin = request.headers.get("origin")
        if origin is not None and origin not in {f"http://{host}" for host in self._hosts}:
            raise Refused(403, "expected a request of this page")

    async def _index(self, request: Request) -> Response:
        try:
            self._guard(request)
        except Refused as error:
            return Response(str(error), error.status, headers=_HEADERS)
        nonce = secrets.token_urlsafe(16)
        page = files("workbench.app.servers.page").joinpath("static/page.html").read_text("utf-8")
        policy = (
            f"default-src 'none'; script-src 'self'; style-src 'self' 'nonce-{nonce}'; connect-src 'self';"
            " img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
        )
        headers = {**_HEADERS, "Content-Security-Policy": policy}
        return HTMLResponse(page.replace("{{ nonce }}", nonce), headers=headers)

    async def _static(self, request: Request) -> Response:
        try:
            self._guard(request)
        except Refused as error:
            return Response(str(error), error.status, headers=_HEADERS)
        own = {each.name: each for each in files("workbench.app.servers.page").joinpath("static").iterdir()}
        found = own.get(request.path_params["name"])
        if found is None or found.name == "page.html":
            return Response("no such file", 404, headers=_HEADERS)
        return Response(found.read_bytes(), media_type=_TYPES[Path(found.name).suffix], headers=_HEADERS)

    def _call(
        self, call: Callable[[dict[str, Any]], Coroutine[Any, Any, dict[str, Any]]]
    ) -> Callable[[Request], Awaitable[Response]]:
        """Returns a handler for a call of the page: JSON in, JSON out, errors as a status and a message."""

        async def answered(request: Request) -> Response:
            try:
                self._guard(request)
                given = request.headers.get("x-workbench-token", "")
                if not compare_digest(given.encode(), self.token.encode()):
                    raise Refused(
                        401, "this page is of another start of the server: open the printed address"
                    )
                task = asyncio.create_task(call(await _body(request)))
                self._running.add(task)
                task.add_done_callback(self._running.discard)
                return JSONResponse(await asyncio.wait_for(task, SECONDS), headers=_HEADERS)
            except asyncio.CancelledError:
                if not self._is_closed:
                    raise
                status, message = 503, "the server is stopped"
            except Refused as error:
                status, message = error.status, str(error)
            except Superseded:
                status, message = 409, "superseded"
            except Changed as error:
                status, message = 412, str(error)
            except TimeoutError:
                status, message = 503, f"not judged within {SECONDS:.0f} seconds; given up"
            except (PaperError, ReportError, OSError) as error:
                status, message = 422, str(error)
            except ClientDisconnect:
                return Response(status_code=499)
            return JSONResponse({"error": message}, status, headers=_HEADERS)

        return answered

    async def _text(self, data: dict[str, Any]) -> dict[str, Any]:
        """Returns the names of the texts; of one, its content if it differs from the page's, and a stamp of
        its model."""
        if self.texts is None:
            return {"name": None, "names": []}
        names = self.texts.names
        file = self._file({**data, "name": data.get("name") or names[0]})
        text, stamp = file.read()
        model = file.model.name if file.model.exists() else None
        told: dict[str, Any] = {"name": file.name, "names": names, "stamp": stamp, "model": model}
        told["model_stamp"] = file.model_stamp
        return told if data.get("stamp") == stamp else {**told, "text": text}

    async def _check(self, data: dict[str, Any]) -> dict[str, Any]:
        """Returns the verdicts on the text of a tab."""
        path, folder = self._place(data)
        text, answers = _text_of(data), _answers_of(data)
        name = _string(data, "tab")
        tab = Tab(self._desk.turn(name, folder), _number(data), answers=answers, text=text, path=path)
        last = self._tabs.pop(name, None)
        if last is not None and last.path == path:
            tab.before = last.judged or last.before
        self._tabs[name] = tab
        while len(self._tabs) > _MOST_TABS:
            del self._tabs[next(iter(self._tabs))]
        try:
            tab.judged = await tab.turn.verdicts(path, {path: text}, answers, tab.before)
        except PaperError as error:
            return fault_view(error.faults, path)
        return page_view(tab.judged, path, text, answers)

    async def _corrections(self, data: dict[str, Any]) -> dict[str, Any]:
        """Returns the verdicts of the last check with proved corrections."""
        tab = self._judged_tab(data)
        assert tab.judged is not None
        tab.judged = await tab.turn.corrections(tab.judged)
        return page_view(tab.judged, tab.path, tab.text, tab.answers)

    async def _progress(self, data: dict[str, Any]) -> dict[str, Any]:
        """Returns how many claims are judged; after a change, also the first verdicts, if there are more than
        the page was told."""
        tab = self._tabs.get(_string(data, "tab"))
        if tab is None or tab.number != _number(data):
            return {"judged": 0}
        turn = tab.turn
        told = {"judged": turn.judged, "news": turn.news}
        if not turn.has_standing or turn.news == data.get("told") or (first := turn.at_once()) is None:
            return told
        return {**told, "view": page_view(first, tab.path, tab.text, tab.answers)}

    async def _save(self, data: dict[str, Any]) -> dict[str, Any]:
        """Writes the text into its file."""
        return {"stamp": self._file(data).save(_text_of(data), _string(data, "stamp"))}

    async def _model(self, data: dict[str, Any]) -> dict[str, Any]:
        """Returns the drafted model with the answers, and writes it next to the file if requested."""
        from workbench.papers.drafting.model_file import model_text

        tab = self._judged_tab(data)
        assert tab.judged is not None
        if tab.judged.draft is None:
            raise Refused(400, "this text has a model already")
        text = model_text(tab.judged.draft.ingested, tab.path.with_suffix(".toml"))
        name = tab.path.with_suffix(".toml").name
        if data.get("write"):
            file = self._file(data)
            if tab.path != file.path:
                raise Refused(409, "another text is judged in this tab; change the text, and it is judged")
            file.save_model(text)
        return {"name": name, "model": text}

    async def _report(self, data: dict[str, Any]) -> dict[str, Any]:
        """Returns the report of the last check as one page."""
        from workbench.report.render import page_of

        tab = self._judged_tab(data)
        assert tab.judged is not None
        html = await asyncio.to_thread(page_of, tab.judged.paper, tab.judged.results)
        return {"name": f"{tab.path.stem}-report.html", "html": html}

    def _judged_tab(self, data: dict[str, Any]) -> Tab:
        tab = self._tabs.get(_string(data, "tab"))
        if tab is None or tab.judged is None:
            raise Refused(409, "nothing is judged in this tab; change the text, and it is")
        return tab

    def _file(self, data: dict[str, Any]) -> PageFile:
        """Returns the text on disk that a request names."""
        if self.texts is None:
            raise Refused(400, "there is no file; start `workbench serve FILE`")
        return self.texts.open(_string(data, "name", 4096))

    def _place(self, data: dict[str, Any]) -> tuple[Path, Path]:
        """Returns the path of a text, real or assumed, and the folder outside of which no file is read."""
        if data.get("document") == "file":
            path = self._file(data).path
            assert self.texts is not None, "it has the file"
            return path, self.texts.folder
        suffix = _string({"suffix": ".tex", **data}, "suffix")
        if suffix not in SUFFIXES:
            raise Refused(400, f"suffix: expected one of {', '.join(sorted(SUFFIXES))}")
        folder = Path(self._empty.name).resolve()
        return folder / f"text{suffix}", folder


async def _body(request: Request) -> dict[str, Any]:
    """Returns the JSON object of a request. Raises Refused."""
    body = bytearray()
    async for chunk in request.stream():
        body += chunk
        if len(body) > _MOST_BODY:
            raise Refused(413, f"expected a text of at most {MOST_BYTES:,} bytes")
    try:
        data = json.loads(body)
    except (ValueError, RecursionError):
        data = None
    if not isinstance(data, dict):
        raise Refused(400, "expected a JSON object")
    return data


def _string(data: dict[str, Any], key: str, most: int = 200) -> str:
    value = data.get(key)
    if not isinstance(value, str) or len(value) > most:
        raise Refused(400, f"{key}: expected a string of at most {most:,} characters")
    return value


def _number(data: dict[str, Any]) -> int:
    value = data.get("number", 0)
    if not isinstance(value, int):
        raise Refused(400, "number: expected an integer")
    return value


def _text_of(data: dict[str, Any]) -> str:
    text = _string(data, "text", MOST_BYTES)
    try:
        size = len(text.encode("utf-8"))
    except UnicodeEncodeError:
        raise Refused(400, "text: expected Unicode characters, got half of one") from None
    if size > MOST_BYTES:
        raise Refused(413, f"expected a text of at most {MOST_BYTES:,} bytes, got {size:,}")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _answers_of(data: dict[str, Any]) -> tuple[Answer, ...]:
    """Returns the answers of the author. Raises Refused for an invalid entry of a model."""
    given = data.get("answers", [])
    if not isinstance(given, list) or len(given) > 500:
        raise Refused(400, "answers: expected a list of at most 500")
    made = []
    for each in given:
        if not isinstance(each, dict) or each.get("table") not in _ANSWERED:
            raise Refused(400, "answers: expected entries of symbols, definitions or points")
        answer = Answer(each["table"], _string(each, "key"), _string(each, "value", 2000))
        if not answer.is_entry:
            raise Refused(400, f"answers: expected one entry of a model, got {answer.lines[1]!r}")
        made.append(answer)
    return tuple(made)
