"""An equation that is given holds always: what the claim differentiates of it is a premise, too."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome, Verdict
from workbench.papers import load_paper

MODEL = r"""source = "p.md"
[symbols]
'x' = "vector"
'y' = "vector"
'w' = "vector"
'f' = "vector"
[[claim]]
at = "line 3"
given = ["line 1", "line 2"]
"""


def verdict(folder: Path, *formulas: str) -> Verdict:
    return verdicts(folder, "\n".join(f"$$ {each} $$" for each in formulas), MODEL)[-1]


@pytest.mark.parametrize(
    ("first", "second", "claim", "expected"),
    [
        (r"\dot{x} = w \times y", r"\ddot{x} = f", r"f = \dot{w} \times y + w \times \dot{y}", "proved"),
        (
            r"\dot{x} = w \times y",
            r"\ddot{x} = f",
            r"f \cdot f = 2 \ddot{x} \cdot \ddot{x}",
            "refuted",
        ),
        (r"x = y + w", r"\ddot{w} = 0", r"\ddot{x} = \ddot{y}", "proved"),
        (r"x = y + w", r"\dot{w} = 0", r"\ddot{x} = \ddot{y}", "proved"),
        (r"x = y + w", r"\ddot{w} = 0", r"\dot{x} \cdot \dot{x} = \dot{y} \cdot \dot{y}", "refuted"),
        (r"x \cdot y = 1", r"\dot{y} = 0", r"\dot{x} \cdot y = 0", "proved"),
    ],
)
def test_its_derivatives_are_given(
    tmp_path: Path, first: str, second: str, claim: str, expected: str
) -> None:
    found = verdict(tmp_path, first, second, claim)
    assert found.outcome == expected
    assert any(each.method == "given" and first in each.figures["formula"] for each in found.evidence)


def test_open_claims_list_their_given_formulas(tmp_path: Path) -> None:
    found = verdict(tmp_path, r"\dot{x} = w", r"\dot{y} = w", r"\dot{f} = x")
    assert told(found) == "said"
    (given,) = (each for each in found.evidence if each.method == "given")
    assert given.figures == {"formula": r"\dot{x} = w, \dot{y} = w"}


def test_unneeded_given_formulas_are_not_listed(tmp_path: Path) -> None:
    found = verdict(tmp_path, r"\dot{x} = w", r"\dot{y} = w", r"x \times y = -y \times x")
    assert found.outcome == "proved" and all(each.method != "given" for each in found.evidence)


CANCELLED = """
source = "p.md"
[symbols]
m = { kind = "scalar", positive = true }
x = { kind = "scalar", free = true }
y = { kind = "scalar", free = true }
[[claim]]
at = "line 3"
"""


@pytest.mark.parametrize("premise", ["given = ['line 1']", "assume = ['m x = m y']"])
def test_a_positive_number_of_a_premise_is_not_0(tmp_path: Path, premise: str) -> None:
    """m x = m y and x = y was refuted at m = 0, since the claim does not speak of m."""
    given, follows = verdicts(tmp_path, "$$ m x = m y $$\n\n$$ x = y $$\n", CANCELLED + premise)
    assert follows.outcome is Outcome.PROVED
    assert told(given) == ("said" if "given" in premise else "refuted")


FUNCTIONS = """
source = "p.md"
[symbols]
q = { kind = "scalar", independent = true }
x = { kind = "scalar", independent = true }
k = { kind = "scalar", constant = true }
f = { kind = "scalar", of = ["q"] }
h = { kind = "scalar", of = ["q"] }
V = { kind = "scalar", of = ["x"] }
[[claim]]
at = "line 3"
given = ["line 1"]
"""


@pytest.mark.parametrize(
    ("given", "claim", "holds"),
    [
        (r"V = \frac{1}{2} k x^2", r"\frac{\partial V}{\partial x} = k x", True),
        (r"\frac{1}{2} k x^2 = V", r"\frac{d}{dt} \frac{\partial V}{\partial x} = k \dot{x}", True),
        (r"f = 0", r"\frac{\partial f}{\partial q} \dot{q} = 0", True),
        (r"f = 0", r"\frac{\partial f}{\partial q} = 0", False),
        (r"f = h", r"\frac{\partial f}{\partial q} = \frac{\partial h}{\partial q}", False),
        (r"x = f", r"\frac{\partial f}{\partial q} = 0", False),
        (r"f = q \dot{q}", r"\frac{\partial f}{\partial q} = \dot{q}", False),
        (r"\frac{d f}{d q} \dot{q} = \frac{d f}{d q} \frac{1}{h}", r"\frac{d^2 f}{d q^2} \dot{q}^2 = \frac{d^2 f}{d q^2} \frac{1}{h^2}", False),
    ],
)  # fmt: skip
def test_along_a_motion_it_holds_at_no_other_place(
    tmp_path: Path, given: str, claim: str, holds: bool
) -> None:
    """A constraint f(q) = 0 says nothing of ∂f/∂q; what says what f is, V = ½ k x², does."""
    (tmp_path / "p.md").write_text(f"$$ {given} $$\n\n$$ {claim} $$\n")
    (tmp_path / "p.toml").write_text(FUNCTIONS)
    *_, last = judge_paper(load_paper(tmp_path / "p.toml"))
    assert (last.verdict.outcome is Outcome.PROVED) == holds, last.verdict.reason


SPRING = r"""
source = "p.md"
[symbols]
m = { kind = "scalar", constant = true, positive = true }
k = { kind = "scalar", constant = true, positive = true }
x = "scalar"
E = "scalar"
"""


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"m \dot x \ddot x + k x \dot x = k x", "refuted"),
        (r"\ddot x = - \frac{2 k}{m} x", "refuted"),
        (r"\ddot x = - \frac{k}{m} x", "proved"),
        (r"\ddot x = - \frac{k}{m} x + E", "said"),  # it may say what E is
    ],
)
def test_given_formulas_exclude_other_excuses(tmp_path: Path, formula: str, expected: str) -> None:
    """Stated twice, a false equation was conditional on itself, and excused as saying what m is."""
    text = [r"m \ddot x = - k x", r"\ddot x = - \frac{3 k}{m} x", formula, formula]
    (tmp_path / "p.md").write_text("\n\n".join(f"$$ {each} $$" for each in text))
    given = (f"[[claim]]\nat = 'line {line}'\ngiven = ['line 1']\n" for line in (5, 7))
    (tmp_path / "p.toml").write_text(SPRING + "".join(given))
    *_, first, second = judge_paper(load_paper(tmp_path / "p.toml"))
    again = (
        "conditional" if expected == "said" else expected
    )  # a law that is stated again follows from itself
    assert (told(first.verdict), told(second.verdict)) == (expected, again)
