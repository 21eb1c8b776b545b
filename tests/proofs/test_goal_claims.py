"""The chapter's goals: tampered with, each fails; so does a proof with another witness."""

import re
import tomllib
from pathlib import Path

import pytest

import proofs
from workbench.app.pipeline.judge_claims import PaperJudge
from workbench.core.verdict import Outcome, Verdict
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import Scope
from workbench.language.goals.proofs import Kernel, Proven
from workbench.papers import PaperError
from workbench.papers.load import find_paper, merge
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove

CHAPTER = Path(proofs.__file__).parent / "chapter"
FILES = sorted(CHAPTER.glob("[0-9]*.toml"))
NONSENSE = r"\Phi_n = = 7 \nonsense{"
CLAIMS = {claim.id: claim for claim in find_paper().claims}
QUICK = ("48.uniquely", "Theorem_3.exists", "71", "Theorem5", "82.translation", "92.field")


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_with_nonsense_printed_every_claim_fails(file, tmp_path):
    """Each has a fault of its own, within its own lines."""
    head, *tables = re.split(r"(?m)^(?=\[\[claim\]\]$)", file.read_text("utf-8"))
    for notation in CHAPTER.glob("notation.toml"):
        (tmp_path / notation.name).write_text(notation.read_text("utf-8"), "utf-8")
    text, places = head, []
    for table in tables:
        (claim,) = tomllib.loads(table)["claim"]
        table = re.sub(r"(?ms)^inherits = .*?\n", "", table)
        if "printed" in claim:
            table = re.sub(r"(?ms)^printed = ('''.*?'''|'.*?')\n", "", table)
        table = table.replace("[[claim]]\n", f"[[claim]]\nprinted = '{NONSENSE}'\n", 1)
        assert tomllib.loads(table)["claim"][0]["printed"] == NONSENSE
        first, text = text.count("\n"), text + table
        places.append(range(first + 1, text.count("\n") + 1))
    damaged = tmp_path / file.name
    damaged.write_text(text, "utf-8")
    with pytest.raises(PaperError) as caught:
        merge([damaged], proofs.chapter.theorems)
    faults = {f.line for f in caught.value.faults if "printed" in f.message or r"\nonsense" in f.message}
    assert places and all(faults & {*lines} for lines in places)


def verdict(name: str, goal: str | None = None, theorem: Proven | None = None) -> Verdict:
    claim = CLAIMS[name]
    scope = Scope(claim.notation.symbols, claim.notation.definitions, {})
    if theorem is None:
        theorem = proofs.chapter.theorems[claim.proof.theorem]
    read = claim.proof.goal.goal if goal is None else read_goal(goal, scope)
    bare = claim.proof.goal.bare if claim.correction.hypothesis else None
    return prove(read, scope, Judge(claim.notation.definitions), theorem, claim.supposed, bare)


@pytest.mark.parametrize("name", QUICK)
def test_goals_are_shown(name):
    expected = Outcome.CONDITIONAL if CLAIMS[name].correction.hypothesis else Outcome.PROVED
    assert verdict(name).outcome == expected == CLAIMS[name].expected


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("Theorem_1", r"\exists! B", r"\exists B"),
        ("Theorem_1", r"\boldsymbol{\rho}", r"2 \boldsymbol{\rho}"),
        ("21.every_n", r"n \geq 2", r"n \geq 1"),
        ("Theorem_3.exists", r"\forall n \geq 1 : \exists P", r"\forall n \geq 1 : \exists! P"),
        ("Theorem_3.exists", r"P \mathbf{v}", r"P \dot{\mathbf{v}}"),
        ("71", r"\operatorname{Re}(p) \neq 0", r"p \neq 0"),
        ("Theorem5", r"Q \in SO_3", r"Q \in \underline{SO}_3"),
        ("Theorem5", r"\exists!", r"\exists"),
        ("104.origin", r"\rho = \mathbf{0} \Rightarrow", ""),
        ("109.all", r"n \geq 0", r"n \geq 0 : \forall x \in V_3"),
        ("92.field", r"m + w \times", r"m - w \times"),
        ("76.definition", r"b \cdot (S a)", r"a \cdot (S b)"),
    ],
)
def test_another_goal_is_not_shown_by_the_proof(name, old, new):
    goal = CLAIMS[name].proof.goal.latex
    assert old in goal
    if new.endswith("x \\in V_3"):  # an idle ∀ does not change what is said
        assert verdict(name, goal.replace(old, new, 1)).outcome == Outcome.PROVED
        return
    assert verdict(name, goal.replace(old, new, 1)).outcome == Outcome.UNCHECKED


def test_a_goal_joined_in_prose_is_argued_not_proved():
    judge = PaperJudge(find_paper(), motions=False)
    result = judge.result(CLAIMS["80.series"])
    judge.close()
    assert (result.verdict.outcome, result.passed) == (Outcome.ARGUED, True)
    assert verdict("80.series", theorem=Proven(Kernel())).outcome == Outcome.PROVED


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (r"= -\tilde{w} ", r"= \tilde{w} "),
        (r"\tilde{w}^4 = -", r"\tilde{w}^4 = "),
        (r"= \dot{p} \tilde{w} (", r"= \tilde{w} ("),
        (r"\sin(p - p)", r"\sin(p)"),
        (r"\dot{Y} = \dot{p}", r"\dot{Y} = 2 \dot{p}"),
        (r"\dot{Y} = \dot{p} \tilde{w} Y", r"Y = Y"),
    ],
)
def test_each_part_of_an_argued_goal_counts(old, new):
    claim = CLAIMS["80.series"]
    goal = claim.proof.goal.latex.replace(r"\printed", claim.printed.latex)
    assert old in goal
    assert verdict(claim.id, goal.replace(old, new, 1), Proven(Kernel())).outcome != Outcome.PROVED
