"""A counterexample as readers see it: what is not 0, in the formula's letters, each value by its kind."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from workbench.judge.verdict import Counterexample, Outcome
from workbench.language.typed.types import QUATERNION, Type, type_of_kind
from workbench.report.prose import Run, formula, text
from workbench.verify.results import ClaimResult

_LETTER = re.compile(
    r"\\(?!dot|ddot|dddot|ddddot|tilde|underline|mathbf|boldsymbol|mathrm|left|right|cos|sin)[A-Za-z]+"
)
_RATIONAL = re.compile(r"-?\d+(/[1-9]\d*)?")
#: What no declaration calls so.
_UNDECLARED = {str(each): each for each in (QUATERNION, Type(1, 3))}
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
    kind_of = example.kinds.get
    defined = {
        name: value_of(entries, kind_of(name, "")) for name, entries in small.items() if entries not in sides
    }
    behind = example.behind if defined else ()
    values = {
        name: value_of(entries, kind_of(name, ""))
        for name, entries in example.values.items()
        if name not in behind
    }
    ours = claim.our_formula or (claim.goal.latex if claim.goal else None)
    shown, defined_shown = (_shown(of, ours or claim.shown or "") for of in (values, defined))
    return Against(
        of="as it was meant" if outcome is Outcome.ILL_FORMED else "as printed",
        formula=formula(ours) if ours else None,
        values=shown,
        rest=len(shown) < len(values) or (not shown and len(defined_shown) < len(defined)),
        defined=defined_shown,
        left=value_of(example.left, example.kind).run,
        right=value_of(example.right, example.kind).run,
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


def value_of(entries: Sequence[str], kind: str = "") -> Value:
    """A value of a kind, as `str(Type)` has it. Of an unknown kind more than one entry are a column."""
    if not entries or not all(_RATIONAL.fullmatch(entry) for entry in entries):
        return Value(value_as_text(entries, kind), None, is_zero=False)
    is_zero = all(Fraction(entry) == 0 for entry in entries)
    return Value(value_as_text(entries, kind), _Latex(_type_of(kind, entries)).whole(entries), is_zero)


def value_as_text(entries: Sequence[str], kind: str = "") -> str:
    """The same as text: (1, 2, 3), a matrix by rows as ((1, 2), (3, 4)), a quaternion as its scalar and its
    vector (1, (2, 3, 4)), a dual value as 1 + ε 2."""
    return _Plain(_type_of(kind, entries)).whole(entries)


def values_as_text(example: Counterexample) -> dict[str, str]:
    """The values of the symbols as text."""
    return {name: value_as_text(each, example.kinds.get(name, "")) for name, each in example.values.items()}


def sides_as_text(example: Counterexample) -> tuple[str, str]:
    return value_as_text(example.left, example.kind), value_as_text(example.right, example.kind)


def _type_of(kind: str, entries: Sequence[str]) -> Type:
    """The type of the kind; that of a column where there is none, or where it has not so many entries, as a
    value that is undefined."""
    plain = kind.removeprefix("dual ")
    found = _UNDECLARED.get(plain) or type_of_kind(plain)
    size = 0 if found is None else found.rows * found.columns
    if found is None or len(entries) not in (size, 2 * size * (plain != kind)):
        return Type(len(entries), 1)
    return found.with_dual(len(entries) > size)


@dataclass(frozen=True)
class _Plain:
    """Values of a type as text."""

    type: Type
    unit = "ε"

    def whole(self, entries: Sequence[str]) -> str:
        """Of a dual value no part that is 0."""
        if not self.type.dual:
            return self.part(entries)
        half = len(entries) // 2
        real, dual = entries[:half], entries[half:]
        if _are_zero(dual):
            return self.part(real)
        sign, size = self._signed(dual)
        if _are_zero(real):
            return f"{sign.strip('+ ')}{size}"
        return f"{self.part(real)} {sign} {size}"

    def _signed(self, dual: Sequence[str]) -> tuple[str, str]:
        """The sign of the dual part behind the real one, and ε times the rest."""
        if len(dual) > 1 or not _RATIONAL.fullmatch(dual[0]):
            return "+", f"{self.unit} {self.part(dual)}"
        sign, size = ("-", dual[0][1:]) if dual[0].startswith("-") else ("+", dual[0])
        return sign, self.unit if size == "1" else f"{self.unit} {self.part([size])}"

    def part(self, entries: Sequence[str]) -> str:
        """Of the real or the dual part."""
        numbers = [self.number(entry) for entry in entries]
        if len(numbers) == 1:
            return numbers[0]
        if self.type.algebra == "quaternion":
            return self.pair(numbers[0], self.matrix([[number] for number in numbers[1:]]))
        columns = self.type.columns
        return self.matrix([numbers[at : at + columns] for at in range(0, len(numbers), columns)])

    def number(self, entry: str) -> str:
        return entry

    def pair(self, scalar: str, vector: str) -> str:
        return f"({scalar}, {vector})"

    def matrix(self, rows: Sequence[Sequence[str]]) -> str:
        entries = [row[0] if len(row) == 1 else f"({', '.join(row)})" for row in rows]
        return f"({', '.join(entries)})"


@dataclass(frozen=True)
class _Latex(_Plain):
    """Values of a type laid out for pencil."""

    unit = r"\varepsilon"

    def part(self, entries: Sequence[str]) -> str:
        is_zero = len(entries) > 1 and _are_zero(entries) and self.type.algebra != "quaternion"
        return r"\mathbf{0}" if is_zero else super().part(entries)

    def number(self, entry: str) -> str:
        return _rational_latex(entry)

    def pair(self, scalar: str, vector: str) -> str:
        return rf"\left({scalar}, {vector}\right)"

    def matrix(self, rows: Sequence[Sequence[str]]) -> str:
        lines = r" \\ ".join(" & ".join(row) for row in rows)
        return rf"\begin{{bmatrix}} {lines} \end{{bmatrix}}"


def _are_zero(entries: Sequence[str]) -> bool:
    return all(_RATIONAL.fullmatch(entry) and Fraction(entry) == 0 for entry in entries)


def _rational_latex(number: str) -> str:
    sign, digits = ("-", number[1:]) if number.startswith("-") else ("", number)
    if "/" not in digits:
        return sign + digits
    numerator, denominator = digits.split("/")
    return rf"{sign}\frac{{{numerator}}}{{{denominator}}}"
