"""Reader of propositions: what the text of a goal states, and where that differs from the goal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from workbench.certificates.emission.emitted_suppositions import conditions
from workbench.certificates.goals.propositions import ALWAYS, binder, every
from workbench.certificates.reading.meaning import OfTerm, OfText
from workbench.certificates.reading.read_back import Expression, Parser, Unread
from workbench.certificates.theorem import relations
from workbench.core.construct import symbol
from workbench.core.properties import PROPERTIES
from workbench.core.terms import Relation, Term
from workbench.core.types import Declaration
from workbench.language.goals.goals import (
    All,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    Iff,
    Implies,
    Variable,
)

_SUPPOSED = {
    row.coq.format(dual=dual, d="", k="").split()[0]
    for row in PROPERTIES.values()
    for dual in ("", "dual_")
    if row.coq
}


@dataclass(frozen=True)
class Proposition:
    """A proposition as read.

    Attributes:
        head: `forall`, `exists`, `->`, `<->`, `and`, `not`, `equal`, `at_least`, `is` for the condition on a
            letter, `every` for an integer, or `always`.
        binders: As written; for an integer, its name and its least value.
        sides: The sides of an equation.
        dual: Whether the equation is between dual quantities.
        words: The words of an `is`.
    """

    head: str
    parts: tuple[Proposition, ...] = ()
    binders: tuple[str, ...] = ()
    sides: tuple[Expression, ...] = ()
    dual: bool = False
    words: str = ""

    def __str__(self) -> str:
        match self.head:
            case "forall" | "exists":
                return f"{self.head} {' '.join(self.binders)}, {self.parts[0]}"
            case "every":
                return f"{every(self.binders[0], int(self.binders[1]))}{self.parts[0]}"
            case "always":
                return f"{ALWAYS}{self.parts[0]}"
            case "->":
                return f"{self.parts[0].within()} -> {self.parts[1]}"
            case "<->":
                return " <-> ".join(p.within() for p in self.parts)
            case "and":
                return " /\\ ".join(p.within() for p in self.parts)
            case "not":
                return f"~ {self.parts[0]}"
            case "is":
                return self.words
        word = "equal_at" if self.head == "equal" else self.head
        return f"{word} {'(d := true) ' if self.dual else ''}now {' '.join(s.at(0) for s in self.sides)}"

    def within(self) -> str:
        loose = self.head in ("forall", "exists", "every", "always", "->", "<->", "and")
        return f"({self})" if loose else str(self)


class _Reader(Parser):
    def proposition(self) -> Proposition:
        if self.peek() in ("forall", "exists"):
            quantifier, binders = self.take(), []
            if quantifier == "forall" and self.peek() != "(":
                return self._counted()
            while self.peek() == "(":
                binders.append(self._binder())
            self.take(",")
            return Proposition(quantifier, (self.proposition(),), tuple(binders))
        left = self._conjunction()
        if self.peek() == "->":
            self.take()
            return Proposition("->", (left, self.proposition()))
        if self.peek() == "<->":
            self.take()
            return Proposition("<->", (left, self._conjunction()))
        return left

    def _counted(self) -> Proposition:
        """Returns the proposition for every integer from its least value on, or for every instant."""
        name, _, type_, _ = self.take(), self.take(":"), self.take(), self.take(",")
        if (name, type_) == ("now", "instant"):
            return Proposition("always", (self.proposition(),))
        if type_ != "nat":
            raise Unread(f"{name} is a {type_}")
        least = "0"
        if self.tokens[self.place : self.place + 1] == ["("] and self.tokens[self.place + 2] == "<=":
            _, least, _, _, _, _, _ = map(self.take, ("(", None, "<=", name, ")", "%nat", "->"))
        return Proposition("every", (self.proposition(),), (name, least))

    def _conjunction(self) -> Proposition:
        parts = [self._unit()]
        while self.peek() == "/\\":
            self.take()
            parts.append(self._unit())
        return parts[0] if len(parts) == 1 else Proposition("and", tuple(parts))

    def _unit(self) -> Proposition:
        match word := self.take():
            case "(":
                inner = self.proposition()
                self.take(")")
                return inner
            case "~":
                return Proposition("not", (self._unit(),))
            case "equal_at" | "at_least":
                dual = self._given("d", "true")
                self.take("now")
                head = "equal" if word == "equal_at" else word
                return Proposition(head, sides=(self.atom(), self.atom()), dual=dual)
            case _ if word in _SUPPOSED:
                words = [word]
                while self.peek() == "(":
                    _, name, _, value, _ = (self.take() for _ in range(5))
                    words.append(f"({name} := {value})")
                return Proposition("is", words=" ".join([*words, self.take()]))
        raise Unread(f"expected a proposition, got {word}")

    def _given(self, name: str, value: str) -> bool:
        if self.peek() != "(" or self.tokens[self.place + 1 : self.place + 3] != [name, ":="]:
            return False
        for expected in ("(", name, ":=", value, ")"):
            self.take(expected)
        return True

    def _binder(self) -> str:
        self.take("(")
        name = self.take()
        self.take(":")
        type_ = [self.take()]
        while self.peek() != ")":
            type_.append(self.take())
        self.take(")")
        return f"({name} : {' '.join(type_)})"


def proposition(text: str) -> Proposition:
    """Returns the proposition of a text. Raises Unread outside of the emitted subset."""
    reader = _Reader(text)
    made = reader.proposition()
    if reader.peek():
        raise Unread(f"{reader.peek()} after the end of a proposition")
    return made


@dataclass(frozen=True)
class Comparison:
    """Comparison of a proposition with a goal. names: name in the text → term."""

    of_term: OfTerm
    names: Mapping[str, Term]
    families: Mapping[Declaration, str]
    integers: Mapping[str, str] = field(default_factory=dict)

    def faults(self, said: Proposition, goal: Goal) -> Iterator[str]:
        match goal, said.head:
            case Atom(statement), _:
                one = list(relations(statement))
                parts = said.parts if len(one) > 1 and said.head == "and" else (said,)
                yield from self._each(parts, one, Comparison._relation)
            case AtLeast(left, right), "at_least":
                yield from self._sides(said, left, right)
            case Both(parts), "and":
                yield from self._each(said.parts, parts, Comparison.faults)
            case Implies(premise, conclusion, lasting), "->":
                first, then = said.parts
                if lasting != (first.head == "always"):
                    yield f"{first} is supposed at another time"
                    return
                parts = first.parts if lasting else (first,)
                yield from self._each((*parts, then), (premise, conclusion), Comparison.faults)
            case AllFrom(integer, least, body), "every":
                name, own = said.binders
                if own != str(least) or name in self.integers.values():
                    yield f"{name} is at least {own} and stands for {integer} ≥ {least}"
                integers = {**self.integers, integer: name}
                of_term = self.of_term.with_letters((), len(integers))
                inside = replace(self, integers=integers, of_term=of_term)
                yield from inside.faults(said.parts[0], body)
            case Iff(left, right), "<->":
                yield from self._each(said.parts, (left, right), Comparison.faults)
            case All(variables, body), "forall":
                yield from self._all(said, variables, body)
            case Exists(variables, body, unique), "exists":
                yield from self._exists(said, variables, body, unique)
            case _:
                yield f"{said.head} stands for {type(goal).__name__}"

    def _each(self, said: Sequence[Proposition], wanted: Sequence, faults) -> Iterator[str]:
        if len(said) != len(wanted):
            yield f"{len(said)} parts stand for {len(wanted)}"
            return
        for one, goal in zip(said, wanted, strict=True):
            yield from faults(self, one, goal)

    def _bound(
        self, said: Proposition, variables: Sequence[Variable]
    ) -> tuple[Comparison, list[str], list[str]]:
        """Returns the comparison inside of the quantifier, the names, and the expected conditions on the
        letters."""
        names = [text.split()[0].removeprefix("(") for text in said.binders]
        letters = {n: symbol(v.declaration) for n, v in zip(names, variables, strict=False)}
        wanted = [c for n, v in zip(names, variables, strict=False) for c in conditions(v.declaration, n)]
        of_term = self.of_term.with_letters([v.name for v in variables], len(self.integers))
        return replace(self, names={**self.names, **letters}, of_term=of_term), names, wanted

    def _binders(
        self, said: Proposition, variables: Sequence[Variable], names: Sequence[str]
    ) -> Iterator[str]:
        wanted = tuple(binder(v, n) for v, n in zip(variables, names, strict=False))
        if said.binders != wanted or len(variables) != len(names) or len(set(names)) != len(names):
            yield f"{' '.join(said.binders)} stands for {', '.join(v.letter.letter for v in variables)}"

    def _all(self, said: Proposition, variables: Sequence[Variable], body: Goal) -> Iterator[str]:
        inside, names, wanted = self._bound(said, variables)
        yield from self._binders(said, variables, names)
        inner = _after(wanted, said.parts[0])
        if inner is None:
            yield f"{', '.join(wanted)} is not what is supposed of {', '.join(names)}"
            return
        yield from inside.faults(inner, body)

    def _exists(
        self, said: Proposition, variables: Sequence[Variable], body: Goal, unique: bool
    ) -> Iterator[str]:
        inside, names, wanted = self._bound(said, variables)
        yield from self._binders(said, variables, names)
        inner = said.parts[0]
        parts = list(inner.parts) if inner.head == "and" else [inner]
        if [p.words for p in parts[: len(wanted)]] != wanted or len(parts) != len(wanted) + 1 + unique:
            yield f"{', '.join(wanted)} is not what is said of {', '.join(names)}"
            return
        yield from inside.faults(parts[len(wanted)], body)
        if unique:
            yield from self._only(parts[-1], variables, names, body)

    def _only(
        self, said: Proposition, variables: Sequence[Variable], names: Sequence[str], body: Goal
    ) -> Iterator[str]:
        if said.head != "forall":
            yield "nothing says that there are no others"
            return
        inside, others, wanted = self._bound(said, variables)
        yield from self._binders(said, variables, others)
        inner = _after(wanted, said.parts[0])
        if inner is None or inner.head != "->":
            yield f"{', '.join(wanted)} is not what is supposed of {', '.join(others)}"
            return
        yield from inside.faults(inner.parts[0], body)
        last = inner.parts[1]
        same = tuple(
            Proposition("equal", sides=(Expression(a), Expression(b)), dual=v.declaration.type.dual)
            for a, b, v in zip(others, names, variables, strict=False)
        )
        if last != (same[0] if len(same) == 1 else Proposition("and", same)) or set(others) & set(names):
            yield f"{last} does not say that others are the same"

    def _relation(self, said: Proposition, one: Relation) -> Iterator[str]:
        inner = said
        if one.operator == "≠":
            if said.head != "not":
                yield f"{said} denies nothing"
                return
            (inner,) = said.parts
        if inner.head != "equal" or inner.dual != (one.left.type.dual or one.right.type.dual):
            yield f"{said} is no such equation"
            return
        yield from self._sides(inner, one.left, one.right)

    def _sides(self, said: Proposition, left: Term, right: Term) -> Iterator[str]:
        of_text = OfText(self.names, self.of_term, self.families, self.integers)
        for text, term in zip(said.sides, (left, right), strict=True):
            meant, wanted = of_text(text), self.of_term(term)
            if meant != wanted:
                yield f"{text} says {meant}, the term {wanted}"


def _after(wanted: Sequence[str], said: Proposition) -> Proposition | None:
    """Returns the rest after these premises; None if they are not the premises."""
    for one in wanted:
        if said.head != "->" or said.parts[0] != Proposition("is", words=one):
            return None
        said = said.parts[1]
    return said


def faults(
    text: str, goal: Goal, of_term: OfTerm, names: Mapping[str, Term], families: Mapping[Declaration, str]
) -> list[str]:
    """Returns where the text, read back, differs from the goal, or does not reproduce the text."""
    read = proposition(text)
    found = [] if str(read) == text else [f"{text} is written again as {read}"]
    return found + list(Comparison(of_term, names, families).faults(read, goal))
