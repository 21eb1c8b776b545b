"""`workbench lsp` in Emacs and Neovim without a screen, with the configurations of the guide."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pygls")

#: The second display is false; the first one defines c.
TEXT = """%! workbench: symbols.'a' = { kind = "vector" }
%! workbench: symbols.'b' = { kind = "vector" }
%! workbench: symbols.'c' = { kind = "vector" }
\\[ c = a \\times b \\]
\\[ a \\times b = b \\times a \\]
\\[ c \\cdot a = 0 \\]
"""
EMACS = r"""
(require 'json)
(find-file "p.tex")
(run-hooks 'post-command-hook)
(defun until (holds)
  (let ((end (+ (float-time) 100)))
    (while (and (not (funcall holds)) (< (float-time) end)) (accept-process-output nil 0.1))))
(defun asked (method &optional more)
  (jsonrpc-request (eglot-current-server) method (append (eglot--TextDocumentPositionParams) more)))
(defun faults ()
  (mapcar (lambda (each) (cons (flymake-diagnostic-beg each) (flymake-diagnostic-text each)))
          (seq-filter (lambda (each) (eq (flymake-diagnostic-type each) 'eglot-error)) (flymake-diagnostics))))
(until (lambda () (and (eglot-current-server) (ignore-errors (eglot--managed-buffers (eglot-current-server))))))
(flymake-mode 1)
(flymake-start)
(defun fixes ()
  (goto-char (or (caar (faults)) (point-min)))
  (seq-filter (lambda (each) (plist-get each :edit)) (eglot-code-actions (point) (1+ (point)))))
(until #'faults)
(setq before (mapcar #'cdr (faults)))
(until #'fixes)
(setq fix (car (fixes)))
(setq hover (plist-get (plist-get (asked :textDocument/hover) :contents) :value))
(goto-char (point-min))
(search-forward "c \\cdot")
(goto-char (match-beginning 0))
(setq places (mapcar (lambda (each) (plist-get (plist-get (plist-get each :range) :start) :line))
                     (asked :textDocument/definition)))
(eglot--apply-workspace-edit (plist-get fix :edit))
(eglot--signal-textDocument/didChange)
(until (lambda () (null (faults))))
(princ (concat "TOLD " (json-encode (list (cons "before" before) (cons "hover" hover) (cons "places" places)
  (cons "title" (plist-get fix :title)) (cons "after" (length (faults))) (cons "text" (buffer-string))))))
"""
NEOVIM = r"""
local function faults()
  return vim.diagnostic.get(0, { severity = vim.diagnostic.severity.ERROR })
end
local function asked(method, more)
  local params = vim.tbl_extend("force", vim.lsp.util.make_position_params(0, "utf-16"), more or {})
  for _, answer in pairs(vim.lsp.buf_request_sync(0, method, params, 60000) or {}) do
    return answer.result
  end
end
local function fixes()
  vim.api.nvim_win_set_cursor(0, { faults()[1].lnum + 1, faults()[1].col })
  local diagnostics = { faults()[1].user_data.lsp }
  local lsp = diagnostics[1]
  lsp = lsp.range and lsp or { range = vim.lsp.util.make_range_params(0, "utf-16").range, message = "", data = lsp.data }
  local found = asked("textDocument/codeAction", { range = lsp.range, context = { diagnostics = { lsp } } })
  return vim.tbl_filter(function(each) return each.edit end, found or {})
end
vim.cmd("edit p.tex")
local told = {}
vim.wait(100000, function() return #faults() > 0 end)
told.before = vim.tbl_map(function(each) return each.message end, faults())
vim.wait(60000, function() return #fixes() > 0 end, 500)
local fix = fixes()[1]
told.title = fix.title
told.hover = asked("textDocument/hover").contents.value
vim.api.nvim_win_set_cursor(0, { 6, 3 })
told.places = vim.tbl_map(function(each) return each.range.start.line end, asked("textDocument/definition"))
vim.lsp.util.apply_workspace_edit(fix.edit, "utf-16")
vim.wait(60000, function() return #faults() == 0 end)
told.after = #faults()
told.text = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), "\n") .. "\n"
io.stdout:write("TOLD " .. vim.fn.json_encode(told) .. "\n")
vim.cmd("qall!")
"""


def configurations(language: str) -> list[str]:
    """The configurations in a language that the guide's page on editors shows."""
    page = files("workbench.guide").joinpath("howto/editor.md").read_text("utf-8")
    return re.findall(rf"```{language}\n(.*?)```", page, re.DOTALL)


def run(folder: Path, *command: str) -> dict[str, Any]:
    """What the script in an editor tells. The command `workbench` is that of this interpreter."""
    (folder / "p.tex").write_text(TEXT)
    program = folder / "workbench"
    program.write_text(
        f"#!{sys.executable}\nimport sys\nfrom workbench.app.commands.commands import main\nmain(sys.argv[1:])\n"
    )
    program.chmod(0o755)
    variables = {"PATH": f"{folder}{os.pathsep}{os.environ['PATH']}", "HOME": str(folder)}
    variables |= {"WORKBENCH_CACHE": str(folder / "cache"), "XDG_CONFIG_HOME": str(folder)}
    done = subprocess.run(
        command, cwd=folder, env=os.environ | variables, capture_output=True, text=True, timeout=300
    )
    lines = [line for line in done.stdout.splitlines() if line.startswith("TOLD ")]
    assert lines, done.stdout + done.stderr
    told: dict[str, Any] = json.loads(lines[-1].removeprefix("TOLD "))
    return told


def assert_told(told: dict[str, Any]) -> None:
    assert len(told["before"]) == 1 and "refuted; with a = " in told["before"][0]
    assert "**refuted**" in told["hover"] and "read as `a × b = b × a`" in told["hover"]
    assert told["places"] == [3], "the display that defines c"
    assert told["title"] == "Change the sign of b × a"
    assert told["after"] == 0 and "= -b \\times a" in told["text"]


def test_emacs_shows_verdicts_and_corrects(tmp_path: Path) -> None:
    emacs = shutil.which("emacs")
    probe = ["--batch", "--eval", "(progn (package-initialize) (require 'eglot))"]
    if emacs is None or subprocess.run([emacs, *probe], capture_output=True).returncode:
        pytest.skip("Emacs with eglot is not installed")
    (tmp_path / "config.el").write_text("\n".join(configurations("elisp")))
    (tmp_path / "script.el").write_text(EMACS)
    load = ["--eval", "(progn (package-initialize) (require 'eglot))", "-l", "config.el", "-l", "script.el"]
    assert_told(run(tmp_path, emacs, "--batch", "--no-init-file", *load))


def test_neovim_shows_verdicts_and_corrects(tmp_path: Path) -> None:
    neovim = shutil.which("nvim")
    if neovim is None:
        pytest.skip("Neovim is not installed")
    newest, older, start = configurations("lua")
    said = subprocess.run([neovim, "--version"], capture_output=True, text=True, check=True).stdout
    number = tuple(map(int, re.findall(r"\d+", said)[:2]))
    (tmp_path / "config.lua").write_text(newest if number >= (0, 11) else start + older)
    (tmp_path / "script.lua").write_text(NEOVIM)
    assert_told(run(tmp_path, neovim, "--headless", "-u", "config.lua", "-c", "luafile script.lua"))
