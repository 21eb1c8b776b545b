"""Verdicts of earlier runs, so that what did not change is not judged again.

A verdict is found again by everything that it depends on: what is claimed and supposed, the definitions of
all symbols within its reach, the options, the versions of the engines, and the code of the workbench and of
the paper's theorems. A file that is damaged, or that belongs to somebody else, is as good as none.
"""

from __future__ import annotations

import json
import os
import sqlite3
import sys
from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import contextmanager, suppress
from dataclasses import fields, is_dataclass
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

from workbench.judge.verdict import Outcome, Verdict
from workbench.language.integers import Linear
from workbench.language.names import Name
from workbench.language.terms import Definition, Symbol, Term
from workbench.language.types import Declaration, Type
from workbench.papers.model import Claim, Notation, Theorem

#: What a claim says of itself that no verdict depends on.
_COSMETIC = frozenset((
    "id", "equation", "section", "note", "inherits", "fault", "unread", "mend", "file", "line",
    "notation", "statement", "span", "chain",
))  # fmt: skip
_DECISIVE = tuple(field.name for field in fields(Claim) if field.name not in _COSMETIC)
_ENGINES = ("drake", "python-flint", "sympy", "numpy")
_MOST = 50_000
#: What stands in many places.
_OFTEN = (Term, Declaration, Definition, Type, Linear)


class Memory:
    """The verdicts in a file, made on first use."""

    def __init__(self, file: Path) -> None:
        self._database: sqlite3.Connection | None = None
        with suppress(OSError, sqlite3.Error):
            self._database = _opened(file)

    def recall(self, key: str) -> Verdict | None:
        """The verdict that is remembered under the key, if it is there and undamaged."""
        if self._database is None:
            return None
        with suppress(sqlite3.Error, ValueError, KeyError, TypeError):
            query = "SELECT verdict, seal FROM verdicts WHERE key = ?"
            row = self._database.execute(query, (key,)).fetchone()
            if row is not None and row[1] == _seal(key, row[0]):
                return Verdict.from_dict(json.loads(row[0]))
        return None

    def remember(self, key: str, verdict: Verdict) -> None:
        """Keeps a verdict; one that would not come back as it is is not kept."""
        if self._database is None:
            return
        text = json.dumps(verdict.to_dict(), ensure_ascii=False)
        if Verdict.from_dict(json.loads(text)) != verdict:
            return
        with suppress(sqlite3.Error), self._database:
            insert = "INSERT OR REPLACE INTO verdicts (key, verdict, seal) VALUES (?, ?, ?)"
            self._database.execute(insert, (key, text, _seal(key, text)))

    def knows(self, key: str) -> bool:
        """Whether what the key stands for was found to be so."""
        return self.recall(key) is not None

    def know(self, key: str) -> None:
        self.remember(key, Verdict(Outcome.PROVED))

    def close(self) -> None:
        if self._database is not None:
            with suppress(sqlite3.Error), self._database:
                oldest = "SELECT max(rowid) FROM verdicts"
                self._database.execute(f"DELETE FROM verdicts WHERE rowid <= ({oldest}) - ?", (_MOST,))
            self._database.close()
            self._database = None


@contextmanager
def standard_memory() -> Iterator[Memory]:
    """That under WORKBENCH_CACHE, or where the system keeps such files."""
    from platformdirs import user_cache_path

    place = os.environ.get("WORKBENCH_CACHE")
    memory = Memory((Path(place) if place else user_cache_path("kinematics-workbench")) / "verdicts.sqlite")
    try:
        yield memory
    finally:
        memory.close()


def _opened(file: Path) -> sqlite3.Connection | None:
    """The database; a damaged one is made anew, one of another user is left alone."""
    file.parent.mkdir(parents=True, exist_ok=True)
    if file.exists() and hasattr(os, "getuid") and file.stat().st_uid != os.getuid():
        return None
    table = "CREATE TABLE IF NOT EXISTS verdicts (key TEXT PRIMARY KEY, verdict TEXT, seal TEXT)"
    for attempt in range(2):
        database = sqlite3.connect(file, timeout=5.0)
        try:
            database.execute("PRAGMA synchronous = OFF")  # what an outage damages is judged again
            database.execute(table)
            return database
        except sqlite3.OperationalError:  # locked, or no room
            database.close()
            return None
        except sqlite3.DatabaseError:
            database.close()
            if attempt:
                return None
            file.unlink()
    return None


def _seal(key: str, text: str) -> str:
    return _digest(f"{key}\n{text}")


class Keys:
    """The keys of one paper's verdicts. options: what else they depend on."""

    def __init__(self, theorems: Mapping[str, Theorem], options: Mapping[str, Any]) -> None:
        modules = {sys.modules[theorem.__module__] for theorem in theorems.values()}
        packages = sorted({module.__name__.split(".")[0] for module in modules} | {"workbench"})
        versions = [(name, version(name)) for name in _ENGINES]
        code = [(name, _code_of(name)) for name in packages]
        self._proofs = {name: _digest(repr(proof)) for name, proof in theorems.items() if not callable(proof)}
        self._ground = _digest(repr((code, versions, sys.version_info[:2], sorted(options.items()))))
        self._reaches: dict[int, _Reach] = {}
        self._last: tuple[Claim, str] | None = None  # its forms are asked for one after the other

    def of(self, claim: Claim, form: str) -> str:
        """The key of the verdict on one form of a claim."""
        if self._last is None or self._last[0] is not claim:
            self._last = claim, self._all_of(claim)
        return _digest(f"{form}\n{self._last[1]}")

    def _all_of(self, claim: Claim) -> str:
        """What the verdicts on all its forms depend on."""
        on_motions = claim.notation.on_motions.get(claim.id)
        text, names = _said([*(getattr(claim, name) for name in _DECISIVE), on_motions])
        reach = self._reach(claim.notation)
        reached = reach.of(names)
        if claim.goal is not None:  # its proof may speak of any symbol
            reached += [reach.whole, self._proofs.get(claim.theorem or "", "")]
        elif not claim.notation.hand.is_plain:  # what it prints may be any symbol's name
            reached.append(reach.whole)
        return _digest(repr((text, reached, self._ground)))

    def of_bindings(self, notation: Notation) -> str:
        """The key of the agreement of a notation's bindings with its definitions, on motions that agree
        with their plants."""
        return _digest(repr(("bindings", self._reach(notation).of(()), self._ground)))

    def _reach(self, notation: Notation) -> _Reach:
        if id(notation) not in self._reaches:
            self._reaches[id(notation)] = _Reach(notation)
        return self._reaches[id(notation)]


class _Reach:
    """What the symbols of a notation stand for, by their names."""

    def __init__(self, notation: Notation) -> None:
        self._digests: dict[Name, list[str]] = {}
        self._names: dict[Name, set[Name]] = {}
        for definition in notation.definitions:
            name, (text, names) = definition.declaration.name, _said(definition)
            self._digests.setdefault(name, []).append(_digest(text))
            self._names.setdefault(name, set()).update(names)
        bindings = sorted((_said(symbol)[0], bound) for symbol, bound in notation.motion.items())
        robot = notation.robot and (notation.robot, notation.robot.urdf.read_bytes())
        self._motion = _digest(repr((bindings, robot)))
        self._bound = {symbol.declaration.name for symbol in notation.motion}
        self.whole = _digest(_said([notation.symbols, tuple(notation.definitions)])[0])

    def of(self, names: Iterable[Name]) -> list[str]:
        """Digests of the bindings, and of the definitions, in their order, of all that the names stand for,
        and the bound ones, which must agree with them."""
        waiting, reached = {*names, *self._bound}, set()
        while waiting:
            name = waiting.pop()
            reached.add(name)
            waiting |= self._names.get(name, set()) - reached
        return [self._motion, *(d for name, own in self._digests.items() if name in reached for d in own)]


def _digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()


def _said(part: Any) -> tuple[str, frozenset[Name]]:
    """All that a part of a claim or of a definition says, the same in each process, and the names of all
    symbols in it."""
    if part is None or isinstance(part, str | int):
        return repr(part), frozenset()
    if isinstance(part, _OFTEN):
        return _said_once(part)
    if isinstance(part, tuple | list):
        return _together("", part)
    if is_dataclass(part):
        return _said_by_fields(part)
    if isinstance(part, Mapping):
        return _together("", part.items())
    if isinstance(part, Set):
        return _together("", sorted(part, key=repr))
    return repr(part), frozenset()


def _said_by_fields(part: Any) -> tuple[str, frozenset[Name]]:
    return _together(type(part).__name__, [getattr(part, name) for name in _shown(type(part))])


def _together(kind: str, parts: Iterable[Any]) -> tuple[str, frozenset[Name]]:
    said = [_said(part) for part in parts]
    return f"{kind}({', '.join(text for text, _ in said)})", frozenset().union(*(names for _, names in said))


@cache
def _said_once(part: Any) -> tuple[str, frozenset[Name]]:
    text, names = _said_by_fields(part)
    return text, names | {part.declaration.name} if isinstance(part, Symbol) else names


@cache
def _shown(kind: type) -> tuple[str, ...]:
    return tuple(field.name for field in fields(kind) if field.repr)


@cache
def _code_of(package: str) -> str:
    """A digest of the package's sources, in the order of their names."""
    root = Path(sys.modules[package].__file__).parent
    digest = sha256()
    for path in sorted(root.rglob("*.py")):
        digest.update(f"{path.relative_to(root)}\n".encode() + path.read_bytes())
    return digest.hexdigest()
