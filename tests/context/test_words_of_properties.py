"""A property of symbols counts however a sentence puts it, and a denied one does not."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, model
from workbench.core.verdict import Outcome

KINDS = {"a": "vector", "b": "vector", "u": "vector", "f": "scalar", "S": "tensor", "M": "tensor"}
#: A formula that holds under a property only, and the sentences that state the property.
STATED = {
    r"(u \cdot a) u = a + u \times (u \times a)": (
        "For a unit vector $u$,",
        "If $u$ is a unit vector, then",
        "As $u$ has unit length,",
        "If $u$ is of unit magnitude,",
        "Since $u$ has length one,",
        "For normalized $u$,",
    ),
    r"\frac{d}{dt} (f a) = f \dot{a}": (
        "For constant $f$,",
        "The scalar $f$ is time-invariant. Hence",
        "If $f$ does not depend on time,",
        "As $f$ does not vary with time,",
    ),
    r"(a + b) \cdot (a + b) = a \cdot a + b \cdot b": (
        "For perpendicular $a$ and $b$,",
        "Since $a$ and $b$ are orthogonal,",
        "Since $a$ is perpendicular to $b$,",
        "As the vector $a$ is orthogonal to the vector $b$,",
        "With $a$ normal to $b$,",
    ),
    r"(a \cdot b) a = (a \cdot a) b": (
        "When $a$ is parallel to $b$,",
        "For collinear $a$ and $b$,",
        "If $a$ and $b$ have the same direction,",
    ),
    r"f a + b = b - f (b + a)": ("When $f$ vanishes,", "If $f$ is zero,"),
    r"u \cdot \dot{u} = 0": ("Let $u$ be a unit vector. Then", "As $u$ has unit length,"),
    r"S M a = M S a": (
        "If $S$ and $M$ are diagonal,",
        "For diagonal $S$ and $M$,",
        "If $S$ commutes with $M$,",
    ),
}
DENIED = {
    r"(u \cdot a) u = a + u \times (u \times a)": (
        "Although $u$ does not have unit length,",
        "Without assuming that $u$ has unit length,",
        "It need not be a unit vector $u$:",
        "If $u$ is not of unit magnitude,",
    ),
    r"\frac{d}{dt} (f a) = f \dot{a}": (
        "Although $f$ depends on time,",
        "As $f$ varies with time,",
        "For no constant $f$,",
    ),
    r"(a + b) \cdot (a + b) = a \cdot a + b \cdot b": (
        "As $a$ is not perpendicular to $b$,",
        "Even if $a$ need not be orthogonal to $b$,",
    ),
    r"(a \cdot b) a = (a \cdot a) b": (
        "As $a$ is not parallel to $b$,",
        "Without assuming that $a$ is parallel to $b$,",
    ),
    r"f a + b = b - f (b + a)": ("As $f$ does not vanish,", "Since $f$ never vanishes,"),
}


def rows(table: dict[str, tuple[str, ...]]) -> list[tuple[str, str]]:
    return [(words, display) for display, sentences in table.items() for words in sentences]


def verdict_on(folder: Path, words: str, display: str):
    (verdict,) = judged(folder, f"{words}\n\n$$\n{display}\n$$\n", model(KINDS))
    return verdict


@pytest.mark.parametrize(("words", "display"), rows(STATED))
def test_property_counts_in_each_wording(tmp_path: Path, words: str, display: str) -> None:
    assert verdict_on(tmp_path, "We have", display).outcome in (Outcome.REFUTED, Outcome.DEFINITION)
    assert verdict_on(tmp_path, words, display).outcome is Outcome.CONDITIONAL


@pytest.mark.parametrize(("words", "display"), rows(DENIED))
def test_denied_property_excuses_nothing(tmp_path: Path, words: str, display: str) -> None:
    verdict = verdict_on(tmp_path, words, display)
    assert verdict.outcome is Outcome.REFUTED and str(verdict.grade) in ("error", "warning")


@pytest.mark.parametrize(
    ("words", "display"),
    [
        ("For coplanar $a$, $b$ and $u$,", r"a \cdot (b \times u) = (a \times u) \cdot b"),
        ("If $S$ is singular,", r"S M a = M S a"),
        ("For linearly dependent $a$ and $b$,", r"a \times b = b \times a"),
        ("For isotropic $S$,", r"S M a = M S a"),
    ],
)
def test_unformalized_property_lowers_an_error(tmp_path: Path, words: str, display: str) -> None:
    assert str(verdict_on(tmp_path, "We have", display).grade) == "error"
    lowered = verdict_on(tmp_path, words, display)
    assert str(lowered.grade) == "warning" and any("the text says more" in each for each in lowered.unless)


@pytest.mark.parametrize("words", ["Let $f = g^2$. Then", "With $f = g^2$,", "We put $f = g^2$ and find"])
def test_definition_in_a_sentence_holds_for_all_times(tmp_path: Path, words: str) -> None:
    kinds = {"f": "scalar", "g": "scalar"}

    def verdict(display: str):
        return judged(tmp_path, f"{words}\n\n$$\n{display}\n$$\n", model(kinds))[0]

    assert verdict(r"\dot{f} = 2 g \dot{g}").outcome is Outcome.CONDITIONAL
    assert str(verdict(r"\dot{f} = 3 g \dot{g}").grade) == "error"


def test_plain_letter_may_be_the_bold_one(tmp_path: Path) -> None:
    kinds = {r"\mathbf{w}": "vector", "a": "vector", "w": "vector", "f": "scalar"}

    def verdict(right: str):
        display = rf"a \times (\mathbf{{w}} \times a) = (a \cdot a) {right} - (\mathbf{{w}} \cdot a) a"
        return judged(tmp_path, f"We have\n\n$$\n{display}\n$$\n", model(kinds))[0]

    assert verdict(r"\mathbf{w}").outcome is Outcome.PROVED
    assert "another typeface" in verdict("w").reason
    assert verdict(r"2 \mathbf{w}").outcome is Outcome.REFUTED
