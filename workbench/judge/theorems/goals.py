r"""Goals: statements with quantifiers, read from LaTeX to typed terms.

    \forall n \geq 1 : \exists! B \in L(V_3, V_3), b \in V_3 : \forall r \in V_3 : x^{(n)} = b + B x

`;` separates what holds together and binds least, then come `\Leftrightarrow` and `\Rightarrow`, then
`\wedge`; `\Big( … \Big)` groups. A quantifier reaches as far to the right as it can. What stands between
these marks is read by the reader of formulas, with the bound letters declared by their sets:

    \mathbb{R}  V_3  L(V_3, V_3)  SO_3  S^2 (unit vectors)  A(D) (operators in D)  {A \to B} (maps)

underlined for dual ones. A letter of one of them is a constant; with `^\mathbb{R}` behind it, as in the
chapter's SO_3^ℝ, a function of time. An `\exists` is about one instant, and so is a premise; with
`\Longrightarrow` what stands before it is supposed for all times. `a \geqslant b` compares two real scalars.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.language.declarations import read_key
from workbench.language.definitions import Definitions
from workbench.language.errors import ReadError, SpecError
from workbench.language.names import Name
from workbench.language.reader import read_formula, read_term
from workbench.language.symbols import SymbolTable
from workbench.language.terms import Conjunction, Relation, Statement, Term
from workbench.language.types import OPERATOR, SCALAR, TENSOR, VECTOR, Declaration, Type


class GoalError(ValueError):
    """A goal that cannot be read."""


@dataclass(frozen=True)
class Variable:
    """A bound letter: its declaration, and for a map the declaration of its argument."""

    declaration: Declaration
    argument: Declaration | None = None

    @property
    def name(self) -> Name:
        return self.declaration.name

    @property
    def letter(self) -> Name:
        """Its name, of a map without its argument."""
        return self.declaration.name.without_arguments()


@dataclass(frozen=True)
class Atom:
    """Equations and inequations without quantifiers: what the kernel judges."""

    statement: Statement


@dataclass(frozen=True)
class AtLeast:
    """left ≥ right, of real scalars."""

    left: Term
    right: Term


@dataclass(frozen=True)
class All:
    variables: tuple[Variable, ...]
    body: Goal


@dataclass(frozen=True)
class AllFrom:
    """For every integer from `least` on."""

    integer: str
    least: int
    body: Goal


@dataclass(frozen=True)
class Exists:
    variables: tuple[Variable, ...]
    body: Goal
    unique: bool


@dataclass(frozen=True)
class Implies:
    """`lasting`: the premise is supposed for all times, and not at one instant."""

    premise: Goal
    conclusion: Goal
    lasting: bool = False


@dataclass(frozen=True)
class Iff:
    left: Goal
    right: Goal


@dataclass(frozen=True)
class Both:
    parts: tuple[Goal, ...]


Goal = Atom | AtLeast | All | AllFrom | Exists | Implies | Iff | Both


@dataclass(frozen=True)
class Scope:
    """What formulas are read in: the symbols, their definitions, the integer variables (name → its least)."""

    table: SymbolTable
    definitions: Definitions
    integers: Mapping[str, int]

    def with_variables(self, variables: Sequence[Variable]) -> Scope:
        table = self.table
        for variable in variables:
            formals = () if variable.argument is None else (variable.argument,)
            table = table.with_symbol(variable.declaration, formals)
        return replace(self, table=table)

    def with_integer(self, name: str, least: int) -> Scope:
        return replace(self, integers={**self.integers, name: least})

    def term(self, latex: str) -> Term:
        """Raises ReadError or IllFormedAt."""
        return read_term(latex, self.table, self.integers)

    def statement(self, latex: str) -> Statement:
        """Raises ReadError or IllFormedAt; ReadError where the formula states another range than its goal."""
        reading = read_formula(latex, self.table, self.integers)
        for stated in reading.ranges:
            if not stated.lower.is_number or self.integers.get(stated.variable) != int(stated.lower):
                message = f"the formula states a range of {stated.variable} that its goal does not"
                raise ReadError(message, 1, 1)
        statements = reading.statements
        return statements[0] if len(statements) == 1 else Conjunction(statements)


_MARK = re.compile(
    r"\\(?:forall|exists!?|Rightarrow|Longrightarrow|Leftrightarrow|wedge|geqslant|Big\s*[()])(?![A-Za-z])"
    r"|\\.|[{};:]",
    re.DOTALL,
)
_QUANTIFIERS = ("\\forall", "\\exists", "\\exists!")
_FROM = re.compile(
    r"(?P<names>[A-Za-z](?:_\w|_\{\w+\})?(?:\s*,\s*[A-Za-z](?:_\w|_\{\w+\})?)*)\s*\\geq\s*(?P<least>\d+)"
)


def read_goal(latex: str, scope: Scope) -> Goal:
    """Raises GoalError, ReadError or IllFormedAt."""
    reader = _Reader(list(_pieces(latex)))
    goal = reader.goal(scope)
    if reader.pieces:
        raise GoalError(f"expected the end of the goal, got {reader.pieces[0]!r}")
    return goal


def _pieces(latex: str) -> Iterator[str]:
    """The marks of a goal and what stands between them; marks in braces belong to what stands there."""
    start = depth = 0
    for mark in _MARK.finditer(latex):
        text = mark[0]
        if text in "{}":
            depth += 1 if text == "{" else -1
        elif depth == 0 and (text in ";:" or text.rstrip("()! ") in _MARKS):
            if between := latex[start : mark.start()].strip():
                yield between
            yield re.sub(r"\s", "", text)
            start = mark.end()
    if rest := latex[start:].strip():
        yield rest


_MARKS = frozenset(
    [
        "\\forall",
        "\\exists",
        "\\Rightarrow",
        "\\Longrightarrow",
        "\\Leftrightarrow",
        "\\wedge",
        "\\geqslant",
        "\\Big",
    ]
)


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
        if counted := _FROM.fullmatch(binder):
            if quantifier != "\\forall":
                raise GoalError(f"expected \\forall for the integers {binder}")
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


# what a quantifier binds

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
    depth = start = 0
    for place, character in enumerate(binder):
        depth += (character in "({[") - (character in ")}]")
        if character == "," and depth == 0:
            yield binder[start:place]
            start = place + 1
    yield binder[start:]


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
    if fresh or known.name in scope.table.defined:
        raise GoalError(f"{letter} is a symbol of the paper already")
    if (known.type, known.constant, known.rotation, known.unit) != (
        declaration.type,
        declaration.constant,
        declaration.rotation,
        declaration.unit,
    ):
        raise GoalError(f"{letter} is declared as another thing than a member of {domain.strip()}")
    return Variable(known)


def _in_set(name: str, domain: str, timed: bool) -> Declaration:
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
    return Declaration(
        name,
        type_.with_dual(dual),
        constant=constant and timed,
        unit=flag == "unit",
        rotation=flag == "rotation",
    )


def atoms(goal: Goal) -> Iterator[Statement]:
    """The formulas that the goal is made of."""
    match goal:
        case Atom(statement):
            yield statement
        case All(body=body) | AllFrom(body=body) | Exists(body=body):
            yield from atoms(body)
        case Implies(premise, conclusion):
            yield from atoms(premise)
            yield from atoms(conclusion)
        case Iff(left, right):
            yield from atoms(left)
            yield from atoms(right)
        case Both(parts):
            for part in parts:
                yield from atoms(part)


def bound_integers(goal: Goal | None) -> set[str]:
    """The integers that the goal binds anywhere."""
    match goal:
        case AllFrom(integer, _, body):
            return {integer} | bound_integers(body)
        case All(body=body) | Exists(body=body):
            return bound_integers(body)
        case Implies(left, right) | Iff(left, right):
            return bound_integers(left) | bound_integers(right)
        case Both(parts):
            return set().union(*map(bound_integers, parts))
    return set()


def equations(statement: Statement) -> Iterator[Relation]:
    """The relations of a chain or a system. Raises GoalError for a statement with ⇒ or ⇔ within."""
    match statement:
        case Relation():
            yield statement
        case Conjunction(parts=parts):
            for part in parts:
                yield from equations(part)
        case _:
            raise GoalError("expected equations, got an implication")
