"""Laws of the cutter: no token is lost, layouts and macros change nothing, conditions never vanish."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from random import Random

import pytest

from tests.display_layouts import LAYOUTS, TERMS, Chain, some_chains, some_side
from workbench.source.documents import Display, is_text, read_text
from workbench.source.rows.chains import Step, steps_of
from workbench.source.rows.cutter import cut_display
from workbench.source.rows.display_statements import Cut, Role
from workbench.source.rows.display_vocabulary import GAPS

ROOT = Path(__file__).parents[2]
COUNT = 60


def displays_of(tmp_path: Path, body: str, name: str = "p.tex") -> Sequence[Display]:
    path = tmp_path / name
    path.write_text(f"\\begin{{document}}\n{body}\n\\end{{document}}" if name.endswith("tex") else body)
    return read_text(path).displays


def formulas_of(displays: Sequence[Display]) -> list[str]:
    steps = [step for display in displays for statement in steps_of(display) for step in statement]
    return ["".join(step.spelled()[0].split()) for step in steps]


def places_of(cut: Cut) -> Counter[int]:
    """How many places each token is in; an equation that may be a condition is in its own statement, too."""
    counts: Counter[int] = Counter()
    parts = [each.nodes for each in cut.statements]
    parts += [b.nodes for each in cut.statements for b in each.beside if b.role is Role.CONDITION]
    parts += [cut.remarks, *(nodes for _, nodes in cut.leftovers)]
    for nodes in parts:
        counts.update({id(token) for node in nodes for token in node.tokens})
    return counts


def assert_conserved(display: Display) -> None:
    cut = cut_display(display)
    assert not cut.lost(display), display.latex
    counts = places_of(cut)
    printed = [token for row in display.rows for token in row.tokens if token.text not in GAPS]
    noted = {"\\stackrel", "\\overset", "\\underbrace", "\\overbrace", "\\cancel"}
    if noted.isdisjoint(token.text for token in printed):
        assert all(counts[id(token)] <= 1 for token in printed), display.latex


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_display_is_cut_into_the_formulas_that_it_states(tmp_path: Path, layout: str) -> None:
    random = Random(layout)
    for _ in range(COUNT):
        chains = some_chains(random)
        text = LAYOUTS[layout](chains, random)
        displays = displays_of(tmp_path, text)
        assert formulas_of(displays) == [step for chain in chains for step in chain.steps()], text
        for display in displays:
            assert_conserved(display)


@pytest.mark.parametrize("layout", [name for name in LAYOUTS if name not in ("gather", "cases", "gathered")])
def test_markdown_and_tex_are_cut_alike(tmp_path: Path, layout: str) -> None:
    random = Random(layout)
    text = LAYOUTS[layout](some_chains(random), random)
    inner = text if text.startswith(("$$", "\\[")) else f"$$\n{text}\n$$"
    assert formulas_of(displays_of(tmp_path, inner, "p.md")) == formulas_of(displays_of(tmp_path, text))


def test_no_token_of_the_installed_texts_is_lost() -> None:
    found = [path for path in sorted((ROOT / "proofs" / "texts").rglob("*")) if is_text(path)]
    displays = [display for path in found for display in read_text(path).displays]
    assert len(displays) > 100
    for display in displays:
        assert_conserved(display)


def test_macros_and_what_they_print_are_cut_alike(tmp_path: Path) -> None:
    macros = {"\\eq": "&=", "\\nl": "\\\\", "\\tm": "+ b_1", "\\side": "a - \\dot{c}", "\\both": "a = b"}
    declared = "".join(f"\\newcommand{{{name}}}{{{body}}}\n" for name, body in macros.items())
    lefts, rights = ["a", "\\side", "c_2"], ["\\side", "\\both", "b"]
    random = Random(1)
    for _ in range(COUNT):
        rows = [
            " ".join((random.choice(lefts), "\\eq", random.choice(rights), "\\tm"))
            for _ in range(random.randint(1, 4))
        ]
        inner = " \\nl ".join(rows)
        written = f"\\begin{{align}} {inner} \\end{{align}}"
        printed = written
        for name, body in macros.items():
            printed = re.sub(rf"\{name}(?![a-z])", lambda _, body=body: body + " ", printed)
        expected = formulas_of(displays_of(tmp_path, printed))
        assert formulas_of(displays_of(tmp_path, declared + written)) == expected, written


CONDITION_WORDS = [
    "where", "with", "given", "given that", "provided", "provided that", "whenever", "when", "if", "for", "while",
    "subject to", "such that", "since", "because", "as", "using", "(since", "for all", "at", "assuming",
]  # fmt: skip
BESIDE = [
    r"\begin{{equation}} A = B, \quad \text{{{0} }} p \cdot q = 0 \end{{equation}}",
    r"\begin{{equation}} A = B \ \text{{{0} $p \cdot q = 0$}} \end{{equation}}",
    r"\begin{{align}} A &= B && \text{{{0} }} p \cdot q = 0 \end{{align}}",
    r"\begin{{align}} A &= B & \text{{{0} $p \cdot q = 0$}} \end{{align}}",
    r"\begin{{equation}} \text{{{0} }} p \cdot q = 0: \quad A = B \end{{equation}}",
    r"\begin{{equation}}\begin{{cases}} A = B & \text{{{0} }} p \cdot q = 0 \end{{cases}}\end{{equation}}",
    r"$$\begin{{aligned}} A &= B, \\ & \text{{{0} }} p \cdot q = 0. \end{{aligned}}$$",
    r"\begin{{gather}} A = B \\ \text{{{0} }} p \cdot q = 0 \end{{gather}}",
]


@pytest.mark.parametrize("word", CONDITION_WORDS)
@pytest.mark.parametrize("layout", BESIDE)
def test_a_condition_beside_a_formula_is_its_premise(tmp_path: Path, word: str, layout: str) -> None:
    displays = displays_of(tmp_path, layout.format(word))
    (step,) = [step for display in displays for steps in steps_of(display) for step in steps]
    assert "".join(step.spelled()[0].split()) == "A=B"
    assert [latex(each) for each in (*step.assumed, *step.reasons)] == ["p\\cdotq=0"]


@pytest.mark.parametrize("word", ["since", "where", "(since", "as"])
@pytest.mark.parametrize("layout", BESIDE)
def test_macros_in_words_are_expanded(tmp_path: Path, word: str, layout: str) -> None:
    declared = "\\newcommand{\\with}[1]{p \\cdot #1}\\def\\said{" + word + " }"
    written = layout.format(r"\said").replace(r"p \cdot q", r"\with{q}")
    (display,) = displays_of(tmp_path, declared + written)
    (step,) = [step for steps in steps_of(display) for step in steps]
    assert [latex(each) for each in (*step.assumed, *step.reasons)] == ["p\\cdotq=0"]


def latex(tokens: Sequence) -> str:
    return "".join(token.text for token in tokens).replace(" ", "")


UNWORDED = {
    r"\begin{equation} A = B, \quad p \cdot q = 0 \end{equation}": "perhaps",
    r"\begin{equation} A = B \quad p \cdot q = 0 \end{equation}": "perhaps",
    r"\begin{align} A &= B && p \cdot q = 0 \end{align}": "perhaps",
    r"\begin{equation}\begin{cases} A = B & p \cdot q = 0 \end{cases}\end{equation}": "perhaps",
    r"\begin{equation} A = B \quad (p \perp q) \end{equation}": "assumed",
    r"\begin{equation} A = B, \quad p \perp q \end{equation}": "assumed",
    r"\begin{equation} A = B \quad \forall p \perp q \end{equation}": "assumed",
    r"\begin{align} A &= B && (p \neq q) \end{align}": "assumed",
    r"\begin{equation} A \stackrel{p = q}{=} B \end{equation}": "assumed",
    r"\begin{equation} A + \underbrace{p}_{=0} = B \end{equation}": "reasons",
    r"\begin{equation} A + \cancel{p} = B \end{equation}": "reasons",
    r"\begin{equation} A + \cancelto{0}{p} = B \end{equation}": "reasons",
    r"\begin{equation} (A + \cancel{p}) q = B \end{equation}": "reasons",
    r"\begin{equation} A = B, \quad n \geq 1 \end{equation}": "ranges",
    r"\begin{equation} n \geq 1: \quad A_n = B \end{equation}": None,
    r"\begin{equation} n \geq 1, \quad A_n = B \end{equation}": "ranges",
    r"\begin{align} A &= B && \text{along the axis} \end{align}": "limits",
    r"\begin{equation} A = B \quad \text{if } p \end{equation}": "limits",
    r"\begin{equation} A = B \quad \text{by orthogonality of the two} \end{equation}": "limits",
}


@pytest.mark.parametrize("display", UNWORDED)
def test_text_beside_a_formula_is_never_dropped(tmp_path: Path, display: str) -> None:
    steps = [step for each in displays_of(tmp_path, display) for line in steps_of(each) for step in line]
    if (key := UNWORDED[display]) is not None:
        assert getattr(steps[0], key), display


ROWS_OF_CONDITIONS = {
    r"A &= B \\ & \text{where } p q = 0 \\ D &= E": {"A=B": ["pq=0"], "D=E": []},
    r"A &= B \\ & \text{for } p q = 0: \\ D &= E": {"A=B": [], "D=E": ["pq=0"]},
    r"A &= B \\ \intertext{Since $p q = 0$,} D &= E": {"A=B": [], "D=E": ["pq=0"]},
    r"A &= B \\ \intertext{and, as $p q = 0$,} &= C": {"A=B": [], "B=C": ["pq=0"]},
    r"A &= B \text{ for all } n; \quad D = E": {"A=B": [], "D=E": []},
    r"\forall x, \forall y, \quad D = E": {"D=E": []},
    r"\forall x, D(x) \leq E": {r"D(x)\leqE": []},
}


@pytest.mark.parametrize("rows", ROWS_OF_CONDITIONS)
def test_a_condition_belongs_to_the_formula_of_its_row(tmp_path: Path, rows: str) -> None:
    displays = displays_of(tmp_path, rf"\begin{{align}} {rows} \end{{align}}")
    steps = [step for line in steps_of(displays[0]) for step in line]
    found = {plain_of(step): [latex(each) for each in (*step.assumed, *step.reasons)] for step in steps}
    assert found == ROWS_OF_CONDITIONS[rows]
    assert_conserved(displays[0])


WORDED = [
    r"F = -G\text{ and is parallel to }(r - s)",
    r"f = g \text{ times } h",
    r"x = y + \text{terms that depend on } a",
    r"x \text{ is a multiple of } y",
    r"(f, f) \geq 0\text{ with equality iff }f = 0",
]


@pytest.mark.parametrize("formula", WORDED)
def test_words_within_a_formula_stay_in_it(tmp_path: Path, formula: str) -> None:
    """Without the words F = -G and is parallel to r was read as F = -G r."""
    ((step,),) = steps_of(displays_of(tmp_path, rf"\[ {formula} \]")[0])
    assert plain_of(step) == "".join(formula.split())


def test_a_factor_that_is_struck_out_is_not_said_to_vanish(tmp_path: Path) -> None:
    text = r"\[ \cancel{p} q = \cancel{p} r \] \[ \frac{\cancel{p} q}{\cancel{p}} = q \]"
    steps = [step for each in displays_of(tmp_path, text) for line in steps_of(each) for step in line]
    assert len(steps) == 2 and not any(step.reasons for step in steps)


def test_a_reason_belongs_to_the_steps_of_its_row(tmp_path: Path) -> None:
    rows = r"A &= B \\ &= C && \text{since $p = q$} \\ &= D"
    (steps,) = steps_of(displays_of(tmp_path, rf"\begin{{align}} {rows} \end{{align}}")[0])
    assert [len(step.reasons) for step in steps] == [0, 1, 1]


QUESTIONS = {
    r"\begin{align} & A = B \\ & \quad - C = D \end{align}": [("A=B-C", "A=B"), ("B-C=D", "-C=D")],
    r"\begin{equation}\begin{split} & A = B \\ & C \end{split}\end{equation}": [("A=BC", "A=B")],
    r"\begin{equation}\begin{split} A &= B \\ & C \end{split}\end{equation}": [("A=BC", "A=B")],
    r"\begin{alignat}{2} A &= B && - C = D \end{alignat}": [("A=B-C", "A=B"), ("B-C=D", "-C=D")],
}


@pytest.mark.parametrize("display", QUESTIONS)
def test_two_readings_of_a_layout_are_both_stated(tmp_path: Path, display: str) -> None:
    (steps,) = steps_of(displays_of(tmp_path, display)[0])
    assert [(latex(step.tokens), latex(step.otherwise[0])) for step in steps] == QUESTIONS[display]
    assert all(step.question for step in steps)


@pytest.mark.parametrize("words", ["Wrong: ", "False: ", "not ", "Incorrect: "])
def test_words_that_deny_a_formula_keep_it_from_being_claimed(tmp_path: Path, words: str) -> None:
    ((step,),) = steps_of(displays_of(tmp_path, rf"\[ \text{{{words}}} A = B \]")[0])
    assert step.denied is not None


def test_rows_are_not_split_inside_groups(tmp_path: Path) -> None:
    random = Random(2)
    for _ in range(COUNT):
        inner = f"{random.choice(TERMS)} = {random.choice(TERMS)}, \\quad {random.choice(TERMS)}"
        opening, closing = random.choice(
            [("(", ")"), ("\\left(", "\\right)"), ("f_{", "}"), ("\\sqrt{", "}")]
        )
        text = f"A = {opening}{inner}{closing} + B"
        ((step,),) = steps_of(displays_of(tmp_path, f"\\[ {text} \\]")[0])
        assert plain_of(step).startswith("A=") and plain_of(step).endswith("+B")


def test_an_environment_without_an_end_ends_with_its_group(tmp_path: Path) -> None:
    for part in (
        r"{\begin{bmatrix} b \\ c }",
        r"\frac{\begin{bmatrix} b}{c}",
        r"\left(\begin{matrix} b \right)",
    ):
        (display,) = displays_of(tmp_path, f"$$a = {part} = d, \\quad e = f$$", "p.md")
        part = "".join(part.split())
        found = [plain_of(step) for line in steps_of(display) for step in line]
        assert found == [f"a={part}", f"{part}=d", "e=f"]


def plain_of(step: Step) -> str:
    return "".join(step.spelled()[0].split())


def test_deep_and_long_displays_are_cut(tmp_path: Path) -> None:
    deep = f"\\[ a = {'{' * 3000} b {'}' * 3000} \\]"
    rows = " \\\\ ".join(["a &= b + c"] * 1500)
    long = f"\\begin{{align}} {rows} \\end{{align}}"
    displays = displays_of(tmp_path, f"{deep}\n{long}")
    assert len(steps_of(displays[1])) == 1500
    for display in displays:
        assert not cut_display(display).lost(display)


def test_some_sides_differ() -> None:
    """The generator makes different formulas."""
    sides = {Chain(some_side(Random(seed)), [["b"]]).steps()[0] for seed in range(40)}
    assert len(sides) > 20
