"""Norms and roots in both engines: numbers, factors and squares are taken out, and each root is one letter."""

from itertools import combinations, product

import pytest
from judge.test_judge import judged

from workbench import check
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


DUALS = {"a": "dual scalar", "b": "dual scalar", "v": "dual vector", "f": "scalar", "g": "scalar"}
#: sums of squares whose real parts are positive
POSITIVE = [
    "1 + a^2",
    "(1 + a^2)(2 + b^2)",
    "(3 + 3 a^2)^2",
    "1 + f^2 + \\varepsilon g",
    r"4 + \varepsilon g",
]


@pytest.mark.parametrize("square", POSITIVE)
def test_the_root_of_a_dual_number(square):
    """Its square, its dual part and its rate: what makes it the root."""
    root, real = rf"\sqrt{{{square}}}", rf"\sqrt{{\operatorname{{Re}}({square})}}"
    laws = [
        (rf"({root})^2", square),
        (rf"\operatorname{{Re}}({root})", real),
        (rf"2 {real} \operatorname{{Du}}({root})", rf"\operatorname{{Du}}({square})"),
        (rf"2 {root} \frac{{d}}{{dt}} ({root})", rf"\frac{{d}}{{dt}} ({square})"),
    ]
    for left, right in laws:
        assert check(f"{left} = {right}", DUALS).outcome is Outcome.PROVED, left
        assert check(f"{left} = {right} + \\varepsilon", DUALS).outcome in (
            Outcome.REFUTED,
            Outcome.ILL_FORMED,
        ), left


#: Roots of what is a square or a sum of squares as it is written, not as it is once multiplied out.
WRITTEN = [
    (r"\sqrt{(x - y)^2}", r"|x - y|", "x - y"),
    (r"\sqrt{(x - y) (x - y)}", r"|y - x|", "y - x"),
    (r"\sqrt{x^2 \sin^2 y + x^2 \cos^2 y}", "|x|", "x"),
    (r"\sqrt{(x \sin y)^2 + (x \cos y)^2}", "|x|", "x"),
    (r"\sqrt{a \cdot a}", r"\|a\|", r"2 \|a\|"),
    (r"\sqrt{(a - b) \cdot (a - b)}", r"\|b - a\|", r"\|a + b\|"),
    (r"\sqrt{\det(T T^T)}", r"|\det T|", r"\det T"),
    (r"\sqrt{\det(T^T T)}", r"|\det T|", r"-\det T"),
    (r"\sqrt{(1 + x^2)^2}", "1 + x^2", "1 - x^2"),
]


@pytest.mark.parametrize(("root", "true", "false"), WRITTEN)
def test_a_root_of_what_is_written_as_squares(root, true, false):
    symbols = {"x": "scalar", "y": "scalar", "a": "vector", "b": "vector", "T": "tensor"}
    assert check(f"{root} = {true}", symbols).outcome is Outcome.PROVED
    assert check(f"{root} = {false}", symbols).outcome is Outcome.REFUTED


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
