"""A counterexample as readers see it: what is not 0, in the formula's letters, matrices as matrices."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from workbench.judge.verdict import Outcome
from workbench.report.prose import Run, formula, text
from workbench.verify.results import ClaimResult

_LETTER = re.compile(
    r"\\(?!dot|ddot|dddot|ddddot|tilde|underline|mathbf|boldsymbol|mathrm|left|right|cos|sin)[A-Za-z]+"
)
_RATIONAL = re.compile(r"-?\d+(/[1-9]\d*)?")
#: Components of the largest value that is told of a defined symbol: a dual vector.
_SMALL = 6


@dataclass(frozen=True)
class Against:
    """values: symbol and value, those that are not 0.   rest: whether others are 0.   of: what is false.
    formula: ours, where what is printed is no formula.   defined: what definitions make of the values."""

    of: str
    formula: Run | None
    values: tuple[tuple[Run, Run], ...]
    rest: bool
    defined: tuple[tuple[Run, Run], ...]
    left: Run
    right: Run


def against(result: ClaimResult) -> Against | None:
    """None where there is no counterexample, or one against what lacks a hypothesis only."""
    example, outcome, claim = result.counterexample, result.verdict.outcome, result.claim
    if example is None or outcome is Outcome.CONDITIONAL:
        return None
    small = {name: entries for name, entries in example.defined.items() if len(entries) <= _SMALL}
    sides = (example.left, example.right)
    defined = {name: value_of(entries) for name, entries in small.items() if entries not in sides}
    behind = example.behind if defined else ()
    values = {name: value_of(entries) for name, entries in example.values.items() if name not in behind}
    ours = claim.our_formula or (claim.goal.latex if claim.goal else None)
    shown, defined_shown = (_shown(of, ours or claim.shown or "") for of in (values, defined))
    return Against(
        of="as it was meant" if outcome is Outcome.ILL_FORMED else "as printed",
        formula=formula(ours) if ours else None,
        values=shown,
        rest=len(shown) < len(values) or (not shown and len(defined_shown) < len(defined)),
        defined=defined_shown,
        left=value_of(example.left).run,
        right=value_of(example.right).run,
    )


def _shown(values: Mapping[str, Value], said: str) -> tuple[tuple[Run, Run], ...]:
    return tuple(
        (formula(as_printed(name, said)), value.run) for name, value in values.items() if not value.is_zero
    )


def as_printed(name: str, said: str) -> str:
    """The name of a symbol in the type in which a formula sets its letter: bold, where it stands there in
    bold only."""
    for letter in _LETTER.findall(name):
        for style in (r"\boldsymbol", r"\mathbf"):
            bold = f"{style}{{{letter}}}"
            is_bare = re.search(re.escape(letter) + r"(?![A-Za-z])", said.replace(bold, ""))
            if bold in said and not is_bare and bold not in name:
                replacement = bold.replace("\\", r"\\")
                return re.sub(re.escape(letter) + r"(?![A-Za-z])", replacement, name, count=1)
    return name


@dataclass(frozen=True)
class Value:
    """A value of a counterexample. latex: laid out for pencil, None where an entry is no rational number."""

    plain: str
    latex: str | None
    is_zero: bool

    @property
    def run(self) -> Run:
        return text(self.plain) if self.latex is None else formula(self.latex)


def value_of(entries: Sequence[str]) -> Value:
    """A number, a vector, or a matrix by rows; a dual one (2, 6, 18 entries) as real part + ε dual part."""
    plain = ", ".join(entries)
    if not entries or not all(_RATIONAL.fullmatch(entry) for entry in entries):
        return Value(plain, None, is_zero=False)
    is_zero = all(Fraction(entry) == 0 for entry in entries)
    if len(entries) not in (2, 6, 18):
        return Value(plain, _laid_out(entries), is_zero)
    half = len(entries) // 2
    real, dual = entries[:half], entries[half:]
    if all(Fraction(entry) == 0 for entry in dual):
        return Value(plain, _laid_out(real), is_zero)
    sign, size = _signed(dual)
    if all(Fraction(entry) == 0 for entry in real):
        return Value(plain, f"{sign.strip('+ ')}{size}", is_zero)
    return Value(plain, f"{_laid_out(real)} {sign} {size}", is_zero)


def _signed(dual: Sequence[str]) -> tuple[str, str]:
    """The sign of the dual part behind the real one, and ε times the rest."""
    if len(dual) == 1 and dual[0] in ("1", "-1"):
        return ("-" if dual[0] == "-1" else "+"), r"\varepsilon"
    if len(dual) == 1 and dual[0].startswith("-"):
        return "-", rf"\varepsilon {_laid_out([dual[0][1:]])}"
    return "+", rf"\varepsilon {_laid_out(dual)}"


def _laid_out(entries: Sequence[str]) -> str:
    numbers = [_rational_latex(entry) for entry in entries]
    size = isqrt(len(numbers))
    if len(numbers) == 1:
        return numbers[0]
    if all(Fraction(entry) == 0 for entry in entries):
        return r"\mathbf{0}"
    columns = size if size > 2 and size * size == len(numbers) else 1  # four: a quaternion
    rows = [" & ".join(numbers[at : at + columns]) for at in range(0, len(numbers), columns)]
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"


def _rational_latex(number: str) -> str:
    sign, digits = ("-", number[1:]) if number.startswith("-") else ("", number)
    if "/" not in digits:
        return sign + digits
    numerator, denominator = digits.split("/")
    return rf"{sign}\frac{{{numerator}}}{{{denominator}}}"
