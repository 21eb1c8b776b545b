"""Formulas as sums of monomials, in which products over sums are multiplied out: two spellings of one formula
have one sum, up to the order of what commutes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from math import gcd, lcm

from workbench.core.terms import (
    Apply,
    Block,
    Derivative,
    Identity,
    Integer,
    Number,
    Power,
    Relation,
    Symbol,
    Term,
    Zero,
)

#: The most monomials of a sum, and the highest power that is multiplied out.
_MOST_MONOMIALS, _HIGHEST_POWER = 64, 4
#: The cell of a monomial that stands in no matrix.
NO_CELL = (-1, -1)


class TooLong(ValueError):
    """A formula has too many monomials."""


@dataclass(frozen=True, slots=True)
class Leaf:
    """A symbol without derivatives, and the order of its derivative."""

    base: Term
    order: int = 0


@dataclass(frozen=True, slots=True)
class Node:
    """An operation on parts, each of which is a leaf, a node, or a sum. said: what else belongs to it."""

    head: str
    parts: tuple[Part, ...] = ()
    said: object = None


@dataclass(frozen=True, slots=True)
class Monomial:
    """A number times powers of numbers, times a vector or matrix. cell: its place in a matrix of sums."""

    factor: Fraction
    powers: tuple[tuple[Part, int], ...] = ()
    word: Part | None = None
    cell: tuple[int, int] = NO_CELL

    def times(self, factor: Fraction) -> Monomial:
        return replace(self, factor=self.factor * factor)


@dataclass(frozen=True, slots=True)
class Sum:
    """A sum of monomials that differ by more than a number."""

    monomials: tuple[Monomial, ...]


Part = Leaf | Node | Sum
_ONE = Monomial(Fraction(1))


def equation_sum(said: Relation) -> Sum:
    """Returns left − right of an equation; the entries of a matrix are monomials with their cells.

    Raises:
        TooLong: It has too many monomials.
    """
    left, right = (_in_cells(normal_sum(side)) for side in (said.left, said.right))
    return _collected([*left.monomials, *(each.times(Fraction(-1)) for each in right.monomials)])


def normal_sum(term: Term) -> Sum:
    """Returns the sum of a term. Raises TooLong."""
    match term:
        case Number(value=value):
            return _collected([Monomial(Fraction(value))])
        case Integer(value=value) if value.is_number:
            return _collected([Monomial(Fraction(int(value)))])
        case Zero():
            return Sum(())
        case Identity():
            return _of_part(Node("identity"), term)
        case Symbol():
            return _of_part(Leaf(term), term)
        case Derivative(body=Symbol() as body, order=order) if order.is_number:
            return _of_part(Leaf(body, int(order)), term)
        case Power(base=base, exponent=exponent) if exponent.is_number:
            return _power(base, int(exponent), term)
        case Block(entries=entries):
            cells = tuple(normal_sum(entry) for row in entries for entry in row)
            return _of_part(Node("block", cells, (len(entries), len(entries[0]))), term)
        case Apply():
            return _operation(term)
        case _:
            parts = tuple(normal_sum(child) for child in term.children)
            return _of_part(Node(type(term).__name__, parts, None if parts else term), term)


def _of_part(part: Part, term: Term) -> Sum:
    if term.type.kind == "scalar":
        return Sum((Monomial(Fraction(1), ((part, 1),)),))
    return Sum((Monomial(Fraction(1), (), part),))


def _operation(term: Apply) -> Sum:
    one, *rest = (normal_sum(each) for each in term.arguments)
    match term.head:
        case "add":
            return _collected([each for part in (one, *rest) for each in part.monomials])
        case "neg":
            return _scaled(one, Fraction(-1))
        case "mul" | "dot" | "cross" | "outer":
            return reduce(lambda a, b: _product(term.head, a, b), rest, one)
        case "triple":
            return _product("dot", one, _product("cross", rest[0], rest[1]))
        case "div":
            return _product("mul", one, _inverse(rest[0]))
        case "transpose" | "skew" | "inverse":
            return _linear(term.head, one, term)
        case _:
            return _of_part(Node(term.head, (one, *rest)), term)


def _linear(head: str, one: Sum, term: Apply) -> Sum:
    if term.arguments[0].type.kind == "scalar":
        return _inverse(one) if head == "inverse" else one
    if head == "inverse" and len(one.monomials) != 1:
        return _of_part(Node(head, (one,)), term)
    turn = {"transpose": _transposed, "skew": _skew, "inverse": _inverted}[head]
    found = []
    for each in one.monomials:
        sign, word = turn(each.word) if each.word is not None else (1, None)
        new = replace(each, factor=each.factor * sign, word=word)
        if head == "inverse":
            new = replace(new, factor=1 / each.factor, powers=tuple((a, -n) for a, n in each.powers))
        found.append(new)
    return _collected(found)


def _skew(word: Part) -> tuple[int, Part]:
    return 1, Node("skew", (word,))


def _transposed(word: Part) -> tuple[int, Part]:
    match word:
        case Node("mul", parts):
            turned = [_transposed(each) for each in reversed(parts)]
            return _sign(turned), Node("mul", tuple(each for _, each in turned))
        case Node("transpose", (inner,)):
            return 1, inner
        case Node("skew"):
            return -1, word
        case Node("identity"):
            return 1, word
        case Node("outer", (one, other)):
            return 1, Node("outer", (other, one))
        case Node("block", cells, (int(rows), int(columns))):
            turned_cells = tuple(cells[j * columns + i] for i in range(columns) for j in range(rows))
            return 1, Node("block", turned_cells, (columns, rows))
        case Leaf(base=Symbol(declaration=own)) if own.symmetric or own.diagonal:
            return 1, word
    return 1, Node("transpose", (word,))


def _inverted(word: Part) -> tuple[int, Part]:
    match word:
        case Node("mul", parts):
            return 1, Node("mul", tuple(_inverted(each)[1] for each in reversed(parts)))
        case Node("inverse", (inner,)):
            return 1, inner
        case Node("identity"):
            return 1, word
        case Leaf(base=Symbol(declaration=own)) | Node("transpose", (Leaf(base=Symbol(declaration=own)),)):
            if own.rotation:
                return _transposed(word)
    return 1, Node("inverse", (word,))


def _sign(parts: list[tuple[int, Part]]) -> int:
    return reduce(lambda sign, part: sign * part[0], parts, 1)


def _product(head: str, one: Sum, other: Sum) -> Sum:
    return _collected([_both(head, a, b) for a in one.monomials for b in other.monomials])


def _both(head: str, a: Monomial, b: Monomial) -> Monomial:
    powers: dict[Part, int] = dict(a.powers)
    for part, exponent in b.powers:
        powers[part] = powers.get(part, 0) + exponent
    word: Part | None = None
    if a.word is None or b.word is None:
        word = a.word if b.word is None else b.word
    else:
        word = _joined(head, a.word, b.word)
        if isinstance(word, Node) and word.head == "dot":
            powers[word] = powers.get(word, 0) + 1
            word = None
    return Monomial(a.factor * b.factor, tuple((part, n) for part, n in powers.items() if n), word)


def _joined(head: str, a: Part, b: Part) -> Part:
    """Returns the product of two words. aᵀb is a dot product, a bᵀ a dyad, [a]ₓb a cross product."""
    if head != "mul":
        return Node(head, (a, b))
    factors = [part for each in (a, b) for part in (each.parts if _is(each, "mul") else (each,))]  # type: ignore[union-attr]
    factors = [each for each in factors if not _is(each, "identity")] or [Node("identity")]
    first, last = factors[0], factors[-1]
    if _is_row(first) and _is_column(last) and len(factors) > 1:
        return Node("dot", (first.parts[0], _mul(factors[1:])))  # type: ignore[union-attr]
    if len(factors) > 1 and _is_row(last) and _is_column(factors[-2]):
        dyad = Node("outer", (factors[-2], last.parts[0]))  # type: ignore[union-attr]
        return _mul([*factors[:-2], dyad])
    factors = _multiplied_out(factors)
    while len(factors) > 1 and _is(factors[-2], "skew") and _is_column(factors[-1]):
        factors[-2:] = [Node("cross", (factors[-2].parts[0], factors[-1]))]  # type: ignore[union-attr]
    return _mul(factors)


def _multiplied_out(factors: list[Part]) -> list[Part]:
    """Returns the factors with one matrix for each two neighbours that are written with their entries."""
    found: list[Part] = []
    for each in factors:
        last = found[-1] if found else None
        match last, each:
            case Node("block", left, (int(rows), int(inner))), Node("block", right, (int(own), int(columns))):
                if inner == own:
                    cells = (
                        _collected(
                            [
                                one
                                for k in range(inner)
                                for one in _entry_product(left[i * inner + k], right[k * columns + j])
                            ]
                        )
                        for i in range(rows)
                        for j in range(columns)
                    )
                    found[-1] = Node("block", tuple(cells), (rows, columns))
                    continue
        found.append(each)
    return found


def _entry_product(one: Part, other: Part) -> tuple[Monomial, ...]:
    assert isinstance(one, Sum) and isinstance(other, Sum)
    return _product("mul", one, other).monomials


def _mul(factors: list[Part]) -> Part:
    return factors[0] if len(factors) == 1 else Node("mul", tuple(factors))


def _is(part: Part | None, head: str) -> bool:
    return isinstance(part, Node) and part.head == head


def _is_row(part: Part) -> bool:
    return isinstance(part, Node) and part.head == "transpose" and _is_column(part.parts[0])


def _is_column(part: Part) -> bool:
    match part:
        case Leaf(base=base):
            return base.type.is_column
        case Node("cross"):
            return True
        case Node("mul", parts):
            return _is_column(parts[-1])
        case Node("block", _, (_, columns)):
            return columns == 1
    return False


def _power(base: Term, exponent: int, term: Term) -> Sum:
    own = normal_sum(base)
    if base.type.kind == "scalar":
        if exponent < 0:
            own, exponent = _inverse(own), -exponent
        if len(own.monomials) > 1 and exponent > _HIGHEST_POWER:
            return _of_part(Node("power", (own,), exponent), term)
        return reduce(lambda a, b: _product("mul", a, b), [own] * exponent, Sum((_ONE,)))
    if base.type.is_column and exponent == 2:
        return _product("dot", own, own)
    if base.type.is_square and 0 < exponent <= _HIGHEST_POWER:
        return reduce(lambda a, b: _product("mul", a, b), [own] * (exponent - 1), own)
    return _of_part(Node("power", (own,), exponent), term)


def _inverse(own: Sum) -> Sum:
    if len(own.monomials) == 1:
        (one,) = own.monomials
        if one.word is None:
            return Sum((Monomial(1 / one.factor, tuple((part, -n) for part, n in one.powers)),))
    if not own.monomials:
        raise TooLong
    content = _content(own)
    return Sum((Monomial(1 / content, ((_scaled(own, 1 / content), -1),)),))


def _content(own: Sum) -> Fraction:
    """Returns the common factor of the numbers of a sum, with the sign of the most of them."""
    factors = [each.factor for each in own.monomials]
    size = Fraction(gcd(*(each.numerator for each in factors)), lcm(*(each.denominator for each in factors)))
    return -size if sum(each < 0 for each in factors) * 2 > len(factors) else size


def _scaled(own: Sum, factor: Fraction) -> Sum:
    return Sum(tuple(each.times(factor) for each in own.monomials))


def _collected(monomials: list[Monomial]) -> Sum:
    """Returns the sum with one monomial for those that differ by a number. Raises TooLong."""
    if len(monomials) > _MOST_MONOMIALS:
        raise TooLong
    found: dict[object, Monomial] = {}
    for each in (squared for one in monomials for squared in _without_roots(one)):
        key = (frozenset(each.powers), each.word, each.cell)
        known = found.get(key)
        found[key] = each if known is None else replace(known, factor=known.factor + each.factor)
    return Sum(tuple(each for each in found.values() if each.factor))


def _without_roots(own: Monomial) -> Iterator[Monomial]:
    """Yields a monomial with x·x for |x|², and x for the square of its root."""
    for part, exponent in own.powers:
        if isinstance(part, Node) and part.head in ("norm", "root") and exponent > 1 and part.parts:
            (inner,) = part.parts[:1]
            assert isinstance(inner, Sum)
            head = "dot" if part.head == "norm" else "mul"
            square = _product(head, inner, inner) if head == "dot" else inner
            rest = tuple((p, n - 2 if p == part else n) for p, n in own.powers if p != part or n > 2)
            outer = Sum((replace(own, powers=rest),))
            yield from _product("mul", square, outer).monomials
            return
    yield own


def _in_cells(own: Sum) -> Sum:
    """Returns the sum with the entries of matrices as monomials of their own."""
    found: list[Monomial] = []
    for each in own.monomials:
        if isinstance(each.word, Node) and each.word.head == "block" and isinstance(each.word.said, tuple):
            columns = each.word.said[1]
            for at, cell in enumerate(each.word.parts):
                assert isinstance(cell, Sum)
                outer = replace(each, word=None)
                found += [
                    replace(_both("mul", outer, one), cell=divmod(at, columns)) for one in cell.monomials
                ]
        else:
            found.append(each)
    return _collected(found)


def parts_of(own: Part | Monomial | None) -> Iterator[Part]:
    """Yields a part and the parts in it, each as often as it occurs."""
    match own:
        case Monomial(powers=powers, word=word):
            for each in (*(part for part, _ in powers), word):
                yield from parts_of(each)
            return
        case None:
            return
    yield own
    inner: tuple[Part | Monomial, ...] = ()
    if isinstance(own, Node):
        inner = own.parts
    elif isinstance(own, Sum):
        inner = own.monomials
    for one in inner:
        yield from parts_of(one)


def leaves_of(own: Part | Monomial) -> Iterator[Leaf]:
    """Yields the leaves of a part or a monomial, each as often as it occurs."""
    return (each for each in parts_of(own) if isinstance(each, Leaf))
