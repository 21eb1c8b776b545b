"""The part of a claim that its judges see. The key of a verdict is computed from this part, so that a verdict
can depend only on what its key contains."""

from __future__ import annotations

from dataclasses import fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from workbench.context.claims import Ambiguity, Claim, ClaimContext, Correction, Formula, Notation, OnMotions
from workbench.core.names import Name
from workbench.core.operations import PARTIALS
from workbench.core.spans import Span
from workbench.core.terms import Apply, Definition, Derivative, Symbol, sides_of
from workbench.language.definitions import Definitions
from workbench.prover.explain.canonical_text import canonical_text

#: Fields that name, locate or comment on a claim. The judges see their defaults.
UNSEEN = ("id", "source", "mend", "inherits", "chain", "unread")
_SEEN = tuple(each.name for each in fields(Claim) if each.name not in (*UNSEEN, "notation"))
_UNNAMED = ""
#: The judges see that a claim stands in a text, but not where.
_SOMEWHERE = Span(Path(), 0, 0, 0, 0)


class JudgedParts:
    """The judged parts of claims.

    Equal parts of one notation are the same object, and so are their definitions: the judges cache by
    identity.
    """

    def __init__(self) -> None:
        self._reaches: dict[int, _Reach] = {}
        self._definitions: dict[tuple[int, ...], Definitions] = {}

    def of(self, claim: Claim) -> Claim:
        """Returns the claim without names, positions and comments, with the part of its notation that it
        reaches."""
        seen, reach = judged_fields_of(claim), self._reach_of(claim.notation)
        own = _without_place(claim.notation.on_motions.get(claim.id))
        part = reach.whole if _needs_all(claim) else reach.part(canonical_text([*seen.values(), own]).names)
        return Claim(
            _UNNAMED, notation=part if own is None else _with_motion_formulas(part, {_UNNAMED: own}), **seen
        )

    def for_proposals(self, claim: Claim) -> Claim:
        """Returns the same with its whole notation: a proposal may use any symbol."""
        return Claim(_UNNAMED, notation=self._reach_of(claim.notation).whole, **judged_fields_of(claim))

    def bound(self, notation: Notation) -> Notation:
        """Returns the part of a notation that its bindings to motions reach."""
        return self._reach_of(notation).part(frozenset())

    def _reach_of(self, notation: Notation) -> _Reach:
        if id(notation) not in self._reaches:
            self._reaches[id(notation)] = _Reach(notation, self._definitions)
        return self._reaches[id(notation)]


class _Reach:
    """The names that the symbols of a notation lead to. `shared`: definitions that are in use."""

    def __init__(self, notation: Notation, shared: dict[tuple[int, ...], Definitions]) -> None:
        self._notation, self._shared = notation, shared
        self._of: dict[Name, list[Definition]] = {}
        for definition in notation.definitions:
            self._of.setdefault(definition.declaration.name, []).append(definition)
        self._next: dict[Name, frozenset[Name]] = {}
        self._parts: dict[frozenset[Name], Notation] = {}
        frames = notation.symbols.frames
        always = (tuple(notation.motion), frames.velocities, frames.orientations)
        self._always = canonical_text(always).names

    @cached_property
    def whole(self) -> Notation:
        return _with_motion_formulas(self._notation, {})

    def part(self, names: frozenset[Name]) -> Notation:
        """Returns the notation restricted to these names and the names that they lead to."""
        reached = self._closed(names | self._always)
        if reached not in self._parts:
            found = [d for d in self._notation.definitions if d.declaration.name in reached]
            key = tuple(map(id, found))
            self._parts[reached] = replace(
                self._notation,
                symbols=self._notation.symbols.part(reached),
                definitions=self._shared.setdefault(key, Definitions(found)),
                framed=self._notation.framed & reached,
                on_motions={},
            )
        return self._parts[reached]

    def _closed(self, names: frozenset[Name]) -> frozenset[Name]:
        waiting, reached = set(names), set()
        while waiting:
            name = waiting.pop()
            reached.add(name)
            waiting |= self._led_to(name) - reached
        return frozenset(reached)

    def _led_to(self, name: Name) -> frozenset[Name]:
        """Returns the members of the family with their own definitions, and the names in its definitions."""
        if name not in self._next:
            members = {other for other in self._of if name.index_of(other) is not None}
            said = [canonical_text(definition).names for definition in self._of.get(name, ())]
            self._next[name] = frozenset(members).union(*said)
        return self._next[name]


def _needs_all(claim: Claim) -> bool:
    """True if all symbols of the notation may be used: by a proof, or by a formula that is printed in the
    author's spellings or parsed again."""
    has_proof = claim.proof.goal is not None or claim.proof.every_n is not None
    is_read_again = differentiates_product(claim.printed) or claim.printed.ill_formed is not None
    return has_proof or is_read_again or not claim.notation.author_notation.is_plain


def differentiates_product(formula: Formula) -> bool:
    """True if it contains a derivative of more than a symbol, which may mean that of the first factor
    only."""
    if formula.statement is None:
        return False
    parts = (part for side in sides_of(formula.statement) for part in side.walk())
    return any(
        not isinstance(part.children[0], Symbol)
        for part in parts
        if isinstance(part, Derivative) or (isinstance(part, Apply) and part.head in PARTIALS)
    )


def judged_fields_of(claim: Claim) -> dict[str, Any]:
    """Returns the fields that the judges see, except the notation."""
    return {name: _without_place(getattr(claim, name)) for name in _SEEN}


def _without_place(value: Any) -> Any:
    if isinstance(value, Span):
        return _SOMEWHERE
    if isinstance(value, Formula) and value.at is not None:
        return replace(value, at=None)
    if isinstance(value, OnMotions | Correction | ClaimContext | Ambiguity):
        return replace(value, **{name: _without_place(own) for name, own in vars(value).items()})
    if isinstance(value, tuple):
        return tuple(map(_without_place, value))
    return value


def _with_motion_formulas(notation: Notation, on_motions: dict[str, Any]) -> Notation:
    """Returns the notation with other formulas for motions, and the same printer, which is expensive to
    build."""
    made = replace(notation, on_motions=on_motions)
    vars(made)["author_notation"] = notation.author_notation
    return made
