"""Errata that the machine must find, and what it must never do: propose what is not proved."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace
from functools import cache
from random import Random

import pytest
from click.testing import CliRunner
from repair.damage import damages, read_or_fault, right_claims, same

from workbench import check
from workbench.app.commands.commands import main
from workbench.context.claims import Correction
from workbench.engines.jet.rings import PRIME
from workbench.papers import find_paper
from workbench.papers.load import merge
from workbench.prover.decide.decide import Judge
from workbench.prover.results.claim_results import HOLDS
from workbench.repair.propose.definition_repair import repair_definitions
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits
from workbench.repair.screening.screen import Screen

SAMPLE = 6

#: Under any load of the machine; how fast repairs are is a matter of the campaign.
PATIENT = Limits(seconds=120, judgement=60)


@pytest.fixture(scope="module")
def paper():
    return find_paper()


def named(paper, name):
    return next(claim for claim in paper.claims if claim.id == name)


@cache
def blindly(name):
    """The repair of a claim of the chapter from the printed form alone."""
    claim = named(find_paper(), name)
    return repaired(replace(claim, correction=Correction(), source=replace(claim.source, note="")))


def repaired(claim, **limits):
    return repair(claim, replace(PATIENT, **limits), judge=Judge(claim.notation.definitions))


@pytest.mark.parametrize(
    "name",
    [
        *(
            pytest.param(name, marks=pytest.mark.slow)
            for name in ("45", "58.adjugate", "61.tensor", "62.inverse")
        ),
        "53.adjugate",
        "53.det",
        "61.S",
        "61.adjugate",
        "63.t",
        "70.div",
    ],
)
def test_errata_are_found_from_the_printed_form_alone(paper, name):
    claim = named(paper, name)
    by_hand = claim.corrected or claim.reading
    found = blindly(name)
    forms = [read_or_fault(p.latex, claim).statement for p in found.proposals]
    assert any(same(claim, form, by_hand.statement) for form in forms), found


def test_the_hand_written_correction_is_not_looked_at(paper):
    lying = replace(named(paper, "70.div"), correction=Correction(corrected=named(paper, "58.t").printed))
    assert [p.latex for p in repaired(lying).proposals] == [p.latex for p in blindly("70.div").proposals]


def test_the_edit_is_said_in_words():
    (proposal, *_) = blindly("61.adjugate").proposals
    said = [change.description for change in proposal.changes]
    assert said[0].startswith("put the tilde over the whole of")
    assert [s.startswith("insert the factor 2 before") for s in said[1:]] == [True, True]


@pytest.mark.slow
def test_proposals_for_damaged_claims_are_proved(paper):
    random = Random(8)
    pool = [d for claim, formula in right_claims(paper)[::4] for d in damages(claim, formula, random, 1)]
    chosen = random.sample(pool, SAMPLE)
    good = 0
    for damaged in chosen:
        claim = damaged.claim
        judge = Judge(claim.notation.definitions)
        found = repair(claim, replace(PATIENT, proposals=2), judge=judge)
        forms = [read_or_fault(p.latex, claim).statement for p in found.proposals]
        assume = claim.supposed
        for form in forms:
            assert judge.judge(form, assume=assume, orders=claim.orders).outcome in HOLDS, damaged
        good += any(same(claim, form, damaged.original) for form in forms)
    assert good >= 0.75 * SAMPLE


def test_formulas_far_from_the_truth_get_no_proposal():
    found = check(r"a = b + c", symbols={"a": "vector", "b": "vector", "c": "vector"}).repair()
    assert found.complete
    for proposal in found.proposals:
        assert proposal.verdict.outcome in HOLDS
    assert not found.proposals


def test_an_interrupt_keeps_what_was_found(paper):
    ticks = Counter()

    def interrupted(found):
        ticks["all"] += 1
        if ticks["all"] > 20:
            raise KeyboardInterrupt

    found = repair(named(paper, "64.split"), progress=interrupted)
    assert not found.complete and ticks["all"] == 21


def test_the_search_ends_at_its_limit(paper):
    found = repaired(named(paper, "64.split"), candidates=50)
    assert not found.complete and found.candidates <= 51


def test_a_point_is_put_on_the_supposed_equations(paper):
    for name in ("49", "50", "70.rho"):
        claim = named(paper, name)
        for values in claim.instances:
            screen = Screen(claim.notation.definitions, claim.supposed, [values])
            residual = screen.residual(claim.printed.statement)
            assert residual is not None and not any(residual), name


def test_a_residue_ring_divides():
    from workbench.repair.screening.random_points import FlintResidueRing

    ring = FlintResidueRing()
    third = ring.constant(1, 3)
    assert int(ring.divide(third, ring.constant(2, 1)) * 6) == 1
    with pytest.raises(ZeroDivisionError):
        ring.divide(third, ring.constant(PRIME, 1))


def test_one_change_of_a_definition_corrects_all_its_claims(paper, tmp_path):
    """w and α of (67) as printed, repaired from two claims that are false with them; the definitions by hand
    are those of the paper file."""
    folder, name = paper.paths[0].parent, "04_1_centres_and_adjugates.toml"
    text = (folder / name).read_text("utf-8")
    for right, printed in (
        (
            r"2 \ddot{\omega} - \omega \times \dot{\omega} - \frac{1}{2}",
            r"\ddot{\omega} - \omega \times \dot{\omega} -",
        ),
        (r"3 \dot{\omega}^2 - 4 \omega", r"2 \dot{\omega}^2 - 2 \omega"),
    ):
        assert text.count(right) == 1
        text = text.replace(right, printed)
    (tmp_path / name).write_text(text, "utf-8")
    (tmp_path / "notation.toml").write_bytes((folder / "notation.toml").read_bytes())
    as_printed = merge([tmp_path / name], paper.theorems)
    false = [named(as_printed, each) for each in ("64.split", "66.det_S")]
    det = named(paper, "66.det_S")
    (found,) = repair_definitions(false)
    assert found.mended == ("64.split", "66.det_S")
    by_hand = {name: read_or_fault(f"{name} = {new}", det) for name, _, new in found.changed}
    judge = Judge(det.notation.definitions)
    assert len(by_hand) == 2
    for formula in by_hand.values():
        assert judge.judge(formula.statement).outcome in HOLDS


def test_command_line(paper):
    done = CliRunner().invoke(main, ["repair", "70.div", "--json"])
    assert done.exit_code == 0, done.output
    assert [p["verdict"] for p in json.loads(done.stdout)["proposed"]] == ["proved"]
    assert CliRunner().invoke(main, ["repair", "no-such-claim"]).exit_code == 2
    assert CliRunner().invoke(main, ["repair", "70.div", "--seconds", "-1"]).exit_code == 2


def test_claims_with_norms_are_repaired_without_screening():
    printed = r"\|a \times b\|^2 = a^2 b^2 - a \cdot b"
    found = check(printed, symbols={"a": "vector", "b": "vector"}).repair()
    assert [p.edit for p in found.proposals] == [r"$a \cdot b$ gets the exponent 2"]
