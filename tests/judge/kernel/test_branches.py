r"""θ = c arccos x and its kin: what is said without the arc, on which branch, and where nothing is said."""

import math
from dataclasses import replace
from fractions import Fraction

import pytest
from judge.test_judge import defined, judged

from workbench.core.verdict import Outcome

#: How c · arc may be written, with c and what stands for α/c.
FACTORS = {
    r"{}": (Fraction(1), r"\alpha"),
    r"-{}": (Fraction(-1), r"\left(-1\right) \alpha"),
    r"2 {}": (Fraction(2), r"\frac{1}{2} \alpha"),
    r"\frac{{{}}}{{2}}": (Fraction(1, 2), r"2 \alpha"),
    r"-\frac{{2}}{{3}} {}": (Fraction(-2, 3), r"\left(-\frac{3}{2}\right) \alpha"),
    r"\frac{{-2 {}}}{{3}}": (Fraction(-2, 3), r"\left(-\frac{3}{2}\right) \alpha"),
}

#: What is known of p = α/c, the branch, and the angle on it that has the same sine and cosine as p.
ARCS = {
    r"\arccos f": ([r"\cos(p) = f"], r"0 \leq p \leq \pi", lambda p: math.acos(math.cos(p))),
    r"\arcsin f": (
        [r"\sin(p) = f"],
        r"-\frac{\pi}{2} \leq p \leq \frac{\pi}{2}",
        lambda p: math.asin(math.sin(p)),
    ),
    r"\arctan f": (
        [r"\sin(p) = f \cos(p)"],
        r"-\frac{\pi}{2} < p < \frac{\pi}{2}",
        lambda p: math.atan(math.tan(p)),
    ),
    r"\operatorname{atan2}(f, g)": (
        [r"\sin(p) \sqrt{f^2 + g^2} = f", r"\cos(p) \sqrt{f^2 + g^2} = g"],
        r"-\pi < p \leq \pi",
        lambda p: math.atan2(math.sin(p), math.cos(p)),
    ),
}


@pytest.mark.parametrize("factor", FACTORS)
@pytest.mark.parametrize("arc", ARCS)
def test_it_holds_on_the_branch_and_the_witness_is_on_another(arc, factor):
    known, branch, principal = ARCS[arc]
    c, part = FACTORS[factor]
    verdict = judged(rf"\alpha = {factor.format(arc)}", [said.replace("(p)", rf"({part})") for said in known])
    assert verdict.outcome == Outcome.CONDITIONAL
    assert str(verdict.hypothesis) == branch.replace(" p ", f" {part} ").replace("leq p", rf"leq {part}")
    witness = verdict.counterexample
    (value,) = witness.values[r"\alpha"]
    assert witness.left == (value,) and witness.right == (f"an angle with {verdict.hypothesis}",)
    angle = float(Fraction(value) / c)
    on_it = principal(angle)
    assert abs(angle - on_it) > 1
    for share in (1, 2, 3, 4):
        assert math.cos(angle / share) == pytest.approx(math.cos(on_it / share), abs=1e-12)
        assert math.sin(angle / share) == pytest.approx(math.sin(on_it / share), abs=1e-12)
    *engines, said = verdict.evidence
    assert len(engines) == 2 * len(known)
    assert (said.method, said.outcome) == ("branch", rf"\alpha = {value} lies on another one")


@pytest.mark.parametrize("arc", ARCS)
def test_the_arc_may_stand_on_either_side(arc):
    known, _, _ = ARCS[arc]
    assume = [said.replace("(p)", r"(\alpha)") for said in known]
    one, other = judged(rf"{arc} = \alpha", assume), judged(rf"\alpha = {arc}", assume)
    assert one == replace(other, read_back=one.read_back)


@pytest.mark.parametrize("arc", ARCS)
@pytest.mark.parametrize("part", [r"2 \alpha", r"-\alpha", r"\alpha + \beta", r"\alpha + f"])
def test_of_another_angle_it_is_not_said(arc, part):
    known, _, _ = ARCS[arc]
    verdict = judged(rf"\alpha = {arc}", [said.replace("(p)", f"({part})") for said in known])
    is_even = part == r"-\alpha" and "cos" in arc
    assert verdict.outcome in ((Outcome.CONDITIONAL,) if is_even else (Outcome.REFUTED, Outcome.UNCHECKED))


@pytest.mark.parametrize("arc", ARCS)
def test_of_any_angle_it_is_false(arc):
    verdict = judged(rf"\alpha = {arc}")
    assert verdict.outcome == Outcome.REFUTED
    assert verdict.counterexample.left != verdict.counterexample.right


def test_a_sum_of_angles_has_no_branch_witness():
    verdict = judged(r"\alpha + \beta = \arccos f", [r"\cos(\alpha + \beta) = f"])
    assert verdict.outcome == Outcome.UNCHECKED
    assert verdict.reason == r"holds up to the branch: where 0 \leq \alpha + \beta \leq \pi"
    definitions, table = defined(**{r"\gamma": r"\alpha - \beta"})
    verdict = judged(
        r"\gamma = \arcsin f", [r"\sin(\alpha - \beta) = f"], definitions=definitions, table=table
    )
    assert verdict.outcome == Outcome.UNCHECKED and verdict.reason.startswith("holds up to the branch: where")


@pytest.mark.parametrize("arc", [r"\arccos", r"\arcsin", r"\arctan"])
@pytest.mark.parametrize("factor", ["", "-", "2 ", r"\frac{1}{3} "])
def test_two_of_one_kind_are_equal_where_their_arguments_are(arc, factor):
    claim = rf"{factor}{arc} f = {factor}{arc} g"
    assert judged(claim, ["f = g"]).outcome == Outcome.PROVED
    verdict = judged(claim)
    assert verdict.outcome == Outcome.REFUTED
    sides = [*verdict.counterexample.left, *verdict.counterexample.right]
    assert len(set(sides)) == 2 and (arc == r"\arctan" or all(abs(Fraction(x)) <= 1 for x in sides))
