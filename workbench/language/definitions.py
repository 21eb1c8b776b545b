"""The definitions of a paper's symbols: one step at a time, or expanded completely."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Protocol

from workbench.core.codes.type_codes import TypeCode
from workbench.core.construct import apply, number, power, relation, with_children, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.names import Name
from workbench.core.operations import CIRCULAR
from workbench.core.terms import (
    Apply,
    Definition,
    Identity,
    IllFormed,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
    sides_of,
)
from workbench.core.types import PI, SCALAR, Declaration
from workbench.language.naming.spelling import Named

#: Left subscript that marks the root of a positive number.
_ROOT = ("\\surd",)


class Lookup(Protocol):
    """A lookup of definitions: the body of a defined symbol in one step, None for a free one."""

    def lookup(self, symbol: Symbol) -> Term | None: ...


def is_definition(statement: Statement, definitions: Lookup) -> bool:
    """True if an equation is the definition of the symbol on its left that is in force."""
    match statement:
        case Relation(operator="=", left=Symbol() as defined, right=body):
            return definitions.lookup(defined) == body
    return False


class Definitions:
    """The definitions of a paper, looked up symbol by symbol.

    A definition covers the members that its index reaches with n ≥ 0: a_{n+1} := … defines a₁, a₂, … and
    leaves a declared a₀ free. The definition of a single member takes precedence, Φ₁ over Φ_{n+1}; no other
    member is defined twice. A recurrence descends from a number to its base; a symbolic Φ_n stays a free
    member of the family, and Φ_{n+1} is rewritten in terms of Φ_n.
    """

    def __init__(self, definitions: Iterable[Definition] = ()) -> None:
        self._all = tuple(definitions)
        self._of: dict[Name, list[Definition]] = {}
        for definition in sorted(self._all, key=lambda d: sum(not place.is_number for place in d.index)):
            self._of.setdefault(definition.declaration.name, []).append(definition)
        # The key is the whole name, since a base Φ₁ is a separate symbol until the recurrence makes it a
        # member.
        self._exact = {
            d.declaration.name.at(d.index): d for d in self._all if all(i.is_number for i in d.index)
        }
        self._known: dict[Symbol, Term | None] = {}
        self._about: dict[Name, tuple[Definition, ...]] = {}

    def __iter__(self) -> Iterator[Definition]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def about(self, symbol: Symbol) -> tuple[Definition, ...]:
        """Returns the definitions of the symbol's family, including those of single members, as Φ₁ of Φₙ."""
        family = symbol.declaration.name
        if family not in self._about:
            names = ((d, d.declaration.name) for d in self._all)
            own = (d for d, name in names if name == family or family.index_of(name) is not None)
            self._about[family] = tuple(own)
        return self._about[family]

    def reached(self, *terms: Term) -> Iterator[Term]:
        """Yields the subterms of the terms, and those of all definitions in them, recursively."""
        waiting, seen = list(reversed(terms)), set()
        while waiting:
            for part in waiting.pop().walk():
                yield part
                if isinstance(part, Symbol) and part.declaration.name not in seen:
                    seen.add(part.declaration.name)
                    waiting += [definition.body for definition in self.about(part)]

    def symbols_in(self, *terms: Term) -> Iterator[Symbol]:
        """Yields the symbols in the terms, and those in all definitions in them, recursively."""
        return (part for part in self.reached(*terms) if isinstance(part, Symbol))

    def known_of(self, statement: Statement) -> Iterator[Relation]:
        """Yields what is known of the symbols of the statement.

        A positive symbol is not 0. π is not 0; if it occurs only in sines and the like, the cosine and sine
        of its half are given instead.
        """
        found = list(dict.fromkeys(self.symbols_in(*sides_of(statement))))
        yield from (relation("≠", part, zero()) for part in found if part.declaration.positive)
        pis = [part for part in found if self.is_pi(part.declaration)]
        sides = [expand(side, self) for side in sides_of(statement)] if pis else []
        for pi in pis:
            quarter = apply("div", pi, number(2))
            if all(only_turns(side, pi) for side in sides):
                yield relation("=", apply("cos", quarter), zero())
                yield relation("=", apply("sin", quarter), number(1))
            else:
                yield relation("≠", pi, zero())

    def is_pi(self, declaration: Declaration) -> bool:
        """True for the number π, which a model may leave undeclared; False for a declared free symbol."""
        is_number = declaration.type == SCALAR and not declaration.free
        return declaration.name == PI.name and is_number and declaration.name not in self._of

    def lookup(self, symbol: Symbol) -> Term | None:
        """Returns the body of the symbol for its index and arguments, one step; None if it is primitive.

        The same symbol gives the same object. Raises IllFormed for an undefined member of a family that only
        definitions introduce.
        """
        is_defined = symbol.declaration.name in self._of
        if not is_defined and not symbol.declaration.positive:
            return None
        if symbol not in self._known:
            self._known[symbol] = self._step(symbol) if is_defined else squared_root(symbol)
        return self._known[symbol]

    def _step(self, symbol: Symbol) -> Term | None:
        exact = self._exact.get(symbol.declaration.name.at(symbol.index))
        if exact is not None:
            body = _with_arguments(exact.body, exact, symbol)
            is_bare = isinstance(body, Zero | Identity) and not body.printed
            return replace(body, type=symbol.type.with_dual(False)) if is_bare else body
        own = self._of[symbol.declaration.name]
        for definition in own:
            values = solve(definition.index, symbol.index)
            if values is not None and all(value.constant >= 0 for value in values.values()):
                return _with_arguments(instantiate(definition.body, values), definition, symbol)
        if symbol.declaration.introduced and all(place.is_number for place in symbol.index):
            family = symbol.declaration.name
            known = [str(name) for name in self._exact if family.index_of(name) is not None]
            known += [family.shown(definition.index) for definition in own]
            shown = ", ".join(dict.fromkeys(known))
            raise IllFormed(TypeCode.UNDEFINED_MEMBER(shown=family.shown(symbol.index), known=shown))
        return None


def squared_root(symbol: Symbol) -> Term:
    """Returns x = r² for a positive x: every such x has an equally smooth r, and the square of every r ≠ 0 is
    positive."""
    own = symbol.declaration
    name = replace(own.name, left_sub=(*_ROOT, *own.name.left_sub))
    root = replace(own, name=name, weight=None).with_flags(positive=False)
    return power(replace(symbol, declaration=root, weight=None), 2)


def number_behind(root: Symbol) -> Symbol:
    """Returns the positive number whose root `squared_root` created; other symbols unchanged."""
    own = root.declaration
    if own.name.left_sub[:1] != _ROOT:
        return root
    name = replace(own.name, left_sub=own.name.left_sub[1:])
    return replace(root, declaration=replace(own, name=name).with_flags(positive=True))


def expand(term: Term, definitions: Lookup) -> Term:
    """Returns the term with every defined symbol replaced by its body, down to primitive symbols.

    Equal symbols become one object, so that Φ_8 stays a small graph although it is a huge tree.
    """
    return _Expansion(definitions).term(term)


class _Expansion:
    def __init__(self, definitions: Lookup) -> None:
        self.definitions = definitions
        self.done: dict[int, tuple[Term, Term]] = {}
        self.members: dict[Named, Term] = {}

    def term(self, term: Term) -> Term:
        known = self.done.get(id(term))
        if known is None:
            known = self.done[id(term)] = (term, self._term(term))
        return known[1]

    def _term(self, term: Term) -> Term:
        if isinstance(term, Symbol):
            key = (term.declaration.name, term.index)
            if not term.arguments and key in self.members:
                return self.members[key]
            body = self.definitions.lookup(term)
            if body is not None:
                result = self.term(body)
                if not term.arguments:
                    self.members[key] = result
                return result
        return with_children(term, self.term)


def only_turns(term: Term, pi: Symbol) -> bool:
    """True if π occurs only as an addend of the argument of a sine or the like."""
    if isinstance(term, Apply) and term.head in CIRCULAR:
        return all(_is_addend(each, pi) for each in term.arguments)
    return term != pi and all(only_turns(child, pi) for child in term.children)


def _is_addend(term: Term, pi: Symbol) -> bool:
    head = term.head if isinstance(term, Apply) else ""
    rest = [part for part in term.children if not isinstance(part, Number)]
    if head in ("add", "neg") or (head in ("mul", "div") and len(rest) == 1):
        return all(_is_addend(part, pi) for part in rest)
    return term == pi or pi not in term.walk()


def solve(pattern: tuple[Linear, ...], index: tuple[Linear, ...]) -> dict[str, Linear] | None:
    """Returns the values of the pattern's variables at which it equals the index; None if there are none."""
    values: dict[str, Linear] = {}
    for place, wanted in zip(pattern, index, strict=True):
        if place.is_number:
            if place != wanted:
                return None
            continue
        ((name, _),) = place.coefficients
        values[name] = wanted - place.constant
    return values


def _with_arguments(body: Term, definition: Definition, symbol: Symbol) -> Term:
    if not definition.parameters:
        return body
    actual = {p.name: a for p, a in zip(definition.parameters, symbol.arguments, strict=True)}
    used = frozenset().union(*map(free_integers, symbol.arguments))
    body = instantiate(body, {f"in {name}": Linear.variable(name) for name in used})
    return replaced(body, lambda symbol: actual.get(symbol.declaration.name))


def replaced(term: Term, given: Callable[[Symbol], Term | None]) -> Term:
    """Returns the term with its symbols replaced where `given` returns a term. Raises IllFormed."""
    return _replaced(term, given, {})


def _replaced(term: Term, given: Callable[[Symbol], Term | None], done: dict[int, Term]) -> Term:
    if id(term) not in done:
        new = given(term) if isinstance(term, Symbol) else None
        if new is None:
            new = with_children(term, lambda child: _replaced(child, given, done))
        done[id(term)] = new
    return done[id(term)]
