"""Readings of a formula whose types or weights do not fit, by what its printing may have lost.

An equation is taken apart into addends. Each has its own alternatives: the marks that can be put on it so
that it has the type and weight of the other side. Of one alternative for each addend those are sought that
add up to the other side at random points modulo the prime; and those with the fewest marks, whatever they
add up to.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from heapq import heappop, heappush
from itertools import combinations, islice, product
from random import Random

from workbench.judge.rings import PRIME
from workbench.language.elaborate import Elaborator
from workbench.language.errors import Fault, Misfit
from workbench.language.statements import reading_of
from workbench.language.syntax import Bracket, Chain, Fraction, Group, Leaf, Lines, Node, Product, Sum, parse
from workbench.language.terms import Conjunction, IllFormed, Statement, Term
from workbench.papers.model import Claim
from workbench.repair.marks import Mark, letter_marks, marked, product_marks
from workbench.repair.nodes import below, exchanged, latex_of
from workbench.repair.screen import Screen
from workbench.repair.search import Candidate, Change

#: The most misprints undone in one addend, and the most alternatives of one addend that are read.
MOST_MARKS = 4
MOST_READ = 1500

#: Alternatives kept of each addend, in the rounds of the search for a sum that fits.
_ROUNDS = (4, 12, 40)
_MOST_SUMS = 200_000
_MOST_PAIRS = 3000

_LINEAR = frozenset(("symmetric", "skew", "vect", "trace", "re", "du"))

Marks = tuple[Mark, ...]


@dataclass(frozen=True)
class _Alternative:
    """What an addend may have been: its marks, the term it then is, and a number that tells its value."""

    marks: Marks
    term: Term
    value: int | None

    @property
    def cost(self) -> int:
        return sum(mark.cost for mark in self.marks)


class Readings:
    """The readings of an ill-formed claim. `tick` is called now and then, and may raise to end the search."""

    def __init__(self, claim: Claim, screen: Screen | None, tick: Callable[[], None]) -> None:
        try:
            self._reader = _Reader(claim, parse(claim.printed.latex), screen, tick)
        except Fault:
            self._reader = None
        self._seen: set[Statement] = set()

    def that_hold(self) -> Iterator[Candidate]:
        """Equations that hold at the screen's points, those with few marks first."""
        if self._reader is not None:
            yield from self._candidates(self._reader.that_add_up())

    def likeliest(self, most: int) -> Iterator[Candidate]:
        """Up to `most` readings with few marks, true or not."""
        if self._reader is not None:
            yield from islice(self._candidates(self._reader.few_marks(most)), most)

    def _candidates(self, choices: Iterator[Marks]) -> Iterator[Candidate]:
        for marks in choices:
            statement = self._reader.statement(marks)
            if statement is not None and statement not in self._seen:
                self._seen.add(statement)
                changes = tuple(Change(mark.kind, mark.description) for mark in marks)
                yield Candidate(statement, changes, latex_of(marked(marks, self._reader.lines)))


class _Reader:
    """One formula and what is known of its integers."""

    def __init__(self, claim: Claim, lines: Lines, screen: Screen | None, tick: Callable[[], None]) -> None:
        self.table = claim.notation.symbols
        self.lines, self.screen, self.tick = lines, screen, tick
        self.integers = frozenset(claim.orders.variables if claim.orders else ())
        self._taken_apart: list[_Parts] = []

    def statement(self, marks: Sequence[Mark]) -> Statement | None:
        try:
            found = reading_of(marked(marks, self.lines), self.table, self.integers).statements
        except (Fault, Misfit, IllFormed):
            return None
        return found[0] if len(found) == 1 else Conjunction(found)

    def term(self, node: Node) -> Term | None:
        self.tick()
        try:
            return Elaborator(self.table, self.integers).term(node)
        except (Fault, Misfit, IllFormed):
            return None

    def that_add_up(self) -> Iterator[Marks]:
        equation = self._equation()
        if equation is not None:
            self._taken_apart = list(_Equation(self, equation).taken_apart())
            for parts in self._taken_apart:
                yield from parts.that_add_up()

    def few_marks(self, most: int) -> Iterator[Marks]:
        for parts in self._taken_apart:
            yield from parts.cheapest(most)
        if not self._taken_apart:
            yield from self._anywhere()

    def _equation(self) -> Chain | None:
        chains = [c for line in self.lines.lines for c in line if isinstance(c, Chain) and c.relations]
        equations = [c for c in chains if [sign for sign, _ in c.relations] == ["="]]
        return equations[0] if len(equations) == 1 and self.screen is not None else None

    def _anywhere(self) -> Iterator[Marks]:
        """One or two marks anywhere, for what is no equation."""
        single = sorted(all_marks(self.lines, self.table), key=lambda mark: mark.cost)
        yield from ((mark,) for mark in single if mark.cost <= 2)
        cheap = [mark for mark in single if mark.cost == 1]
        for count, pair in enumerate(combinations(cheap, 2)):
            if count == _MOST_PAIRS:
                return
            yield pair


def all_marks(node: Node, table) -> list[Mark]:
    return [mark for marks in letter_marks(node, table) for mark in marks] + list(product_marks(node))


class _Equation:
    """left = right, at least one of which cannot be read."""

    def __init__(self, reader: _Reader, chain: Chain) -> None:
        self.reader, self.chain = reader, chain
        random = Random(61)
        self.weights = [random.randrange(PRIME) for _ in range(400)]

    def taken_apart(self) -> Iterator[_Parts]:
        """The alternatives of all addends, for each way to read the denominators."""
        for context in self._contexts():
            for wanted in self._wanted([self._slots(side, context, None) for side in self.chain.sides]):
                slots = []
                for sign, side in zip((1, -1), self.chain.sides, strict=True):
                    slots += [(sign, alternatives) for alternatives in self._slots(side, context, wanted)]
                if all(alternatives for _, alternatives in slots):
                    yield _Parts(context, slots)

    def _contexts(self) -> Iterator[Marks]:
        """What makes the denominators readable."""
        ways: list[list[Marks]] = []
        for part in below(self.chain):
            if isinstance(part, Fraction) and self.reader.term(part.denominator) is None:
                ways.append(self._ways_to_read(part.denominator))
        yield from (tuple(m for marks in chosen for m in marks) for chosen in product(*ways))

    def _ways_to_read(self, node: Node) -> list[Marks]:
        single = [mark for mark in all_marks(node, self.reader.table) if mark.cost == 1]
        ways: list[Marks] = []
        for marks in (*((m,) for m in single), *combinations(single, 2)):
            term = self.reader.term(marked(marks, node))
            if term is not None and term.type.kind == "scalar":
                ways.append(marks)
            if len(ways) == 4:
                break
        return ways

    # addends

    def _slots(self, side: Node, context: Marks, wanted: Term | None) -> list[list[_Alternative]]:
        """The alternatives of each addend of a side. wanted: a term of the type and weight that they must
        have; without it only what can be read as printed is given."""
        whole = self.reader.term(marked(context, side))
        if whole is not None and (wanted is None or _fits(whole, wanted)):
            return [[_Alternative((), whole, self._value(whole, wanted))]]
        return [self._alternatives(side, leaf, context, wanted) for leaf in addends_of(side)]

    def _wanted(self, found: Sequence[list[list[_Alternative]]]) -> list[Term]:
        """Terms of the types and weights that both sides may have: those of a whole side that can be read, or
        those that most addends have."""
        whole = [slots[0][0].term for slots in found if len(slots) == 1 and slots[0]]
        whole = [t for t in whole if t.weight is not None]
        if whole:
            return whole[:1] if len(whole) == 2 and _fits(*whole) else whole
        terms = [a.term for slots in found for alternatives in slots for a in alternatives]
        terms = [t for t in terms if t.weight is not None] or terms
        return [max(terms, key=lambda t: sum(_fits(t, other) for other in terms))] if terms else []

    def _alternatives(
        self, side: Node, leaf: Node, context: Marks, wanted: Term | None
    ) -> list[_Alternative]:
        found: dict[object, _Alternative] = {}
        most = MOST_MARKS
        lonely = alone(marked(context, side), leaf)
        for count, marks in enumerate(self._choices(leaf) if wanted is not None else [()]):
            if count == MOST_READ or sum(mark.cost for mark in marks) > most:
                break
            term = self.reader.term(marked(marks, lonely))
            if term is None or (wanted is not None and not _fits(term, wanted)):
                continue
            value = self._value(term, wanted)
            if not marks:
                most = 1  # nothing is wrong with it by itself
            found.setdefault(term if value is None else value, _Alternative(marks, term, value))
        return list(found.values())

    def _choices(self, leaf: Node) -> Iterator[Marks]:
        """Combinations of marks by their cost: one on each letter, and one on the products."""
        letters = list(letter_marks(leaf, self.reader.table))
        products = list(product_marks(leaf))
        for cost in range(MOST_MARKS + 1):
            for part in range(min(cost, 1) + 1):
                for on_letters in _with_cost(letters, cost - part):
                    if part:
                        yield from ((*on_letters, mark) for mark in products)
                    else:
                        yield on_letters

    def _value(self, term: Term, shape: Term | None) -> int | None:
        """A random combination of the components at the points."""
        if shape is None:
            return None
        components = self.reader.screen.components(term, shape)
        if components is None or len(components) > len(self.weights):
            return None
        return sum(w * x for w, x in zip(self.weights, components, strict=False)) % PRIME


@dataclass(frozen=True)
class _Parts:
    """The addends of an equation with their signs and alternatives, those with few marks first. `context`:
    the marks outside of the addends."""

    context: Marks
    slots: list[tuple[int, list[_Alternative]]]

    def that_add_up(self) -> Iterator[Marks]:
        """Choices whose values add up to 0, the sums of one half of the addends looked up for the other."""
        if any(a.value is None for _, alternatives in self.slots for a in alternatives):
            return
        for width in _ROUNDS:
            cut = [(sign, alternatives[:width]) for sign, alternatives in self.slots]
            halves = [_sums(cut[::2]), _sums(cut[1::2])]
            if None in halves:
                return
            partners: dict[int, list[tuple[_Alternative, ...]]] = {}
            for value, chosen in halves[0]:
                partners.setdefault(-value % PRIME, []).append(chosen)
            fitting = [
                (*first, *second) for value, second in halves[1] for first in partners.get(value, ())
            ]
            fitting.sort(key=lambda chosen: sum(a.cost for a in chosen))
            yield from ((*self.context, *(m for a in chosen for m in a.marks)) for chosen in fitting)
            if fitting:
                return

    def cheapest(self, most: int) -> Iterator[Marks]:
        """Choices with the fewest marks."""
        ordered = [alternatives for _, alternatives in self.slots]
        start = (0,) * len(ordered)
        queue = [(sum(a[0].cost for a in ordered), start)]
        seen = {start}
        for _ in range(most):
            if not queue:
                return
            cost, places = heappop(queue)
            chosen = (a[place] for a, place in zip(ordered, places, strict=True))
            yield (*self.context, *(m for a in chosen for m in a.marks))
            for number, place in enumerate(places):
                if place + 1 < len(ordered[number]):
                    following = (*places[:number], place + 1, *places[number + 1 :])
                    if following not in seen:
                        seen.add(following)
                        more = ordered[number][place + 1].cost - ordered[number][place].cost
                        heappush(queue, (cost + more, following))


def _sums(
    slots: Sequence[tuple[int, list[_Alternative]]],
) -> list[tuple[int, tuple[_Alternative, ...]]] | None:
    """All sums of one alternative for each addend; None if they are too many."""
    sums: list[tuple[int, tuple[_Alternative, ...]]] = [(0, ())]
    for sign, alternatives in slots:
        if len(sums) * len(alternatives) > _MOST_SUMS:
            return None
        sums = [
            ((total + sign * a.value) % PRIME, (*chosen, a)) for total, chosen in sums for a in alternatives
        ]
    return sums


def _fits(term: Term, wanted: Term) -> bool:
    free = None in (term.weight, wanted.weight)
    return term.type.kind == wanted.type.kind and (free or term.weight == wanted.weight)


def _with_cost(letters: Sequence[list[Mark]], cost: int) -> Iterator[Marks]:
    """One mark or none on each letter, of this cost together."""
    if not letters:
        if cost == 0:
            yield ()
        return
    yield from _with_cost(letters[1:], cost)
    for mark in letters[0]:
        if mark.cost <= cost:
            yield from ((mark, *others) for others in _with_cost(letters[1:], cost - mark.cost))


def addends_of(node: Node) -> list[Node]:
    """The addends of a side, also those in brackets with only numbers and linear functions before them."""
    match node:
        case Sum(addends=addends):
            return [leaf for _, _, addend in addends for leaf in addends_of(addend)]
        case Bracket(parts=(part,)) | Group(parts=(part,)):
            return addends_of(part) if _holds_sum(part) else [node]
        case Fraction(numerator=numerator) if _holds_sum(numerator):
            return addends_of(numerator)
        case Product(items=items):
            sums = [item for item in items if _holds_sum(item)]
            if len(sums) == 1 and all(item is sums[0] or _is_plain(item) for item in items):
                return addends_of(sums[0])
    return [node]


def _holds_sum(node: Node) -> bool:
    match node:
        case Sum():
            return True
        case Bracket(parts=(part,)) | Group(parts=(part,)) | Fraction(numerator=part):
            return _holds_sum(part)
        case Product(items=items):
            return any(_holds_sum(item) for item in items)
    return False


def _is_plain(node: Node) -> bool:
    match node:
        case Leaf(kind="NUMBER"):
            return True
        case Leaf(kind="FUNCTION", text=text):
            return text in _LINEAR
        case Fraction():
            return all(isinstance(part, Fraction | Group) or _is_plain(part) for part in below(node))
    return False


def alone(side: Node, leaf: Node) -> Node:
    """The side with each sum around the leaf cut down to the addend that holds it."""
    cut: dict[int, Node] = {}
    sums = [part for part in below(side) if isinstance(part, Sum)]
    for node in reversed(sums):
        for sign, at, addend in node.addends:
            if any(part is leaf for part in below(addend)):
                cut[id(node)] = Sum(node.at, ((sign, at, exchanged(addend, cut)),))
                break
    return exchanged(side, cut)
