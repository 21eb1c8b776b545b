"""What a text says of a family, it says of each member in the stated range, and of no other."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, model, text_of
from workbench.core.verdict import Grade, Outcome

MODEL = model({"f": "scalar", "g": "scalar", "J_n": "scalar", "q_n": "scalar", "e_n": "vector"})
DEFINED, LAW = "J_n = f q_n", r"\dot{q}_n = f q_n"

#: What is said, what follows of a member or of another index, and the same with an error.
SAID = [
    (DEFINED, "g J_2 = g f q_2", "g J_2 = 2 g f q_2"),
    (DEFINED, "g J_n = g f q_n", "g J_n = 2 g f q_n"),
    (DEFINED, "g J_k = g f q_k", "g J_k = 2 g f q_k"),
    (DEFINED, "J_k + J_{k+1} = f (q_k + q_{k+1})", "J_k + J_{k+1} = f (q_k + q_k)"),
    (LAW, r"\ddot{q}_2 = \dot{f} q_2 + f^2 q_2", r"\ddot{q}_2 = \dot{f} q_2 + 2 f^2 q_2"),
    (LAW, r"\ddot{q}_k = \dot{f} q_k + f^2 q_k", r"\ddot{q}_k = \dot{f} q_k + 2 f^2 q_k"),
]


@pytest.mark.parametrize(("said", "right", "wrong"), SAID)
def test_fact_about_a_family_decides_about_members(tmp_path: Path, said: str, right: str, wrong: str) -> None:
    *_, follows, false = judged(tmp_path, text_of([said, right, wrong]), MODEL)
    assert (follows.outcome, follows.grade) == (Outcome.CONDITIONAL, Grade.OK)
    assert (false.outcome, false.grade) == (Outcome.REFUTED, Grade.ERROR)


@pytest.mark.parametrize(("said", "right"), [each[:2] for each in SAID if "_n" not in each[1]])
def test_fact_decides_in_its_range_only(tmp_path: Path, said: str, right: str) -> None:
    claim = right + r", \quad k = 1, \dots, 3" * ("_k" in right)
    *_, inside = judged(tmp_path, text_of([said + r", \quad n = 1, \dots, 7", claim]), MODEL)
    assert (inside.outcome, inside.grade) == (Outcome.CONDITIONAL, Grade.OK)
    for elsewhere in (r"n \geq 5", r"n = 5, \dots, 7", "n = 5, 6, 7"):
        *_, outside = judged(tmp_path, text_of([rf"{said}, \quad {elsewhere}", claim]), MODEL)
        assert outside.outcome is not Outcome.CONDITIONAL


def test_number_for_a_sum_over_a_family_ends_in_no_error(tmp_path: Path) -> None:
    tables = MODEL + '\n[definitions]\ns = "J_1 + q_6"\n'
    *_, value = judged(tmp_path, text_of([DEFINED, "s = 4"]), tables.replace('e_n"', 's" = "scalar"\n"e_n"'))
    assert value.grade is not Grade.OK


@pytest.mark.parametrize("said", [r"V = f q_n + g J_n", r"V = q_n + \frac{J_n}{g}"])
@pytest.mark.parametrize("letter", ["n", "m"])
def test_index_that_only_the_body_holds_is_that_of_the_claim(tmp_path: Path, said: str, letter: str) -> None:
    right = said.removeprefix("V = ").replace("_n", f"_{letter}")
    said, kinds = said.replace("_n", f"_{letter}"), MODEL.replace("_n", f"_{letter}") + 'V = "scalar"\n'
    first, rest = right.split(" + ")
    *_, follows, false = judged(
        tmp_path, text_of([said, f"{first} = V - {rest}", f"{first} = V + {rest}"]), kinds
    )
    assert follows.outcome is not Outcome.REFUTED
    assert false.outcome is Outcome.REFUTED or false.grade is not Grade.OK


def test_symbols_under_an_index_define_no_circle(tmp_path: Path) -> None:
    kinds = model({"V": "scalar", "f": "scalar", "g": "scalar", "i_m": "scalar", "w_m": "scalar"})
    solved = [
        r"V = f i_m + \frac{w_m}{g}",
        r"f i_m = V - \frac{w_m}{g}",
        r"i_m = \frac{V}{f} - \frac{w_m}{f g}",
    ]
    for wrong in ("", "2"):
        *_, last = judged(tmp_path, text_of([*solved, rf"V = f i_m + {wrong} \frac{{w_m}}{{g}}"]), kinds)
        assert (last.outcome is Outcome.REFUTED) <= bool(wrong)
