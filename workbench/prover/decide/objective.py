"""The objective of a minimum or maximum as a function of its variables."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.core.construct import apply, block, dual_unit, number, rebuild
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.terms import (
    Apply,
    BigSum,
    Conjunction,
    Derivative,
    Extremum,
    Relation,
    Statement,
    Symbol,
    Term,
)
from workbench.engines.inventory import Lookup, NotExact
from workbench.language.definitions import expand, replaced


@dataclass(frozen=True)
class Objective:
    """The objective.

    letters: the variables, numbers and vectors.   body: the term, with all definitions expanded.
    inside: the argument of the norm, if the body is a norm.
    """

    letters: tuple[Symbol, ...]
    body: Term
    inside: Term | None

    @staticmethod
    def of(said: Extremum, definitions: Lookup, assume: Sequence[Statement]) -> Objective:
        """Returns the objective. Raises NotExact if the term depends on a variable in a hidden way."""
        body = expand(said.body, definitions)
        for letter in said.letters:
            _require_visible(letter, body)
            supposed = [expand(side, definitions) for s in assume for side in _sides(s)]
            if any(letter in side.walk() for side in supposed):
                raise NotExact(f"a premise about {letter.declaration.name}, which varies")
        if isinstance(body, Apply) and body.head == "norm" and not body.type.dual:
            return Objective(said.letters, body, body.arguments[0])
        return Objective(said.letters, body, None)

    @property
    def count(self) -> int:
        """The number of unknown components."""
        return sum(letter.type.rows for letter in self.letters)

    @property
    def unknowns(self) -> list[Term]:
        """The components of the letters."""
        return [
            letter if letter.type.rows == 1 else apply("dot", _column(int(j == i) for j in range(3)), letter)
            for letter in self.letters
            for i in range(letter.type.rows)
        ]

    def at(self, values: Mapping[int, int]) -> Term:
        """Returns the term with these values of the unknowns, and 0 for the others."""
        return self._put(self.body, values)

    def inside_at(self, values: Mapping[int, int]) -> Term:
        assert self.inside is not None, "a norm"
        return self._put(self.inside, values)

    def _put(self, term: Term, values: Mapping[int, int]) -> Term:
        given: dict[Symbol, Term] = {}
        first = 0
        for letter in self.letters:
            own = {i: values.get(first + i, 0) for i in range(letter.type.rows)}
            given[letter] = _column(own.values()) if letter.type.rows > 1 else _weightless(own[0])
            first += letter.type.rows
        return replaced(term, given.get)


def _weightless(value: int) -> Term:
    return replace(number(value), weight=None)


def _column(values: Iterable[int]) -> Term:
    return block([[_weightless(value)] for value in values])


def _require_visible(letter: Symbol, body: Term) -> None:
    name = letter.declaration.name
    for part in body.walk():
        if isinstance(part, Derivative | BigSum) and letter in part.walk():
            raise NotExact(f"a rate or a sum over n of what depends on {name}, which varies")
        if isinstance(part, Apply) and letter in part.walk():
            operator = part.head in GRADIENTS | PARTIALS or part.arguments[0].type.kind == "operator"
            if operator:
                raise NotExact(f"a derivative of what depends on {name}, which varies")
        if isinstance(part, Symbol) and part != letter:
            scripts = " ".join(text for script in part.declaration.name.scripts for text in script)
            spoken = re.findall(r"\\[A-Za-z]+|[A-Za-z]+", scripts)
            if letter in part.arguments or letter in part.declaration.of or name.letter in spoken:
                raise NotExact(f"{part.declaration.name} may depend on {name}, which varies; define it")


def _sides(statement: Statement) -> list[Term]:
    match statement:
        case Relation():
            return [statement.left, statement.right]
        case Conjunction(parts=parts):
            return [side for part in parts for side in _sides(part)]
    raise NotExact("a minimum or maximum under a premise that is no equation or inequation")


def at_zero_part(term: Term, is_zero: Callable[[Term], bool]) -> Term:
    """Returns the term with |a + ε b| replaced by ε ‖b‖ where a is 0."""
    children = [at_zero_part(child, is_zero) for child in term.children]
    is_norm = isinstance(term, Apply) and term.head == "norm" and term.type.dual
    if is_norm and is_zero(apply("re", children[0])):
        return apply("mul", dual_unit(), apply("norm", apply("du", children[0])))
    same = all(n is old for n, old in zip(children, term.children, strict=True))
    return term if same else rebuild(term, children)
