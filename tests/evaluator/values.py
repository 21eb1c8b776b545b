"""What a formula is worth: numbers for its symbols, nothing symbolic, nothing of the judge.

    world = World(definitions, seed=3)
    world.holds(statement, {"n": 2})       # True, False, or None where a side is undefined

A free symbol is a random curve: its Taylor series in the time t, to 30 digits. Every number is such a series
over the dual numbers, so that a derivative is a shift, div and curl are dual parts, and a unit vector or a
rotation is a curve divided by its length. A statement with an integer n is evaluated at n by counting, never
by rewriting it. An identity that is false is so at almost every such point; one that holds, holds at all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from itertools import combinations, pairwise
from itertools import product as iterate
from math import factorial
from random import Random

from evaluator.curves import drawn
from evaluator.operations import applied, counted
from evaluator.series import (
    DIGITS,
    LENGTH,
    TOLERANCE,
    Matrix,
    NotRead,
    Operator,
    Series,
    Undefined,
    acted,
    added,
    added_up,
    constant,
    dot,
    each,
    hamilton,
    inverse,
    nothing,
    product,
    scaled,
    unit,
)
from mpmath import mp, mpf

from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Conjunction,
    Counting,
    Definition,
    Derivative,
    DualUnit,
    Equivalence,
    Identity,
    Implication,
    Integer,
    Number,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)

Integers = Mapping[str, int]

#: What is small beside 1.
NEAR = mpf(10) ** -8


class World:
    """Curves for all free symbols, drawn when they are first needed. `fixed`: name → numbers, by components,
    that a symbol has at t = 0; its derivatives stay random. `length`: how many Taylor coefficients are drawn.
    `own`: the value of a symbol by its name, whatever its definition says."""

    def __init__(
        self,
        definitions: Iterable[Definition] = (),
        seed: int = 0,
        fixed: Mapping[str, tuple[object, ...]] | None = None,
        length: int = LENGTH,
        own: Callable[[World, str], Matrix | None] | None = None,
    ) -> None:
        mp.dps = DIGITS
        self._random = Random(seed)
        self._definitions = tuple(definitions)
        self._fixed = dict(fixed or {})
        self._length, self._own = length, own
        self._drawn: dict[str, Matrix] = {}
        self._known: dict[tuple[str, int | None], Matrix | Operator] = {}
        self._moved: int | None = None  # along which axis a place is moved, for div and curl
        self._pushed: tuple[str, int, int] | None = None  # name, order, component: moved by ε tᵏ/k!
        self._stepped: tuple[str, int, mpf] | None = None  # name, component: moved by this number
        self._functions: dict[str, list[list[tuple[mpf, tuple[int, ...]]]]] = {}
        self._arguments: dict[str, Matrix] = {}
        self._smallness = mpf(1)

    # statements

    def holds(self, statement: Statement, integers: Integers | None = None) -> bool | None:
        """Whether it is true at t = 0; None where it is undefined there."""
        at = dict(integers or {})
        try:
            match statement:
                case Relation(operator="≈"):
                    return self._close(statement.left, statement.right, at)
                case Relation(operator=operator):
                    return self._zero(statement.left, statement.right, at) == (operator == "=")
                case Conjunction(parts=parts):
                    said = [self.holds(part, at) for part in parts]
                    return False if False in said else None if None in said else True
                case Implication(left=left, right=right):
                    return self.holds(right, at) if self.holds(left, at) else True
                case Equivalence(left=left, right=right):
                    one, other = self.holds(left, at), self.holds(right, at)
                    return None if None in (one, other) else one == other
        except Undefined:
            return None
        raise NotRead("a statement of this kind")

    def _close(self, left: Term, right: Term, at: Integers) -> bool:
        """Whether the sides differ by what is of second order, where all that is small is of order 10⁻⁸."""
        self._smallness, self._drawn, self._known = NEAR, {}, {}
        pairs = zip(self.value(left, at), self.value(right, at), strict=True)
        gaps = [(x - y).re[0] for rows in pairs for x, y in zip(*rows, strict=True)]
        return all(abs(gap) <= NEAR * NEAR * 10**5 for gap in gaps)

    def _zero(self, left: Term, right: Term, at: Integers) -> bool:
        a, b = self.value(left, at), self.value(right, at)
        if callable(a) or callable(b):
            test = [[self._curve()] for _ in range(3)]
            a, b = (x(test) if callable(x) else product(x, test) for x in (a, b))
        size = max(
            [mpf(1)]
            + [abs(part[0]) for m in (a, b) for row in m for x in row for part in (x.re, x.du) if part]
        )
        gaps = [x - y for rows in zip(a, b, strict=True) for x, y in zip(*rows, strict=True)]
        return all(abs(part[0]) <= TOLERANCE * size for gap in gaps for part in (gap.re, gap.du) if part)

    # symbols

    def _curve(self) -> Series:
        def number() -> mpf:
            return mpf(self._random.randint(-999, 999)) / 389

        return Series(tuple(number() for _ in range(self._length)))

    def _symbol(self, symbol: Symbol, at: Integers) -> Matrix | Operator:
        declaration = symbol.declaration
        if declaration.name in self._arguments:
            return self._arguments[declaration.name]
        index = [_integer(i, at) for i in symbol.index]
        if any(i < 0 for i in index):
            raise NotRead("a negative index")
        name = _spelled(declaration.name, index)
        if self._own is not None and (value := self._own(self, name)) is not None:
            return value
        is_still = not (self._pushed or self._stepped)
        if not symbol.arguments and is_still and (name, self._moved) in self._known:
            return self._known[name, self._moved]
        found = self._defined(symbol, name, index, at)
        if found is None:
            found = self._free(symbol, name)
        if not symbol.arguments and not self._arguments and is_still:
            self._known[name, self._moved] = found
        return found

    def named(self, name: str) -> Matrix:
        """The value of a free symbol that stands in the definitions."""
        parts = (part for definition in self._definitions for part in definition.body.walk())
        return self._symbol(
            next(p for p in parts if isinstance(p, Symbol) and str(p.declaration.name) == name), {}
        )

    def _defined(self, symbol: Symbol, name: str, index: list[int], at: Integers) -> Matrix | Operator | None:
        """By the definition of this very member, or else by one that reaches it from n = 0 on."""
        for definition in sorted(self._definitions, key=lambda d: sum(not i.is_number for i in d.index)):
            values: dict[str, int] = {}
            if all(i.is_number for i in definition.index):
                if _spelled(definition.declaration.name, [int(i) for i in definition.index]) != name:
                    continue
            elif definition.declaration.name != symbol.declaration.name:
                continue
            else:
                pairs = list(zip(definition.index, index, strict=True))
                if any(i.is_number and int(i) != wanted for i, wanted in pairs):
                    continue
                values = {v: wanted - i.constant for i, wanted in pairs for v in i.variables}
                if any(value < 0 for value in values.values()):
                    continue
            outer = self._arguments
            inner = [self.value(argument, at) for argument in symbol.arguments]
            self._arguments = {p.name: v for p, v in zip(definition.parameters, inner, strict=True)}
            found = self.value(definition.body, values)
            self._arguments = outer
            return found
        return None

    def _free(self, symbol: Symbol, name: str) -> Matrix:
        if symbol.declaration.of:
            return self._function(symbol, name)
        if symbol.declaration.clock and name not in self._drawn:
            rest = (mpf(0),) * (self._length - 2)
            self._drawn[name] = [[Series((self._curve().re[0], mpf(1), *rest))]]
        if name not in self._drawn:
            self._drawn[name] = drawn(symbol, self._curve, self._fixed.get(name))
            if symbol.declaration.small:
                self._drawn[name] = scaled(self._drawn[name], self._smallness)
        found = self._drawn[name]
        if self._stepped is not None and self._stepped[0] == name:
            _, place, step = self._stepped
            found = added(found, [[constant(step if i == place else 0)] for i in range(len(found))])
        if symbol.declaration.coordinate and self._moved is not None:
            step = [[constant(0, int(i == self._moved))] for i in range(3)]
            return added(found, step)
        if self._pushed is not None and self._pushed[0] == name:
            _, order, component = self._pushed
            size = len(found[0][0].re)
            push = tuple(mpf(int(k == order)) / factorial(order) for k in range(size))
            still = (mpf(0),) * size
            moved = [[Series(still, push if i == component else still)] for i in range(len(found))]
            return added(found, moved)
        return found

    def _function(self, symbol: Symbol, name: str) -> Matrix:
        """A random polynomial of what it is `of`, of degree 3."""
        columns = [self._symbol(argument, {}) for argument in symbol.declaration.of]
        places = [entry for column in columns for (entry,) in column]
        rows, width = symbol.type.rows, symbol.type.columns
        powers = [p for p in iterate(range(4), repeat=len(places)) if sum(p) <= 3]
        if name not in self._functions:
            self._functions[name] = [[(self._curve().re[0], p) for p in powers] for _ in range(rows * width)]

        def value(terms: list[tuple[mpf, tuple[int, ...]]]) -> Series:
            addends = []
            for factor, exponents in terms:
                total = constant(factor)
                for place, exponent in zip(places, exponents, strict=True):
                    for _ in range(exponent):
                        total = total * place
                addends.append(total)
            return added_up(addends)

        flat = [value(terms) for terms in self._functions[name]]
        return [flat[i * width : (i + 1) * width] for i in range(rows)]

    # terms

    def value(self, term: Term, at: Integers) -> Matrix | Operator:
        """The value with the integer variables put to `at`."""
        if term.type.kind == "operator":
            return self._operator(term, at)
        match term:
            case Number(value=value):
                return [[constant(mpf(value.numerator) / value.denominator)]]
            case Integer(value=value):
                return [[constant(_integer(value, at))]]
            case Counting(name=name, arguments=arguments):
                return [[constant(counted(name, [_integer(a, at) for a in arguments]))]]
            case Zero():
                return nothing(term.type.rows, term.type.columns)
            case Identity():
                return unit(term.type.rows)
            case DualUnit():
                return [[constant(0, 1)]]
            case Symbol():
                return self._symbol(term, at)
            case Derivative(body=body, order=order):
                times = _integer(order, at)
                return each(self.value(body, at), lambda x: x.rate(times))
            case Power():
                return self._power(term, at)
            case BigSum():
                return self._big_sum(term, at)
            case Block(entries=entries):
                return self._block(entries, at)
            case Apply():
                return self._apply(term, at)
        raise NotRead(f"a {type(term).__name__}")

    def _power(self, term: Power, at: Integers) -> Matrix:
        base, exponent = self.value(term.base, at), _integer(term.exponent, at)
        if exponent < 0:
            raise NotRead("a negative power")
        if term.base.type.is_column:
            if exponent % 2:
                raise NotRead("an odd power of a vector")
            base, exponent = dot(base, base), exponent // 2
        is_quaternion = term.base.type.kind == "quaternion"
        total = [[constant(int(i == 0))] for i in range(4)] if is_quaternion else unit(len(base))
        for _ in range(exponent):
            total = hamilton(total, base) if is_quaternion else product(total, base)
        return total

    def _big_sum(self, term: BigSum, at: Integers) -> Matrix | Operator:
        upper, names = _integer(term.upper, at), term.variables
        if term.lower is not None:
            choices = [(k,) for k in range(_integer(term.lower, at), upper + 1)]
        else:
            bars = combinations(range(upper + len(names) - 1), len(names) - 1) if upper >= 0 else ()
            ends = [(-1, *bar, upper + len(names) - 1) for bar in bars]
            choices = [tuple(b - a - 1 for a, b in pairwise(end)) for end in ends]
        total = nothing(term.type.rows, term.type.columns)
        for choice in choices:
            addend = self.value(term.body, {**at, **dict(zip(names, choice, strict=True))})
            total = added(total, addend)
        return total

    def _block(self, entries: tuple[tuple[Term, ...], ...], at: Integers) -> Matrix:
        rows: Matrix = []
        for row in entries:
            values = [self.value(entry, at) for entry in row]
            rows += [[x for value in values for x in value[i]] for i in range(len(values[0]))]
        return rows

    def _operator(self, term: Term, at: Integers) -> Operator:
        match term:
            case TimeOperator():
                return lambda x: each(x, lambda entry: entry.rate())
            case Zero():
                return lambda x: each(x, lambda entry: entry - entry)
            case Identity():
                return lambda x: x
            case Symbol():
                found = self._symbol(term, at)
                return found if callable(found) else lambda x: product(found, x)
            case Power(base=base, exponent=exponent):
                once, times = self._acting(base, at), _integer(exponent, at)

                def repeated(x: Matrix) -> Matrix:
                    for _ in range(times):
                        x = once(x)
                    return x

                return repeated
            case BigSum(variables=(name,), lower=Linear() as lower, upper=upper, body=body):
                values = range(_integer(lower, at), _integer(upper, at) + 1)
                parts = [self._acting(body, {**at, name: k}) for k in values]
                return lambda x: acted([part(x) for part in parts], x)
            case Apply(head="add", arguments=arguments):
                parts = [self._acting(a, at) for a in arguments]
                return lambda x: acted([part(x) for part in parts], x)
            case Apply(head="neg", arguments=(inner,)):
                inside = self._acting(inner, at)
                return lambda x: each(inside(x), lambda entry: -entry)
            case Apply(head="div", arguments=(top, bottom)):
                inside, factor = self._acting(top, at), inverse(self.value(bottom, at))
                return lambda x: product(factor, inside(x))
            case Apply(head="mul" | "compose", arguments=(left, right)):
                outer, inner = self._acting(left, at), self._acting(right, at)
                return lambda x: outer(inner(x))
        raise NotRead(f"the operator {term}")

    def _acting(self, term: Term, at: Integers) -> Operator:
        found = self.value(term, at)
        return found if callable(found) else lambda x: product(found, x)

    def _apply(self, term: Apply, at: Integers) -> Matrix:
        head = term.head
        if head in ("divergence", "curl"):
            return self._gradient(head, term.arguments[0], at)
        if head in ("partial", "total"):
            return self._partial(*term.arguments, at)
        values = [self.value(argument, at) for argument in term.arguments]
        return applied(term, values)

    def _partial(self, body: Term, by: Term, at: Integers) -> Matrix:
        """∂b/∂x⁽ᵏ⁾ = Sₖ − Σ ∂b/∂x⁽ʲ⁾ tᵏ⁻ʲ/(k−j)! over j < k, where Sₖ is what b changes by if x is moved by
        ε tᵏ/k!."""
        order = 0
        while isinstance(by, Derivative):
            by, order = by.body, order + _integer(by.order, at)
        if self._pushed is not None or not isinstance(by, Symbol) or by.declaration.of:
            raise NotRead("a partial derivative by what is no symbol")
        name = _spelled(by.declaration.name, [_integer(i, at) for i in by.index])
        if self._defined(by, name, [_integer(i, at) for i in by.index], at) is not None:
            raise NotRead("a partial derivative by what is defined")
        if any(isinstance(part, Apply) and part.head in ("partial", "total") for part in body.walk()):
            return self._of_slopes(body, by, name, order, at)
        columns = []
        for component in range(by.type.rows):
            lower: list[Matrix] = []
            for k in range(order + 1):
                self._pushed = (name, k, component)
                moved = each(self.value(body, at), lambda x: Series(x.du or (mpf(0),) * len(x.re)))
                self._pushed = None
                for j, known in enumerate(lower):
                    back = Series(tuple(-mpf(int(i == k - j)) / factorial(k - j) for i in range(LENGTH)))
                    moved = added(moved, product([[back]], known))
                lower.append(moved)
            columns.append(lower[-1])
        return _side_by_side(columns)

    def _of_slopes(self, body: Term, by: Symbol, name: str, order: int, at: Integers) -> Matrix:
        """The partial derivative of partial derivatives, by their differences: (8 f(h) − f(2h) − …)/12h."""
        if self._stepped is not None or order:
            raise NotRead("a partial derivative of a higher order")
        columns = []
        for component in range(by.type.rows):
            parts = []
            for steps, weight in ((-2, 1), (-1, -8), (1, 8), (2, -1)):
                self._stepped = (name, component, steps * NEAR)
                parts.append(scaled(self.value(body, at), mpf(weight) / (12 * NEAR)))
            self._stepped = None
            columns.append(acted(parts, parts[0]))
        return _side_by_side(columns)

    def _gradient(self, head: str, field: Term, at: Integers) -> Matrix:
        if self._moved is not None:
            raise NotRead("div or curl of a div or curl")
        columns = []
        for axis in range(3):
            self._moved = axis
            columns.append([entry.du or (mpf(0),) * LENGTH for (entry,) in self.value(field, at)])
        self._moved = None
        g = [[Series(columns[j][i]) for j in range(3)] for i in range(3)]  # ∂f_i/∂ρ_j
        if head == "divergence":
            return [[g[0][0] + g[1][1] + g[2][2]]]
        return [[g[2][1] - g[1][2]], [g[0][2] - g[2][0]], [g[1][0] - g[0][1]]]


def _side_by_side(columns: list[Matrix]) -> Matrix:
    if len(columns) == 1:
        return columns[0]
    return [[column[i][0] for column in columns] for i in range(len(columns[0]))]


def _integer(value: Linear, at: Integers) -> int:
    return value.constant + sum(size * at[name] for name, size in value.coefficients)


def _spelled(name: Name, index: list[int]) -> str:
    return name.shown(index)
