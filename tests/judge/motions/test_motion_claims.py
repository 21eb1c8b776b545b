"""What of a goal, of a sentence and of a definition is looked at on Drake's motions, and what vetoes it."""

import re
from dataclasses import dataclass

import numpy as np
import pytest
from click.testing import CliRunner
from judge.motions.motion_papers import HEAD, MOTION, judged, motions, paper

from tests.planted import PLANTED, planted
from workbench.app.commands.commands import main
from workbench.app.pipeline import motion_witnesses
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.app.pipeline.motion_witnesses import Witnesses
from workbench.core.codes.motion_codes import MotionCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.paper_errors import PaperError
from workbench.core.reasons import code_of
from workbench.core.verdict import Outcome, Verdict
from workbench.drake.sampled_motions import six_revolute_motion
from workbench.drake.special_motions import special_motion
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import Scope
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.prover.goals.goal_equations import equations_of_goal
from workbench.prover.motions.motion_check import Subject, witness
from workbench.prover.motions.motion_source import bindings_of

# --- goals


@pytest.mark.parametrize(
    "goal, expected",
    [
        ("a = b", [("a = b", [], [])]),
        (r"\forall n \geq 2 : a^{(n)} = b ; a = b", [("a^{(n)} = b", [], [("n", 2)]), ("a = b", [], [])]),
        (r"\forall c \in V_3 : a = c \Rightarrow c = b \wedge c = a", [
            ("c = b", ["a = c"], []), ("c = a", ["a = c"], [])
        ]),
        (r"\forall c \in V_3 : a \neq b \wedge a = c \Rightarrow c = b", [
            ("c = b", [r"a \neq b", "a = c"], [])
        ]),
        (r"\exists c \in V_3 : a = c ; a = b", [("a = b", [], [])]),
        (r"a = b \Longrightarrow \dot{a} = \dot{b}", []),
        (r"\Big( \forall c \in V_3 : c = a \Big) \Rightarrow a = b", []),
        (r"a \cdot a \geqslant b \cdot b", []),
        (r"a = b \Leftrightarrow b = a", [(r"a = b \Leftrightarrow b = a", [], [])]),
    ],
)  # fmt: skip
def test_equations_behind_no_existence_are_said(goal, expected):
    table = SymbolTable.build({"a": {"kind": "vector"}, "b": {"kind": "vector"}})
    found = [
        (to_latex(part.statement), [to_latex(p) for p in part.premises], list(part.integers))
        for part in equations_of_goal(read_goal(goal, Scope(table, (), {})))
    ]
    assert found == expected


def goal_claim(goal: str) -> str:
    return f"statement = 'it'\ngoal = '{goal}'"


def test_a_goal_is_evaluated_for_points_and_integers(tmp_path):
    point, family = judged(
        tmp_path,
        goal_claim(r"\forall r \in V_3 : \frac{d}{dt} (p + R r) = v + \omega \times (R r)"),
        goal_claim(r"\forall n \geq 1 : \frac{d^n}{dt^n} v = \frac{d^{n-1}}{dt^{n-1}} \dot{v}"),
    )
    assert point["verdict"] == "proved" and motions(point)[0]["samples"] == 22
    assert motions(family)[0]["instances"] == ["n = 1", "n = 2", "n = 3"]


def seen(folder, outcome: Outcome, goal: str) -> Verdict:
    """What becomes of a verdict, whatever an engine said."""
    (claim,) = paper(folder, goal_claim(goal)).claims
    verdict = planted(outcome, evidence=(PLANTED,))
    return Witnesses().seen(verdict, claim, claim.printed, None)


def test_numbers_veto_a_goal_if_one_of_its_equations_is_false(tmp_path):
    goal = r"\forall r \in V_3 : \dot{R} r = \omega \times (R r) ; \forall r \in V_3 : \dot{R} r = R r"
    assert seen(tmp_path, Outcome.PROVED, goal).code is VerdictCode.MOTIONS_CONTRADICT
    assert seen(tmp_path, Outcome.ARGUED, goal).code is VerdictCode.MOTIONS_CONTRADICT
    refuted = seen(tmp_path, Outcome.REFUTED, goal)
    assert refuted.outcome == Outcome.REFUTED and refuted.evidence[-1].outcome == "the sides part"


@pytest.mark.parametrize(
    "goal, reason",
    [
        (r"\exists! w \in V_3 : w = v", MotionCode.EXISTENCE),
        (r"\exists! w \in V_3 : w = x", MotionCode.ALGEBRA),
        (
            r"\forall b, c \in V_3 : b \times c = -c \times b ; \exists w \in V_3 : w = \ddot{p}",
            MotionCode.EXISTENCE,
        ),
        (r"\forall b, c \in V_3 : b \times c = -c \times b", MotionCode.ALGEBRA),
    ],
)
def test_a_goal_that_is_not_evaluated_says_why(tmp_path, goal, reason):
    verdict = seen(tmp_path, Outcome.PROVED, goal)
    assert verdict.outcome == Outcome.PROVED and code_of(verdict.no_motion) is reason


# --- [motion.claims]

DEFINED = HEAD + "    'u' = 'R x'\n"


def with_ours(*lines: str) -> str:
    return "\n".join([MOTION, "[motion.claims.0]", *lines])


def test_a_definition_is_seen_by_a_formula_of_ours(tmp_path):
    plain, ours = (
        judged(tmp_path, "printed = 'u = R x'", head=DEFINED, motion=motion)[0]
        for motion in (MOTION, with_ours("holds = 'R^T u = x'"))
    )
    assert plain["motion"]["because"] == "a definition of what Drake has no quantity for"
    assert ours["motion"]["witness"] == "Drake" and motions(ours)[0]["formula"] == "R^T u = x"


def test_both_forms_of_ours_are_shown_on_one_motion(tmp_path):
    motion = with_ours(
        r"holds = '\ddot{p} = \dot{v}'", r"printed = '\frac{d^n}{dt^n} p = 0 v'", 'orders = "n = 1..2"'
    )
    (claim,) = judged(tmp_path, "printed = 'p = 0 p'\ncorrected = 'p = p'", motion=motion)
    false, right = motions(claim)
    assert (false["outcome"], right["outcome"]) == ("the sides part", "residual within the error")
    assert false["instances"] == ["n = 1", "n = 2"]
    assert claim["motion"]["error"]["false"] == 1.0 and claim["motion"]["error"]["right"] <= 1e-14


@pytest.mark.parametrize(
    "none, because", [("algebra", "no motion: algebra"), ("it is a word", "it is a word")]
)
def test_the_reason_for_no_motion_is_reported(tmp_path, none, because):
    (claim,) = judged(tmp_path, "printed = 'u = R x'", head=DEFINED, motion=with_ours(f'none = "{none}"'))
    assert claim["motion"]["because"] == because == claim["motion"]["line"]
    assert claim["motion"]["witness"] == (because if none == "algebra" else "none")


def test_a_special_motion_shows_what_the_general_ones_do_not(tmp_path):
    holds = r"holds = '\omega = \mathbf{0}'"
    rest, moving = (
        judged(tmp_path, "printed = 'u = R x'", head=DEFINED, motion=with_ours(*lines))[0]
        for lines in ((holds, 'on = "translation"'), (holds,))
    )
    assert rest["passed"] and motions(rest)[0]["motions"] == ["translation"]
    assert not moving["passed"] and moving["reason_code"] == VerdictCode.MOTIONS_CONTRADICT.slug


def test_a_printed_form_that_holds_is_refused(tmp_path):
    motion = with_ours(r"printed = '\dot{p} = v'", r"holds = '\ddot{p} = \dot{v}'")
    (claim,) = judged(tmp_path, "printed = 'p = 0 p'\ncorrected = 'p = p'", motion=motion)
    assert not claim["passed"] and claim["reason_code"] == VerdictCode.MOTIONS_CONTRADICT.slug


@pytest.mark.parametrize(
    "lines, message",
    [
        (["is = 'p = p'"], "expected one of holds, printed, orders, on, none, got is"),
        (["printed = 'p = p'"], "expected holds, or none and why"),
        (["holds = 'p = p'", "none = 'x'"], "expected holds, or none and why"),
        (["holds = 'p = q'"], "q"),
        (["holds = 'p = v'"], "differ in weight"),
        (["holds = 'p = p'", "on = 'the moon'"], "expected one of rest, .*, got the moon"),
        (["holds = 'p = p'", "orders = 'many'"], "motion: .*many"),
        (["holds = 'p = p'", "[motion.claims.1]", "holds = 'p = p'"], "no claim has the id '1'"),
    ],
)
def test_bad_formulas_of_ours_are_refused_where_they_stand(tmp_path, lines, message):
    with pytest.raises(PaperError) as raised:
        paper(tmp_path, "printed = 'p = p'", motion=with_ours(*lines))
    assert any(fault.line is not None and re.search(message, str(fault)) for fault in raised.value.faults)


def test_our_formula_must_be_about_a_motion(tmp_path):
    with pytest.raises(PaperError, match=r"motion\.claims: 0: no motion: algebra"):
        judged(tmp_path, "printed = 'u = R x'", head=DEFINED, motion=with_ours("holds = 'a = a'"))


def test_the_members_that_are_looked_at_grow_together(tmp_path):
    (claim,) = judged(
        tmp_path,
        r"""
        printed = '\frac{d^m}{dt^m} v^{(n)} = \frac{d^n}{dt^n} v^{(m)}'
        orders = "m = 0..2, n = 1..2"
        """,
    )
    assert motions(claim)[0]["instances"] == ["m = 0, n = 1", "m = 1, n = 2", "m = 2, n = 2"]


# --- vetoes, errors


@dataclass(frozen=True)
class Planted:
    """A motion on which one quantity has the other sign."""

    motion: object
    name: str

    def __getattr__(self, attribute):
        return getattr(self.motion, attribute)

    def jet(self, binding, order, sample):
        return self.motion.jet(binding, order, sample) * (-1.0 if binding == self.name else 1.0)


@pytest.mark.parametrize("name", ["w_WB", "v_WBo"])
def test_a_corrected_form_above_its_error_fails_the_run(tmp_path, monkeypatch, name):
    """With a motion of the wrong sign, which neither the plant nor the definitions are asked about."""
    planted = Planted(special_motion("two revolute joints"), name)
    monkeypatch.setattr(motion_witnesses, "_motions", lambda notation: (planted,))
    monkeypatch.setattr(motion_witnesses, "_require_agreement", lambda motion: None)
    monkeypatch.setattr("workbench.prover.motions.binding_check.require_consistent", lambda *anything: None)
    printed = r"""
        printed = '\ddot{p} + \dot{R} x = \dot{v} - \omega \times (R x)'
        corrected = '\ddot{p} + \dot{R} x = \dot{v} + \omega \times (R x)'
    """
    (result,) = judge_paper(paper(tmp_path, printed))
    assert not result.passed and "the correction: expected proved, got unchecked" in result.why_not
    assert VerdictCode.MOTIONS_CONTRADICT in result.why_not.codes


def test_the_same_run_without_the_planted_sign_passes(tmp_path):
    (claim,) = judged(
        tmp_path,
        r"""
        printed = '\ddot{p} + \dot{R} x = \dot{v} - \omega \times (R x)'
        corrected = '\ddot{p} + \dot{R} x = \dot{v} + \omega \times (R x)'
        """,
    )
    assert claim["passed"]


LAW = r"printed = '\frac{d^n}{dt^n} R = \frac{d^{n-1}}{dt^{n-1}} (\tilde{\omega} R)'"


def decades(folder, n: int, turns: tuple[float, float]) -> tuple[float, float]:
    """Of a law in its n-th derivative on the arm, with windows of these widths: residual and error."""
    loaded = paper(folder, LAW + f'\norders = "n = {n}..{n}"')
    (claim,) = loaded.claims
    arm = six_revolute_motion(9, samples=(0.5,), turns=turns)
    choices = bindings_of(claim.notation.motion)
    subject = Subject(claim.printed.statement, (), claim.orders, claim.notation.definitions, choices, (arm,))
    found = witness(subject)
    assert not found.vetoed
    figures = found.evidence.figures
    return figures["residuals_below"][0], figures["errors_below"][0]


def test_residuals_scale_with_the_error_when_the_order_changes(tmp_path):
    residuals, errors = np.log10([decades(tmp_path, n, (4.0, 6.0)) for n in (1, 2, 3, 4)]).T
    assert np.all(residuals <= errors)
    assert np.all(np.diff(errors) >= 1) and np.all(np.diff(residuals) >= 0)
    assert residuals[-1] >= residuals[0] + 2


def test_residuals_scale_with_the_error_when_the_step_changes(tmp_path):
    """Windows ever narrower divide the rounding of the samples by their width."""
    steps = [(4.0, 6.0), (0.4, 0.6), (0.04, 0.06), (0.01, 0.02)]
    residuals, errors = np.log10([decades(tmp_path, 3, turns) for turns in steps]).T
    assert np.all(residuals <= errors)
    assert np.all(np.diff(errors) >= 0) and np.all(np.diff(residuals) >= 0)
    assert errors[-1] >= errors[0] + 3 and residuals[-1] >= residuals[0] + 2


# --- what is bound is tied


def test_bound_symbols_are_tied_by_what_is_bound_beside_them(tmp_path):
    """A point's velocity is the body's and ω × its place, for the exact judge too."""
    head = HEAD + "    '\\Phi' = '\\dot{R} R^T'\n"
    symbols = head.replace(
        "'x' =", "'r' = { kind = \"vector\", constant = true }\n    'y' = { kind = \"vector\" }\n    'x' ="
    )
    motion = MOTION + "    'r' = \"p_BoP_B\"\n    'y' = \"p_WP\"\n    'a' = \"a_WP\"\n"
    (claim,) = judged(
        tmp_path, r"printed = '\dot{y} = v + \omega \times (y - p)'", head=symbols, motion=motion
    )
    assert claim["verdict"] == "proved" and len(motions(claim)[0]["motions"]) == 5


def test_a_tie_never_runs_in_a_circle(tmp_path):
    """The paper defines the place of Bo by that of P: P is not defined by Bo once more."""
    head = HEAD.replace(
        "'p' = { kind = \"vector\", weight = 0 }",
        "'r' = { kind = \"vector\", constant = true }\n    'y' = { kind = \"vector\" }",
    )
    head = head.replace("[definitions]", "[definitions]\n    'p' = 'y - R r'")
    motion = MOTION + "    'r' = \"p_BoP_B\"\n    'y' = \"p_WP\"\n"
    (claim,) = judged(tmp_path, "printed = 'y = p + R r'", head=head, motion=motion)
    assert claim["verdict"] == "proved" and motions(claim)


def test_verify_counts_what_was_seen_and_what_was_not(tmp_path):
    paper(
        tmp_path,
        r"printed = '\dot{p} = v'",
        r"printed = 'a \times x = -x \times a'",
        r"printed = '\omega^{(6)} = \frac{d}{dt} \omega^{(5)} + 0 a'",
    )
    output = CliRunner().invoke(main, ["check", str(tmp_path / "paper.toml")]).output
    assert "on Drake's motions: 1 claims; 1 no motion: algebra; 1 for other reasons not" in output


def test_a_premise_that_is_an_identity_restricts_no_motion(tmp_path):
    """Rounding in (R Rᵀ − I) a is no equation for a: solved, it would put a anywhere, or nowhere."""
    (claim,) = judged(
        tmp_path,
        r"""
        printed = 'R (R^T a) = a \Rightarrow a = x'
        corrected = 'R (R^T a) = a \Rightarrow a = R R^T a'
        """,
    )
    (seen,) = motions(claim)
    assert seen["outcome"] == "the sides part" and seen["samples"] == 22
