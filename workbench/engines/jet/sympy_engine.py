"""The jet engine over SymPy's polynomials."""

from __future__ import annotations

from workbench.core.terms import Relation
from workbench.engines.inventory import Lookup
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource
from workbench.engines.jet.sympy_gate import PolyElement
from workbench.engines.jet.sympy_ring import SympyRing


class SympyEngine(JetEngine):
    """Evaluates terms as ratios of polynomials in the parameters of the symbols."""

    def __init__(self, inventory: Inventory | None, definitions: Lookup) -> None:
        self.ring = SympyRing(inventory)
        super().__init__(PointSource(self.ring, self.ring.point), definitions)

    def residuals(self, relation: Relation) -> list[PolyElement]:
        """Returns the numerators of left − right, component by component."""
        return self.ring.tops(self.differences(relation.left, relation.right))
