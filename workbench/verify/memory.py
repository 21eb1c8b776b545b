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
from collections.abc import Iterator, Mapping, Set
from contextlib import contextmanager, suppress
from dataclasses import fields, is_dataclass
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

from workbench.judge.verdict import Outcome, Verdict
from workbench.language.terms import Symbol, Term
from workbench.papers.model import Claim, Notation, Theorem

#: What a claim says of itself that no verdict depends on.
_COSMETIC = frozenset(
    {
        "id",
        "equation",
        "section",
        "note",
        "inherits",
        "fault",
        "unread",
        "mend",
        "file",
        "line",
        "notation",
        "statement",
        "span",
        "chain",
    }
)
_ENGINES = ("drake", "python-flint", "sympy", "numpy")
_MOST = 50_000


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
    return sha256(f"{key}\n{text}".encode()).hexdigest()


class Keys:
    """The keys of one paper's verdicts. options: what else they depend on."""

    def __init__(self, theorems: Mapping[str, Theorem], options: Mapping[str, Any]) -> None:
        modules = {sys.modules[theorem.__module__] for theorem in theorems.values()}
        packages = sorted({module.__name__.split(".")[0] for module in modules} | {"workbench"})
        versions = [(name, version(name)) for name in _ENGINES]
        code = [(name, _code_of(name)) for name in packages]
        proofs = {name: repr(proof) for name, proof in theorems.items() if not callable(proof)}
        self._proofs = {name: sha256(text.encode()).hexdigest() for name, text in proofs.items()}
        self._ground = repr((code, versions, sys.version_info[:2], sorted(options.items())))
        self._reaches: dict[int, _Reach] = {}
        self._last: tuple[Claim, str] | None = None  # its forms are asked for one after the other

    def of(self, claim: Claim, form: str) -> str:
        """The key of the verdict on one form of a claim."""
        if self._last is None or self._last[0] is not claim:
            self._last = claim, self._all_of(claim)
        return sha256(f"{form}\n{self._last[1]}".encode()).hexdigest()

    def _all_of(self, claim: Claim) -> str:
        """What the verdicts on all its forms depend on."""
        said = {f.name: getattr(claim, f.name) for f in fields(claim) if f.name not in _COSMETIC}
        reach = self._reach(claim.notation)
        said["on motions"] = claim.notation.on_motions.get(claim.id)
        if claim.goal is None:
            reached: Any = reach.of(said)
        else:  # its proof may speak of any symbol
            reached = reach.of(said), reach.whole, self._proofs.get(claim.theorem or "")
        return sha256(repr((said, reached, self._ground)).encode()).hexdigest()

    def of_bindings(self, notation: Notation) -> str:
        """The key of the agreement of a notation's bindings with its definitions, on motions that agree
        with their plants."""
        reached = self._reach(notation).of(None)
        return sha256(repr(("bindings", reached, self._ground)).encode()).hexdigest()

    def _reach(self, notation: Notation) -> _Reach:
        if id(notation) not in self._reaches:
            self._reaches[id(notation)] = _Reach(notation)
        return self._reaches[id(notation)]


class _Reach:
    """What the symbols of a notation stand for, by their names."""

    def __init__(self, notation: Notation) -> None:
        self._texts: dict[str, list[str]] = {}
        self._names: dict[str, set[str]] = {}
        for definition in notation.definitions:
            name = definition.declaration.name
            self._texts.setdefault(name, []).append(repr(definition))
            self._names.setdefault(name, set()).update(_names_in(definition))
        bindings = sorted((repr(symbol), bound) for symbol, bound in notation.motion.items())
        self._motion = repr((bindings, notation.robot and (notation.robot, notation.robot.urdf.read_bytes())))
        self._bound = {symbol.declaration.name for symbol in notation.motion}
        self.whole = repr((_in_order(notation.symbols), tuple(notation.definitions)))

    def of(self, said: Any) -> tuple[str, list[str]]:
        """The definitions, in their order, of all that the symbols in it stand for, and of the bound ones,
        which must agree with them; and the bindings."""
        waiting, reached = {*_names_in(said), *self._bound}, set()
        while waiting:
            name = waiting.pop()
            reached.add(name)
            waiting |= self._names.get(name, set()) - reached
        return self._motion, [text for name in self._texts if name in reached for text in self._texts[name]]


def _in_order(part: Any) -> list[Any]:
    """The fields of a dataclass; the sets among them sorted, since their order is another in each process."""
    values = (getattr(part, field.name) for field in fields(part))
    return [sorted(value, key=repr) if isinstance(value, Set) else value for value in values]


def _names_in(part: Any) -> frozenset[str]:
    """The names of all symbols in a part of a claim or of a definition."""
    if isinstance(part, Term):
        return _names_in_term(part)
    if isinstance(part, dict):
        part = tuple(part.values())
    elif is_dataclass(part):
        part = [getattr(part, field.name) for field in fields(part)]
    if isinstance(part, tuple | list):
        return frozenset().union(*map(_names_in, part))
    return frozenset()


@cache
def _names_in_term(term: Term) -> frozenset[str]:
    return frozenset(part.declaration.name for part in term.walk() if isinstance(part, Symbol))


@cache
def _code_of(package: str) -> str:
    """A digest of the package's sources, in the order of their names."""
    root = Path(sys.modules[package].__file__).parent
    digest = sha256()
    for path in sorted(root.rglob("*.py")):
        digest.update(f"{path.relative_to(root)}\n".encode() + path.read_bytes())
    return digest.hexdigest()
