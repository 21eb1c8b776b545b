"""A signal that stops `workbench serve` during a request: one answer to the browser, no complaint, nothing left."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("uvicorn")

#: A text that takes longer to judge than a server takes to stop.
TEXT = "\n".join(
    rf"\[ \mathbf{{a}} \times (\mathbf{{b}} \times \mathbf{{c}}_{{{n}}}) = {n} \mathbf{{b}} \]"
    for n in range(300)
)


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_a_stop_during_a_request_is_quiet(name: str, tmp_path: Path) -> None:
    code = "from workbench.app.commands.commands import main; main()"
    folders = {"TMPDIR": str(tmp_path / "tmp"), "WORKBENCH_CACHE": str(tmp_path / "cache")}
    (tmp_path / "tmp").mkdir()
    with subprocess.Popen(
        [sys.executable, "-uc", code, "serve"],
        env=os.environ | folders,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        found = re.search(r"http://127\.0\.0\.1:(\d+)/#token=(\S+)", process.stdout.readline())
        assert found

        def call(api: str, **data: Any) -> tuple[int, dict[str, Any]]:
            connection = HTTPConnection("127.0.0.1", int(found[1]), timeout=60)
            body = json.dumps({"tab": "t", "number": 1, **data})
            connection.request("POST", f"/api/{api}", body, {"X-Workbench-Token": found[2]})
            answer = connection.getresponse()
            return answer.status, json.loads(answer.read())

        with ThreadPoolExecutor(1) as pool:
            checked = pool.submit(call, "check", name="p.tex", text=TEXT)
            end = time.monotonic() + 60
            while not call("progress")[1]["judged"] and time.monotonic() < end:
                time.sleep(0.05)
            process.send_signal(getattr(signal, name))
            answer = checked.result(60)
        _, told = process.communicate(timeout=60)
    assert answer == (503, {"error": "the server is stopped"})
    assert told.strip() in ("", "interrupted")
    assert not list((tmp_path / "tmp").glob("workbench-*"))
