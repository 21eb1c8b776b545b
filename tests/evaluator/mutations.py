"""Statements with one thing changed in them that keeps all types: most often they are false then."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random

from workbench.core.construct import (
    apply,
    big_sum,
    block,
    derivative,
    number,
    power,
    rebuild,
    relation,
    symbol,
    zero,
)
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Derivative,
    IllFormed,
    Number,
    Power,
    Relation,
    Symbol,
    Term,
)
from workbench.core.types import Declaration
from workbench.language.naming.symbols import SymbolTable

_REVERSIBLE = ("mul", "cross", "dot", "outer", "add", "compose", "div")
_UNDONE = ("conjugate", "inverse", "transpose", "skew", "norm", "symmetric", "antisymmetric")
_PARTNERS = {"sin": "cos", "cos": "sin", "symmetric": "antisymmetric", "antisymmetric": "symmetric",
             "re": "du", "du": "re", "inverse": "transpose", "transpose": "inverse", "trace": "det",
             "det": "trace", "conjugate": "inverse"}  # fmt: skip


def mutated_once(random: Random, claim: Relation, table: SymbolTable) -> Relation:
    """Raises IllFormed where the change fits nowhere."""
    sides = [claim.left, claim.right]
    which = random.choice((0, 1, 1))
    paths = list(_paths(sides[which]))
    for _ in range(20):
        path = random.choice(paths)
        old = _at(sides[which], path)
        try:
            new = random.choice(list(_ways(random, old, table)))()
            if new == old or new.type != old.type:
                continue
            put = _put(sides[which], path, new)
            return relation(claim.operator, *(put if k == which else side for k, side in enumerate(sides)))
        except IllFormed:
            continue
    raise IllFormed("nothing fits")


def degenerate(random: Random, claim: Relation, table: SymbolTable) -> Relation:
    """The claim for a special case: one of its free symbols is 0, a number, or another symbol. Raises
    IllFormed."""
    free = [s for s in dict.fromkeys((*claim.left.walk(), *claim.right.walk())) if _is_free(s, table)]
    if not free:
        raise IllFormed("nothing is free")
    old = random.choice(free)
    others: list[Term] = [s for s in free if s.type == old.type and s != old]
    new = random.choice([zero(old.type), *others, *([number(2)] if old.type.kind == "scalar" else ())])
    return relation(claim.operator, *(_replaced(side, old, new) for side in (claim.left, claim.right)))


def _is_free(term: Term, table: SymbolTable) -> bool:
    if not isinstance(term, Symbol) or term.index or term.arguments:
        return False
    own = term.declaration
    flags = (
        own.unit,
        own.rotation,
        own.transform,
        own.symmetric,
        own.diagonal,
        own.constant,
        own.small,
        own.clock,
        own.coordinate,
    )
    return not any((*flags, own.independent, own.of, own.name in table.defined.members))


def _paths(term: Term, path: tuple[int, ...] = ()) -> Iterator[tuple[int, ...]]:
    yield path
    for place, child in enumerate(term.children):
        yield from _paths(child, (*path, place))


def _at(term: Term, path: tuple[int, ...]) -> Term:
    for place in path:
        term = term.children[place]
    return term


def _put(term: Term, path: tuple[int, ...], new: Term) -> Term:
    if not path:
        return new
    children = list(term.children)
    children[path[0]] = _put(children[path[0]], path[1:], new)
    return rebuild(term, tuple(children))


def _replaced(term: Term, old: Term, new: Term) -> Term:
    if term == old:
        return new
    children = tuple(_replaced(child, old, new) for child in term.children)
    return term if children == term.children else rebuild(term, children)


def _ways(random: Random, old: Term, table: SymbolTable) -> Iterator[Callable[[], Term]]:
    yield lambda: apply("mul", number(2), old)
    yield lambda: apply("div", old, number(2))
    yield lambda: apply("neg", old)
    if old.type.is_square and old.type.kind != "scalar":
        yield lambda: apply("transpose", old)
    if old.type.kind == "quaternion":
        yield lambda: apply("conjugate", old)
    match old:
        case Symbol(declaration=own, index=index):
            alike = [d for d in dict.fromkeys(table.symbols.values()) if _may_stand_for(d, own)]
            for other in random.sample(alike, min(len(alike), 4)):
                yield lambda other=other: symbol(other, index)
            if index:
                for step in (1, -1):
                    yield lambda step=step: symbol(own, tuple(place + step for place in index))
            yield lambda: zero(old.type)
            yield lambda: derivative(old, 1)
        case Number(value=value):
            for step in (1, -1):
                yield lambda step=step: number(value + step) if value + step else zero()
            yield lambda: number(1 / value)
        case Derivative(body=body, order=order) if order.is_number:
            yield lambda: derivative(body, order + 1)
            yield lambda: derivative(body, order - 1) if int(order) > 1 else body
        case Power(base=base, exponent=exponent) if exponent.is_number:
            yield lambda: power(base, exponent + 1)
            yield lambda: power(base, exponent - 1) if int(exponent) > 1 else base
        case BigSum(variables=names, lower=lower, upper=upper, body=body) if lower is not None:
            for step in (1, -1):
                yield lambda step=step: big_sum(names, lower + step, upper, body)
                yield lambda step=step: big_sum(names, lower, upper + step, body)
        case Block(entries=entries):
            for _ in range(6):
                yield lambda: _with_entries_changed(random, entries)
        case Apply(head=head, arguments=arguments):
            if head in _REVERSIBLE and len(arguments) > 1:
                for _ in range(4):
                    yield lambda: apply(head, *reversed(arguments))
            if head in _UNDONE:
                for _ in range(3):
                    yield lambda: arguments[0]
            if head in _PARTNERS:
                for _ in range(3):
                    yield lambda: apply(_PARTNERS[head], *arguments)
            if head == "add":
                for left_out in range(len(arguments)):
                    rest = [a for place, a in enumerate(arguments) if place != left_out]
                    turned = [apply("neg", a) if p == left_out else a for p, a in enumerate(arguments)]
                    yield lambda rest=rest: apply("add", *rest) if len(rest) > 1 else rest[0]
                    yield lambda turned=turned: apply("add", *turned)
            if head in ("mul", "cross", "dot") and len(arguments) == 2:
                for argument in arguments:
                    yield lambda argument=argument: argument


def _may_stand_for(one: Declaration, other: Declaration) -> bool:
    return (one.type, one.indices, one.parameters) == (
        other.type,
        other.indices,
        other.parameters,
    ) and one != other


def _with_entries_changed(random: Random, entries: tuple[tuple[Term, ...], ...]) -> Term:
    rows = [list(row) for row in entries]
    places = [(i, j) for i, row in enumerate(rows) for j in range(len(row))]
    (i, j), (k, m) = random.choice(places), random.choice(places)
    if (i, j) == (k, m):
        rows[i][j] = apply("neg", rows[i][j])
    else:
        rows[i][j], rows[k][m] = rows[k][m], rows[i][j]
    return block(rows)
