"""The chain of notation files of a paper file, and settings from it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from workbench.core.schema import key_names
from workbench.papers.reading_stages import Stage, stage
from workbench.runtime import Budget
from workbench.source.toml.toml_file import TomlFile

T = TypeVar("T")

NOTATION_KEYS = key_names("notation file")


def notation_chain(file: TomlFile) -> list[TomlFile]:
    """Returns the notation files that `file` builds on, the deepest first, and `file` itself."""
    chain = [file]
    while (name := _notation_file(chain[0])) is not None:
        user = chain[0]
        path = user.path.parent / name
        if Path(name).name != name:
            raise user.error_at_value(("notation",), f"notation: expected a file beside this, got {name!r}")
        if any(path.resolve() == link.path.resolve() for link in chain):
            raise user.error_at_value(("notation",), f"notation: {name} refers back to itself")
        if not path.is_file():
            raise user.error_at_value(("notation",), f"notation: no file {name!r} beside this one")
        chain.insert(0, TomlFile(path))
        chain[0].allow_keys((), NOTATION_KEYS)
    return chain


def chain_stage(file: TomlFile) -> Stage[list[TomlFile]]:
    """Returns the files of the chain with the errors of reading it."""
    done = stage(notation_chain, file)
    chain = done.value and [each.origin for each in done.value]
    return replace(done, value=chain)


def _notation_file(file: TomlFile) -> str | None:
    """Returns the file that this one builds on; a table [notation] may name that file under `from`."""
    if not isinstance(file.data.get("notation"), dict):
        return file.text(("notation",))
    return file.text(("notation", "from"))


def nearest(chain: Sequence[TomlFile], read: Callable[[TomlFile], T | None]) -> T | None:
    """Returns the value of the last file of a chain that has one."""
    return next((found for file in reversed(chain) if (found := read(file))), None)


def budget_of(file: TomlFile) -> Budget | None:
    """Returns the limits of time and memory for each judgement; None if the file sets none."""
    given = file.value(("budget",), dict, None)
    if given is None:
        return None
    file.allow_keys(("budget",), key_names("budget"))
    for name, value in given.items():
        try:
            Budget(**{name: value})
        except ValueError as error:
            raise file.error_at_value(("budget", name), f"budget: {error}") from None
    return Budget(**given)
