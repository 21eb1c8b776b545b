"""Inverse functions of symbols that assumed equations give: refuted where no branch makes them true."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome

SCALARS = ("x", "u", r"\phi", r"\theta", r"\alpha", r"\beta")
LENGTH = {"kind": "scalar", "constant": True, "positive": True}
SYMBOLS = dict.fromkeys(SCALARS, "scalar") | dict.fromkeys(("a", "l"), LENGTH)

#: Premises, what may follow from them, and what does not.
ARCS = [
    (
        (r"u = \frac{l}{\tan\phi}", r"\alpha = \arctan(\frac{l}{u - a})"),
        r"\phi = \arctan(\frac{l \tan\alpha}{l + a \tan\alpha})",
        r"\phi = \arctan(\frac{l \tan\alpha}{l - a \tan\alpha})",
    ),
    (
        (r"\theta = \pi",),
        r"\frac{\theta}{3} = \arccos(\frac{1}{2})",
        r"\frac{\theta}{5} = \arccos(\frac{1}{2})",
    ),
    ((r"\beta = \pi - \alpha",), r"\beta = \arcsin(\sin\alpha)", r"\beta = \arcsin(\frac{1}{2} \sin\alpha)"),
    ((r"\beta = \alpha + \pi",), r"\beta = \arctan(\tan\alpha)", r"\beta = \arctan(2 \tan\alpha)"),
]


@pytest.mark.parametrize(("premises", "true", "false"), ARCS)
def test_inverse_functions_of_assigned_symbols(premises: tuple[str, ...], true: str, false: str) -> None:
    for assume in (premises, premises[::-1]):
        assert check(true, symbols=SYMBOLS, assume=assume).outcome is not Outcome.REFUTED
        assert check(false, symbols=SYMBOLS, assume=assume).outcome is Outcome.REFUTED


def test_a_formula_that_is_true_at_a_given_angle_is_not_refuted() -> None:
    true = check(r"x \cos(\frac{\theta}{3}) = \frac{x}{2}", symbols=SYMBOLS, assume=[r"\theta = \pi"])
    assert true.outcome is not Outcome.REFUTED
