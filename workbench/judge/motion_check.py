"""A relation on the motions that Drake made: numbers that can veto a proof."""

from __future__ import annotations

from collections.abc import Mapping
from random import Random
from typing import Any

import numpy as np

from workbench.judge.components import Value
from workbench.judge.inventory import Inventory, Lookup
from workbench.judge.jets import JetEngine
from workbench.judge.rings import FloatRing, PointSource, sample
from workbench.judge.verdict import Evidence
from workbench.language.terms import Relation, Symbol

#: Residual over scale that rounding can explain at these orders; wrong formulas leave residuals near 1.
TOLERANCE = 1e-9

#: Drake differentiates its Expressions this often at most.
HIGHEST_ORDER = 5

VETO = "residual above tolerance"


class _FloatRing(FloatRing):
    def random(self, random: Random) -> float:
        return random.uniform(-1, 1)


class MotionSource:
    """Bound symbols from a motion at one time, the others free."""

    def __init__(
        self,
        motion: Any,
        time: float,
        bindings: Mapping[Symbol, str],
        free: PointSource,
        moved_along: int | None = None,
    ) -> None:
        self.ring = free.ring
        self._motion, self._time, self._bindings, self._free = motion, time, bindings, free
        self._moved_along = moved_along

    def jet(self, symbol: Symbol, depth: int) -> Value:
        binding = self._bindings.get(symbol)
        if binding is None:
            return self._free.jet(symbol, depth)
        jets = self._motion.jet(binding, depth, self._time).astype(object)
        if symbol.type.dual:
            return Value(list(jets[:, 0]), list(jets[:, 1]))
        if symbol.declaration.coordinate and self._moved_along is not None:
            step = np.zeros_like(jets)
            step[0, self._moved_along] = 1.0
            return Value(list(jets), list(step))
        return Value(list(jets))

    def circle(self, angle: Symbol) -> tuple[float, float]:
        if angle not in self._bindings:
            return self._free.circle(angle)
        value = float(np.ravel(self._motion.jet(self._bindings[angle], 0, self._time))[0])
        return float(np.cos(value)), float(np.sin(value))

    def along(self, component: int) -> MotionSource:
        free = self._free.along(component)
        return MotionSource(self._motion, self._time, self._bindings, free, component)


def check_on_motions(
    relation: Relation, inventory: Inventory, definitions: Lookup, bindings: Mapping[Symbol, str]
) -> Evidence | None:
    """The largest residual over scale on all motions with the bound symbols; None where nothing is bound.

    Scale: the largest component of either side, at least 1. The outcome is VETO above TOLERANCE.
    """
    used = {symbol: bindings[symbol] for symbol in inventory.orders if symbol in bindings}
    if not used or max(inventory.orders[symbol] for symbol in used) > HIGHEST_ORDER:
        return None
    from workbench.drake.motions import reference_motions

    worst, scale, samples, names = 0.0, 0.0, 0, []
    ring, random = _FloatRing(), Random(1)
    for motion in reference_motions():
        if not {motion_name for motion_name in used.values()} <= set(motion.available_bindings()):
            continue
        names.append(motion.name)
        for time in motion.samples:
            free = PointSource(ring, sample(inventory, ring, random, lambda _: True))
            engine = JetEngine(MotionSource(motion, time, used, free), definitions)
            try:
                sides = [abs(x) for t in (relation.left, relation.right) for x in engine.components(t)]
                residual = max(abs(x) for x in engine.differences(relation.left, relation.right))
            except ZeroDivisionError:
                continue
            size = max(1.0, *sides)
            samples += 1
            worst, scale = max(worst, residual / size), max(scale, size)
    if not samples:
        return None
    figures = {
        "motions": names,
        "samples": samples,
        "bound": sorted(used.values()),
        "free": sum(symbol not in used for symbol in inventory.orders),
        "residual_below": _decade(worst),
        "scale": float(f"{scale:.2g}"),
        "tolerance": TOLERANCE,
    }
    outcome = "residual within tolerance" if worst <= TOLERANCE else VETO
    return Evidence("Drake reference motions", outcome, figures)


def _decade(residual: float) -> float:
    """The next power of ten, at least 1e-16: the digits below are noise and differ between machines."""
    return float(f"1e{max(-16, int(np.ceil(np.log10(residual))))}") if residual > 0 else 1e-16
