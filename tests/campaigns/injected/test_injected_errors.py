"""The campaign of injected misprints: what each kind changes, and what is said of a few; the whole with --slow."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from injected_errors import (
    FALSE_PROOF,
    FOUND,
    STILL_TRUE,
    changed_forms,
    injected,
    proved_claims,
    sample,
)

from workbench import check
from workbench.context.claims import Claim

SYMBOLS = {
    "a": "vector",
    "b": "vector",
    "R": "rotation",
    r"\theta": "scalar",
    "x_1": "scalar",
    "x_2": "scalar",
}


def claim(latex: str) -> Claim:
    return check(latex, SYMBOLS).result.claim


@pytest.mark.parametrize(
    ("kind", "latex", "changed"),
    [
        ("sign or operator", r"a + b = b + a", [r"-a + b = b + a", r"a - b = b + a"]),
        ("sign or operator", r"a \times b = -b \times a", [r"a \cdot b = -b \times a"]),
        ("index", r"x_1 + x_2 = x_2 + x_1", [r"x_{2} + x_{2} = x_{2} + x_{1}"]),
        ("number", r"2 x_1 = x_1 + x_1", [r"3 x_{1} = x_{1} + x_{1}"]),
        ("symbol", r"a \times b = -b \times a", [r"b \times b = -b \times a"]),
        ("transpose", r"R^T R a = a", [r"R R a = a"]),
        ("inverse", r"R^{-1} R a = a", [r"R R a = a"]),
        ("order of factors", r"R^T a = R^{-1} a", [r"a R^{T} = R^{-1} a"]),
        ("dot", r"\frac{d}{dt} (a + b) = \dot{a} + \dot{b}", [r"\frac{d}{d t} (a + b) = a + \dot{b}"]),
        (
            "sin or cos",
            r"\sin 2\theta = 2 \sin\theta \cos\theta",
            [r"\cos 2 \theta = 2 \sin \theta \cos \theta"],
        ),
    ],
)
def test_misprints_of_a_kind_change_one_thing(kind: str, latex: str, changed: list[str]) -> None:
    forms = [form.replace(" ", "") for form in changed_forms(claim(latex), kind)]
    assert all(form.replace(" ", "") in forms for form in changed), forms


@pytest.mark.parametrize(
    ("latex", "changed", "result", "corrected"),
    [
        (r"a \times b = -b \times a", r"a \times b = b \times a", FOUND, True),
        (r"R^T R a = a", r"R R a = a", FOUND, True),
        (r"a \cdot b = b \cdot a", r"a \cdot b = a \cdot b + 0", STILL_TRUE, False),
        (r"a + b = b + a", r"a + b = b + x_1", FOUND, True),
    ],
)
def test_result_of_a_misprint(latex: str, changed: str, result: str, corrected: bool) -> None:
    row = injected("test", claim(latex), "test", changed, seconds=30.0)
    assert row is not None and row.result == result
    assert row.corrected is corrected


@pytest.mark.slow
def test_misprints_in_corrected_errata_are_found() -> None:
    chosen = sample(Random(39), list(proved_claims(["errata"])), 120)
    rows = [row for each in chosen if (row := injected(*each, 0.0)) is not None]
    false = [row for row in rows if row.result != STILL_TRUE]
    assert not any(row.result == FALSE_PROOF for row in rows)
    assert sum(row.result == FOUND for row in false) >= 0.9 * len(false)
