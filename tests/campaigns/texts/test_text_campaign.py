"""The campaign of texts: that its own truth is right, that it sees what is wrong, and what the product says."""

from __future__ import annotations

import os
from dataclasses import replace
from random import Random

import pytest
from context_laws import in_formula
from exact_values import holds
from formula_trees import Writer, leaf, number, unit, zero
from identity_pool import FAMILIES, Pool, cross, defined, dot, norm2, t
from judged_claims import Seen, compared, judged, kind_of
from one_fault import FALSE, TRUE, UNDER, Stating
from tally import told, wrong
from written_documents import Document, Shown, Step, documents

A, B = leaf("a", "vector"), leaf("b", "vector")
R = leaf("R", "matrix")


@pytest.mark.parametrize("family", [*FAMILIES, "condition"])
def test_identities_hold_and_faults_are_seen(family: str) -> None:
    stating = Stating(Random(family))
    for _ in range(12):
        assert FALSE not in stating.stated(family, share_of_false=0).truths
    truths = [each for _ in range(12) for each in stating.stated(family, share_of_false=1).truths]
    assert truths.count(FALSE) >= 6


@pytest.mark.parametrize(
    ("left", "right", "true"),
    [
        (cross(A, B), -cross(B, A), True),
        (cross(A, B), cross(B, A), False),
        (R * t(R), unit((3, 3)), True),
        (R * t(R), unit((4, 4)), False),
        (R - R, zero("matrix", (3, 1)), False),
        (R - R, zero("matrix"), True),
        (dot(A, A), norm2(A), True),
        (dot(A, A), number(1), False),
    ],
)
def test_truth_of_known_formulas(left: object, right: object, true: bool) -> None:
    point = Pool(Random(1)).point()
    defined(point)
    assert holds(left, right, point) is true


def test_conditions_matter() -> None:
    stating = Stating(Random(5))
    made = [stating.stated("condition", share_of_false=0) for _ in range(20)]
    assert all(each.condition is not None and each.truths[-1] == UNDER for each in made)
    assert all(FALSE in stating.without_its_condition().truths for _ in range(20))


def test_products_are_written_in_brackets() -> None:
    f, g = leaf("f", "scalar"), leaf("g", "scalar")
    writer = Writer()
    assert writer.write((f + g) * dot(A, B)).plain == r"(f + g) (a \cdot b)"
    assert writer.write(2 * dot(A, B) - cross(A, B)).plain == r"2 a \cdot b - a \times b"
    assert writer.write(t(A + B) * (f * g)).plain == "(a + b)^T (f g)"


STEP, OTHER = Step("f g", "g f", TRUE, "scalars"), Step("f", "g + h", FALSE, "scalars", 1)


@pytest.mark.parametrize(
    ("claims", "kinds"),
    [
        ([("f g = g f", "proved"), ("f = g + h", "refuted")], ["proved", "refuted"]),
        ([("f g = g f", "refuted"), ("f = g + h", "proved")], ["false alarm", "false proof"]),
        ([("f g = g f", "unchecked"), ("f = g + h", "conditional")], ["silent", "excused"]),
        ([("f g = g f", "proved"), ("f = g", "proved")], ["proved", "invented", "false proof", "vanished"]),
        (
            [("f g = g f f", "refuted"), ("f = g + h", "refuted")],
            ["refuted", "invented", "false alarm", "vanished"],
        ),
        ([("f g = g f", "proved")], ["proved", "vanished"]),
    ],
)
def test_wrong_verdicts_are_detected(claims: list[tuple[str, str]], kinds: list[str]) -> None:
    display = Shown("d0x", "align", "", [STEP, OTHER], [])
    seen = [Seen(f"d0xa.{at}", latex, outcome, "", 1) for at, (latex, outcome) in enumerate(claims)]
    assert [kind for kind, _, _ in compared(display, seen)] == kinds


@pytest.mark.parametrize(
    ("reason", "kind"),
    [
        ("holds by $f = g$", "false proof"),
        ("holds by $f = g$ (d0xa)", "false proof"),
        ("holds by $h = g$ (d7xa.2)", "excused"),
    ],
)
def test_false_formula_with_a_condition_rests_on_another_display(reason: str, kind: str) -> None:
    step = replace(OTHER, beside="f = g")
    assert kind_of(step, Seen("d0xa", "f = g + h", "conditional", reason, 1)) == kind


def test_verdicts_on_unprinted_formulas_are_reported() -> None:
    display = Shown("d0x", "equation", "", [OTHER], [], printed=False)
    assert [kind for kind, *_ in compared(display, [Seen("d0xa", "f = g + h", "refuted", "", 1)])] == [
        "invented"
    ]


def test_documents_have_all_formats_and_truths() -> None:
    made = documents(seed=3, formulas=240, each=30)
    assert {each.format for each in made} == {"tex", "md", "rst", "ipynb", "html"}
    truths = [step.truth for one in made for shown in one.shown for step in shown.steps]
    assert {TRUE, FALSE, UNDER} <= set(truths)
    assert {shown.layout for one in made for shown in one.shown} > {"multline", "array rcrcl", "pairs"}


def _assert_right(made: list[Document]) -> None:
    results = [judged(each) for each in made]
    assert not [one.broken for one in results if one.broken]
    faults = wrong(results)
    assert not faults, f"{len(faults)} wrong findings\n" + "\n\n".join(map(told, faults[:10]))


def test_no_formula_of_a_few_texts_is_judged_wrongly() -> None:
    _assert_right(documents(seed=1, formulas=40, each=20))


@pytest.mark.slow
def test_no_formula_of_many_texts_is_judged_wrongly() -> None:
    seed = int.from_bytes(os.urandom(2), "big")
    print(f"seed {seed}")
    _assert_right(documents(seed, formulas=5000))


def test_renaming_keeps_transposes_and_derivatives() -> None:
    taken = {"T": "J", "d": "w", "a": r"\hat{e}"}
    line = r"\begin{align} T^T a &= \frac{d}{dt}(d) \label{d1xa}"
    assert in_formula(line, taken) == r"\begin{align} J^T \hat{e} &= \frac{d}{dt}(w) \label{d1xa}"
