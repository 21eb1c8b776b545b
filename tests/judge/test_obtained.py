"""Members of which a premise says that they exist, angles of points of the unit circle, and functions of time
with given derivatives: true goals, and false ones of their form."""

import pytest

from tests.judge.goals.test_goals import outcome
from workbench.core.verdict import Outcome
from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    DerivativeAxiom,
    ExistsElimination,
    ExistsIntroduction,
    Instance,
    Introductions,
    Kernel,
    UnitCircleAxiom,
)

ANGLE = r"\exists p \in \mathbb{R} : \cos p = c \wedge \sin p = d"
ON_CIRCLE = r"\forall c, d \in \mathbb{R} : c^2 + d^2 = 1 \Rightarrow"
HALF = r"\exists p \in \mathbb{R} : \cos p = -1 \wedge \sin p = 0"
SOME = r"\Big( \exists c \in V_3 : T c = a \Big)"
FROM_SOME = Introductions(
    ExistsElimination(0, ExistsIntroduction({"d": "2 c"}, Congruence("2 Y", Y=Instance(-1))))
)


@pytest.mark.parametrize(
    ("true", "false", "proof"),
    [
        (f"{ON_CIRCLE} {ANGLE}", f"{ON_CIRCLE} {ANGLE.replace('p = d', 'p = 2 d')}", UnitCircleAxiom()),
        (f"{ON_CIRCLE} {ANGLE}", rf"\forall c, d \in \mathbb{{R}} : {ANGLE}", UnitCircleAxiom()),
        (
            f"{ON_CIRCLE} {ANGLE}",
            rf"\forall c, d \in \mathbb{{R}} : c + d = 1 \Rightarrow {ANGLE}",
            UnitCircleAxiom(),
        ),
        (HALF, HALF.replace("-1", "2"), UnitCircleAxiom()),
        (  # of an angle that is there: what its cosine and sine say of it
            r"\exists q \in \mathbb{R} : \cos q = 1 \wedge \sin q = 0 \wedge \cos(2 q) = 1",
            r"\exists q \in \mathbb{R} : \cos q = 1 \wedge \sin q = 0 \wedge \cos(2 q) = -1",
            Cut(
                HALF,
                UnitCircleAxiom(),
                ExistsElimination(-1, ExistsIntroduction({"q": "2 p"}, Kernel())),
            ),
        ),
        (
            rf"{SOME} \Rightarrow \exists d \in V_3 : T d = 2 a",
            rf"{SOME} \Rightarrow \exists d \in V_3 : T d = a + b",
            FROM_SOME,
        ),
        (  # what there is, is there at one instant
            rf"{SOME} \Rightarrow \exists d \in V_3 : T d = 2 a",
            rf"{SOME} \Rightarrow \exists d \in V_3 : T d = 2 a \wedge \dot{{T}} d = 2 \dot{{a}}",
            FROM_SOME,
        ),
    ],
)
def test_obtained_values_prove_only_true_goals(true, false, proof):
    shown = outcome(true, proof)
    assert shown.outcome == Outcome.PROVED, shown.reason
    assert outcome(false, proof).outcome == Outcome.UNCHECKED


ZERO_ANGLE = r"\exists p \in \mathbb{R} : \cos p = 1 \wedge \sin p = 0"


@pytest.mark.parametrize(
    ("goal", "proof", "why"),
    [
        # no angle, no cosine or no sine, or more than these
        (
            r"\exists p \in \underline{\mathbb{R}} : \cos p = 1 \wedge \sin p = 0",
            UnitCircleAxiom(),
            "a real angle",
        ),
        (
            r"\exists p \in \mathbb{R} : \sin p = 0 \wedge \cos p = 1",
            UnitCircleAxiom(),
            "its cosine and its sine",
        ),
        (
            r"\exists p \in \mathbb{R} : \cos p = 1 \wedge \cos p = 0",
            UnitCircleAxiom(),
            "its cosine and its sine",
        ),
        (r"\exists p \in \mathbb{R} : \cos p = 1", UnitCircleAxiom(), "its cosine and its sine"),
        (
            r"\exists p \in \mathbb{R} : \cos p = 1 \wedge \sin p \neq 0",
            UnitCircleAxiom(),
            "its cosine and its sine",
        ),
        (
            r"\exists p \in \mathbb{R} : \cos(2 p) = 1 \wedge \sin(2 p) = 0",
            UnitCircleAxiom(),
            "its cosine and its sine",
        ),
        (f"{ZERO_ANGLE} \\wedge p = 1", UnitCircleAxiom(), "its cosine and its sine"),
        (f"{ZERO_ANGLE} \\wedge p \\geqslant 1", UnitCircleAxiom(), "its cosine and its sine"),
        (f"{ZERO_ANGLE} \\wedge \\forall c \\in V_3 : c = a", UnitCircleAxiom(), "its cosine and its sine"),
        (f"{ZERO_ANGLE} \\Rightarrow p = 1", UnitCircleAxiom(), "its cosine and its sine"),
        (
            r"\exists p \in \mathbb{R} : \forall c \in \mathbb{R} : \cos p = c \wedge \sin p = 0",
            UnitCircleAxiom(),
            "its cosine and its sine",
        ),
        (ZERO_ANGLE.replace(r"\exists", r"\exists!"), UnitCircleAxiom(), "no rule for ∃!"),
        (r"\exists p, q \in \mathbb{R} : \cos p = 1 \wedge \sin p = 0", UnitCircleAxiom(), "no rule for ∃"),
        # a cosine that is told by the angle itself
        (
            r"\exists p \in \mathbb{R} : \cos p = \cos p \wedge \sin p = \sin p",
            UnitCircleAxiom(),
            "do not depend on it",
        ),
        (
            r"\exists p \in \mathbb{R} : \cos p = \sin p \wedge \sin p = \cos p",
            UnitCircleAxiom(),
            "do not depend on it",
        ),
        (
            r"\exists p \in \mathbb{R} : \cos p = 1 + \varepsilon 1 \wedge \sin p = 0",
            UnitCircleAxiom(),
            "expected a real",
        ),
        # a letter that has a meaning already, and a premise that is no ∃
        (
            r"\Big( \exists d \in V_3 : d = a \Big) \Rightarrow a = b",
            Introductions(ExistsElimination(0, ExistsElimination(0, Congruence("Y", Y=Instance(-1))))),
            "d is a symbol already",
        ),
        (
            r"a = b \Rightarrow \exists c \in V_3 : c = a",
            Introductions(ExistsElimination(0, ExistsIntroduction({"c": "a"}))),
            "premise 0 is a formula, and no ∃",
        ),
        (
            r"\Big( \forall c \in V_3 : c = a \Big) \Rightarrow a = b",
            Introductions(ExistsElimination(0, Congruence("Y", Y=Instance(-1)))),
            "premise 0 is ∀, and no ∃",
        ),
        # one for each is not one for all
        (
            r"\exists d \in V_3 : \forall c \in V_3 : d = c",
            Cut(
                r"\forall c \in V_3 : \exists d \in V_3 : d = c",
                Introductions(ExistsIntroduction({"d": "c"})),
                ExistsElimination(-1, ExistsIntroduction({"d": "d"})),
            ),
            "and no ∃",
        ),
        (
            r"\exists d \in V_3 : \forall c \in V_3 : d = c",
            ExistsIntroduction(
                {"d": "a"},
                Introductions(
                    Cut(
                        r"\exists e \in V_3 : e = c",
                        ExistsIntroduction({"e": "c"}),
                        ExistsElimination(-1, Congruence("Y", Y=Instance(-1))),
                    )
                ),
            ),
            "refuted",
        ),
        # what there is is not what was named, and is not differentiated
        (
            r"\Big( \exists c \in V_3 : c = a \Big) \Rightarrow a = b",
            Introductions(ExistsElimination(0, Congruence("Y", Y=Instance(-1, back=True)))),
            None,
        ),
        (
            r"\Big( \exists c \in V_3^\mathbb{R} : c = a \Big) \Rightarrow \exists d \in V_3^\mathbb{R} : \dot{d} = \dot{a}",
            Introductions(
                ExistsElimination(0, ExistsIntroduction({"d": "c"}, Congruence(r"\dot{Y}", Y=Instance(-1))))
            ),
            "may not be differentiated",
        ),
        (
            r"\Big( \exists c \in V_3 : c = a \Big) \Longrightarrow \dot{a} = \mathbf{0}",
            Introductions(ExistsElimination(0, Congruence(r"\dot{Y}", Y=Instance(-1, back=True)))),
            "may not be differentiated",
        ),
    ],
)
def test_invalid_uses_of_obtained_values_are_unchecked(goal, proof, why):
    found = outcome(goal, proof)
    assert found.outcome == Outcome.UNCHECKED
    assert why is None or why in found.reason, found.reason


def test_a_letter_that_was_obtained_is_not_any():
    """∀ c: …, behind an ∃ c whose c was obtained, is not of this c alone."""
    goal = r"\Big( \exists c \in V_3 : c = a \Big) \Rightarrow \forall c \in V_3 : c = a"
    assert outcome(goal, Introductions(Congruence("Y", Y=Instance(-1)))).outcome == Outcome.UNCHECKED
    found = outcome(
        goal, Cut("a = a", Kernel(), Introductions(ExistsElimination(0, Congruence("Y", Y=Instance(-1)))))
    )
    assert found.outcome == Outcome.UNCHECKED


def test_the_evidence_names_what_is_supposed_of_angles():
    shown = outcome(HALF, UnitCircleAxiom())
    assert [e.method for e in shown.evidence] == ["goal, ∃: the angle of a point of the unit circle"]


BELOW = r"\Big( \forall k < n : v^{(k)} = \mathbf{0} \Big)"
SOME_V = r"\forall n \geq 0 : \forall c \in V_3 : \exists v \in V_3^\mathbb{R} : "
FROM_V = Introductions(
    Cut(
        rf"\exists v \in V_3^\mathbb{{R}} : {BELOW} \wedge v^{{(n)}} = c",
        DerivativeAxiom(),
        ExistsElimination(-1, Congruence("Y", Y=Instance(-1, {"k": "0"}))),
    )
)


def test_some_function_has_these_derivatives():
    shown = outcome(rf"{SOME_V} {BELOW} \wedge v^{{(n)}} = c", DerivativeAxiom())
    assert shown.outcome == Outcome.PROVED
    assert [e.method for e in shown.evidence] == [
        "goal, ∃: a function of time with these derivatives at an instant"
    ]


@pytest.mark.parametrize(
    "goal",
    [
        SOME_V.replace(r"v \in V_3^\mathbb{R}", r"v \in V_3") + rf"{BELOW} \wedge v^{{(n)}} = c",
        SOME_V.replace(r"\exists", r"\exists!") + rf"{BELOW} \wedge v^{{(n)}} = c",
        SOME_V.replace("c \\in V_3", r"c \in \underline{V}_3") + rf"{BELOW} \wedge v^{{(n)}} = c",
        rf"{SOME_V} {BELOW} \wedge v^{{(n)}} = v",
        rf"{SOME_V} {BELOW} \wedge v^{{(n)}} \neq c",
        rf"{SOME_V} {BELOW} \wedge v^{{(n)}} = 2 c",
        rf"{SOME_V} {BELOW} \wedge v^{{(n+1)}} = c",
        rf"{SOME_V} {BELOW} \wedge \frac{{d^n}}{{dt^n}} [2 v] = c",
        rf"{SOME_V} {BELOW} \wedge v^{{(n)}} = c \wedge \dot{{v}} = c",
        rf"{SOME_V} {BELOW} \wedge v^{{(n)}} = c \wedge \forall e \in V_3 : e = v",
        rf"{SOME_V} \Big( {BELOW} \wedge v^{{(n)}} = c \Big) \Rightarrow v = c",
        rf"{SOME_V} {BELOW.replace('n', 'n+1', 1)} \wedge v^{{(n)}} = c",
        rf"{SOME_V} {BELOW.replace('(k)', '(k+1)')} \wedge v^{{(n)}} = c",
        r"\forall n \geq 0 : \forall c \in V_3 : \exists v \in V_3^\mathbb{R} : v^{(n)} = c",
        r"\exists v \in SO_3^\mathbb{R} : \Big( \forall k < 1 : v^{(k)} = 0 \Big) \wedge v^{(1)} = T",
        r"\exists v \in S^2^\mathbb{R} : \Big( \forall k < 1 : v^{(k)} = \mathbf{0} \Big) \wedge v^{(1)} = a",
    ],
)
def test_no_function_is_said_to_have_others(goal):
    assert outcome(goal, DerivativeAxiom()).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize(
    ("goal", "proof", "why"),
    [
        (r"\forall n \geq 0 : \forall c \in V_3 : c = \mathbf{0}", FROM_V, "not seen to be less than n"),
        (r"\forall n \geq 1 : \forall c \in V_3 : c = \mathbf{0}", FROM_V, "is refuted"),
        (
            r"\Big( \forall k < 2 : a^{(k)} = b^{(k)} \Big) \wedge T = F_1 \Rightarrow a = b",
            Introductions(Congruence("Y", Y=Instance(0, {"k": "0"}, part=2))),
            "no part 2",
        ),
        (
            r"\Big( \forall k < 2 : a^{(k)} = b^{(k)} \Big) \wedge T = F_1 \Rightarrow a^{(2)} = b^{(2)}",
            Introductions(Congruence("Y", Y=Instance(0, {"k": "2"}))),
            "not seen to be less than 2",
        ),
    ],
)
def test_goals_that_do_not_follow_are_unchecked(goal, proof, why):
    found = outcome(goal, proof)
    assert found.outcome == Outcome.UNCHECKED and why in found.reason, found.reason


def test_a_part_of_a_premise_is_used():
    goal = r"\Big( \forall k < 2 : a^{(k)} = b^{(k)} \Big) \wedge T = F_1 \Rightarrow a = b \wedge T = F_1"
    proof = Introductions(
        AndIntroduction(Congruence("Y", Y=Instance(0, {"k": "0"})), Congruence("Y", Y=Instance(0, part=1)))
    )
    assert outcome(goal, proof).outcome == Outcome.PROVED
