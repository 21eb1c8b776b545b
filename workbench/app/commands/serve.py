"""workbench serve: a page on this machine that judges a text as it is written."""

from __future__ import annotations

import socket
import webbrowser
from pathlib import Path

import click

from workbench.app.commands.options import Unusable, reports_faults


@click.command()
@click.argument("path", metavar="[FILE|FOLDER]", required=False, type=click.Path(path_type=Path))
@click.option(
    "--port", type=click.IntRange(0, 65535), default=0, help="The port; 0, the default, takes a free one."
)
@click.option("--open/--no-open", "opens", default=False, help="Open the page in the browser.")
@reports_faults
def serve(path: Path | None, port: int, opens: bool) -> None:
    """Show a page on this machine that judges a text as you type. FILE is the text to begin with; of a FOLDER
    any text can be opened; without either, paste one.

    Only this machine is served, and only who has the printed address. No file outside of the folder is read;
    none but the opened text and its new model is written. Ctrl-C ends it. Needs the extra page."""
    try:
        from workbench.app.servers.page.page_app import Page, PageServer
    except ImportError:
        raise Unusable("the page needs the extra page: pip install 'kinematics-workbench[page]'") from None
    from workbench.app.servers.page.page_file import PageTexts
    from workbench.source.documents import SUFFIXES

    if path is not None and not path.is_dir() and path.suffix.lower() not in SUFFIXES:
        raise Unusable(f"{path}: expected a folder, or a text ({', '.join(sorted(SUFFIXES))})")
    texts = None if path is None else PageTexts(path)
    with socket.socket() as listener:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listener.bind(("127.0.0.1", port))
        except OSError as error:
            raise Unusable(f"--port {port}: cannot be used: {error.strerror or error}") from None
        listener.listen()
        page = Page(listener.getsockname()[1], texts)
        address = f"http://127.0.0.1:{listener.getsockname()[1]}/#token={page.token}"
        click.echo(f"{path or 'the page'}: open {address}\nCtrl-C ends it")
        if opens:
            webbrowser.open(address)
        try:
            PageServer(page).run(sockets=[listener])
        finally:
            page.close()
