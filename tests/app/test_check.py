"""`workbench.check` in Python and in notebooks."""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

import workbench
from workbench import check
from workbench.core.verdict import Outcome

AB = {"a": "vector", "b": "vector"}
EVERY_VERDICT = Path(__file__).parents[1] / "papers" / "every_verdict.toml"


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"a \times b = -b \times a", Outcome.PROVED),
        (r"a \times b = b \times a", Outcome.REFUTED),
        (r"a = b a", Outcome.ILL_FORMED),
    ],
)
def test_outcomes(latex, outcome):
    checked = check(latex, AB)
    assert checked.outcome == outcome
    assert checked.holds == bool(checked) == (outcome == Outcome.PROVED)
    assert str(outcome) in str(checked) and str(checked) == repr(checked)
    assert str(outcome) in checked._repr_markdown_() and latex in checked._repr_markdown_()


@pytest.mark.parametrize(
    ("last", "outcome"), [("b \\times (-a)", Outcome.PROVED), ("b \\times a", Outcome.REFUTED)]
)
def test_an_aligned_chain_is_one_formula(last, outcome):
    latex = rf"\begin{{aligned}} a \times b &= -b \times a, \\ &= {last} \end{{aligned}}"
    assert check(latex, AB).outcome == outcome


def test_a_counterexample_says_what_definitions_make_of_it():
    example = check(r"n \cdot n = 1", AB, definitions=[r"n = a \times b"]).verdict.counterexample
    a, b, n = ([int(x) for x in given] for given in (*example.values.values(), example.defined["n"]))
    assert n == [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    assert example.behind == ("a", "b")
    spoken_of = check(r"n \cdot n = a \cdot a", AB, definitions=[r"n = a \times b"]).verdict.counterexample
    assert spoken_of.behind == ("b",)


def test_a_refutation_shows_its_counterexample():
    markdown = check(r"a \cdot b = 0", AB)._repr_markdown_()
    assert "all else 0" not in markdown and "the left side is 1, the right side 0" in markdown


def test_lines_are_a_tuple_of_verdicts():
    lines = check(r"\begin{aligned} a \cdot b &= b \cdot a \\ a \cdot b &= 0 \end{aligned}", AB)
    assert isinstance(lines, tuple) and [line.outcome for line in lines] == [Outcome.PROVED, Outcome.REFUTED]
    assert not lines.holds and not lines
    assert lines._repr_markdown_().count("$$") == 4


def test_no_notation_of_a_paper_is_used_unless_asked():
    formula = r"\det \Phi_2 = -(\omega \times \dot{\omega})^2"
    assert check(formula, paper="chapter").holds
    with pytest.raises(ValueError, match=r"unknown symbol"):
        check(formula)


def test_the_notation_of_a_paper_is_read_without_its_claims():
    from workbench.papers import installed_notation, load_installed

    whole, alone = load_installed("chapter").notation, installed_notation("chapter")
    assert alone.symbols == whole.symbols and list(alone.definitions) == list(whole.definitions)


def test_the_notation_of_a_paper_file_and_more_symbols():
    checked = check(r"\Phi_1 y = \omega \times y", {"y": {"kind": "vector"}}, paper=EVERY_VERDICT)
    assert checked.holds
    assert checked.verdict.read_back == r"\Phi_{1} y = \omega \times y"


def test_assumptions_and_orders():
    assert check(r"a \cdot b = 0", AB, assume=["a = 0"]).holds
    family = check(
        r"\operatorname{tr} \Phi_n = \operatorname{tr} \Phi_n^T", paper=EVERY_VERDICT, orders="n = 1..3"
    )
    assert family.holds and family.verdict.scope


@pytest.mark.parametrize(
    "definitions", [{"K": r"a \times b", "n": r"K \times b"}, [r"K = a \times b", r"n := K \times b"]]
)
def test_definitions_of_ones_own(definitions):
    formula = r"n = (a \cdot b) b - b^2 a"
    assert check(formula, AB, definitions=definitions).holds
    assert check(r"n = K \times b", AB, definitions=definitions).outcome == Outcome.DEFINITION
    assert check("K = b", AB, definitions=r"K = a \times b").outcome == Outcome.REFUTED


@pytest.mark.parametrize("sign", [":=", r"\coloneqq", r"\triangleq", r"\stackrel{def}{=}"])
def test_a_definition_of_a_free_symbol_is_not_false(sign):
    known = {**AB, "c": "vector", "u": {"kind": "vector", "unit": True}}

    def outcome(latex, definitions=()):
        return check(latex.replace(":=", sign), known, definitions=definitions).outcome

    assert outcome("c := a + b") == Outcome.DEFINITION
    assert outcome("c = a + b") == Outcome.REFUTED
    assert outcome("c := a + b", ["c = a - b"]) == Outcome.REFUTED
    assert outcome("c := a + b", ["c = b + a"]) == Outcome.PROVED
    for open_ in ("c := c + a", "u := a", "a + b := c", r"\dot{c} := a", "c := a = b", r"c := a, b \neq 0"):
        assert outcome(open_) in (Outcome.DEFINITION, Outcome.UNCHECKED), open_
    assert outcome("a + b := b + a") == Outcome.PROVED
    assert outcome(r"c := a \cdot b") == Outcome.ILL_FORMED


@pytest.mark.parametrize("definitions", [(), ["c = a - b"]])
@pytest.mark.parametrize("sign", [":=", r"\coloneqq"])
def test_an_assignment_is_no_falsehood(sign, definitions):
    known = {**AB, "c": "vector"}

    def verdict(latex):
        return check(latex.replace(":=", sign), known, definitions=definitions).verdict

    for step in (r"c := \frac{c}{\|c\|}", "c := c + a", r"c := c + a, b \neq 0"):
        assert verdict(step).outcome == Outcome.DEFINITION
        assert "assigns a value" in verdict(step).reason
    assert verdict("c = c + a").outcome == Outcome.REFUTED
    assert verdict("c := b").outcome == (Outcome.REFUTED if definitions else Outcome.DEFINITION)


def test_a_recurrence_of_ones_own_beside_the_notation_of_a_paper():
    own = {r"\Psi_1": r"\Phi_1", r"\Psi_{n+1}": r"\dot{\Psi}_n + \Psi_n \Phi_1"}
    assert check(r"\Psi_3 = \Phi_3", paper="chapter", definitions=own).holds
    assert check(r"\Psi_n = \Phi_n", paper=EVERY_VERDICT, definitions=own, orders="n = 1..4").holds
    wrong = own | {r"\Psi_{n+1}": r"\dot{\Psi}_n - \Psi_n \Phi_1"}
    assert check(r"\Psi_3 = \Phi_3", paper="chapter", definitions=wrong).outcome == Outcome.REFUTED


def test_a_notation_file_needs_no_claims(tmp_path):
    file = tmp_path / "notation.toml"
    file.write_text("[symbols]\n'x' = { kind = 'vector' }\n[definitions]\n'K' = '\\tilde{x}'\n")
    assert check(r"K y = x \times y", {"y": "vector"}, notation=file).holds
    assert check(r"K_2 = x^2", notation=str(file), definitions=["K_2 = x \\cdot x"]).holds


def test_a_place_in_a_paper_has_symbols_of_its_own():
    formula = r"\mathbf{P}_2 = \mathbf{D} + \tilde{\omega}"
    with pytest.raises(ValueError, match="unknown symbol"):
        check(formula)
    assert check(formula, at="32").holds
    assert check(formula, {"q": "scalar"}, at="32", definitions=["Q = q\\mathbf{P}_2"]).holds


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"latex": "a = "}, "line 1, column"),
        ({"latex": r"a = \psi"}, r"line 1, column 5: unknown symbol \psi"),
        ({"latex": ""}, "line 1, column 1"),
        ({"latex": "\\begin{aligned} a &= b \\\\\n a &= \\psi \\end{aligned}"}, "line 2, column 7: unknown"),
        ({"latex": "a = b", "assume": ["a"]}, "assume: "),
        ({"latex": "a = b", "assume": ["a b = 0"]}, "assume: "),
        ({"latex": "a = b", "assume": [r"a \neq a"]}, "no values"),
        ({"latex": "a = b", "orders": "n"}, "expected `n = 1..8`"),
        ({"latex": "a = b", "symbols": {"a": "matrix"}}, "kind is 'matrix'"),
        ({"latex": "a = b", "symbols": {"a": 3}}, "expected a table"),
        ({"latex": "a = b", "symbols": {r"\omega": "vector"}, "paper": EVERY_VERDICT}, "already"),
        ({"latex": "a = b", "paper": "no.toml"}, "no such file"),
        ({"latex": "a = b", "paper": "nothing"}, "no installed paper of that name"),
        ({"latex": 3}, "latex: expected LaTeX, got 3"),
        ({"latex": "a = b", "assume": [3]}, "assume: expected LaTeX"),
        ({"latex": "a = b", "symbols": ["a", "b"]}, "symbols: expected LaTeX → kind"),
        ({"latex": "a = b", "symbols": {"t": "scalar"}}, "t is the time"),
        ({"latex": "a = b", "definitions": "K"}, "definitions: expected a symbol, = and what it is, got 'K'"),
        ({"latex": "a = b", "definitions": {"K": 3}}, "definitions: expected LaTeX"),
        ({"latex": "a = b", "definitions": 3}, "definitions: expected LaTeX, got 3"),
        (
            {"latex": "a = b", "definitions": ["K = a \\times c"]},
            "definitions: K: line 1, column 10: unknown symbol c",
        ),
        ({"latex": "a = b", "definitions": ["K = a b"]}, "definitions: K: line 1, column 3: vectors beside"),
        (
            {"latex": "a = b", "definitions": ["K = a", "K = b"]},
            "definitions: K: this symbol is defined already",
        ),
        ({"latex": "a = b", "definitions": ["a + b = a"]}, "definitions: a + b: expected one symbol"),
        (
            {"latex": "a = b", "definitions": ["K = M", "M = a"]},
            "definitions: K: line 1, column 1: unknown symbol M",
        ),
        ({"latex": "a = b", "notation": "no.toml"}, "no.toml: no such file"),
        ({"latex": "a = b", "notation": EVERY_VERDICT, "paper": "chapter"}, "not both"),
        ({"latex": "a = b", "at": "999"}, "'999' selects no claim"),
        ({"latex": "a = b", "at": "6"}, "'6' is in 02_rigid_motion.toml, "),
    ],
)
def test_bad_input_is_a_value_error_of_one_line(arguments, message):
    with pytest.raises(ValueError) as caught:
        check(**{"symbols": AB, **arguments})
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


HEAVY = ("pydrake", "sympy", "flint", "numba", "jinja2", "numpy", "lark", "rich")


def test_import_is_light():
    code = "import sys, workbench; print(sorted(set(sys.modules) & set(sys.argv[1:])))"
    done = subprocess.run([sys.executable, "-c", code, *HEAVY], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
    assert workbench.__version__ == version("kinematics-workbench")


def test_judging_on_all_cores_gives_what_one_core_gives(monkeypatch):
    from workbench.app.pipeline import judge_claims as verify
    from workbench.papers import find_paper

    paper = find_paper(None)
    serial = verify.judge_paper(paper, ["53-57"], motions=False)
    monkeypatch.setattr(verify, "MANY", 1)
    assert verify.judge_paper(paper, ["53-57"], motions=False) == serial


def test_an_error_comes_through_from_another_process():
    import pickle

    from workbench.papers import PaperError

    error = pickle.loads(pickle.dumps(PaperError("a.toml", 3, 4, "what was wrong")))
    assert str(error) == "a.toml:3:4: what was wrong" and error.line == 3


@pytest.mark.parametrize(
    ("row", "column", "result"),
    [
        (r"[f \quad -g]", r"\begin{bmatrix} x \\ y \end{bmatrix}", "f x - g y"),
        (r"[f \; g]", r"[x \; y]^T", "f x + g y"),
        (r"\left[ f \; -g \right]", r"\left[ x \quad y \right]^T", "f x - g y"),
        (r"\begin{pmatrix} f \; -g \end{pmatrix}", r"\begin{pmatrix} x \\ y \end{pmatrix}", "f x - g y"),
    ],
)
def test_entries_that_spaces_part_are_a_row(row, column, result):
    scalars = dict.fromkeys("fgxy", "scalar")
    assert check(f"{row} {column} = {result}", symbols=scalars)
    assert not check(f"{row} {column} = {result} + f", symbols=scalars)


def test_a_reason_in_words_that_does_not_fit_is_said() -> None:
    """It ended in an AssertionError."""
    with pytest.raises(ValueError, match="condition: a = f: line 1, column 3: the two sides differ in type"):
        check(r"f g = 0 \quad \text{since } a = f", {"f": "scalar", "g": "scalar", "a": "vector"})
