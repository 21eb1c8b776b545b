"""Verdicts of earlier runs, so that what did not change is not judged again.

A verdict is found again by everything that it depends on: what is claimed and supposed, the definitions of
all symbols within its reach, the options, the versions of the engines, and the code of the workbench and of
the paper's theorems.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import asdict, fields, is_dataclass
from functools import cache
from typing import Any

from workbench.judge.theorems.proofs import Proven
from workbench.judge.verdict import Outcome, Verdict
from workbench.language.typed.integers import Linear
from workbench.language.typed.names import Name
from workbench.language.typed.terms import Definition, Symbol, Term
from workbench.language.typed.types import Declaration, Type
from workbench.memory.ground import digest, ground
from workbench.memory.store import Store
from workbench.papers.model import Claim, Notation
from workbench.repair.propose.proposed import Proposed

#: What a claim says of itself that no verdict depends on.
_COSMETIC = frozenset((
    "id", "equation", "section", "note", "inherits", "fault", "unread", "mend", "file", "line",
    "notation", "statement", "span", "chain",
))  # fmt: skip
_DECISIVE = tuple(field.name for field in fields(Claim) if field.name not in _COSMETIC)
_ENGINES = ("drake", "python-flint", "sympy", "numpy")
#: What stands in many places.
_OFTEN = (Term, Declaration, Definition, Type, Linear)


class Memory(Store):
    """The verdicts in a file."""

    def recall(self, key: str) -> Verdict | None:
        """The verdict that is remembered under the key, if it is there and undamaged."""
        with suppress(ValueError, KeyError, TypeError):
            if (text := self.get(key)) is not None:
                return Verdict.from_dict(json.loads(text))
        return None

    def remember(self, key: str, verdict: Verdict) -> None:
        """Keeps a verdict; one that would not come back as it is is not kept."""
        text = json.dumps(verdict.to_dict(), ensure_ascii=False)
        if Verdict.from_dict(json.loads(text)) == verdict:
            self.put(key, text.encode())

    def proposals(self, key: str) -> tuple[Proposed, ...] | None:
        """What an earlier search proposed, if that is there and undamaged."""
        with suppress(ValueError, KeyError, TypeError):
            if (text := self.get(key)) is not None:
                return tuple(
                    Proposed(**{**each, "verdict": Outcome(each["verdict"])}) for each in json.loads(text)
                )
        return None

    def keep_proposals(self, key: str, proposed: Sequence[Proposed]) -> None:
        self.put(key, json.dumps([asdict(each) for each in proposed], ensure_ascii=False).encode())

    def knows(self, key: str) -> bool:
        """Whether what the key stands for was found to be so."""
        return self.recall(key) is not None

    def know(self, key: str) -> None:
        self.remember(key, Verdict(Outcome.PROVED))


class Keys:
    """The keys of one paper's verdicts. options: what else they depend on."""

    def __init__(self, theorems: Mapping[str, Proven], options: Mapping[str, Any]) -> None:
        self._proofs = {name: digest(repr(proof)) for name, proof in theorems.items()}
        self._ground = digest(repr((ground(["workbench"], _ENGINES), sorted(options.items()))))
        self._reaches: dict[int, _Reach] = {}
        self._last: tuple[Claim, str] | None = None  # its forms are asked for one after the other

    def of(self, claim: Claim, form: str) -> str:
        """The key of the verdict on one form of a claim."""
        if self._last is None or self._last[0] is not claim:
            self._last = claim, self._all_of(claim)
        return digest(f"{form}\n{self._last[1]}")

    def _all_of(self, claim: Claim) -> str:
        """What the verdicts on all its forms depend on."""
        on_motions = claim.notation.on_motions.get(claim.id)
        text, names = _said([*(getattr(claim, name) for name in _DECISIVE), on_motions])
        reach = self._reach(claim.notation)
        reached = reach.of(names)
        if claim.goal is not None:  # its proof may speak of any symbol
            reached += [reach.whole, self._proofs.get(claim.theorem or "", "")]
        elif claim.every_n is not None:
            reached += [reach.whole, self._proofs.get(claim.every_n, "")]
        elif not claim.notation.hand.is_plain:  # what it prints may be any symbol's name
            reached.append(reach.whole)
        return digest(repr((text, reached, self._ground)))

    def of_proposals(self, claim: Claim) -> str:
        """The key of what is proposed for a claim: any symbol may stand in it."""
        whole = self._reach(claim.notation).whole
        return digest(repr((self.of(claim, "proposals"), whole, claim.notation.words)))

    def of_bindings(self, notation: Notation) -> str:
        """The key of the agreement of a notation's bindings with its definitions, on motions that agree
        with their plants."""
        return digest(repr(("bindings", self._reach(notation).of(()), self._ground)))

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
            self._digests.setdefault(name, []).append(digest(text))
            self._names.setdefault(name, set()).update(names)
        bindings = sorted((_said(symbol)[0], bound) for symbol, bound in notation.motion.items())
        robot = notation.robot and (notation.robot, notation.robot.urdf.read_bytes())
        self._motion = digest(repr((bindings, robot)))
        self._bound = {symbol.declaration.name for symbol in notation.motion}
        self.whole = digest(_said([notation.symbols, tuple(notation.definitions)])[0])

    def of(self, names: Iterable[Name]) -> list[str]:
        """Digests of the bindings, and of the definitions, in their order, of all that the names stand for,
        and the bound ones, which must agree with them."""
        waiting, reached = {*names, *self._bound}, set()
        while waiting:
            name = waiting.pop()
            reached.add(name)
            waiting |= self._names.get(name, set()) - reached
        return [self._motion, *(d for name, own in self._digests.items() if name in reached for d in own)]


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
