"""Where a scope of a model begins and what is in force in it; what a sentence or an unfinished row says."""

from pathlib import Path

import pytest

from tests.texts.written import told
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.names import Name
from workbench.core.paper_errors import PaperError
from workbench.papers.load import load_paper

HEADINGS = [
    "## Parent\n\nWords.\n\n### Child\n\n",
    "## Parent\n\n```{figure} f.png\n---\nname: fig\n---\nA figure.\n```\n\n",
    "Parent\n------\n\n",
]


@pytest.mark.parametrize("heading", HEADINGS)
def test_a_scope_begins_at_a_heading_whatever_stands_below_it(tmp_path: Path, heading: str) -> None:
    (tmp_path / "p.md").write_text(f"# First\n\n$$ a = b $$\n\n{heading}$$ a = 2 b $$\n")
    model = "source = 'p.md'\n[symbols]\nb = 'scalar'\n[definitions]\na = 'b'\n[[scope]]\nfrom = 'Parent'\n"
    (tmp_path / "p.toml").write_text(model + "definitions = { a = '2 b' }\n")
    results = judge_paper(load_paper(tmp_path / "p.toml"))
    assert [result.verdict.outcome.value for result in results] == ["definition", "definition"]


def test_without_the_place_of_a_scope_nothing_is_a_fault(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$ a = b $$\n\n$$ a = 2 b $$\n\n$$ b = b + c $$\n")
    model = "source = 'p.md'\n[symbols]\nb = 'scalar'\nc = 'vector'\n[definitions]\na = 'b'\n[[scope]]\n"
    (tmp_path / "p.toml").write_text(model + "from = 'nowhere'\ndefinitions = { a = '2 b' }\n")
    paper = load_paper(tmp_path / "p.toml")
    assert "the text has no 'nowhere'" in paper.faults[0].message
    outcomes = [result.verdict.outcome.value for result in judge_paper(paper)]
    assert outcomes == ["definition", "unchecked", "unchecked"]


def test_an_omitted_right_side_is_not_taken_from_the_next_row(tmp_path: Path) -> None:
    rows = r"\begin{align} x &= \\ y &= z \\ a &= \\ &= b \\ u =& \\ v =& w \end{align}"
    (tmp_path / "p.tex").write_text(rf"\begin{{document}}{rows}\end{{document}}")
    symbols = "\n".join(f"{name} = 'scalar'" for name in "xyzabuvw")
    (tmp_path / "p.toml").write_text(f"source = 'p.tex'\n[symbols]\n{symbols}\n")
    printed = [claim.printed.latex.replace(" ", "") for claim in load_paper(tmp_path / "p.toml").claims]
    assert not any("=y" in each or "=v" in each for each in printed)
    assert "y=z" in printed and "a=b" in printed and "v=w" in printed


def test_definitions_that_do_not_fit_a_later_scope_are_dropped(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("# A\n\n$$ v = u $$\n\n# B\n\n$$ v = u $$\n\n# C\n\n$$ v = u $$\n")
    symbols = "source = 'p.md'\n[symbols]\nv = 'vector'\nu = 'vector'\nw = { kind = 'scalar', free = true }\n"
    scopes = "[[scope]]\nfrom = 'B'\nsymbols = { w = 'vector' }\ndefinitions = { u = 'v + w - w' }\n"
    scopes += "[[scope]]\nfrom = 'C'\nsymbols = { w = 'scalar' }\ndefinitions = { w = '2' }\n"
    (tmp_path / "p.toml").write_text(symbols + scopes)
    paper = load_paper(tmp_path / "p.toml")
    outcomes = [result.verdict.outcome.value for result in judge_paper(paper)]
    assert not paper.faults and outcomes == ["definition", "proved", "definition"]
    (tmp_path / "p.toml").write_text(symbols + scopes.replace("w = '2'", "w = 'v'"))
    with pytest.raises(PaperError, match="differ in type"):
        load_paper(tmp_path / "p.toml")


def test_a_sentence_that_says_what_is_defined_excuses_nothing(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$ a = \\dot b + b $$\n\nWith $\\dot b = c$ it is done.\n")
    model = "source = 'p.md'\n[symbols]\nb = 'scalar'\n[definitions]\nc = '\\dot b'\na = '2 c'\n"
    (tmp_path / "p.toml").write_text(model)
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert result.verdict.outcome.value == "refuted"
    (tmp_path / "p.toml").write_text(model.replace("c = '\\dot b'\na = '2 c'", "a = '2 \\dot b'"))
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert told(result.verdict) == "doubtful"


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
    (tmp_path / "p.md").write_text(f"$$ {text} $$\n")
    (tmp_path / "p.toml").write_text(
        "source = 'p.md'\n[symbols]\nx = 'scalar'\ny = 'scalar'\nz = 'scalar'\na = 'vector'\n"
    )
    claims = load_paper(tmp_path / "p.toml").claims
    assert [claim.printed.latex.replace(" ", "") for claim in claims] == expected
    conditions = {"y \\neq 0": ["y\\neq0"], "if } y = z": ["y=z"]}
    assumed = [claim.assume[0].latex.replace(" ", "") for claim in claims if claim.assume]
    assert assumed == next((latex for part, latex in conditions.items() if part in row), [])


def test_rates_may_stand_among_the_arguments(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$ J^\\#(q) J(q, \\dot q) = J^\\# J $$\n")
    model = "source = 'p.md'\n[conventions]\narguments = ['q', '\\dot q', '\\ddot{q}']\n"
    (tmp_path / "p.toml").write_text(model + "[symbols]\nq = 'scalar'\nJ = 'tensor'\n'J^\\#' = 'tensor'\n")
    (claim,) = load_paper(tmp_path / "p.toml").claims
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
    (tmp_path / "p.md").write_text(f"$$ {formula} $$\n")
    convention = "[conventions]\ncross = 'right'\n" if more == "right" else ""
    symbols = "".join(f"{name} = {{ kind = 'vector', free = true }}\n" for name in "fgh")
    own = "" if more == "right" else more
    (tmp_path / "p.toml").write_text(f"source = 'p.md'\n{convention}[symbols]\n{symbols}{own}\n")
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert result.verdict.outcome.value == expected, result.verdict.reason


def test_a_scope_may_begin_at_any_line(tmp_path: Path) -> None:
    text = "# A\n\n$$ v = u $$\n\nFrom here on\n\nit is so.\n\n$$ v = u $$\n"
    (tmp_path / "p.md").write_text(text)
    model = "source = 'p.md'\n[symbols]\nv = 'vector'\nw = 'vector'\n[definitions]\nu = 'v + w'\n"
    scope = "[[scope]]\nfrom = 'line {}'\ndefinitions = {{ u = 'v' }}\n"
    for line in (4, 5, 7, 9):
        (tmp_path / "p.toml").write_text(model + scope.format(line))
        paper = load_paper(tmp_path / "p.toml")
        outcomes = [result.verdict.outcome.value for result in judge_paper(paper)]
        assert not paper.faults and outcomes == ["refuted", "proved"], line
    (tmp_path / "p.toml").write_text(model + scope.format(10))
    assert "the text has no 'line 10'" in load_paper(tmp_path / "p.toml").faults[0].message


@pytest.mark.parametrize("section", [r"\section{Two}\label{sec:two}", r"\section*{Two}\label{sec:two}"])
def test_a_scope_begins_at_the_label_of_a_section(tmp_path: Path, section: str) -> None:
    body = rf"\[ b \cdot a = a \cdot b \] {section} where \[ b a = a b \] \section{{Three}}\label{{sec:end}}"
    (tmp_path / "p.tex").write_text(
        rf"\begin{{document}}\section{{One}}\label{{sec:one}}{body}\end{{document}}"
    )
    head = "source = 'p.tex'\n[symbols]\n'a' = 'vector'\n'b' = 'vector'\n[[scope]]\n"
    scope = "from = 'sec:two'\nsymbols = { 'b' = { kind = 'scalar' } }\n"
    (tmp_path / "p.toml").write_text(head + scope)
    claims = load_paper(tmp_path / "p.toml").claims
    kinds = [claim.notation.symbols.symbols[Name("b")].type.kind for claim in claims]
    assert kinds == ["vector", "scalar"]
    (tmp_path / "p.toml").write_text(head + scope.replace("sec:two", "sec:end"))  # no display follows
    assert "from: the text has no 'sec:end'" in load_paper(tmp_path / "p.toml").faults[0].message


def test_a_scope_may_use_what_is_defined_behind_the_place(tmp_path: Path) -> None:
    """Of r, e and s a scope defines r anew by e, which stood behind it, and e is in force as before."""
    (tmp_path / "p.md").write_text("$$ s = 2 a $$\n\n$$ s = 8 a $$ (two)\n")
    (tmp_path / "p.toml").write_text(
        "source = 'p.md'\n[symbols]\na = 'vector'\nr = 'vector'\ns = 'vector'\ne = 'vector'\n"
        "[definitions]\nr = 'a'\ns = '2 r'\ne = '2 a'\n"
        "[[scope]]\nfrom = 'two'\ndefinitions = { r = '2 e' }\n"
    )
    assert [each.verdict.outcome.value for each in judge_paper(load_paper(tmp_path / "p.toml"))] == [
        "proved",
        "proved",
    ]


def test_circular_definitions_of_a_scope_are_rejected(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$ r = 2 e $$\n\n$$ e = 2 r $$ (two)\n")
    (tmp_path / "p.toml").write_text(
        "source = 'p.md'\n[symbols]\nr = 'vector'\ne = 'vector'\n[definitions]\nr = '2 e'\n"
        "[[scope]]\nfrom = 'two'\ndefinitions = { e = '2 r' }\n"
    )
    with pytest.raises(PaperError, match="used above its definition"):
        load_paper(tmp_path / "p.toml")


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
    (tmp_path / "p.tex").write_text(f"\\begin{{equation}}\n{formula}\n\\end{{equation}}\n")
    claim = f"[[claim]]\nat = '1'\nassume = ['{assumed}']\n"
    symbols = "[symbols]\nx = 'scalar'\ny = 'scalar'\nv = 'scalar'\n"
    (tmp_path / "p.toml").write_text("source = 'p.tex'\n" + symbols + claim)
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert result.verdict.outcome.value == expected
