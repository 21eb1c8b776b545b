"""The errata of the chapter: what the machine finds from the printed forms alone, beside what was found by hand."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from click.testing import CliRunner
from rich.console import Console

from workbench.app.commands.commands import main
from workbench.context.claims import Correction
from workbench.papers import find_paper
from workbench.repair.propose.known_errata import compared, errata_table, known_errata, summary
from workbench.repair.propose.parallel_repairs import repair_claims
from workbench.repair.propose.proposal import Repair
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits

#: Of the errata of the chapter, at least so many are corrected as by hand.
CORRECTED = 62


@pytest.fixture(scope="module")
def paper():
    return find_paper()


def named(paper, name):
    return next(claim for claim in paper.claims if claim.id == name)


def test_a_proposal_is_compared_with_the_correction_made_by_hand(paper):
    claim = named(paper, "70.div")
    found = repair(claim)
    assert compared(found).result == "same"
    other = replace(claim, correction=Correction(corrected=named(paper, "70.curl").reading))
    assert compared(replace(found, claim=other)).result == "different"
    row = compared(Repair(claim, candidates=7))
    assert row.result == "none" and "7 candidates" in row.why and "limit" in row.why
    assert (
        summary([row]) == "0 of 1 errata corrected by the machine as by hand; 0 otherwise, but proved; 1 not"
    )


def test_proved_claims_and_theorems_are_no_known_errata(paper):
    ids = {claim.id for claim in known_errata(paper.claims)}
    assert "70.div" in ids and not ids & {"58.det", "Theorem_1"}


def test_command_line():
    done = CliRunner().invoke(main, ["errata", "70.div", "58.det", "--json"])
    assert done.exit_code == 0, done.output
    (row,) = json.loads(done.stdout)
    assert (row["id"], row["result"]) == ("70.div", "same")
    done = CliRunner().invoke(main, ["errata", "102.A"])
    assert done.exit_code == 1 and "0 of 1 errata" in done.stdout
    assert CliRunner().invoke(main, ["errata", "--seconds", "nan"]).exit_code == 2


@pytest.mark.slow
def test_the_errata_of_the_chapter(paper, capsys):
    limits = Limits(seconds=60.0, judgement=30.0)
    rows = [compared(found) for found in repair_claims(known_errata(paper.claims), limits)]
    with capsys.disabled():
        Console(width=110).print(errata_table(rows), "\n", summary(rows), sep="")
    assert sum(row.is_same for row in rows) >= CORRECTED
