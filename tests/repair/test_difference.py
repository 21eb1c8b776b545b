"""Laws of the difference: its parts are both formulas, nothing differs from itself, formatting is none."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.papers import find_paper
from workbench.repair.as_printed import as_printed
from workbench.repair.difference import difference, tokens_of

ERRATA = [
    (claim.printed.latex, (claim.corrected or claim.reading).latex)
    for claim in find_paper().claims
    if claim.printed.latex and (claim.corrected or claim.reading)
]
PRINTED = sorted({claim.printed.latex for claim in find_paper().claims if claim.printed.latex})
SNIPPETS = st.lists(
    st.sampled_from(
        ["a", "\\omega", "\\dot{", "\\tilde", "{", "}", "_", "^", "2", "\\mathbf", "+", "\\frac", "\\text{vect}", "[", " "]
    ),
    max_size=25,
).map("".join)


def latex(tokens):
    return " ".join(token.latex for token in tokens)


@pytest.mark.parametrize(("printed", "right"), ERRATA)
def test_the_parts_in_a_row_are_both_formulas(printed, right):
    found = difference(printed, right)
    assert tokens_of(found.printed) == tokens_of(printed)
    assert tokens_of(found.proposed) == tokens_of(right)
    entries = found.to_list()
    assert tokens_of(" ".join(e.get("same", e.get("printed")) for e in entries)) == tokens_of(printed)
    assert tokens_of(" ".join(e.get("same", e.get("proposed")) for e in entries)) == tokens_of(right)
    assert found and any("same" not in entry for entry in entries)


@pytest.mark.parametrize("formula", PRINTED)
def test_nothing_differs_from_itself_and_tokens_are_canonical(formula):
    found = difference(formula, formula)
    assert not found
    assert found.highlighted(lambda text: f"<{text}>") == found.proposed
    assert tokens_of(found.proposed) == tokens_of(formula)


@given(SNIPPETS, SNIPPETS)
@settings(max_examples=200, deadline=None)
def test_any_two_texts_have_a_difference(one, other):
    found = difference(one, other)
    assert bool(found) == (tokens_of(one) != tokens_of(other))
    kept = [part.printed if part.same else part.proposed for part in found.parts]
    assert latex(token for tokens in kept for token in tokens) == latex(tokens_of(other))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (r"\left( a + b \right) x", "(a+b)x"),
        (r"\boldsymbol{\omega} \times \mathbf a", r"\bm\omega\times\boldsymbol{a}"),
        (r"x^2_1", "x_{1}^{2}"),
        (r"\dot{\tilde{\omega}}", r"\tilde{\dot\omega}"),
        (r"\text{vect} \Phi", r"\operatorname{vect}{\Phi}"),
        (r"\widetilde{\mathbf{S}}_3", r"\tilde{\mathbf{S}_3}"),
        (r"a \ne b", r"a \neq {b}"),
        (r"x \triangleq y", r"x \stackrel{\text{def}}{=} y"),
    ],
)
def test_formatting_is_no_difference(one, other):
    assert not difference(one, other)


@pytest.mark.parametrize(
    ("one", "other", "shown"),
    [
        ("a + b", "a - b", "a [-+-] {+-+} b"),
        ("a + b", "a + 2b", "a + {+2+} b"),
        (r"\ddot{\omega} x", r"\dddot{\omega} x", r"[-\ddot{\omega}-] {+\dddot{\omega}+} x"),
        ("x^2", "x^3", "x^{ [-2-] {+3+} }"),
        (r"\tilde S t", r"\widetilde{S t}", r"[-\tilde{S}-] {+\widetilde{S+} t {+}+}"),
    ],
)
def test_what_differs_is_marked_in_plain_text(one, other, shown):
    assert str(difference(one, other)).replace(" ", "") == shown.replace(" ", "")


def test_all_in_a_new_accent_is_highlighted():
    found = difference(r"a + \tilde S t + u", r"a + \widetilde{S t} + u")
    assert found.highlighted(lambda text: f"<{text}>") == r"a + \widetilde{<S> <t>} + u"
    assert found.highlighted(lambda text: f"<{text}>", proposed=False) == r"a + <\tilde{S}> t + u"


def test_lines_of_one_formula_are_no_difference():
    one = r"\begin{aligned} a = & [b + c] \\ & + d \end{aligned}"
    assert not difference(one, "a = (b + c) + d")
    assert difference(r"a^{[n]}", r"a^{(n)}")
    assert difference(r"\begin{bmatrix} a & b \end{bmatrix}", r"\begin{bmatrix} a \\ b \end{bmatrix}")


def test_a_proposal_is_spelled_as_the_printed_form():
    claim = next(claim for claim in find_paper().claims if claim.id == "58.det")
    table = claim.notation.symbols
    printed = r"\det \Phi_2 = -(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}})^2"
    canonical = r"\det \Phi_{2} = \left(\omega \times \dot{\omega}\right)^{2}"
    respelled = as_printed(canonical, printed, table, ())
    assert str(difference(printed, respelled)) == str(difference(printed, printed.replace("-", ""))) != ""
    assert as_printed(canonical, r"\mystery", table, ()) == canonical
    assert as_printed(canonical, canonical, table, ()) == canonical
