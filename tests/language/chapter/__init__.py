"""The formulas of the chapter in their intended form, by equation number, with the symbols of each part.

Left out, because they are no identities: (34), (71), (73), (78 but for its two conditions),
(82), (84), (85) speak of sets and maps, (81) is an infinite series, (102) a minimum over all points.
Chains with dots are given for a fixed number of bodies.
"""

from tests.language.chapter.chains import CHAIN, MANIPULATOR
from tests.language.chapter.dual import DUAL
from tests.language.chapter.parts import Part
from tests.language.chapter.real import REAL

__all__ = ["PARTS", "Part"]

PARTS = {"real": REAL, "dual": DUAL, "chain": CHAIN, "manipulator": MANIPULATOR}
