"""Laws of the difference: none between equals; the one change made is the one found, at its place."""

import pytest
from formulas import TYPICAL, formulas
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from workbench.source.typeset.differences import Change, difference
from workbench.source.typeset.latex_atoms import atoms_of, latex_of


@pytest.mark.parametrize("latex", TYPICAL)
def test_a_formula_does_not_differ_from_itself(latex):
    found = difference(latex, latex)
    assert found.changes == ()
    assert not found.rewritten


@pytest.mark.parametrize("latex", TYPICAL)
def test_final_punctuation_is_no_difference(latex):
    assert difference(latex, latex + ".").changes == ()


@given(formulas, st.data())
@settings(max_examples=150)
def test_a_replaced_leaf_is_found_and_marked(latex, data):
    atoms = atoms_of(latex)
    leaves = [i for i, atom in enumerate(atoms) if atom.leaf]
    assume(len(leaves) >= 3)
    place = data.draw(st.sampled_from(leaves))
    changed = list(atoms)
    changed[place] = atoms_of(r"\kappa")[0]
    found = difference(latex_of(atoms), latex_of(changed))
    assert found.marked_before == found.marked_after == {place}
    assert len(found.changes) == 1
    assert r"\kappa" in found.changes[0].after
    assert atoms[place].latex in found.changes[0].before


@given(formulas, formulas)
@settings(max_examples=150)
def test_only_leaves_are_marked_and_fragments_can_be_typeset(first, second):
    found = difference(first, second)
    for latex, marked in ((first, found.marked_before), (second, found.marked_after)):
        atoms = atoms_of(latex)
        assert all(atoms[i].leaf for i in marked)
    for change in found.changes:
        assert change.before or change.after


EXAMPLES = [
    (r"a - b", r"a + b", Change("sign", "-", "+")),
    (r"\det \Phi = -(x)^2", r"\det \Phi = (x)^2", Change("sign", "-", None)),
    (r"27 x", r"26 x", Change("number", "27", "26")),
    (
        r"\dot{\omega} + a",
        r"\ddot{\omega} + a",
        Change("mark", r"\dot{\omega}", r"\ddot{\omega}"),
    ),
    (r"\tilde{\omega} + a", r"\omega + a", Change("mark", r"\tilde{\omega}", r"\omega")),
    (
        r"\boldsymbol{\omega} + a",
        r"\rho + a",
        Change("symbol", r"\boldsymbol{\omega}", r"\rho"),
    ),
    (r"(a)(b)", r"(a) \cdot (b)", Change("operator", None, r"\cdot")),
    (r"a + b + c", r"a + c", Change("part", "+ b", None)),
    (r"a + c", r"a + b + c", Change("part", None, "+ b")),
    (r"x + y", r"x^2 + y", Change("exponent", "x", "x ^{ 2 }")),
    (r"a - S t + u", r"a - \widetilde{S t} + u", Change("mark", "S t", r"\widetilde{ S t }")),
    (r"\frac{1}{2} a", r"\frac{3}{2} a", Change("number", "1", "3")),
    (r"a x^2 + y", r"a x^3 + y", Change("exponent", "x ^{ 2 }", "x ^{ 3 }")),
    (r"a - \phi_n", r"a - \Phi_n", Change("symbol", r"\phi _{ n }", r"\Phi _{ n }")),
    (
        r"x \left[ a + b \right] + y",
        r"x \left[ a + b \right) + y",
        Change("bracket", "]", ")"),
    ),
    (r"a + x", r"a + x_c", Change("index", "x", "x _{ c }")),
    (
        r"\tilde{S}_3 t_3 + a + b",
        r"\widetilde{S_3 t_3} + a + b",
        Change("mark", r"\tilde{S} _{ 3 } t _{ 3 }", r"\widetilde{ S _{ 3 } t _{ 3 } }"),
    ),
]


@pytest.mark.parametrize(("before", "after", "change"), EXAMPLES)
def test_examples(before, after, change):
    assert difference(before, after).changes == (change,)


def test_bold_letters_count_as_plain_ones():
    assert difference(r"\boldsymbol{\omega} + 1", r"\omega + 2").changes[0].kind == "number"
    assert len(difference(r"\boldsymbol{\omega} + 1", r"\omega + 2").changes) == 1


def test_bold_letters_count_if_nothing_else_differs():
    change = difference(r"\boldsymbol{\omega} + 1", r"\omega + 1").changes[0]
    assert (change.before, change.after) == (r"\boldsymbol{\omega}", r"\omega")


def test_formulas_without_likeness_are_called_rewritten():
    assert difference(r"a + b + c", r"\rho \times \omega = 0").rewritten


def test_formulas_without_atoms_have_no_difference():
    assert difference(r"\mystery", "a") is None
