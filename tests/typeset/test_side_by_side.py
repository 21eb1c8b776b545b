"""Laws of two formulas side by side: the parts are both formulas, nothing differs from itself, formatting is
no difference."""

from __future__ import annotations

import pytest
from formulas import formulas
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.planted import planted
from workbench.core.verdict import Outcome
from workbench.papers import find_paper
from workbench.repair.propose.proposal import Proposal
from workbench.repair.trees.as_printed import as_printed
from workbench.source.typeset.differences import difference, in_one_line
from workbench.source.typeset.latex_atoms import LatexNotTypesettable, atoms_of, in_colour

ERRATA = [
    (claim.printed.latex, (claim.corrected or claim.reading).latex)
    for claim in find_paper().claims
    if claim.printed.latex and (claim.corrected or claim.reading)
]
PRINTED = sorted({claim.printed.latex for claim in find_paper().claims if claim.printed.latex})
SNIPPETS = st.lists(
    st.sampled_from(
        [
            "a",
            "\\omega",
            "\\dot{",
            "\\tilde",
            "{",
            "}",
            "_",
            "^",
            "2",
            "\\mathbf",
            "+",
            "\\frac",
            "\\text{vect}",
            "[",
            " ",
        ]
    ),
    max_size=25,
).map("".join)


def differ(one, other):
    return any("same" not in part for part in difference(one, other).parts)


def side(parts, key):
    return " ".join(part.get("same", part.get(key)) for part in parts)


def assert_parts_are_both(one, other):
    parts = difference(one, other).parts
    assert not differ(side(parts, "proposed"), other)
    assert not differ(side(parts, "printed"), one)
    assert differ(one, other) == any(part.get("printed") or part.get("proposed") for part in parts)


@pytest.mark.parametrize(("printed", "right"), ERRATA)
def test_the_parts_in_a_row_are_both_formulas(printed, right):
    assert_parts_are_both(printed, right)
    assert differ(printed, right)


@given(formulas, formulas)
@settings(max_examples=200)
def test_the_parts_of_any_two_formulas_are_both(one, other):
    assert_parts_are_both(one, other)


@pytest.mark.parametrize("formula", PRINTED)
def test_nothing_differs_from_itself_and_parts_are_canonical(formula):
    found = difference(formula, formula)
    assert (found.changes, found.marked_before, found.marked_after) == ((), frozenset(), frozenset())
    ((_, canonical),) = (part for entry in found.parts for part in entry.items())
    assert difference(canonical, canonical).parts == found.parts and not differ(formula, canonical)
    assert in_colour(formula, found.marked_after) == formula


@given(SNIPPETS, SNIPPETS)
@settings(max_examples=200)
def test_any_two_texts_are_compared_or_refused(one, other):
    try:
        atoms_of(one), atoms_of(other)
    except LatexNotTypesettable:
        assert difference(one, other) is None
    else:
        assert_parts_are_both(one, other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (r"\left( a + b \right) x", "(a+b)x"),
        (r"\Bigl\| a \Bigr\rVert", r"\|a\|"),
        (r"\boldsymbol{\omega} \times \mathbf a", r"\bm\omega\times\boldsymbol{a}"),
        (r"x^2_1", "x_{1}^{2}"),
        (r"{x_1}^2", "x_{1}^{2}"),
        (r"\dot{\tilde{\omega}}", r"\tilde{\dot\omega}"),
        (r"\text{vect} \Phi", r"\operatorname{vect}{\Phi}"),
        (r"\widetilde{\mathbf{S}}_3", r"\tilde{\mathbf{S}_3}"),
        (r"a \ne b", r"a \neq {b}"),
        (r"x \triangleq y", r"x \stackrel{\text{def}}{=} y"),
        (r"2 [a + (b - c)] [d]", r"2 \left( a + [b - c] \right) (d)"),
    ],
)
def test_formatting_is_no_difference(one, other):
    assert not differ(one, other)
    assert not differ(other, one)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("{a b}^2", "a b^2"),
        ("a {}^2 b", "a^2 b"),
        (r"x^{2} y", r"x^{2 y}"),
        ("[a, b)", "(a, b)"),
        ("[a] + b", "a + b"),
        (r"\boldsymbol{\omega} + 1", r"\omega + 1"),
        (r"\boldsymbol{\omega}", r"\omega"),
    ],
)
def test_formulas_with_different_meaning_differ(one, other):
    assert differ(one, other)
    assert differ(other, one)


@pytest.mark.parametrize(
    ("one", "other", "shown"),
    [
        ("a + b", "a - b", "a [-+-] {+-+} b"),
        ("a + b", "a + 2b", "a + {+2+} b"),
        (r"\ddot{\omega} x", r"\dddot{\omega} x", r"[-\ddot{\omega}-] {+\dddot{\omega}+} x"),
        ("x^2", "x^3", "x^{ [-2-] {+3+} }"),
        (r"2 x, \mathbf{p} > 1", r"x, p > 1", r"[-2-] x, [-\mathbf{p}-] {+p+} > 1"),
        (r"\tilde S t", r"\widetilde{S t}", r"[-\tilde{S}-] {+\widetilde{S+} t {+}+}"),
    ],
)
def test_differences_are_marked_in_plain_text(one, other, shown):
    assert in_one_line(difference(one, other).parts).replace(" ", "") == shown.replace(" ", "")


def test_all_in_a_new_accent_is_highlighted():
    one, other = r"a + \tilde S t + u", r"a + \widetilde{S t} + u"
    found = difference(one, other)
    assert (
        in_colour(other, found.marked_after, "red")
        == r"a + \widetilde{ {\color{red}{S}} {\color{red}{t}} } + u"
    )
    assert in_colour(one, found.marked_before, "red") == r"a + {\color{red}{\tilde{S}}} t + u"


def test_lines_of_one_formula_are_no_difference():
    one = r"\begin{aligned} a = & [b + c] \\ & + d \end{aligned}"
    assert not differ(one, "a = (b + c) + d")
    assert differ(r"a^{[n]}", r"a^{(n)}")
    assert differ(r"\begin{bmatrix} a & b \end{bmatrix}", r"\begin{bmatrix} a \\ b \end{bmatrix}")
    rows = r"\begin{aligned} \begin{bmatrix} a & b \end{bmatrix} \end{aligned}"
    assert not differ(rows, r"\begin{bmatrix} a & b \end{bmatrix}")
    inner = r"\begin{bmatrix} \begin{aligned} a \end{aligned} & b \end{bmatrix}"
    assert differ(inner, inner.replace("&", r"\\"))


def test_a_proposal_is_unmarked_if_the_print_cannot_be_split():
    proposal = Proposal("a = 2 b", (), planted(Outcome.PROVED))
    assert proposal.beside(r"\mystery").difference == [{"same": "a = 2 b"}]
    assert proposal.in_colour(r"\mystery") == in_one_line(proposal.difference(r"\mystery")) == "a = 2 b"


def test_a_proposal_is_spelled_as_the_printed_form():
    claim = next(claim for claim in find_paper().claims if claim.id == "58.det")
    table = claim.notation.symbols
    printed = r"\det \Phi_2 = -(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}})^2"
    canonical = r"\det \Phi_{2} = \left(\omega \times \dot{\omega}\right)^{2}"
    respelled = as_printed(canonical, printed, table, ())
    assert difference(printed, respelled).parts == difference(printed, printed.replace("-", "")).parts
    assert differ(printed, respelled)
    assert as_printed(canonical, r"\mystery", table, ()) == canonical
    assert as_printed(canonical, canonical, table, ()) == canonical
