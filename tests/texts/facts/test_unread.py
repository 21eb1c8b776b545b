r"""What a text says of a symbol in a formula that is not read: a value is judged with, and anything else keeps a
formula that is false for a free symbol from being refuted."""

from pathlib import Path

import pytest

from tests.texts.written import shown, symbols_of, told, verdicts

KINDS = {**dict.fromkeys((r"\theta", r"\phi", "x", "y", "z", "m"), "scalar"), "v": "vector"}

#: What the text says, a formula that is true with it and false in general, and one that is false with it, too.
VALUES = [
    (r"\theta = \pm 90^{\circ }", r"x \cos\theta + y = y + 2 x \cos\theta", r"x \sin\theta + y = y + x \sin^2\theta"),
    (r"\theta = \pm\frac{\pi}{2}", r"x \sin\theta + y = y + x \sin^3\theta", r"x \sin\theta + y = y - x \sin\theta"),
    (r"\theta = 90\degree", r"x \sin\theta + y = y + x \sin^2\theta", r"x \sin\theta + y = y - x \sin^2\theta"),
    (r"\theta = -90°", r"x \sin\theta + y = y - x \sin^2\theta", r"x \sin\theta + y = y + x \sin^2\theta"),
    (r"\theta=\pi.", r"x \cos\theta + y = y - x \cos^2\theta", r"x \cos\theta + y = y + x \cos^2\theta"),
    (r"\theta = 0", r"x \tan\theta + y = y + 2 x \tan\theta", r"x \tan\theta + y = 2 y + x \tan\theta"),
    (r"\theta = 270^\circ", r"x \dot{\theta} + y = y - x \dot{\theta} \sin\theta + x \cos\theta", r"x \dot{\theta} + y = x + y + x \dot{\theta}"),
    ("m = 2", "x m + y = y + m^2 x / 2", "x m + y = y + m^2 x"),
    ("m = -2", "2 x m + y = y - m^2 x", "2 x m + y = y + m^2 x"),
    ("m = 0", "x m + y = y + m^2 x", "x m + y = 2 y + m^2 x"),
    ("m = 3", r"x \dot{m} + y = y + 2 x \dot{m}", r"x \dot{m} + y = x + y + 2 x \dot{m}"),
]  # fmt: skip

#: What it says, and a formula that may be true with it.
OPEN = [
    (r"\theta = 30^\circ", r"x \sin\theta + y = y + 2 x \sin^2\theta"),
    (r"\theta = 180^\circ", r"x \cos\frac{\theta}{2} + y = y + 2 x \cos\frac{\theta}{2}"),
    (r"\theta = 360^\circ", r"x \cos\frac{\theta}{2} + y \cos\frac{\theta}{2} = y \cos\frac{\theta}{2} - x"),
    (r"\theta = 90^\circ", r"x \theta + x \cos\theta = x \theta + 2 x \cos\theta"),
    (r"\theta = 90^\circ$, $\theta = 0", r"x \cos\theta + y = y + 2 x \cos\theta"),
    (r"\theta = 0$, $\theta = 90^\circ", r"x \cos\theta + y = y + 2 x \cos\theta"),
    (r"\theta = 90^\circ, 270^\circ", r"x \cos\theta + y = y + 2 x \cos\theta"),
    (r"\theta = 90^\circ", r"\frac{d}{dt}(m v) + v \cos\theta = m \dot{v} + 2 v \cos\theta"),
    (r"\theta = 90", r"x \cos\theta + y = y + 2 x \cos\theta"),
    (r"m(0) = 2", "x m + y = y + m^2 x"),
    (r"m = 5 \,\text{g}", "x m + y = y + m^2 x"),
    (r"m = \int x", "x m + y = y + m^2 x"),
    (r"\dot{m} = \int x", "x m + y = y + 2 x m"),
    (r"m = 2$, $m = \int x", "x m + y = y + 2 x m"),
]


def outcomes(folder: Path, said: str, *displays: str) -> list[str]:
    text = f"Note this (${said}$)!\n\n{shown(*displays)}"
    return [told(each) for each in verdicts(folder, text, symbols_of(KINDS))]


@pytest.mark.parametrize(("said", "true", "false"), VALUES)
def test_a_formula_is_judged_with_the_value_that_the_text_gives(
    tmp_path: Path, said: str, true: str, false: str
) -> None:
    assert outcomes(tmp_path, said, true, false) == ["conditional", "refuted"]
    assert outcomes(tmp_path, "z", true, false) == ["refuted"] * 2


@pytest.mark.parametrize(("said", "formula"), OPEN)
def test_unread_statements_keep_a_falsehood_open(tmp_path: Path, said: str, formula: str) -> None:
    assert outcomes(tmp_path, said, formula) == ["doubtful"]


@pytest.mark.parametrize("said", [r"\dot{m} = 0", r"\ddot{m} = 3"])
def test_unread_statement_that_a_refutation_meets_is_no_doubt(tmp_path: Path, said: str) -> None:
    assert outcomes(tmp_path, said, "x m + y = y + 2 x m") == ["refuted"]


def test_a_decimal_value_is_met_by_the_counterexample(tmp_path: Path) -> None:
    assert outcomes(tmp_path, "m = 1.5", "x m + y = y + 2 x m") == ["refuted"]
    assert outcomes(tmp_path, "m = 1.5", "2 x m + y = y + 3 x") == ["conditional"]


def test_a_value_and_a_definition_may_make_a_claim_true(tmp_path: Path) -> None:
    definition, follows = "z = x + x^2", r"z \sin\theta + z y = x + x^2 \sin\theta + z y"
    assert outcomes(tmp_path, r"\theta = 90^\circ", definition, follows) == [
        "said",
        "conditional",
    ]
    false = follows.replace("= x", "= 2 x")
    assert outcomes(tmp_path, r"\theta = 90^\circ", definition, false) == ["said", "refuted"]


def test_a_value_decides_what_a_formula_says(tmp_path: Path) -> None:
    assert outcomes(tmp_path, "m = 2", "x y m = x^2 + x + y") == ["refuted"]
