"""Evaluation of statements on a stage: residuals compared with the errors of the references."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from random import Random

import numpy as np

from workbench.core.terms import (
    Conjunction,
    Equivalence,
    Extremum,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
)
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import SPHERES, Parameter, parts
from workbench.engines.jet.batched_scalars import Lanes
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, sample
from workbench.prover.motions.motion_source import COPIES, Bindings, BoundFirst, MotionSource, Stage

#: Safety factor: the errors of many references add up, and two disturbances see a part of that.
SAFETY = 16.0
EPSILON = float(np.finfo(float).eps)

#: Relative error above which nothing can be concluded.
USELESS = 1e-3

#: Change of a premise per unit of an unknown that is due to rounding alone.
NOTHING = 1e-9

Array = np.ndarray


@dataclass(frozen=True)
class Truth:
    """One statement on a stage, sample by sample, shape (samples,).

    residual, error, size: the largest component of left − right, the part of it that the errors of the
    references explain, and the largest component of either side (of equations; 0 elsewhere).
    holds: true as far as the errors allow a decision.   told: True if there is a decision.
    """

    residual: Array
    error: Array
    size: Array
    holds: Array
    told: Array

    def both(self, other: Truth) -> Truth:
        worse = self.relative >= other.relative
        return Truth(
            np.where(worse, self.residual, other.residual),
            np.where(worse, self.error, other.error),
            np.where(worse, self.size, other.size),
            holds=self.holds & other.holds,
            told=self.told & other.told,
        )

    @property
    def relative(self) -> Array:
        """The residual over the size of the sides; over 1 if both vanish within the errors."""
        relative: Array = self.residual / self.scale
        return relative

    @property
    def scale(self) -> Array:
        return np.where(self.size > self.error / USELESS, np.maximum(self.size, EPSILON), 1.0)


class Evaluation:
    """Evaluates statements on a stage; use `Evaluation.truth`."""

    def __init__(self, stage: Stage, bindings: Bindings, lookup: BoundFirst, inventory: Inventory) -> None:
        self._stage, self._bindings, self._lookup, self._inventory = stage, bindings, lookup, inventory
        self._point = sample(inventory, stage.ring(), Random(1))
        self._engine = self._engine_at(self._point)

    def truth(self, statement: Statement) -> Truth:
        """Returns the truth of the statement. Raises NotExact if it has no numerical value, as an undefined
        operator."""
        with np.errstate(all="ignore"):
            return self._truth(statement)

    def suppose(self, premises: Sequence[Statement]) -> Array:
        """Sets free symbols to values that satisfy the premises, if these are linear; returns where they
        hold."""
        equations = [r for p in premises for r in _equations(p)]
        unknowns = [p for s in self._inventory.orders for p in self._unknowns(s, equations)]
        with np.errstate(all="ignore"):
            if unknowns:
                self._solve(equations, unknowns)
            held = np.ones(len(self._stage), dtype=bool)
            for premise in premises:
                truth = self._truth(premise)
                held &= truth.holds & truth.told
        return held

    def _truth(self, statement: Statement) -> Truth:
        match statement:
            case Relation(operator="≈"):
                raise NotExact("what is small on a motion")
            case Relation():
                return self._relation(statement)
            case Conjunction(parts=conjuncts):
                total = self._truth(conjuncts[0])
                for part in conjuncts[1:]:
                    total = total.both(self._truth(part))
                return total
            case Implication(left=left, right=right):
                given, then = self._truth(left), self._truth(right)
                return replace(
                    then, holds=then.holds | ~given.holds, told=then.told & given.told & given.holds
                )
            case Equivalence(left=left, right=right):
                one, other = self._truth(left), self._truth(right)
                met = one.holds | other.holds
                return replace(one, holds=one.holds == other.holds, told=one.told & other.told & met)
            case Extremum(least=least, body=body, value=value):
                return self._bound(*((body, value) if least else (value, body)))
        raise TypeError(f"no truth of a {type(statement).__name__}")

    def _bound(self, more: Term, less: Term) -> Truth:
        """Returns the truth of more ≥ less, at the varying point of a minimum or maximum."""
        truth = self._relation(Relation("=", more, less))
        over, under = (self._lanes(self._engine.components(side))[0, :, 0] for side in (more, less))
        beaten = np.maximum(under - over, 0.0)
        return replace(truth, residual=beaten, holds=beaten <= truth.error)

    def _relation(self, relation: Relation) -> Truth:
        differences = self._lanes(self._engine.differences(relation.left, relation.right))
        sides = [self._lanes(self._engine.components(side)) for side in (relation.left, relation.right)]
        size = np.max(np.abs(np.concatenate(sides))[:, :, 0], axis=0)
        residual = np.max(np.abs(differences[:, :, 0]), axis=0)
        disturbed = np.max(np.abs(differences - differences[:, :, :1]), axis=(0, 2))
        error = SAFETY * disturbed + 64 * EPSILON * np.maximum(size, 1.0)
        seen = np.isfinite(residual) & np.isfinite(error)
        truth = Truth(residual, error, size, residual <= error, seen)
        if relation.operator == "=":
            return replace(truth, told=seen & (error < USELESS * truth.scale))
        apart = ~truth.holds
        nothing = np.zeros_like(residual)
        return Truth(nothing, nothing, nothing, apart, seen & apart)

    def _lanes(self, components: Sequence[Lanes | float]) -> Array:
        """Returns an array of shape (components, samples, copies)."""
        count = len(self._stage) * COPIES
        values = [c.values if isinstance(c, Lanes) else c for c in components]
        return np.array([np.broadcast_to(v, count) for v in values], dtype=float).reshape(
            -1, count // COPIES, COPIES
        )

    def _engine_at(self, point: dict[Parameter, Lanes]) -> JetEngine:
        free = PointSource(self._stage.ring(), point)
        return JetEngine(MotionSource(self._stage, self._bindings, free), self._lookup)

    def _unknowns(self, symbol: Symbol, equations: Sequence[Relation]) -> list[Parameter]:
        """Returns the parameters of an undifferentiated free symbol in the equations, else []."""
        if self._bindings.find(symbol) is not None or self._inventory.orders[symbol]:
            return []
        if symbol.declaration.coordinate or symbol in self._inventory.angles:
            return []
        if not any(symbol in self._leaves(side) for r in equations for side in (r.left, r.right)):
            return []
        found = parts(symbol, 0)
        if any(part in SPHERES for part, _, _ in found):
            return []
        return [Parameter(symbol, part, 0, i) for part, count, _ in found for i in range(count)]

    def _leaves(self, term: Term) -> set[Symbol]:
        leaves: set[Symbol] = set()
        pending = [term]
        while pending:
            here = pending.pop()
            body = self._lookup.lookup(here) if isinstance(here, Symbol) else None
            if isinstance(here, Symbol) and body is None:
                leaves.add(here)
            pending += here.children if body is None else [body]
        return leaves

    def _solve(self, equations: Sequence[Relation], unknowns: Sequence[Parameter]) -> None:
        """Performs one step of Newton's method from a random point. For equations that are affine in the
        unknowns it ends at the nearest solution."""
        here = self._residuals(self._point, equations)
        columns = []
        for unknown in unknowns:
            moved = {**self._point, unknown: self._point[unknown] + 1.0}
            columns.append(self._residuals(moved, equations) - here)
        matrix = np.moveaxis(np.array(columns), 0, -1)  # (lanes, equations, unknowns)
        usable = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(here).all(axis=1)
        matrix[usable] *= np.abs(matrix[usable]).max(axis=(1, 2), keepdims=True) > NOTHING
        step = np.full((len(here), len(unknowns)), np.nan)
        if usable.any():
            step[usable] = (-np.linalg.pinv(matrix[usable]) @ here[usable][:, :, None])[:, :, 0]
        for i, unknown in enumerate(unknowns):
            self._point[unknown] = self._point[unknown] + Lanes(step[:, i])
        self._engine = self._engine_at(self._point)

    def _residuals(self, point: dict[Parameter, Lanes], equations: Sequence[Relation]) -> Array:
        """Returns left − right of all equations, shape (lanes, components)."""
        engine = self._engine_at(point)
        found = [self._lanes(engine.differences(r.left, r.right)) for r in equations]
        total = np.concatenate(found)
        return total.reshape(len(total), -1).T


def _equations(statement: Statement) -> list[Relation]:
    match statement:
        case Relation(operator="="):
            return [statement]
        case Conjunction(parts=conjuncts):
            return [r for part in conjuncts for r in _equations(part)]
    return []
