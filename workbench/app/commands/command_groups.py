"""The click group of all commands: lists them from the table, and imports a command at its first use."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from typing import Any, NoReturn

import click

from workbench.app.commands.command_table import COMMANDS, Entry


class CommandGroups(click.Group):
    """A group whose commands are those of the table."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [entry.name for entry in COMMANDS if not entry.hidden]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        for entry in COMMANDS:
            if entry.name == cmd_name:
                return _loaded(entry)
        return None

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        unknown = self.get_command(ctx, args[0]) is None and not args[0].startswith("-")
        if unknown and not ctx.resilient_parsing:  # completion of a word that is no command offers nothing
            _refuse(ctx, args[0], self.list_commands(ctx))
        return super().resolve_command(ctx, args)

    def make_context(self, *args: Any, **extra: Any) -> click.Context:
        with _coded():
            return super().make_context(*args, **extra)

    def invoke(self, ctx: click.Context) -> Any:
        with _coded():
            return super().invoke(ctx)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        shown = [entry for entry in COMMANDS if not entry.hidden]
        for group in dict.fromkeys(entry.group for entry in shown):
            with formatter.section(group):
                formatter.write_dl([(each.name, each.summary) for each in shown if each.group == group])


@contextmanager
def _coded() -> Iterator[None]:
    """Lets the message of an error of usage end with its code."""
    try:
        yield
    except click.UsageError as error:
        from workbench.app.commands.options import coded_message

        error.format_message = partial(coded_message, error.format_message())  # type: ignore[method-assign]
        raise


def _loaded(entry: Entry) -> click.Command:
    """Returns the command, with the examples of its entry at the end of its help text."""
    module, _, name = entry.target.partition(":")
    command: click.Command = getattr(import_module(module), name)
    command.short_help = entry.summary
    lines = "\n".join(f"  {example}" for example in entry.examples)
    word = "Example" if len(entry.examples) == 1 else "Examples"
    command.epilog = f"\b\n{word}:\n{lines}"
    return command


def _refuse(ctx: click.Context, name: str, known: Sequence[str]) -> NoReturn:
    from workbench.core.close_names import did_you_mean

    hint = did_you_mean(name, known) or "`workbench --help` lists the commands."
    raise click.UsageError(f"no command {name!r}. {hint}", ctx)
