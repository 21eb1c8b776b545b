"""Values of the symbols of a claim on several motions at several times, all at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, cast
from zlib import crc32

import numpy as np

from workbench.core.names import Name
from workbench.core.terms import Symbol, Term
from workbench.drake.bindings import Bound, alternatives
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.jet.batched_scalars import LaneRing, Lanes
from workbench.engines.jet.components import Value
from workbench.engines.jet.rings import PointSource
from workbench.language.definitions import solve

#: Number of disturbed copies of each time, with each reference moved by its error.
DISTURBED = 2
COPIES = 1 + DISTURBED


@dataclass(frozen=True)
class Bindings:
    """Bound symbols: symbols or patterns such as Φ_n → their bindings."""

    of: Mapping[Symbol, Bound]
    _known: dict[Symbol, tuple[Bound, int] | None] = field(default_factory=dict, compare=False, repr=False)

    def find(self, symbol: Symbol) -> tuple[Bound, int] | None:
        """Returns the binding and the value of its index (0 if it has none), or None."""
        if symbol not in self._known:
            self._known[symbol] = self._find(symbol)
        return self._known[symbol]

    def _find(self, symbol: Symbol) -> tuple[Bound, int] | None:
        exact = self.of.get(symbol)
        if exact is not None:
            return exact, 0
        for pattern, bound in self.of.items():
            if pattern.declaration.name != symbol.declaration.name or pattern.arguments or symbol.arguments:
                continue
            values = solve(pattern.index, symbol.index)
            if values is not None and all(value.is_number for value in values.values()):
                index = next((int(values[name]) for name in bound.variables), 0)
                return bound, index
        return None


def bindings_of(motion: Mapping[Symbol, str]) -> tuple[Bindings, ...]:
    """Returns the bindings of a paper's [motion]: the k-th of several if symbols have alternatives."""
    choices = {symbol: alternatives(text) for symbol, text in motion.items()}
    count = max(map(len, choices.values()), default=0)
    return tuple(
        Bindings({symbol: bounds[min(k, len(bounds) - 1)] for symbol, bounds in choices.items()})
        for k in range(count)
    )


@dataclass(frozen=True)
class BoundFirst:
    """A lookup that hides the definitions of bound symbols: their values come from Drake."""

    definitions: Lookup
    bindings: Bindings
    but_for: frozenset[Name] = frozenset()

    def lookup(self, symbol: Symbol) -> Term | None:
        if symbol.declaration.name not in self.but_for and self.bindings.find(symbol) is not None:
            return None
        return self.definitions.lookup(symbol)


class Motion(Protocol):
    name: str
    samples: tuple[float, ...]
    course: tuple[float, ...]

    def available_bindings(self) -> tuple[str, ...]: ...


class Stage:
    """Motions at times: `places` has one (motion, time) for each sample, with COPIES lanes."""

    def __init__(self, places: Sequence[tuple[Motion, float]]) -> None:
        self.places = tuple(places)
        self._jets: dict[tuple[str, int], list[np.ndarray]] = {}

    def __len__(self) -> int:
        return len(self.places)

    def ring(self) -> LaneRing:
        return LaneRing(len(self), COPIES)

    def jet(self, bound: Bound, index: int, depth: int) -> list[np.ndarray]:
        """Returns derivatives 0 … depth, each an array of the quantity's shape with Lanes for entries."""
        key = (bound.text, index)
        known = self._jets.get(key)
        if known is None or len(known) <= depth:
            known = self._jets[key] = self._assembled(bound, index, depth)
        return known[: depth + 1]

    def _assembled(self, bound: Bound, index: int, depth: int) -> list[np.ndarray]:
        from workbench.drake.bound_jets import bound_jet

        found = [bound_jet(cast(Any, motion), bound, index, depth, time) for motion, time in self.places]
        jets = []
        for k in range(depth + 1):
            random = np.random.default_rng([crc32(bound.text.encode()), index, k])
            values = np.array([jet.values[k] for jet in found])
            errors = np.array([jet.errors[k] for jet in found])
            copies = [values]
            for _ in range(DISTURBED):
                copies.append(values + errors * random.choice((-1.0, 1.0), values.shape))
            lanes = np.moveaxis(np.array(copies), 0, 1).reshape(-1, *values.shape[1:])
            jets.append(_as_lanes(lanes))
        return jets


def _as_lanes(values: np.ndarray) -> np.ndarray:
    array = np.empty(values.shape[1:], dtype=object)
    for place in np.ndindex(array.shape):
        array[place] = Lanes(np.ascontiguousarray(values[(slice(None), *place)]))
    return array


class MotionSource:
    """A source with bound symbols from a stage, and the others free."""

    def __init__(
        self, stage: Stage, bindings: Bindings, free: PointSource, moved_along: int | None = None
    ) -> None:
        self.ring = free.ring
        self._stage, self._bindings, self._free, self._moved_along = stage, bindings, free, moved_along

    def jet(self, symbol: Symbol, depth: int) -> Value:
        found = self._bindings.find(symbol)
        if found is None:
            return self._free.jet(symbol, depth)
        jets = self._stage.jet(*found, depth)
        if symbol.type.dual:
            return Value([x[0] for x in jets], [x[1] for x in jets])
        if symbol.declaration.coordinate and self._moved_along is not None:
            step = [0 * x for x in jets]
            step[0][self._moved_along] = Lanes(1.0)
            return Value(jets, step)
        return Value(jets)

    def _angle(self, angle: Term, value: Lanes | None) -> Lanes:
        if value is not None:
            return value
        assert isinstance(angle, Symbol), "bound"
        found: Lanes = self.jet(angle, 0).re[0].item()
        return found

    def circle(self, angle: Term, value: Lanes | None = None) -> tuple[Any, Any]:
        if isinstance(angle, Symbol) and self._bindings.find(angle) is None:
            return self._free.circle(angle)
        values = self._angle(angle, value).values
        return Lanes(np.cos(values)), Lanes(np.sin(values))

    def circles(self) -> list[Term]:
        return self._free.circles()

    def moved(self, seed: object) -> MotionSource:
        raise NotExact("a partial derivative, on a motion")

    def slopes(self, function: Symbol, degree: int, count: int) -> list[Any]:
        raise NotExact("a function of coordinates, on a motion")

    def along(self, component: int) -> MotionSource:
        return MotionSource(self._stage, self._bindings, self._free.along(component), component)
