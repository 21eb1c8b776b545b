"""Equivalences and implications between zeros: what one equation says of another."""

from fractions import Fraction
from random import Random

import pytest
from judge.test_judge import TABLE, judged

from workbench.core.codes.verdict_codes import UNLESS_IT_LASTS
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definition
from workbench.language.definitions import Definitions


def product(roots, powers):
    return " ".join(rf"(f - ({r}))^{n}" for r, n in zip(roots, powers, strict=True))


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("operator", ["=", r"\neq"])
def test_polynomials_with_equal_roots_have_equal_zero_sets(seed, operator):
    random = Random(seed)
    roots = random.sample([-2003, -7, 0, 1, 5, 1009], random.randint(1, 3))
    others = list(roots) if seed % 3 == 0 else random.sample([-2003, -7, 0, 1, 5, 1009], random.randint(1, 3))
    left, right = (product(r, [random.randint(1, 2) for _ in r]) for r in (roots, others))
    verdict = judged(rf"{left} {operator} 0 \Leftrightarrow {right} {operator} 0")
    if set(roots) == set(others):
        assert verdict.outcome == Outcome.PROVED
        assert len(verdict.evidence) == 4
    else:
        assert verdict.outcome == Outcome.REFUTED
        (value,) = verdict.counterexample.values["f"]
        assert int(value) in set(roots) ^ set(others)
    implied = judged(rf"{left} {operator} 0 \Rightarrow {right} {operator} 0")
    holds = set(roots) <= set(others) if operator == "=" else set(others) <= set(roots)
    assert (implied.outcome == Outcome.PROVED) == holds
    assert (implied.outcome == Outcome.REFUTED) == (not holds)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("f + 1009 g = 0", "(f + 1009 g)(f + 2003 g - 4001) = 0"),
        (r"a = \mathbf{0}", r"a \cdot (b - 1009 a) = 0"),
        (r"2 f = 1009", r"(2 f - 1009)(3 f - 2003) = 0"),
    ],
)
def test_zeros_are_solved_for(left, right):
    verdict = judged(rf"{left} \Leftrightarrow {right}")
    assert verdict.outcome == Outcome.REFUTED
    sides = [*verdict.counterexample.left, *verdict.counterexample.right]
    assert all(Fraction(x) is not None for x in sides)
    assert judged(rf"{left} \Rightarrow {right}").outcome != Outcome.REFUTED
    assert judged(rf"{right} \Rightarrow {left}").outcome == Outcome.REFUTED


def test_a_claim_that_needs_a_lasting_premise_asks_its_author():
    verdict = judged(r"f = 1 \Rightarrow \dot{f} = 0")
    assert verdict.outcome == Outcome.UNCHECKED
    assert verdict.reason.startswith("false if the condition holds at one instant only")
    assert judged(r"f = 1 \Rightarrow \dot{f} = g").outcome == Outcome.REFUTED
    assert judged(r"f = 1 \Rightarrow f g = g").outcome == Outcome.PROVED


def test_an_assumption_may_hold_at_all_times():
    """An assumption is a premise: it, too, is supposed at the instant, and may be meant for all times."""
    table = TABLE.with_specs({"v": {"kind": "vector"}, r"\theta": {"kind": "scalar"}})
    definition, known = read_definition("v", r"f a + \dot{\theta} b", table)
    definitions = Definitions([definition])
    for latex, outcome in (("v = f a", Outcome.UNCHECKED), ("v = 2 f a", Outcome.REFUTED)):
        verdict = judged(latex, (r"\theta = 0",), definitions=definitions, table=known)
        assert verdict.outcome == outcome
        assert (verdict.code in UNLESS_IT_LASTS) == (outcome is Outcome.UNCHECKED)
    both = (r"\theta = 0", r"\dot{\theta} = 0")
    assert judged("v = f a", both, definitions=definitions, table=known).outcome == Outcome.PROVED
