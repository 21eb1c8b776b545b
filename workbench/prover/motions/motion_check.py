"""Evaluation of a statement on Drake's motions: it can veto a proof, and shows the effect of an error."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Protocol, cast

import numpy as np

from workbench.core.codes.motion_codes import MotionCode
from workbench.core.integer_instances import instantiate
from workbench.core.names import Name
from workbench.core.operations import GRADIENTS
from workbench.core.reasons import Reason, reason_of
from workbench.core.terms import (
    Conjunction,
    Equivalence,
    Extremum,
    IllFormed,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
    heads_in,
)
from workbench.core.verdict import Evidence
from workbench.drake.bindings import Bound
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.inventory import Inventory, take_inventory
from workbench.prover.motions.motion_source import Bindings, BoundFirst, Motion, Stage
from workbench.prover.motions.statements_on_motions import Evaluation, Truth

METHOD = "Drake reference motions"
HOLDS, PARTS = "residual within the error", "the sides part"

#: Limit on the order of derivatives, including those of the bindings: beyond it expressions and errors grow
#: too large.
HIGHEST_ORDER = 5

#: Number of members of a family that are evaluated, the lowest ones.
INSTANCES = 3


class Ranges(Protocol):
    def assignments(self) -> Iterator[dict[str, int]]: ...


@dataclass(frozen=True)
class Subject:
    """A statement with its premises, the ranges of its integers, and the bindings of its symbols."""

    statement: Statement
    premises: tuple[Statement, ...]
    orders: Ranges | None
    definitions: Lookup
    bindings: tuple[Bindings, ...]
    motions: tuple[Motion, ...]


@dataclass(frozen=True)
class Witness:
    """The result on the motions. `evidence`: None if nothing was tested, with the `reason`.   vetoed: an
    instance does not hold."""

    evidence: Evidence | None
    reason: Reason | None = None
    vetoed: bool = False


def witness(*subjects: Subject, course: bool = False) -> Witness:
    """Evaluates the instances of the statements on all motions that have their quantities.

    course: also record the residual over time, on the first of the motions.
    """
    reasons: list[Reason] = []
    seen: list[_Seen] = []
    for subject in subjects:
        found = list(_instances(subject))
        seen += [instance for instance in found if isinstance(instance, _Seen)]
        reasons += [reason for reason in found if isinstance(reason, Reason)]
    if not seen:
        return Witness(
            None, next((r for r in reasons if r.code is not MotionCode.ALGEBRA), MotionCode.ALGEBRA())
        )
    return _told(seen, course)


def _instances(subject: Subject) -> Iterator[_Seen | Reason]:
    """Yields the lowest instances that can be evaluated, or the reason why one cannot."""
    told = failed = 0
    try:
        for values in _spread(subject.orders):
            found = _instance(subject, values)
            yield found
            told += isinstance(found, _Seen)
            failed += isinstance(found, Reason)
            if told == INSTANCES or failed > 2 * INSTANCES:
                return
    except (NotExact, IllFormed) as outside:
        yield reason_of(outside)


def _spread(orders: Ranges | None) -> list[dict[str, int]]:
    """Returns the values of the integers, beginning with those that grow together, m = n = 1, 2, 3."""
    if orders is None:
        return [{}]
    rows = list(orders.assignments())
    values = {name: sorted({row[name] for row in rows}) for name in rows[0]}

    def apart(row: dict[str, int]) -> bool:
        """True if an integer is not as far up its range as the others, nor at its end."""
        places = [values[name].index(value) for name, value in row.items()]
        top = max(places, default=0)
        return any(p != min(top, len(values[n]) - 1) for n, p in zip(row, places, strict=True))

    return sorted(rows, key=apart)


@dataclass(frozen=True)
class _Seen:
    """One instance on its stage."""

    values: dict[str, int]
    stage: Stage
    truth: Truth
    used: np.ndarray
    case: _Case

    @property
    def fails(self) -> bool:
        return bool(np.any(self.used & ~self.truth.holds))


@dataclass(frozen=True)
class _Case:
    """One instance with its premises and the meaning of its symbols."""

    statement: Statement
    premises: tuple[Statement, ...]
    lookup: BoundFirst
    inventory: Inventory
    bindings: Bindings

    def on(self, stage: Stage) -> tuple[Truth, np.ndarray]:
        """Returns the statement's truth, and where its premises hold and it can be evaluated."""
        evaluation = Evaluation(stage, self.bindings, self.lookup, self.inventory)
        held = evaluation.suppose(self.premises)
        truth = evaluation.truth(self.statement)
        return truth, held & truth.told


def _instance(subject: Subject, values: dict[str, int]) -> _Seen | Reason:
    """Returns the result of one instance on the motions, or the reason why there is none."""
    try:
        statement, *premises = (instantiate(s, values) for s in (subject.statement, *subject.premises))
    except (NotExact, IllFormed) as outside:
        return reason_of(outside)
    given, statement = _split(statement)
    reason = MotionCode.ALGEBRA()
    for bindings in subject.bindings:
        case = _case(statement, (*premises, *given), subject.definitions, bindings)
        used = [(s, k) for s, k in case.inventory.orders.items() if bindings.find(s) is not None]
        if not used:
            continue
        if _same(case):
            return MotionCode.NO_QUANTITY()
        if max(_order(bindings, s, k) for s, k in used) > HIGHEST_ORDER:
            return MotionCode.TOO_HIGH_AN_ORDER()
        needed = {name for s, _ in used for name in _bound(bindings, s)[0].needs}
        motions = tuple(m for m in subject.motions if needed <= set(m.available_bindings()))
        if not motions:
            return MotionCode.NO_MOTION_HAS(quantities=", ".join(sorted(needed)))
        stage = _stage(motions)
        truth, seen = case.on(stage)
        if seen.any():
            return _Seen(values, stage, truth, seen, case)
        reason = MotionCode.PREMISES_NOT_MET()
    return reason


def _split(statement: Statement) -> tuple[tuple[Statement, ...], Statement]:
    """Returns the premise and the conclusion of an implication; no premise for other statements."""
    if isinstance(statement, Implication):
        return (statement.left,), statement.right
    return (), statement


def _case(
    statement: Statement, premises: tuple[Statement, ...], definitions: Lookup, bindings: Bindings
) -> _Case:
    sides = [side for s in (statement, *premises) for r in relations(s) for side in (r.left, r.right)]
    lookup = BoundFirst(definitions, bindings)
    if not all(GRADIENTS.isdisjoint(heads_in(side)) for side in sides):
        names = {s.declaration.name for side in sides for s in side.symbols()}
        fields = frozenset(n for n in names if _is_field(n, sides, definitions))
        lookup = replace(lookup, but_for=fields)
    return _Case(statement, premises, lookup, take_inventory(sides, lookup), bindings)


def _is_field(name: Name, sides: Sequence[Term], definitions: Lookup) -> bool:
    """True if a symbol of this name is defined by means of the coordinate."""
    pending: list[Term] = [t for side in sides for t in side.symbols() if t.declaration.name == name]
    first = True
    while pending:
        here = pending.pop()
        if isinstance(here, Symbol):
            if here.declaration.coordinate and not first:
                return True
            body = definitions.lookup(here)
            pending += [] if body is None else [body]
        pending += here.children
        first = False
    return False


def relations(statement: Statement) -> Iterator[Relation]:
    match statement:
        case Relation():
            yield statement
        case Conjunction(parts=parts):
            for part in parts:
                yield from relations(part)
        case Implication() | Equivalence():
            yield from relations(statement.left)
            yield from relations(statement.right)
        case Extremum(body=body, value=value):
            yield Relation("=", body, value)


def _same(case: _Case) -> bool:
    """True for an equation that repeats the definition of an unbound symbol."""
    match case.statement:
        case Relation(operator="=", left=Symbol() as left, right=right):
            body = case.lookup.lookup(left)
            return body is not None and body == right
    return False


def _bound(bindings: Bindings, symbol: Symbol) -> tuple[Bound, int]:
    found = bindings.find(symbol)
    assert found is not None, "a bound symbol"
    return found


def _order(bindings: Bindings, symbol: Symbol, depth: int) -> int:
    bound, index = _bound(bindings, symbol)
    return depth + bound.order(index)


@lru_cache(maxsize=32)
def _stage(motions: tuple[Motion, ...]) -> Stage:
    return Stage([(motion, time) for motion in motions for time in motion.samples])


@lru_cache(maxsize=32)
def _course(motion: Any) -> Stage:
    return Stage([(motion, time) for time in motion.course])


def _told(seen: Sequence[_Seen], course: bool) -> Witness:
    worst = max(seen, key=lambda s: (s.fails, float(np.max(np.where(s.used, s.truth.relative, 0.0)))))
    fails = worst.fails
    truth, used = worst.truth, worst.used
    bound = {
        _bound(worst.case.bindings, symbol)[0].text
        for s in seen
        for symbol in s.case.inventory.orders
        if s.case.bindings.find(symbol) is not None
    }
    figures: dict[str, Any] = {
        "motions": _motions(seen),
        "samples": int(sum(s.used.sum() for s in seen)),
        "bound": sorted(bound),
    }
    if seen[0].values:
        figures["instances"] = [", ".join(f"{n} = {v}" for n, v in s.values.items()) for s in seen]
    relative = np.where(used, truth.relative, 0.0)
    allowed = np.where(used, truth.error / truth.scale, 0.0)
    if fails:
        place = int(np.argmax(relative))
        motion, time = worst.stage.places[place]
        figures |= {"motion": motion.name, "time": time, "residual": figure(relative[place])}
        if worst.values:
            figures["at"] = ", ".join(f"{n} = {v}" for n, v in worst.values.items())
        figures["error_below"] = figure(float(allowed[place]), decade=True)
    else:
        figures["residuals_below"], figures["errors_below"] = _by_motion(seen)
    if course:
        figures["course"] = _over_time(worst)
    return Witness(Evidence(METHOD, PARTS if fails else HOLDS, figures), vetoed=fails)


def _motions(seen: Sequence[_Seen]) -> list[str]:
    """Returns the names of the motions on which anything was evaluated."""
    names = (m.name for s in seen for (m, _), used in zip(s.stage.places, s.used, strict=True) if used)
    return list(dict.fromkeys(names))


def _by_motion(seen: Sequence[_Seen]) -> tuple[list[float], list[float]]:
    """Returns the largest relative residual on each motion, and the largest that errors explain."""
    worst = {name: [0.0, 0.0] for name in _motions(seen)}
    for instance in seen:
        truth = instance.truth
        figures = zip(
            instance.stage.places, instance.used, truth.relative, truth.error / truth.scale, strict=True
        )
        for (motion, _), used, residual, error in figures:
            if used:
                known = worst[motion.name]
                known[:] = max(known[0], float(residual)), max(known[1], float(error))
    lowest, highest = ([figure(pair[i], decade=True) for pair in worst.values()] for i in range(2))
    return lowest, highest


def _over_time(seen: _Seen) -> dict[str, Any] | None:
    """Returns the relative residual on the first motion; None at times without a value."""
    motion = next(m for (m, _), used in zip(seen.stage.places, seen.used, strict=True) if used)
    stage = _course(cast(Hashable, motion))
    truth, used = seen.case.on(stage)
    relative = [figure(float(r), decade=bool(h)) for r, h in zip(truth.relative, truth.holds, strict=True)]
    residuals = [r if u else None for r, u in zip(relative, used, strict=True)]
    return {"motion": motion.name, "times": [time for _, time in stage.places], "residuals": residuals}


def figure(value: float, decade: bool = False) -> float:
    """Returns two digits; or, for a decade, the next power of ten, at least 1e-16, since further digits are
    noise."""
    if decade:
        return float(f"1e{max(-16, int(np.ceil(np.log10(value))))}") if value > 0 else 1e-16
    return float(f"{value:.2g}")
