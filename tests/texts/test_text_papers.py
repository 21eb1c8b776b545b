"""A text is judged as a paper: step by step, every fault in its place, the model beside it checked against it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.texts.written import verdicts
from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Outcome
from workbench.papers import load_paper
from workbench.source.documents import read_text
from workbench.source.rows.chains import steps_of

TEXT = r"""\newcommand{\cross}[2]{#1 \times #2}
%! workbench: symbols.'a' = { kind = "vector" }
%! workbench: symbols.'r' = { kind = "vector" }
%! workbench: symbols.'v' = { kind = "vector" }
%! workbench: symbols.'f' = { kind = "scalar" }
\begin{align}
  (\cross{a}{r}) \cdot (\cross{a}{r}) &= a^2 r^2 - (a \cdot r)^2 \notag\\
   &= a^2 r^2 + (a \cdot r)^2 \label{eq:lag}\\
   &= (a\cdot r)^2 + r^2 a^2
\end{align}
\[ v = \cross{a}{r} \] \[ a + f = r \] \[ \foo{x} = f \]
"""


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, [*arguments], catch_exceptions=False)


@pytest.fixture
def paper(tmp_path: Path) -> Path:
    path = tmp_path / "p.tex"
    path.write_text(TEXT)
    return path


def test_every_claim_has_a_verdict_or_a_reason_with_a_position(paper: Path) -> None:
    result = run("check", str(paper), "--no-proposals", "--json")
    claims = {claim["id"]: claim for claim in json.loads(result.stdout)["claims"]}
    assert result.exit_code == 1
    assert {name: claim["verdict"] for name, claim in claims.items()} == {
        "eq-lag.1": "proved",
        "eq-lag.2": "refuted",
        "2": "proved",
        "L11": "definition",
        "L11'": "ill-formed",
        "L11''": "unchecked",
    }
    assert claims["eq-lag.2"]["chain"] == ["eq-lag.1"]
    where = claims["eq-lag.2"]["place"]
    line = TEXT.split("\n")[where["line"] - 1]
    assert line[where["column"] - 1 : where["end_column"] - 1] == r"= a^2 r^2 + (a \cdot r)^2"
    assert claims["L11"]["reason"] == "defines v" and claims["L11"]["grade"] == "note"


def test_listing_shows_errors_by_line_and_unread_formulas(paper: Path) -> None:
    out = run("check", str(paper), "--no-proposals").stdout
    assert out.startswith(f"{paper}: 2 errors, 1 not judged, 1 holds, 1 definition\n")
    assert "✗ (1) eq:lag, line 8: does not follow from the step before\n" in out
    assert "     8 |    &= a^2 r^2 + (a \\cdot r)^2 \\label{eq:lag}\\\\\n       |     ^^^^" in out
    column = TEXT.split("\n")[10].index("\\foo")
    assert "\n  cannot be read: unknown command \\foo [WB-UNKNOWN-COMMAND]\n" in out
    assert f"\n    11 | {TEXT.split(chr(10))[10]}\n       | {' ' * column}^^^^" in out


def test_formats_for_machines(paper: Path) -> None:
    annotations = run("check", str(paper), "--no-proposals", "--format", "github").stdout.splitlines()
    assert annotations[0].startswith(
        f"::error file={paper},line=8,endLine=8,col=5,endColumn=30,title=refuted eq-lag.2::"
    )
    log = json.loads(run("check", str(paper), "--no-proposals", "--format", "sarif").stdout)
    (found,) = log["runs"]
    assert (log["version"], found["columnKind"]) == ("2.1.0", "unicodeCodePoints")
    rules = [rule["id"] for rule in found["tool"]["driver"]["rules"]]
    assert all(rules[result["ruleIndex"]] == result["ruleId"] for result in found["results"])
    lines = run("check", str(paper), "--no-proposals", "--format", "rdjsonl").stdout.splitlines()
    assert [json.loads(line)["severity"] for line in lines] == ["ERROR", "INFO", "ERROR", "INFO"]


def test_columns_of_rdjsonl_are_bytes(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("é $$ \\foo = 1 $$\n")
    (line,) = run("check", str(path), "--format", "rdjsonl").stdout.splitlines()
    assert json.loads(line)["location"]["range"]["start"] == {"line": 1, "column": 7}


def test_an_unreadable_text_has_exit_status_2(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("$$ \\foo = 1 $$\n")
    assert run("check", str(path)).exit_code == 2
    path.write_text("no formula")
    result = run("check", str(path))
    assert (result.exit_code, "no displayed equation" in result.output) == (2, True)


MODEL = r"""source = "p.md"
[symbols]
'a' = { kind = "vector" }
'b' = { kind = "vector" }
[[claim]]
at = "one"
corrected = 'a \times b = -b \times a'
[[scope]]
from = "two"
symbols = { 'b' = { kind = "scalar" } }
[[claim]]
at = "line 4"
skip = "words"
"""


def test_a_model_says_what_the_text_does_not(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text(
        "$$ a \\times b = b \\times a $$ (one)\n\n$$ b a = a b $$ (two)\n$$ \\foo $$\n"
    )
    (tmp_path / "p.toml").write_text(MODEL)
    for name in ("p.md", "p.toml"):
        result = run("check", str(tmp_path / name), "--no-proposals")
        assert result.exit_code == 0, result.output
        assert "error" not in result.stdout.replace("no new error found", "")


SCOPED = r"""source = "p.md"
[symbols]
'a' = "vector"
'b' = "vector"
's' = "scalar"
[definitions]
'u' = 'a + b'
'v' = 's a'
[[scope]]
from = "two"
symbols = { 'b' = "scalar" }
definitions = { 'v' = 'w + a', 'w' = 's a' }
"""


def test_a_scope_keeps_fitting_definitions_in_any_order(tmp_path: Path) -> None:
    one, two, three, four = verdicts(
        tmp_path,
        "$$ u = a + b $$ (one)\n\n$$ v = a + s a $$ (two)\n\n$$ w = v - a $$\n\n$$ b u = u b $$\n",
        SCOPED,
    )
    assert one.outcome is Outcome.DEFINITION
    assert two.outcome is three.outcome is Outcome.PROVED
    assert "unknown symbol u" in four.reason
    (tmp_path / "p.toml").write_text(SCOPED.replace("'w' = 's a' }", "'w' = 's + a' }"))
    with pytest.raises(PaperError, match="w: the addends differ"):
        load_paper(tmp_path / "p.toml")


def test_all_entries_that_no_longer_fit_the_text_are_named(tmp_path: Path) -> None:
    displays = "$$ a \\times b = b \\times a $$ (one)\n\n$$ a = a $$ (two)\n\n$$ a \\times a = 0 $$\n"
    (tmp_path / "p.md").write_text(displays)
    (tmp_path / "p.toml").write_text(
        MODEL.split("[[claim]]")[0]
        + "[[claim]]\nat = 'gone'\nprinted = 'a = a'\nnote = 'x'\n"
        + "[[claim]]\nat = 'one'\nprinted = 'a \\times b = b'\n"
        + "[[claim]]\nat = 'two'\ncorrected = '\\foo'\n[[scope]]\nfrom = 'three'\n"
    )
    paper = load_paper(tmp_path / "p.toml")
    messages = [(error.line, error.message) for error in paper.faults]
    assert sorted(line for line, _ in messages) == [6, 11, 14, 16]
    told = " ".join(message for _, message in messages)
    for words in (
        "no 'three'",
        "the same formula stands at line 3",
        "the text says a \\times b = b \\times a there now",
        "unknown command",
    ):
        assert words in told
    assert run("check", str(tmp_path / "p.toml"), "--no-proposals").exit_code == 1


def test_a_quote_may_be_spaced_and_ended_otherwise(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$ a \\times a = 0 $$ (one)\n")
    quoted = "[[claim]]\nat = 'one'\nprinted = 'a\\times a  =0.'\n"
    (tmp_path / "p.toml").write_text(MODEL.split("[[claim]]")[0] + quoted)
    assert not load_paper(tmp_path / "p.toml").faults


def test_macros_that_only_tex_can_follow_are_named(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    path.write_text(
        r"\newcommand\one[1]{\expandafter(#1)}\newcommand\other[1]{\expandafter[#1]}"
        r"\[ \one{1} = 1 \] \[ \other{\one{1}} = 1 \] \[ 1 = 1 \]"
    )
    one, both, none = (result.verdict.reason for result in judge_paper(load_paper(path)))
    assert "the macro \\one could" in one
    assert "the macro \\one, \\other could" in both
    assert "macro" not in none


def test_another_reading_that_is_not_read_decides_nothing(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    path.write_text("%! workbench: symbols.x = 'scalar'\n" r"\[\begin{split} & x = \sin \\ & x \end{split}\]")
    (result,) = judge_paper(load_paper(path))
    assert result.claim.ambiguity.otherwise[0].unread == "cannot be read: line 1, column 5: sin of nothing"
    assert result.verdict.outcome is Outcome.UNCHECKED and "a row without" in result.verdict.reason


STEPS = [
    (r"a = b = c", ["a=b", "b=c"]),
    (r"a = b, \quad c = d", ["a = b", "c = d"]),
    (r"a = b, \quad n \geq 1", [r"a = b,n \geq1"]),
    (r"x = 1 \text{ or } x = 2", [r"x = 1 \text{ or } x = 2"]),
    (r"a = b \Rightarrow c = d", [r"a = b \Rightarrow c = d"]),
    (r"f = g(a, b), h", [r"f = g(a, b), h"]),
    (r"\begin{split} a &= b & \rightarrow b &= a \\ c &= d & \to d &= c \end{split}", [r"a = b \Rightarrow b = a", r"c = d \Rightarrow d = c"]),
    (r"x_\text{and} = y \text{ and } u = v", [r"x_\text{and} = y", "u = v"]),
    (r"a = 1 + 2 + ...", ["a = 1 + 2 + ..."]),
    (r"\begin{cases} a = b \\ c = d \end{cases}", ["a = b", "c = d"]),
    (r"\begin{aligned} a &= b \\ &\quad + c \\ &= d \end{aligned}", ["a=b + c", "b + c=d"]),
    (r"a = \begin{cases} b & c \\ d & e \end{cases}", [r"a = \begin{cases} b & c \\ d & e \end{cases}"]),
    (r"\underbrace{a}_{x} = \mathclap{b}\,. ", ["a = b"]),
    (r"\mbox{\boldmath $\omega$} := \mathbfit{r}", [r"\boldsymbol{\omega} := \boldsymbol{r}"]),
    (r"v = ^A R_B \, ^B u + \hspace{0em}^C w", [r"v = {}^A R_B \, {}^B u + {}^C w"]),
    (r"(^A x)\,^2 = x \!^{-1} \frac{^N d x}{dt}^T", [r"({}^A x)\,^2 = x \!^{-1} \frac{{}^N d x}{dt}^T"]),
    (r"{\rm v} = {\bf R u}", [r"\mathrm{v} = \mathbf{R u}"]),
    (r"\text{v} \in \textrm{SO}(3), \text{v} = a", [r"\mathrm{v} = a,\mathrm{v} \in\mathrm{SO}(3)"]),
    (r"a \overset{(1)}{=} b \stackrel{\text{by 2}}{=} c", ["a =b", "b =c"]),
    (r"a \overset{?}{=} b", [r"a \overset{?}{=} b"]),
    (r"\begin{aligned} a &=& b \\ &=& c \end{aligned}", ["a = b", "b =c"]),
    (r"a = b \rightarrow c = d", [r"a = b \Rightarrow c = d"]),
    (r"f: x \to y", [r"f: x \to y"]),
    (r"\begin{matrix} a = b \\ c = d \end{matrix}", ["a = b", "c = d"]),
    (r"\begin{matrix} a = b & c = d \end{matrix}", [r"\begin{matrix} a = b & c = d \end{matrix}"]),
    (r"\displaylines{a = b \\ c = d}", ["a = b", "c = d"]),
    (r"\begin{array}{lll} a = b & c & = d \end{array}", ["a = b", "c = d"]),
    (r"\begin{aligned} a &= b & + c &= d \end{aligned}", ["a = b", "+ c = d"]),
    (r"a &= b & + c &= d \\ e &= f", ["a = b", "+ c = d", "e = f"]),
]  # fmt: skip


@pytest.mark.parametrize(("latex", "steps"), STEPS)
def test_steps(tmp_path: Path, latex: str, steps: list[str]) -> None:
    path = tmp_path / "p.tex"
    path.write_text(f"\\[ {latex} \\]")
    (display,) = read_text(path).displays
    found = [step.spelled()[0] for line in steps_of(display) for step in line]
    assert ["".join(each.split()) for each in found] == ["".join(each.split()) for each in steps]


def test_a_drafted_model_loads_and_its_guesses_refute_nothing(tmp_path: Path) -> None:
    path, out = tmp_path / "p.md", tmp_path / "all.json"
    path.write_text(
        "The vector $v$ and the scalar $m$:\n$$ m v = v m $$ (one)\n\n$$ i j = -j i $$\n\n$$ \\int v = m $$\n\n$$ \\mathbf{w} := m v $$\n"
    )
    result = run("ingest", str(path), "--json", str(out))
    assert result.exit_code == 0, result.output
    displays = json.loads(out.read_text())["displays"]
    assert [(d["label"], d["line"], d["read"], d["feature"]) for d in displays] == [
        ("one", 2, True, None),
        (None, 4, True, None),
        (None, 6, False, "integrals"),
        (None, 8, True, None),
    ]
    model = (tmp_path / "p.toml").read_text()
    assert '\'v\' = { kind = "vector" }  # guessed: the text says "vector" near it' in model
    checked = json.loads(run("check", str(tmp_path / "p.toml"), "--no-proposals", "--json").stdout)["claims"]
    assert [claim["verdict"] for claim in checked][:3] == ["proved", "refuted", "unchecked"]
    assert checked[1]["grade"] == "warning" and "false if i, j are of kind scalar" in checked[1]["reason"]
    again = run("ingest", str(path))
    assert (again.exit_code, "--force" in again.output) == (2, True)


def test_control_characters_are_shown_and_not_obeyed(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    path.write_text("%! workbench: title = '\\u001b'\n\\[ a\x1b[31m = \\foo \\]\n")
    out = run("check", str(path)).output
    assert "\x1b" not in out and "\ufffd" in out


def test_control_characters_in_titles_and_notes_are_one_message(tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(
        'title = "a\\u001b[31m"\n[symbols]\na = { kind = "vector" }\n'
        '[[claim]]\nid = "1"\nprinted = "a = 2 a"\nnote = "n\\u001b[2J"\n'
    )
    for command in ("check", str(path)), ("show", "1", "--paper", str(path), "--no-proposals"):
        assert "\x1b" not in run(*command).output
    result = run("report", "--paper", str(path), "--out", str(tmp_path / "out"), "--no-motions")
    assert (result.exit_code, "got U+001B" in result.output) == (2, True)


def test_init_writes_ten_true_claims(tmp_path: Path) -> None:
    path = tmp_path / "body.toml"
    assert run("init", str(path)).exit_code == 0
    result = run("check", str(path))
    assert (result.exit_code, "10 claims: 10 proved" in result.output) == (0, True)
    assert run("init", str(path)).exit_code == 2


MENDED = r"""source = "p.md"
[citation]
authors = "A. Author"
commit = "0123456"
[symbols]
'a' = { kind = "vector" }
'b' = { kind = "vector" }
[[claim]]
at = "one"
corrected = 'a \times b = -b \times a'
fault = "misprint"
mend = [['b \times a', '-b \times a']]
note = "A sign."
[[claim]]
at = "two"
corrected = 'b \times a = -a \times b'
fault = "misprint"
mended_by = "one"
[[claim]]
at = ["three", "L8"]
unread = "derivatives"
"""
FOUR = r"""$$ a \times b = b \times a $$ (one)

$$ b \times a = a \times b $$ (two)

$$ \partial a = b $$ (three)


$$ \partial b = a = c $$
"""


def faulty(tmp_path: Path, model: str = MENDED, text: str = FOUR) -> Path:
    (tmp_path / "p.md").write_text(text)
    path = tmp_path / "p.toml"
    path.write_text(model)
    return path


def test_faults_of_a_text_are_mended_as_those_of_a_paper_file(tmp_path: Path) -> None:
    path = faulty(tmp_path)
    for command in (["check", str(path), "--no-proposals"], ["verify", "--paper", str(path)]):
        result = run(*command)
        assert result.exit_code == 0, result.output
    out = tmp_path / "out"
    assert run("report", "--paper", str(path), "--out", str(out)).exit_code == 0
    note = (out / "erratum.tex").read_text()
    assert "0123456" in note and "A. Author" in note
    assert note.count(r"\Fitted{\linewidth}{b \times a}") == 1, (
        "the second is mended by the edit of the first"
    )


def test_an_unexpected_verdict_passes_unless_it_is_a_fault(tmp_path: Path) -> None:
    path = faulty(tmp_path, text=FOUR.replace(r"\partial a = b", "a + b = b + a"))
    result = run("check", str(path), "--no-proposals")
    assert (result.exit_code, "can do without `unread`" in result.output) == (0, True)
    path = faulty(tmp_path, text=FOUR.replace(r"\partial a = b", "a + b = b - a"))
    result = run("check", str(path), "--no-proposals")
    assert (result.exit_code, "1 error" in result.output) == (1, True)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('mended_by = "one"', 'mended_by = "ten"', "mended_by: no claim has the id 'ten'"),
        ("[['b \\times a'", "[['c'", "expected 'c' once in what is printed"),
        ('fault = "misprint"\nmended_by', "mended_by", "only a claim with a fault has it"),
        ('fault = "misprint"\nmend ', 'fault = "slip"\nmend ', "expected one of error, misprint"),
        ('["three", "L8"]', '["three", "L9"]', "the text has no display 'L9'"),
        ('["three", "L8"]', "[]", "at: expected a place, or a list of places"),
    ],
)
def test_fault_entries_of_a_model_are_checked(tmp_path: Path, old: str, new: str, says: str) -> None:
    assert old in MENDED
    path = faulty(tmp_path, MENDED.replace(old, new))
    for command in (["check", str(path), "--no-proposals"], ["verify", "--paper", str(path)]):
        result = run(*command)
        assert result.exit_code in (1, 2) and says in result.output


TEXTS = Path(__file__).parents[2] / "proofs" / "texts"


@pytest.mark.parametrize("model", sorted(TEXTS.glob("*/*.toml")), ids=lambda path: path.stem)
def test_the_installed_texts_say_where_they_come_from(model: Path) -> None:
    paper = load_paper(model)
    assert paper.faults == () and paper.warnings == ()
    assert {"authors", "source", "commit", "licence"} <= set(paper.citation)
    assert all(
        claim.source.note
        for claim in paper.claims
        if claim.mend.fault and not claim.mend.by and not claim.mend.cause
    )


def test_ten_displays_of_the_texts_are_false_and_five_garbled() -> None:
    """pytest judges each of these claims, see proofs/texts: here they are counted."""
    false, garbled = set(), set()
    for model in TEXTS.glob("*/*.toml"):
        for claim in load_paper(model).claims:
            place = (claim.source.file, claim.equation or claim.id.partition(".")[0])
            if claim.corrected is not None:
                false.add(place)
            elif claim.mend.fault is not None:
                garbled.add(place)
    assert len(false) >= 10 and len(garbled - false) >= 5


SAID = r"""
%! workbench: symbols.'a' = { kind = "vector" }
%! workbench: symbols.'b' = { kind = "vector" }
%! workbench: symbols.'r' = { kind = "vector" }
%! workbench: symbols.'\theta' = { kind = "scalar" }
%! workbench: symbols.'p' = { kind = "scalar" }
%! workbench: symbols.'F' = { kind = "tensor" }
%! workbench: definitions.'v' = '\dot{r}'
"""


@pytest.mark.parametrize(
    ("formulas", "verdict", "why"),
    [
        (r"\[ a = r \times b \] \[ a \cdot b = 0 \]", "conditional", "(L9)"),
        (r"\[ a = r \times b \] \[ a \cdot r = p \] \[ a \cdot a = 0 \]", "refuted", None),
        (r"\[ a = r \times b \] \[ a = p r \] \[ a \cdot b = 0 \]", "conditional", "(L9)"),
        (r"\[ a = r \times b \] \[ r = p b \] \[ a = 0 a \]", "conditional", "(L9)"),
        (r"\[ a = F b \] \[ b = F a \] \[ a \cdot b = 0 \]", "refuted", None),
        (r"\[ a \cdot b = \|a\| \|b\| \cos \theta \]", "definition", "says what \\theta is"),
        (r"\[ \sin^2 \theta = \cos \theta \]", "refuted", None),
        (r"\[ a \times b \neq b \times a \]", "unchecked", "always, or in general"),
        (r"\[ r \times (a + b) = r \times a + r \times a \]", "definition", "says what b is"),
        (r"\[ r \times (a + b) = r \times a - r \times b \]", "refuted", None),
        (r"\[ \dot{r} = v \] \[ v \times r = r \times v \]", "refuted", None),
        (r"\[ \dot{r} = v \] \[ r = p b \] \[ v \times r = r \times v \]", "refuted", None),
        (r"\[ \dot{r} = v \] \[ r = p b \] \[ r \times b = 0 \]", "conditional", "(L9')"),
        (r"\[ \dot{r} = v \] \[ \dot{r} = a \] \[ v \times r = r \times v \]", "refuted", None),
    ],
)  # fmt: skip
def test_claims_that_follow_from_the_text_are_not_refuted(
    tmp_path: Path, formulas: str, verdict: str, why: str | None
) -> None:
    path = tmp_path / "p.tex"
    path.write_text(SAID + formulas)
    last = json.loads(run("check", str(path), "--no-proposals", "--json").stdout)["claims"][-1]
    assert last["verdict"] == verdict
    assert why is None or why in last["reason"]


@pytest.mark.parametrize(
    ("sentence", "verdict"), [("the function $g(N)$", "unchecked"), ("the vector $g$", "ill-formed")]
)
def test_a_function_named_in_a_sentence_is_no_factor(tmp_path: Path, sentence: str, verdict: str) -> None:
    (tmp_path / "p.md").write_text(f"Of {sentence} we know:\n\n$$ a = R \\, g(R^T b) $$\n")
    kinds = "'R' = 'rotation'\n" + "\n".join(f"'{name}' = 'vector'" for name in "abgN")
    (tmp_path / "p.toml").write_text(f"source = 'p.md'\n[symbols]\n{kinds}\n")
    (claim,) = json.loads(run("check", str(tmp_path / "p.toml"), "--no-proposals", "--json").stdout)["claims"]
    assert claim["verdict"] == verdict


FRAMED = """
source = "p.tex"
frames = { base = "N", names = ["A", "B"], dot = "N", '{}^F R^G' = "rotation to F from G" }
symbols = { 'q' = { kind = "scalar" } }
"""
TURN = r"\begin{bmatrix} \cos q & -\sin q & 0 \\ \sin q & \cos q & 0 \\ 0 & 0 & 1 \end{bmatrix}"


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (rf"{{}}^A R^B = {TURN}", "definition"),
        (r"{}^A R^N = {}^A R^B {}^B R^N", "proved"),
        (r"{}^A R^N = {}^A R^B {}^N R^B", "refuted"),
    ],
)
def test_a_formula_may_say_what_frames_leave_open(tmp_path: Path, formula: str, verdict: str) -> None:
    (tmp_path / "p.tex").write_text(rf"\[ {formula} \]")
    (tmp_path / "p.toml").write_text(FRAMED)
    (claim,) = json.loads(run("check", str(tmp_path / "p.toml"), "--no-proposals", "--json").stdout)["claims"]
    assert claim["verdict"] == verdict
