"""Messages end with their code, and the code leads to its page."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from workbench import check
from workbench.app.commands.commands import main
from workbench.core.code_labels import coded, label, suffix, telling_code
from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.codes.input_codes import InputCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.reasons import Code, Reason

SAME = VerdictCode.SAME_TERM()


def test_message_ends_with_its_code() -> None:
    assert suffix(SAME) == " [WB-SAME-TERM]" and coded(SAME) == f"{SAME} [WB-SAME-TERM]"


def test_plain_text_and_no_reason_have_no_code() -> None:
    assert (suffix("plain"), coded("plain"), suffix(None), coded(None)) == ("", "plain", "", None)


def test_reason_around_one_reason_has_the_code_of_that_one() -> None:
    outer = Reason(VerdictCode.AT_ONE_INSTANT, {"why": SAME})
    assert telling_code(outer) is VerdictCode.SAME_TERM


def test_show_try_and_notebook_show_the_code() -> None:
    tried = CliRunner().invoke(main, ["try", "a = a", "-s", "a=vector"]).output
    checked = check("a = a", symbols={"a": "vector"})
    mark = f"[{label(VerdictCode.SAME_TERM)}]"
    assert mark in tried and mark in str(checked)
    assert "WB-SAME-TERM" in checked._repr_markdown_().replace("\\", "")


def test_code_of_a_message_leads_to_its_page() -> None:
    shown = CliRunner().invoke(main, ["help", label(VerdictCode.SAME_TERM)]).output
    assert "What to do:" in shown


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("chek", InputCode.COMMAND_LINE),
        ("check --formt json x.md", InputCode.COMMAND_LINE),
        ("try a=a -s a", InputCode.COMMAND_LINE),
        ("motion nosuch.urdf --body hand", InputCode.COMMAND_LINE),
        ("check nosuch.tex", InputCode.FILE_NOT_FOUND),
        ("show nosuch", InputCode.NO_CLAIM_SELECTED),
        ("help WB-NOSUCH", InputCode.NO_PAGE),
        ("try a=a -s a=vectr", DeclarationCode.UNKNOWN_KIND),
        ("check plain.md", InputCode.NO_DISPLAY),
        ("check toml.toml", InputCode.NOT_TOML),
        ("draft plain.md", InputCode.NO_DISPLAY),
    ],
)
def test_error_of_a_command_ends_with_its_code(
    line: str, code: Code, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("plain.md").write_text("no formula\n", encoding="utf-8")
    Path("toml.toml").write_text("title = \n", encoding="utf-8")
    done = CliRunner().invoke(main, line.split())
    (told,) = [each for each in done.output.splitlines() if each.startswith("Error: ")]
    assert done.exit_code == 2 and told.endswith(f" [{label(code)}]")
