"""Families whose single members agree with what is defined for all n.

A definition of one member (Φ₁) goes before that of all (Φₙ₊₁). A base of a recurrence is such a member, and
so may be Φ₃ := …; then what the recurrence proves for all n need not hold at n = 3.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Protocol
from weakref import WeakKeyDictionary

from workbench.judge.inventory import NotExact
from workbench.judge.verdict import Outcome, Verdict
from workbench.language.construct import relation, symbol
from workbench.language.definitions import Definitions, expand, solve
from workbench.language.instances import instantiate
from workbench.language.integers import Linear
from workbench.language.terms import IllFormed, Relation, Statement

_KNOWN: WeakKeyDictionary[Definitions, bool] = WeakKeyDictionary()


class InstanceJudge(Protocol):
    """A judge of statements without integer variables."""

    definitions: Definitions

    def judge_instance(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict: ...


def is_regular(judge: InstanceJudge) -> bool:
    """Whether each member defined by itself is what the definition for all n makes of it, where that one
    applies to it."""
    definitions = judge.definitions
    if definitions not in _KNOWN:
        _KNOWN[definitions] = not _some_overlap(definitions) and all(
            _holds(judge, said) for said in _single_members(definitions)
        )
    return _KNOWN[definitions]


def _some_overlap(definitions: Definitions) -> bool:
    """Whether two definitions for several members each, such as K_{0,n} and K_{m,n}, share one."""
    many = [d for d in definitions if any(not place.is_number for place in d.index)]
    return any(
        a.declaration == b.declaration and all(map(_meet, a.index, b.index)) for a, b in combinations(many, 2)
    )


def _meet(a: Linear, b: Linear) -> bool:
    if a.is_number and b.is_number:
        return a == b
    number, place = (a, b) if a.is_number else (b, a)
    return not number.is_number or int(number) >= place.constant


def _single_members(definitions: Definitions) -> Iterator[Relation]:
    """Φ₃ = (what the definition for all n says of Φ₃), for each Φ₃ that is defined by itself."""
    for single in definitions:
        if not single.index or not all(i.is_number for i in single.index):
            continue
        formals = [symbol(formal) for formal in single.parameters]
        member = symbol(single.declaration, single.index, formals)
        for general in definitions:
            if general.declaration != single.declaration or general is single:
                continue
            values = solve(general.index, single.index)
            if values is None or general.parameters != single.parameters:
                continue
            if any(int(value) < 0 for value in values.values()):
                continue
            try:
                said = relation("=", member, instantiate(general.body, values))
                expand(said.right, definitions)
            except IllFormed:  # below the base: the recurrence does not say it
                continue
            yield said


def _holds(judge: InstanceJudge, said: Relation) -> bool:
    if expand(said.left, judge.definitions) == expand(said.right, judge.definitions):
        return True
    try:
        outcome = judge.judge_instance(said, (), None).outcome
    except NotExact:
        return False
    return outcome in (Outcome.PROVED, Outcome.PROBABLE, Outcome.DEFINITION)
