"""`workbench help`: a page of the manual, the meaning of a code, or a search."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from workbench.app.commands.options import Unusable
from workbench.core.codes.input_codes import InputCode

if TYPE_CHECKING:
    from collections.abc import Sequence

    from workbench.guide.pages import Page


def _topics(ctx: click.Context, _parameter: click.Parameter, begun: str) -> list[str]:
    """Returns the topics with this prefix, for the shell's completion."""
    from workbench.guide.generated import manual

    root = ctx.find_root().command
    assert isinstance(root, click.Group)
    return [page.topic for page in manual(root) if page.topic.startswith(begun)]


@click.command("help")
@click.argument("topic", nargs=-1, shell_complete=_topics)
@click.option("--search", "searched", is_flag=True, help="List the pages that contain all words of TOPIC.")
@click.option(
    "--site",
    type=click.Path(path_type=Path, file_okay=False),
    metavar="FOLDER",
    help="Write the source of the manual's site, for sphinx-build (extra docs).",
)
@click.option(
    "--notebooks",
    type=click.Path(path_type=Path, file_okay=False, exists=True),
    metavar="FOLDER",
    help="With --site: the notebooks to show.",
)
@click.pass_context
def help_command(
    ctx: click.Context, topic: Sequence[str], searched: bool, site: Path | None, notebooks: Path | None
) -> None:
    """Show a page of the manual. TOPIC is a page, a command, or a code such as WB-UNKNOWN-SYMBOL; without it
    the contents are shown. In the pager, / searches and q leaves."""
    from workbench.guide.generated import manual
    from workbench.guide.pages import contents_text

    root = ctx.find_root().command
    assert isinstance(root, click.Group)
    pages = manual(root)
    if site is not None:
        from workbench.guide.docs_source import write_source

        written = write_source(site, root, notebooks)
        click.echo(f"{site}: {len(written)} pages; now: sphinx-build -W {site} {site / '_build'}")
    elif not topic:
        click.echo_via_pager(contents_text(pages))
    elif searched:
        _print_found(topic, pages)
    else:
        click.echo_via_pager(_text(" ".join(topic), pages, root, ctx))


def _text(topic: str, pages: Sequence[Page], root: click.Group, ctx: click.Context) -> str:
    from workbench.core.close_names import did_you_mean
    from workbench.guide.message_page import code_text, known_codes
    from workbench.guide.pages import find_page

    if (page := find_page(topic, pages)) is not None:
        return page.text
    if (text := code_text(topic)) is not None:
        return text
    if (command := root.get_command(ctx, topic)) is not None:
        return command.get_help(click.Context(command, ctx.find_root(), topic)) + "\n"
    known = known_codes() if topic.upper().startswith("WB-") else [page.topic for page in pages]
    hint = did_you_mean(topic, known) or f"`workbench help --search {topic}` looks into all pages."
    raise Unusable(InputCode.NO_PAGE(topic=repr(topic), hint=hint))


def _print_found(words: Sequence[str], pages: Sequence[Page]) -> None:
    from workbench.guide.pages import search

    found = search(words, pages)
    for page, line in found:
        click.echo(f"{page.topic}: {page.title}\n    {line[:150]}")
    if not found:
        click.echo(f"no page contains {' '.join(words)!r}", err=True)
    sys.exit(0 if found else 1)
