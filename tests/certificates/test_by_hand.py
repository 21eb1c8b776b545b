"""Theorems written by hand belong to claims of the paper."""

from dataclasses import replace

import pytest

from tests.planted import planted
from workbench.app.pipeline.judge_claims import ClaimResult
from workbench.certificates import coqc
from workbench.certificates.certify import with_certificates
from workbench.certificates.handwritten import by_hand
from workbench.core.verdict import Outcome
from workbench.papers import find_paper


def results(name):
    (claim,) = [c for c in find_paper().claims if c.id == name]
    return [ClaimResult(claim, planted(Outcome.PROVED), None, None, Outcome.PROVED, True)]


def test_each_theorem_of_the_chapter_s_file_is_on_a_claim():
    (file,) = by_hand(find_paper())
    theorems = file.path.read_text("utf-8").count("\nTheorem ")
    assert len({said for _, _, said in file.about}) == theorems
    assert all(said.startswith("Theorem ") and said.endswith(".") for _, _, said in file.about)


@pytest.mark.parametrize(
    ("said", "shown"),
    [
        (coqc.Checked(True, (), "", 1.0), True),
        (coqc.Checked(True, ("wrong",), "", 1.0), False),
        (coqc.Checked(False, (), "Error", 1.0), False),
        (None, False),
    ],
)
def test_a_handwritten_theorem_is_shown_only_if_coq_accepts_all(monkeypatch, said, shown):
    monkeypatch.setattr(coqc, "recall", lambda text: said)
    (told,) = with_certificates(results("21.every_n"), find_paper())
    hand = [c for c in told.certificates if c.form == "theorem"]
    assert bool(hand) == shown
    if shown:
        assert hand[0].statement.startswith("Theorem c_21_all")
        assert "not read back" in hand[0].word
    (other,) = with_certificates(results("58.det"), find_paper())
    assert not [c for c in other.certificates if c.form == "theorem"]


def test_a_theorem_on_no_claim_is_an_error(tmp_path):
    folder = tmp_path / "certificates"
    folder.mkdir()
    (folder / "mine.v").write_text(
        "(* on 14, 14.x: words *)\nTheorem t : True.\nProof. exact I. Qed.\n", "utf-8"
    )
    with pytest.raises(coqc.CoqFault, match=r"mine.v: a theorem on 14\.x"):
        by_hand(replace(find_paper(), paths=(tmp_path / "paper.toml",)))
