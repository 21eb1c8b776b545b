"""What Coq says of the certificates; skipped where there is no coqc."""

import re
from dataclasses import replace

import pytest
from click.testing import CliRunner

from tests.certificates.emitted import JOINED, joined, one
from tests.planted import planted
from tests.proofs.tampering import made_false, with_a_changed_conclusion
from workbench import check
from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import ClaimResult
from workbench.certificates import coqc
from workbench.certificates.certified_forms import Certificate
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.goals.goal_theorem import whole
from workbench.certificates.refutation import not_empty
from workbench.certificates.steps import steps_of
from workbench.certificates.theorem import theorem
from workbench.core.verdict import Outcome
from workbench.language.goals.goals import Scope
from workbench.papers import find_paper

pytestmark = [
    pytest.mark.slow,  # compiling the library takes half a minute
    pytest.mark.skipif(coqc.version() is None, reason=f"no coqc: {coqc.INSTALL}"),
]


@pytest.mark.parametrize("name", ["58.det", "3.Phi_2", "25", "60.div", "139.fixed", "53.split", "83.1"])
def test_a_certificate_is_accepted_without_axioms(name):
    said = coqc.check(one(name).text, remember=False)
    assert said.accepted, said.fault
    assert said.axioms == ()


def test_an_axiom_is_reported():
    text = (
        one("58.det").text.replace(
            "Print Assumptions",
            "Axiom wrong : False.\nTheorem t : False. exact wrong. Qed.\nPrint Assumptions t. (*",
        )
        + " *)"
    )
    said = coqc.check(text, remember=False)
    assert said.accepted
    assert said.axioms == ("wrong",)
    assert not said.expected


def test_a_wrong_statement_is_refused():
    text = one("58.det").text.replace("≡ - square", "≡ square")
    assert not coqc.check(text, remember=False).accepted


def test_the_command_prints_the_axioms_and_fails_loudly(tmp_path, monkeypatch):
    done = CliRunner().invoke(main, ["certify", "58.det", "--check", "--out", str(tmp_path)])
    assert done.exit_code == 0, done.output
    assert "no axioms" in done.output
    assert (tmp_path / "claim_58_det_printed.v").exists()
    monkeypatch.setattr(coqc, "recall", lambda text: coqc.Checked(False, (), "refused", 0.0))
    broken = CliRunner().invoke(main, ["certify", "58.det", "--check"])
    assert broken.exit_code == 3


@pytest.mark.parametrize("name", ["76", "70.div", "113.P1", "132.total", "64", "124.power"])
def test_a_refutation_is_accepted_on_the_axioms_of_the_reals(name):
    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.certificates.certify import exact_forms, written

    results = [r for r in judge_paper(find_paper("chapter"), [name]) if r.claim.id == name]
    (made,) = [written(f, v).certificate for f, _, v in exact_forms(results) if v.outcome == "refuted"]
    assert made.theorems[0].statement.startswith(f"Theorem {made.theorems[0].name} : ~ forall")
    said = coqc.check(made.text, remember=False)
    assert said.accepted, said.fault
    assert said.axioms
    assert said.expected


@pytest.mark.parametrize(
    ("name", "form"),
    [("58.nonsingular", "printed"), ("61.nonsingular", "reading"), ("10.invertible", "printed")],
)
def test_equivalent_disequations_are_accepted(name, form):
    said = coqc.check(one(name, form).text, remember=False)
    assert said.accepted, said.fault
    assert said.expected


def test_an_inequation_with_a_wrong_partner_is_refused():
    text = one("58.nonsingular").text.replace(
        "equal_at now (omega × D omega)", "equal_at now (omega + D omega)"
    )
    assert not coqc.check(text, remember=False).accepted


@pytest.mark.parametrize(("name", "form"), [("3.skew", "printed"), ("59", "reading"), ("49", "printed")])
def test_a_motion_that_meets_the_premises_is_accepted(name, form):
    said = coqc.check(not_empty(one(name, form)).text, remember=False)
    assert said.accepted, said.fault
    assert said.expected


def test_a_motion_that_does_not_meet_them_is_refused():
    right = not_empty(one("59", "reading")).text
    text = re.sub(r"number \((-?\d+) # (\d+)\)", r"number (\1 # 7\2)", right)
    assert text != right
    assert not coqc.check(text, remember=False).accepted


def test_handwritten_theorems_need_no_axioms_and_complete_proofs():
    hand = find_paper("chapter").paths[0].parent.parent / "certificates" / "theorems.v"
    text = hand.read_text("utf-8")
    said = coqc.check(coqc.with_assumptions(text))
    assert said.accepted, said.fault
    assert said.axioms == ()
    start, _, _ = text.partition("(* on 20.Phi")
    omitted = "Theorem omitted : False. Proof. Admitted.\n"
    assert coqc.check(coqc.with_assumptions(start + omitted), remember=False).axioms == ("omitted",)
    with pytest.raises(coqc.CoqFault):
        coqc.with_assumptions("Definition x := 1.")


@pytest.mark.parametrize("name", ["76.definition", "92.origin", "Remark7.translations", "Theorem_1", "119"])
def test_a_goal_is_one_theorem(name):
    (text,) = goal_texts(name)
    said = coqc.check(text, remember=False)
    assert said.accepted, said.fault
    assert said.axioms
    assert said.expected


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("76.definition", "(b · (S_' @ a)))", "(b · (u_T @ a)))"),
        (
            "76.definition",
            "exists (S_' : dual_tensor K), constant",
            "exists (S_' : dual_tensor K), ~ constant",
        ),
        ("92.origin", "(D (rho + R @ r)) v)", "(D (R @ r)) v)"),
        ("92.origin", "(rho + R @ r) (zero : vector K) -> ", ""),
        ("Remark7.translations", "embed v))", "embed u))"),
        ("21.every_n", "(2 <= n)%nat", "(1 <= n)%nat"),  # of every n: another bound,
        ("21.every_n", "(pred (pred n))", "(pred n)"),  # another conclusion,
        (
            "117",
            " (u_R_rotation : forall i0 i1 : nat, dual_rotation (u_R i0 i1))",
            "",
        ),  # without a hypothesis,
        ("119", "u_Q_n ∘ u_R i (S i)", "u_Q_n ∘ u_R i i"),  # of another family,
        ("21.every_n", "K n_less_2 R", "K (S n_less_2) R"),  # by a step about another n
    ],
)
def test_a_goal_that_says_something_else_is_refused(name, old, new):
    (text,) = goal_texts(name)
    start, mark, statement = text.partition("Theorem claim_")
    assert old in statement
    assert not coqc.check(start + mark + statement.replace(old, new, 1), remember=False).accepted


@pytest.mark.parametrize("name", JOINED)
def test_a_false_goal_with_a_proof_of_its_own_is_refused(name):
    """The proof is written anew for the goal with a conclusion that is false."""
    (claim,) = [c for c in find_paper("chapter").claims if c.id == name]
    changed = list(with_a_changed_conclusion(claim.proof.goal.goal, made_false))
    assert changed
    texts = [text for goal in changed[:: max(1, len(changed) // 3)] for text in goal_texts(name, goal)]
    assert texts or " : nat, " in joined()[name].proposition  # whose false steps are not written
    assert not any(coqc.check(text, remember=False).accepted for text in texts)


def goal_texts(name, goal=None):
    """The certificate of a claim's goal, or of another goal by its proof; nothing if none can be written."""
    paper = find_paper("chapter")
    (claim,) = [c for c in paper.claims if c.id == name]
    if goal is not None:
        claim = replace(claim, proof=replace(claim.proof, goal=replace(claim.proof.goal, goal=goal)))
    scope = Scope(claim.notation.symbols, claim.notation.definitions, {})
    try:
        return [whole(claim, scope, paper.theorems[claim.proof.theorem].proof).text]
    except NotCertified:
        return []


NORM = {"a": "vector", "b": "vector"}


@pytest.mark.parametrize(
    ("formula", "accepted"),
    [
        (r"\|a\|^2 \|b\|^2 = (a \times b)^2 + (a \cdot b)^2", True),
        (r"\frac{a \cdot a}{\|a\|} = \|a\|", True),
        (r"\|a\|^2 \|b\|^2 = (a \times b)^2 - (a \cdot b)^2", False),
        (r"\|a\| \|b\| = a \cdot b", False),
        (r"\frac{a \cdot b}{\|a\|} = \|b\|", False),
    ],
)
def test_norms_are_roots_and_nothing_more(formula, accepted):
    claim = check(formula, symbols=NORM).result.claim
    made = theorem("t", claim.printed.statement, (), claim.notation.definitions)
    assert made.read_back_faults() == []
    said = coqc.check(Certificate(None, (made,)).text, remember=False)
    assert said.accepted == accepted, said.fault
    assert not accepted or said.axioms == ()


def step_texts(name):
    paper = find_paper("chapter")
    (claim,) = [c for c in paper.claims if c.id == name]
    result = ClaimResult(claim, planted(Outcome.PROVED), None, None, Outcome.PROVED, True)
    return [step.certificate.text for step in steps_of(result, paper.theorems).steps if step.certificate]


def test_each_member_of_a_family_of_rotations_is_a_rotation():
    last = r"(\S+ m \(S m\)) ∘ transpose \(\1\) ≡ε \(ident : dual_tensor K\)\.\n"
    text = next(t for t in step_texts("117") if re.search(last, t))
    assert "forall i0 i1 : nat, dual_rotation" in text
    assert coqc.check(text, remember=False).accepted
    said = re.search(last, text)[0]
    changed = said.replace("m (S m)) ≡", "(S m) m) ≡")
    assert changed != said
    assert not coqc.check(text.replace(said, changed), remember=False).accepted


def test_a_batch_rejects_only_the_wrong_certificates(tmp_path, monkeypatch):
    compiled = coqc.library()
    monkeypatch.setattr(coqc, "memory", lambda: tmp_path)
    monkeypatch.setattr(coqc, "library", lambda: compiled)
    right, other = one("58.det").text, one("3.Phi_2").text
    wrong = right.replace("≡ - square", "≡ square")
    axiom = right.replace(
        "Proof.\n", "Proof.\n  admit.\nAdmitted.\nTheorem again : True.\nProof. exact I. Qed.\n(*", 1
    )
    axiom = axiom.replace("Qed.\n\n", "Qed. *)\n\n").replace("Qed.\nPrint", "Qed. *)\nPrint")
    assert coqc.in_batches([right, wrong, axiom, other]) == [[right, wrong, axiom, other]]
    coqc.check_all([right, wrong, axiom, other, other])
    assert [coqc.recall(text).expected for text in (right, wrong, axiom, other)] == [True, False, False, True]
    assert not coqc.recall(wrong).accepted
    assert coqc.recall(axiom).accepted
    assert coqc.recall(right).axioms == coqc.recall(other).axioms == ()
    assert coqc.in_batches([right, other]) == []
