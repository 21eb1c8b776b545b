"""Where a scope of a model begins and what is in force in it; what a sentence or an unfinished row says."""

from pathlib import Path

import pytest

from tests.texts.written import outcomes, paper_of, shown, symbols_of, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.names import Name
from workbench.core.paper_errors import PaperError

HEADINGS = [
    "## Parent\n\nWords.\n\n### Child\n\n",
    "## Parent\n\n```{figure} f.png\n---\nname: fig\n---\nA figure.\n```\n\n",
    "Parent\n------\n\n",
]


@pytest.mark.parametrize("heading", HEADINGS)
def test_a_scope_begins_at_a_heading_whatever_stands_below_it(tmp_path: Path, heading: str) -> None:
    text = f"# First\n\n$$ a = b $$\n\n{heading}$$ a = 2 b $$\n"
    model = "[symbols]\nb = 'scalar'\n[definitions]\na = 'b'\n[[scope]]\nfrom = 'Parent'\n"
    found = outcomes(tmp_path, text, model + "definitions = { a = '2 b' }\n")
    assert found == ["definition", "definition"]


def test_without_the_place_of_a_scope_nothing_is_a_fault(tmp_path: Path) -> None:
    model = "source = 'p.md'\n[symbols]\nb = 'scalar'\nc = 'vector'\n[definitions]\na = 'b'\n[[scope]]\n"
    model += "from = 'nowhere'\ndefinitions = { a = '2 b' }\n"
    paper = paper_of(tmp_path, shown("a = b", "a = 2 b", "b = b + c"), model, "md")
    assert "the text has no 'nowhere'" in paper.faults[0].message
    found = [result.verdict.outcome.value for result in judge_paper(paper)]
    assert found == ["definition", "unchecked", "unchecked"]


def test_an_omitted_right_side_is_not_taken_from_the_next_row(tmp_path: Path) -> None:
    rows = r"\begin{align} x &= \\ y &= z \\ a &= \\ &= b \\ u =& \\ v =& w \end{align}"
    model = "source = 'p.tex'\n" + symbols_of(dict.fromkeys("xyzabuvw", "scalar"))
    paper = paper_of(tmp_path, rf"\begin{{document}}{rows}\end{{document}}", model, "tex")
    printed = [claim.printed.latex.replace(" ", "") for claim in paper.claims]
    assert not any("=y" in each or "=v" in each for each in printed)
    assert "y=z" in printed and "a=b" in printed and "v=w" in printed


def test_definitions_that_do_not_fit_a_later_scope_are_dropped(tmp_path: Path) -> None:
    text = "# A\n\n$$ v = u $$\n\n# B\n\n$$ v = u $$\n\n# C\n\n$$ v = u $$\n"
    symbols = "source = 'p.md'\n[symbols]\nv = 'vector'\nu = 'vector'\nw = { kind = 'scalar', free = true }\n"
    scopes = "[[scope]]\nfrom = 'B'\nsymbols = { w = 'vector' }\ndefinitions = { u = 'v + w - w' }\n"
    scopes += "[[scope]]\nfrom = 'C'\nsymbols = { w = 'scalar' }\ndefinitions = { w = '2' }\n"
    assert outcomes(tmp_path, text, symbols + scopes) == ["said", "proved", "said"]
    with pytest.raises(PaperError, match="differ in type"):
        paper_of(tmp_path, text, symbols + scopes.replace("w = '2'", "w = 'v'"), "md")


def test_a_sentence_that_says_what_is_defined_excuses_nothing(tmp_path: Path) -> None:
    text = "$$ a = \\dot b + b $$\n\nWith $\\dot b = c$ it is done.\n"
    model = "[symbols]\nb = 'scalar'\n[definitions]\n"
    assert outcomes(tmp_path, text, f"{model}c = '\\dot b'\na = '2 c'\n") == ["refuted"]
    assert outcomes(tmp_path, text, f"{model}a = '2 \\dot b'\n") == ["doubtful"]


@pytest.mark.parametrize(
    ("environment", "row", "expected"),
    [
        ("cases", "x - x = 0 & x x = 0", ["x-x=0", "xx=0"]),
        ("cases", "x - x = 0 \\quad & a = 2 a - a,", ["x-x=0", "a=2a-a"]),
        ("array}{ll", "x = y & 2 y = x & x + y = z", ["x=y", "2y=x", "x+y=z"]),
        ("aligned", "x = y & + z", ["x=y+z"]),
        ("aligned", "x = y & = z", ["x=y", "y=z"]),
        ("aligned", "x = y \\cdot & z = y", ["x=y\\cdotz", "y\\cdotz=y"]),
        ("cases", "x = y & \\text{if } y = z", ["x=y"]),
        ("cases", "x = y & y \\neq 0", ["x=y"]),
        ("cases", "x = y & y = 0", ["x=y", "y=0"]),
    ],
)
def test_an_equation_behind_a_mark_is_one_of_its_own(
    tmp_path: Path, environment: str, row: str, expected: list[str]
) -> None:
    """A = B & C = D was read as A = B C = D; a relation that is no equation is the condition of A = B."""
    text = f"\\begin{{{environment}}} {row} \\end{{{environment.partition('}')[0]}}}"
    model = "source = 'p.md'\n" + symbols_of({"x": "scalar", "y": "scalar", "z": "scalar", "a": "vector"})
    claims = paper_of(tmp_path, shown(text), model, "md").claims
    assert [claim.printed.latex.replace(" ", "") for claim in claims] == expected
    conditions = {"y \\neq 0": ["y\\neq0"], "if } y = z": ["y=z"]}
    assumed = [claim.assume[0].latex.replace(" ", "") for claim in claims if claim.assume]
    assert assumed == next((latex for part, latex in conditions.items() if part in row), [])


def test_rates_may_stand_among_the_arguments(tmp_path: Path) -> None:
    text = shown("J^\\#(q) J(q, \\dot q) = J^\\# J")
    model = "source = 'p.md'\n[conventions]\narguments = ['q', '\\dot q', '\\ddot{q}']\n"
    model += symbols_of({"q": "scalar", "J": "tensor", "J^\\#": "tensor"})
    (claim,) = paper_of(tmp_path, text, model, "md").claims
    assert claim.printed.statement.left == claim.printed.statement.right


@pytest.mark.parametrize(
    ("formula", "more", "expected"),
    [
        (r"\tilde{f} = f + g", "", "unchecked"),
        (r"\tilde{f} = f + g", r"'\tilde{f}' = { kind = 'vector', free = true }", "refuted"),
        (r"f \times g \times h = f \times (g \times h)", "", "unchecked"),
        (r"f \times g \times h = g (f \cdot h) - h (f \cdot g)", "right", "proved"),
        (r"f \times g \times h = (f \times g) \times h", "right", "refuted"),
        (r"\begin{bmatrix} 2 & \cdot \\ \cdot & 2 \end{bmatrix} = 2 \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}", "", "proved"),
    ],
)  # fmt: skip
def test_formulas_with_another_reading_name_it(
    tmp_path: Path, formula: str, more: str, expected: str
) -> None:
    """\tilde{f} = f + g was ill-formed, f being a vector and its skew tensor none."""
    convention = "[conventions]\ncross = 'right'\n" if more == "right" else ""
    symbols = "".join(f"{name} = {{ kind = 'vector', free = true }}\n" for name in "fgh")
    own = "" if more == "right" else more
    (verdict,) = verdicts(tmp_path, shown(formula), f"{convention}[symbols]\n{symbols}{own}\n")
    assert verdict.outcome.value == expected, verdict.reason


def test_a_scope_may_begin_at_any_line(tmp_path: Path) -> None:
    text = "# A\n\n$$ v = u $$\n\nFrom here on\n\nit is so.\n\n$$ v = u $$\n"
    model = "source = 'p.md'\n[symbols]\nv = 'vector'\nw = 'vector'\n[definitions]\nu = 'v + w'\n"
    scope = "[[scope]]\nfrom = 'line {}'\ndefinitions = {{ u = 'v' }}\n"
    for line in (4, 5, 7, 9):
        assert outcomes(tmp_path, text, model + scope.format(line)) == ["refuted", "proved"], line
    (fault,) = paper_of(tmp_path, text, model + scope.format(10), "md").faults
    assert "the text has no 'line 10'" in fault.message


@pytest.mark.parametrize("section", [r"\section{Two}\label{sec:two}", r"\section*{Two}\label{sec:two}"])
def test_a_scope_begins_at_the_label_of_a_section(tmp_path: Path, section: str) -> None:
    body = rf"\[ b \cdot a = a \cdot b \] {section} where \[ b a = a b \] \section{{Three}}\label{{sec:end}}"
    text = rf"\begin{{document}}\section{{One}}\label{{sec:one}}{body}\end{{document}}"
    head = "source = 'p.tex'\n[symbols]\n'a' = 'vector'\n'b' = 'vector'\n[[scope]]\n"
    scope = "from = 'sec:two'\nsymbols = { 'b' = { kind = 'scalar' } }\n"
    claims = paper_of(tmp_path, text, head + scope, "tex").claims
    kinds = [claim.notation.symbols.symbols[Name("b")].type.kind for claim in claims]
    assert kinds == ["vector", "scalar"]
    without = paper_of(tmp_path, text, head + scope.replace("sec:two", "sec:end"), "tex")
    assert "from: the text has no 'sec:end'" in without.faults[0].message  # no display follows


def test_a_scope_may_use_what_is_defined_behind_the_place(tmp_path: Path) -> None:
    """Of r, e and s a scope defines r anew by e, which stood behind it, and e is in force as before."""
    model = symbols_of(dict.fromkeys("arse", "vector")) + "[definitions]\nr = 'a'\ns = '2 r'\ne = '2 a'\n"
    model += "[[scope]]\nfrom = 'two'\ndefinitions = { r = '2 e' }\n"
    found = outcomes(tmp_path, f"{shown('s = 2 a', 's = 8 a')} (two)\n", model)
    assert found == ["proved", "proved"]


def test_circular_definitions_of_a_scope_are_rejected(tmp_path: Path) -> None:
    model = "source = 'p.md'\n[symbols]\nr = 'vector'\ne = 'vector'\n[definitions]\nr = '2 e'\n"
    model += "[[scope]]\nfrom = 'two'\ndefinitions = { e = '2 r' }\n"
    with pytest.raises(PaperError, match="used above its definition"):
        paper_of(tmp_path, f"{shown('r = 2 e', 'e = 2 r')} (two)\n", model, "md")


@pytest.mark.parametrize(
    ("formula", "assumed", "expected"),
    [
        ("x = v", r"\dot x = v", "refuted"),
        (r"\dot x = 2 v", r"\dot x = v", "refuted"),
        ("x^2 = v^2", "x + v = 2 v", "proved"),
        ("x = v", "x + v = 3 v", "refuted"),
        ("x = v", "y = 3 v", "definition"),
    ],
)
def test_a_formula_of_an_assumed_symbol_is_a_claim(
    tmp_path: Path, formula: str, assumed: str, expected: str
) -> None:
    text = f"\\begin{{equation}}\n{formula}\n\\end{{equation}}\n"
    claim = f"[[claim]]\nat = '1'\nassume = ['{assumed}']\n"
    (verdict,) = verdicts(tmp_path, text, symbols_of(dict.fromkeys("xyv", "scalar")) + claim, "tex")
    assert verdict.outcome.value == expected
