"""Norms and roots in both engines: numbers, factors and squares are taken out, and each root is one letter."""

from itertools import product

import pytest
from judge.test_judge import judged

from workbench.judge.verdict import Outcome

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


SPLIT = [
    (r"\sqrt{(f^2 + 1)(g^2 + 1)}", r"\sqrt{f^2 + 1} \sqrt{g^2 + 1}"),
    (r"\sqrt{(f^2 + 1)^3}", r"(f^2 + 1) \sqrt{f^2 + 1}"),
    (r"\sqrt{(f^2 + 1)^5}", r"(f^2 + 1)^2 \sqrt{f^2 + 1}"),
    (r"\sqrt{f^2 g^4}", r"|f| g^2"),
    (r"\|f g a\|", r"|f| |g| \|a\|"),
    (r"\|f^2 a\|", r"f^2 \|a\|"),
    (r"\|(f^2 + 2) a\|", r"(f^2 + 2) \|a\|"),
    (r"\| \|a\| b\|", r"\|a\| \|b\|"),
    (r"\sqrt{\frac{1}{4} f^2 + g^2}", r"\frac{1}{2} \sqrt{f^2 + 4 g^2}"),
    (r"\sqrt{4}", "2"),
    (r"\sqrt{\frac{9}{4}}", r"\frac{3}{2}"),
]


@pytest.mark.parametrize("number", ["2", r"\frac{1}{2}", r"\frac{5}{3}", "12"])
def test_the_root_of_a_number_that_is_no_square_is_a_letter(number):
    assert judged(rf"\sqrt{{{number}}} \sqrt{{{number}}} = {number}").outcome == Outcome.PROVED
    root = rf"\sqrt{{{number} f^2 + g^2}}"
    assert judged(rf"{root} {root} = {number} f^2 + g^2").outcome == Outcome.PROVED
    assert judged(rf"{root} {root} = {number} f^2 - g^2").outcome == Outcome.REFUTED


@pytest.mark.parametrize(("whole", "parts"), SPLIT)
def test_a_product_of_squares_is_a_product_of_roots(whole, parts):
    assert judged(f"{whole} = {parts}").outcome == Outcome.PROVED
    assert judged(f"{whole} = 2 ({parts})").outcome == Outcome.REFUTED
    assert judged(f"{whole} = -({parts})").outcome == Outcome.REFUTED
