"""Detection of trivially true equations: b = b + c − c, or 0 = 0 in disguise."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from workbench.core.construct import apply, derivative
from workbench.core.terms import (
    Apply,
    Conjunction,
    Identity,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.engines.jet.rings import PRIME
from workbench.language.printing.author_spelling import is_spelt_as_one
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.subterm_positions import places, sides
from workbench.repair.terms.term_arithmetic import number_and_rest, product_of


def is_vacuous(statement: Statement) -> bool:
    """True if addends cancel in a sum, or the statement is trivial."""
    return has_cancelling_addends(statement) or is_trivial(statement)


def says_less(statement: Statement, printed: Statement) -> bool:
    """True if the statement is about numbers only and the print is not, or if a rotation that is printed less
    often stands beside its transpose."""
    ours, theirs = _symbols(statement), _symbols(printed)
    return (bool(theirs) and not ours) or any(ours[turn] > theirs[turn] for turn in _turned_back(statement))


def _symbols(statement: Statement) -> Counter[Symbol]:
    parts = (part for _, side in sides(statement) for part in side.walk())
    return Counter(part for part in parts if isinstance(part, Symbol))


def _turned_back(statement: Statement) -> Iterator[Symbol]:
    """Yields the rotations R of which R R^T stands beside other factors."""
    products = (t for _, t in places(statement) if isinstance(t, Apply) and t.head == "mul")
    factors = (others for product in products if len(others := _commuting(product)[1]) > 2)
    for left, right in (pair for others in factors for pair in pairwise(others)):
        turn, other = (right, left) if _undone("transpose", left) else (left, right)
        if isinstance(turn, Symbol) and turn.declaration.rotation and _undone("transpose", other) == turn:
            yield turn


def has_cancelling_addends(statement: Statement) -> bool:
    """True if addends cancel in a sum."""
    sums = (term for _, term in places(statement) if isinstance(term, Apply) and term.head == "add")
    return any(map(_cancels, sums))


def like_terms(statement: Statement) -> int:
    """Returns the number of addends that differ from another addend of their sum only by a number, as in M −
    2 M."""
    sums = (term for _, term in places(statement) if isinstance(term, Apply) and term.head == "add")
    count = 0
    for term in sums:
        rests = Counter(number_and_rest(addend)[1] for addend in term.arguments)
        count += sum(times - 1 for times in rests.values())
    return count


def is_idle(statement: Statement, screen: Screen) -> bool:
    """True if both sides of an equation vanish apart from common addends, though neither is printed as 0."""
    match statement:
        case Relation(operator="="):
            if isinstance(statement.left, Zero) or isinstance(statement.right, Zero):
                return False
            left, right = (Counter(_addends(side, 1)) for side in (statement.left, statement.right))
            return _vanishes(left - right, statement.left, screen) and _vanishes(
                right - left, statement.left, screen
            )
        case Conjunction(parts=parts):
            return all(is_idle(part, screen) for part in parts)
    return False


def _vanishes(addends: Counter, shape: Term, screen: Screen) -> bool:
    total: list[int] | None = None
    for (sign, term), count in addends.items():
        components = screen.components(term, shape)
        if components is None or (total is not None and len(total) != len(components)):
            return False
        total = [
            (t + sign * count * x) % PRIME
            for t, x in zip(total or [0] * len(components), components, strict=True)
        ]
    return not any(total or ())


def _cancels(term: Apply) -> bool:
    counts = Counter(_addends(term, 1))
    return any((-sign, addend) in counts for sign, addend in counts)


def is_trivial(statement: Statement) -> bool:
    """True if an equation holds by reordering and cancelling, or a chain repeats a side."""
    match statement:
        case Relation(operator="="):
            counts: dict[Term, Fraction] = {}
            for sign, side in ((1, statement.left), (-1, statement.right)):
                for factor, term in _multiples(side, Fraction(sign)):
                    counts[term] = counts.get(term, Fraction(0)) + factor
            return not any(counts.values())
        case Conjunction(parts=parts):
            chain = [side for _, side in sides(statement)]
            return len(set(chain)) < len(chain) or any(map(is_trivial, parts))
    return False


def _multiples(term: Term, factor: Fraction) -> Iterator[tuple[Fraction, Term]]:
    """Yields the addends with the numbers before them, without (Xᵀ)ᵀ and the like."""
    match term:
        case Apply(head="mul", arguments=(Number(value=value), inner) | (inner, Number(value=value))):
            yield from _multiples(inner, factor * value)
        case Apply(head="transpose" | "conjugate" as head, arguments=(inner,)):
            for own, part in _multiples(inner, factor):
                yield own, _undone(head, part) or apply(head, part)
        case Apply(head="inverse", arguments=(inner,)) if (known := _undone("inverse", inner)) is not None:
            yield from _multiples(known, factor)
        case _:
            for sign, part in _addends(term, 1):
                if part is term:
                    yield factor * sign, _in_order(part)
                else:
                    yield from _multiples(part, factor * sign)


def _in_order(product: Term) -> Term:
    """Returns a product with its scalar factors first, in one order."""
    scalars, others = _commuting(product)
    if not scalars or len(scalars) + len(others) == 1:
        return product
    if any(each.type.kind == "operator" for each in others):  # D a x is not a D x
        return product
    return product_of([*sorted(scalars, key=repr), *others])


def _commuting(term: Term) -> tuple[list[Term], list[Term]]:
    """Returns the scalar factors of a product, and its other factors."""
    if not (isinstance(term, Apply) and term.head == "mul"):
        return ([term], []) if term.type.kind == "scalar" else ([], [term])
    parts = [_commuting(argument) for argument in term.arguments]
    others = [factor for part in parts for factor in part[1]]
    return [factor for part in parts for factor in part[0]], others


def _undone(head: str, term: Term) -> Term | None:
    return term.arguments[0] if isinstance(term, Apply) and term.head == head else None


def _addends(term: Term, sign: int) -> Iterator[tuple[int, Term]]:
    match term:
        case Apply(head="add") if not is_spelt_as_one(term):
            for addend in term.arguments:
                yield from _addends(addend, sign)
        case Apply(head="neg", arguments=(inner,)):
            yield from _addends(inner, -sign)
        case Apply(head="mul", arguments=(Identity(), x) | (x, Identity())) if x.type.kind == "tensor":
            yield from _addends(x, sign)
        case Apply(head="mul", arguments=(TimeOperator(), x)) if x.type.kind != "operator":
            yield sign, derivative(x, 1)  # D x is another way to write it
        case _:
            yield sign, term
