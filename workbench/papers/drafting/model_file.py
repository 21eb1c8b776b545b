"""A drafted model as TOML: guesses with reasons, proposals, and unread formulas. It always loads."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from workbench.papers.drafting.draft_model import Ingested, Proposed
from workbench.papers.drafting.model_proposal import tables_of
from workbench.papers.drafting.redefinitions import Scope
from workbench.papers.reading_stages import ErrorLog
from workbench.papers.texts.load_texts import model_of
from workbench.papers.texts.text_model import TextModel
from workbench.source.documents.titles import own_title
from workbench.source.toml.toml_file import TomlFile

_WIDTH = 100


def model_text(ingested: Ingested, path: Path) -> str:
    """Returns the model for a file at `path`. Entries that the loader rejects become comments with the
    reason."""
    return loaded_model(ingested, path, is_confirmed=False)[0]


def loaded_model(
    ingested: Ingested, path: Path, is_confirmed: bool
) -> tuple[str, TextModel, tuple[Scope, ...]]:
    """Returns the model as text and as loaded, and the scopes that it can keep. is_confirmed: nothing is
    listed as guessed."""
    chosen = [proposed for proposed in ingested.definitions if proposed.sure]
    refused: dict[str, str] = {}
    ingested = replace(ingested, scopes=list(ingested.scopes))
    while True:
        written = "\n".join(_lines(ingested, path, chosen, refused, is_confirmed)) + "\n"
        faults = ErrorLog()
        model = model_of(TomlFile(path, written), ingested.text, faults)
        model.notations()
        wrong = {str(fault.path[-1]): fault.message for fault in faults if fault.path[:1] == ("definitions",)}
        if scopes := [fault.path[1] for fault in faults if fault.path[:1] == ("scope",)]:
            del ingested.scopes[int(scopes[0])]
            continue
        wrong |= {
            _symbol(fault.path[-1]): fault.message for fault in faults if fault.path[:1] == ("symbols",)
        }
        if not wrong and faults and ingested.scopes:
            ingested.scopes.clear()
            continue
        if refused.keys() >= wrong.keys():
            faults.stop()
            return written, model, tuple(ingested.scopes)
        refused |= wrong
        chosen = [proposed for proposed in chosen if proposed.name not in refused]


def _symbol(name: object) -> str:
    """Returns the key of a refused symbol, beside those of refused definitions."""
    return f"[symbols] {name}"


def _lines(
    ingested: Ingested, path: Path, chosen: list[Proposed], refused: dict[str, str], is_confirmed: bool
) -> Iterator[str]:
    text = ingested.text
    yield f"# A first model of {_comment(text.path.name)}. Kinds marked `guessed` are guesses: look at each."
    if ingested.questions:
        yield "#"
        yield "# Only the author can answer:"
        yield from (f"#   - {_comment(question)}" for question in ingested.questions)
    yield ""
    yield f"source = {string(os.path.relpath(text.path, path.parent or '.'))}"
    macros = ingested.macros and string(os.path.relpath(ingested.macros, path.parent or "."))
    if macros and not ingested.fences:
        yield f"macros = {macros}"
    yield f"title = {string(own_title(text) or text.path.stem)}"
    tables = tables_of(ingested.proposals)
    if not is_confirmed:
        yield "# Take out what is right: until then, no fault is found in what rests on it."
        yield "guessed = ["
        names = [*(f"[{table}]" for table in tables), *ingested.fences, *ingested.guesses]
        yield from (
            f"    {string(name)},"
            for name in names
            if name not in ingested.confirmed and _symbol(name) not in refused
        )
        yield "]"
    yield ""
    if ingested.fences:
        yield "[macros]"
        if macros:
            yield f"from = {macros}"
        for name, body in ingested.fences.items():
            yield f"{string(name)} = {string(body)}  # guessed: it seems to print that"
        yield ""
    for table, entries in tables.items():
        yield f"[{table}]"
        yield from (f"{key} = {value}  # guessed: {_comment(why)}" for key, (value, why) in entries.items())
        yield ""
    yield "[symbols]"
    defined = {proposed.name for proposed in chosen}
    for guess in ingested.guesses.values():
        flags = "".join(f", {flag} = true" for flag in guess.spec if flag not in ("kind", "of"))
        flags += f", of = [{', '.join(map(string, guess.of))}]" if guess.of else ""
        entry = f'{string(guess.name)} = {{ kind = "{guess.kind}"{flags} }}'
        wrong = refused.get(_symbol(guess.name))
        mark = "# " if guess.name in defined or wrong else ""
        why = f"; refused: {_comment(wrong)}" if wrong else ""
        yield f"{mark}{entry}  # guessed: {_comment(guess.why)}{why}"
    yield ""
    yield "[definitions]"
    for proposed in ingested.definitions:
        entry = f"{string(proposed.name)} = {string(proposed.body)}"
        note = f"# line {proposed.line}: {_comment(proposed.why)}"
        if proposed in chosen:
            yield f"{entry}  {note}"
        else:
            why = f"; refused: {_comment(refused[proposed.name])}" if proposed.name in refused else ""
            yield f"# {entry}  {note}{why}"
    for scope in ingested.scopes:
        yield from ("", *scope_lines(scope))
    unread = [(d, feature) for d in text.displays if (feature := ingested.feature_of(d)) is not None]
    if unread:
        yield ""
        yield "# Not read yet, and what each needs:"
        for display, feature in unread:
            yield f"#   line {display.line}: {_comment(feature)}: {_comment(display.latex)}"


def scope_lines(scope: Scope) -> Iterator[str]:
    """Yields the lines of a scope in a model."""
    yield f"[[scope]]  # line {scope.display.line}: {_comment(scope.why)}"
    yield f"from = {string(scope.start)}"
    if scope.symbols:
        yield "[scope.symbols]"
        yield from (f"{string(name)} = {entry}" for name, entry in scope.symbols.items())
    if scope.definitions:
        yield "[scope.definitions]"
        yield from (f"{string(name)} = {string(body)}" for name, body in scope.definitions.items())


def string(text: str) -> str:
    """Returns the text as a TOML string, as a literal one if TOML allows it."""
    if "'" not in text and text.isprintable():
        return f"'{text}'"
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in escaped) + '"'


def _comment(text: str) -> str:
    flat = " ".join(text.split())
    flat = "".join(c if c.isprintable() else "\ufffd" for c in flat)
    return flat if len(flat) <= _WIDTH else f"{flat[: _WIDTH - 1]}…"
