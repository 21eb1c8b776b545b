"""Angles that are written otherwise: what cancels in them, what is repeated, and how often."""

import pytest
from judge.test_judge import judged

from workbench.core.verdict import Outcome

SAME = [
    (r"\|a\| - \|a\| + \|b\|", r"\|b\|"),
    (r"\|b\| + \|a\| - \|a\|", r"\|b\|"),
    (r"f g - f g + \alpha", r"\alpha"),
    (r"3 \|a\| - \|a\|", r"2 \|a\|"),
    (r"-2 (f g + \alpha)", r"-2 \alpha - 2 g f"),
    (r"\frac{\|a\|}{3} - \|a\|", r"-\frac{2}{3} \|a\|"),
    (r"\operatorname{Re} \underline{\alpha} + \alpha", r"\alpha + \operatorname{Re} \underline{\alpha}"),
    (r"2 \underline{\alpha} - \underline{\alpha}", r"\underline{\alpha}"),
    (r"\|R a\| + \|a\|", r"2 \|a\|"),
    (r"\|2 a\|", r"2 \|a\|"),
]


@pytest.mark.parametrize(("one", "other"), SAME)
def test_they_turn_alike_and_their_opposites_do_not(one, other):
    for function in (r"\sin", r"\cos"):
        assert judged(f"{function}({one}) = {function}({other})").outcome == Outcome.PROVED
        rate = rf"\frac{{d}}{{dt}} {function}"
        assert judged(f"{rate}({one}) = {rate}({other})").outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
        more = judged(f"{function}({one}) = {function}(2 ({other}))").outcome
        assert more not in (Outcome.PROVED, Outcome.CONDITIONAL)
    assert judged(rf"\sin({one}) = -\sin({other})").outcome not in (Outcome.PROVED, Outcome.CONDITIONAL)


@pytest.mark.parametrize("formula", [r"\sin(f \alpha) = \sin(2 \alpha)", r"\cos(f \alpha) = \cos(2 \alpha)"])
def test_an_angle_in_a_product_is_the_angle_beside_it(formula):
    """For f = 2 they are the same; no point has α = 0 in one of them and another α in the other."""
    assert judged(rf"{formula} \text{{ for }} f = 2").outcome != Outcome.REFUTED
