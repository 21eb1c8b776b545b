"""Counterexamples for readers: nonzero values in the formula's letters, each formatted by its kind."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from workbench.core.types import QUATERNION, Type, type_of_kind
from workbench.core.verdict import Counterexample, Outcome
from workbench.language.grammar.latex_keys import Ignored, latex_key
from workbench.prover.results.claim_results import ClaimResult
from workbench.report.mixed_prose import Run, formula, text

_LETTER = re.compile(
    r"\\(?!dot|ddot|dddot|ddddot|tilde|underline|mathbf|boldsymbol|mathrm|left|right|cos|sin)[A-Za-z]+"
)
_RATIONAL = re.compile(r"-?\d+(/[1-9]\d*)?")
#: Types that have no name of a kind.
_UNDECLARED = {str(each): each for each in (QUATERNION, Type(1, 3))}
_RELATION = re.compile(r":?=|\\equiv(?![A-Za-z])|\\triangleq(?![A-Za-z])")
#: The most components of a defined symbol's value that is shown: those of a dual vector.
_SMALL = 6


@dataclass(frozen=True)
class Against:
    """A counterexample as shown.

    Attributes:
        values: (symbol, value) of nonzero symbols.
        rest: Whether other symbols are 0.
        formula: Our formula, if what is printed is none.
        defined: (symbol, value) of defined symbols.
    """

    formula: str | None
    values: tuple[tuple[str, str], ...]
    rest: bool
    defined: tuple[tuple[str, str], ...]
    left: str
    right: str

    @property
    def sentence(self) -> list[Run]:
        """The counterexample in words: with ω = (0, 1, 0), all else 0: the left side is 2, the right side
        -2."""
        runs = _listed(self.values)
        if self.rest:
            runs.append(text(", all else 0" if self.values else "all symbols 0"))
        if self.defined:
            runs += [text(", so that " if runs else ""), *_listed(self.defined)]
        sides = f"the left side is {self.left}, the right side {self.right}"
        return [text("with "), *runs, text(f": {sides}")] if runs else [text(sides)]

    def __str__(self) -> str:
        return "".join(run.content for run in self.sentence)


def _listed(values: Sequence[tuple[str, str]]) -> list[Run]:
    runs: list[Run] = []
    for name, value in values:
        runs += [text(", ")] if runs else []
        runs += [formula(name), text(f" = {value}")]
    return runs


def against(result: ClaimResult) -> Against | None:
    """Returns the counterexample of a result; None without one, or if only a hypothesis is missing."""
    example, claim = result.counterexample, result.claim
    if example is None or result.verdict.outcome is Outcome.CONDITIONAL:
        return None
    ours = claim.our_formula or (claim.proof.goal.latex if claim.proof.goal else None)
    said = ours or claim.shown or ""
    found = told(example, said)
    return replace(found, formula=ours)


def told(example: Counterexample, said: str = "") -> Against:
    """Returns the nonzero values, in the letters of the formula `said`, and the two sides."""
    sides = (example.left, example.right)
    small = {name: entries for name, entries in example.defined.items() if len(entries) <= _SMALL}
    shown_sides = {_bare(side) for side in _RELATION.split(said)}
    defined = {
        name: entries
        for name, entries in small.items()
        if entries not in sides or _bare(name) not in shown_sides
    }
    behind = example.behind if defined else ()
    values = {name: entries for name, entries in example.values.items() if name not in behind}

    def shown(of: Mapping[str, tuple[str, ...]]) -> tuple[tuple[str, str], ...]:
        return tuple(
            (as_printed(name, said), value_as_text(entries, example.kinds.get(name, "")))
            for name, entries in of.items()
            if not _are_zero(entries)
        )

    left, right = sides_as_text(example)
    shown_values, shown_defined = shown(values), shown(defined)
    rest = len(shown_values) < len(values) or (not values and len(shown_defined) < len(defined))
    return Against(None, shown_values, rest, shown_defined, left, right)


def _bare(latex: str) -> str:
    """Returns a side or a name without braces, blanks and marks of alignment and punctuation."""
    return latex_key(latex, Ignored.BRACES | Ignored.GAPS | Ignored.ALIGNMENT).strip(".,;")


def as_printed(name: str, said: str) -> str:
    """Returns the name with its letter in the typeface of the formula: bold if it occurs in bold only."""
    for letter in _LETTER.findall(name):
        for style in (r"\boldsymbol", r"\mathbf"):
            bold = f"{style}{{{letter}}}"
            is_bare = re.search(re.escape(letter) + r"(?![A-Za-z])", said.replace(bold, ""))
            if bold in said and not is_bare and bold not in name:
                replacement = bold.replace("\\", r"\\")
                return re.sub(re.escape(letter) + r"(?![A-Za-z])", replacement, name, count=1)
    return name


def value_as_text(entries: Sequence[str], kind: str = "") -> str:
    """Returns a value of a kind (as `str(Type)`) as text.

    Examples: (1, 2, 3), a matrix by rows as ((1, 2), (3, 4)), a quaternion as its scalar and its vector (1,
    (2, 3, 4)), a dual value as 1 + ε 2. Several entries of an unknown kind are a column.
    """
    type_ = _type_of(kind, entries)
    if not type_.dual:
        return _part(entries, type_)
    half = len(entries) // 2
    real, dual = entries[:half], entries[half:]
    if _are_zero(dual):
        return _part(real, type_)
    sign, size = _signed(dual, type_)
    if _are_zero(real):
        return f"{sign.strip('+ ')}{size}"
    return f"{_part(real, type_)} {sign} {size}"


def sides_as_text(example: Counterexample) -> tuple[str, str]:
    return value_as_text(example.left, example.kind), value_as_text(example.right, example.kind)


def _type_of(kind: str, entries: Sequence[str]) -> Type:
    """Returns the type of the kind; a column for an unknown kind, or if the number of entries differs."""
    plain = kind.removeprefix("dual ")
    found = _UNDECLARED.get(plain) or type_of_kind(plain)
    size = 0 if found is None else found.rows * found.columns
    if found is None or len(entries) not in (size, 2 * size * (plain != kind)):
        return Type(len(entries), 1)
    return found.with_dual(len(entries) > size)


def _signed(dual: Sequence[str], type_: Type) -> tuple[str, str]:
    """Returns the sign of the dual part, and ε times its absolute value."""
    if len(dual) > 1 or not _RATIONAL.fullmatch(dual[0]):
        return "+", f"ε {_part(dual, type_)}"
    sign, size = ("-", dual[0][1:]) if dual[0].startswith("-") else ("+", dual[0])
    return sign, "ε" if size == "1" else f"ε {size}"


def _part(entries: Sequence[str], type_: Type) -> str:
    """Returns the real or the dual part of a value."""
    if len(entries) == 1:
        return entries[0]
    if type_.algebra == "quaternion":
        return f"({entries[0]}, ({', '.join(entries[1:])}))"
    rows = [entries[at : at + type_.columns] for at in range(0, len(entries), type_.columns)]
    told = [row[0] if len(row) == 1 else f"({', '.join(row)})" for row in rows]
    return f"({', '.join(told)})"


def _are_zero(entries: Sequence[str]) -> bool:
    return all(_RATIONAL.fullmatch(entry) and Fraction(entry) == 0 for entry in entries)
