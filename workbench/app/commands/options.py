"""Shared parts of the commands: options, JSON output, and messages for errors."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, Any

import click

from workbench.app.pipeline.verdict_memory import memory_of_verdicts
from workbench.core.code_labels import suffix
from workbench.core.codes.input_codes import InputCode
from workbench.core.reasons import Reason, reason_of

if TYPE_CHECKING:
    from workbench.papers import Paper

INTERRUPTED = 130


def coded_message(message: str) -> str:
    """Returns the message with its code at the end: its own, or that of an unusable command line."""
    reason = message if isinstance(message, Reason) else InputCode.COMMAND_LINE(what=message)
    return f"{message}{suffix(reason)}"


class Unusable(click.ClickException):
    """Unusable input: one message with its code on standard error, exit status 2."""

    exit_code = 2

    def format_message(self) -> str:
        return coded_message(self.message)


class UnusableFile(Unusable):
    """Files that cannot be used; the message has the code of each fault."""

    def format_message(self) -> str:
        return self.message


class Defect(click.ClickException):
    """The workbench contradicts itself: exit status 3."""

    exit_code = 3


def reports_faults(command: Callable[..., None]) -> Callable[..., None]:
    """Returns the command with errors of bad input turned into messages and exit status 2."""

    @wraps(command)
    def guarded(*arguments: Any, **options: Any) -> None:
        from workbench.core.verdict import EngineDisagreement
        from workbench.papers import PaperError
        from workbench.papers.selection import SelectError
        from workbench.report import ReportError

        try:
            command(*arguments, **options)
        except PaperError as error:
            from workbench.app.commands.carets import faults_text

            raise UnusableFile(faults_text(error.faults).removeprefix("Error: ")) from None
        except (SelectError, ReportError) as error:
            raise Unusable(reason_of(error, InputCode.COMMAND_LINE)) from None
        except (KeyboardInterrupt, ImportError) as error:
            if not _is_interruption(error):
                raise
            click.echo("interrupted", err=True)
            sys.exit(INTERRUPTED)
        except EngineDisagreement as error:
            raise Defect(f"the engines disagree, so no verdict is given: {error}") from error

    return guarded


def _is_interruption(error: BaseException | None) -> bool:
    """True if the error was caused by Ctrl-C; a library that is being imported may wrap it."""
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__cause__
    return error is not None


def _installed(_ctx: click.Context, _parameter: click.Parameter, begun: str) -> list[str]:
    """Returns the installed papers with this prefix, for the shell's completion."""
    from workbench.papers.installed_papers import installed_names

    return [name for name in installed_names() if name.startswith(begun)]


paper_option = click.option(
    "--paper",
    "paper_name",
    shell_complete=_installed,
    show_default="the installed paper chapter",
    metavar="FILE",
    help="A paper file, or the name of an installed paper.",
)
cache_option = click.option(
    "--cache/--no-cache",
    default=True,
    help="Take the verdicts of earlier runs on what has not changed since; kept under WORKBENCH_CACHE, or"
    " where the system keeps such files.",
)
json_flag = click.option("--json", "as_json", is_flag=True, help="Print JSON.")


def named_paper(name: str | None, cache: bool = True, meanwhile: Callable[[], None] = lambda: None) -> Paper:
    """Returns the paper of `paper_option`. meanwhile: called while other processes read it."""
    from workbench.papers import find_paper

    with memory_of_verdicts(cache) as memory:
        return find_paper(name, memory, meanwhile)


def json_text(data: Any) -> str:
    return json.dumps(data, ensure_ascii=False, indent=2) + "\n"


def print_json(data: Any) -> None:
    click.echo(json_text(data), nl=False)
