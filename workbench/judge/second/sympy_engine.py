"""The second engine over SymPy's polynomials."""

from __future__ import annotations

from workbench.judge.second.jets import JetEngine
from workbench.judge.second.rings import PointSource
from workbench.judge.second.sympy_gate import PolyElement
from workbench.judge.second.sympy_ring import SympyRing
from workbench.judge.subject.inventory import Inventory, Lookup
from workbench.language.typed.terms import Relation


class SympyEngine(JetEngine):
    """Evaluates terms as ratios of polynomials in all that the symbols depend on."""

    def __init__(self, inventory: Inventory | None, definitions: Lookup) -> None:
        self.ring = SympyRing(inventory)
        super().__init__(PointSource(self.ring, self.ring.point), definitions)

    def residuals(self, relation: Relation) -> list[PolyElement]:
        """The numerators of left − right, component by component."""
        return self.ring.tops(self.differences(relation.left, relation.right))
