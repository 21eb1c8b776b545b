"""Each claim of the chapter that is not right as printed says what its fault is, and how the print is mended."""

import re
from pathlib import Path

import pytest

from workbench.context.claim_parts import FAULTS
from workbench.core.verdict import Outcome
from workbench.papers import find_paper
from workbench.papers.corrections import mended, same_formula
from workbench.source.typeset.latex_atoms import atoms_of

CHAPTER = Path(__file__).parents[3] / "shared" / "chapter.md"


@pytest.fixture(scope="module")
def claims():
    return find_paper(None).claims


def test_every_wrong_claim_has_a_fault(claims):
    wrong = [c for c in claims if c.expected not in (Outcome.PROVED, Outcome.ARGUED)]
    wrong += [c for c in claims if c.reading or c.corrected or c.correction.hypothesis]
    assert len(wrong) > 90
    assert [c.id for c in wrong if c.mend.fault is None] == []
    assert {c.mend.fault for c in claims} == {None, *FAULTS}


def test_a_fault_says_how_it_is_mended(claims):
    """By an edit, by that of another claim, by a right form beside the printed one, or by a hypothesis."""
    ids = {c.id for c in claims}
    for claim in claims:
        if claim.mend.fault is None:
            continue
        right = claim.reading or claim.corrected or claim.correction.hypothesis
        assert claim.mend.edits or claim.mend.by in ids or right, claim.id
        assert claim.source.note or claim.mend.edits, claim.id


def test_edits_can_be_set(claims):
    for claim in claims:
        for edit in claim.mend.edits:
            if edit.is_math:
                atoms_of(edit.old.replace("&", ""))
                atoms_of(edit.new.replace("&", ""))


#: Claims whose edits do not make the proved form letter by letter, and why.
IN_OTHER_LETTERS = {
    "68": "the print is a ≠; the difference of its sides is proved to be det Φ₄",
    "79": "the ρ of the decomposition, ρ_s in the proof, is not any vector",
    "97": "PQ is a word for ρ_Q − ρ_P, which is proved in its place",
    **dict.fromkeys(("101.A", "101.J", "101.H"), "as 97"),
    "103.twist": "ω̲ on both sides would say nothing; it is written out by (90)",
    "121": "a product of k − 1 rotations is one letter in the proof",
    "124.power": "the print is of all powers; the first is refuted and proved, 124.powers goes on",
    "131": "the dots of the print are a sum in the proof",
    "132": "the edit is of the coefficient below it; the proof is for p = 3, and 132.all for all p",
    **dict.fromkeys(
        ("135.Phi2", "135.Phi3", "135.Phi4"), "Φ̲ with the bracketed derivative is bold in the proof"
    ),
}


def test_edits_make_the_proved_form(claims):
    """Where the print is one formula and its right form is one. The others are edits of sentences, or stand
    for a right form in other letters."""
    other = {
        claim.id
        for claim in claims
        if claim.mend.edits and claim.printed.latex and (right := claim.corrected or claim.reading)
        if not same_formula(mended(claim.printed.latex, claim.mend.edits), right.latex)
    }
    assert other == set(IN_OTHER_LETTERS)


def test_one_slip_is_one_fault(claims):
    """Underlines that Section 8 and (135) have lost; orders that are counted in two ways."""
    faults = {c.id: c.mend.fault for c in claims}
    dual = {c.id for c in claims if re.fullmatch(r"1(35\.Phi\d|35\.P|36|3[789]|4[0-7])", c.id)}
    assert len(dual) == 16 and {faults[name] for name in dual} == {"transcription"}
    counts = {"37.base", "107", "108.by13", "110.by13", "111", "112.by13", "113.by13"}
    assert {faults[name] for name in counts} == {"error"}
    assert len({c.mend.cause for c in claims if c.id in counts}) == 1


@pytest.mark.skipif(not CHAPTER.is_file(), reason="the chapter's text is not beside the checkout")
def test_edits_change_printed_text(claims):
    text = re.sub(r"\s|&|\\,", "", CHAPTER.read_text("utf-8"))
    for claim in claims:
        if claim.mend.beside:
            beside = re.sub(r"\s|&|\\,", "", claim.mend.beside.strip("“”").replace("$$", ""))
            assert beside.rstrip(".,:") in text, claim.id
