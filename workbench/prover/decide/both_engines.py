"""Caches of engines: an engine that has evaluated parts of a statement serves the next statement.

An engine can serve many statements if the results for one do not affect another: if the statement has no
division and no root, which the engine would record, and only symbols have sines.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, Any

from workbench.engines.inventory import Lookup
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, RandomPoint, ResidueRing, sample
from workbench.engines.polynomial.polynomial_engine import ExactEngine

if TYPE_CHECKING:
    from workbench.engines.jet.sympy_engine import SympyEngine

_SEED = 2020

#: Largest number of indeterminates of a cached ring; more would lengthen all of its monomials.
_MOST = 120

#: Number of cached engines.
_KEPT = 60


class Engines:
    """The cached engines, by the identity of the definitions; for the polynomial engine also by the
    symbols."""

    def __init__(self) -> None:
        self._first: dict[tuple[object, ...], ExactEngine] = {}
        self._second: dict[int, SympyEngine] = {}
        self._residues: dict[int, JetEngine] = {}

    def first(self, inventory: Inventory, definitions: Lookup) -> ExactEngine:
        """Returns the polynomial engine for the symbols of the inventory."""
        if not _is_plain(inventory):
            return ExactEngine(inventory, definitions)
        about = id(definitions), frozenset(inventory.orders.items()), frozenset(inventory.angles)
        if about not in self._first:
            _keep(self._first, about, ExactEngine(inventory, definitions))
        return self._first[about]

    def second(self, inventory: Inventory, definitions: Lookup) -> SympyEngine:
        """Returns the jet engine over SymPy's polynomials."""
        from workbench.engines.jet.sympy_engine import SympyEngine

        if not _is_plain(inventory):
            return SympyEngine(inventory, definitions)
        known = self._second.get(id(definitions))
        if known is None or len(known.ring.point) > _MOST:
            _keep(self._second, id(definitions), SympyEngine(None, definitions))
        return self._second[id(definitions)]

    def residues(self, inventory: Inventory, definitions: Lookup) -> JetEngine:
        """Returns the jet engine at a random point modulo a prime."""
        ring = ResidueRing()
        if not _is_plain(inventory):
            return JetEngine(PointSource(ring, sample(inventory, ring, Random(_SEED))), definitions)
        if id(definitions) not in self._residues:
            source = PointSource(ring, RandomPoint(ring, Random(_SEED)))
            _keep(self._residues, id(definitions), JetEngine(source, definitions))
        return self._residues[id(definitions)]


def _is_plain(inventory: Inventory) -> bool:
    return not (inventory.reciprocals or inventory.norms or inventory.circles)


def _keep(kept: dict[Any, Any], about: object, engine: object) -> None:
    """Stores an engine; removes the oldest one if there are too many."""
    if len(kept) >= _KEPT:
        del kept[next(iter(kept))]
    kept[about] = engine
