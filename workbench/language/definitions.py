"""What the defined symbols of a paper stand for: one step at a time, or all the way down."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from workbench.language.construct import rebuild
from workbench.language.instances import instantiate
from workbench.language.integers import Linear
from workbench.language.symbols import index_in, spelled
from workbench.language.terms import Definition, Identity, IllFormed, Symbol, Term, Zero


class Definitions:
    """The definitions of a paper, asked for one symbol at a time.

    An index given as a number (Φ₁) goes before a pattern (Φ_{n+1} or Φ_n). A recurrence, whose body mentions
    the family itself, descends from a number to its base; a symbolic Φ_n stays a free member of the family,
    and Φ_{n+1} is rewritten in Φ_n.
    """

    def __init__(self, definitions: Iterable[Definition] = ()) -> None:
        self._all = tuple(definitions)
        self._of: dict[str, list[Definition]] = {}
        for definition in self._all:
            self._of.setdefault(definition.declaration.name, []).append(definition)
        self._exact = {
            spelled(d.declaration.name, d.index): d for d in self._all if all(i.is_number for i in d.index)
        }
        self._recurrences = {id(d) for d in self._all if _mentions(d.body, d.declaration.name)}
        self._known: dict[Symbol, Term | None] = {}

    def __iter__(self) -> Iterator[Definition]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def lookup(self, symbol: Symbol) -> Term | None:
        """What the symbol is defined as, one step, for its own index and arguments; None if it is primitive.

        The same symbol gives the same object. Raises IllFormed for a member below the base of a recurrence.
        """
        if symbol.declaration.name not in self._of:
            return None
        if symbol not in self._known:
            self._known[symbol] = self._step(symbol)
        return self._known[symbol]

    def _step(self, symbol: Symbol) -> Term | None:
        exact = self._exact.get(spelled(symbol.declaration.name, symbol.index))
        if exact is not None:
            body = _with_arguments(exact.body, exact, symbol)
            if isinstance(body, Zero | Identity):
                return replace(body, type=symbol.type.with_dual(False))
            return body
        for definition in self._of[symbol.declaration.name]:
            values = solve(definition.index, symbol.index)
            if values is None:
                continue
            if id(definition) in self._recurrences and not self._descends(symbol, values):
                return None
            body = instantiate(definition.body, values)
            return _with_arguments(body, definition, symbol)
        return None

    def _descends(self, symbol: Symbol, values: Mapping[str, Linear]) -> bool:
        """Whether the recurrence step applies: a number above the base, or a symbolic n + c."""
        if any(value.constant < 0 for value in values.values() if not value.is_number):
            return False
        numbers = [i for i in symbol.index if i.is_number]
        if len(numbers) < len(symbol.index):
            return True
        bases = (index_in(symbol.declaration.name, name) for name in self._exact)
        lowest = min((tuple(map(int, base)) for base in bases if base is not None), default=None)
        if lowest is None or tuple(int(i) for i in symbol.index) < lowest:
            start = "has no base" if lowest is None else f"starts at {', '.join(map(str, lowest))}"
            wanted = ", ".join(map(str, symbol.index))
            name = symbol.declaration.name.replace("@", "n")
            raise IllFormed(f"{name} is not defined for n = {wanted}: its recurrence {start}")
        return True


def expand(term: Term, definitions: Definitions) -> Term:
    """The term with every defined symbol replaced by its body, down to primitive symbols.

    Equal symbols become one object, so that Φ_8 stays a small graph although it is a huge tree.
    """
    return _Expansion(definitions).term(term)


class _Expansion:
    def __init__(self, definitions: Definitions) -> None:
        self.definitions = definitions
        self.done: dict[int, tuple[Term, Term]] = {}
        self.members: dict[tuple[str, tuple[Linear, ...]], Term] = {}

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
        children = tuple(self.term(child) for child in term.children)
        unchanged = all(new is old for new, old in zip(children, term.children, strict=True))
        return term if unchanged else rebuild(term, children)


def _mentions(body: Term, name: str) -> bool:
    return any(isinstance(t, Symbol) and t.declaration.name == name for t in body.walk())


def solve(pattern: tuple[Linear, ...], index: tuple[Linear, ...]) -> dict[str, Linear] | None:
    """The values of the pattern's variables at which it equals the index; None if there are none."""
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
    return _replace(body, actual, {})


def _replace(term: Term, actual: Mapping[str, Term], done: dict[int, Term]) -> Term:
    if id(term) not in done:
        if isinstance(term, Symbol) and term.declaration.name in actual:
            done[id(term)] = actual[term.declaration.name]
        else:
            children = tuple(_replace(child, actual, done) for child in term.children)
            unchanged = all(new is old for new, old in zip(children, term.children, strict=True))
            done[id(term)] = term if unchanged else rebuild(term, children)
    return done[id(term)]
