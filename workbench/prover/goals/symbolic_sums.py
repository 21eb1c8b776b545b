"""Elimination of sums to a symbolic n: by Leibniz' rule, by shifting, by splitting off ends.

    Σ_{k=0}^{n} C(n, k) x⁽ᵏ⁾ × y⁽ⁿ⁻ᵏ⁾ = (x × y)⁽ⁿ⁾
    Σ_{k=1}^{n} f(k+1) = Σ_{k=2}^{n+1} f(k) = Σ_{k=1}^{n+1} f(k) − f(1)

Each remaining sum becomes a free symbol, the same one for equal sums, so that a proof of the rest holds with
the sums. Derivatives and linear operations are moved to the addends first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from workbench.core.construct import apply, derivative, integer, number, relation, symbol, with_children
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.names import Name
from workbench.core.operations import COMPONENTWISE, PRODUCTS
from workbench.core.terms import Apply, BigSum, Counting, Derivative, Relation, Symbol, Term
from workbench.core.types import Declaration
from workbench.engines.inventory.addend_expansion import addends, has_sums, spread
from workbench.language.printing.printer import to_latex

_SHIFTS = (0, 1, -1, 2, -2)


def without_sums(equation: Relation, least: Mapping[str, int]) -> Relation:
    """Returns the equation with derivatives and free symbols for its sums. least: the least value of each
    integer."""
    return _Sums(dict(least)).equation(equation)


@dataclass
class _Sums:
    least: dict[str, int]
    kept: list[BigSum] = field(default_factory=list)

    def equation(self, equation: Relation) -> Relation:
        left, right = (self._side(side) for side in (equation.left, equation.right))
        return relation(equation.operator, left, right)

    def _side(self, side: Term) -> Term:
        total: Term | None = None
        for negative, addend in addends(spread(side)):
            term = self._without(addend) if isinstance(addend, BigSum) else self._inside(addend)
            term = apply("neg", term) if negative else term
            total = term if total is None else apply("add", total, term)
        assert total is not None
        return total

    def _inside(self, term: Term) -> Term:
        return self._without(term) if isinstance(term, BigSum) else with_children(term, self._inside)

    def _without(self, total: BigSum) -> Term:
        if total.lower is None:
            return self._free(total)
        leibniz = None if has_sums(total.body) else self._leibniz(total)
        if leibniz is not None:
            return leibniz
        for known in self.kept:
            matched = self._matched(total, known)
            if matched is not None:
                return matched
        self.kept.append(total)
        return self._free(total)

    def _free(self, total: BigSum) -> Symbol:
        return symbol(Declaration(Name(rf"\left({to_latex(total)}\right)", of=(total,)), total.type))

    def _matched(self, total: BigSum, known: BigSum) -> Term | None:
        """Returns the sum as a known one, shifted, plus or minus the addends at its ends; None if no shift
        matches."""
        (k,), (j,) = total.variables, known.variables
        (total_first, total_last), (first, last) = _bounds(total), _bounds(known)
        for shift in _SHIFTS:
            moved = instantiate(total.body, {k: Linear.variable(j) + shift})
            if moved != known.body:
                continue
            lower, upper = total_first - shift, total_last - shift
            if not (self._at_least(upper - lower, -1) and self._at_least(last - first, -1)):
                continue
            more_below, more_above = first - lower, upper - last
            if not (more_below.is_number and more_above.is_number):
                continue
            ends = [*_ends(known, j, lower, int(more_below), below=True)]
            ends += _ends(known, j, upper, int(more_above), below=False)
            result: Term = self._free(known)
            for negative, term in ends:
                term = self._inside(term)
                result = apply("add", result, apply("neg", term) if negative else term)
            return result
        return None

    def _at_least(self, value: Linear, least: int) -> bool:
        """True if the value is at least that large for all integers in scope."""
        lowest = value.substitute({name: self.least.get(name, 0) for name in value.variables})
        return all(c > 0 for _, c in value.coefficients) and int(lowest) >= least

    def _leibniz(self, total: BigSum) -> Term | None:
        """Returns (x y)⁽ᵐ⁾ for Σ_{k=0}^{m} C(m, k) x⁽ᵏ⁾ y⁽ᵐ⁻ᵏ⁾, minus the addends that the sum lacks at its
        ends."""
        (k,) = total.variables
        factors = list(_factors(total.body))
        found = [f for f in factors if isinstance(f, Counting) and f.name == "binomial"]
        if not found:
            return None
        top, chosen = found[0].arguments
        if chosen == top - Linear.variable(k):
            chosen = Linear.variable(k)
        offset = chosen - Linear.variable(k)
        rest = _divided(total.body, found[0])
        result = None if rest is None else _product(rest, k, top, offset)
        if result is None:
            return None
        lowest, highest = _bounds(total)
        first, last = Linear(0) - offset, top - offset
        less_below, less_above = lowest - first, last - highest
        if not all(less.is_number and 0 <= int(less) <= 3 for less in (less_below, less_above)):
            return None
        if not self._at_least(highest - lowest, -1):
            return None
        missing = [first + i for i in range(int(less_below))] + [last - i for i in range(int(less_above))]
        for value in missing:
            result = apply("add", result, apply("neg", instantiate(_evaluated(total.body, k, value), {})))
        return result


def _bounds(total: BigSum) -> tuple[Linear, Linear]:
    """Returns the bounds of a sum over a range."""
    assert total.lower is not None and total.upper is not None, "a sum over a range"
    return total.lower, total.upper


def _evaluated(body: Term, k: str, value: Linear) -> Term:
    """Returns the addend at a value; C(m, 0) and C(m, m) are 1."""
    at = instantiate(body, {k: value})
    return _ones(at)


def _ones(term: Term) -> Term:
    if isinstance(term, Counting) and term.name == "binomial":
        top, chosen = term.arguments
        if chosen == Linear(0) or chosen == top:
            return number(1)
        if chosen == Linear(1) or chosen == top - 1:
            return integer(top)
        return term
    return with_children(term, _ones)


def _ends(known: BigSum, j: str, end: Linear, more: int, below: bool) -> Iterator[tuple[bool, Term]]:
    """Yields the addends by which a sum with another end exceeds the known one (negative if it lacks
    them)."""
    first, last = _bounds(known)
    for step in range(abs(more)):
        if below:
            value = end + step if more > 0 else first + step
        else:
            value = end - step if more > 0 else last - step
        yield more < 0, _evaluated(known.body, j, value)


def _factors(term: Term) -> Iterator[Term]:
    if isinstance(term, Apply) and term.head in PRODUCTS:
        for argument in term.arguments:
            yield from _factors(argument)
    else:
        yield term


def _divided(term: Term, factor: Term) -> Term | None:
    """Returns the product without one of its factors; None if it does not contain the factor."""
    if not (isinstance(term, Apply) and term.head in PRODUCTS):
        return None
    left, right = term.arguments
    if factor in (left, right):
        return right if left == factor else left
    rest = _divided(left, factor)
    if rest is not None:
        return apply(term.head, rest, right)
    rest = _divided(right, factor)
    return None if rest is None else apply(term.head, left, rest)


def _product(body: Term, k: str, top: Linear, offset: Linear) -> Term | None:
    """Returns (x y)⁽ᵐ⁾ for x⁽ᵏ⁾ y⁽ᵐ⁻ᵏ⁾, between factors that do not depend on k; else None."""
    orders = {Linear.variable(k) + offset, top - Linear.variable(k) - offset}
    match body:
        case Apply(head=head, arguments=(inner,)) if head in COMPONENTWISE:
            found = _product(inner, k, top, offset)
            return None if found is None else apply(head, found)
        case Apply(head=head, arguments=(left, right)) if head in PRODUCTS:
            if not _depends(left, k):
                found = _product(right, k, top, offset)
                return None if found is None else apply(head, left, found)
            if not _depends(right, k):
                found = _product(left, k, top, offset)
                return None if found is None else apply(head, found, right)
            one, other = _base(left, k, orders), _base(right, k, orders)
            if one is not None and other is not None and {one[1], other[1]} == orders:
                return derivative(apply(head, one[0], other[0]), top)
    return None


def _base(term: Term, k: str, orders: set[Linear]) -> tuple[Term, Linear] | None:
    """Returns x and the order of x⁽ᵏ⁾, inside time-independent linear operations; else None."""
    match term:
        case Derivative(body=body, order=order) if order in orders and not _depends(body, k):
            return body, order
        case Apply(head=head, arguments=(inner,)) if head in COMPONENTWISE:
            found = _base(inner, k, orders)
            return None if found is None else (apply(head, found[0]), found[1])
    return None


def _depends(term: Term, k: str) -> bool:
    return k in free_integers(term)
