"""Range of recurrences: the n from which a definition for all n applies.

A definition of one member (Φ₁) takes precedence over that of all members (Φₙ₊₁). The base of a recurrence is
such a member, and so may be Φ₃ := …, which need not satisfy the definition for all n. A proof that rewrote
Φₙ₊₁ by it then covers only the n past that member.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Protocol
from weakref import WeakKeyDictionary

from workbench.core.construct import relation, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.names import Name
from workbench.core.terms import Definition, IllFormed, Relation, Statement, Symbol, Term
from workbench.core.verdict import Outcome, Verdict
from workbench.engines.inventory import NotExact, reached
from workbench.language.definitions import Definitions, expand, solve

_KNOWN: WeakKeyDictionary[Definitions, Exceptions] = WeakKeyDictionary()

Index = tuple[Linear, ...]


class InstanceJudge(Protocol):
    """A judge of statements without integer variables."""

    definitions: Definitions

    def judge_instance(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict: ...


@dataclass(frozen=True)
class Exceptions:
    """Exceptions from definitions for all n.

    apart: family → its members for which the definition for all n fails or is not known to hold.
    first: family → its lowest member, if a recurrence derives all others from its base: 1 for Φ₁, Φₙ₊₁.
    tangled: True if a family of several indices has such members; then no proof for all n is tried.
    """

    apart: Mapping[Name, frozenset[int]]
    first: Mapping[Name, int]
    tangled: bool

    def start(self, members: Iterable[Symbol]) -> dict[str, int]:
        """Returns variable → the least value, from 0, at which none of these symbolic members is an
        exception."""
        return _least(
            (index, max((k + 1 for k in self.apart.get(member.declaration.name, ())), default=0))
            for member in members
            for index in member.index
        )

    def begin(self, members: Iterable[Symbol]) -> dict[str, int]:
        """Returns variable → the least value, from 0, at which all these members belong to their families."""
        return _least(
            (index, self.first.get(member.declaration.name, 0))
            for member in members
            for index in member.index
        )


def _least(bounds: Iterable[tuple[Linear, int]]) -> dict[str, int]:
    """Returns variable → the least value, from 0, at which each index n + c reaches its bound."""
    least: dict[str, int] = {}
    for index, bound in bounds:
        for name in index.variables:
            least[name] = max(least.get(name, 0), bound - index.constant)
    return least


def exceptions(judge: InstanceJudge) -> Exceptions:
    """Returns the exceptions from the judge's definitions."""
    definitions = judge.definitions
    if definitions not in _KNOWN:
        _KNOWN[definitions] = _exceptions(judge)
    return _KNOWN[definitions]


def _exceptions(judge: InstanceJudge) -> Exceptions:
    definitions = judge.definitions
    apart: dict[Name, set[int]] = {}
    first: dict[Name, int] = {}
    tangled = _some_overlap(definitions)
    for general in definitions:
        if all(place.is_number for place in general.index):
            continue
        name = general.declaration.name
        own = list(_members_by_themselves(definitions, general))
        if len(general.index) == 1:
            first[name] = _first(general, {int(index[0]) for index in own})
        for index in own:
            values = solve(general.index, index)
            if values is None or any(int(value) < 0 for value in values.values()):
                continue
            if _agrees(judge, general, index, values):
                continue
            if len(index) == 1:
                apart.setdefault(name, set()).add(int(index[0]))
            else:
                tangled = True
    return Exceptions({name: frozenset(found) for name, found in apart.items()}, first, tangled)


def _first(general: Definition, base: set[int]) -> int:
    """Returns the lowest member of the base if the recurrence refers to none below it; else 0."""
    mentioned = [
        int(place - general.index[0])
        for part in general.body.symbols()
        if part.declaration.name == general.declaration.name
        for place in part.index
        if (place - general.index[0]).is_number
    ]
    lowest, reached = min(base, default=0), general.index[0].constant
    while reached in base:
        reached += 1
    closed = bool(mentioned) and general.index[0].constant >= lowest and reached + min(mentioned) >= lowest
    return lowest if closed else 0


def _some_overlap(definitions: Definitions) -> bool:
    """True if two definitions for several members each, such as K_{0,n} and K_{m,n}, share one."""
    many = [d for d in definitions if any(not place.is_number for place in d.index)]
    return any(
        a.declaration == b.declaration and all(map(_meet, a.index, b.index)) for a, b in combinations(many, 2)
    )


def _meet(a: Linear, b: Linear) -> bool:
    if a.is_number and b.is_number:
        return a == b
    number, place = (a, b) if a.is_number else (b, a)
    return not number.is_number or int(number) >= place.constant


def _members_by_themselves(definitions: Definitions, general: Definition) -> Iterator[Index]:
    """Yields the indices of the family's members that have their own definitions."""
    for single in definitions:
        if all(place.is_number for place in single.index):
            if single.declaration == general.declaration:
                yield single.index
            elif not single.index and (index := general.declaration.name.index_of(single.declaration.name)):
                yield index


def _agrees(judge: InstanceJudge, general: Definition, index: Index, values: Mapping[str, Linear]) -> bool:
    """True if the member equals the value of the definition for all n."""
    formals = [symbol(formal) for formal in general.parameters]
    try:
        member = symbol(general.declaration, index, formals)
        said = relation("=", member, instantiate(general.body, values))
        return _holds(judge, said)
    except (IllFormed, NotExact):
        return False


def _holds(judge: InstanceJudge, said: Relation) -> bool:
    if expand(said.left, judge.definitions) == expand(said.right, judge.definitions):
        return True
    outcome = judge.judge_instance(said, (), None).outcome
    return outcome in (Outcome.PROVED, Outcome.PROBABLE, Outcome.DEFINITION)


def rewritten(terms: Iterable[Term], definitions: Definitions) -> Iterator[Symbol]:
    """Yields the symbolic members, such as Φₙ₊₁, that definitions replace in the terms, recursively."""
    members = symbolic_members(reached(definitions, *terms))
    yield from (member for member in dict.fromkeys(members) if definitions.lookup(member) is not None)


def symbolic_members(parts: Iterable[Term]) -> list[Symbol]:
    """Returns those of the terms that are members of families with an integer variable in their index."""
    symbols = (part for part in parts if isinstance(part, Symbol))
    return [part for part in symbols if any(not place.is_number for place in part.index)]
