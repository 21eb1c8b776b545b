"""The engines of a judge: one that has computed the parts of a statement keeps them for the next.

One engine can be put to many statements where what it finds of one says nothing of another: where nothing is
divided by and no root is taken, which it would remember, and no term but a symbol has a sine.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING

from workbench.engines.inventory.inventory import Inventory, Lookup
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, RandomPoint, ResidueRing, sample
from workbench.engines.polynomial.polynomial_engine import ExactEngine

if TYPE_CHECKING:
    from workbench.engines.jet.sympy_engine import SympyEngine

_SEED = 2020

#: So many indeterminates are at most in a ring that is kept; more make all of its monomials longer.
_MOST = 120

#: So many engines are kept.
_KEPT = 60


class Engines:
    """The engines that are kept, each by what it is about: the identity of the definitions that it holds, and
    of the first engine the symbols, too."""

    def __init__(self) -> None:
        self._first: dict[tuple, ExactEngine] = {}
        self._second: dict[int, SympyEngine] = {}
        self._residues: dict[int, JetEngine] = {}

    def first(self, inventory: Inventory, definitions: Lookup) -> ExactEngine:
        """The first engine, for the symbols of the inventory."""
        if not _is_plain(inventory):
            return ExactEngine(inventory, definitions)
        about = id(definitions), frozenset(inventory.orders.items()), frozenset(inventory.angles)
        if about not in self._first:
            _keep(self._first, about, ExactEngine(inventory, definitions))
        return self._first[about]

    def second(self, inventory: Inventory, definitions: Lookup) -> SympyEngine:
        """The second engine over SymPy's polynomials."""
        from workbench.engines.jet.sympy_engine import SympyEngine

        if not _is_plain(inventory):
            return SympyEngine(inventory, definitions)
        known = self._second.get(id(definitions))
        if known is None or len(known.ring.point) > _MOST:
            _keep(self._second, id(definitions), SympyEngine(None, definitions))
        return self._second[id(definitions)]

    def residues(self, inventory: Inventory, definitions: Lookup) -> JetEngine:
        """The second engine at a random point modulo a prime."""
        ring = ResidueRing()
        if not _is_plain(inventory):
            return JetEngine(PointSource(ring, sample(inventory, ring, Random(_SEED))), definitions)
        if id(definitions) not in self._residues:
            source = PointSource(ring, RandomPoint(ring, Random(_SEED)))
            _keep(self._residues, id(definitions), JetEngine(source, definitions))
        return self._residues[id(definitions)]


def _is_plain(inventory: Inventory) -> bool:
    return not (inventory.reciprocals or inventory.norms or inventory.circles)


def _keep(kept: dict, about: object, engine: object) -> None:
    """Keeps an engine; where there are many, the oldest goes."""
    if len(kept) >= _KEPT:
        del kept[next(iter(kept))]
    kept[about] = engine
