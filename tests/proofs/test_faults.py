"""Each claim of the chapter that is not right as printed says what its fault is, and how the print is mended."""

import re
from pathlib import Path

import pytest

from workbench.judge.verdict import Outcome
from workbench.papers import find_paper
from workbench.papers.mends import mended, same_formula
from workbench.papers.model import FAULTS
from workbench.typeset.latex_atoms import atoms_of

CHAPTER = Path(__file__).parents[3] / "shared" / "chapter.md"


@pytest.fixture(scope="module")
def claims():
    return find_paper(None).claims


def test_what_is_not_right_has_a_fault(claims):
    wrong = [c for c in claims if c.expected not in (Outcome.PROVED, Outcome.ARGUED)]
    wrong += [c for c in claims if c.reading or c.corrected or c.hypothesis]
    assert len(wrong) > 90
    assert [c.id for c in wrong if c.fault is None] == []
    assert {c.fault for c in claims} == {None, *FAULTS}


def test_a_fault_says_how_it_is_mended(claims):
    """By an edit, by that of another claim, by a right form beside the printed one, or by a hypothesis."""
    ids = {c.id for c in claims}
    for claim in claims:
        if claim.fault is None:
            continue
        right = claim.reading or claim.corrected or claim.hypothesis
        assert claim.mend.edits or claim.mend.by in ids or right, claim.id
        assert claim.note or claim.mend.edits, claim.id


def test_edits_can_be_set(claims):
    for claim in claims:
        for edit in claim.mend.edits:
            if edit.is_math:
                atoms_of(edit.old.replace("&", ""))
                atoms_of(edit.new.replace("&", ""))


def test_edits_make_the_proved_form(claims):
    """Where the print is one formula and its right form is one. The others are edits of sentences, or stand
    for a right form in other letters: that is said here, one by one."""
    in_other_letters = {
        *("34.size", "61.det", "61.nonsingular", "62.inverse", "68", "79", "97", "101.A", "101.J", "101.H"),
        *(
            "102.A",
            "102.J",
            "102.H",
            "103.twist",
            "108",
            "121",
            "124.power",
            "131",
            "132",
        ),
        *("135.Phi2", "135.Phi3", "135.Phi4"),
    }
    other = {
        claim.id
        for claim in claims
        if claim.mend.edits and claim.printed.latex and (right := claim.corrected or claim.reading)
        if not same_formula(mended(claim.printed.latex, claim.mend.edits), right.latex)
    }
    assert other == in_other_letters


@pytest.mark.skipif(not CHAPTER.is_file(), reason="the chapter's text is not beside the checkout")
def test_what_is_changed_is_printed(claims):
    text = re.sub(r"\s|&|\\,", "", CHAPTER.read_text("utf-8"))
    for claim in claims:
        if claim.mend.beside:
            beside = re.sub(r"\s|&|\\,", "", claim.mend.beside.strip("“”").replace("$$", ""))
            assert beside.rstrip(".,:") in text, claim.id
