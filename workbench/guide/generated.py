"""The pages of the manual that are made from tables."""

from __future__ import annotations

from collections.abc import Callable

import click

from workbench.guide.api_page import api_page
from workbench.guide.command_page import command_page
from workbench.guide.key_page import key_page
from workbench.guide.message_page import message_page
from workbench.guide.pages import Page, all_pages
from workbench.guide.spelling_page import spelling_page


def manual(command_line: click.Group) -> list[Page]:
    """Returns all pages. command_line: the group whose commands the reference lists."""
    made = [
        _reference("command-line", "Command line", lambda: command_page(command_line)),
        _reference("model-keys", "Model keys", key_page),
        _reference("spellings", "Spellings", spelling_page),
        _reference("api", "Python API", api_page),
        _reference("messages", "Messages", message_page),
    ]
    return all_pages(made)


def _reference(topic: str, heading: str, read: Callable[[], str]) -> Page:
    return Page(topic, "Reference", "reference", read, heading)
