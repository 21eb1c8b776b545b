"""Laws of the MathML: every character of the formula is there, and none that is not; else None."""

import unicodedata
import xml.etree.ElementTree as ElementTree

import pytest
from formulas import TYPICAL, formulas
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.language.printing.printer import to_latex
from workbench.papers import find_paper
from workbench.papers.installed_papers import installed_names
from workbench.report import mathml as adapter
from workbench.report.mathml import mathml
from workbench.source.typeset import glyphs
from workbench.source.typeset.latex_atoms import atoms_of

NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"


def shown(latex, **options):
    converted = mathml(latex, **options)
    assert converted is not None, latex
    return ElementTree.fromstring(converted)


def text_of(tree):
    return "".join("".join(tree.itertext()).split())


@pytest.mark.parametrize("latex", TYPICAL)
@pytest.mark.parametrize("display", [False, True])
def test_typical_formulas_are_typeset(latex, display):
    tree = shown(latex, display=display)
    assert tree.get("display") == ("block" if display else "inline")
    assert tree.get("alttext") == latex
    assert "\\" not in text_of(tree)
    assert "&" not in text_of(tree)


@given(formulas)
@settings(max_examples=120)
def test_every_formula_of_the_grammar_is_typeset(latex):
    shown(latex)


@given(st.text(alphabet=st.sampled_from(r"\{}^_&ab2 .()|~'dotmega<>"), max_size=30))
@settings(max_examples=150)
def test_any_text_gives_wellformed_mathml_or_none(text):
    converted = mathml(text)
    if converted is not None:
        ElementTree.fromstring(converted)


@pytest.mark.parametrize(("command", "character"), sorted(glyphs.SYMBOLS.items()))
def test_each_symbol_is_its_character(command, character):
    assert text_of(shown(command)) == character


@pytest.mark.parametrize(("command", "character"), sorted(glyphs.ACCENTS.items()))
@pytest.mark.parametrize("letter", [r"\omega", r"\mathbf{R}", r"\boldsymbol{\Phi}"])
def test_each_mark_stands_on_its_letter(command, character, letter):
    tree = shown(f"{command}{{{letter}}}")
    tag = "munder" if command == r"\underline" else "mover"
    base, mark = tree.find(f".//{NAMESPACE}{tag}")
    assert mark.text == character
    assert text_of(base) == text_of(shown(letter))


def test_marks_nest_in_the_order_written():
    tree = shown(r"\dot{\tilde{\omega}}")
    outer = tree.find(f".//{NAMESPACE}mover")
    inner = outer[0].find(f".//{NAMESPACE}mover")
    assert (inner[1].text, outer[1].text) == ("˜", "˙")


@pytest.mark.parametrize(
    ("latex", "name"),
    [
        (r"\boldsymbol{\omega}", "MATHEMATICAL BOLD ITALIC SMALL OMEGA"),
        (r"\boldsymbol{\varepsilon}", "MATHEMATICAL BOLD ITALIC SMALL EPSILON"),
        (r"\boldsymbol{\epsilon}", "MATHEMATICAL BOLD ITALIC EPSILON SYMBOL"),
        (r"\boldsymbol{v}", "MATHEMATICAL BOLD ITALIC SMALL V"),
        (r"\mathbf{\Phi}", "MATHEMATICAL BOLD CAPITAL PHI"),
        (r"\mathbf{R}", "MATHEMATICAL BOLD CAPITAL R"),
        (r"\mathbf{0}", "MATHEMATICAL BOLD DIGIT ZERO"),
        (r"\mathfrak{g}", "MATHEMATICAL FRAKTUR SMALL G"),
        (r"\mathfrak{C}", "BLACK-LETTER CAPITAL C"),
        (r"\mathbb{R}", "DOUBLE-STRUCK CAPITAL R"),
        (r"\mathcal{R}", "SCRIPT CAPITAL R"),
    ],
)
def test_styled_letters_are_unicode_letters(latex, name):
    """MathML Core knows no `mathvariant` but `normal`: browsers ignore it."""
    tree = shown(latex)
    assert unicodedata.name(text_of(tree)) == name
    assert not [e for e in tree.iter() if e.get("mathvariant") not in (None, "normal")]


def test_aligned_becomes_a_table_without_ampersands():
    tree = shown(r"\begin{aligned} a &= b \\ c &= d \end{aligned}", display=True)
    rows = tree.findall(f".//{NAMESPACE}mtr")
    assert [text_of(row) for row in rows] == ["a=b", "c=d"]


def test_left_scripts_stand_left():
    assert text_of(shown(r"{}^{k-1}\mathbf{R}_k")) == "k−1𝐑k"


def test_minus_is_an_operator_only_after_an_operand():
    signs = [e for e in shown("a = -b - c").iter(f"{NAMESPACE}mo") if e.text == "−"]
    assert [sign.get("form") for sign in signs] == ["prefix", None]


@given(formulas, st.data())
@settings(max_examples=100)
def test_exactly_the_marked_leaves_are_marked(latex, data):
    leaves = [i for i, atom in enumerate(atoms_of(latex)) if atom.leaf]
    marked = frozenset(data.draw(st.sets(st.sampled_from(leaves))))
    tree = shown(latex, marked=marked)
    assert sum(e.get("class") == "changed" for e in tree.iter()) == len(marked)


@pytest.mark.parametrize("latex", [r"\mystery{x}", "a & b }", r"\input{x}", "50%", r"\frac{a}", "☺"])
def test_unknown_commands_are_not_typeset(latex):
    assert mathml(latex) is None


@pytest.mark.parametrize(("right", "wrong"), [("ω", "ϖ"), ("<mn>2</mn>", ""), ("−", "+")])
def test_a_converter_that_errs_is_caught(monkeypatch, right, wrong):
    converted = adapter.convert(r"\omega^2 - \rho").replace("&#x003C9;", "ω").replace("&#x02212;", "−")
    assert right in converted
    monkeypatch.setattr(adapter, "convert", lambda *_, **__: converted.replace(right, wrong))
    adapter.mathml.cache_clear()
    try:
        assert mathml(r"\omega^2 - \rho") is None
    finally:
        adapter.mathml.cache_clear()


@pytest.mark.parametrize(
    ("latex", "spaces"),
    [
        (r"\det \Phi = \det S", [("0", "0.17em"), ("0", "0.17em")]),
        (r"2 \det T", [("0.17em", "0.17em")]),
        (r"(\operatorname{trace} T) a", [("0", "0.17em")]),
        (r"\operatorname{sym}(T)", [("0", "0")]),
    ],
)
def test_function_name_has_space_beside_operands_only(latex, spaces):
    names = [e for e in shown(latex).iter(f"{NAMESPACE}mo") if (e.text or "").isalpha()]
    assert [(name.get("lspace"), name.get("rspace")) for name in names] == spaces


#: Heads of terms that no installed text has: what the printer makes of them is typeset, too.
RARE = (
    *(rf"{name} x" for name in glyphs.FUNCTION_NAMES),
    r"\log x",
    r"\sqrt[3]{x}",
    r"\frac{\partial f}{\partial x}",
    r"\frac{d f}{d x}",
)


@pytest.mark.parametrize("name", installed_names())
def test_terms_of_installed_texts_are_typeset(name):
    """Each form of each claim, printed from its term, becomes MathML with just the characters of the print. So a
    printer from terms to MathML could show nothing more; and corrections keep the author's spelling, which terms
    do not have."""
    forms = [form for claim in find_paper(name).claims for form in claim.forms.values() if form.statement]
    assert forms
    assert [latex for form in forms if mathml(latex := to_latex(form.statement)) is None] == []


@pytest.mark.parametrize("latex", RARE)
def test_rare_construct_is_typeset(latex):
    assert mathml(latex) is not None
