"""The reference of the command line, made from click's commands."""

from __future__ import annotations

import re

import click

_WIDTH = 100


def command_page(group: click.Group) -> str:
    """Returns the help text of each command of the group, in its order, as one Markdown page."""
    context = click.Context(group, info_name="workbench", max_content_width=_WIDTH, terminal_width=_WIDTH)
    parts = [
        "# Command line",
        "Each command with its options, as `workbench COMMAND --help` prints it.",
        "Exit status of all commands: 0 as expected, 1 something is wrong, 2 the input cannot be used,"
        " 3 a defect of the workbench, 130 interrupted.",
    ]
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        if command is not None:
            inner = click.Context(command, context, name, max_content_width=_WIDTH, terminal_width=_WIDTH)
            help_text = re.sub(r"[ \t]+$", "", command.get_help(inner), flags=re.MULTILINE)
            parts.append(f"## {name}\n\n```text\n{help_text}\n```")
    return "\n\n".join(parts) + "\n"
