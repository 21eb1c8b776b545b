"""Laws of the atoms: nothing is lost, rewriting is idempotent, what is unknown is refused."""

import pytest
from formulas import TYPICAL, formulas
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.source.documents.tex.tex_tokens import tokens_of
from workbench.source.typeset.latex_atoms import LatexNotTypesettable, atoms_of, latex_of


@pytest.mark.parametrize("latex", TYPICAL)
def test_typical_formulas_keep_their_source(latex):
    rewritten = latex_of(atoms_of(latex))
    assert rewritten.replace(" ", "").replace("{", "").replace("}", "") == latex.replace(" ", "").replace(
        "{", ""
    ).replace("}", "")


@given(formulas)
@settings(max_examples=150)
def test_rewriting_is_idempotent(latex):
    atoms = atoms_of(latex)
    again = atoms_of(latex_of(atoms))
    assert latex_of(again) == latex_of(atoms)
    assert [atom.identity for atom in again] == [atom.identity for atom in atoms]


@given(st.text(alphabet=st.sampled_from(r"\{}^_&ab2 .()[]|~'" + "é\0\n$#%"), max_size=40))
@settings(max_examples=300)
def test_any_text_is_taken_apart_or_refused(text):
    try:
        atoms_of(text)
    except LatexNotTypesettable as refusal:
        assert str(refusal)


@pytest.mark.parametrize(
    ("latex", "named"),
    [
        (r"\mystery x", r"\mystery"),
        ("{a", "too early"),
        ("a}", "}"),
        (r"\left( a", "too early"),
        (r"\left x \right)", "delimiter"),
        (r"\begin{cases} a \end{array}", "cases is ended by array"),
        (r"\begin{tikzpicture} \end{tikzpicture}", "tikzpicture"),
        (r"x^", "too early"),
        (r"x^^2", "argument"),
        (r"\text{a$b}", r"\text"),
        (r"\input{secret}", r"\input"),
        ("a & b", "&"),
        (r"\begin{cases} a & b & c \end{cases}", "&"),
        (r"\begin{array}{l} a & b \end{array}", "&"),
        (r"\begin{bmatrix} {a & b} \end{bmatrix}", "&"),
        (r"a \\ b", r"\\"),
        ("x^2^3", "second ^"),
        ("x_2^3_4", "second _"),
        ("x^2'", "second '"),
        ("%", "%"),
        ("x\0", "\0"),
        ("☃", "☃"),
    ],
)
def test_refusals_name_the_cause(latex, named):
    with pytest.raises(LatexNotTypesettable) as refusal:
        atoms_of(latex)
    assert named in str(refusal.value)


def test_deep_nesting_is_refused_not_crashed():
    with pytest.raises(LatexNotTypesettable):
        atoms_of("{" * 100_000)
    with pytest.raises(LatexNotTypesettable):
        atoms_of(r"\dot{" * 5000 + "x" + "}" * 5000)


def test_only_the_first_digit_is_an_exponent():
    assert latex_of(atoms_of("x^12")).replace(" ", "") == "x^{1}2"


def test_bold_has_an_identity_but_no_shape_of_its_own():
    bold, plain = atoms_of(r"\boldsymbol{\omega}")[0], atoms_of(r"\omega")[0]
    assert bold.identity != plain.identity
    assert bold.shape == plain.shape


def test_the_order_of_two_marks_counts():
    first, second = atoms_of(r"\dot{\tilde{\omega}}")[0], atoms_of(r"\tilde{\dot{\omega}}")[0]
    assert first.shape != second.shape


@pytest.mark.parametrize("latex", TYPICAL)
def test_blanks_between_tokens_change_no_atom(latex):
    places = [token.start for token in tokens_of(latex) if token.word or token.text in "{}^_=+"]
    noted = latex
    for place in reversed(places):
        noted = f"{noted[:place]} \n {noted[place:]}"
    assert [atom.identity for atom in atoms_of(noted)] == [atom.identity for atom in atoms_of(latex)]


def test_blanks_in_words_are_one_as_in_print():
    assert atoms_of("\\text{if  and\n only}") == atoms_of(r"\text{if and only}")
