"""Formulas without symbols: each is proved or refuted as mpmath finds the numbers on both sides."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import NamedTuple

import mpmath
import pytest

from workbench import check
from workbench.context.claims import Notation
from workbench.context.read_formulas import read_statement
from workbench.core.verdict import EngineDisagreement, Outcome
from workbench.engines.jet import closed_values
from workbench.engines.polynomial import closed_numbers
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide import closed_formulas
from workbench.prover.decide.decide import Judge

PLAIN = SymbolTable.build({})


class Shown(NamedTuple):
    latex: str
    value: mpmath.mpf


def fraction(random: Random) -> tuple[int, int]:
    return random.randint(-5, 8), random.choice([1, 1, 2, 3, 4, 6])


def angle(random: Random) -> Shown:
    above, below = fraction(random)
    latex = rf"\frac{{{above} \pi}}{{{below}}}" if below > 1 else rf"{above} \pi"
    return Shown(latex, mpmath.mpf(above) * mpmath.pi / below)


def cosine(random: Random) -> Shown:
    of = angle(random)
    return Shown(rf"\cos({of.latex})", mpmath.cos(of.value))


def sine(random: Random) -> Shown:
    of = angle(random)
    return Shown(rf"\sin({of.latex})", mpmath.sin(of.value))


def number(random: Random) -> Shown:
    above, below = random.randint(0, 3), random.choice([1, 2, 4])
    return Shown(rf"\frac{{{above}}}{{{below}}}", mpmath.mpf(above) / below)


def root(random: Random) -> Shown:
    of = random.choice([2, 3, 4, 6, 8])
    return Shown(rf"\frac{{\sqrt{{{of}}}}}{{2}}", mpmath.sqrt(of) / 2)


def factorial(random: Random) -> Shown:
    n = random.randint(0, 4)
    return Shown(f"{n}!", mpmath.factorial(n))


def exponential(random: Random) -> Shown:
    return Shown(random.choice(["e^0", r"\exp(0)", r"\cosh 0"]), mpmath.mpf(1))


def trace(random: Random) -> Shown:
    n = random.randint(2, 4)
    return Shown(rf"\operatorname{{tr}} \mathbf{{I}}_{n}", mpmath.mpf(n))


def determinant(random: Random) -> Shown:
    a, b, c, d = (random.randint(-2, 2) for _ in range(4))
    return Shown(rf"\det \begin{{bmatrix}} {a} & {b} \\ {c} & {d} \end{{bmatrix}}", mpmath.mpf(a * d - b * c))


LEAVES: list[Callable[[Random], Shown]] = [
    cosine, sine, number, root, factorial, exponential, trace, determinant, cosine, sine,
]  # fmt: skip


def expression(random: Random, depth: int) -> Shown:
    if not depth:
        return random.choice(LEAVES)(random)
    left, right = expression(random, depth - 1), random.choice(LEAVES)(random)
    match random.choice("+-*"):
        case "+":
            return Shown(f"{left.latex} + ({right.latex})", left.value + right.value)
        case "-":
            return Shown(f"{left.latex} - ({right.latex})", left.value - right.value)
    return Shown(rf"({left.latex}) \cdot ({right.latex})", left.value * right.value)


def is_true(left: Shown, right: Shown) -> bool:
    return abs(left.value - right.value) < mpmath.mpf("1e-30")


@pytest.mark.parametrize("seed", range(120))
def test_closed_formula_is_proved_or_refuted(seed: int) -> None:
    with mpmath.workdps(40):
        random = Random(seed)
        left = expression(random, seed % 3)
        others = (expression(random, random.randint(0, 1)) for _ in range(200))
        wants_truth = seed % 2 == 0  # most pairs differ, so true ones are looked for
        right = next((other for other in others if is_true(left, other) == wants_truth), left)
        truth = is_true(left, right)
    found = check(f"{left.latex} = {right.latex} + 0", {}).outcome
    assert found == (Outcome.PROVED if truth else Outcome.REFUTED), f"{left.latex} = {right.latex}"


def test_engines_that_differ_on_a_number_stop(monkeypatch: pytest.MonkeyPatch) -> None:
    (true,) = read(r"\cos\frac{\pi}{3} = \frac{1}{2}", PLAIN)
    monkeypatch.setitem(closed_values._FUNCTIONS, "cos", closed_values.sympy.sin)
    with pytest.raises(EngineDisagreement):
        closed_formulas.judge_closed(true, (), Definitions())


@pytest.mark.parametrize("order", [4, 8, 12, 20, 24, 28, 60])
def test_roots_of_numbers_lie_in_the_cyclotomic_field(order: int) -> None:
    field = closed_numbers.Cyclotomic(order)
    for square in (2, 3, 5, 6, 7, 10, 15):
        _, primes = closed_numbers.square_free(closed_numbers.Fraction(square))
        if order % (4 * closed_numbers.prod(primes)) == 0:
            own = field._root(closed_numbers.Fraction(square))
            assert (own * own - field.rational(closed_numbers.Fraction(square))).polynomial == 0


def test_one_engine_proves_no_closed_formula() -> None:
    notation = Notation(SymbolTable(), Definitions([]), {})
    statement, _ = read_statement(r"\cos\frac{\pi}{3} = \frac12", notation, None)
    assert Judge(notation.definitions).judge(statement).outcome is Outcome.PROVED
    alone = Judge(notation.definitions, second_engine=False).judge(statement)
    assert alone.outcome is Outcome.PROBABLE
