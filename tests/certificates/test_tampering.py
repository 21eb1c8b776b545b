"""Tampering: false statements, with the proof of the true one and with a proof of their own, are refused."""

import re
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.certificates.emitted import all_certificates, one
from workbench.certificates import coqc
from workbench.certificates.certified_forms import Certificate
from workbench.certificates.emission.emitted_families import general
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.goals.goal_theorem import OF_MOMENTS, joined
from workbench.certificates.theorem import HEADER, theorem
from workbench.certificates.values.trial import holds_whatever_they_are
from workbench.core.integer_instances import instantiate
from workbench.core.terms import IllFormed, Relation
from workbench.language.goals.goals import Atom, Implies, Scope
from workbench.language.goals.proofs import Kernel
from workbench.papers import find_paper
from workbench.prover.goals.proof_rules import obligations
from workbench.prover.goals.sequents import Sequent
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.term_edits import edits

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(coqc.version() is None, reason=f"no coqc: {coqc.INSTALL}"),
]

#: Of one certificate at most so many mutants, of all together so many, in one run of Coq so many certificates.
EACH, WANTED, TOGETHER = 10, 520, 4


def originals():
    """(form, its statement at small orders, its theorem), where one equation is proved by computation alone."""
    for form, made in all_certificates():
        if isinstance(made, str) or not isinstance(form.formula.statement, Relation) or form.claim.assume:
            continue
        values = form.claim.instances[min(1, len(form.claim.instances) - 1)]
        definitions = form.claim.notation.definitions
        try:
            statement = instantiate(form.formula.statement, values)
            base = theorem("base", statement, (), definitions)
        except (NotCertified, IllFormed):
            continue
        if not base.emitter.steps and len(base.goals[0]) == 1 and base.proof.count("DD") < 40:
            yield form, statement, base


def mutants(form, statement, base):
    """(kind of edit, theorem) of distinct statements that are false at random points modulo a prime."""
    definitions = form.claim.notation.definitions
    try:
        screen = Screen(definitions, (), [{}])
        screen.keep(statement)
    except Exception:  # what the screen does not take is no part of the campaign
        return
    seen = {base.statement}
    for edit in edits(statement):
        if len(seen) > EACH:
            return
        if edit.statement is None:
            continue
        try:
            residual = screen.residual(edit.statement)
            changed = theorem("base", edit.statement, (), definitions)
        except (NotCertified, IllFormed, ArithmeticError, ValueError):
            continue
        if residual is None or not any(residual) or changed.emitter.steps or changed.statement in seen:
            continue
        seen.add(changed.statement)
        yield edit.kind, changed


def attempt(made, deep, fails=True):
    """The theorem's statement, with a proof by the given deep copies."""
    left, right = deep
    setup, _, rest = made.proof.partition("  certify")
    setup = setup.removeprefix("Proof.").replace("intros ", "idtac; try intros ")
    rule, more = ("by_either _ free", "eq_refl ") if rest.startswith("_by") else ("by_computing _", "")
    goal = re.sub(r"^Theorem \w+", "Goal forall", made.statement).replace(" :\n", ",\n", 1)
    proof = f"(refine (@{rule} known0 _ _ {left} {right} {more}_); vm_compute; reflexivity)"
    end = f"Fail {proof}.\nAbort." if fails else f"{proof}.\nQed."
    return f"{goal}\nProof. intros.{setup}  {end}\n"


def test_the_campaign_would_see_a_theorem_that_is_accepted():
    (base,) = one("58.det").theorems
    said = coqc.check(f"{HEADER}\n{attempt(base, base.goals[0][0])}", remember=False)
    assert not said.accepted
    assert "has not failed" in said.fault


def test_coq_rejects_false_statements_with_either_deep_copy():
    kinds, texts, forms, attempts = Counter(), [], Counter(), 0
    for form, statement, base in originals():
        if kinds.total() >= WANTED:
            break
        # the same proof is accepted where the statement is true
        text = [attempt(base, base.goals[0][0], fails=False)]
        for kind, changed in mutants(form, statement, base):
            text.append(attempt(changed, changed.goals[0][0]))
            if len(base.emitter.slots) == len(changed.emitter.slots):
                text.append(attempt(changed, base.goals[0][0]))
            kinds[kind] += 1
            forms[form.identifier] += 1
        if len(text) > 1:
            texts.append("\n".join(text))
            attempts += len(text) - 1
    together = ["\n".join([HEADER, *texts[i : i + TOGETHER]]) for i in range(0, len(texts), TOGETHER)]
    with ThreadPoolExecutor(2) as pool:
        said = list(pool.map(coqc.check, together))
    assert [s.fault for s in said if not s.accepted] == []
    print(f"\n{kinds.total()} false statements of {len(forms)} certificates, {attempts} proofs, all refused")
    print("\n".join(f"{number:5} {kind}" for kind, number in kinds.most_common()))
    assert kinds.total() >= 500
    assert attempts >= kinds.total() * 1.5


def steps_about_every_n():
    """(claim, what a step says, in what scope) of those with sums or derivatives of order n."""
    paper = find_paper("chapter")
    for claim in paper.claims:
        if claim.id in ("Theorem_1", "21.every_n", "Remark_5", "119", "131.all"):
            notation = claim.notation
            scope = Scope(notation.symbols, notation.definitions, {})
            proof = paper.theorems[claim.proof.theorem].proof
            for asked in obligations(Sequent(claim.proof.goal.goal, scope), proof):
                if asked.scope.integers and isinstance(asked.statement, Relation) and not asked.assume:
                    yield claim.id, asked.statement, asked.scope.definitions


def about_every_n(statement, definitions):
    said, _, integers = general(statement, ())
    return theorem("base", said, (), definitions, integers, several=True)


def test_every_false_statement_about_every_n_is_refused():
    texts, kinds = [], Counter()
    for _, statement, definitions in steps_about_every_n():
        try:
            base = about_every_n(statement, definitions)
        except (NotCertified, IllFormed):
            continue
        if not base.emitter.lemmas or base.emitter.steps or not holds_whatever_they_are(base):
            continue
        text, seen = [attempt(base, base.goals[0][0], fails=False)], {base.statement}
        for edit in edits(statement):
            if len(text) > EACH or edit.statement is None:
                break
            try:
                changed = about_every_n(edit.statement, definitions)
            except (NotCertified, IllFormed, ArithmeticError, ValueError):
                continue
            if changed.emitter.steps or changed.statement in seen or holds_whatever_they_are(changed):
                continue
            seen.add(changed.statement)
            kinds[edit.kind] += 1
            text.append(attempt(changed, changed.goals[0][0]))
            if len(base.emitter.slots) == len(changed.emitter.slots):
                text.append(attempt(changed, base.goals[0][0]))
        texts.append("\n".join(text))
    header = HEADER.replace("Open Scope", "From Kin Require Import Orders.\nOpen Scope", 1)
    with ThreadPoolExecutor(2) as pool:
        said = list(pool.map(coqc.check, ["\n".join([header, text]) for text in texts]))
    assert [s.fault for s in said if not s.accepted] == []
    print(f"\n{kinds.total()} false statements about every n, all refused")
    assert kinds.total() >= 30


#: (claim, form) with inverses of blocks and of tensors; and with what is supposed at one instant.
OTHERS = (
    ("24.inverse", "printed"),
    ("33.twist", "printed"),
    ("51.value", "printed"),
    ("62.inverse", "corrected"),
    ("110.A", "printed"),
    ("111", "printed"),
)


def test_coq_rejects_false_inverses_and_false_instants():
    texts = []
    for claim_id, name in OTHERS:
        (claim,) = (c for c in find_paper("chapter").claims if c.id == claim_id)
        values, definitions = claim.instances[min(2, len(claim.instances) - 1)], claim.notation.definitions
        statement = instantiate(getattr(claim, name).statement, values)
        supposed = [instantiate(s, values) for s in claim.supposed]
        screen = Screen(definitions, supposed, [{}])
        screen.keep(statement)
        false = (e.statement for e in edits(statement) if e.statement is not None)
        mutated = [s for s in false if (r := screen.residual(s)) is not None and any(r)][:4]
        for number, changed in enumerate([statement, *mutated]):
            if claim_id.startswith("11"):
                goal = Implies(Atom(supposed[0]), Atom(changed))
                made = joined("base", goal, Scope(claim.notation.symbols, definitions, {}), Kernel())
                text = Certificate(None, (made,), header=OF_MOMENTS).text
            else:
                text = Certificate(None, (theorem("base", changed, supposed, definitions),)).text
            texts.append((claim_id, number, text))
    with ThreadPoolExecutor(2) as pool:
        said = list(pool.map(lambda one: coqc.check(one[2], remember=False), texts))
    for (claim_id, number, _), heard in zip(texts, said, strict=True):
        assert heard.accepted == (number == 0), (claim_id, number, heard.fault)
        assert number == 0 or heard.fault.startswith("Error: In environment"), heard.fault  # of its proof
    print(f"\n{len(texts) - len(OTHERS)} false statements with inverses or at one instant, all refused")
    assert len(texts) - len(OTHERS) >= 20
