"""Members of which a premise says that they exist, angles of points of the unit circle, and functions of time
with given derivatives: true goals, and false ones of their form."""

from tests.judge.goals.test_goals import outcome
from workbench.core.verdict import Outcome
from workbench.language.goals.proofs import (
    DerivativeAxiom,
    UnitCircleAxiom,
)

HALF = r"\exists p \in \mathbb{R} : \cos p = -1 \wedge \sin p = 0"


def test_the_evidence_names_what_is_supposed_of_angles():
    shown = outcome(HALF, UnitCircleAxiom())
    assert [e.method for e in shown.evidence] == ["goal, ∃: the angle of a point of the unit circle"]


BELOW = r"\Big( \forall k < n : v^{(k)} = \mathbf{0} \Big)"
SOME_V = r"\forall n \geq 0 : \forall c \in V_3 : \exists v \in V_3^\mathbb{R} : "


def test_some_function_has_these_derivatives():
    shown = outcome(rf"{SOME_V} {BELOW} \wedge v^{{(n)}} = c", DerivativeAxiom())
    assert shown.outcome == Outcome.PROVED
    assert [e.method for e in shown.evidence] == [
        "goal, ∃: a function of time with these derivatives at an instant"
    ]
