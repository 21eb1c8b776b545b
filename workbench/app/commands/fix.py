"""check --fix and --diff: applies proved corrections to the author's files, or prints them for `patch`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from workbench.app.commands.options import Unusable
from workbench.core.verdict import Outcome
from workbench.runtime.atomic_files import replace_file
from workbench.source.documents.source_edits import SourceEdit, applied, patch_of
from workbench.source.documents.source_view import MOST_BYTES
from workbench.source.toml.file_bytes import file_bytes

if TYPE_CHECKING:
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.source.documents import Source


def proved_edits(results: Sequence[ClaimResult]) -> dict[Path, list[SourceEdit]]:
    """Returns the edits that correct errors and warnings, by file; of overlapping corrections the first."""
    found: dict[Path, list[SourceEdit]] = {}
    for result in results:
        proposed = result.proposed[0] if result.proposed else None
        if not result.is_wrong or proposed is None or proposed.verdict is not Outcome.PROVED:
            continue
        kept = [edit for edits in found.values() for edit in edits]
        if any(_clash(edit, other) for edit in result.edits for other in kept):
            continue
        for edit in result.edits:
            own = found.setdefault(edit.span.file, [])
            if edit not in own:
                own.append(edit)
    return found


def _clash(edit: SourceEdit, other: SourceEdit) -> bool:
    if edit == other or edit.span.file != other.span.file:
        return False
    return edit.start <= other.end and other.start <= edit.end


def diff_of(edits: dict[Path, list[SourceEdit]]) -> str:
    """Returns the corrections as a unified diff."""
    texts = ((path, own[0].source.text, own) for path, own in edits.items())
    return "".join(patch_of(text, applied(text, own), os.path.relpath(path)) for path, text, own in texts)


def write_fixes(edits: dict[Path, list[SourceEdit]]) -> int:
    """Applies the corrections to the files, and returns their number.

    Raises Unusable if a file cannot be written, or has changed since it was read; in the latter case no file
    is changed.
    """
    made = [(path, _edited(path, own[0].source, own)) for path, own in edits.items()]
    for path, data in made:
        try:
            replace_file(path, data)
        except OSError as error:
            raise Unusable(f"{path}: cannot be written: {error.strerror or error}") from None
    return sum(len(own) for own in edits.values())


def _edited(path: Path, source: Source, edits: Sequence[SourceEdit]) -> bytes:
    """Returns the bytes of the file with the edits applied; all others are kept, including line endings."""
    raw = file_bytes(path, "a text", MOST_BYTES)
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise Unusable(f"{path}: is not UTF-8; --diff prints the corrections instead") from None
    if text.replace("\r\n", "\n").replace("\r", "\n") != source.text:
        raise Unusable(f"{path}: changed while it was judged; nothing was written")
    offsets = [at for at, sign in enumerate(text) if sign != "\n" or text[at - 1 : at] != "\r"]
    offsets.append(len(text))
    moved = [replace(edit, start=offsets[edit.start], end=offsets[edit.end]) for edit in edits]
    mark = b"\xef\xbb\xbf" if raw.startswith(b"\xef\xbb\xbf") else b""
    return mark + applied(text, moved).encode("utf-8")


def confirmed(edits: dict[Path, list[SourceEdit]]) -> bool:
    """Shows the corrections, and returns whether the user confirms them."""
    click.echo(diff_of(edits), nl=False)
    count = sum(len(own) for own in edits.values())
    return click.confirm(f"Make {count} correction{'' if count == 1 else 's'}?", default=False)
