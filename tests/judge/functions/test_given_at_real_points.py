"""Claims under equations that assign values: refuted at points with the real sines of their angles."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome

SCALARS = ("x", "y", "u", "w", r"\phi", r"\alpha", r"\beta", r"\gamma", "v", r"\omega")
LENGTH = {"kind": "scalar", "constant": True, "positive": True}
SYMBOLS = dict.fromkeys(SCALARS, "scalar") | dict.fromkeys(("h", "a", "b", "l"), LENGTH) | {"r": "vector"}
UNICYCLE = (r"\dot{x} = v \cos\phi", r"\dot{y} = v \sin\phi", r"\dot{\phi} = \omega")
ON_AXIS = (r"\dot{r} = v \begin{bmatrix} \cos\phi \\ \sin\phi \\ 0 \end{bmatrix}", r"\dot{\phi} = \omega")

#: Premises, what follows from them, and what does not.
RATES = [
    (UNICYCLE, r"\phi \dot{x} = \phi v \cos\phi", r"\phi \dot{x} = \phi v \sin\phi"),
    (
        UNICYCLE,
        r"y + h \dot{y} + \phi \dot{x} = y + h v \sin\phi + \phi v \cos\phi",
        r"y + h \dot{y} + \phi \dot{x} = y + v \sin\phi + \phi v \cos\phi",
    ),
    (
        UNICYCLE,
        r"(x + h \dot{x}, \phi + h \dot{\phi}) = (x + h v \cos\phi, \phi + h \omega)",
        r"(x + h \dot{x}, \phi + h \dot{\phi}) = (x + h v \sin\phi, \phi + h \omega)",
    ),
    (
        ON_AXIS,
        r"h \dot{r} + \phi \dot{r} = (h + \phi) v \begin{bmatrix} \cos\phi \\ \sin\phi \\ 0 \end{bmatrix}",
        r"h \dot{r} + \phi \dot{r} = (h + \phi) v \begin{bmatrix} \sin\phi \\ \cos\phi \\ 0 \end{bmatrix}",
    ),
    (("u = w \\phi", "w = \\sin\\phi"), r"u = \phi \sin\phi", r"u = \phi \cos\phi"),
]

#: Of inverse functions: what may hold for other branches is not refuted.
ARCS = [
    (
        (r"u = \frac{l}{\tan\phi}", r"\alpha = \arctan(\frac{l}{u - a})"),
        r"\phi = \arctan(\frac{l \tan\alpha}{l + a \tan\alpha})",
        r"\phi = \arctan(\frac{l \tan\alpha}{l - a \tan\alpha})",
    ),
    ((r"\beta = \pi - \alpha",), r"\beta = \arcsin(\sin\alpha)", r"\beta = \arcsin(\frac{1}{2} \sin\alpha)"),
    ((r"\beta = \alpha + \pi",), r"\beta = \arctan(\tan\alpha)", r"\beta = \arctan(2 \tan\alpha)"),
]


@pytest.mark.parametrize(("premises", "true", "false"), RATES)
def test_rates_that_are_assigned(premises: tuple[str, ...], true: str, false: str) -> None:
    for assume in (premises, premises[::-1]):
        assert check(true, symbols=SYMBOLS, assume=assume).outcome is not Outcome.REFUTED
        assert check(false, symbols=SYMBOLS, assume=assume).outcome is Outcome.REFUTED


@pytest.mark.parametrize(("premises", "true", "false"), ARCS)
def test_inverse_functions_of_assigned_symbols(premises: tuple[str, ...], true: str, false: str) -> None:
    for assume in (premises, premises[::-1]):
        assert check(true, symbols=SYMBOLS, assume=assume).outcome is not Outcome.REFUTED
        assert check(false, symbols=SYMBOLS, assume=assume).outcome is Outcome.REFUTED
