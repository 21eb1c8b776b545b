r"""The reader of goals: LaTeX to typed terms with quantifiers.

    \forall n \geq 1 : \exists! B \in L(V_3, V_3), b \in V_3 : \forall r \in V_3 : x^{(n)} = b + B x

`;` is a conjunction and binds least, then come `\Leftrightarrow` and `\Rightarrow`, then `\wedge`; `\Big( …
\Big)` groups. A quantifier extends as far to the right as possible. The reader of formulas reads the text
between these marks, with the bound letters declared by their sets:

    \mathbb{R}  V_3  L(V_3, V_3)  SO_3  S^2 (unit vectors)  A(D) (operators in D)  {A \to B} (maps)

underlined for dual ones. A letter of such a set is a constant; with `^\mathbb{R}` after the set, as in the
chapter's SO_3^ℝ, it is a function of time. An `\exists` holds at one instant, and so does a premise; the
premise of `\Longrightarrow` holds at all times. `a \geqslant b` compares two real scalars. `\forall k < n`
ranges over the integers k from 0 to n − 1.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from workbench.core.brackets import nesting, outside
from workbench.core.formula_errors import SpecError
from workbench.core.names import Name
from workbench.core.types import OPERATOR, SCALAR, TENSOR, VECTOR, Declaration, Type
from workbench.language.goals.goals import (
    All,
    AllBelow,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    GoalError,
    Iff,
    Implies,
    Scope,
    Variable,
)
from workbench.language.grammar.parser import parse
from workbench.language.naming.declarations import read_key
from workbench.language.naming.linear_indices import linear

_MARK = re.compile(
    r"\\(?:forall|exists!?|Rightarrow|Longrightarrow|Leftrightarrow|wedge|geqslant|Big\s*[()])(?![A-Za-z])"
    r"|\\.|[{};:]",
    re.DOTALL,
)
_QUANTIFIERS = ("\\forall", "\\exists", "\\exists!")
_FROM = re.compile(
    r"(?P<names>[A-Za-z](?:_\w|_\{\w+\})?(?:\s*,\s*[A-Za-z](?:_\w|_\{\w+\})?)*)\s*\\geq\s*(?P<least>\d+)"
)
_BELOW = re.compile(r"(?P<name>[A-Za-z])\s*<\s*(?P<bound>[^<]+)")


def read_goal(latex: str, scope: Scope) -> Goal:
    """Returns the goal. Raises GoalError, ReadError or IllFormedAt."""
    reader = _Reader(list(_pieces(latex)))
    goal = reader.goal(scope)
    if reader.pieces:
        raise GoalError(f"expected the end of the goal, got {reader.pieces[0]!r}")
    return goal


def _pieces(latex: str) -> Iterator[str]:
    """Yields the marks of a goal and the texts between them; marks in braces belong to the texts."""
    start = depth = 0
    for mark in _MARK.finditer(latex):
        text = mark[0]
        if text in "{}":
            depth += nesting(text)
        elif depth == 0 and (text in ";:" or text.rstrip("()! ") in _MARKS):
            if between := latex[start : mark.start()].strip():
                yield between
            yield re.sub(r"\s", "", text)
            start = mark.end()
    if rest := latex[start:].strip():
        yield rest


_MARKS = frozenset((
    "\\forall", "\\exists", "\\Rightarrow", "\\Longrightarrow", "\\Leftrightarrow", "\\wedge",
    "\\geqslant", "\\Big",
))  # fmt: skip


@dataclass
class _Reader:
    pieces: list[str]

    def goal(self, scope: Scope) -> Goal:
        parts = [self._quantified(scope)]
        while self._takes(";"):
            parts.append(self._quantified(scope))
        return parts[0] if len(parts) == 1 else Both(tuple(parts))

    def _quantified(self, scope: Scope) -> Goal:
        if not self.pieces or self.pieces[0] not in _QUANTIFIERS:
            return self._implication(scope)
        quantifier = self.pieces.pop(0)
        binder = self._next("what the quantifier binds").rstrip(", ")
        if not (self.pieces and self.pieces[0] in _QUANTIFIERS) and not self._takes(":"):
            raise GoalError(f"expected a colon behind {quantifier} {binder}")
        counted, below = _FROM.fullmatch(binder), _BELOW.fullmatch(binder)
        if (counted or below) and quantifier != "\\forall":
            raise GoalError(f"expected \\forall for the integers {binder}")
        if below:
            return self._below(below["name"], below["bound"], scope)
        if counted:
            names = [name.strip() for name in counted["names"].split(",")]
            least = int(counted["least"])
            for name in names:
                scope = scope.with_integer(name, least)
            goal = self._quantified(scope)
            for name in reversed(names):
                goal = AllFrom(name, least, goal)
            return goal
        variables = tuple(_variables(binder, scope, fresh=quantifier != "\\forall"))
        body = self._quantified(scope.with_variables(variables))
        if quantifier == "\\forall":
            return All(variables, body)
        return Exists(variables, body, unique=quantifier.endswith("!"))

    def _below(self, name: str, text: str, scope: Scope) -> Goal:
        bound = linear(parse(text).lines[0][0], list(scope.integers))
        if bound is None:
            raise GoalError(f"expected {name} to be less than an integer that is known, got {text}")
        if name in scope.integers:
            raise GoalError(f"{name} is bound twice")
        return AllBelow(name, 0, bound, self._quantified(scope.with_integer(name, 0)))

    def _implication(self, scope: Scope) -> Goal:
        left = self._conjunction(scope)
        if self._takes("\\Leftrightarrow"):
            return Iff(left, self._conjunction(scope))
        for arrow, lasting in (("\\Rightarrow", False), ("\\Longrightarrow", True)):
            if self._takes(arrow):
                return Implies(left, self._quantified(scope), lasting)
        return left

    def _conjunction(self, scope: Scope) -> Goal:
        parts = [self._unit(scope)]
        while self._takes("\\wedge"):
            parts.append(self._unit(scope))
        return parts[0] if len(parts) == 1 else Both(tuple(parts))

    def _unit(self, scope: Scope) -> Goal:
        if self._takes("\\Big("):
            goal = self.goal(scope)
            if not self._takes("\\Big)"):
                raise GoalError("expected \\Big)")
            return goal
        if self.pieces and self.pieces[0] in _QUANTIFIERS:
            return self._quantified(scope)
        latex = self._next("a formula")
        if self._takes("\\geqslant"):
            return AtLeast(scope.term(latex), scope.term(self._next("the smaller side")))
        return Atom(scope.statement(latex))

    def _takes(self, mark: str) -> bool:
        if self.pieces and self.pieces[0] == mark:
            self.pieces.pop(0)
            return True
        return False

    def _next(self, wanted: str) -> str:
        if not self.pieces or self.pieces[0].rstrip("()!") in _MARKS or self.pieces[0] in (";", ":"):
            raise GoalError(f"expected {wanted}, got {self.pieces[0] if self.pieces else 'nothing'}")
        return self.pieces.pop(0)


# The sets of quantifiers.

_SETS: dict[str, tuple[Type, str | None]] = {
    "R": (SCALAR, None),
    "V_3": (VECTOR, None),
    "L(V_3,V_3)": (TENSOR, None),
    "SO_3": (TENSOR, "rotation"),
    "S^2": (VECTOR, "unit"),
    "A(D)": (OPERATOR, None),
}
_STYLE = re.compile(r"\\(?:mathbf|mathbb|mathrm|mathcal|boldsymbol|operatorname)(?![A-Za-z])|[\s{}]|\\[,;: ]")


def _variables(binder: str, scope: Scope, fresh: bool) -> Iterator[Variable]:
    letters: list[str] = []
    for part in _split(binder):
        letter, sign, domain = part.partition("\\in ")
        letters.append(letter.strip())
        if sign:
            yield from (_variable(name, domain, scope, fresh) for name in letters)
            letters = []
    if letters:
        raise GoalError(f"expected a set behind {', '.join(letters)}, as in x \\in V_3")


def _split(binder: str) -> Iterator[str]:
    commas = [place for place in outside(binder, "({[", ")}]") if binder[place] == ","]
    yield from (binder[start + 1 : end] for start, end in pairwise([-1, *commas, len(binder)]))


def _variable(letter: str, domain: str, scope: Scope, fresh: bool) -> Variable:
    try:
        name, places = read_key(letter)
    except SpecError as error:
        raise GoalError(f"{letter}: {error}") from None
    if places:
        raise GoalError(
            f"{letter}: a bound letter has no index {places[0]}; write it with a prime or in bold"
        )
    source, arrow, target = domain.partition("\\to")
    if arrow:
        argument = _in_set(Name(name.base, of=("the argument", name)), source, False)
        value = _in_set(name, target, False)
        declaration = replace(value, name=replace(name, parameters=1), parameters=1)
        if name in scope.table.functions or name in scope.table.symbols:
            raise GoalError(f"{letter} is a symbol of the paper already")
        return Variable(declaration, argument)
    declaration = _in_set(name, domain, True)
    known = scope.table.symbols.get(name)
    if known is None:
        return Variable(declaration)
    if fresh or known.name in scope.table.defined.members:
        raise GoalError(f"{letter} is a symbol of the paper already")
    if (known.type, known.constant, known.rotation, known.unit) != (
        declaration.type,
        declaration.constant,
        declaration.rotation,
        declaration.unit,
    ):
        raise GoalError(f"{letter} is declared as another thing than a member of {domain.strip()}")
    return Variable(known)


def _in_set(name: Name, domain: str, timed: bool) -> Declaration:
    squeezed = _STYLE.sub("", domain)
    constant = not squeezed.endswith("^R")
    squeezed = squeezed.removesuffix("^R")
    dual = "\\underline" in squeezed
    found = _SETS.get(squeezed.replace("\\underline", ""))
    if found is None or (not timed and not constant):
        known = ", ".join(_SETS)
        raise GoalError(
            f"expected a set, one of {known}, with \\underline for dual ones, got {domain.strip()!r}"
        )
    type_, flag = found
    made = Declaration(name, type_.with_dual(dual))
    return made.with_flags(constant=constant and timed, unit=flag == "unit", rotation=flag == "rotation")
