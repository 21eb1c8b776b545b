"""The server of the page in a thread of the test, and requests to it as a browser makes them."""

from __future__ import annotations

import json
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

from workbench.app.servers.page.page_app import Page, PageServer
from workbench.app.servers.page.page_file import PageTexts


class Served:
    """A page that is served."""

    def __init__(self, page: Page, port: int) -> None:
        self.page, self.port = page, port
        self.address = f"http://127.0.0.1:{port}/#token={page.token}"

    def request(
        self, method: str, path: str, body: Any = None, **headers: str
    ) -> tuple[int, dict[str, str], bytes]:
        """Status, headers and body of an answer; headers: with _ for -."""
        connection = HTTPConnection("127.0.0.1", self.port, timeout=60)
        raw = body if isinstance(body, bytes) else None if body is None else json.dumps(body).encode()
        own = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.request(method, path, raw, own)
        answer = connection.getresponse()
        try:
            return answer.status, {name.lower(): value for name, value in answer.getheaders()}, answer.read()
        finally:
            connection.close()

    def call(self, api: str, /, **data: Any) -> tuple[int, dict[str, Any]]:
        """Status and JSON of a call of the page, with its token."""
        data = {"tab": "t", "name": "paper.tex", **data}
        status, _, body = self.request("POST", f"/api/{api}", data, X_Workbench_Token=self.page.token)
        return status, json.loads(body)


@contextmanager
def served(path: Path | None = None) -> Iterator[Served]:
    """Within it the page is served at a free port."""
    listener = socket.socket()
    listener.bind(("127.0.0.1", 0))
    port = listener.getsockname()[1]
    page = Page(port, PageTexts(path) if path else None)
    server = PageServer(page)
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    end = time.monotonic() + 30
    while not server.started and time.monotonic() < end:
        time.sleep(0.01)
    try:
        yield Served(page, port)
    finally:
        server.should_exit = True
        thread.join(30)
        page.close()
        listener.close()
