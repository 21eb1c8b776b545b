"""What Coq says of the certificates; skipped where there is no coqc."""

import re

import pytest
from click.testing import CliRunner

from tests.certificates.emitted import all_certificates, one
from workbench.certificates import coqc
from workbench.certificates.theorem import HEADER
from workbench.cli.commands import main
from workbench.papers import find_paper
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.edits import edits

pytestmark = [
    pytest.mark.slow,  # compiling the library takes half a minute
    pytest.mark.skipif(coqc.version() is None, reason=f"no coqc: {coqc.INSTALL}"),
]


@pytest.mark.parametrize("name", ["58.det", "3.Phi_2", "25", "60.div", "139.fixed", "53.split", "83.1"])
def test_a_certificate_is_accepted_without_axioms(name):
    said = coqc.check(one(name).text, remember=False)
    assert said.accepted, said.fault
    assert said.axioms == ()


def test_an_axiom_is_seen():
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
    monkeypatch.setattr(coqc, "check", lambda text: coqc.Checked(False, (), "refused", 0.0))
    broken = CliRunner().invoke(main, ["certify", "58.det", "--check"])
    assert broken.exit_code == 3


def mutants(wanted):
    """(certificate's theorem, mutant's theorem): false statements, by the engines modulo a prime."""
    from workbench.certificates.nodes import NotCertified
    from workbench.certificates.theorem import theorem
    from workbench.language.instances import instantiate
    from workbench.language.terms import IllFormed, Relation

    found = []
    for form, made in all_certificates():
        if isinstance(made, str) or not isinstance(form.formula.statement, Relation) or form.claim.assume:
            continue
        values = form.claim.instances[min(1, len(form.claim.instances) - 1)]
        definitions = form.claim.notation.definitions
        try:
            original = instantiate(form.formula.statement, values)
            screen = Screen(definitions, (), [{}])
            screen.keep(original)
            base = theorem("base", original, (), definitions)
        except Exception:  # what the screen does not take is no part of the campaign
            continue
        if base.emitter.steps or len(base.goals[0]) != 1:
            continue
        taken = 0
        for edit in edits(original):
            if taken == 8:
                break
            if edit.statement is None:
                continue
            try:
                residual = screen.residual(edit.statement)
                changed = theorem("mutant", edit.statement, (), definitions)
            except (NotCertified, IllFormed, ArithmeticError, ValueError):
                continue
            if residual is None or not any(residual) or changed.emitter.steps:
                continue
            found.append((form.identifier, base, changed))
            taken += 1
        if len(found) >= wanted:
            break
    return found


def attempt(theorem, deep):
    """The theorem's statement, with a proof by the given deep copies that must fail."""
    lines = theorem.proof.split("  certify ")[0]
    left, right = deep
    setup = lines.removeprefix("Proof.")
    return (
        re.sub(r"^Theorem \w+", "Goal forall", theorem.statement).replace(" :\n", ",\n", 1)
        + f"\nProof. intros.{setup.replace('intros ', 'idtac; try intros ')}"
        + f"  Fail (refine (@by_computing _ known0 _ _ {left} {right} _); vm_compute; reflexivity).\nAbort.\n"
    )


def test_the_campaign_would_see_a_theorem_that_is_accepted():
    (base,) = one("58.det").theorems
    said = coqc.check(f"{HEADER}\n{attempt(base, base.goals[0][0])}", remember=False)
    assert not said.accepted
    assert "has not failed" in said.fault


def test_false_statements_are_refused_with_the_old_copy_and_with_their_own():
    campaign = mutants(300)
    assert len(campaign) >= 250
    count = 0
    for at in range(0, len(campaign), 25):
        texts = [HEADER]
        for _, base, changed in campaign[at : at + 25]:
            texts.append(attempt(changed, changed.goals[0][0]))  # statement and copy together
            count += 1
            if base.emitter.binders == changed.emitter.binders and len(base.emitter.slots) == len(
                changed.emitter.slots
            ):
                texts.append(attempt(changed, base.goals[0][0]))  # the statement alone
                count += 1
        said = coqc.check("\n".join(texts), remember=False)
        assert said.accepted, said.fault
    assert count >= 500


@pytest.mark.parametrize("name", ["76", "70.div", "113.P1", "132.total"])
def test_a_refutation_is_accepted_on_the_axioms_of_the_reals(name):
    from workbench.certificates.certify import exact_forms, written
    from workbench.verify.claims import judge_paper

    results = [r for r in judge_paper(find_paper("chapter"), [name]) if r.claim.id == name]
    (made,) = [written(f, v).certificate for f, _, v in exact_forms(results) if v.outcome == "refuted"]
    assert made.theorems[0].statement.startswith(f"Theorem {made.theorems[0].name} : ~ forall")
    said = coqc.check(made.text, remember=False)
    assert said.accepted, said.fault
    assert said.axioms
    assert said.expected
