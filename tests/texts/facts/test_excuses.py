"""What a text says elsewhere silences no falsehood of which it does not speak, and proves nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.texts.written import (
    ALPHABETS,
    FORMATS,
    display,
    heading,
    inline,
    line_of,
    model_of,
    paper_of,
    renamed,
    text_of,
    told,
    verdicts,
)
from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers.load import load_paper

WRITTEN = list(zip(ALPHABETS, FORMATS, strict=True))
FALSE = [
    r"<a> \times <b> = <b> \times <a>",
    r"(<a> + <b>)^2 = <a>^2 + <b>^2",
    r"<f> (<g> + <f>) = <f> <g> + <f>",
]
#: A false assertion, and what would follow from it.
FALSE_GIVEN = [
    (FALSE[0], r"2 <a> \times <b> = 0"),
    (FALSE[1], r"<a> \cdot <b> = 0"),
    (FALSE[2], r"<f>^2 = <f>"),
]
#: A postulate, and what follows from it.
POSTULATES = [
    (r"\ddot{<a>} = <b>", r"\ddot{<a>} \cdot <a> = <a> \cdot <b>"),
    (r"<a> \cdot <a> = 1", r"(<a> \cdot <a>) <f> = <f>"),
    (r"<a> = <f> <b>", r"<a> \times <b> = 0"),
]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize(("given", "follows"), FALSE_GIVEN)
def test_a_false_given_is_refuted_and_proves_nothing(
    tmp_path: Path, letters: dict[str, str], form: str, given: str, follows: str
) -> None:
    given, follows = renamed(given, letters), renamed(follows, letters)
    text = text_of([display(given, form), display(follows, form)], form)
    entry = f"[[claim]]\nat = '{line_of(follows, text)}'\ngiven = ['{line_of(given, text)}']\n"
    first, last = verdicts(tmp_path, text, model_of(letters, form, entry), form)
    assert first.outcome == "refuted" and first.counterexample is not None
    assert last.outcome == "conditional" and "is given, and false by itself" in last.reason


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize(("given", "follows"), POSTULATES)
def test_a_postulate_that_is_given_proves_what_follows(
    tmp_path: Path, letters: dict[str, str], form: str, given: str, follows: str
) -> None:
    given, follows = renamed(given, letters), renamed(follows, letters)
    text = text_of([display(given, form), display(follows, form)], form)
    entry = f"[[claim]]\nat = '{line_of(follows, text)}'\ngiven = ['{line_of(given, text)}']\n"
    first, last = verdicts(tmp_path, text, model_of(letters, form, entry), form)
    assert (told(first), last.outcome) == ("said", "proved")


#: Sentences before a falsehood about a and b that speak of no symbol of it, or say what is known anyway.
IRRELEVANT = [
    ("where {} is a matrix with the identity in its corner, and", "<h> _4"),
    ("For {} that are constant we have", "<g>"),
    ("Suppose that {} vanishes. Then", "<h>"),
    ("With {},", r"<h> = <f> + <g>"),
]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize(("sentence", "speaks_of"), IRRELEVANT)
def test_a_sentence_about_other_symbols_excuses_nothing(
    tmp_path: Path, letters: dict[str, str], form: str, sentence: str, speaks_of: str
) -> None:
    said = sentence.format(inline(renamed(speaks_of, letters), form))
    for false in FALSE[:2]:
        text = text_of([said, display(renamed(false, letters), form)], form)
        (verdict,) = verdicts(tmp_path, text, model_of(letters, form), form)
        assert verdict.outcome == "refuted", said


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
def test_a_sentence_that_repeats_a_definition_excuses_nothing(
    tmp_path: Path, letters: dict[str, str], form: str
) -> None:
    body = renamed(r"\frac{<a>}{\|<a>\|}", letters)
    false = renamed(
        r"\exp(\tilde{<a>}) = \mathbf{I} + \tilde{n} \sin \|<a>\| + \tilde{n}^2 \cos \|<a>\|", letters
    )
    text = text_of([f"With {inline(f'n = {body}', form)}", display(false, form)], form)
    model = model_of(letters, form, f"[definitions]\n'n' = '{body}'\n")
    (verdict,) = verdicts(tmp_path, text, model, form)
    assert verdict.outcome == "refuted"


#: What a section may suppose, and what holds only then.
CONDITIONS = [
    (r"where {},", r"<a> \cdot <b> = 0", r"(<a> + <b>)^2 = <a>^2 + <b>^2"),
    (r"Suppose that {}. Then", r"<f> \neq 0", r"<f> <g> = <f> \Rightarrow <g> = 1"),
    (r"With {} it is", r"<f> = 0", r"<f> (<g> + <h>) = <f> (<g> - <h>)"),
]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize(("sentence", "condition", "formula"), CONDITIONS)
def test_a_condition_ends_with_its_section(
    tmp_path: Path, letters: dict[str, str], form: str, sentence: str, condition: str, formula: str
) -> None:
    said = sentence.format(inline(renamed(condition, letters), form))
    shown = display(renamed(formula, letters), form)
    one, two = heading("One", form), heading("Two", form)
    for again in ("In general, for all of these", "We repeat it without more"):
        text = text_of(
            [one, f"{said}\n\n{shown}" if form == "rst" else f"{said}\n{shown}", two, again, shown], form
        )
        inside, behind = verdicts(tmp_path, text, model_of(letters, form), form)
        assert (inside.outcome, behind.outcome) == ("conditional", "refuted")


#: A formula that stands first, one with a condition beside it, and a false one that holds by the condition.
BESIDE = [
    (r"<a> \times <b> = -<b> \times <a>", r"<f> <a> \times <b> = 0", r"<a> = 2 <b>"),
    (r"<f> + <g> = <g> + <f>", r"<g> + <f> = <g>", r"<f> = 0"),
    (r"\|<a>\|^2 = <a> \cdot <a>", r"\|<a> + <b>\|^2 = \|<a>\|^2 + \|<b>\|^2", r"<a> \cdot <b> = 0"),
]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize("words", [r"\text{with } ", r"\text{where } ", r"\text{using } ", ""])
@pytest.mark.parametrize(("first", "formula", "condition"), BESIDE)
def test_condition_beside_a_formula_excuses_no_other(
    tmp_path: Path, letters: dict[str, str], form: str, words: str, first: str, formula: str, condition: str
) -> None:
    shown = [first, rf"{formula}, \quad {words}{condition}", f"1 {formula}"]
    text = text_of(["So", *(f"{display(renamed(each, letters), form)}\n\nand" for each in shown)], form)
    found = verdicts(tmp_path, text, model_of(letters, form), form)
    assert found[0].outcome == "proved"
    assert found[1].outcome in ("proved", "conditional", "unchecked")
    assert found[-1].outcome in ("refuted", "definition")


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
def test_a_condition_before_the_sections_holds_in_all(
    tmp_path: Path, letters: dict[str, str], form: str
) -> None:
    condition = inline(renamed(CONDITIONS[1][1], letters), form)
    said = f"We suppose that {condition} here."
    shown = display(renamed(CONDITIONS[1][2], letters), form)
    text = text_of([said, heading("One", form), "So", shown], form)
    (verdict,) = verdicts(tmp_path, text, model_of(letters, form), form)
    assert verdict.outcome == "conditional"


def test_a_condition_holds_in_the_sections_below(tmp_path: Path) -> None:
    shown = display(renamed(CONDITIONS[1][2], ALPHABETS[0]), "md")
    for deeper, expected in (("##", "conditional"), ("#", "refuted")):
        text = f"# One\n\nLet $f \\neq 0$ be so.\n\n{deeper} Two\n\n{shown}\n"
        (verdict,) = verdicts(tmp_path, text, model_of(ALPHABETS[0], "md"), "md")
        assert verdict.outcome == expected


#: What is said of a before a scope that declares it anew, and a falsehood about the other a.
BEFORE_SCOPE = [
    (display, r"<a> = 2 <b>", r"<a> \times <b> = 0"),
    (display, r"<a> = \int <b>", r"<a> \cdot <a> \times <b> + <a> \cdot <a> = 0"),
    (inline, r"<a> = \int <b>", r"<a> \times <b> = <b> \times <a>"),
    (
        inline,
        r"\dot{<a>} = <b>",
        r"\ddot{<a>} \times \dot{<b>} \cdot <b> + \ddot{<a>} \cdot \ddot{<a>} = <f> - <f>",
    ),
]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize(("shape", "said", "formula"), BEFORE_SCOPE)
def test_the_old_meaning_of_a_symbol_is_not_used(
    tmp_path: Path, letters: dict[str, str], form: str, shape, said: str, formula: str
) -> None:
    said, formula = (renamed(each, letters) for each in (said, formula))
    before = [heading("One", form), "So it is: " * (shape is inline) + shape(said, form)]
    if shape is inline:
        before.append(display("1 + 1 = 2", form))
    text = text_of([*before, heading("Two", form), display(formula, form)], form)
    scope = f"[[scope]]\nfrom = 'Two'\nsymbols = {{ '{letters['a']}' = 'vector' }}\n"
    told = verdicts(tmp_path, text, model_of(letters, form, scope), form)[-1]
    alone = text_of([display(formula, form)], form)
    fresh = verdicts(tmp_path, alone, model_of(letters, form), form)[-1]
    assert (told.outcome, told.reason, told.counterexample) == (
        fresh.outcome,
        fresh.reason,
        fresh.counterexample,
    )


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
def test_a_given_formula_means_what_it_says_there(tmp_path: Path, letters: dict[str, str], form: str) -> None:
    given, formula = (renamed(each, letters) for each in (r"<a> = 2 <b>", r"<a> \times <b> = 0"))
    text = text_of([display(given, form), heading("Two", form), display(formula, form)], form)
    entry = f"[[claim]]\nat = '{line_of(formula, text)}'\ngiven = ['{line_of(given, text)}']\n"
    scope = f"[[scope]]\nfrom = 'Two'\nsymbols = {{ '{letters['a']}' = 'vector' }}\n"
    paper = paper_of(tmp_path, text, model_of(letters, form, scope + entry), form)
    (fault,) = paper.faults
    assert "given:" in str(fault) and "declares" in str(fault) and "expected a formula" in str(fault)
    assert paper_of(tmp_path, text, model_of(letters, form, entry), form).faults == ()


#: Ways to assume a formula left = right without saying it.
ASSUMED = {
    "itself": "{left} = {right}",
    "its sides swapped": "{right} = {left}",
    "a multiple": "3 ({left}) = 3 ({right})",
    "a negative part of it": r"-\frac{{1}}{{2}} ({right}) = -\frac{{1}}{{2}} ({left})",
    "a constant times it": r"\frac{{{left}}}{{{m}}} = \frac{{{right}}}{{{m}}}",
    "a difference": "({left}) - ({right}) = 0",
    "a part of more": "{h} = 1, {left} = {right}",
    "a part of more, first": "{right} = {left}, {h} = {f}",
    "its definition": "{defined} = {right}",
}
CONCLUSIONS = [
    (r"<a> \times <b>", r"<b> \times <a>"),
    (r"(<a> + <b>)^2", r"<a>^2 + <b>^2"),
    (r"<f> (<g> + <f>)", r"<f> <g> + <f>"),
    (r"\dot{<f>} <g>", r"<f> \sin <x>"),
]


@pytest.mark.parametrize("how", ASSUMED)
@pytest.mark.parametrize(("left", "right"), CONCLUSIONS)
def test_a_circular_condition_is_reported(tmp_path: Path, left: str, right: str, how: str) -> None:
    for place, letters in enumerate(ALPHABETS):
        form = FORMATS[place % len(FORMATS)]
        one, other = renamed(left, letters), renamed(right, letters)
        names = {"left": one, "right": other, "defined": "Q", **letters}
        text = text_of([display(f"{one} = {other}", form)], form)
        more = f"[definitions]\n'Q' = '{one}'\n[[claim]]\nat = '{line_of(f'{one} = {other}', text)}'\n"
        assumed = f"assume = ['{ASSUMED[how].format(**names)}']\n"
        paper = paper_of(tmp_path, text, model_of(letters, form, more + assumed), form)
        (fault,) = paper.faults
        assert "assume: expected a condition" in str(fault) and "strike it out" in str(fault)
        assert fault.line is not None and fault.column is not None
        assert [r.verdict.outcome for r in judge_paper(paper, motions=False)] == ["unchecked"]


def test_an_assumed_conclusion_exits_with_1(tmp_path: Path) -> None:
    text = "\n\n".join([display("f g = f", "md"), display("f g = g f", "md")])
    for key in ("assume = ['f = f g']", "hypothesis = '2 f = 2 f g'"):
        entry = f"[[claim]]\nat = 'line 2'\n{key}\n"
        paper_of(tmp_path, text, model_of(ALPHABETS[0], "md", entry), "md")
        result = CliRunner().invoke(main, ["check", str(tmp_path / "p.toml")])
        assert result.exit_code == 1 and "the formula itself" in result.output


@pytest.mark.parametrize(
    ("formula", "assumed"),
    [
        ("<f> <g> = <f>", "<g> = 1"),
        ("<f> = <g>", "<f> = <h>, <h> = <g>"),
        ("<f> = <g>", "<h> <f> = <h> <g>"),
        ("<f>^2 = <g>^2", "<f> = <g>"),
        (r"<a> \times <b> = 0", "<a> = <f> <b>"),
        (r"<f> <g> = <f> \Rightarrow <g> = 1", r"<f> \neq 0"),
        (r"\dot{<f>} = <g>", "<f> = <g>"),
        ("<m> = 2", "3 <m> = 2"),
    ],
)
def test_another_condition_may_be_assumed(tmp_path: Path, formula: str, assumed: str) -> None:
    for letters, form in WRITTEN:
        text = text_of([display(renamed(formula, letters), form)], form)
        line = line_of(renamed(formula, letters), text)
        entry = f"[[claim]]\nat = '{line}'\nassume = ['{renamed(assumed, letters)}']\n"
        assert paper_of(tmp_path, text, model_of(letters, form, entry), form).faults == ()


#: Equations that no values satisfy, and such that some do.
IMPOSSIBLE = [
    r"\operatorname{tr}(\tilde{<a>}) = 1",
    r"\cos^2 <x> + \sin^2 <x> = 2",
    r"<a> \cdot (<a> \times <b>) = 1",
    r"<f> - <f> = 1",
    r"\cos\pi = 1",
]
POSSIBLE = [r"<f>^2 = 1", r"\cos <x> = 1", r"<a> \cdot <b> = 1"]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
def test_unsatisfiable_formulas_constrain_no_symbol(
    tmp_path: Path, letters: dict[str, str], form: str
) -> None:
    for formulas, expected in ((IMPOSSIBLE, "refuted"), (POSSIBLE, "said")):
        for formula in formulas:
            text = text_of([display(renamed(formula, letters), form)], form)
            (verdict,) = verdicts(tmp_path, text, model_of(letters, form), form)
            assert told(verdict) == expected, formula


#: A definition, a falsehood that seems to say what a symbol is, and one that does.
UNFOLDED = [
    (r"<f> \cos <x> + <g> \sin <x>", r"Q = <f> \cos <x>", r"Q = <f> \cos <h>"),
    (r"2 <a>", "<a> = Q", "<b> = Q"),
    (r"<g> <f>", r"<f> = Q + <g>", r"<h> = Q + <g>"),
    (r"\dot{<f>} + <g>", r"\dot{<f>} = Q", r"\dot{<h>} = Q"),
]


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize(("body", "false", "says"), UNFOLDED)
def test_a_symbol_behind_a_definition_is_not_said(
    tmp_path: Path, letters: dict[str, str], form: str, body: str, false: str, says: str
) -> None:
    more = f"[definitions]\n'Q' = '{renamed(body, letters)}'\n"
    text = text_of([display(renamed(each, letters), form) for each in (false, says)], form)
    first, last = verdicts(tmp_path, text, model_of(letters, form, more), form)
    assert (first.outcome, told(last)) == ("refuted", "said")


DENIALS = [
    r"\text{Wrong: } %s",
    r"\text{not } %s",
    r"%s \quad \text{is false}",
    r"\mbox{It is incorrect that } %s",
]
ASSENTS = [r"\text{Note: } %s", r"\text{and } %s"]


@pytest.mark.parametrize("words", DENIALS + ASSENTS)
def test_words_that_negate_a_formula_are_recognized(tmp_path: Path, words: str) -> None:
    for letters, form in WRITTEN:
        true = renamed(words % r"<a> \times <b> = -<b> \times <a>", letters)
        (verdict,) = verdicts(tmp_path, text_of([display(true, form)], form), model_of(letters, form), form)
        assert (verdict.outcome == "proved") is (words in ASSENTS), verdict.reason


SILENT = r"""
\begin{equation} \det J = l_1 l_2 \cos\theta_2 \end{equation}
\begin{equation} \operatorname{tr} R = 1 + 3\cos\theta \end{equation}
"""
SILENT_MODEL = r"""source = "p.tex"
[symbols]
'l_1' = { kind = "scalar", constant = true }
'l_2' = { kind = "scalar", constant = true }
'\theta_1' = "scalar"
'\theta_2' = "scalar"
'\theta' = "scalar"
'u' = { kind = "vector", unit = true }
[definitions]
'J' = '\begin{bmatrix} -l_1\sin\theta_1 - l_2\sin(\theta_1+\theta_2) & -l_2\sin(\theta_1+\theta_2) \\ l_1\cos\theta_1 + l_2\cos(\theta_1+\theta_2) & l_2\cos(\theta_1+\theta_2) \end{bmatrix}'
'R' = '\mathbf{I} + \sin\theta \tilde{u} + (1-\cos\theta) \tilde{u}^2'
"""


def test_no_falsehood_about_defined_matrices_is_silent(tmp_path: Path) -> None:
    (tmp_path / "p.tex").write_text(SILENT)
    (tmp_path / "p.toml").write_text(SILENT_MODEL)
    results = judge_paper(load_paper(tmp_path / "p.toml"), motions=False)
    assert [result.verdict.outcome for result in results] == ["refuted", "refuted"]
    for right in (("\\cos\\theta_2", "\\sin\\theta_2"), ("1 + 3", "1 + 2")):
        (tmp_path / "p.tex").write_text((tmp_path / "p.tex").read_text().replace(*right))
    results = judge_paper(load_paper(tmp_path / "p.toml"), motions=False)
    assert [result.verdict.outcome for result in results] == ["proved", "proved"]
