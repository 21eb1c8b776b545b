"""The grade of a verdict follows from its outcome and its basis, the same in every output."""

import json
from dataclasses import replace
from itertools import product
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from tests.planted import planted
from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.codes.doubt_codes import DoubtCode, as_one_doubt, single_doubts
from workbench.core.reasons import Reason
from workbench.core.verdict import Grade, Outcome, Strength, Verdict, grade_of
from workbench.papers.load import load_paper
from workbench.report.findings import findings, sarif

MODEL = """source = "t.md"
[symbols]
a = "vector"
b = "vector"
f = { kind = "scalar", free = true }
"""
FALSE = {Outcome.REFUTED, Outcome.ILL_FORMED}
TRUE = {Outcome.PROVED, Outcome.CONDITIONAL}


@pytest.mark.parametrize(
    ("outcome", "basis", "unless", "grade"),
    [
        ("proved", "DECLARED", 0, "ok"),
        ("conditional", "STATED", 0, "ok"),
        ("conditional", "HINTED", 0, "note"),
        ("refuted", "DECLARED", 0, "error"),
        ("refuted", "STATED", 0, "error"),
        ("refuted", "STATED", 1, "warning"),
        ("refuted", "HINTED", 0, "warning"),
        ("refuted", "GUESSED", 0, "warning"),
        ("refuted", "GUESSED", 2, "note"),
        ("refuted", "DECLARED", 2, "note"),
        ("proved", "GUESSED", 0, "ok"),
        ("ill-formed", "GUESSED", 0, "warning"),
        ("definition", "STATED", 0, "note"),
        ("argued", "DECLARED", 0, "note"),
        ("probable", "DECLARED", 0, "not judged"),
        ("unchecked", "DECLARED", 0, "not judged"),
    ],
)
def test_grade_follows_from_outcome_basis_and_doubts(
    outcome: str, basis: str, unless: int, grade: str
) -> None:
    assert grade_of(Outcome(outcome), Strength[basis], ["doubt"] * unless) == grade


def test_grade_is_lowered_and_never_raised_by_a_doubt() -> None:
    order = [Grade.ERROR, Grade.WARNING, Grade.NOTE]
    for outcome, basis, count in product(FALSE, Strength, range(4)):
        grades = [grade_of(outcome, basis, ["doubt"] * number) for number in (count, count + 1)]
        assert order.index(grades[0]) <= order.index(grades[1])


def test_grade_of_what_is_true_is_never_a_fault() -> None:
    shown = {grade_of(outcome, basis, ()) for outcome, basis in product(TRUE, Strength)}
    assert shown == {Grade.OK, Grade.NOTE}


DOUBTS = st.text().map(lambda name: DoubtCode.SOMETHING_ELSE(name=name))


@given(st.sampled_from(Outcome), st.sampled_from(Strength), st.lists(DOUBTS, max_size=3).map(tuple))
def test_verdict_comes_back_from_json_with_its_grade(
    outcome: Outcome, basis: Strength, unless: tuple[Reason, ...]
) -> None:
    verdict = planted(outcome, basis=basis, unless=unless)
    again = Verdict.from_dict(json.loads(json.dumps(verdict.to_dict())), verdict.proof)
    assert again == verdict and again.grade is verdict.grade
    assert [each.code for each in again.unless] == [DoubtCode.SOMETHING_ELSE] * len(unless)


def test_several_doubts_count_once_and_can_be_told_apart() -> None:
    (doubt,) = as_one_doubt([DoubtCode.NOT_TRIED(), DoubtCode.OTHER_DOTS(), DoubtCode.NOT_TRIED()])
    assert list(single_doubts(doubt)) == [DoubtCode.NOT_TRIED(), DoubtCode.OTHER_DOTS()]
    assert str(doubt) == "; ".join(single_doubts(doubt)) and as_one_doubt([]) == ()


def judged(folder: Path, text: str):
    (folder / "t.md").write_text(text, encoding="utf-8")
    (folder / "t.toml").write_text(MODEL, encoding="utf-8")
    paper = load_paper(folder / "t.toml", faults=[])
    return paper, judge_paper(paper, motions=False)


@pytest.mark.parametrize("unless, level", [((), "error"), (("a is b",), "warning"), (("a", "b"), "note")])
def test_level_of_a_finding_is_the_grade(tmp_path: Path, unless: tuple[str, ...], level: str) -> None:
    paper, (result,) = judged(tmp_path, "Here $$f a = a f f$$ stands.")
    result = replace(result, verdict=replace(result.verdict, unless=unless))
    (finding,) = findings(paper, [result])
    assert (finding.code, finding.level) == ("refuted", level)
    assert all(doubt in finding.message for doubt in unless)


@pytest.mark.parametrize("outcome", Outcome)
def test_finding_of_each_outcome_has_a_rule_of_sarif(tmp_path: Path, outcome: Outcome) -> None:
    paper, (result,) = judged(tmp_path, "Here $$f a = a f f$$ stands.")
    result = replace(result, verdict=planted(outcome, evidence=result.verdict.evidence))
    found = findings(paper, [result])
    run = sarif(found, "1")["runs"][0]
    assert [rule["id"] for rule in run["tool"]["driver"]["rules"]] == [each.code for each in found]


def status(folder: Path, text: str, *options: str) -> tuple[int, dict]:
    judged(folder, text)
    call = ["check", "--no-motions", "--no-proposals", "--no-cache", "--format", "json", *options]
    done = CliRunner().invoke(main, [*call, str(folder / "t.toml")])
    return done.exit_code, json.loads(done.stdout)


def test_report_names_grade_basis_and_doubts_of_each_claim(tmp_path: Path) -> None:
    code, report = status(tmp_path, "Here $$a \\times b = -b \\times a$$ and $$f a = a f f$$ stand.")
    told = [{key: claim[key] for key in ("grade", "basis", "unless")} for claim in report["claims"]]
    assert told == [
        {"grade": "ok", "basis": "declared", "unless": []},
        {"grade": "error", "basis": "declared", "unless": []},
    ]
    assert code == 1


@pytest.mark.parametrize("options", [(), ("--strict",)])
def test_status_is_0_where_a_formula_is_not_judged(tmp_path: Path, options: tuple[str, ...]) -> None:
    text = "Here $$a \\times b = -b \\times a$$ and $$a \\times q_1 = 0$$ stand."
    assert status(tmp_path, text, *options)[0] == 0
