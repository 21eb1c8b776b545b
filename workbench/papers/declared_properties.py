"""What is declared of symbols that definitions give: it must be seen to hold wherever these are defined."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any, NamedTuple

from workbench.core.construct import symbol
from workbench.core.properties import FLAGS, PROPERTIES
from workbench.core.terms import IllFormed, Statement
from workbench.language.definitions import Definitions
from workbench.language.naming.declarations import read_key
from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.language.naming.symbols import SymbolTable
from workbench.source.toml.toml_file import TomlFile


class Promise(NamedTuple):
    """A symbol that has a definition, and what is declared of it beside its kind."""

    key: str
    flag: str


def without_promises(
    specs: Mapping[str, Mapping[str, Any]], defined: Collection[str], anew: Collection[str] = ()
) -> tuple[dict[str, Mapping[str, Any]], list[Promise]]:
    """The declarations of [symbols], those of defined symbols without what their definitions are to keep.
    anew: those that a scope defines, which are free before it."""
    plain: dict[str, Mapping[str, Any]] = {}
    promises = []
    for key, spec in specs.items():
        plain[key] = spec
        if key in defined:
            flags = [flag for flag in FLAGS if spec.get(flag) is True or spec.get("kind") == flag]
            promises += [Promise(key, flag) for flag in flags]
            kind = "tensor" if "rotation" in flags else spec.get("kind")
            flags += ["free"] * (key in anew)
            plain[key] = {**{name: said for name, said in spec.items() if name not in flags}, "kind": kind}
    return plain, promises


def require_kept(
    promises: Collection[Promise], owners: Mapping[str, TomlFile], table: SymbolTable, known: Definitions
) -> None:
    """Raises PaperError for what is not seen to hold. owners: the files of the definitions."""
    for key, flag in promises:
        names = (read_key(key, INDEX_LETTERS), read_key(key))  # T_m may be one name, m being a symbol
        name, index = next(each for each in names if each[0] in table.symbols)
        try:
            why = unseen(PROPERTIES[flag].statement_of(symbol(table.symbols[name], index)), known)
        except IllFormed as fault:
            why = str(fault)
        if why is not None:
            message = f"{key}: declared as {flag}, which its definition is not seen to be: {why}"
            raise owners[key].error_at_key(("definitions", key), message)


def unseen(statement: Statement, definitions: Definitions) -> str | None:
    """Why the statement is not seen to hold wherever it is defined; None if it is."""
    from workbench.core.verdict import Outcome
    from workbench.engines.inventory.inventory import NotExact
    from workbench.prover.decide.decide import Judge

    try:
        verdict = Judge(definitions).judge(statement)
    except NotExact as outside:
        return str(outside)
    holds = verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
    return None if holds else verdict.reason or str(verdict.outcome)
