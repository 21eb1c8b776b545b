"""Norms and roots in both engines: numbers, factors and squares are taken out, and each root is one letter."""

from itertools import combinations, product

import pytest
from judge.test_judge import judged

from workbench.core.verdict import Outcome

NUMBERS = {"2": "2", "-3": "3", r"\frac{1}{2}": r"\frac{1}{2}", r"-\frac{2}{3}": r"\frac{2}{3}", "6": "6"}
LENGTHS = [r"\|{0} a\|", r"\|{0} f a\|", r"|{0} f|", r"\sqrt{{({0})^2 (f^2 + g^2)}}"]


@pytest.mark.parametrize(("number", "length"), list(product(NUMBERS, LENGTHS)))
def test_a_number_is_taken_out(number, length):
    size, alone = NUMBERS[number], length.format("1")
    scaled = length.format(rf"\left({number}\right)")
    assert judged(f"{scaled} = {size} {alone}").outcome == Outcome.PROVED
    assert judged(f"{scaled} = {size}^2 {alone}").outcome == Outcome.REFUTED
    assert (
        judged(rf"\frac{{d}}{{dt}} {scaled} = {size} \frac{{d}}{{dt}} {alone}", [f"{alone} \\neq 0"]).outcome
        == Outcome.PROVED
    )


@pytest.mark.parametrize("number", ["2", r"\frac{1}{2}", r"\frac{5}{3}", "12"])
def test_the_root_of_a_number_that_is_no_square_is_a_letter(number):
    assert judged(rf"\sqrt{{{number}}} \sqrt{{{number}}} = {number}").outcome == Outcome.PROVED
    root = rf"\sqrt{{{number} f^2 + g^2}}"
    assert judged(rf"{root} {root} = {number} f^2 + g^2").outcome == Outcome.PROVED
    assert judged(rf"{root} {root} = {number} f^2 - g^2").outcome == Outcome.REFUTED


SUMS = ["1 + f^2", "2 + f^2", "1 + f^2 + g^2", "f^2 + g^2 + f^2 g^2 + 3", r"a \cdot a + 1"]
NO_ROOTS = ["1 + f", "f + g", "f g", r"\frac{f}{2}"]


@pytest.mark.parametrize(
    ("one", "other"),
    [(rf"\sqrt{{{x}}}", rf"\sqrt{{{y}}}") for x, y in combinations(SUMS, 2)]
    + [(rf"\sqrt{{{x}}}", y) for x, y in product(SUMS, NO_ROOTS)]
    + [(rf"f \sqrt{{{x}}}", rf"\frac{{f^2 + 3}}{{\sqrt{{{x}}}}}") for x in SUMS],
)
def test_unequal_roots_are_refuted_at_irrational_values(one, other):
    verdict = judged(f"{one} = {other}")
    assert verdict.outcome == Outcome.REFUTED
    example = verdict.counterexample
    assert example is not None and example.left != example.right
