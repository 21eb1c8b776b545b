"""Check of declared properties of defined symbols: each must be proved wherever the symbol is defined."""

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
from workbench.source.toml.toml_file import TomlTable


class Promise(NamedTuple):
    """A property that is declared of a defined symbol."""

    key: str
    flag: str


def without_promises(
    specs: Mapping[str, Mapping[str, Any]], defined: Collection[str], anew: Collection[str] = ()
) -> tuple[dict[str, Mapping[str, Any]], list[Promise]]:
    """Returns the declarations of [symbols] without properties of defined symbols, and these properties.

    anew: symbols that a scope defines and that are free before it.
    """
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
    promises: Collection[Promise], owners: Mapping[str, TomlTable], table: SymbolTable, known: Definitions
) -> None:
    """Raises PaperError for a property that is not proved. owners: the files of the definitions."""
    for key, flag in promises:
        names = (read_key(key, INDEX_LETTERS), read_key(key))  # T_m may be one name if m is a symbol
        name, index = next(each for each in names if each[0] in table.symbols)
        try:
            why = unseen(PROPERTIES[flag].statement_of(symbol(table.symbols[name], index)), known)
        except IllFormed as fault:
            why = str(fault)
        if why is not None:
            message = f"{key}: declared as {flag}, which its definition is not seen to be: {why}"
            raise owners[key].error_at_key(("definitions", key), message)


def unseen(statement: Statement, definitions: Definitions) -> str | None:
    """Returns why the statement is not proved wherever it is defined; None if it is."""
    from workbench.core.verdict import Outcome
    from workbench.engines.inventory import NotExact
    from workbench.prover.decide.decide import Judge

    try:
        verdict = Judge(definitions).judge(statement)
    except NotExact as outside:
        return str(outside)
    holds = verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
    return None if holds else verdict.reason or str(verdict.outcome)
