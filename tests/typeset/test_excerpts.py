"""Parts of formulas for one line of a table: balanced, with their marks, and without fractions."""

from __future__ import annotations

import re

import pytest
from formulas import formulas
from hypothesis import given, settings

from workbench.source.typeset.differences import difference
from workbench.source.typeset.excerpts import excerpts, in_one_line, left_side
from workbench.source.typeset.latex_atoms import atoms_of


@given(formulas, formulas)
@settings(max_examples=100)
def test_excerpts_are_balanced_and_keep_a_mark(old, new):
    found = difference(old, new)
    if found is None or not (found.marked_before or found.marked_after):
        return
    cut = excerpts(old, new, found.marked_before, found.marked_after, 6)
    for latex, marked in cut or ():
        atoms = atoms_of(latex)
        assert all(atoms[place].leaf for place in marked)
    assert cut is None or cut[0][1] or cut[1][1]


@given(formulas)
@settings(max_examples=60)
def test_one_line_has_no_fraction_and_the_same_marks(latex):
    leaves = frozenset(place for place, atom in enumerate(atoms_of(latex)) if atom.leaf)
    shown, marked = in_one_line(latex, leaves)
    assert not re.search(r"\\[dt]?frac", shown)
    assert len(marked) == len(leaves)


@pytest.mark.parametrize(
    ("latex", "side"), [(r"\det \Phi_4 = 0", r"\det \Phi _{ 4 }"), ("a + b", None), (r"x \neq 0", "x")]
)
def test_left_side_stands_before_the_first_relation(latex, side):
    assert left_side(latex) == side
