"""Other coefficients for the addends of an equation, wherever they stand: the equation, or none."""

from fractions import Fraction
from itertools import islice, product

import pytest

from workbench.core.terms import Relation
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.repair.terms.coefficients import Scaling, scaled
from workbench.repair.terms.linear_places import addend_places
from workbench.repair.terms.subterm_positions import subterm

KINDS = {**dict.fromkeys("abcdef", "scalar"), **dict.fromkeys("uvw", "vector"), "T": "tensor"}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()})
FORMULAS = [
    "a = b + c - d",
    "a = b + [c - (d + e)]",
    "a = b (c + d (e - f)) - (b - (c - d))",
    r"u = T (v + w) - \frac{v - (w + u)}{a}",
    r"u = T [\dot w - v \times w] + w \times T w",
    r"u = \dot v - w \times v - [T (\dot w - u \times w) + w \times T w]",
    r"u = -(v \times (w - u) + (T - a \mathbf{I}) v)",
    r"u = \frac{d}{dt} (a v - (b + c) w) + (T + (T - T^T)) v",
]


@pytest.mark.parametrize("formula", FORMULAS)
def test_addends_scale_wherever_they_stand(formula: str) -> None:
    (relation,) = read(formula, TABLE)
    made = []
    for chosen in addend_places(relation.right):
        for factors in islice(product((0, -1, 2), repeat=len(chosen)), 729):
            places = [(1, *place) for place in chosen]
            known = Scaling(tuple(zip(places, map(Fraction, factors), strict=True)))
            made.append(scaled(relation, known))
            if set(factors) == {2} and made[-1] is not None:
                assert made[-1].left == relation.left
                assert subterm(made[-1], (1,)) != relation.right
    assert any(isinstance(each, Relation) for each in made)
