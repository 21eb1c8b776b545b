"""The pages of the manual that are made from tables."""

from __future__ import annotations

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
        Page("command-line", "Reference", "reference", lambda: command_page(command_line)),
        Page("model-keys", "Reference", "reference", key_page),
        Page("spellings", "Reference", "reference", spelling_page),
        Page("api", "Reference", "reference", api_page),
        Page("messages", "Reference", "reference", message_page),
    ]
    return all_pages(made)
