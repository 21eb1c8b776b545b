"""The subject of a formula: its free symbols, the symbols whose rates it contains, and its speech act."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

from workbench.context.facts import Act
from workbench.context.free_symbols import equations_of, free_in, parts_as_written, terms_of
from workbench.core.construct import apply, block, number, symbol, with_children, zero
from workbench.core.names import Name
from workbench.core.operations import PARTIALS
from workbench.core.terms import (
    Apply,
    Block,
    Derivative,
    IllFormed,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
    column_of_symbols,
    sides_of,
)
from workbench.core.types import SCALAR, VECTOR, Declaration, Type
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory, take_inventory
from workbench.language.definitions import Definitions
from workbench.language.function_places import function_of, is_elsewhere
from workbench.language.naming.symbols import SymbolTable


@dataclass(frozen=True)
class Subject:
    """A statement with the definitions in force.

    Attributes:
        bound: The symbols that a motion gives.
        framed: The symbols that frames and points give.
        moving: The symbols whose rates the text writes.
        ruled: The symbols whose rates a law of the text gives.
        assumed: The symbols of the equations that a model assumes for the statement.
        letters: Whether letters and accents are used as evidence.
        laws: Equations that give rates, which are unfolded as definitions are.
    """

    statement: Statement
    definitions: Definitions
    symbols: SymbolTable
    bound: frozenset[Name] = frozenset()
    framed: frozenset[Name] = frozenset()
    moving: frozenset[Name] = frozenset()
    ruled: frozenset[Name] = frozenset()
    assumed: frozenset[Name] = frozenset()
    letters: bool = True
    laws: tuple[Relation, ...] = ()

    @cached_property
    def free(self) -> list[Symbol]:
        """The undefined symbols that are not declared free, after unfolding definitions."""
        written = dict.fromkeys(term for term in terms_of(self.statement) if isinstance(term, Symbol))
        table = self.symbols.symbols
        names = {
            each
            for each in self.declarations
            if not (each.free or each.clock or each.name in self.assumed)
            and (each in self.written or each.name in table)
        }
        shown = [
            each
            for each in written
            if each.declaration in names and not each.arguments and not each.type.dual
        ]
        seen = {each.declaration for each in shown}
        behind = (each for each in names - seen if not (each.indices or each.parameters or each.type.dual))
        return [*shown, *(symbol(each) for each in sorted(behind, key=lambda each: str(each.name)))]

    @cached_property
    def written(self) -> set[Declaration]:
        """The declarations of the symbols that are written in the statement."""
        return {term.declaration for term in terms_of(self.statement) if isinstance(term, Symbol)}

    @cached_property
    def declarations(self) -> set[Declaration]:
        """The declarations of all free symbols, after unfolding definitions."""
        return free_in(sides_of(self.statement), self.definitions)

    @cached_property
    def moved(self) -> set[Declaration]:
        """The free symbols whose rates the statement contains."""
        return free_in(self.rates, self.definitions)

    @cached_property
    def rates(self) -> list[Term]:
        """The terms that the statement or its definitions differentiate by time."""
        parts = self.definitions.reached(*sides_of(self.statement))
        return list(dict.fromkeys(part.body for part in parts if isinstance(part, Derivative)))

    @cached_property
    def conditioned(self) -> set[Declaration]:
        """The functions for which the statement is a differential or orthogonality condition."""
        return conditioned(self.statement, self.definitions)

    @cached_property
    def orders(self) -> dict[Symbol, int]:
        """The highest order of differentiation of each symbol, with all definitions unfolded."""
        with suppress(NotExact, IllFormed):
            return dict(take_inventory(sides_of(self.statement), self.definitions).orders)
        return dict(Inventory().orders)

    @cached_property
    def act(self) -> tuple[Act, Symbol | None]:
        """The act of the author, and the symbol it is about; occurrences are counted in the unfolded
        statement.
        """
        if not isinstance(self.statement, Relation):
            return self._concluded
        if self.statement.operator not in ("=", "≈"):
            return Act.ASSERT, None
        left, right = self.statement.left, self.statement.right
        for one, other in ((left, right), (right, left)):
            own, order = derived(one)
            if own is None:
                continue
            if own.declaration.name in self.framed and not self._is_open_column(own):
                bodies = [each.body for each in self.definitions if each.declaration.name in self.framed]
                if free_in([other], self.definitions) - free_in(bodies, self.definitions):
                    return Act.CONSTRAIN, own
                continue
            if not self._may_be_given(own):
                continue
            highest = self._orders_in([other, *self._laws_behind([other])]).get(own)
            if highest is None:
                return (Act.POSTULATE if order else Act.DEFINE), own
            if highest < order:
                return Act.POSTULATE, own
        return self._constrained

    @property
    def _concluded(self) -> tuple[Act, Symbol | None]:
        """CONSTRAIN if a symbol of a concluded equation occurs once in the statement, else ASSERT."""
        equations = [term for each in equations_of(self.statement) for term in terms_of(each)]
        once = [each for each in self._single if each in equations]
        return (Act.CONSTRAIN, once[0]) if once else (Act.ASSERT, None)

    @property
    def _single(self) -> list[Symbol]:
        """The symbols that occur once in the statement and in no definition of its other symbols."""
        count: Counter[Symbol] = Counter()
        behind: Counter[Declaration] = Counter()
        sides = map(_without_zero_columns, sides_of(self.statement))
        for term in (part for side in sides for part in parts_as_written(side)):
            if isinstance(term, Symbol):
                count[term] += 1
                count.update([function_of(term)[0]] if is_elsewhere(term) else ())
                with suppress(IllFormed):
                    body = self.definitions.lookup(term)
                    behind.update(free_in([body], self.definitions) if body is not None else ())
        behind.update(free_in(self._laws_behind([*sides_of(self.statement)]), self.definitions))
        once = [
            each
            for each, number in count.items()
            if number == 1 and not behind[each.declaration] and self._may_be_given(each)
        ]
        once = [each for each in once if not any(o is not each and each in o.declaration.of for o in count)]
        return [each for each in once if not (self.rates and each.declaration.constant)]

    def free_in(self, side: Term) -> set[Declaration]:
        """Returns the free symbols of a side, with definitions and laws unfolded, and f for f(x + h)."""
        elsewhere = [part for part in side.walk() if isinstance(part, Symbol) and is_elsewhere(part)]
        functions = [function_of(part)[0] for part in elsewhere]
        return free_in([side, *functions, *self._laws_behind([side])], self.definitions)

    def _laws_behind(self, terms: Sequence[Term]) -> list[Term]:
        """Returns the sides of the laws for rates in the terms, and for rates in these laws."""
        found: list[Term] = []
        waiting = list(self.laws)
        while waiting:
            reached = self._orders_in([*terms, *found])
            used = [law for law in waiting if any(_gives_rate(side, reached) for side in sides_of(law))]
            if not used:
                break
            found += [side for law in used for side in sides_of(law)]
            waiting = [law for law in waiting if law not in used]
        return found

    @cached_property
    def constrained(self) -> list[Symbol]:
        """The symbols that an equation may say something of: those that stand once in it, or all that may be
        given if its sides have no common free symbol, or one of them is a number."""
        if self.conditioned:
            return _symbols_of(self.conditioned)[:1]
        if once := self._single:
            return once
        left, right = map(self.free_in, sides_of(self.statement))
        inside: list[Symbol] = []
        if left and right and left.isdisjoint(right):
            inside = self._symbols
        elif self._is_example:
            inside = _symbols_of(left | right)
        return [each for each in inside if self._may_be_given(each)]

    @property
    def _constrained(self) -> tuple[Act, Symbol | None]:
        """CONSTRAIN for an equation that may say something of a symbol; ASSERT for any other."""
        assert isinstance(self.statement, Relation)
        kind = self.statement.left.type
        best = min(self.constrained, key=lambda each: each.type != kind, default=None)
        return (Act.ASSERT, None) if best is None else (Act.CONSTRAIN, best)

    @property
    def _symbols(self) -> list[Symbol]:
        return list(dict.fromkeys(term for term in terms_of(self.statement) if isinstance(term, Symbol)))

    @property
    def _is_example(self) -> bool:
        """True if one side is a matrix of numbers, or a number opposite a symbol alone."""
        left, right = sides_of(self.statement)
        if _is_value(left) != _is_value(right):
            return True
        pairs = ((left, right), (right, left))
        return any(isinstance(one, Symbol) and _is_number(other) for one, other in pairs)

    def _may_be_given(self, own: Symbol) -> bool:
        """True if a formula may give the value of the symbol."""
        declared = own.declaration
        if self._is_open_column(own):
            return True
        if self._is_expansion and (is_elsewhere(own) or declared.small):  # f(x + s) follows from f
            return False
        if declared.free or declared.clock or declared.name in self.bound or declared.name in self.framed:
            return False
        return declared in free_in([own], self.definitions) and not self.definitions.is_pi(declared)

    @cached_property
    def _is_expansion(self) -> bool:
        """True for ≈ with a value f(x + s)."""
        is_near = isinstance(self.statement, Relation) and self.statement.operator == "≈"
        parts = (part for side in sides_of(self.statement) for part in side.walk())
        return is_near and any(map(is_elsewhere, parts))

    def _is_open_column(self, own: Symbol) -> bool:
        """True if the symbol is a column of components that occur nowhere else."""
        bodies = [each.body for each in self.definitions.about(own)]
        parts = _components_of(bodies[0]) if len(bodies) == 1 and not own.index else ()
        entries = {part.declaration for part in parts if not part.declaration.free}
        if not entries:
            return False
        others = [term for term in terms_of(self.statement) if isinstance(term, Symbol) and term != own]
        return entries <= self.declarations and entries.isdisjoint(free_in(others, self.definitions))

    def _orders_in(self, terms: Sequence[Term]) -> dict[Symbol, int]:
        written = dict.fromkeys(self.definitions.symbols_in(*terms), 0)  # x > 0 may be a square elsewhere
        with suppress(NotExact, IllFormed):
            orders = dict(take_inventory(terms, self.definitions, slopes=False).orders)
            return {part: 0 for part in written if part.declaration.positive} | orders
        return written


def _without_zero_columns(term: Term) -> Term:
    """Returns the term without the rows of a matrix that a matrix before it multiplies by 0."""
    if not any(isinstance(part, Zero) for part in term.walk()):
        return term
    made = with_children(term, _without_zero_columns)
    match made:
        case Apply(head="mul", arguments=(Block(entries=left), Block(entries=right))) if len(left[0]) == len(
            right
        ):
            kept = [any(not isinstance(row[at], Zero) for row in left) for at in range(len(right))]
            rows = [
                row if keep else [zero(each.type) for each in row]
                for row, keep in zip(right, kept, strict=True)
            ]
            return apply("mul", made.children[0], block(rows))
    return made


def derived(term: Term) -> tuple[Symbol | None, int]:
    """Returns x and the order for x, ẋ, ẍ and the column (p, 1) of a point; else (None, 0)."""
    if isinstance(term, Symbol):
        return term, 0
    if isinstance(term, Derivative) and isinstance(term.body, Symbol) and term.order.is_number:
        return term.body, int(term.order)
    if isinstance(term, Block) and term.type == Type(4, 1):
        places = [each for each in term.children if not isinstance(each, Number | Zero)]
        return derived(places[0]) if len(places) == 1 else (None, 0)
    return None, 0


def _gives_rate(side: Term, orders: Mapping[Symbol, int]) -> bool:
    """True if a side is a rate that the orders reach, perhaps with factors."""
    if isinstance(side, Apply) and side.head in ("mul", "neg", "div"):
        rates = [part for part in side.arguments if any(isinstance(each, Derivative) for each in part.walk())]
        return len(rates) == 1 and _gives_rate(rates[0], orders)
    own, order = derived(side)
    return own is not None and 0 < order <= orders.get(own, 0)


def _symbols_of(declarations: Collection[Declaration]) -> list[Symbol]:
    """Returns the symbols of declarations by name; families and functions have more than one each."""
    single = (each for each in declarations if not (each.indices or each.parameters))
    return [symbol(each) for each in sorted(single, key=lambda each: str(each.name))]


def _components_of(body: Term) -> tuple[Symbol, ...]:
    """Returns the symbols of a column of symbols, or of x i + y j + z k."""
    addends = body.arguments if isinstance(body, Apply) and body.head == "add" else ()
    factors = [part for each in addends for part in each.children]
    along = tuple(part for part in factors if isinstance(part, Symbol) and part.type == SCALAR)
    is_sum = len(set(along)) == len(addends) > 1 and body.type.is_column
    return along if is_sum else column_of_symbols(body)


def _is_value(term: Term) -> bool:
    """True if the term is a matrix or quaternion of numbers other than 0 and 1."""
    is_one = (
        isinstance(term, Apply) and term.head == "quaternion" and term.arguments == (number(1), zero(VECTOR))
    )
    parts = [] if is_one or term.type.rows == 1 == term.type.columns else list(term.walk())
    has_symbol = any(isinstance(part, Symbol) for part in parts)
    return any(isinstance(part, Number) for part in parts) and not has_symbol


def _is_number(term: Term) -> bool:
    """True if the term consists of numbers and is not 0."""
    parts = list(term.walk())
    has_number = any(isinstance(part, Number) and part.value != 0 for part in parts)
    return has_number and not any(isinstance(part, Symbol) for part in parts)


def conditioned(statement: Statement, definitions: Definitions) -> set[Declaration]:
    """Returns the undefined functions whose slopes the statement equates to a number, as e_n · e_m = 0 does
    in orthogonal coordinates.
    """
    known = {definition.declaration.name for definition in definitions}
    found: set[Declaration] = set()
    for equation in equations_of(statement):
        sides = (equation.left, equation.right)
        if all(any(isinstance(part, Symbol) for part in side.walk()) for side in sides):
            continue
        parts = list(definitions.reached(*sides))
        if any(isinstance(part, Apply) and part.head in PARTIALS for part in parts):
            symbols = (part.declaration for part in parts if isinstance(part, Symbol))
            found |= {each for each in symbols if each.of and not each.free and each.name not in known}
    return found


def names_of(declarations: Sequence[Declaration] | set[Declaration]) -> frozenset[Name]:
    return frozenset(each.name for each in declarations)
