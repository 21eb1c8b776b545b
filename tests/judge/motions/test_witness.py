"""Drake as the witness of claims: what holds is seen to hold, an error parts the sides, a wrong binding is refused."""

from pathlib import Path

import pytest
from judge.motions.motion_papers import MOTION, judged, motions, paper

from tests.planted import PLANTED, planted
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.app.pipeline.motion_witnesses import Witnesses
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Outcome
from workbench.papers import find_paper
from workbench.report.to_json import report_json


def test_true_claims_hold_on_every_motion(tmp_path):
    (claim,) = judged(tmp_path, r"printed = '\dot{R} = \tilde{\omega} R'")
    (seen,) = motions(claim)
    assert claim["verdict"] == "proved" and len(seen["motions"]) == 5 and "6R arm, seed 9" in seen["motions"]
    assert claim["motion"]["witness"] == "Drake" and claim["motion"]["line"].startswith(
        "holds at 22 instants"
    )


def test_refuted_form_and_correction_use_equal_times(tmp_path):
    (claim,) = judged(
        tmp_path,
        r"""
        printed = '\ddot{R} R^T = \dot{\tilde{\omega}} - \tilde{\omega}^2'
        corrected = '\ddot{R} R^T = \dot{\tilde{\omega}} + \tilde{\omega}^2'
    """,
    )
    assert claim["verdict"] == "refuted" and claim["passed"]
    (false,), (right,) = motions(claim), motions(claim["corrected"])
    assert false["outcome"] == "the sides part" and right["outcome"] == "residual within the error"
    cost = claim["motion"]["error"]
    assert (
        cost["false"] > 0.1 and cost["right"] <= 1e-13 and cost["motion"] == "two cylindrical joints, seed 1"
    )
    assert cost["time"] in false["course"]["times"] and f"t = {cost['time']:g} s" in claim["motion"]["line"]


def test_claims_without_a_motion_are_counted_separately(tmp_path):
    loaded = paper(
        tmp_path,
        r"printed = 'a \times x = -x \times a'",
        r"printed = '\dot{R} = \tilde{\omega} R'",
        r"printed = '\omega^{(6)} = \frac{d}{dt} \omega^{(5)} + 0 a'",
    )
    report = report_json(loaded, judge_paper(loaded))
    lines = [claim["motion"] for claim in report["claims"]]
    assert [line["witness"] for line in lines] == ["no motion: algebra", "Drake", "none"]
    assert lines[2]["because"] == "derivatives of too high an order"
    assert report["witnesses"] == {"Drake": 1, "no motion: algebra": 1, "none": 1}


@pytest.mark.parametrize(
    "binding, wrong, message",
    [
        (r"'\omega' = ", "w_WB_B", r"w_WB_B is off by"),  # a swapped frame
        ("'v' = ", "v_WB0", r"v is defined as .*, and v_WB0 is off by"),
        ("'v' = ", "v_WP", "v_WP is off by"),
    ],
)
def test_a_binding_that_contradicts_a_definition_is_refused(tmp_path, binding, wrong, message):
    right = {r"'\omega' = ": "w_WB", "'v' = ": "v_WBo"}[binding]
    motion = MOTION.replace(f'{binding}"{right}"', f'{binding}"{wrong}"')
    assert motion != MOTION
    with pytest.raises(PaperError, match=message):
        judged(tmp_path, r"printed = '\dot{R} = \tilde{\omega} R'", motion=motion)


@pytest.mark.parametrize(
    "line, message",
    [
        ("'a' = \"w_BW\"", "unknown quantity 'w_BW'; expected w_AB_W or w_WB"),
        ("'a' = \"R_WB\"", "a is a vector, but R_WB has the shape"),
        ("'p' = \"v_WBo\"", "p has weight 0, but v_WBo has weight 1"),
        ("'a' = \"p_WP^(n)\"", "has an index that a has not"),
        ("'a' = \"p_WP^(n+)\"", "expected a number, or an index"),
        ('robot = { urdf = "none.urdf", body = "B" }', "no URDF file at"),
        ('robot = { urdf = "paper.toml" }', "expected both urdf and body"),
    ],
)
def test_bad_bindings_are_refused_where_they_stand(tmp_path, line, message):
    with pytest.raises(PaperError, match=message):
        paper(tmp_path, "printed = 'a = a'", motion=f"[motion]\n{line}")


def test_numbers_veto_a_proof(tmp_path):
    """A form that is false on the motions does not stay proved, whatever an engine said."""
    loaded = paper(tmp_path, r"printed = '\dot{R} = -\tilde{\omega} R'")
    (claim,) = loaded.claims
    proved = planted(Outcome.PROVED, evidence=(PLANTED,))
    seen = Witnesses().seen(proved, claim, claim.printed, None)
    assert seen.outcome == Outcome.UNCHECKED and seen.code is VerdictCode.MOTIONS_CONTRADICT


def test_premises_are_satisfied_or_nothing_is_said(tmp_path):
    solved, impossible = judged(
        tmp_path,
        r"""
        printed = 'x = R^T a'
        assume = ['R x = a']
        """,
        r"""
        printed = '\omega \times a = \mathbf{0}'
        assume = ['\omega = \mathbf{0}']
        """,
    )
    assert solved["verdict"] == "proved" and motions(solved)[0]["samples"] == 22
    assert motions(impossible) == [] and impossible["motion"]["because"].startswith("nowhere on the motions")


def test_a_body_of_a_urdf_is_one_of_the_motions(tmp_path):
    urdf = Path(__file__).parents[2] / "drake" / "two_arms.urdf"
    (tmp_path / "arms.urdf").write_text(urdf.read_text("utf-8"), "utf-8")
    motion = MOTION + '    robot = { urdf = "arms.urdf", body = "hand" }\n'
    (claim,) = judged(tmp_path, r"printed = '\dot{R} = \tilde{\omega} R'", motion=motion)
    assert "hand of arms.urdf" in motions(claim)[0]["motions"]
    missing = motion.replace('"hand"', '"foot"')
    with pytest.raises(PaperError, match="no body 'foot'"):
        judged(tmp_path, r"printed = '\dot{R} = \tilde{\omega} R'", motion=missing)


def test_the_chapters_errors_and_their_corrections():
    """(61), (66), (70) and (10): both forms on the same motion."""
    for result in judge_paper(find_paper(None), ["10", "61.adjugate", "66", "70.div"]):
        if result.corrected is None:
            continue
        cost = result.on_motions.error
        assert result.passed and cost.false > 0.05 and cost.right <= 1e-12, result.claim.id
