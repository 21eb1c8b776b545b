"""Readings of an ill-typed formula, by corrections of what its printing may have lost.

An equation is split into addends. Each addend has alternatives: the marks that give it the type and weight of
the other side. The search chooses one alternative for each addend such that they add up to the other side at
random points modulo the prime; it also yields those with the fewest marks, regardless of their sum.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import combinations, islice, product
from random import Random

from workbench.context.claims import Claim
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.terms import Conjunction, IllFormed, Statement, Term
from workbench.core.types import Weight
from workbench.engines.jet.rings import PRIME
from workbench.language.elaboration.statements import reading_of
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import Chain, Fraction, Node, Styled, Sum
from workbench.language.naming.linear_indices import linear
from workbench.repair.screening.addend_choices import AddendChoices, Alternative, Marks
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.changes import Candidate, Change
from workbench.repair.trees.addend_nodes import addends_of, alone
from workbench.repair.trees.letter_candidates import is_rate
from workbench.repair.trees.lost_marks import (
    Mark,
    all_marks,
    letter_marks,
    marked,
    marked_lines,
    product_marks,
)
from workbench.repair.trees.misplaced_factors import factor_marks, index_marks, letters_of
from workbench.repair.trees.misprinted_integers import bound_variables, integer_marks
from workbench.repair.trees.misspellings import Spelling, spellings
from workbench.repair.trees.shared_terms import RememberingElaborator
from workbench.repair.trees.tree_nodes import below, hole

#: The most misprints corrected in one addend, and the most alternatives of one addend that are read.
MOST_MARKS = 4
MOST_READ = 1500
MOST_CHOICES = 40_000

#: The most misprints corrected in an addend that has the right type and weight as printed, by stage.
DEPTHS = (1, 3)

#: The most alternatives of an addend with equal values.
_MOST_ALIKE = 2

_MOST_PAIRS = 3000


class Readings:
    """The readings of an ill-formed claim. tick: called now and then; may raise to end the search."""

    def __init__(self, claim: Claim, screen: Screen | None, tick: Callable[[], None]) -> None:
        integers = frozenset(claim.orders.variables if claim.orders else ())
        spelled = spellings(claim.printed.latex, claim.notation.symbols, integers)
        self._readers = [_Reader(claim, spelling, screen, tick) for spelling in spelled]
        self._seen: set[Statement] = set()

    def that_hold(self) -> Iterator[Iterator[Candidate]]:
        """Yields, stage by stage, equations that hold at the screen's points, those with few marks first."""
        yield (c for reader in self._readers for c in self._candidates(reader, reader.as_it_is()))
        for depth in DEPTHS:
            for reader in self._readers:
                yield self._candidates(reader, reader.that_add_up(depth))

    def likeliest(self, most: int) -> Iterator[Candidate]:
        """Yields up to `most` readings with few marks, true or not."""
        for number, reader in enumerate(self._readers[:most]):
            share = -(-most // len(self._readers)) if number else max(2, most // len(self._readers[:4]))
            yield from islice(self._candidates(reader, reader.few_marks(most)), share)

    def _candidates(self, reader: _Reader, choices: Iterator[Marks]) -> Iterator[Candidate]:
        for marks in choices:
            statement = reader.statement(marks)
            if statement is not None and statement not in self._seen:
                self._seen.add(statement)
                changes = tuple(Change(mark.kind, mark.description) for mark in marks)
                latex = latex_of(marked(marks, reader.lines))
                dear = sum(mark.cost - 1 for mark in marks)
                yield Candidate(statement, (*reader.changes, *changes), latex, (dear,))


class _Reader:
    """One spelling of a formula, with its integers."""

    def __init__(
        self, claim: Claim, spelling: Spelling, screen: Screen | None, tick: Callable[[], None]
    ) -> None:
        self.table = claim.notation.symbols
        self.lines, self.changes = spelling.lines, spelling.changes
        self.screen, self.tick = screen, tick
        self.integers = frozenset(claim.orders.variables if claim.orders else ())
        self._elaborator = RememberingElaborator(self.table, self.integers)
        self._taken_apart: list[AddendChoices] = []
        self.letters = [
            (letter, self._weight(term))
            for letter in letters_of(self.lines)
            if (term := self.term(letter)) is not None
        ]

    def statement(self, marks: Sequence[Mark]) -> Statement | None:
        self.tick()
        try:
            found = reading_of(marked_lines(marks, self.lines), self.table, self.integers).statements
        except (Fault, TypeMismatch, IllFormed):
            return None
        return found[0] if len(found) == 1 else Conjunction(found)

    def term(self, node: Node) -> Term | None:
        self.tick()
        try:
            return self._elaborator.term(node)
        except (Fault, TypeMismatch, IllFormed):
            return None

    @staticmethod
    def _weight(term: Term) -> int | None:
        return None if term.weight is None or not term.weight.is_number else int(term.weight)

    def as_it_is(self) -> Iterator[Marks]:
        """Yields no marks, if the equation holds at the points as it is."""
        if self.screen is None or not self.changes:
            return
        statement = self.statement(())
        residual = None if statement is None else self.screen.residual(statement)
        if residual is not None and not any(residual):
            yield ()

    def that_add_up(self, depth: int) -> Iterator[Marks]:
        """Yields marks with which the equations hold.

        depth: the most marks that are tried on an addend that is well-typed by itself.
        """
        self._taken_apart = []
        ways = [self._of_equation(equation, depth) for equation in self._equations()]
        if len(ways) == 1:
            yield from ways[0]
        elif ways:
            yield from (tuple(m for marks in chosen for m in marks) for chosen in product(*map(list, ways)))

    def _of_equation(self, equation: Chain, depth: int) -> Iterator[Marks]:
        for parts in _Equation(self, equation, depth).taken_apart():
            self._taken_apart.append(parts)
            yield from parts.that_add_up()

    def few_marks(self, most: int) -> Iterator[Marks]:
        if self.statement(()) is not None:
            yield ()
        for parts in self._taken_apart:
            yield from parts.cheapest(most)
        if not self._taken_apart:
            yield from self._anywhere()

    def _equations(self) -> list[Chain]:
        """Returns the equations to correct: for a = b = c, each side that is unreadable or does not fit, with
        one that is readable."""
        chains = [c for line in self.lines.lines for c in line if isinstance(c, Chain) and c.relations]
        chains = [c for c in chains if all(sign == "=" for sign, _ in c.relations) and not _is_bound(c)]
        screen = self.screen
        if len(chains) != 1 or screen is None:
            return []
        (chain,) = chains
        if len(chain.sides) == 2:
            return [chain]
        terms = [self.term(side) for side in chain.sides]
        good = next(((number, term) for number, term in enumerate(terms) if term is not None), None)
        if good is None:
            return []
        number, read = good
        bad = [n for n, term in enumerate(terms) if not _agree(screen, read, term)]
        return [Chain(chain.at, (chain.sides[number], chain.sides[n]), chain.relations[:1]) for n in bad]

    def _anywhere(self) -> Iterator[Marks]:
        """Yields one or two marks anywhere, for statements that are no equations."""
        single = sorted(all_marks(self.lines, self.table), key=lambda mark: mark.cost)
        yield from ((mark,) for mark in single if mark.cost <= 2)
        cheap = [mark for mark in single if mark.cost == 1]
        for count, pair in enumerate(combinations(cheap, 2)):
            if count == _MOST_PAIRS:
                return
            yield pair


def _agree(screen: Screen, good: Term, other: Term | None) -> bool:
    """True if two sides agree in type, weight and value at the points."""
    if other is None or not _fits(other, good):
        return False
    values = screen.components(good, good), screen.components(other, good)
    return None not in values and values[0] == values[1]


def _is_bound(chain: Chain) -> bool:
    r"""True for n = \overline{1, m}."""
    return any(isinstance(side, Styled) and side.style == "\\overline" for side in chain.sides)


class _Equation:
    """An equation left = right with at least one unreadable side."""

    def __init__(self, reader: _Reader, chain: Chain, depth: int) -> None:
        self.reader, self.chain, self.depth = reader, chain, depth
        self.variables = reader.integers | bound_variables(chain)
        random = Random(61)
        self.weights = [random.randrange(PRIME) for _ in range(400)]
        self._known: dict[tuple, list[Marks]] = {}

    def taken_apart(self) -> Iterator[AddendChoices]:
        """Yields the alternatives of all addends, for each way to read the denominators."""
        for context in self._contexts():
            printed = [self._slots(side, context, None) for side in self.chain.sides]
            whole = [slots[0][0].term for slots in printed if len(slots) == 1 and slots[0]]
            apart = self.depth > 1 and len(whole) == 2 and _fits(*whole)
            for wanted in self._wanted(printed):
                slots = []
                for sign, side in zip((1, -1), self.chain.sides, strict=True):
                    found = self._slots(side, context, wanted, apart)
                    slots += [(sign, alternatives) for alternatives in found]
                if all(alternatives for _, alternatives in slots):
                    yield AddendChoices(context, slots)

    def _contexts(self) -> Iterator[Marks]:
        """Yields the marks that make the denominators readable."""
        ways: list[list[Marks]] = []
        for part in below(self.chain):
            if not isinstance(part, Fraction) or is_rate(part):
                continue
            if self.reader.term(part.denominator) is None:
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

    def _slots(
        self, side: Node, context: Marks, wanted: Term | None, apart: bool = False
    ) -> list[list[Alternative]]:
        """Returns the alternatives of each addend of a side.

        A side that fits has only itself as an alternative, unless `apart`.

        wanted: a term of the required type and weight; if None, only readings as printed are returned.
        """
        whole = self.reader.term(marked(context, side))
        if whole is not None and not apart and (wanted is None or _fits(whole, wanted)):
            return [[Alternative((), whole, self._value(whole, wanted))]]
        return [self._alternatives(side, leaf, context, wanted) for leaf in addends_of(side)]

    def _wanted(self, found: Sequence[list[list[Alternative]]]) -> list[Term]:
        """Returns terms of the types and weights that both sides may have.

        These are those of a readable whole side, or those of most addends.
        """
        whole = [slots[0][0].term for slots in found if len(slots) == 1 and slots[0]]
        if len(whole) == 2 and not _fits(*whole):
            return whole
        whole = [t for t in whole if t.weight is not None]
        if whole:
            return whole[:1]
        terms = [a.term for slots in found for alternatives in slots for a in alternatives]
        terms = [t for t in terms if t.weight is not None] or terms
        return [max(terms, key=lambda t: sum(_fits(t, other) for other in terms))] if terms else []

    def _alternatives(self, side: Node, leaf: Node, context: Marks, wanted: Term | None) -> list[Alternative]:
        found: dict[object, list[Alternative]] = {}
        most, read = MOST_MARKS, 0
        offset: int | None = None
        nodes = set(map(id, below(leaf)))
        within = tuple(mark for mark in context if id(mark.old) in nodes)
        around = [mark for mark in context if mark not in within]
        fill = hole(alone(marked(around, side), leaf), leaf)
        is_one_product = not any(isinstance(p, Sum) and not self._is_integer(p) for p in below(leaf))
        for marks in self._readable(leaf, wanted) if wanted is not None else [()]:
            if read == MOST_READ or sum(mark.cost for mark in marks) > most:
                break
            dots = _dots(marks) if is_one_product else None
            if None not in (dots, offset) and dots != offset:
                continue
            read += 1
            term = self.reader.term(fill(marked((*within, *marks), leaf)))
            if term is not None and wanted is not None and dots is not None:
                offset = _offset(dots, wanted.weight, term.weight, offset)
            if term is None or (wanted is not None and not _fits(term, wanted)):
                continue
            value = self._value(term, wanted)
            if not marks:
                most = self.depth  # it is well-typed by itself
            alike = found.setdefault(term if value is None else value, [])
            if len(alike) < _MOST_ALIKE and term not in [a.term for a in alike]:
                alike.append(Alternative(marks, term, value))
        alternatives = [alternative for alike in found.values() for alternative in alike]
        if wanted is not None:
            self._known[id(leaf), wanted.type.kind, wanted.weight] = [a.marks for a in alternatives]
        return sorted(alternatives, key=lambda alternative: alternative.cost)

    def _readable(self, leaf: Node, wanted: Term) -> Iterable[Marks]:
        """Returns the marks to try on an addend; with further denominators, only those that were readable
        before."""
        known = self._known.get((id(leaf), wanted.type.kind, wanted.weight))
        return islice(self._choices(leaf), MOST_CHOICES) if known is None else known

    def _is_integer(self, node: Node) -> bool:
        try:
            return linear(node, self.variables) is not None
        except Fault:
            return False

    def _choices(self, leaf: Node) -> Iterator[Marks]:
        """Yields combinations of marks by cost: one on each letter and integer, and one on the products."""
        table = self.reader.table
        places = [*letter_marks(leaf, table), *index_marks(leaf, table), *integer_marks(leaf, self.variables)]
        products = [*factor_marks(leaf, self.reader.letters), *product_marks(leaf)]
        for cost in range(MOST_MARKS + 1):
            for on_products in sorted(range(min(cost, 2) + 1), key=lambda n: n != 2):  # one mark for two
                for on_letters in _with_cost(places, cost - on_products):
                    if on_products:
                        yield from ((*on_letters, m) for m in products if m.cost == on_products)
                    else:
                        yield on_letters

    def _value(self, term: Term, shape: Term | None) -> int | None:
        """Returns a random combination of the components at the points."""
        screen = self.reader.screen
        if shape is None or screen is None:
            return None
        components = screen.components(term, shape)
        if components is None or len(components) > len(self.weights):
            return None
        return sum(w * x for w, x in zip(self.weights, components, strict=False)) % PRIME


def _dots(marks: Sequence[Mark]) -> int | None:
    """Returns the number of dots that the marks add; None if a mark changes the weight otherwise."""
    dots = 0
    for mark in marks:
        if mark.dots is None:
            return None
        dots += mark.dots
    return dots


def _offset(dots: int, wanted: Weight, weight: Weight, before: int | None) -> int | None:
    """Returns the number of dots that a term of this weight needs; `before` if it has no weight."""
    if wanted is None or weight is None:
        return before
    lacking = wanted - weight
    return dots + int(lacking) if lacking.is_number else None


def _fits(term: Term, wanted: Term) -> bool:
    """True if the terms may be equated; a tensor may be with an operator."""
    free = None in (term.weight, wanted.weight)
    kinds = {term.type.kind, wanted.type.kind}
    is_same = len(kinds) == 1 or kinds == {"tensor", "operator"}
    return is_same and (free or term.weight == wanted.weight)


def _with_cost(letters: Sequence[list[Mark]], cost: int) -> Iterator[Marks]:
    """Yields at most one mark for each letter, with this total cost."""
    if not letters:
        if cost == 0:
            yield ()
        return
    yield from _with_cost(letters[1:], cost)
    for mark in letters[0]:
        if mark.cost <= cost:
            yield from ((mark, *others) for others in _with_cost(letters[1:], cost - mark.cost))
